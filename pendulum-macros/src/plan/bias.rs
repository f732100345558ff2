//! How far an approximate θ is from θ, and its derivative from θ̇.

use super::arc::Arc;
use super::cosines::Cosines;
use super::curve::{Curves, SwingCurves};
use crate::exact::Real;
use crate::motion::Swing;
use crate::parse::Method;
use crate::program::rounding::products;
use crate::scene::Scene;
use crate::supremum::by_halves;
use pendulum_runtime::double::Double;
use std::f64::consts::PI;

/// sup |θ0 cos πs − θ| over a horizon of less than an eighth of a period, of which no more than the phases that it meets
/// count; `None` where the horizon is longer, or θ has too many harmonics. `drift` bounds the difference of the phases.
///
/// A longer sum may exceed the amplitude beyond the horizon, where its error over all phases has to stand for that.
pub(super) fn of_cosine(rate: &Real, drift: f64, scene: &Scene, swing: &Swing) -> Option<f64> {
    let [low, high] = phases(scene, swing)?;
    let theta = SwingCurves::new(swing, &scene.motion.omega).angle();
    let terms = theta.terms();
    if terms.len() > MOST_TERMS {
        return None;
    }
    let amplitude = swing.amplitude.to_double();
    let faster = 1.0 + (rate.to_f64() / swing.rate().to_f64() - 1.0).abs();
    let moved = amplitude.hi * of_moved_cosine(low.abs().max(high.abs()) * faster, drift);
    let apart = difference(terms, &[amplitude]);
    let at_same_phase = by_halves([low, high], CELLS, MOST_HALVED, |low, high| apart.over(low, high).largest(0));
    Some((at_same_phase + theta.omitted() + moved) * (1.0 + 1e-9))
}

/// sup |cos πs − cos πs′| for phases up to `farthest` that differ by up to `drift`, in anchors: it is
/// |2 sin ½π(s + s′) sin ½π(s − s′)|, little about a turning point.
pub(super) fn of_moved_cosine(farthest: f64, drift: f64) -> f64 {
    let sine = |anchors: f64| libm::sin((PI * anchors).min(PI / 2.0));
    2.0 * sine(farthest) * sine(0.5 * drift)
}

/// Σ aₘ cos(mπs) of a curve less Σ wₙ cos((2n−1)πs): one sum.
fn difference(terms: &[(u32, Double)], weights: &[Double]) -> Cosines {
    let ours = |index: usize| weights.get(index).copied().unwrap_or(Double::ZERO);
    Cosines::new(terms.iter().enumerate().map(|(index, &(m, a))| (m, (a - ours(index)).hi)))
}

fn sum_of(terms: &[(u32, Double)]) -> Cosines {
    Cosines::new(terms.iter().map(|&(m, a)| (m, a.hi)))
}

/// The phases that the horizon meets, where they are less than from an anchor to a lowest point; the others are mirror
/// images of those.
fn phases(scene: &Scene, swing: &Swing) -> Option<[f64; 2]> {
    let reach = Arc::reach(scene)? * swing.rate().to_f64() * (1.0 + 1e-12);
    let launch = swing.launch.to_f64();
    (reach < 0.25).then_some([launch - reach, launch + reach])
}

/// sup |θ̂′ − θ̇| over the horizon in rad per unit of t, for θ̂ = Σ wₙ cos((2n−1)πs), or twice the arcsine of that for
/// [`Method::Fourier`]. `drift` bounds the difference of the phases, in anchors.
pub(super) fn of_velocity(
    weights: &[Double],
    method: Method,
    rate: &Real,
    drift: f64,
    scene: &Scene,
    swing: &Swing,
) -> f64 {
    let exact_rate = swing.rate().to_f64();
    let curves = SwingCurves::new(swing, &scene.motion.omega);
    let theta = curves.angle();
    let (ours, terms) = (Cosines::odd(weights), theta.terms());
    let (steepest, exact) = (ours.magnitude(1), sum_of(terms));
    let [exact_steepest, exact_bend] = [1, 2].map(|order| exact.magnitude(order));
    if terms.len() > MOST_TERMS {
        let fastest = scene.motion.fastest().to_f64();
        let slopes = if method == Method::Fourier { f64::INFINITY } else { steepest };
        return (slopes * rate.to_f64() + fastest) * (1.0 + 1e-9);
    }
    // Of our phases, which differ by the drift from those that are met.
    let met = phases(scene, swing).filter(|_| drift < 0.25).map(|[low, high]| [low - drift, high + drift]);
    let met = met.unwrap_or([0.0, 0.5]);
    // Both at the same phase and rate; then the other rate, and the other phase.
    let at_same_phase = if method == Method::Fourier {
        let sines = Sines::new(weights, exact, &curves);
        by_halves(met, CELLS, MOST_HALVED, |low, high| sines.apart(low, high))
    } else {
        let apart = difference(terms, weights);
        by_halves(met, CELLS, MOST_HALVED, |low, high| apart.over(low, high).largest(1))
    };
    let faster = match (rate.to_f64() - exact_rate).abs() {
        0.0 => 0.0,
        faster => faster * by_halves(met, CELLS, MOST_HALVED, |low, high| ours.over(low, high).largest(1)),
    };
    let shifted = (exact_bend * drift).min(2.0 * exact_steepest);
    ((at_same_phase + theta.omitted_slope() + shifted) * exact_rate + faster) * (1.0 + 1e-9)
}

/// So near the top that θ has more harmonics, an approximation of it comes to be as far from it as they are large, and
/// so does the derivative.
pub(super) const MOST_TERMS: usize = 400;

/// Cells of the half wave, and how many of them are halved: next to an overshoot the arcsine's derivative peaks within
/// a millionth of the half wave.
const CELLS: u32 = 96;
const MOST_HALVED: usize = 2000;

/// y, of which θ̂ is twice the arcsine, beside Y = sin(θ/2), of which it is the first terms.
struct Sines {
    ours: Cosines,
    whole: Cosines,
    /// ρ = Y − y.
    rest: Cosines,
    theta: Cosines,
    /// What Y, and so ρ, and its derivative are in doubt by.
    omitted: [f64; 2],
}

impl Sines {
    fn new(weights: &[Double], theta: Cosines, curves: &SwingCurves) -> Self {
        let curve = curves.half_sine();
        let (whole, rest) = (sum_of(curve.terms()), difference(curve.terms(), weights));
        Self { ours: Cosines::odd(weights), whole, rest, theta, omitted: [curve.omitted(), curve.omitted_slope()] }
    }

    /// Bounds |θ̂′ − θ′| between two phases. With m = 1 − y² it is |2ρ′ + θ′ρ·tan ¼(θ̂ + θ)|/√m, in which nothing is
    /// large that cancels.
    fn apart(&self, low: f64, high: f64) -> f64 {
        let [y, whole, rest, theta] = [&self.ours, &self.whole, &self.rest, &self.theta].map(|sum| sum.over(low, high));
        let within = |(low, high): (f64, f64), order: usize| (low - self.omitted[order], high + self.omitted[order]);
        let (sines, wholes) = (y.range(0), within(whole.range(0), 0));
        if sines.1.max(wholes.1) >= 1.0 || sines.0.min(wholes.0) <= -1.0 {
            return f64::INFINITY;
        }
        let tangent = |y: f64, whole: f64| libm::tan(0.5 * (libm::asin(y) + libm::asin(whole)));
        let tangents = (tangent(sines.0, wholes.0), tangent(sines.1, wholes.1));
        let [rest, first] = [0, 1].map(|order| within(rest.range(order), order));
        let second = products(products(theta.range(1), rest), tangents);
        let most = (2.0 * first.0 + second.0).abs().max((2.0 * first.1 + second.1).abs());
        most / ((1.0 - y.largest(0)) * (1.0 + y.largest(0))).sqrt()
    }
}

#[cfg(test)]
mod edge_tests;
#[cfg(test)]
mod tests;
