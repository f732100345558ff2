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
/// * k = 0.9807852804032304, K = 3.0402005646451418, K′ = 1.5860712391076077, q = 0.19418044072494273
///
/// Planned for an error of at most `tol`, over |t| ≤ 86400.0:
///
/// * phase: Cody and Waite's remainder of 2 words, wrong by at most 2.9e-17 anchors
/// * theta: polynomial of 14 terms in s², coefficients adapted in blocks of 4; proven error ≤ 2.692e-10 rad (2.7e-10 of truncation, 3.4e-16 of phase, 7.6e-15 of rounding); 36 operations
/// * velocity: polynomial of 15 terms in s², coefficients adapted in blocks of 4; proven error ≤ 2.217e-10 rad·ω (2.2e-10 of truncation, 1.7e-16 of phase, 1.2e-14 of rounding); 40 operations
/// * not a polynomial in s², adapted in blocks of 8 for `theta`: it costs about 1.5 operations more
/// * not a polynomial in s², adapted in blocks of 8 for `velocity`: it costs about 1.5 operations more
/// * not the passage through the lowest point, phase by Cody and Waite's remainder of 2 words from the lowest point: it costs about 151 operations
/// * not `harmonic`: it is wrong by about 5e-1
/// * not `series`: 12 harmonics, about 61 operations
/// * not `fourier`: about 13 harmonics, the arcsine of whose sum bends more than θ does
pub struct Clock;
#[allow(
    dead_code,
    unused_qualifications,
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    clippy::arithmetic_side_effects,
    clippy::as_conversions,
    clippy::float_arithmetic,
    clippy::float_cmp,
    clippy::min_ident_chars,
    clippy::missing_inline_in_public_items,
    clippy::missing_docs_in_private_items,
    clippy::single_call_fn
)]
impl Clock {
    /// θ at t = 0, rad.
    pub const THETA0: f64 = 2.748893571891069;
    /// ω, the rate of small oscillations, rad per unit of t.
    pub const OMEGA: f64 = 3.1415307243047144;
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
    /// T = 4K/ω, the time of one swing to and fro.
    pub const PERIOD: f64 = 3.870979890311913;
    /// How the motion is approximated.
    pub const METHOD: &'static str = "polynomial";
    /// The number of terms of the approximation.
    pub const TERMS: usize = 14;
    /// Operations that one call of the first function executes.
    pub const OPERATIONS: usize = 36;
    /// Proven bound of |θ(t) − exact| over the horizon, rad.
    pub const MAX_ERROR: f64 = 2.692401668104248e-10;
    /// Proven bound of the velocity's error over the horizon, in rad·ω.
    pub const MAX_VELOCITY_ERROR: f64 = 2.2169327957925062e-10;
    /// θ(t), rad; NaN if t is not finite. 36 operations.
    #[inline(always)]
    #[must_use]
    pub const fn theta(t: f64) -> f64 {
        let magic = t * 0.516665045200957 + 6755399441055744.0;
        let n = magic - 6755399441055744.0;
        let s = t - n * 1.9354899451427627 - n * 1.3193586841992646e-11;
        let v = s * s;
        let y = if 0.9365303320242175_f64 < v { 0.9365303320242175_f64 } else { v };
        let w = y * y;
        let w2 = w * w;
        let w4 = w2 * w2;
        let result = (-0.21167013757405648 * y - 1.4348564309150027)
            * (w + 8.92139366090917) + 15.549812639059756
            + ((-0.014536551913868474 * y + 0.11075453720109249)
                * (w - 22.63757244621774) + 2.8386088483279104) * w2
            + ((1.3639956024941755 * y - 1.268908267964459) * (w + 0.5125911474275531)
                + 0.24798080068530537
                + (0.13693109967750627 * y - 0.6978265091858055) * w2) * w4;
        f64::from_bits(result.to_bits() ^ (magic.to_bits() << 63))
    }
    /// θ̇(t), rad per unit of t; NaN if t is not finite. 40 operations.
    #[inline(always)]
    #[must_use]
    pub const fn velocity(t: f64) -> f64 {
        let magic = t * 0.516665045200957 + 6755399441055744.0;
        let n = magic - 6755399441055744.0;
        let s = t - n * 1.9354899451427627 - n * 1.3193586841992646e-11;
        let v = if 0.9677449726163487_f64 < s { 0.9677449726163487_f64 } else { s };
        let clamped = if v < -0.9677449726163487 { -0.9677449726163487 } else { v };
        let y = clamped * clamped;
        let w = y * y;
        let w2 = w * w;
        let w4 = w2 * w2;
        let result = clamped
            * ((2.6488841332868325 * y - 1.2698057634701574) * (w - 2.1667361230103306)
                - 6.528119199908748
                + ((2.997051261956164 * y - 2.031808632869422) * (w + 0.5040447776874944)
                    + 4.315902499775383) * w2
                + ((78.52226084770291 * y - 66.64024150477209) * (w + 0.5161634292097182)
                    + 16.451611120654647
                    + ((-3.66307272572286 * y + 22.3742386625538) * y
                        - 56.93922034441709) * w2) * w4);
        f64::from_bits(result.to_bits() ^ (magic.to_bits() << 63))
    }
    /// (θ(t), θ̇(t)), with one phase reduction for both; NaN if t is not finite. 64 operations.
    #[inline(always)]
    #[must_use]
    pub const fn state(t: f64) -> (f64, f64) {
        let magic = t * 0.516665045200957 + 6755399441055744.0;
        let n = magic - 6755399441055744.0;
        let s = t - n * 1.9354899451427627 - n * 1.3193586841992646e-11;
        let v = if 0.9677449726163487_f64 < s { 0.9677449726163487_f64 } else { s };
        let clamped = if v < -0.9677449726163487 { -0.9677449726163487 } else { v };
        let y = clamped * clamped;
        let w = y * y;
        let w2 = w * w;
        let w4 = w2 * w2;
        let first_result = (-0.21167013757405648 * y - 1.4348564309150027)
            * (w + 8.92139366090917) + 15.549812639059756
            + ((-0.014536551913868474 * y + 0.11075453720109249)
                * (w - 22.63757244621774) + 2.8386088483279104) * w2
            + ((1.3639956024941755 * y - 1.268908267964459) * (w + 0.5125911474275531)
                + 0.24798080068530537
                + (0.13693109967750627 * y - 0.6978265091858055) * w2) * w4;
        let second_result = clamped
            * ((2.6488841332868325 * y - 1.2698057634701574) * (w - 2.1667361230103306)
                - 6.528119199908748
                + ((2.997051261956164 * y - 2.031808632869422) * (w + 0.5040447776874944)
                    + 4.315902499775383) * w2
                + ((78.52226084770291 * y - 66.64024150477209) * (w + 0.5161634292097182)
                    + 16.451611120654647
                    + ((-3.66307272572286 * y + 22.3742386625538) * y
                        - 56.93922034441709) * w2) * w4);
        (
            f64::from_bits(first_result.to_bits() ^ (magic.to_bits() << 63)),
            f64::from_bits(second_result.to_bits() ^ (magic.to_bits() << 63)),
        )
    }
}
