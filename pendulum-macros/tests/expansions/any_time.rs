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
/// * theta: polynomial of 14 terms in s² + c over one of 3, coefficients adapted in blocks of 4; proven error ≤ 1.901e-15 rad (4.3e-18 of truncation, 8.7e-16 of phase, 1.0e-15 of rounding); 58 operations
/// * not a polynomial in s² over poles for `theta`: it costs about 1.0 operations more
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
    pub const OPERATIONS: usize = 58;
    /// Proven bound of |θ(t) − exact| over the horizon, rad.
    pub const MAX_ERROR: f64 = 1.900823390746143e-15;
    /// θ(t), rad; NaN if t is not finite. 58 operations.
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
        let sign = f64::from_bits(1.0_f64.to_bits() ^ (magic.to_bits() << 63));
        let v_3 = v_2 + 0.00954559538513422;
        let d = -0.2894105315208435 - v_3 * v_3;
        let v_4 = v_2 - 0.15625;
        let y = if 0.09375095367522612_f64 < v_4 {
            0.09375095367522612_f64
        } else {
            v_4
        };
        let w = y * y;
        let w2 = w * w;
        let w4 = w2 * w2;
        sign / d
            * ((0.16435345102400264 + 2.889908597254424 * y) * (w + 0.6130725086990148)
                - 0.27050478467360234
                + ((2.899314285561524 - 0.492430495496803 * y) * (w + 2.8067766233419844)
                    - 10.370918535692603) * w2
                + ((3.489608632029096 - 7.648079217643113 * y) * (w - 0.4492094273883639)
                    - 2.1824709052620093
                    + (-0.7723487803595143 + 10.31420102223766 * y) * w2) * w4)
    }
}
