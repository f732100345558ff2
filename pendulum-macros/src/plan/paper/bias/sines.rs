//! Two arcsines beside each other, of sums of harmonics: how far θ̂ is from θ, cell by cell.

use super::difference;
use crate::plan::cosines::Cosines;
use crate::plan::curve::{Curve, Curves, SwingCurves};
use crate::program::rounding::products;
use pendulum_runtime::double::Double;

/// y, of which θ̂ is twice the arcsine, beside Y = sin(θ/2), of which it is the first terms.
pub(super) struct Sines {
    pub(super) ours: Cosines,
    pub(super) whole: Cosines,
    /// ρ = Y − y.
    pub(super) rest: Cosines,
    pub(super) theta: Cosines,
    /// What Y, and so ρ, and its derivative are in doubt by; and θ′.
    pub(super) omitted: [f64; 2],
    pub(super) omitted_slope: f64,
    /// k′, which cos(θ/2) is at least.
    pub(super) complementary: f64,
}

impl Sines {
    pub(super) fn new(weights: &[Double], theta: &Curve, curves: &SwingCurves) -> Self {
        let (theta, omitted_slope) = (Cosines::of(theta.terms()), theta.omitted_slope());
        let curve = curves.half_sine();
        let (whole, rest) = (Cosines::of(curve.terms()), difference(curve.terms(), weights));
        let omitted = [curve.omitted(), curve.omitted_slope()];
        let complementary = curves.complementary();
        Self { ours: Cosines::odd(weights), whole, rest, theta, omitted, omitted_slope, complementary }
    }

    /// Bounds |θ̂ − θ| between two phases: with C = cos(θ/2) it is 2 arcsin(|ρ|(y + Y)/(yC + Y√(1 − y²))), where neither
    /// is negative, and everywhere at most 2|ρ| times the arcsine's slope.
    pub(super) fn angles_apart(&self, low: f64, high: f64) -> f64 {
        let [y, whole, rest] = [&self.ours, &self.whole, &self.rest].map(|sum| sum.over(low, high));
        let omitted = self.omitted[0];
        let [least, least_whole] = [y.range(0).0, whole.range(0).0 - omitted];
        let [most, most_whole] = [y.largest(0), whole.largest(0) + omitted];
        let rest = rest.largest(0) + omitted;
        let cosine = |sine: f64| ((1.0 - sine) * (1.0 + sine)).max(0.0).sqrt();
        let (ours, exact) = (cosine(most), cosine(most_whole).max(self.complementary));
        let by_slope = 2.0 * rest / ours.min(exact);
        if least < 0.0 || least_whole < 0.0 {
            return by_slope;
        }
        let divisor = least * exact + least_whole * ours;
        by_slope.min(2.0 * libm::asin((rest * (most + most_whole) / divisor).min(1.0)))
    }

    /// Bounds |sin θ̂ − sin θ| between two phases, 2|cos ½(θ̂ + θ) sin ½(θ̂ − θ)|.
    pub(super) fn sines_apart(&self, low: f64, high: f64) -> f64 {
        let [(a, b), (c, d)] = [&self.ours, &self.whole].map(|sum| sum.over(low, high).range(0));
        let half = |sine: f64| libm::asin(sine.clamp(-1.0, 1.0));
        let (least, most) = (2.0 * half(a.min(c - self.omitted[0])), 2.0 * half(b.max(d + self.omitted[0])));
        let steepest = if least <= 0.0 { 1.0 } else { libm::cos(least).abs().max(libm::cos(most).abs()) };
        self.angles_apart(low, high) * steepest
    }

    /// Bounds |θ̂′ − θ′| between two phases. With m = 1 − y² it is |2ρ′ + θ′ρ·tan ¼(θ̂ + θ)|/√m, in which nothing is
    /// large that cancels.
    pub(super) fn slopes_apart(&self, low: f64, high: f64) -> f64 {
        let [y, whole, rest, theta] = [&self.ours, &self.whole, &self.rest, &self.theta].map(|sum| sum.over(low, high));
        let within = |(low, high): (f64, f64), omitted: f64| (low - omitted, high + omitted);
        let (sines, wholes) = (y.range(0), within(whole.range(0), self.omitted[0]));
        if sines.1.max(wholes.1) >= 1.0 || sines.0.min(wholes.0) <= -1.0 {
            return f64::INFINITY;
        }
        let tangent = |y: f64, whole: f64| libm::tan(0.5 * (libm::asin(y) + libm::asin(whole)));
        let tangents = (tangent(sines.0, wholes.0), tangent(sines.1, wholes.1));
        let [rest, first] = [0, 1].map(|order| within(rest.range(order), self.omitted[order]));
        let slopes = within(theta.range(1), self.omitted_slope);
        let second = products(products(slopes, rest), tangents);
        let most = (2.0 * first.0 + second.0).abs().max((2.0 * first.1 + second.1).abs());
        most / ((1.0 - y.largest(0)) * (1.0 + y.largest(0))).sqrt()
    }
}
