//! Roundings weighted by their effect on a result: the reverse sweep of automatic differentiation, in intervals.
//!
//! The computed result differs from the exact one by Σ ∂result/∂nodeᵢ·δᵢ, δᵢ being the rounding at the node i and the
//! derivatives taken somewhere between the computed and the exact values (mean value theorem). Intervals that hold both
//! make the bound rigorous.

use super::{INFLATION, Known, LOST, magnitude, products};
use crate::program::{Id, Op, Program};

/// An interval of derivatives.
#[derive(Clone, Copy, Debug)]
struct Slope {
    low: f64,
    high: f64,
}

impl Slope {
    const ZERO: Self = Self { low: 0.0, high: 0.0 };

    fn magnitude(self) -> f64 {
        magnitude((self.low, self.high))
    }

    fn plus(self, other: Self) -> Self {
        Self::outward(self.low + other.low, self.high + other.high)
    }

    fn times(self, low: f64, high: f64) -> Self {
        if self.low == 0.0 && self.high == 0.0 {
            return self;
        }
        let (low, high) = products((self.low, self.high), (low, high));
        Self::outward(low, high)
    }

    /// Ends farther apart by what they are rounded by: slopes may cancel, or underflow.
    fn outward(low: f64, high: f64) -> Self {
        let rounded_by = |end: f64| f64::EPSILON * end.abs() + LOST;
        Self { low: low - rounded_by(low), high: high + rounded_by(high) }
    }
}

impl Known {
    /// The interval of computed and exact values.
    fn both(self) -> (f64, f64) {
        (self.low - self.error, self.high + self.error)
    }
}

impl Program {
    /// Bounds the error of node `result`; infinite where it isn't differentiable. What is given doesn't follow from others.
    pub(super) fn adjoint_error(&self, result: Id, known: &[Known], is_given: &[bool]) -> f64 {
        let slopes = &mut vec![Slope::ZERO; result + 1][..];
        slopes[result] = Slope { low: 1.0, high: 1.0 };
        let mut error = 0.0;
        // By index, since unoptimised iterators would take the planner longer.
        let mut above = result + 1;
        while above > 0 {
            above -= 1;
            let (id, slope) = (above, slopes[above]);
            let steepest = slope.magnitude();
            if steepest == 0.0 {
                continue;
            }
            let local = known[id].local;
            if local > 0.0 {
                error += steepest * local + LOST;
            }
            if !is_given[id] && !pass_back(id, self.nodes[id].op, slope, known, slopes) {
                return f64::INFINITY;
            }
        }
        if error.is_nan() { f64::INFINITY } else { error * INFLATION }
    }
}

/// Adds the slope of a node, after which all that use it have added theirs, to those of its operands; `false` where
/// there is none.
fn pass_back(id: Id, op: Op, slope: Slope, known: &[Known], slopes: &mut [Slope]) -> bool {
    // Whichever sign a number takes, everything before it changes by it alike, unless something goes past it.
    let is_sign = matches!(op, Op::Alternate { .. } | Op::Along { .. } | Op::Against { .. });
    if is_sign && slopes[..id].iter().any(|slope| slope.magnitude() > 0.0) {
        return false;
    }
    let mut add = |id: Id, part: Slope| slopes[id] = slopes[id].plus(part);
    match op {
        Op::Input | Op::Constant { .. } => {}
        Op::Add(a, b) => {
            add(a, slope);
            add(b, slope);
        }
        Op::Sub(a, b) => {
            add(a, slope);
            add(b, slope.times(-1.0, -1.0));
        }
        Op::Mul(a, b) => {
            let ((a_low, a_high), (b_low, b_high)) = (known[a].both(), known[b].both());
            add(a, slope.times(b_low, b_high));
            add(b, slope.times(a_low, a_high));
        }
        Op::Div(a, b) => {
            let ((a_low, a_high), (b_low, b_high)) = (known[a].both(), known[b].both());
            if b_low <= 0.0 && b_high >= 0.0 {
                return false;
            }
            let inverse = slope.times(1.0 / b_high, 1.0 / b_low);
            add(a, inverse);
            add(b, inverse.times(1.0 / b_high, 1.0 / b_low).times(-a_high, -a_low));
        }
        Op::Root(x) => {
            let (low, high) = known[x].both();
            if low <= 0.0 {
                return false;
            }
            add(x, slope.times(0.5 / high.sqrt(), 0.5 / low.sqrt()));
        }
        Op::Abs(x) => {
            let (low, _) = known[x].both();
            add(x, slope.times(if low >= 0.0 { 1.0 } else { -1.0 }, 1.0));
        }
        Op::Min { limit, x } | Op::Max { limit, x } => {
            add(x, slope.times(0.0, 1.0));
            add(limit, slope.times(0.0, 1.0));
        }
        Op::Widen(x) | Op::Narrow(x) | Op::Alternate { x, .. } | Op::Along { x, .. } | Op::Against { x, .. } => {
            add(x, slope);
        }
        Op::CopySign { .. }
        | Op::PowerOfTwo { .. }
        | Op::Head(_)
        | Op::Row { .. }
        | Op::Entry { .. }
        | Op::Select { .. } => return false,
    }
    true
}

#[cfg(test)]
mod tests;
