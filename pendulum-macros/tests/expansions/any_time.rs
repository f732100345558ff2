// What this expands to; written by src/snapshots.rs.
//
//     pub struct Forever;
//     theta0 = 1π/2

/// The motion of a pendulum, θ̈ + ω² sin θ = 0, for `theta0 = 1π/2`.
///
/// * θ(0) = 1.5707963267948966 rad, θ̇(0) = 0.0, ω = 1.0
/// * a swing between ±1.5707963267948966 rad with the period T = 7.4162987092054875
/// * k = 0.7071067811865476, K = 1.8540746773013719, K′ = 1.8540746773013719, q = 0.04321391826377225
///
/// Planned for the full precision of `f64`, over 2⁵³ periods:
///
/// * phase: exact products with the rate in 4 words, wrong by at most 1.7e-16 anchors
/// * theta: polynomial of 12 terms in s² plus one of 2 over one of 3, the small coefficients adapted; proven error ≤ 1.568e-15 rad (4.3e-18 of truncation, 8.7e-16 of phase, 6.9e-16 of rounding); 56 operations
/// * not a polynomial in s² over poles, adapted in blocks of 4 for `theta`: it can promise only 2.3e-15
/// * not a polynomial in s² over poles for `theta`: it can promise only 2.0e-15
/// * not a polynomial in s² − 0.125 over poles for `theta`: it can promise only 2.2e-15
/// * not a polynomial in s² − 0.15625 over poles for `theta`: it can promise only 2.1e-15
/// * not a polynomial in s², adapted in blocks of 4 for `theta`: it costs about 1.0 operations more
/// * not pieces, phase by exact products with the rate in 4 words: it costs about 107 operations
/// * not `harmonic`: it is wrong by about 4e-2
/// * not `series`: 11 harmonics at least, of three operations each beside a cosine
/// * not `fourier`: what stands for the arcsine of its sum bends no less than θ, and the sum has an error of its own
pub struct Forever;
#[allow(
    dead_code,
    deprecated,
    unused_qualifications,
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    clippy::arithmetic_side_effects,
    clippy::as_conversions,
    clippy::float_arithmetic,
    clippy::float_cmp,
    clippy::indexing_slicing,
    clippy::min_ident_chars,
    clippy::missing_inline_in_public_items,
    clippy::missing_docs_in_private_items,
    clippy::single_call_fn
)]
impl Forever {
    /// θ at t = 0, rad.
    pub const THETA0: f64 = 1.5707963267948966;
    /// ω, the rate of small oscillations, rad per unit of t.
    pub const OMEGA: f64 = 1.0;
    /// The largest |θ|, rad.
    pub const AMPLITUDE: f64 = 1.5707963267948966;
    /// k = sin(amplitude/2), the modulus.
    pub const MODULUS: f64 = 0.7071067811865476;
    /// K(k), the complete elliptic integral of the first kind.
    pub const K: f64 = 1.8540746773013719;
    /// K′ = K(k′), k′² = 1 − k².
    pub const K_PRIME: f64 = 1.8540746773013719;
    /// q = exp(−πK′/K).
    pub const NOME: f64 = 0.04321391826377225;
    /// T = 4K/ω, the time of one swing to and fro, in the unit of t.
    pub const PERIOD: f64 = 7.4162987092054875;
    /// How the motion is approximated.
    pub const METHOD: &'static str = "polynomial";
    /// The number of terms of the approximation.
    pub const TERMS: usize = 14;
    /// Operations of one call of the first function.
    pub const OPERATIONS: usize = 56;
    /// Proven bound of |θ(t) − exact| over the horizon, rad.
    pub const MAX_ERROR: f64 = 1.568298512105315e-15;
    /// θ(t), rad; NaN if t is not finite. 56 operations.
    #[inline(always)]
    #[must_use]
    pub const fn theta(t: f64) -> f64 {
        let head = f64::from_bits(t.to_bits() & 0xfffffffffc000000);
        let tail = t - head;
        let v = head * 0.2696762979030609;
        let first = v - (v + 5.404319552844595e16 - 5.404319552844595e16);
        let second = tail * 0.2696762979030609 + head * 2.691128875298432e-9;
        let third = tail * 2.691128875298432e-9 + head * -1.1005039832999035e-16;
        let fourth = tail * -1.1005039832999035e-16 + t * -3.230523974410337e-24;
        let magic = first + third + second + 6755399441055744.0;
        let n = magic - 6755399441055744.0;
        let s = first - n + second + third + fourth;
        let v_2 = s * s;
        let y = if 0.2500009536752261_f64 < v_2 { 0.2500009536752261_f64 } else { v_2 };
        let v_3 = v_2 + 0.00954559538513422;
        let d = -0.2894105315208435 - v_3 * v_3;
        let fraction = (0.4283795802822268 * y - 0.054197505029406706) / d;
        let w = y * y;
        let w2 = w * w;
        let w4 = w2 * w2;
        let result = 1.3835866682459301 - 5.383126495668413 * y
            + (0.5482679267403641 + 5.642539657557171 * y) * w
            + ((4.170501500337143 + 10.586924808481383 * y) * (w - 0.7152214545932583)
                + 1.4312561919537126) * w2
            + ((21.919979986138195 - 10.31420102223766 * y) * (w + 1.0542625456871144)
                - 33.38509794218164) * w4 + fraction;
        f64::from_bits(result.to_bits() ^ (magic.to_bits() << 63))
    }
}
