// What this expands to; written by src/snapshots.rs.
//
//     pub struct Over;
//     velocity0 = 2, tol = 1e-3, float = f32

/// The motion of a pendulum, θ̈ + ω² sin θ = 0, for `velocity0 = 2, tol = 1e-3, float = f32`.
///
/// * θ(0) = 0.0 rad, θ̇(0) = 2.0, ω = 1.0
/// * the separatrix: towards the top for ever, never reaching it
///
/// Planned for an error of at most `tol`, over any time:
///
/// * phase s: the time itself from the lowest point, wrong by at most 5.3e-23 of itself
/// * theta: an exponential of 4 terms, an arctangent of 5 terms; error ≤ 1.233e-4 rad, proven: 0.000e0 of truncation, 1.661e-16 of phase, 1.233e-4 of evaluation with its series; 34 operations
pub struct Over;
#[allow(clippy::approx_constant, clippy::float_arithmetic, clippy::neg_multiply)]
impl Over {
    /// θ at t = 0, rad.
    pub const THETA0: f32 = 0.0;
    /// θ̇ at t = 0, rad per unit of t.
    pub const VELOCITY0: f32 = 2.0;
    /// ω, the rate of small oscillations, rad per unit of t.
    pub const OMEGA: f32 = 1.0;
    /// The errors are bounded for all |t| up to this.
    pub const T_MAX: f32 = 3.4028235e38;
    /// k = 1: between swinging and turning over.
    pub const MODULUS: f32 = 1.0;
    /// The kind of plan.
    pub const METHOD: &'static str = "passage";
    /// Terms, or harmonics, of the first function.
    pub const TERMS: usize = 4;
    /// Operations of one call of the first function.
    pub const OPERATIONS: usize = 34;
    /// Proven bound of |θ(t) − exact| over the horizon, rad.
    pub const MAX_ERROR: f32 = 0.00012324349;
    /// θ(t), rad; NaN if t is not finite. 34 operations.
    #[inline(always)]
    #[must_use]
    pub const fn theta(t: f32) -> f32 {
        let z = t + (t - t);
        let v = z.abs();
        let a = if 620.0_f32 < v { 620.0_f32 } else { v };
        let w = a as f64 * 1.4426950408889634;
        let exponent = 6755399441055744.0 - w;
        let f = w - (6755399441055744.0 - exponent);
        let v_2 = f * f;
        let even = v_2 * (0.24022530032732614 + 0.009656715464641046 * v_2);
        let odd = f * (0.6931367264142243 + 0.055838342726314355 * v_2);
        let power = f64::from_bits(exponent.to_bits().wrapping_add(1023) << 52);
        let tangent = power * (1.0 + (even - odd));
        let v_3 = tangent * tangent;
        let r2 = v_3 * v_3;
        let result = (-3.141592653589793
            - tangent
                * (-3.999877121785021
                    + (1.3267096981982465 - 0.740401180534416 * v_3
                        + (0.3669737760461261 - 0.09508898057428448 * v_3) * r2) * v_3))
            as f32;
        f32::from_bits(result.to_bits() ^ (!z.to_bits() & 0x8000_0000))
    }
}
