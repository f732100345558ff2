//! Sums of harmonics of one cosine, evaluated by Clenshaw's recurrence: the paper's θ̂ (Eq. 22), its derivative, and
//! the series of θ (Eq. 17 being its shape with one term).
//!
//! With X = 2 cos 2φ and uₙ = wₙ + X·uₙ₊₁ − uₙ₊₂, Σ wₙ cos((2n−1)φ) = cos φ·(u₁ − u₂) and
//! Σ wₙ sin((2n−1)φ) = sin φ·(u₁ + u₂). The recurrence is linear in the weights, so that a rounding error made in uₙ is
//! an error of wₙ, which the sum passes on at most undiminished: the errors add, they don't multiply.

use super::arcsine::Arcsine;
use super::cosines::Cosines;
use super::kernel::{CELLS, Kernel, RESULT, from_lowest, rounding_given};
use super::polynomial::Polynomial;
use super::reduction::{Origin, Reduction};
use super::variables::Variables;
use crate::program::rounding::{Known, half_ulp};
use crate::program::{Builder, Id, Op, Program};
use crate::series::Parity;
use crate::supremum::by_halves;
use pendulum_runtime::double::Double;

/// How one output is a sum of harmonics.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Harmonics {
    /// cos πs, without sign.
    pub(crate) cosine: Polynomial,
    /// sin πs, where the output is a derivative.
    pub(crate) sine: Option<Polynomial>,
    /// Weights of cos((2n−1)πs).
    pub(crate) cosines: Vec<Double>,
    /// Weights of sin((2n−1)πs), where the output is a derivative.
    pub(crate) sines: Vec<Double>,
    /// The sum of cosines as one polynomial, where that is as accurate: its chain of operations is the shorter.
    pub(crate) folded: Option<Polynomial>,
    /// Of the sum of cosines, in the paper's formula.
    pub(crate) arcsine: Option<Arcsine>,
    /// −1 for a mirror image; the weights of cosines under an arcsine are never mirrored.
    pub(crate) direction: f64,
}

/// How often slices are halved where the rounding peaks.
const MOST_HALVED: usize = 200;

/// The sums, whose ranges the analysis of the rounding knows.
const ARGUMENT: &str = "argument";
const SLOPE: &str = "slope";

impl Harmonics {
    pub(super) fn is_odd(&self) -> bool {
        self.sine.is_some()
    }

    /// Whether the rounding has a narrow peak: that of the derivative of an arcsine, where its argument comes near 1.
    fn peaks(&self) -> bool {
        self.is_odd() && self.arcsine.is_some()
    }

    pub(super) fn terms(&self) -> usize {
        self.cosines.len().max(self.sines.len())
    }

    pub(super) fn describe(&self) -> String {
        let terms = self.terms();
        if let (Some(folded), Some(arcsine)) = (&self.folded, &self.arcsine) {
            let (sum, arcsine) = (folded.describe(), arcsine.terms());
            return format!("{terms} harmonics folded into a {sum}, an arcsine by a polynomial of {arcsine} terms");
        }
        let cosine = self.cosine.terms();
        let arcsine = self
            .arcsine
            .as_ref()
            .map_or(String::new(), |arcsine| format!(", an arcsine by a polynomial of {} terms", arcsine.terms()));
        format!("{terms} harmonics by recurrence from one cosine of {cosine} terms{arcsine}")
    }

    pub(super) fn lower(&self, b: &mut Builder, variables: &Variables, name: &'static str) -> Id {
        let value = match (&self.sine, &self.folded) {
            (None, Some(folded)) => {
                let sum = folded.magnitude(b, variables);
                b.name(sum, ARGUMENT);
                self.arcsine.as_ref().map_or(sum, |arcsine| arcsine.lower(b, sum, self.direction))
            }
            (None, None) => {
                let cosine = self.cosine(b, variables);
                self.value(b, cosine)
            }
            (Some(sine), _) => {
                let cosine = self.cosine(b, variables);
                let sine = sine.magnitude(b, variables);
                b.name(sine, "sine");
                self.derivative(b, cosine, sine)
            }
        };
        b.name(value, name);
        let parity = if self.is_odd() { Parity::Odd } else { Parity::Even };
        variables.signed(b, value, true, parity)
    }

    fn cosine(&self, b: &mut Builder, variables: &Variables) -> Id {
        let cosine = self.cosine.magnitude(b, variables);
        b.name(cosine, "cosine")
    }

    fn value(&self, b: &mut Builder, cosine: Id) -> Id {
        let sum = self.sum_of_cosines(b, cosine);
        self.arcsine.as_ref().map_or(sum, |arcsine| arcsine.lower(b, sum, self.direction))
    }

    /// The sum of sines; of an arcsine, 2y′/√((1 − y)(1 + y)).
    fn derivative(&self, b: &mut Builder, cosine: Id, sine: Id) -> Id {
        let (first, second) = clenshaw(b, cosine, &self.sines);
        let sum = second.map_or(first, |second| b.add(first, second));
        let slope = b.mul(sine, sum);
        b.name(slope, SLOPE);
        if self.arcsine.is_none() {
            return slope;
        }
        let y = self.sum_of_cosines(b, cosine);
        let one = b.constant(1.0);
        let (below, above) = (b.sub(one, y), b.add(one, y));
        let product = b.mul(below, above);
        let root = b.push(Op::Root(product));
        let quotient = b.div(slope, root);
        b.add(quotient, quotient)
    }

    fn sum_of_cosines(&self, b: &mut Builder, cosine: Id) -> Id {
        let (first, second) = clenshaw(b, cosine, &self.cosines);
        let difference = second.map_or(first, |second| b.sub(first, second));
        let sum = b.mul(cosine, difference);
        b.name(sum, ARGUMENT)
    }

    /// The rounding over the whole range of the phase; some number above `cap` as soon as it is known to be, but for a
    /// derivative of an arcsine.
    pub(super) fn rounding(&self, program: &Program, reduction: &Reduction, cap: f64) -> f64 {
        let Some(phase) = program.named(reduction.origin.phase()) else { return f64::INFINITY };
        let of_polynomial =
            |polynomial: &Polynomial| Kernel::Polynomial(polynomial.clone()).rounding(reduction, f64::INFINITY);
        let sums = self.sums(reduction, self.errors(of_polynomial));
        let given = |sums: &[Sum], low: f64, high: f64| {
            let mut known = vec![(phase, Known::between(low, high))];
            let known_sum = |sum: &Sum| Some((program.named(sum.name)?, sum.known(reduction, low, high)));
            known.extend(sums.iter().filter_map(known_sum));
            rounding_given(program, &known)
        };
        // A sum of few terms that is the result itself is analysed better step by step.
        let between = |low: f64, high: f64| {
            let closed = given(&sums, low, high);
            if self.arcsine.is_none() { closed.min(given(&[], low, high)) } else { closed }
        };
        if self.peaks() {
            return by_halves(reduction.range(), CELLS * CELLS, MOST_HALVED, between);
        }
        from_lowest(reduction, cap, between)
    }

    /// The errors of the cosine and the sine, given the rounding of a polynomial.
    fn errors(&self, rounding: impl Fn(&Polynomial) -> f64) -> [f64; 2] {
        let error = |polynomial: &Polynomial| rounding(polynomial) + polynomial.truncation;
        let cosine = self.folded.as_ref().unwrap_or(&self.cosine);
        [error(cosine), self.sine.as_ref().map_or(0.0, error)]
    }

    /// The sums that the program computes, given the errors of the cosine and the sine.
    fn sums(&self, reduction: &Reduction, [cosine, sine]: [f64; 2]) -> Vec<Sum> {
        let float = reduction.float;
        let sum = |name, curve, order, weights: &[Double], factor: f64| {
            let name = if self.arcsine.is_some() { name } else { RESULT };
            // The factor before u₁ ∓ u₂, which are at most these.
            let both = total(weights, 0) + total(weights, 1);
            let recurrence = || recurrence_error(weights, cosine, float.unit()) + factor * both;
            // The product may underflow, too.
            let error = if self.folded.is_some() { cosine } else { recurrence() + half_ulp(0.0, float) };
            Sum { name, curve, order, error }
        };
        let mut all = vec![];
        if !self.cosines.is_empty() {
            all.push(sum(ARGUMENT, Cosines::odd(&self.cosines), 0, &self.cosines, cosine));
        }
        if !self.sines.is_empty() {
            all.push(sum(SLOPE, Cosines::integral_of_sines(&self.sines), 1, &self.sines, sine));
        }
        all
    }
}

/// A sum in a program, and how wrong it is computed.
struct Sum {
    name: &'static str,
    /// It is the derivative of this order.
    curve: Cosines,
    order: usize,
    error: f64,
}

impl Sum {
    /// What is known of it where the phase is between `low` and `high`, for [`crate::program::Program::rounding`].
    fn known(&self, reduction: &Reduction, low: f64, high: f64) -> Known {
        let from_anchor = |phase: f64| {
            let phase = phase * reduction.unit.hi;
            if reduction.origin == Origin::Anchor { phase } else { 0.5 - phase }
        };
        let (low, high) = self.curve.over(from_anchor(low), from_anchor(high)).range(self.order);
        Known::within(low - self.error, high + self.error, self.error)
    }
}

/// u₁ and u₂ (absent for a single weight).
fn clenshaw(b: &mut Builder, cosine: Id, weights: &[Double]) -> (Id, Option<Id>) {
    let constants: Vec<Id> = weights.iter().map(|&weight| b.exact(weight)).collect();
    let Some((&last, rest)) = constants.split_last() else { return (cosine, None) };
    let square = b.mul(cosine, cosine);
    let (four, two) = (b.constant(4.0), b.constant(2.0));
    let fourfold = b.mul(square, four);
    let x = b.sub(fourfold, two);
    b.name(x, "twice_cosine_of_double");
    let (mut here, mut before) = (last, None);
    for &weight in rest.iter().rev() {
        let product = b.mul(x, here);
        let sum = b.add(weight, product);
        let next = before.map_or(sum, |before| b.sub(sum, before));
        (before, here) = (Some(here), next);
    }
    (here, before)
}

/// Σ_{m ≥ n} |wₘ|(m − n + 1), a bound of |uₙ| (n from 0).
fn total(weights: &[Double], n: usize) -> f64 {
    weights.iter().skip(n).enumerate().map(|(i, w)| w.hi.abs() * (i + 1) as f64).sum()
}

/// What the recurrence's roundings and the cosine's error `cosine` add, relative to the final product's factor.
///
/// They are relative to the uₙ as computed, which exceed their bounds by at most a part η: each of the roundings is at
/// most a part c of these, and is passed on as often as weights follow.
fn recurrence_error(weights: &[Double], cosine: f64, unit: f64) -> f64 {
    let x_error = 8.0 * cosine + 6.0 * unit;
    let local = |n: usize| {
        let (here, next) = (total(weights, n), total(weights, n + 1));
        unit * (2.0 * next + (weights[n].hi.abs() + 2.0 * next) + here + weights[n].hi.abs()) + x_error * next
    };
    let steps: f64 = (0..weights.len()).map(local).sum();
    let last_sum_and_product = 2.0 * unit * (total(weights, 0) + total(weights, 1));
    let eta = (7.0 * unit + x_error) * 0.5 * (weights.len() * (weights.len() + 1)) as f64;
    if eta < 1.0 { (steps + last_sum_and_product) / (1.0 - eta) } else { f64::INFINITY }
}

#[cfg(test)]
mod tests;
