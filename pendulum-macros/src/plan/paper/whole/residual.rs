//! What an interpolant Q of θ̂ = 2 arcsin y is wrong by, from its residual R = y − sin(Q/2), which is analytic wherever y
//! and Q are.
//!
//! Q/2, which is arcsin y at the points of the interpolation, stays between −π/2 and π/2 from one of them to the next if
//! |y| and |y − R| = |sin(Q/2)| are below 1 there. Where they are at most Y, |θ̂ − Q| ≤ 2|R|/√(1 − Y²).
//!
//! Their derivatives are 2y′/√(1 − y²) and 2(y′ − R′)/√(1 − (y − R)²), so that |θ̂′ − Q′| ≤ 2(|R′| + |y′R|·Y/(1 − Y²))/√(1 −
//! Y²). R′ follows from R: its Chebyshev coefficients are at most 2 sup |R| each, and from the n-th on, n being the points of
//! R's interpolation, as small as the bound of R on the ellipse makes them. Σj²·2 sup |R| up to there is less than ⅔n³ sup
//! |R|, and what follows, for ρ ≥ 3 and n ≥ 16, less than n² times the interpolation's error, which sup |R| includes: less
//! than n³ sup |R| together.

use crate::chebyshev::{CosineTable, Interpolation, cos_pi, lebesgue, rounding_of_value, sin_pi, value};
use crate::plan::cosines::Cosines;
use crate::plan::paper::bias::supremum;
use crate::power::{power, two_to};
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
    (y.hi.abs() < 1.0).then_some(x * Double::TURN)
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
    let at = |u: Double| (sum.at(phase(u)) - sin_pi(value(series, u) / Double::TURN)).hi.abs();
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

/// The fewest points with which a residual's derivative is bounded.
pub(super) const LEAST_POINTS_OF_SLOPE: usize = 16;

/// What residuals make of the angle's derivative by u, of phases c + `half`·u, given that their own are at most `slope`: they
/// themselves are n³ times less. `None` if the sum may reach 1.
pub(super) fn of_residual_slope(sum: &Wave, half: f64, slope: f64) -> Option<f64> {
    let y = Cosines::of(sum.terms());
    let residual = slope / power(LEAST_POINTS_OF_SLOPE as f64, 3);
    let bound = |low: f64, high: f64| {
        let local = y.over(low, high);
        let most = local.largest(0) + residual;
        let room = (1.0 - most) * (1.0 + most);
        2.0 * (slope + half * local.largest(1) * residual * most / room) / room.sqrt()
    };
    let error = supremum([0.0, 0.5], bound) * INFLATION_OF_SUMS;
    error.is_finite().then_some(error)
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

    /// Of Y cos πs, with a residual whose slope is all there is, and one that moves the angle along the arcsine's.
    #[test]
    fn what_slopes_of_residuals_make() {
        for largest in [0.01, 0.9, 0.999] {
            let sum = Wave::harmonics(&[Double::new(largest)]);
            let steepest = 2.0 / (1.0 - largest * largest).sqrt();
            let found = of_residual_slope(&sum, 1e-9, 1e-9).unwrap() / (steepest * 1e-9);
            assert!((1.0..1.04).contains(&found), "{largest}: {found}");
            // 2|y′R|·Y/(1 − Y²)^(3/2), where y′ is at most πY sin πs.
            let moved = |s: f64| {
                let (sine, y) = (libm::sin(PI * s), largest * libm::cos(PI * s));
                2.0 * PI * largest * sine * y / (1.0 - y * y).powf(1.5)
            };
            let most = (0..=100_000).map(|i| moved(f64::from(i) / 200_000.0)).fold(0.0, f64::max);
            let residual = 1e-12 / 4096.0;
            let found = (of_residual_slope(&sum, 1e9, 1e-12).unwrap() - steepest * 1e-12) / (most * 1e9 * residual);
            assert!((0.9..1.2).contains(&found), "{largest}: {found}");
        }
        assert_eq!(of_residual_slope(&Wave::harmonics(&[Double::new(1.0)]), 0.01, 1e-20), None);
    }
}
