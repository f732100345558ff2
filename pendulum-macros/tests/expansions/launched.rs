// What this expands to; written by src/snapshots.rs.
//
//     struct Pushed;
//     theta0 = 1, velocity0 = -1/2, omega = 3, tol = 1e-6, outputs = [theta, acceleration]

/// The motion of a pendulum, θ̈ + ω² sin θ = 0, for `theta0 = 1, velocity0 = -1/2, omega = 3, tol = 1e-6, outputs = [theta, acceleration]`.
///
/// * θ(0) = 1.0 rad, θ̇(0) = -0.5, ω = 3.0
/// * a swing between ±1.0164196714351632 rad with the period T = 2.2382200703644872
/// * k = 0.4866141094444083, k′ = 0.8736170262132175, K = 1.6786650527733653, K′ = 2.1808718766608886, q = 0.016882730376268574
///
/// Planned for an error of at most `tol`, over 2⁵³ periods:
///
/// * phase s, in half periods from the nearest turning point: exact products with the rate in 2 words, wrong by at most 5.3e-8 half periods
/// * theta: polynomial of 3 terms in s² over one of 3; error ≤ 4.688e-7 rad, proven: 2.963e-7 of truncation, 1.725e-7 of phase, 5.209e-16 of evaluation; 27 operations
/// * acceleration: polynomial of 7 terms in s² (shifted), coefficients adapted; error ≤ 6.429e-7 rad·ω², proven: 4.704e-7 of truncation, 1.725e-7 of phase, 6.609e-16 of evaluation; 31 operations
///
/// Not chosen:
///
/// * a polynomial in s² over poles, by powers for `theta`: it costs no less
/// * a polynomial in s², coefficients adapted in blocks of 4 for `acceleration`: it costs 1 addition more
/// * pieces, phase by exact products with the rate in 2 words: it costs as much as 85 additions, this plan as 40
/// * `harmonic`: it is wrong by about 9e-3 rad
/// * `series`: it takes 3 harmonics at least, of three operations each, and a cosine
/// * `fourier`: a polynomial for the arcsine of its sum takes no fewer terms than one for θ, and the sum has an error besides
struct Pushed;
#[allow(clippy::approx_constant, clippy::float_arithmetic, clippy::neg_multiply)]
impl Pushed {
    /// θ at t = 0, rad.
    pub const THETA0: f64 = 1.0;
    /// θ̇ at t = 0, rad per unit of t.
    pub const VELOCITY0: f64 = -0.5;
    /// ω, the rate of small oscillations, rad per unit of t.
    pub const OMEGA: f64 = 3.0;
    /// The errors are bounded for all |t| up to this.
    pub const T_MAX: f64 = 2.016009414973334e16;
    /// The largest |θ|, rad.
    pub const AMPLITUDE: f64 = 1.0164196714351632;
    /// k = sin(amplitude/2), the modulus.
    pub const MODULUS: f64 = 0.4866141094444083;
    /// K(k), the complete elliptic integral of the first kind.
    pub const K: f64 = 1.6786650527733653;
    /// K′ = K(k′), k′² = 1 − k².
    pub const K_PRIME: f64 = 2.1808718766608886;
    /// q = exp(−πK′/K).
    pub const NOME: f64 = 0.016882730376268574;
    /// T = 4K/ω, the time of one swing to and fro, in the unit of t.
    pub const PERIOD: f64 = 2.2382200703644872;
    /// The kind of plan.
    pub const METHOD: &'static str = "polynomial";
    /// Terms, or harmonics, of the first function.
    pub const TERMS: usize = 3;
    /// Operations of one call of the first function.
    pub const OPERATIONS: usize = 27;
    /// Proven bound of |θ(t) − exact| over the horizon, rad.
    pub const MAX_ERROR: f64 = 4.687966789127545e-7;
    /// Proven bound of the acceleration's error over the horizon, in rad·ω².
    pub const MAX_ACCELERATION_ERROR: f64 = 6.428471204973341e-7;
    /// θ(t), rad; NaN if t is not finite. 27 operations.
    #[inline(always)]
    #[must_use]
    pub const fn theta(t: f64) -> f64 {
        let head = f64::from_bits(t.to_bits() & 0xfffffffffc000000);
        let tail = t - head;
        let v = head * 0.8935671746730804;
        let first = v - (v + 5.404319552844595e16 - 5.404319552844595e16);
        let second = t * 6.892897686341747e-9 + tail * 0.8935671746730804;
        let magic = second + first + 0.05858762081443536 + 6755399441055744.0;
        let n = magic - 6755399441055744.0;
        let s = first - n + second + 0.05858762081443536;
        let v_2 = s * s;
        let p = if 0.2500009536752261_f64 < v_2 { 0.2500009536752261_f64 } else { v_2 };
        let signed = f64::from_bits(
            (-0.21057259439027343_f64).to_bits() ^ (magic.to_bits() << 63),
        );
        let v_3 = v_2 + 0.33113032579421997;
        let d = -0.8899591565132141 - v_3 * v_3;
        signed / d * ((p - 19.550138987672103) * p + 4.825033021328307)
    }
    /// θ̈(t) = −ω² sin θ(t), rad per unit of t squared; NaN if t is not finite. 31 operations.
    #[inline(always)]
    #[must_use]
    pub const fn acceleration(t: f64) -> f64 {
        let head = f64::from_bits(t.to_bits() & 0xfffffffffc000000);
        let tail = t - head;
        let v = head * 0.8935671746730804;
        let first = v - (v + 5.404319552844595e16 - 5.404319552844595e16);
        let second = t * 6.892897686341747e-9 + tail * 0.8935671746730804;
        let magic = second + first + 0.05858762081443536 + 6755399441055744.0;
        let n = magic - 6755399441055744.0;
        let s = first - n + second + 0.05858762081443536;
        let v_2 = s * s;
        let p = if 0.2500009536752261_f64 < v_2 { 0.2500009536752261_f64 } else { v_2 };
        let y = p - 0.375;
        let w = y * y;
        let result = ((-223.8944276347536 - 968.3907237723347 * y - 778.645022161528 * w)
            * (w + 0.18553289723015637) - 45.63480108102437) * (w - 0.11187254164043381)
            - 6.6189819462163735;
        f64::from_bits(result.to_bits() ^ (magic.to_bits() << 63))
    }
}
