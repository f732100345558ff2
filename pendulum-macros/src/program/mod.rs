//! Straight-line programs: what a plan computes, one operation a node.
//!
//! The same value is interpreted to check it, analysed for rounding, counted for its cost and printed as Rust. All of
//! them therefore speak of the very same operations in the very same order.

mod builder;
pub(crate) mod cost;
mod float;
pub(crate) mod interpret;
pub(crate) mod rounding;

use crate::parse::Float;
pub(crate) use builder::Builder;
use pendulum_runtime::double::Double;

/// A node's index; operands precede their users.
pub(crate) type Id = usize;

/// One IEEE operation, a manipulation of a number's bits, or what is emitted as one: a square root, a row of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Op {
    /// The time.
    Input,
    /// A constant: the number of the program's float, and how far the exact constant is from it.
    Constant {
        value: f64,
        rest: f64,
    },
    Add(Id, Id),
    Sub(Id, Id),
    Mul(Id, Id),
    Div(Id, Id),
    /// √x by arithmetic, for x > 0: `pendulum_runtime::support::root`.
    Root(Id),
    Abs(Id),
    /// `if limit < x { limit } else { x }`: NaN passes.
    Min {
        limit: Id,
        x: Id,
    },
    /// `if x < limit { limit } else { x }`: NaN passes.
    Max {
        limit: Id,
        x: Id,
    },
    /// `if a < b { then } else { otherwise }`.
    Select {
        a: Id,
        b: Id,
        then: Id,
        otherwise: Id,
    },
    /// x without its 26 lowest bits (`f64` only).
    Head(Id),
    /// x with its sign flipped where this bit is set of the integer in `magic` (a sum with [`Float::magic`] or a part of
    /// it).
    Alternate {
        x: Id,
        magic: Id,
        bit: u32,
    },
    /// A number's magnitude with the sign of another.
    CopySign {
        magnitude: Id,
        sign: Id,
    },
    /// x with its sign flipped where `sign` is negative.
    Along {
        x: Id,
        sign: Id,
    },
    /// x with its sign flipped where `sign` is positive.
    Against {
        x: Id,
        sign: Id,
    },
    /// 2 to the integer in `magic` (a sum with [`Float::magic`]); `f64` only.
    PowerOfTwo {
        magic: Id,
    },
    /// The row of the program's table that the integer in `magic` (a sum with [`Float::magic`] or a part of it) names,
    /// modulo the number of rows.
    Row {
        magic: Id,
    },
    /// A number of that row.
    Entry {
        row: Id,
        column: usize,
    },
    /// `f32` to `f64`.
    Widen(Id),
    /// `f64` to `f32`.
    Narrow(Id),
}

/// An operation, the type of its result, and the name it has in the emitted code (unnamed ones used once are inlined).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Node {
    pub(crate) op: Op,
    pub(crate) float: Float,
    pub(crate) name: Option<&'static str>,
}

/// The name of a single result, before it takes the sign of the phase if it does last.
pub(crate) const RESULT: &str = "result";

/// A function of the time with one or more results.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Program {
    pub(crate) nodes: Vec<Node>,
    pub(crate) results: Vec<Id>,
    /// Constants that the time chooses among; their number of rows is a power of two, or none.
    pub(crate) table: Vec<Vec<Double>>,
}

impl Op {
    /// The same of other nodes.
    fn map(self, mut to: impl FnMut(Id) -> Id) -> Self {
        match self {
            Self::Input | Self::Constant { .. } => self,
            Self::Add(a, b) => Self::Add(to(a), to(b)),
            Self::Sub(a, b) => Self::Sub(to(a), to(b)),
            Self::Mul(a, b) => Self::Mul(to(a), to(b)),
            Self::Div(a, b) => Self::Div(to(a), to(b)),
            Self::Root(x) => Self::Root(to(x)),
            Self::Abs(x) => Self::Abs(to(x)),
            Self::Head(x) => Self::Head(to(x)),
            Self::Widen(x) => Self::Widen(to(x)),
            Self::Narrow(x) => Self::Narrow(to(x)),
            Self::Min { limit, x } => Self::Min { limit: to(limit), x: to(x) },
            Self::Max { limit, x } => Self::Max { limit: to(limit), x: to(x) },
            Self::Select { a, b, then, otherwise } => {
                Self::Select { a: to(a), b: to(b), then: to(then), otherwise: to(otherwise) }
            }
            Self::Alternate { x, magic, bit } => Self::Alternate { x: to(x), magic: to(magic), bit },
            Self::CopySign { magnitude, sign } => Self::CopySign { magnitude: to(magnitude), sign: to(sign) },
            Self::Along { x, sign } => Self::Along { x: to(x), sign: to(sign) },
            Self::Against { x, sign } => Self::Against { x: to(x), sign: to(sign) },
            Self::PowerOfTwo { magic } => Self::PowerOfTwo { magic: to(magic) },
            Self::Row { magic } => Self::Row { magic: to(magic) },
            Self::Entry { row, column } => Self::Entry { row: to(row), column },
        }
    }

    /// The nodes it reads, one after the other.
    pub(crate) fn each_operand(self, mut read: impl FnMut(Id)) {
        self.map(|id| {
            read(id);
            id
        });
    }
}

impl Program {
    /// What is left of it where these nodes are given.
    pub(crate) fn after(&self, given: &[Id]) -> Self {
        let mut program = self.clone();
        for &id in given {
            program.nodes[id].op = Op::Input;
        }
        program.pruned()
    }

    /// The same of the nodes of these names, as far as it has them.
    pub(crate) fn after_named(&self, names: &[&str]) -> Self {
        let given: Vec<Id> = names.iter().filter_map(|name| self.named(name)).collect();
        self.after(&given)
    }

    /// What it computes up to the node of this name, if it has one, which is its result.
    pub(crate) fn up_to(&self, name: &str) -> Self {
        Self { results: self.named(name).into_iter().collect(), ..self.clone() }.pruned()
    }

    fn pruned(self) -> Self {
        let mut needed = vec![false; self.nodes.len()];
        for &result in &self.results {
            needed[result] = true;
        }
        for id in (0..self.nodes.len()).rev() {
            if needed[id] {
                self.nodes[id].op.each_operand(|operand| needed[operand] = true);
            }
        }
        let mut renamed = vec![Id::MAX; self.nodes.len()];
        let mut nodes = Vec::with_capacity(self.nodes.len());
        for (id, node) in self.nodes.iter().enumerate() {
            if needed[id] {
                renamed[id] = nodes.len();
                nodes.push(Node { op: node.op.map(|id| renamed[id]), ..*node });
            }
        }
        let looks_up = nodes.iter().any(|node: &Node| matches!(node.op, Op::Row { .. }));
        let table = if looks_up { self.table } else { Vec::new() };
        Self { nodes, results: self.results.iter().map(|&id| renamed[id]).collect(), table }
    }

    /// Whether all its constants are numbers, and what they are rounded by is.
    pub(crate) fn is_finite(&self) -> bool {
        let constants = self.nodes.iter().all(|node| match node.op {
            Op::Constant { value, rest } => value.is_finite() && rest.is_finite(),
            _ => true,
        });
        constants && self.table.iter().flatten().all(|entry| entry.hi.is_finite() && entry.lo.is_finite())
    }

    /// The node of this name, if the program has one: of the names that analyses ask for, one at most.
    pub(crate) fn named(&self, name: &str) -> Option<Id> {
        let all = || self.nodes.iter().filter(|node| node.name == Some(name));
        assert!(cfg!(not(test)) || all().count() <= 1, "several nodes are called {name}");
        self.nodes.iter().position(|node| node.name == Some(name))
    }
}

#[cfg(test)]
mod tests;
