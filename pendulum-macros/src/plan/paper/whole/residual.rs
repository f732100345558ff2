//! What an interpolant Q of θ̂ = 2 arcsin y is wrong by, from its residual R = y − sin(Q/2), which is analytic wherever y
//! and Q are.
//!
//! Where |y| and |y − R| = |sin(Q/2)| are at most Y < 1, Q/2, which is arcsin y at the points of the interpolation, stays
//! between −π/2 and π/2 from one of them to the next, and |θ̂ − Q| ≤ 2 sup|R|/√(1 − Y²).

use crate::chebyshev::{cos_pi, sin_pi, value};
use crate::power::power;
use crate::series::Wave;
use crate::supremum::worst;
use pendulum_runtime::double::Double;
use std::f64::consts::PI;

/// 2 arcsin y, by Newton's method on sin πx = y; `None` if |y| ≥ 1.
pub(super) fn twice_arcsine(y: Double) -> Option<Double> {
    let mut x = Double::new(libm::asin(y.hi) / PI);
    for _ in 0..2 {
        x = x + (y - sin_pi(x)) / (Double::PI * cos_pi(x));
    }
    (y.hi.abs() < 1.0).then_some(x * Double::PI * 2.0)
}

/// |y − sin(Q/2)| where the sum is y and the interpolant Q has its variable at u.
pub(super) fn residual(y: Double, series: &[Double], u: Double) -> f64 {
    (y - sin_pi(value(series, u) / (Double::PI * 2.0))).hi.abs()
}

/// What a residual of the sine makes of the angle; `None` if the sum, known at some points, may reach 1.
pub(super) fn of_residual(sum: &Wave, points: &[Point], residual: f64) -> Option<f64> {
    let most = largest(points, bend(sum)) + residual;
    (most < 1.0).then(|| 2.0 * residual / (1.0 - most * most).sqrt())
}

/// Bounds |y″|.
fn bend(sum: &Wave) -> f64 {
    sum.terms().iter().map(|&(m, w)| w.hi.abs() * power(f64::from(m) * PI, 2)).sum()
}

/// |y| at a phase.
#[derive(Clone, Copy)]
pub(super) struct Point {
    pub(super) s: f64,
    pub(super) y: f64,
}

/// Bounds |y| where |y″| ≤ `bend`, from points between the lowest point, ½, and the turning point, 0, about which y is
/// odd and even.
fn largest(points: &[Point], bend: f64) -> f64 {
    let lowest = Point { s: 0.5, y: 0.0 };
    let other_side = points.last().map(|&Point { s, y }| Point { s: -s, y });
    let all: Vec<Point> = std::iter::once(lowest).chain(points.iter().copied()).chain(other_side).collect();
    let between = |pair: &[Point]| worst([pair[0].y, pair[1].y]) + bend * power(pair[0].s - pair[1].s, 2) / 8.0;
    worst(all.windows(2).map(between))
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

    /// Of cos πs − ½ cos 3πs.
    #[test]
    fn the_bend_of_a_known_sum() {
        let sum = Wave::harmonics(&[Double::ONE, Double::new(-0.5)]);
        assert!((bend(&sum) - 5.5 * PI * PI).abs() < 1e-12);
    }

    /// cos πs, of which no sample is the largest value.
    #[test]
    fn the_largest_sum_between_samples() {
        let at = |s: f64| Point { s, y: (PI * s).cos() };
        let bound = |samples: &[f64]| largest(&samples.iter().map(|&s| at(s)).collect::<Vec<_>>(), PI * PI);
        let fine = bound(&[0.4, 0.3, 0.2, 0.1, 0.04]);
        assert!(fine > 1.0 && fine < 1.01, "{fine}");
        // Where samples are missing the bend counts: π²/8 times the square of the gap.
        assert!((bound(&[0.05]) - at(0.05).y - PI * PI / 8.0 * 0.45 * 0.45).abs() < 1e-12);
        assert!((bound(&[0.45, 0.2]) - at(0.2).y - PI * PI / 8.0 * 0.16).abs() < 1e-12);
    }
}
