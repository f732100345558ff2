// What this expands to; written by src/snapshots.rs.
//
//     struct Instant;
//     theta0 = 1, tol = 1e-9, t_max = 1, outputs = [theta, velocity]

/// The motion of a pendulum, θ̈ + ω² sin θ = 0, for `theta0 = 1, tol = 1e-9, t_max = 1, outputs = [theta, velocity]`.
///
/// * θ(0) = 1.0 rad, θ̇(0) = 0.0, ω = 1.0
/// * a swing between ±1.0 rad with the period T = 6.699975664370453
/// * k = 0.479425538604203, k′ = 0.8775825618903728, K = 1.6749939160926133, K′ = 2.194267051772123, q = 0.016317236000592376
///
/// Planned for an error of at most `tol`, over |t| ≤ 1.0:
///
/// * phase s: the time itself, which the horizon keeps short
/// * theta: polynomial of 7 terms in s² (shifted), coefficients adapted; error ≤ 2.763e-11 rad, proven: 2.762e-11 of truncation, 0.000e0 of phase, 1.881e-15 of evaluation; 16 operations
/// * velocity: polynomial of 6 terms in s², coefficients adapted in blocks of 4; error ≤ 8.284e-10 rad·ω, proven: 8.284e-10 of truncation, 0.000e0 of phase, 3.301e-16 of evaluation; 18 operations
///
/// Not chosen:
///
/// * a polynomial in s², coefficients adapted in blocks of 4 for `theta`: it costs 1 addition more
/// * a polynomial in s², by powers for `velocity`: it costs 1 addition more
/// * pieces, phase by one product with the rate: it costs as much as 74 additions, this plan as 30
/// * `harmonic`: it is wrong by about 9e-3 rad
/// * `series`: it takes 5 harmonics at least, of three operations each, and a cosine
/// * `fourier`: a polynomial for the arcsine of its sum takes no fewer terms than one for θ, and the sum has an error besides
struct Instant;
#[allow(clippy::approx_constant, clippy::float_arithmetic, clippy::neg_multiply)]
impl Instant {
    /// θ at t = 0, rad.
    pub const THETA0: f64 = 1.0;
    /// θ̇ at t = 0, rad per unit of t.
    pub const VELOCITY0: f64 = 0.0;
    /// ω, the rate of small oscillations, rad per unit of t.
    pub const OMEGA: f64 = 1.0;
    /// The errors are bounded for all |t| up to this.
    pub const T_MAX: f64 = 1.0;
    /// The largest |θ|, rad.
    pub const AMPLITUDE: f64 = 1.0;
    /// k = sin(amplitude/2), the modulus.
    pub const MODULUS: f64 = 0.479425538604203;
    /// K(k), the complete elliptic integral of the first kind.
    pub const K: f64 = 1.6749939160926133;
    /// K′ = K(k′), k′² = 1 − k².
    pub const K_PRIME: f64 = 2.194267051772123;
    /// q = exp(−πK′/K).
    pub const NOME: f64 = 0.016317236000592376;
    /// T = 4K/ω, the time of one swing to and fro, in the unit of t.
    pub const PERIOD: f64 = 6.699975664370453;
    /// The kind of plan.
    pub const METHOD: &'static str = "polynomial";
    /// Terms, or harmonics, of the first function.
    pub const TERMS: usize = 7;
    /// Operations of one call of the first function.
    pub const OPERATIONS: usize = 16;
    /// Proven bound of |θ(t) − exact| over the horizon, rad.
    pub const MAX_ERROR: f64 = 2.762081659688914e-11;
    /// Proven bound of the velocity's error over the horizon, in rad·ω.
    pub const MAX_VELOCITY_ERROR: f64 = 8.283669840276455e-10;
    /// θ(t), rad; NaN if t is not finite. 16 operations.
    #[inline(always)]
    #[must_use]
    pub const fn theta(t: f64) -> f64 {
        let s = t + (t - t);
        let v = s * s;
        let p = if 1.0000000000000018_f64 < v { 1.0000000000000018_f64 } else { v };
        let y = p - 3.250000000000003;
        let w = y * y;
        ((7.708558358109622e-5 + 4.7882084975032666e-5 * y + 2.782801615222687e-6 * w)
            * (w - 74.25846028938665) + 0.0410686113613072) * (w + 73.98464755030585)
            - 2.7368565884344114
    }
    /// θ̇(t), rad per unit of t; NaN if t is not finite. 18 operations.
    #[inline(always)]
    #[must_use]
    pub const fn velocity(t: f64) -> f64 {
        let s = t + (t - t);
        let v = s * s;
        let y = if 1.0000000000000018_f64 < v { 1.0000000000000018_f64 } else { v };
        let v_2 = if 1.0000000000000009_f64 < s { 1.0000000000000009_f64 } else { s };
        let clamped = if v_2 < -1.0000000000000009 { -1.0000000000000009 } else { v_2 };
        let w = y * y;
        let w2 = w * w;
        clamped
            * ((0.012850676100311872 - 0.0020887117009914125 * y)
                * (w - 36.27810878959313) - 0.37527274921613857
                + (-6.17973738234796e-5 + 3.25842760761288e-5 * y) * w2)
    }
    /// (θ(t), θ̇(t)), with one phase reduction for both; NaN if t is not finite. 30 operations.
    #[inline(always)]
    #[must_use]
    pub const fn state(t: f64) -> (f64, f64) {
        let s = t + (t - t);
        let v = s * s;
        let y = if 1.0000000000000018_f64 < v { 1.0000000000000018_f64 } else { v };
        let v_2 = if 1.0000000000000009_f64 < s { 1.0000000000000009_f64 } else { s };
        let clamped = if v_2 < -1.0000000000000009 { -1.0000000000000009 } else { v_2 };
        let y_2 = y - 3.250000000000003;
        let w = y_2 * y_2;
        let first_result = ((7.708558358109622e-5 + 4.7882084975032666e-5 * y_2
            + 2.782801615222687e-6 * w) * (w - 74.25846028938665) + 0.0410686113613072)
            * (w + 73.98464755030585) - 2.7368565884344114;
        let w_2 = y * y;
        let w2 = w_2 * w_2;
        let second_result = clamped
            * ((0.012850676100311872 - 0.0020887117009914125 * y)
                * (w_2 - 36.27810878959313) - 0.37527274921613857
                + (-6.17973738234796e-5 + 3.25842760761288e-5 * y) * w2);
        (first_result, second_result)
    }
}
