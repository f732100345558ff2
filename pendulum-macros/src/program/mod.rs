//! Straight-line programs: what a plan computes, one operation a node.
//!
//! The same value is interpreted to check it, analysed for rounding, counted for its cost and printed as Rust. All of
//! them therefore speak of the very same operations in the very same order.

pub(crate) mod cost;
pub(crate) mod interpret;
pub(crate) mod rounding;

use crate::parse::Float;
use pendulum_runtime::double::Double;

/// A node's index; operands precede their users.
pub(crate) type Id = usize;

/// One IEEE operation, or a manipulation of a number's bits.
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

/// An operation, the type of its result, and the name it has in the emitted code (unnamed ones are inlined).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Node {
    pub(crate) op: Op,
    pub(crate) float: Float,
    pub(crate) name: Option<&'static str>,
}

/// A function of the time with one or more results.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Program {
    pub(crate) nodes: Vec<Node>,
    pub(crate) results: Vec<Id>,
    /// Constants that the time chooses among; their number of rows is a power of two, or none.
    pub(crate) table: Vec<Vec<Double>>,
}

impl Float {
    /// Adding this number rounds to an integer, held in the low bits of the sum: 1.5·2⁵² or 1.5·2²³, for magnitudes
    /// below a third of it.
    pub(crate) const fn magic(self) -> f64 {
        match self {
            Self::F64 => 6_755_399_441_055_744.0,
            Self::F32 => 12_582_912.0,
        }
    }

    /// Half the distance from 1 to the next number.
    pub(crate) const fn unit(self) -> f64 {
        match self {
            Self::F64 => f64::EPSILON / 2.0,
            Self::F32 => f32::EPSILON as f64 / 2.0,
        }
    }

    /// Significant bits.
    pub(crate) const fn bits(self) -> i32 {
        match self {
            Self::F64 => 53,
            Self::F32 => 24,
        }
    }

    /// x rounded to this type.
    pub(crate) fn round(self, x: f64) -> f64 {
        match self {
            Self::F64 => x,
            Self::F32 => f64::from(x as f32),
        }
    }
}

impl Op {
    /// The nodes it reads.
    pub(crate) fn operands(self) -> Vec<Id> {
        match self {
            Self::Input | Self::Constant { .. } => vec![],
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => vec![a, b],
            Self::Root(x) | Self::Abs(x) | Self::Head(x) | Self::Widen(x) | Self::Narrow(x) => vec![x],
            Self::Min { limit, x } | Self::Max { limit, x } => vec![limit, x],
            Self::Select { a, b, then, otherwise } => vec![a, b, then, otherwise],
            Self::Alternate { x, magic, .. } => vec![x, magic],
            Self::Against { x, sign } => vec![x, sign],
            Self::PowerOfTwo { magic } | Self::Row { magic } => vec![magic],
            Self::Entry { row, .. } => vec![row],
        }
    }
}

/// Writes a program node by node.
#[derive(Clone, Debug)]
pub(crate) struct Builder {
    nodes: Vec<Node>,
    /// The type of the nodes to come.
    float: Float,
    table: Vec<Vec<Double>>,
}

impl Builder {
    /// A program whose time, and results, are of type `float`.
    pub(crate) fn new(float: Float) -> Self {
        Self { nodes: Vec::new(), float, table: Vec::new() }
    }

    pub(crate) fn float(&self) -> Float {
        self.float
    }

    /// The time, node 0.
    pub(crate) fn input(&mut self) -> Id {
        let t = self.push(Op::Input);
        self.name(t, "t")
    }

    /// The number of the float nearest to `value`, whose distance from it is kept.
    pub(crate) fn exact(&mut self, value: Double) -> Id {
        let rounded = self.float.round(value.hi);
        self.push(Op::Constant { value: rounded, rest: (value.hi - rounded) + value.lo })
    }

    /// A number that stands for something within `slack` of it.
    pub(crate) fn loose(&mut self, value: f64, slack: f64) -> Id {
        let rounded = self.float.round(value);
        self.push(Op::Constant { value: rounded, rest: (value - rounded).abs() + slack })
    }

    /// A number that is exact as it stands.
    pub(crate) fn constant(&mut self, value: f64) -> Id {
        self.exact(Double::new(value))
    }

    /// x + offset, if there is any.
    pub(crate) fn offset(&mut self, x: Id, offset: Double) -> Id {
        if offset == Double::ZERO {
            return x;
        }
        let offset = self.exact(offset);
        self.add(x, offset)
    }

    pub(crate) fn add(&mut self, a: Id, b: Id) -> Id {
        self.push(Op::Add(a, b))
    }

    pub(crate) fn sub(&mut self, a: Id, b: Id) -> Id {
        self.push(Op::Sub(a, b))
    }

    pub(crate) fn div(&mut self, a: Id, b: Id) -> Id {
        self.push(Op::Div(a, b))
    }

    pub(crate) fn mul(&mut self, a: Id, b: Id) -> Id {
        self.push(Op::Mul(a, b))
    }

    /// Gives `id` a name in the emitted code.
    pub(crate) fn name(&mut self, id: Id, name: &'static str) -> Id {
        self.nodes[id].name = Some(name);
        id
    }

    /// Appends `op`; an operation that is there already is shared.
    pub(crate) fn push(&mut self, op: Op) -> Id {
        if let Some(id) = self.nodes.iter().position(|node| node.op == op && node.float == self.float) {
            return id;
        }
        self.nodes.push(Node { op, float: self.float, name: None });
        self.nodes.len() - 1
    }

    /// Converts `x` to `float`, in which the program continues.
    pub(crate) fn convert(&mut self, x: Id, float: Float) -> Id {
        self.float = float;
        if self.nodes[x].float == float {
            return x;
        }
        self.push(if float == Float::F64 { Op::Widen(x) } else { Op::Narrow(x) })
    }

    /// `a + b` and what its rounding left (Knuth).
    pub(crate) fn two_sum(&mut self, a: Id, b: Id) -> (Id, Id) {
        let sum = self.add(a, b);
        let seen = self.sub(sum, a);
        let from_a = self.sub(sum, seen);
        let (lost_a, lost_b) = (self.sub(a, from_a), self.sub(b, seen));
        (sum, self.add(lost_a, lost_b))
    }

    /// The numbers of that one of `rows` which the integer in `magic` names. Rows for the same integer, of which there
    /// are always as many, are joined.
    pub(crate) fn look_up(&mut self, rows: &[Vec<Double>], magic: Id) -> Vec<Id> {
        self.table.resize(rows.len(), Vec::new());
        let columns = |row: Option<&Vec<Double>>| row.map_or(0, Vec::len);
        let (first, count) = (columns(self.table.first()), columns(rows.first()));
        self.table.iter_mut().zip(rows).for_each(|(row, more)| row.extend(more));
        let row = self.push(Op::Row { magic });
        self.name(row, "row");
        (first..first + count).map(|column| self.push(Op::Entry { row, column })).collect()
    }

    /// The finished program, without the nodes that no result needs.
    pub(crate) fn finish(self, results: Vec<Id>) -> Program {
        Program { nodes: self.nodes, results, table: self.table }.pruned()
    }
}

impl Program {
    fn pruned(self) -> Self {
        let mut needed = vec![false; self.nodes.len()];
        for &result in &self.results {
            needed[result] = true;
        }
        for id in (0..self.nodes.len()).rev() {
            if needed[id] {
                self.nodes[id].op.operands().into_iter().for_each(|operand| needed[operand] = true);
            }
        }
        let mut renamed = vec![Id::MAX; self.nodes.len()];
        let mut nodes = Vec::new();
        for (id, node) in self.nodes.into_iter().enumerate().filter(|(id, _)| needed[*id]) {
            renamed[id] = nodes.len();
            nodes.push(Node { op: node.op.renamed(&renamed), ..node });
        }
        let looks_up = nodes.iter().any(|node: &Node| matches!(node.op, Op::Row { .. }));
        let table = if looks_up { self.table } else { Vec::new() };
        Self { nodes, results: self.results.iter().map(|&id| renamed[id]).collect(), table }
    }

    /// The node of this name, if the program has one.
    pub(crate) fn named(&self, name: &str) -> Option<Id> {
        self.nodes.iter().position(|node| node.name == Some(name))
    }
}

impl Op {
    fn renamed(self, to: &[Id]) -> Self {
        match self {
            Self::Input | Self::Constant { .. } => self,
            Self::Add(a, b) => Self::Add(to[a], to[b]),
            Self::Sub(a, b) => Self::Sub(to[a], to[b]),
            Self::Mul(a, b) => Self::Mul(to[a], to[b]),
            Self::Div(a, b) => Self::Div(to[a], to[b]),
            Self::Root(x) => Self::Root(to[x]),
            Self::Abs(x) => Self::Abs(to[x]),
            Self::Head(x) => Self::Head(to[x]),
            Self::Widen(x) => Self::Widen(to[x]),
            Self::Narrow(x) => Self::Narrow(to[x]),
            Self::Min { limit, x } => Self::Min { limit: to[limit], x: to[x] },
            Self::Max { limit, x } => Self::Max { limit: to[limit], x: to[x] },
            Self::Select { a, b, then, otherwise } => {
                Self::Select { a: to[a], b: to[b], then: to[then], otherwise: to[otherwise] }
            }
            Self::Alternate { x, magic, bit } => Self::Alternate { x: to[x], magic: to[magic], bit },
            Self::Against { x, sign } => Self::Against { x: to[x], sign: to[sign] },
            Self::PowerOfTwo { magic } => Self::PowerOfTwo { magic: to[magic] },
            Self::Row { magic } => Self::Row { magic: to[magic] },
            Self::Entry { row, column } => Self::Entry { row: to[row], column },
        }
    }
}

#[cfg(test)]
mod tests;
