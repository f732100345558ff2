//! What a program costs.

use super::{Op, Program};

impl Program {
    /// The number of operations (constants and the input are free).
    pub(crate) fn operations(&self) -> usize {
        self.nodes.iter().filter(|node| !matches!(node.op, Op::Input | Op::Constant { .. })).count()
    }

    /// Relative cost in an array loop, one addition or multiplication being 1.
    pub(crate) fn cost(&self) -> f64 {
        self.nodes.iter().map(|node| weight(node.op)).sum()
    }
}

fn weight(op: Op) -> f64 {
    match op {
        Op::Input | Op::Constant { .. } => 0.0,
        Op::Div(..) => 5.0,
        // Two steps of ten operations, the seed and the product.
        Op::Root(_) => 24.0,
        Op::Alternate { .. } | Op::Against { .. } | Op::PowerOfTwo { .. } | Op::Select { .. } => 2.0,
        Op::Widen(_) | Op::Narrow(_) => 1.5,
        _ => 1.0,
    }
}
