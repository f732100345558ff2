//! How far the derivative of an approximate θ is from θ̇.

use super::curve::SwingCurves;
use crate::exact::Real;
use crate::motion::Swing;
use crate::parse::Method;
use crate::scene::Scene;
use pendulum_runtime::double::Double;
use std::f64::consts::PI;

/// sup |θ̂′ − θ̇| in rad per unit of t, for θ̂ = Σ wₙ cos((2n−1)πs), or twice the arcsine of that for
/// [`Method::Fourier`]. `drift` bounds the difference of the phases, in anchors.
pub(super) fn bound(weights: &[Double], method: Method, rate: &Real, drift: f64, scene: &Scene, swing: &Swing) -> f64 {
    let exact_rate = crate::series::swing_rate(swing).to_f64();
    let exact: Vec<(f64, f64)> = {
        let theta = SwingCurves::new(swing, &scene.motion.omega).theta();
        theta.terms().iter().map(|&(m, a)| (f64::from(m) * PI, a.hi)).collect()
    };
    let ours: Vec<(f64, f64)> = weights.iter().enumerate().map(|(n, w)| ((2 * n + 1) as f64 * PI, w.hi)).collect();
    let largest = |terms: &[(f64, f64)]| terms.iter().map(|(m, a)| m * a.abs()).sum::<f64>();
    if exact.len() > MOST_TERMS {
        let fastest = (&swing.elliptic.modulus * &scene.motion.omega).scale(1).to_f64();
        let slopes = if method == Method::Fourier { f64::INFINITY } else { largest(&ours) };
        return (slopes * rate.to_f64() + fastest) * (1.0 + 1e-9);
    }
    let curves = Curves { ours, exact, arcsine: method == Method::Fourier };
    // Both at the same phase and rate; then the other rate, and the other phase.
    let at_same_phase = curves.supremum() * exact_rate;
    let faster = (rate.to_f64() - exact_rate).abs() * largest(&curves.ours);
    let steepest = curves.exact.iter().map(|(m, a)| m * m * a.abs()).sum::<f64>();
    let shifted = (exact_rate * steepest * drift).min(2.0 * exact_rate * largest(&curves.exact));
    (at_same_phase + faster + shifted) * (1.0 + 1e-9)
}

/// Two functions of the phase, by their harmonics (angular frequency, amplitude).
struct Curves {
    ours: Vec<(f64, f64)>,
    exact: Vec<(f64, f64)>,
    arcsine: bool,
}

/// So near the top that θ has more harmonics the two velocities are as far apart as they are large.
const MOST_TERMS: usize = 400;

/// Cells of the half wave.
const CELLS: u32 = 2048;

impl Curves {
    /// sup |θ̂′ − θ′| with respect to the phase: on each cell the value in its middle, and the bound of its slope.
    fn supremum(&self) -> f64 {
        let width = 0.5 / f64::from(CELLS);
        if !self.arcsine {
            return self.supremum_of_sines();
        }
        let exact_bend: f64 = self.exact.iter().map(|(m, a)| m * m * a.abs()).sum();
        let bound = |cell: u32| {
            let s = width * (f64::from(cell) + 0.5);
            let exact: f64 = self.exact.iter().map(|(m, a)| -m * a * (m * s).sin()).sum();
            let (slope, bend) = self.ours_near(s, width);
            (slope - exact).abs() + 0.5 * width * (bend + exact_bend)
        };
        (0..CELLS).map(bound).fold(0.0, f64::max)
    }

    /// Where both are sums of sines, so is their difference.
    fn supremum_of_sines(&self) -> f64 {
        let ours = |index: usize| self.ours.get(index).map_or(0.0, |term| term.1);
        let apart: Vec<(f64, f64)> = self.exact.iter().enumerate().map(|(i, &(m, a))| (m, ours(i) - a)).collect();
        let width = 0.5 / f64::from(CELLS);
        let bend: f64 = apart.iter().map(|(m, a)| m * m * a.abs()).sum();
        let at = |cell: u32| {
            let s = width * (f64::from(cell) + 0.5);
            apart.iter().map(|(m, a)| -m * a * (m * s).sin()).sum::<f64>().abs()
        };
        (0..CELLS).map(at).fold(0.0, f64::max) + 0.5 * width * bend
    }

    /// Our slope at s, and a bound of its own slope within half a `width` of it.
    fn ours_near(&self, s: f64, width: f64) -> (f64, f64) {
        let sum = |f: &dyn Fn(f64, f64) -> f64| self.ours.iter().map(|&(m, a)| f(m, a)).sum::<f64>();
        let first = sum(&|m, a| -m * a * (m * s).sin());
        let bend_bound = sum(&|m, a| m * m * a.abs());
        let y = sum(&|m, a| a * (m * s).cos());
        let (y_most, first_most) =
            (y + 0.5 * width * first.abs() + width * width * bend_bound, first.abs() + width * bend_bound);
        let margin = (1.0 - y * y).max(f64::MIN_POSITIVE);
        let least = (1.0 - y_most * y_most).max(f64::MIN_POSITIVE);
        // (2y′/√m)′ = 2y″/√m + 2y y′²/m^(3/2).
        let bend = 2.0 * bend_bound / least.sqrt() + 2.0 * y_most.abs() * first_most.powi(2) / least.powf(1.5);
        (2.0 * first / margin.sqrt(), bend)
    }
}

#[cfg(test)]
mod tests;
