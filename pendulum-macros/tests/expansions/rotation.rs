// What this expands to; written by src/snapshots.rs.
//
//     #[cfg_attr(all(), doc = "Over the top.")]
//     pub struct Loop;
//     velocity0 = 2.5, tol = 1e-6, t_max = 1000, outputs = [theta, wrapped]

#[cfg_attr(all(), doc = "Over the top.")]
///
/// The motion of a pendulum, θ̈ + ω² sin θ = 0, for `velocity0 = 2.5, tol = 1e-6, t_max = 1000, outputs = [theta, wrapped]`.
///
/// * θ(0) = 0.0 rad, θ̇(0) = 2.5, ω = 1.0
/// * a rotation, one turn in 3.192484444263567, |θ̇| from 1.5 at the top to 2.5 at the lowest point
/// * κ = 0.8, κ′ = 0.6, K = 1.9953027776647294, K′ = 1.7507538029157526, q = 0.06351039340074582
///
/// Planned for an error of at most `tol`, over |t| ≤ 1000.0:
///
/// * phase s, in turns from the nearest top: one product with the rate, wrong by at most 4.9e-14 turns
/// * theta: polynomial of 4 terms in s² over one of 3, coefficients adapted; error ≤ 5.835e-7 rad, proven: 5.835e-7 of truncation, 8.215e-14 of phase, 3.077e-13 of evaluation; 23 operations
/// * wrapped: polynomial of 4 terms in s² over one of 3, coefficients adapted; error ≤ 5.835e-7 rad, proven: 5.835e-7 of truncation, 3.862e-13 of phase, 3.593e-15 of evaluation; 27 operations
///
/// Not chosen:
///
/// * a polynomial in s², coefficients adapted in blocks of 8 for `theta`: it costs 0.5 additions more
/// * a polynomial in s², coefficients adapted in blocks of 8 for `wrapped`: it costs 0.5 additions more
/// * pieces, phase by one product with the rate: it costs as much as 81 additions, this plan as 47
pub struct Loop;
#[allow(clippy::approx_constant, clippy::float_arithmetic, clippy::neg_multiply)]
impl Loop {
    /// θ at t = 0, rad.
    pub const THETA0: f64 = 0.0;
    /// θ̇ at t = 0, rad per unit of t.
    pub const VELOCITY0: f64 = 2.5;
    /// ω, the rate of small oscillations, rad per unit of t.
    pub const OMEGA: f64 = 1.0;
    /// The errors are bounded for all |t| up to this.
    pub const T_MAX: f64 = 1000.0;
    /// κ = 2ω/|θ̇| at the lowest point, the modulus.
    pub const MODULUS: f64 = 0.8;
    /// K(κ), the complete elliptic integral of the first kind.
    pub const K: f64 = 1.9953027776647294;
    /// K′ = K(κ′), κ′² = 1 − κ².
    pub const K_PRIME: f64 = 1.7507538029157526;
    /// q = exp(−πK′/K).
    pub const NOME: f64 = 0.06351039340074582;
    /// The time of one turn, in the unit of t.
    pub const PERIOD: f64 = 3.192484444263567;
    /// The kind of plan.
    pub const METHOD: &'static str = "polynomial";
    /// Terms, or harmonics, of the first function.
    pub const TERMS: usize = 4;
    /// Operations of one call of the first function.
    pub const OPERATIONS: usize = 23;
    /// Proven bound of |θ(t) − exact| over the horizon, rad.
    pub const MAX_ERROR: f64 = 5.834698884750788e-7;
    /// Proven bound of the wrapped angle's error over the horizon, rad.
    pub const MAX_WRAPPED_ERROR: f64 = 5.834698884252707e-7;
    /// θ(t), rad; NaN if t is not finite. 23 operations.
    #[inline(always)]
    #[must_use]
    pub const fn theta(t: f64) -> f64 {
        let x = t * 0.3132356687898215;
        let magic = x + 0.5 + 6755399441055744.0;
        let n = magic - 6755399441055744.0;
        let s = x - (n - 0.5);
        let v = s * s;
        let y = if 0.25000000000005707_f64 < v { 0.25000000000005707_f64 } else { v };
        let v_2 = if 0.5000000000000571_f64 < s { 0.5000000000000571_f64 } else { s };
        let clamped = if v_2 < -0.5000000000000571 { -0.5000000000000571 } else { v_2 };
        let v_3 = y - 0.03855285793542862;
        let d = -0.34204158186912537 - v_3 * v_3;
        let w = y * y;
        let result = clamped / d
            * ((3.8845101537393782 - 1.8492067650023307 * y) * (w + 1.5731541333490644)
                - 5.597549826073936);
        t * 1.9681177518247777 + result
    }
    /// θ(t) wrapped to [−π, π), rad; NaN if t is not finite. 27 operations.
    #[inline(always)]
    #[must_use]
    pub const fn wrapped(t: f64) -> f64 {
        let x = t * 0.3132356687898215;
        let magic = x + 0.5 + 6755399441055744.0;
        let n = magic - 6755399441055744.0;
        let s = x - (n - 0.5);
        let v = s * s;
        let y = if 0.25000000000005707_f64 < v { 0.25000000000005707_f64 } else { v };
        let v_2 = if 0.5000000000000571_f64 < s { 0.5000000000000571_f64 } else { s };
        let clamped = if v_2 < -0.5000000000000571 { -0.5000000000000571 } else { v_2 };
        let v_3 = y - 0.03855285793542862;
        let d = -0.34204158186912537 - v_3 * v_3;
        let w = y * y;
        let result = clamped / d
            * ((3.8845101537393782 - 1.8492067650023307 * y) * (w + 1.5731541333490644)
                - 5.597549826073936);
        let v_4 = clamped * 6.283185307179586 + result
            + if clamped < 0.0 { 3.141592653589793 } else { -3.141592653589793 };
        let angle = if 3.1415926535897927_f64 < v_4 {
            3.1415926535897927_f64
        } else {
            v_4
        };
        if angle < -3.141592653589793 { -3.141592653589793 } else { angle }
    }
}
