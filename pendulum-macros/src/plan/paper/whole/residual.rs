//! What an interpolant Q of θ̂ = 2 arcsin y is wrong by, from its residual R = y − sin(Q/2), which is analytic wherever y
//! and Q are.
//!
//! Q/2, which is arcsin y at the points of the interpolation, stays between −π/2 and π/2 from one of them to the next if
//! |y| and |y − R| = |sin(Q/2)| are below 1 there. Where they are at most Y, |θ̂ − Q| ≤ 2|R|/√(1 − Y²).

use crate::chebyshev::{CosineTable, Interpolation, cos_pi, lebesgue, rounding_of_value, sin_pi, value};
use crate::plan::cosines::Cosines;
use crate::plan::paper::bias::supremum;
use crate::power::two_to;
use crate::program::rounding::INFLATION_OF_SUMS;
use crate::series::Wave;
use pendulum_runtime::double::Double;
use std::f64::consts::PI;

/// The part of what is negligible that the interpolation of a residual may be wrong by.
pub(super) const OF_RESIDUAL: f64 = 1e-4;

/// 2 arcsin y, by Newton's method on sin πx = y; `None` if |y| ≥ 1.
pub(super) fn twice_arcsine(y: Double) -> Option<Double> {
    let mut x = Double::new(libm::asin(y.hi) / PI);
    for _ in 0..2 {
        x = x + (y - sin_pi(x)) / (Double::PI * cos_pi(x));
    }
    (y.hi.abs() < 1.0).then_some(x * Double::PI * 2.0)
}

/// Bounds |R| for the interpolant Q, at a phase for each u, of |u| ≤ 1, by another interpolation.
///
/// Its samples are y as the sum gives it and the sine of Q/2, which is rounded as Q is and by some 2⁻¹⁰⁰ of itself; so may
/// the phase be, where y changes by Σ mπ|wₘ| at most. That the points are rounded changes both alike.
pub(super) fn largest_residual(
    sum: &Wave,
    series: &[Double],
    phase: impl Fn(Double) -> Double,
    interpolation: Interpolation,
) -> f64 {
    let at = |u: Double| (sum.at(phase(u)) - sin_pi(value(series, u) / (Double::PI * 2.0))).hi.abs();
    let size: f64 = sum.terms().iter().map(|&(m, w)| f64::from(m + 1) * w.hi.abs()).sum();
    let rounding = sum.sampling_error() + rounding_of_value(series) + size * two_to(-96);
    interpolation.supremum(CosineTable::new(interpolation.points).points().map(at))
        + lebesgue(interpolation.points) * rounding
}

/// What a residual of the sine makes of the angle; `None` if the sum may reach 1.
pub(super) fn of_residual(sum: &Wave, residual: f64) -> Option<f64> {
    let y = Cosines::of(sum.terms());
    let steepest = |low: f64, high: f64| {
        let most = y.over(low, high).largest(0) + residual;
        2.0 / ((1.0 - most) * (1.0 + most)).sqrt()
    };
    let slope = supremum([0.0, 0.5], steepest) * INFLATION_OF_SUMS;
    slope.is_finite().then_some(slope * residual)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arcsines_of_known_sines() {
        let third = twice_arcsine(Double::new(0.5)).unwrap() * 3.0 - Double::PI;
        let half = twice_arcsine(Double::new(0.5).sqrt()).unwrap() * 2.0 - Double::PI;
        assert!(third.hi.abs() < 1e-30 && half.hi.abs() < 1e-30, "{third:?} {half:?}");
        assert_eq!(twice_arcsine(Double::new(1.0)), None);
    }

    /// Of cos πs − ½ cos 3πs, which is largest where cos² πs is 5/12.
    #[test]
    fn what_residuals_of_a_known_sum_make() {
        let sum = |largest: f64| {
            let factor = largest / (5.0 / 3.0 * (5.0_f64 / 12.0).sqrt());
            Wave::harmonics(&[factor, -0.5 * factor].map(Double::new))
        };
        for largest in [0.01, 0.9, 0.999] {
            let expected = 2e-9 / (1.0 - (largest + 1e-9_f64).powi(2)).sqrt();
            let found = of_residual(&sum(largest), 1e-9).unwrap();
            assert!(found >= expected && found < 1.04 * expected, "{largest}: {found:e} {expected:e}");
            assert!(of_residual(&sum(largest), 0.999_999 - largest).is_some(), "{largest}");
            assert_eq!(of_residual(&sum(largest), 1.0 - largest), None);
        }
        assert_eq!(of_residual(&sum(1.0), 0.0), None);
    }
}
