//! How far an approximate θ is from θ, its derivative from θ̇, and what follows from it for θ̈ from that.

mod sines;

use super::Sum;
use super::linearised::Departure;
use crate::exact::Real;
use crate::parse::Method;
use crate::plan::cosines::Cosines;
use crate::plan::curve::{Curve, Curves, SwingCurves};
use crate::plan::met::Met;
use crate::plan::reduction::Clock;
use crate::program::rounding::{INFLATION_OF_SUMS, half_ulp};
use crate::supremum::{Halving, by_halves, larger};
use pendulum_runtime::double::Double;
use sines::Sines;
use std::f64::consts::PI;

/// θ̂ = Σ wₙ cos((2n−1)πs), or twice the arcsine of that for [`Method::Fourier`], beside the θ of a swing.
pub(super) struct Approximate<'a> {
    sum: &'a Sum<'a>,
    /// By how many anchors the phase at this rate comes to differ from the exact one within the horizon.
    drift: f64,
    /// How the linearised motion departs from the exact one within it, where that is the method.
    departure: Departure,
    theta: &'a Curve,
}

impl<'a> Approximate<'a> {
    pub(super) fn new(sum: &'a Sum<'a>, theta: &'a Curve) -> Self {
        let Sum { scene, swing, rate, launch, .. } = sum;
        let (exact, omega) = (swing.rate(), &scene.motion.omega);
        let horizon = rate.context().float(Clock::new(scene, &exact, &swing.launch).reach());
        let until = |t: &Real| ((rate - &exact).abs() * t + (launch - &swing.launch).abs()).to_f64();
        let drift = horizon.as_ref().map_or(f64::INFINITY, until);
        let departure = match &horizon {
            Some(t) if sum.method == Method::SmallAngle => Departure::new(swing, theta, omega, (omega * t).to_f64()),
            _ => Departure::ANY,
        };
        Self { sum, drift, departure, theta }
    }

    /// sup |θ̂ − θ| over the horizon, and what θ̂ is to be held to, if it exceeds the amplitude by more beyond it.
    pub(super) fn angle(&self) -> (f64, Option<f64>) {
        let everywhere = self.everywhere().min(self.departure.angle);
        let Some(distances) = self.met() else { return (everywhere, None) };
        let Sum { scene, swing, .. } = self.sum;
        let amplitude = swing.amplitude.to_f64();
        // From the amplitude to the next number, at least.
        let within = self.within(distances).max(2.0 * half_ulp(amplitude, scene.float)) * INFLATION_OF_SUMS;
        if within >= everywhere {
            return (everywhere, None);
        }
        let not_exceeded = [within, NEXT_TO * within].into_iter().find(|&error| !self.exceeds(error));
        match not_exceeded {
            Some(error) => (error, None),
            None => (within, Some(scene.float.round_down(amplitude + within))),
        }
    }

    /// sup |θ̂′ − θ̇| over the horizon, in rad per unit of t.
    pub(super) fn velocity(&self) -> f64 {
        let &Self { theta, sum: Sum { scene, swing, method, rate, weights, .. }, drift, departure } = self;
        let (ours, exact) = (Cosines::odd(weights), Cosines::of(theta.terms()));
        let (rate, exact_rate) = (rate.to_f64(), swing.rate().to_f64());
        if theta.terms().len() > MOST_HARMONICS {
            let slopes = if *method == Method::Fourier { f64::INFINITY } else { ours.magnitude(1) };
            return (slopes * rate + scene.motion.fastest().to_f64()) * INFLATION_OF_SUMS;
        }
        // Of our phases, which differ by the drift from those that are met.
        let met = self.met().filter(|_| drift < 0.25).map(|[least, farthest]| [least - drift, farthest + drift]);
        let met = met.unwrap_or([0.0, 0.5]);
        // Both at the same phase and rate; then the other rate, and the other phase.
        let omitted = if *method == Method::Fourier { 0.0 } else { theta.omitted_slope() };
        let at_same_phase = self.at_same_phase(met, Sines::slopes_apart, 1) + omitted;
        let faster = match (rate - exact_rate).abs() {
            0.0 => 0.0,
            faster => faster * supremum(met, |low, high| ours.over(low, high).largest(1)),
        };
        let shifted = (exact.magnitude(2) * drift).min(2.0 * exact.magnitude(1));
        let compared = ((at_same_phase + shifted) * exact_rate + faster) * INFLATION_OF_SUMS;
        compared.min(departure.velocity * scene.motion.omega.to_f64() * INFLATION_OF_SUMS)
    }

    /// How far −ω² sin θ̂ by the paper's formula, or otherwise θ̂″, is from θ̈ over the horizon at most, in rad per unit of
    /// t squared.
    pub(super) fn acceleration(&self) -> f64 {
        let &Sum { scene, swing, method, ref rate, .. } = self.sum;
        let omega = &scene.motion.omega;
        if method != Method::Fourier {
            let bent = Sum::of_weights(scene, swing, method, rate.clone(), self.sum.bends());
            let theta = SwingCurves::new(swing, omega).acceleration();
            let compared = Approximate { sum: &bent, theta: &theta, ..*self }.at_most();
            return compared.min(self.departure.acceleration * omega.square().to_f64() * INFLATION_OF_SUMS);
        }
        let by_angle = self.everywhere();
        let apart = if self.theta.terms().len() > MOST_HARMONICS {
            by_angle
        } else {
            let met = self.met().unwrap_or([0.0, 0.5]);
            by_angle.min(self.at_same_phase(met, Sines::sines_apart, 0))
        };
        apart * omega.square().to_f64() * INFLATION_OF_SUMS
    }

    /// sup |θ̂ − θ| over the horizon, as far as what is met of it is known.
    pub(super) fn at_most(&self) -> f64 {
        let everywhere = self.everywhere();
        self.met().map_or(everywhere, |distances| everywhere.min(self.within(distances))) * INFLATION_OF_SUMS
    }

    /// sup |θ̂ − θ| over all phases.
    fn everywhere(&self) -> f64 {
        let Sum { swing, method, weights, .. } = self.sum;
        match method {
            Method::Fourier => swing.elliptic.fourier_analysis().certified_bound(weights.len(), SLACK),
            Method::Series => left_out(self.theta, weights.len()),
            _ => self.of_cosine() + self.moved(0.5),
        }
    }

    /// sup |θ0 cos πs − θ(s)|, of which both are sums of harmonics. So near the top that these are many, θ stays at ±θ0
    /// while the cosine passes zero: they have the same sign, so θ0 is a bound, and they come to be that far apart. So of
    /// their second derivatives the larger one is.
    fn of_cosine(&self) -> f64 {
        let theta = self.theta;
        if theta.terms().len() > MOST_HARMONICS {
            return theta.size.largest.max(self.sum.weights[0].hi.abs()) * (1.0 + 8.0 * f64::EPSILON);
        }
        let mut terms = theta.terms().to_vec();
        if let Some(first) = terms.first_mut() {
            first.1 = first.1 - self.sum.weights[0];
        }
        supremum_of_terms(&terms, theta.omitted())
    }

    /// sup |θ̂ − θ| at those distances from an anchor, if θ has not too many harmonics.
    fn within(&self, [least, farthest]: [f64; 2]) -> f64 {
        let theta = self.theta;
        if theta.terms().len() > MOST_HARMONICS {
            return f64::INFINITY;
        }
        self.at_same_phase([least, farthest], Sines::angles_apart, 0) + theta.omitted() + self.moved(farthest)
    }

    /// The difference of the angles, or of their derivatives by the phase, at one phase of both: given for sines, and the
    /// derivative of that order of a sum.
    fn at_same_phase(&self, phases: [f64; 2], of_sines: fn(&Sines, f64, f64) -> f64, order: usize) -> f64 {
        if self.sum.method == Method::Fourier {
            let sines = self.sines();
            return supremum(phases, |low, high| of_sines(&sines, low, high));
        }
        let apart = difference(self.theta.terms(), &self.sum.weights);
        supremum(phases, |low, high| apart.over(low, high).largest(order))
    }

    /// Whether |θ̂| can be above θ0 by more than an error at any phase.
    fn exceeds(&self, error: f64) -> bool {
        if self.is_cosine() {
            return false;
        }
        let Sum { swing, method, weights, .. } = self.sum;
        let (ours, amplitude) = (Cosines::odd(weights), swing.amplitude.to_f64());
        let over = |low: f64, high: f64| {
            let sum = ours.over(low, high).largest(0);
            let angle =
                if *method == Method::Fourier { 2.0 * libm::asin(if sum > 1.0 { 1.0 } else { sum }) } else { sum };
            larger(angle - amplitude, 0.0)
        };
        let halving = Halving { cells: CELLS, slices: CELLS, most: MOST_HALVED, least: error / 2.0, cap: error };
        halving.largest([0.0, 0.5], over) * INFLATION_OF_SUMS > error
    }

    /// What another rate comes to for phases that go so far from an anchor: of the one cosine θ0 cos πs, which alone has
    /// one.
    fn moved(&self, farthest: f64) -> f64 {
        if self.is_cosine() { self.sum.weights[0].hi.abs() * of_moved_cosine(farthest, self.drift) } else { 0.0 }
    }

    fn is_cosine(&self) -> bool {
        matches!(self.sum.method, Method::Harmonic | Method::SmallAngle)
    }

    /// The phases of both that may be compared within the horizon.
    fn met(&self) -> Option<[f64; 2]> {
        let Sum { scene, swing, .. } = self.sum;
        let met = Met::within(scene, &swing.rate(), &swing.launch);
        met.map(|met| met.distances_as_reduced(&swing.launch, scene))
    }

    fn sines(&self) -> Sines {
        let Sum { scene, swing, weights, .. } = self.sum;
        let curves = SwingCurves::new(swing, &scene.motion.omega);
        Sines::new(weights, self.theta, &curves)
    }
}

/// sup |cos πs − cos πs′| for phases s up to `farthest` that differ from s′ by up to `drift`, in anchors: it is
/// |2 sin ½π(s + s′) sin ½π(s − s′)|, little about a turning point.
fn of_moved_cosine(farthest: f64, drift: f64) -> f64 {
    let sine = |anchors: f64| libm::sin((PI * anchors).min(PI / 2.0));
    2.0 * sine(farthest + 0.5 * drift) * sine(0.5 * drift)
}

/// More terms than this are bounded by the sum of their magnitudes.
const MOST_IN_CELLS: usize = 40;

/// sup |Σ aₘ cos mφ| over the terms of θ, or of a derivative that underflows before it does, but the first `kept`.
fn left_out(theta: &Curve, kept: usize) -> f64 {
    match theta.terms().get(kept..).unwrap_or_default() {
        many if many.len() > MOST_IN_CELLS => many.iter().map(|(_, a)| a.hi.abs()).sum::<f64>() + theta.omitted(),
        few => supremum_of_terms(few, theta.omitted()),
    }
}

/// sup |Σ aₘ cos mφ| of these terms and of more, of which `omitted` is the largest.
fn supremum_of_terms(terms: &[(u32, Double)], omitted: f64) -> f64 {
    let sum = Cosines::of(terms);
    supremum([0.0, 0.5], |low, high| sum.over(low, high).largest(0)) + omitted
}

/// Σ aₘ cos(mπs) of a curve less Σ wₙ cos((2n−1)πs): one sum.
fn difference(terms: &[(u32, Double)], weights: &[Double]) -> Cosines {
    let ours = |index: usize| weights.get(index).copied().unwrap_or(Double::ZERO);
    Cosines::new(terms.iter().enumerate().map(|(index, &(m, a))| (m, (a - ours(index)).hi)))
}

/// An excess of no more than so many errors costs less than what holds it: at a release from rest it often is the error.
const NEXT_TO: f64 = 1.01;

/// How far certified suprema may exceed the true ones.
const SLACK: f64 = 1e-3;

/// So near the top that θ has more harmonics, an approximation of it comes to be as far from it as they are large, and
/// so does the derivative.
pub(super) const MOST_HARMONICS: usize = 400;

/// Cells of the half wave, and how many of them are halved: next to an overshoot the arcsine's derivative peaks within
/// a millionth of the half wave.
const CELLS: u32 = 96;
const MOST_HALVED: usize = 2000;

/// The largest bound of a function of the half wave between two phases.
pub(super) fn supremum(phases: [f64; 2], bound: impl Fn(f64, f64) -> f64) -> f64 {
    by_halves(phases, CELLS, MOST_HALVED, bound)
}

#[cfg(test)]
mod tests;
