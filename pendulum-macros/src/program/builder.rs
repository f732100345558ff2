//! Writing a program.

use super::{Id, Node, Op, Program};
use crate::parse::Float;
use pendulum_runtime::double::Double;

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
    pub(crate) fn rounded(&mut self, value: Double) -> Id {
        self.push(Op::Constant { value: self.float.round(value.hi), rest: self.float.rest(value) })
    }

    /// The same of a number in one word.
    pub(crate) fn constant(&mut self, value: f64) -> Id {
        self.rounded(Double::new(value))
    }

    /// A number that stands for something within `slack` of it.
    pub(crate) fn loose(&mut self, value: f64, slack: f64) -> Id {
        let rounded = self.float.round(value);
        self.push(Op::Constant { value: rounded, rest: (value - rounded).abs() + slack })
    }

    /// x + offset, if there is any.
    pub(crate) fn offset(&mut self, x: Id, offset: Double) -> Id {
        if offset == Double::ZERO {
            return x;
        }
        let offset = self.rounded(offset);
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

    /// The product, which with 1 is no operation.
    pub(crate) fn mul(&mut self, a: Id, b: Id) -> Id {
        match [a, b].map(|id| self.nodes[id].op == Op::Constant { value: 1.0, rest: 0.0 }) {
            [true, _] => b,
            [_, true] => a,
            _ => self.push(Op::Mul(a, b)),
        }
    }

    /// Gives `id` a name in the emitted code.
    pub(crate) fn name(&mut self, id: Id, name: &'static str) -> Id {
        self.nodes[id].name = Some(name);
        id
    }

    /// Appends `op`; an operation that is there already is shared.
    pub(crate) fn push(&mut self, op: Op) -> Id {
        // It follows its operands. By index, since unoptimised iterators would take the planner twice as long.
        let mut id = 0;
        op.each_operand(|operand| id = id.max(operand + 1));
        while let Some(node) = self.nodes.get(id) {
            if node.float == self.float && node.op == op {
                return id;
            }
            id += 1;
        }
        self.nodes.push(Node { op, float: self.float, name: None });
        self.nodes.len() - 1
    }

    /// Converts `x` to `float`, in which the program continues.
    pub(crate) fn convert(&mut self, x: Id, float: Float) -> Id {
        self.float = float;
        match self.nodes[x].op {
            _ if self.nodes[x].float == float => return x,
            // It was of that type.
            Op::Widen(narrow) => return narrow,
            _ => {}
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

    /// The numbers of that one of `rows` which the integer in `magic` names, a power of two of them. Rows for the
    /// same integer, of which there are always as many, are joined.
    pub(crate) fn look_up(&mut self, rows: &[Vec<Double>], magic: Id) -> Vec<Id> {
        assert!(rows.len().is_power_of_two() && [0, rows.len()].contains(&self.table.len()), "as many rows");
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
