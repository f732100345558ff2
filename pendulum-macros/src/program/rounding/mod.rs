//! Forward analysis of rounding: how far a program's computed values can be from what its operations mean exactly.
//!
//! Every node gets an interval that holds its computed value and a bound on |computed − exact|, where exact is the
//! node's value if constants were unrounded and every operation exact. With a result of magnitude at most m, rounding
//! adds at most half a unit in the last place of m; errors of operands propagate by the operation's derivative. This is
//! the method of Higham, *Accuracy and Stability of Numerical Algorithms* (2002), 3.1, with intervals in place of
//! asymptotic constants. Rounding is monotone, so the intervals of computed values are exact when their ends are
//! computed by the very operations of the program; the bounds on errors are inflated by more than their own rounding.
//!
//! Where an operand reaches a result by two ways whose effects cancel, as x does in x·f(x²), that is too pessimistic.
//! The module [`adjoint`] therefore sums the roundings a second time, each weighted by the derivative of the result
//! with respect to the node where it happens; the smaller of the two bounds counts.

mod adjoint;

use super::{Id, Op, Program};
use crate::parse::Float;
use crate::power::{binade, is_power_of_two, power, two_to};
use crate::supremum::{larger, norm};
use pendulum_runtime::double::{Double, two_prod, two_sum};
use pendulum_runtime::support::{LEAST_UNDER_ROOT, NEXT_TO_ZERO, NEXT_TO_ZERO_SINGLE, ROOT_ERROR};

/// Where a value lies and how wrong it can be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Known {
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) error: f64,
    /// The part of the error that arises here, not in operands.
    local: f64,
}

impl Known {
    /// An exactly known value between two numbers.
    pub(crate) const fn between(low: f64, high: f64) -> Self {
        Self::within(low, high, 0.0)
    }

    /// Any value, wrong by anything.
    const fn nothing() -> Self {
        Self::within(f64::NEG_INFINITY, f64::INFINITY, f64::INFINITY)
    }

    /// A value between two numbers, wrong by at most `error`.
    pub(crate) const fn within(low: f64, high: f64, error: f64) -> Self {
        Self { low, high, error, local: error }
    }

    /// A result whose operands contribute `inherited` to its error.
    fn result((low, high): (f64, f64), inherited: f64, local: f64) -> Self {
        Self { low, high, error: inherited + local, local }
    }

    /// The same value, none of whose error arises here.
    fn passed_on(self) -> Self {
        Self { local: 0.0, ..self }
    }

    /// Whether every computed value is the same.
    fn is_number(self) -> bool {
        self.low == self.high
    }

    fn magnitude(self) -> f64 {
        magnitude((self.low, self.high))
    }

    /// The interval of an operation that is monotone in each operand, before it is rounded.
    fn corners(self, other: Self, f: impl Fn(f64, f64) -> f64) -> (f64, f64) {
        hull([f(self.low, other.low), f(self.low, other.high), f(self.high, other.low), f(self.high, other.high)])
    }
}

/// The ends of an interval, rounded as the program rounds.
fn rounded((low, high): (f64, f64), float: Float) -> (f64, f64) {
    (float.round(low), float.round(high))
}

/// The largest magnitude in an interval.
fn magnitude((low, high): (f64, f64)) -> f64 {
    low.abs().max(high.abs())
}

/// The least interval with all of them.
fn hull([a, b, c, d]: [f64; 4]) -> (f64, f64) {
    (a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
}

/// The interval of the products of numbers from two intervals, mostly of one sign each.
pub(crate) fn products(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    if a.0 >= 0.0 && b.0 >= 0.0 {
        (a.0 * b.0, a.1 * b.1)
    } else if a.0 >= 0.0 && b.1 <= 0.0 {
        (a.1 * b.0, a.0 * b.1)
    } else if a.1 <= 0.0 && b.0 >= 0.0 {
        (a.0 * b.1, a.1 * b.0)
    } else if a.1 <= 0.0 && b.1 <= 0.0 {
        (a.1 * b.1, a.0 * b.0)
    } else {
        hull([a.0 * b.0, a.0 * b.1, a.1 * b.0, a.1 * b.1])
    }
}

/// What a product in two words loses where the second underflows: it is made of six of one word, each of which is wrong by
/// half of the smallest number at most, 2⁻¹⁰⁷⁵.
pub(crate) const LOST: f64 = f64::from_bits(3);

/// Some thousands of the smallest numbers, 2⁻¹⁰⁶⁰: more than all are wrong by of which a sum or a coefficient is made.
pub(crate) const UNDERFLOW: f64 = f64::from_bits(1 << 14);

/// What coefficients that are too small for two words change in a sum of so many powers, of a variable of at most `reach`:
/// infinite where such powers over- or underflow. Those of a phase in units of time are of any size.
pub(crate) fn lost_to_underflow(terms: usize, reach: f64) -> f64 {
    if !Float::F64.moderate().contains(&power(reach, terms as i32)) {
        return f64::INFINITY;
    }
    UNDERFLOW * (0..terms).map(|order| power(reach, order as i32)).sum::<f64>()
}

/// Covers the rounding of bounds themselves, computed in `f64` by chains of a few hundred operations at most.
pub(crate) const INFLATION: f64 = 1.0 + 1e-12;

/// The same for sums of thousands of terms, of functions that are wrong by a few units.
pub(crate) const INFLATION_OF_SUMS: f64 = 1.0 + 1e-9;

/// Half a unit in the last place of `magnitude`: the rounding of results up to it.
pub(crate) fn half_ulp(magnitude: f64, float: Float) -> f64 {
    let smallest = match float {
        Float::F64 => f64::from_bits(1),
        Float::F32 => f64::from(f32::from_bits(1)),
    };
    (binade(magnitude) * float.rounding_unit()).max(smallest)
}

/// What results up to `most` are rounded by: next above a power of two they are rounded to it, which is nearer than half a
/// unit there.
pub(crate) fn rounding_up_to(most: Double, float: Float) -> f64 {
    let power = binade(most.hi);
    // Of two words some binary places are lost.
    let above = (most - Double::new(power)).hi + most.hi * two_to(-100);
    above.max(half_ulp(power.next_down(), float)).min(half_ulp(most.hi, float))
}

impl Program {
    /// The norm of the rounding of its results, given what is known of the nodes of these names, as far as it has them.
    pub(crate) fn rounding_given(&self, given: &[(&str, Known)]) -> f64 {
        let given: Vec<(Id, Known)> =
            given.iter().filter_map(|&(name, known)| Some((self.named(name)?, known))).collect();
        self.norm_of_rounding(&given)
    }

    /// The same, given nodes by their numbers.
    pub(crate) fn norm_of_rounding(&self, given: &[(Id, Known)]) -> f64 {
        norm(self.rounding(given).iter().map(|known| known.error))
    }

    /// The error bound of each result where the nodes `given` hold values in the intervals stated.
    pub(crate) fn rounding(&self, given: &[(Id, Known)]) -> Vec<Known> {
        let mut is_given = vec![false; self.nodes.len()];
        for &(id, _) in given {
            is_given[id] = true;
        }
        let mut known: Vec<Known> = Vec::with_capacity(self.nodes.len());
        for (id, node) in self.nodes.iter().enumerate() {
            let here = if is_given[id] { given.iter().find(|(given, _)| *given == id) } else { None };
            known.push(sound(here.map_or_else(|| inflate(step(node.op, node.float, &known)), |&(_, known)| known)));
        }
        let result = |&id: &Id| {
            let forward = known[id];
            Known { error: forward.error.min(self.adjoint_error(id, &known, &is_given)), ..forward }
        };
        self.results.iter().map(result).collect()
    }
}

/// Of what is bounded by no number nothing is known: no minimum may pass it over.
fn sound(known: Known) -> Known {
    let Known { low, high, error, local } = known;
    if (low + error + local).is_nan() || (high + error + local).is_nan() { Known::nothing() } else { known }
}

/// The bounds with what they are rounded by themselves, underflow included.
fn inflate(known: Known) -> Known {
    let inflated = |bound: f64| if bound > 0.0 { bound * INFLATION + LOST } else { bound };
    Known { error: inflated(known.error), local: inflated(known.local), ..known }
}

fn step(op: Op, float: Float, known: &[Known]) -> Known {
    match op {
        Op::Input => Known::between(f64::NEG_INFINITY, f64::INFINITY),
        // Where nothing is known of them.
        Op::PowerOfTwo { .. } | Op::Head(_) | Op::Row { .. } | Op::Entry { .. } | Op::Select { .. } => Known::nothing(),
        Op::Constant { value, rest } => Known::within(value, value, rest.abs()),
        Op::Add(a, b) => sum(known[a], known[b], float),
        Op::Sub(a, b) => {
            let Known { low, high, error, local } = known[b];
            sum(known[a], Known { low: -high, high: -low, error, local }, float)
        }
        Op::Mul(a, b) if a == b => square(known[a], float),
        Op::Mul(a, b) => product(known[a], known[b], float),
        Op::Div(a, b) => quotient(known[a], known[b], float),
        Op::Root(x) => root(known[x], float),
        Op::Abs(x) => {
            let Known { low, high, error, .. } = known[x];
            let least = if low <= 0.0 && high >= 0.0 { 0.0 } else { low.abs().min(high.abs()) };
            Known::result((least, known[x].magnitude()), error, 0.0)
        }
        Op::Min { limit, x } => extreme(known[limit], known[x], f64::min),
        Op::Max { limit, x } => extreme(known[limit], known[x], f64::max),
        Op::CopySign { magnitude: x, .. } | Op::Alternate { x, .. } | Op::Along { x, .. } | Op::Against { x, .. } => {
            let magnitude = known[x].magnitude();
            Known::result((-magnitude, magnitude), known[x].error, 0.0)
        }
        Op::Widen(x) => known[x].passed_on(),
        Op::Narrow(x) => {
            let Known { low, high, error, .. } = known[x];
            let within = |most| magnitude((low, high)) <= most;
            let (low, high) = rounded((low, high), float);
            Known::result((low, high), error, rounding(low, high, within, float))
        }
    }
}

/// The smaller or larger of a limit and a number.
fn extreme(limit: Known, x: Known, choose: fn(f64, f64) -> f64) -> Known {
    Known::result((choose(limit.low, x.low), choose(limit.high, x.high)), x.error.max(limit.error), 0.0)
}

/// The operands are numbers of the type themselves: none is nearer to the sum than either, so that what is lost is at
/// most the smaller one, unless it overflows.
fn sum(a: Known, b: Known, float: Float) -> Known {
    let (low, high) = rounded((a.low + b.low, a.high + b.high), float);
    let ends = [(a.low, b.low), (a.high, b.high)];
    let reach = |most| ends.into_iter().all(|(x, y)| is_within(two_sum(x, y), most));
    let of_intervals = || rounding(low, high, reach, float).min(a.magnitude()).min(b.magnitude());
    let local = if overflows(low, high) {
        f64::INFINITY
    } else {
        of_numbers(a, b, two_sum, float).unwrap_or_else(of_intervals)
    };
    Known::result((low, high), a.error + b.error, local)
}

fn product(a: Known, b: Known, float: Float) -> Known {
    let (low, high) = rounded(products((a.low, a.high), (b.low, b.high)), float);
    let ends = [(a.low, b.low), (a.low, b.high), (a.high, b.low), (a.high, b.high)];
    let reach = |most| ends.into_iter().all(|(x, y)| is_within(two_prod(x, y), most));
    let power = |x: Known| x.is_number() && is_power_of_two(x.low.abs());
    let local = match (power(a), power(b)) {
        _ if overflows(low, high) => f64::INFINITY,
        (false, false) => of_numbers(a, b, two_prod, float).unwrap_or_else(|| rounding(low, high, reach, float)),
        (true, _) if a.low.abs() >= 1.0 => 0.0,
        (_, true) if b.low.abs() >= 1.0 => 0.0,
        // Nothing but what may underflow.
        _ => half_ulp(0.0, float),
    };
    let lost = if a.error > 0.0 || b.error > 0.0 { LOST } else { 0.0 };
    let inherited = a.magnitude() * b.error + b.magnitude() * a.error + a.error * b.error + lost;
    Known::result((low, high), inherited, local)
}

/// Whether results within these bounds may be no numbers, of which nothing is known but that.
fn overflows(low: f64, high: f64) -> bool {
    !(low.is_finite() && high.is_finite())
}

/// The rounding of an operation on two numbers, if they are that, by one that tells it.
fn of_numbers(a: Known, b: Known, operation: fn(f64, f64) -> (f64, f64), float: Float) -> Option<f64> {
    let lost = || lost(operation(a.low, b.low), float) + half_ulp(0.0, float).max(UNDERFLOW);
    (a.is_number() && b.is_number()).then(lost).filter(|lost| lost.is_finite())
}

/// Whether a result in two words is no larger than `most`.
fn is_within((result, rest): (f64, f64), most: f64) -> bool {
    // What overflows in two words has no rest, which then is no number: nothing is known of it.
    let is_below = if result < 0.0 { rest >= 0.0 } else { rest <= 0.0 };
    result.abs() < most || (result.abs() == most && is_below)
}

/// How much of a result in two words rounding takes.
fn lost((result, rest): (f64, f64), float: Float) -> f64 {
    (result - float.round(result)).abs() + rest.abs()
}

/// A product of a number with itself isn't negative.
fn square(x: Known, float: Float) -> Known {
    let product = product(x, x, float);
    let straddles = x.low <= 0.0 && x.high >= 0.0;
    let least = if straddles { 0.0 } else { float.round(x.low * x.low).min(float.round(x.high * x.high)) };
    Known { low: least, ..product }
}

/// The rounding to results between `low` and `high`. Up to a power of two the binade below counts, if the exact results
/// are `within` it; else what may be rounded to it from above.
fn rounding(low: f64, high: f64, within: impl FnOnce(f64) -> bool, float: Float) -> f64 {
    let magnitude = magnitude((low, high));
    half_ulp(if is_power_of_two(magnitude) && within(magnitude) { magnitude / 2.0 } else { magnitude }, float)
}

fn quotient(a: Known, b: Known, float: Float) -> Known {
    let least = b.low.abs().min(b.high.abs()) - b.error;
    if b.low <= 0.0 && b.high >= 0.0 || least <= 0.0 {
        return Known::nothing();
    }
    let exact = a.corners(b, |x, y| x / y);
    let range = rounded(exact, float);
    let local = half_ulp(magnitude(range), float);
    let lost = if b.error > 0.0 { LOST } else { 0.0 };
    Known::result(range, (a.error + (magnitude(exact) * b.error + lost)) / least, local)
}

/// |√a − √b| is at most both |a − b|/√a and √|a − b|. Just below 0 and of numbers below all normal ones what is computed is
/// next to 0; farther below it is no number.
fn root(x: Known, float: Float) -> Known {
    let least_normal = float.least_normal();
    if x.low < LEAST_UNDER_ROOT || x.high < least_normal {
        return Known::nothing();
    }
    let next_to_zero = match float {
        _ if x.low >= least_normal => 0.0,
        Float::F64 => NEXT_TO_ZERO,
        Float::F32 => NEXT_TO_ZERO_SINGLE,
    };
    let exact = (x.low.max(0.0).sqrt(), x.high.max(0.0).sqrt());
    let inherited = if exact.0 > 0.0 { (x.error / exact.0).min(x.error.sqrt()) } else { x.error.sqrt() };
    let local = larger(ROOT_ERROR * float.rounding_unit() * exact.1, next_to_zero);
    let (low, high) = rounded(exact, float);
    Known::result((low * (1.0 - 1e-6) - next_to_zero, high * (1.0 + 1e-6)), inherited, local)
}

#[cfg(test)]
mod tests;
