//! Runs a program: the same bits as the emitted code.

use super::{Id, Op, Program};
use crate::parse::Float;
use pendulum_runtime::support;

impl Program {
    /// The results at time `t`, which has to be a number of the program's type.
    pub(crate) fn run(&self, t: f64) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            // An `f32` sum, difference, product or quotient rounded from its `f64` counterpart is the correctly
            // rounded one, since 53 ≥ 2·24 + 2 (Figueroa 1995).
            let value = node.float.round(self.apply(node.op, t, &values));
            values.push(value);
        }
        self.results.iter().map(|&id| values[id]).collect()
    }

    fn apply(&self, op: Op, t: f64, v: &[f64]) -> f64 {
        let choose = |a: Id, b: Id, then: Id, otherwise: Id| if v[a] < v[b] { v[then] } else { v[otherwise] };
        let flip = |x: Id, flips: bool| if flips { -v[x] } else { v[x] };
        match op {
            Op::Input => t,
            Op::Constant { value, .. } => value,
            Op::Add(a, b) => v[a] + v[b],
            Op::Sub(a, b) => v[a] - v[b],
            Op::Mul(a, b) => v[a] * v[b],
            Op::Div(a, b) => v[a] / v[b],
            Op::Root(x) => self.root(x, v[x]),
            Op::Abs(x) => v[x].abs(),
            Op::Min { limit, x } => choose(limit, x, limit, x),
            Op::Max { limit, x } => choose(x, limit, limit, x),
            Op::Select { a, b, then, otherwise } => choose(a, b, then, otherwise),
            Op::Head(x) => f64::from_bits(v[x].to_bits() & HEAD_MASK),
            Op::Alternate { x, magic, bit } => flip(x, self.integer_bits(magic, v) >> bit & 1 == 1),
            Op::CopySign { magnitude, sign } => v[magnitude].copysign(v[sign]),
            Op::Along { x, sign } => flip(x, v[sign].is_sign_negative()),
            Op::Against { x, sign } => flip(x, v[sign].is_sign_positive()),
            Op::PowerOfTwo { magic } => f64::from_bits(self.integer_bits(magic, v).wrapping_add(1023) << 52),
            Op::Row { magic } => (self.integer_bits(magic, v) % self.table.len() as u64) as f64,
            Op::Entry { row, column } => self.table[v[row] as usize][column].hi,
            Op::Widen(x) | Op::Narrow(x) => v[x],
        }
    }

    /// What the emitted code calls for a root.
    fn root(&self, x: Id, value: f64) -> f64 {
        match self.nodes[x].float {
            Float::F64 => support::root(value),
            Float::F32 => f64::from(support::rootf(value as f32)),
        }
    }

    /// The bits of a magic sum, whose low ones are the integer's.
    fn integer_bits(&self, magic: Id, v: &[f64]) -> u64 {
        match self.nodes[magic].float {
            Float::F64 => v[magic].to_bits(),
            Float::F32 => u64::from((v[magic] as f32).to_bits()),
        }
    }
}

/// Keeps sign, exponent and the 26 highest bits of the fraction.
pub(crate) const HEAD_MASK: u64 = !((1 << 26) - 1);
