// What this expands to; written by src/snapshots.rs.
//
//     pub(crate) struct Lamp;
//     theta0 = 2, float = f32, tol = 1e-4, t_max = 1000, outputs = [theta, position]

/// The motion of a pendulum, θ̈ + ω² sin θ = 0, for `theta0 = 2, float = f32, tol = 1e-4, t_max = 1000, outputs = [theta, position]`.
///
/// * θ(0) = 2.0 rad, θ̇(0) = 0.0, ω = 1.0
/// * a swing between ±2.0 rad with the period T = 8.349752926918494
/// * k = 0.8414709848078965, k′ = 0.5403023058681398, K = 2.0874382317296236, K′ = 1.7091975942731685, q = 0.07635659780391943
///
/// Planned for an error of at most `tol`, over |t| ≤ 1000.0:
///
/// * phase s, in half periods from the nearest turning point: one product with the rate, wrong by at most 8.2e-6 half periods
/// * theta: polynomial of 3 terms in s² over one of 3; error ≤ 9.140e-5 rad, proven: 3.349e-5 of truncation, 5.756e-5 of phase, 3.534e-7 of evaluation; 16 operations
/// * position: sin(θ/2) by a polynomial of 4 terms in s² over one of 3, coefficients adapted, cos(θ/2) by a polynomial of 4 terms in s² over one of 3, coefficients adapted, squared; error ≤ 7.718e-5 lengths, proven: 1.709e-5 of truncation, 5.756e-5 of phase, 2.531e-6 of evaluation; 29 operations
///
/// Not chosen:
///
/// * a polynomial in s² over poles, by powers for `theta`: it costs no less
/// * a polynomial in s² over poles, by powers for `position`: it costs 2 additions more
/// * pieces, phase by one product with the rate in `f64`: it costs as much as 170 additions, this plan as 39
/// * `harmonic`: it is wrong by about 9e-2 rad
/// * `series`: it takes 4 harmonics at least, of three operations each, and a cosine
/// * `fourier`: a polynomial for the arcsine of its sum takes no fewer terms than one for θ, and the sum has an error besides
pub(crate) struct Lamp;
#[allow(clippy::approx_constant, clippy::float_arithmetic, clippy::neg_multiply)]
impl Lamp {
    /// θ at t = 0, rad.
    pub const THETA0: f32 = 2.0;
    /// θ̇ at t = 0, rad per unit of t.
    pub const VELOCITY0: f32 = 0.0;
    /// ω, the rate of small oscillations, rad per unit of t.
    pub const OMEGA: f32 = 1.0;
    /// The errors are bounded for all |t| up to this.
    pub const T_MAX: f32 = 1000.0;
    /// The largest |θ|, rad.
    pub const AMPLITUDE: f32 = 2.0;
    /// k = sin(amplitude/2), the modulus.
    pub const MODULUS: f32 = 0.84147096;
    /// K(k), the complete elliptic integral of the first kind.
    pub const K: f32 = 2.0874383;
    /// K′ = K(k′), k′² = 1 − k².
    pub const K_PRIME: f32 = 1.7091976;
    /// q = exp(−πK′/K).
    pub const NOME: f32 = 0.0763566;
    /// T = 4K/ω, the time of one swing to and fro, in the unit of t.
    pub const PERIOD: f32 = 8.349753;
    /// The kind of plan.
    pub const METHOD: &'static str = "polynomial";
    /// Terms, or harmonics, of the first function.
    pub const TERMS: usize = 3;
    /// Operations of one call of the first function.
    pub const OPERATIONS: usize = 16;
    /// Proven bound of |θ(t) − exact| over the horizon, rad.
    pub const MAX_ERROR: f32 = 9.139527e-5;
    /// Proven bound of the position's distance from the exact one, in lengths.
    pub const MAX_POSITION_ERROR: f32 = 7.717634e-5;
    /// θ(t), rad; NaN if t is not finite. 16 operations.
    #[inline(always)]
    #[must_use]
    pub const fn theta(t: f32) -> f32 {
        let x = t.abs() * 0.23952805;
        let magic = x + 12582912.0;
        let n = magic - 12582912.0;
        let s = x - n;
        let v = s * s;
        let p = if 0.25_f32 < v { 0.25_f32 } else { v };
        let signed = f32::from_bits(
            (-0.24901083_f32).to_bits() ^ (magic.to_bits() << 31),
        );
        let v_2 = v - 0.024392076;
        let d = -0.42334524 - v_2 * v_2;
        signed / d * ((p - 13.869426) * p + 3.404919)
    }
    /// (sin θ, −cos θ) at t, in lengths: x to the right, y upwards from the pivot; NaN if t is not finite. 29 operations.
    #[inline(always)]
    #[must_use]
    pub const fn position(t: f32) -> (f32, f32) {
        let x = t.abs() * 0.23952805;
        let magic = x + 12582912.0;
        let n = magic - 12582912.0;
        let s = x - n;
        let v = s * s;
        let y = if 0.25_f32 < v { 0.25_f32 } else { v };
        let v_2 = y - 0.087378345;
        let d = -0.16257937 - v_2 * v_2;
        let v_3 = -0.35542947 / d;
        let w = y * y;
        let half_sine = v_3
            * ((-0.35327572 - 1.3490337 * y) * (w + 1.0669101) + 0.77989346);
        let half_cosine = v_3 * ((-1.207476 + y) * (w + 1.3316723) + 1.8667088);
        let v_4 = half_sine * half_cosine;
        let x_2 = v_4 + v_4;
        let y_2 = half_sine * half_sine - half_cosine * half_cosine;
        (f32::from_bits(x_2.to_bits() ^ (magic.to_bits() << 31)), y_2)
    }
}
