//! How far the derivative of an approximate θ is from θ̇.

use super::cosines::Cosines;
use super::curve::SwingCurves;
use super::supremum::by_halves;
use crate::exact::Real;
use crate::motion::Swing;
use crate::parse::Method;
use crate::scene::Scene;
use pendulum_runtime::double::Double;

/// sup |θ̂′ − θ̇| in rad per unit of t, for θ̂ = Σ wₙ cos((2n−1)πs), or twice the arcsine of that for
/// [`Method::Fourier`]. `drift` bounds the difference of the phases, in anchors.
pub(super) fn bound(weights: &[Double], method: Method, rate: &Real, drift: f64, scene: &Scene, swing: &Swing) -> f64 {
    let exact_rate = crate::series::swing_rate(swing).to_f64();
    let theta = SwingCurves::new(swing, &scene.motion.omega).theta();
    let (ours, terms) = (Cosines::odd(weights), theta.terms());
    if terms.len() > MOST_TERMS {
        let fastest = (&swing.elliptic.modulus * &scene.motion.omega).scale(1).to_f64();
        let slopes = if method == Method::Fourier { f64::INFINITY } else { ours.magnitude(1) };
        return (slopes * rate.to_f64() + fastest) * (1.0 + 1e-9);
    }
    let exact = Cosines::new(terms.iter().map(|&(m, a)| (m, a.hi)));
    // Both at the same phase and rate; then the other rate, and the other phase.
    let at_same_phase = if method == Method::Fourier {
        by_halves([0.0, 0.5], CELLS, MOST_HALVED, |low, high| of_arcsine(&ours, &exact, low, high))
    } else {
        // The difference of two sums of cosines is one.
        let ours = |index: usize| weights.get(index).map_or(0.0, |weight| weight.hi);
        let apart = Cosines::new(terms.iter().enumerate().map(|(index, &(m, a))| (m, ours(index) - a.hi)));
        by_halves([0.0, 0.5], CELLS, MOST_HALVED, |low, high| apart.over(low, high).largest(1))
    };
    let faster = (rate.to_f64() - exact_rate).abs() * ours.magnitude(1);
    let shifted = (exact.magnitude(2) * drift).min(2.0 * exact.magnitude(1));
    ((at_same_phase + shifted) * exact_rate + faster) * (1.0 + 1e-9)
}

/// So near the top that θ has more harmonics the two velocities are as far apart as they are large.
const MOST_TERMS: usize = 400;

/// Cells of the half wave, and how many of them are halved: next to an overshoot the arcsine's derivative peaks within
/// a millionth of the half wave.
const CELLS: u32 = 96;
const MOST_HALVED: usize = 2000;

/// Bounds |2y′/√m − θ′|, m = 1 − y², between two phases: by the values themselves, or by that in the middle and the
/// slope, (2y′/√m)′ = 2y″/√m + 2y y′²/m^(3/2).
fn of_arcsine(ours: &Cosines, exact: &Cosines, low: f64, high: f64) -> f64 {
    let (y, theta) = (ours.over(low, high), exact.over(low, high));
    let most = y.largest(0);
    let least = (1.0 - most) * (1.0 + most);
    if least <= 0.0 {
        return f64::INFINITY;
    }
    let values = 2.0 * y.largest(1) / least.sqrt() + theta.largest(1);
    let margin = (1.0 - y.middle(0)) * (1.0 + y.middle(0));
    let middle = (2.0 * y.middle(1) / margin.sqrt() - theta.middle(1)).abs();
    let bend = 2.0 * y.largest(2) / least.sqrt() + 2.0 * most * y.largest(1).powi(2) / least.powf(1.5);
    values.min(middle + 0.5 * (high - low) * (bend + theta.largest(2)))
}

#[cfg(test)]
mod edge_tests;
#[cfg(test)]
mod tests;
