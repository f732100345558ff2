// What this expands to; written by src/snapshots.rs.
//
//     pub struct Forever;
//     theta0 = 1π/2

/// The motion of a pendulum, θ̈ + ω² sin θ = 0, for `theta0 = 1π/2`.
///
/// * θ(0) = 1.5707963267948966 rad, θ̇(0) = 0.0, ω = 1.0
/// * a swing between ±1.5707963267948966 rad with the period T = 7.4162987092054875
/// * k = 0.7071067811865476, k′ = 0.7071067811865476, K = 1.8540746773013719, K′ = 1.8540746773013719, q = 0.04321391826377225
///
/// Planned for the full precision of `f64`, over 2⁵³ periods:
///
/// * phase s, in half periods from the nearest turning point: exact products with the rate in 4 words, wrong by at most 1.7e-16 half periods
/// * theta: polynomial of 17 terms in s² (shifted), coefficients adapted in blocks of 4; error ≤ 1.881e-15 rad, proven: 7.260e-17 of truncation, 8.734e-16 of phase, 9.343e-16 of evaluation; 60 operations
///
/// Not chosen:
///
/// * a polynomial in s² over poles, coefficients adapted in blocks of 4 for `theta`: it leaves less room
/// * a polynomial in s² over two pairs of poles, coefficients adapted in blocks of 4 for `theta`: it leaves less room
/// * a polynomial in s² over poles, by powers for `theta`: it costs 0.5 additions more
/// * pieces, phase by exact products with the rate in 4 words: it costs as much as 109 additions, this plan as 58
/// * `harmonic`: it is wrong by about 4e-2 rad
/// * `series`: it takes 10 harmonics at least, of three operations each, and a cosine
/// * `fourier`: a polynomial for the arcsine of its sum takes no fewer terms than one for θ, and the sum has an error besides
pub struct Forever;
#[allow(clippy::approx_constant, clippy::float_arithmetic, clippy::neg_multiply)]
impl Forever {
    /// θ at t = 0, rad.
    pub const THETA0: f64 = 1.5707963267948966;
    /// θ̇ at t = 0, rad per unit of t.
    pub const VELOCITY0: f64 = 0.0;
    /// ω, the rate of small oscillations, rad per unit of t.
    pub const OMEGA: f64 = 1.0;
    /// The errors are bounded for all |t| up to this.
    pub const T_MAX: f64 = 6.680008020649225e16;
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
    /// The kind of plan.
    pub const METHOD: &'static str = "polynomial";
    /// Terms, or harmonics, of the first function.
    pub const TERMS: usize = 17;
    /// Operations of one call of the first function.
    pub const OPERATIONS: usize = 60;
    /// Proven bound of |θ(t) − exact| over the horizon, rad.
    pub const MAX_ERROR: f64 = 1.880215122256234e-15;
    /// θ(t), rad; NaN if t is not finite. 60 operations.
    #[inline(always)]
    #[must_use]
    pub const fn theta(t: f64) -> f64 {
        let v = t.abs();
        let head = f64::from_bits(v.to_bits() & 0xfffffffffc000000);
        let tail = v - head;
        let v_2 = head * 0.2696762979030609;
        let first = v_2 - (v_2 + 5.404319552844595e16 - 5.404319552844595e16);
        let second = head * 2.691128875298432e-9 + tail * 0.2696762979030609;
        let third = head * -1.1005039832999035e-16 + tail * 2.691128875298432e-9;
        let fourth = v * -3.230523974410337e-24 + tail * -1.1005039832999035e-16;
        let magic = third + second + first + 6755399441055744.0;
        let n = magic - 6755399441055744.0;
        let s = first - n + second + third + fourth;
        let v_3 = s * s;
        let p = if 0.2500009536752261_f64 < v_3 { 0.2500009536752261_f64 } else { v_3 };
        let y = p + 0.0625;
        let w = y * y;
        let w2 = w * w;
        let w4 = w2 * w2;
        let result = (-1.9700361621449383 + 9.870332365009808 * y)
            * (w - 0.6838842409352377) + 0.6505982283628713
            + 5114.066594397547 * (w4 * w4)
            + ((-26.943459626833842 + 37.602887202667496 * y) * (w - 0.5338282033013554)
                - 6.978032909318127) * w2
            + ((1233.8144668762131 - 5669.869790088942 * y) * (w + 0.0755108587252532)
                + 62.73136128703999
                + ((32443.822950358128 - 19496.568206774846 * y)
                    * (w + 1.5588442004284895) - 33508.49429783891) * w2) * w4;
        f64::from_bits(result.to_bits() ^ (magic.to_bits() << 63))
    }
}
