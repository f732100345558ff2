// What this expands to; written by src/snapshots.rs.
//
//     /// The clock on the wall.
//     pub struct Clock;
//     theta0 = 157.5deg, g = 9.81, length = 0.994, tol = 1e-9, t_max = 86_400, outputs = [theta, velocity]

/// The clock on the wall.
///
/// The motion of a pendulum, θ̈ + ω² sin θ = 0, for `theta0 = 157.5deg, g = 9.81, length = 0.994, tol = 1e-9, t_max = 86_400, outputs = [theta, velocity]`.
///
/// * θ(0) = 2.748893571891069 rad, θ̇(0) = 0.0, ω = 3.1415307243047144
/// * a swing between ±2.748893571891069 rad with the period T = 3.870979890311913
/// * k = 0.9807852804032304, k′ = 0.19509032201612828, K = 3.0402005646451418, K′ = 1.5860712391076077, q = 0.19418044072494273
///
/// Planned for an error of at most `tol`, over |t| ≤ 86400.0:
///
/// * phase s, in half periods from the nearest turning point: one product with the rate, wrong by at most 4.0e-12 half periods
/// * theta: polynomial of 9 terms in s² over one of 3, coefficients adapted in blocks of 4; error ≤ 6.220e-10 rad, proven: 5.751e-10 of truncation, 4.685e-11 of phase, 3.815e-14 of evaluation; 28 operations
/// * velocity: polynomial of 7 terms in s² over one of 3, coefficients adapted; error ≤ 4.308e-10 rad·ω, proven: 4.069e-10 of truncation, 2.389e-11 of phase, 3.619e-15 of evaluation; 24 operations
///
/// Not chosen:
///
/// * a polynomial in s² over poles, by powers for `theta`: it costs 1 addition more
/// * a polynomial in s² over poles, coefficients adapted in blocks of 4 for `velocity`: it costs 1 addition more
/// * pieces, phase by one product with the rate: it costs as much as 83 additions, this plan as 48
/// * `harmonic`: it is wrong by about 3e-1 rad
/// * `series`: it takes 12 harmonics at least, of three operations each, and a cosine
/// * `fourier`: a polynomial for the arcsine of its sum takes no fewer terms than one for θ, and the sum has an error besides
pub struct Clock;
#[allow(clippy::approx_constant, clippy::float_arithmetic, clippy::neg_multiply)]
impl Clock {
    /// θ at t = 0, rad.
    pub const THETA0: f64 = 2.748893571891069;
    /// θ̇ at t = 0, rad per unit of t.
    pub const VELOCITY0: f64 = 0.0;
    /// ω, the rate of small oscillations, rad per unit of t.
    pub const OMEGA: f64 = 3.1415307243047144;
    /// The errors are bounded for all |t| up to this.
    pub const T_MAX: f64 = 86400.0;
    /// The largest |θ|, rad.
    pub const AMPLITUDE: f64 = 2.748893571891069;
    /// k = sin(amplitude/2), the modulus.
    pub const MODULUS: f64 = 0.9807852804032304;
    /// K(k), the complete elliptic integral of the first kind.
    pub const K: f64 = 3.0402005646451418;
    /// K′ = K(k′), k′² = 1 − k².
    pub const K_PRIME: f64 = 1.5860712391076077;
    /// q = exp(−πK′/K).
    pub const NOME: f64 = 0.19418044072494273;
    /// T = 4K/ω, the time of one swing to and fro, in the unit of t.
    pub const PERIOD: f64 = 3.870979890311913;
    /// The kind of plan.
    pub const METHOD: &'static str = "polynomial";
    /// Terms, or harmonics, of the first function.
    pub const TERMS: usize = 9;
    /// Operations of one call of the first function.
    pub const OPERATIONS: usize = 28;
    /// Proven bound of |θ(t) − exact| over the horizon, rad.
    pub const MAX_ERROR: f64 = 6.219383123320769e-10;
    /// Proven bound of the velocity's error over the horizon, in rad·ω.
    pub const MAX_VELOCITY_ERROR: f64 = 4.3075098582185365e-10;
    /// θ(t), rad; NaN if t is not finite. 28 operations.
    #[inline(always)]
    #[must_use]
    pub const fn theta(t: f64) -> f64 {
        let x = t.abs() * 0.516665045200957;
        let magic = x + 6755399441055744.0;
        let n = magic - 6755399441055744.0;
        let s = x - n;
        let v = s * s;
        let y = if 0.25_f64 < v { 0.25_f64 } else { v };
        let signed = f64::from_bits(
            83.29963463217591_f64.to_bits() ^ (magic.to_bits() << 63),
        );
        let v_2 = v - 0.18865548074245453;
        let d = -0.0867738276720047 - v_2 * v_2;
        let w = y * y;
        let w2 = w * w;
        signed / d
            * ((-0.03546358893545737 + 0.010052345431550246 * y) * (w + 2.27240519049656)
                + 0.07654959960535461
                + ((-0.08779327473163231 - 0.7509368396381406 * y)
                    * (w - 0.08778952917722718) + (0.08812096226944938 + w2)) * w2)
    }
    /// θ̇(t), rad per unit of t; NaN if t is not finite. 24 operations.
    #[inline(always)]
    #[must_use]
    pub const fn velocity(t: f64) -> f64 {
        let x = t * 0.516665045200957;
        let rounder = 6755399441055744.0_f64.copysign(t);
        let magic = x + rounder;
        let n = magic - rounder;
        let s = x - n;
        let v = s * s;
        let y = if 0.25_f64 < v { 0.25_f64 } else { v };
        let signed = f64::from_bits(s.to_bits() ^ (magic.to_bits() << 63));
        let v_2 = v - 0.1819863955260788;
        let d = -0.06804324543106671 - v_2 * v_2;
        let w = y * y;
        signed / d
            * (((6.124462680145829 - 9.211095363990546 * y + 4.809949611982091 * w)
                * (w - 0.5192770203513656) - 2.3417714567483006)
                * (w + 0.3238841028888346) + 2.5279980693211312)
    }
    /// (θ(t), θ̇(t)), with one phase reduction for both; NaN if t is not finite. 44 operations.
    #[inline(always)]
    #[must_use]
    pub const fn state(t: f64) -> (f64, f64) {
        let x = t * 0.516665045200957;
        let rounder = 6755399441055744.0_f64.copysign(t);
        let magic = x + rounder;
        let n = magic - rounder;
        let s = x - n;
        let v = s * s;
        let y = if 0.25_f64 < v { 0.25_f64 } else { v };
        let signed = f64::from_bits(
            83.29963463217591_f64.to_bits() ^ (magic.to_bits() << 63),
        );
        let v_2 = v - 0.18865548074245453;
        let d = -0.0867738276720047 - v_2 * v_2;
        let w = y * y;
        let w2 = w * w;
        let first_result = signed / d
            * ((-0.03546358893545737 + 0.010052345431550246 * y) * (w + 2.27240519049656)
                + 0.07654959960535461
                + ((-0.08779327473163231 - 0.7509368396381406 * y)
                    * (w - 0.08778952917722718) + (0.08812096226944938 + w2)) * w2);
        let signed_2 = f64::from_bits(s.to_bits() ^ (magic.to_bits() << 63));
        let v_3 = v - 0.1819863955260788;
        let d_2 = -0.06804324543106671 - v_3 * v_3;
        let second_result = signed_2 / d_2
            * (((6.124462680145829 - 9.211095363990546 * y + 4.809949611982091 * w)
                * (w - 0.5192770203513656) - 2.3417714567483006)
                * (w + 0.3238841028888346) + 2.5279980693211312);
        (first_result, second_result)
    }
}
