//! What a program costs.

use super::{Node, Op, Program};
use crate::parse::Float;

impl Program {
    /// The number of operations (constants and the input are free).
    pub(crate) fn operations(&self) -> usize {
        let is_free = |op: Op| matches!(op, Op::Input | Op::Constant { .. } | Op::Entry { .. });
        self.nodes.iter().filter(|node| !is_free(node.op)).count()
    }

    /// Relative cost in an array loop, one addition or multiplication of the input's type being 1. Wide operations in a
    /// narrow program have half the lanes.
    pub(crate) fn cost(&self) -> f64 {
        let lanes = |node: &Node| if node.float == self.float() { 1.0 } else { 2.0 };
        let sum: f64 = self.nodes.iter().map(|node| lanes(node) * weight(node.op)).sum();
        self.lanes_lost() * sum
    }

    /// The same where loops over arrays, calls one by one, and calls of which each waits for the one before count alike,
    /// the last two without a vector to share: the geometric mean of the three.
    pub(crate) fn cost_of_calls_too(&self) -> f64 {
        let lost = self.lanes_lost();
        self.cost() / lost * libm::cbrt(lost)
    }

    fn lanes_lost(&self) -> f64 {
        if self.table.is_empty() { 1.0 } else { lanes_lost(self.float()) }
    }

    /// The type of the time.
    fn float(&self) -> Float {
        self.nodes.first().map_or(Float::F64, |node| node.float)
    }
}

/// What finding a row of a table costs: bits, a mask and an address. That loops over a table don't vectorise as others
/// do counts by [`lanes_lost`].
pub(crate) const ROW: f64 = 3.0;

/// What keeping a number within an interval costs.
pub(crate) const CLAMP: f64 = 2.0 * MINIMUM;

/// What a minimum or a maximum costs.
const MINIMUM: f64 = 1.3;

/// What a sign against that of another number costs.
pub(crate) const AGAINST: f64 = 1.3;

/// What the sign of another number costs, or one along it.
const ALONG: f64 = 1.7;

/// What a division costs beside a multiplication.
pub(crate) const QUOTIENT: f64 = 2.5;

/// What an operation costs in a program with a table, of which loops over arrays vectorise only where the machine
/// gathers. By measured times it is 1.6 to 2.2 without AVX2, 2.1 to 2.7 with its gathers, and 3.7 where a loop has none,
/// in `f64`; in `f32` twice the lanes are lost.
pub(crate) fn lanes_lost(float: Float) -> f64 {
    match float {
        Float::F64 => 2.2,
        Float::F32 => 4.4,
    }
}

/// Measured on x86-64, without and with AVX2, `f64` and `f32`, by `cargo run --release -p pendula-benches --bin
/// weights`, but for tables; docs/BENCHMARKS.md has the figures. The planner compares candidates by them, for which they have
/// to be about right only.
fn weight(op: Op) -> f64 {
    match op {
        Op::Input | Op::Constant { .. } | Op::Entry { .. } => 0.0,
        Op::Div(..) => QUOTIENT,
        Op::Root(_) => 36.0,
        Op::Min { .. } | Op::Max { .. } => MINIMUM,
        Op::Against { .. } => AGAINST,
        Op::CopySign { .. } | Op::Along { .. } => ALONG,
        Op::Select { .. } => 3.0,
        Op::Row { .. } => ROW,
        Op::Widen(_) | Op::Narrow(_) => 2.0,
        _ => 1.0,
    }
}
