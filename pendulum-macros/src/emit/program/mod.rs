//! [`Program`] → the statements of a function's body.

mod bits;

use super::literal;
use crate::parse::Float;
use crate::program::{Id, Node, Op, Program};
use pendulum_runtime::double::Double;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

/// `let`s and the result: a value, or a tuple of several.
pub(super) fn body(program: &Program, support: &TokenStream) -> TokenStream {
    let mut writer = Writer { program, support, bound: names(program) };
    let statements: Vec<TokenStream> = (0..program.nodes.len()).filter_map(|id| writer.statement(id)).collect();
    let table = table(program);
    let results: Vec<TokenStream> = program.results.iter().map(|&id| writer.value(id)).collect();
    if let [result] = results.as_slice() {
        quote!(#table #(#statements)* #result)
    } else {
        quote!(#table #(#statements)* (#(#results),*))
    }
}

/// The table, if there is one: a static, of which there is one, where of a constant each codegen unit would keep its own.
fn table(program: &Program) -> Option<TokenStream> {
    let entry = program.nodes.iter().find(|node| matches!(node.op, Op::Entry { .. }))?;
    let float = entry.float;
    let columns = Literal::usize_unsuffixed(program.table.first()?.len());
    let rows = Literal::usize_unsuffixed(program.table.len());
    let row = |row: &Vec<Double>| {
        let numbers = row.iter().map(|number| literal::float(float.round(number.hi), float));
        quote!([#(#numbers),*])
    };
    let table = program.table.iter().map(row);
    let doc = format!(
        " A row for each of {rows} parts of the way from one turning point (top) to the next, the first part about it: coefficients of powers of the phase from the part's middle, and what else depends on the part."
    );
    Some(quote!(#[doc = #doc] static TABLE: [[#float; #columns]; #rows] = [#(#table),*];))
}

/// The variable that each node is bound to; `None` if it's written where it is used, or is what is returned.
fn names(program: &Program) -> Vec<Option<Ident>> {
    let mut uses = vec![0; program.nodes.len()];
    for node in &program.nodes {
        let twice = matches!(node.op, Op::Min { .. } | Op::Max { .. });
        node.op.each_operand(|operand| uses[operand] += if twice { 2 } else { 1 });
    }
    let mut taken: Vec<String> = Vec::new();
    let mut unique = |wanted: &str| {
        let name = (1..).map(|i| if i == 1 { wanted.to_owned() } else { format!("{wanted}_{i}") });
        let name = name.into_iter().find(|name| !taken.contains(name)).unwrap_or_default();
        taken.push(name.clone());
        Ident::new(&name, Span::call_site())
    };
    program
        .nodes
        .iter()
        .zip(uses)
        .enumerate()
        .map(|(id, (node, uses))| match (node.op, node.name) {
            (Op::Constant { .. }, _) => None,
            _ if uses == 0 && program.results == [id] => None,
            (_, Some(name)) => Some(unique(name)),
            (_, None) if uses > 1 => Some(unique("v")),
            _ => None,
        })
        .collect()
}

struct Writer<'a> {
    program: &'a Program,
    support: &'a TokenStream,
    bound: Vec<Option<Ident>>,
}

/// How tightly an expression's outermost operator binds.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Sum,
    Product,
    Cast,
    Atom,
}

impl Writer<'_> {
    fn statement(&mut self, id: Id) -> Option<TokenStream> {
        let node = &self.program.nodes[id];
        let name = self.bound[id].clone()?;
        if node.op == Op::Input {
            return None;
        }
        let (value, _) = self.expression(node);
        Some(quote!(let #name = #value;))
    }

    /// A node as an operand: its variable, or its expression in parentheses where `at_least` asks for them.
    fn operand(&self, id: Id, at_least: Binding) -> TokenStream {
        if let Some(name) = &self.bound[id] {
            return quote!(#name);
        }
        let (value, binding) = self.expression(&self.program.nodes[id]);
        if binding < at_least { quote!((#value)) } else { value }
    }

    fn value(&self, id: Id) -> TokenStream {
        self.operand(id, Binding::Sum)
    }

    /// As [`Self::operand`], for a method call: a bare literal has no type to call methods of.
    fn atom(&self, id: Id) -> TokenStream {
        let node = &self.program.nodes[id];
        match node.op {
            Op::Constant { value, .. } => literal::typed(value, node.float),
            _ => self.operand(id, Binding::Atom),
        }
    }

    fn expression(&self, node: &Node) -> (TokenStream, Binding) {
        use Binding::{Atom, Cast, Product, Sum};
        let infix = |a, b, operator: TokenStream, binding, right| {
            let (a, b) = (self.operand(a, binding), self.operand(b, right));
            (quote!(#a #operator #b), binding)
        };
        match node.op {
            Op::Input => (quote!(t), Atom),
            Op::Constant { value, .. } => (literal::float(value, node.float), Atom),
            // a + (−c)·x and a − c·x are the same number.
            Op::Add(a, b) if self.is_negative(b) => self.negated(a, b, &quote!(-)),
            Op::Sub(a, b) if self.is_negative(b) => self.negated(a, b, &quote!(+)),
            Op::Add(a, b) => infix(a, b, quote!(+), Sum, Product),
            Op::Sub(a, b) => infix(a, b, quote!(-), Sum, Product),
            Op::Mul(a, b) => infix(a, b, quote!(*), Product, Cast),
            Op::Div(a, b) => infix(a, b, quote!(/), Product, Cast),
            Op::Widen(x) | Op::Narrow(x) => (self.cast(x, node.float), Cast),
            Op::Root(x) => (self.root(x, node.float), Atom),
            Op::Abs(x) => (self.abs(x), Atom),
            Op::Min { limit, x } => (self.min(limit, x), Atom),
            Op::Max { limit, x } => (self.max(limit, x), Atom),
            Op::Select { a, b, then, otherwise } => (self.select([a, b], then, otherwise), Atom),
            Op::Head(x) => (self.head(x), Atom),
            Op::Alternate { x, magic, bit } => (self.alternate(x, magic, bit), Atom),
            Op::CopySign { magnitude, sign } => (self.copy_sign(magnitude, sign), Atom),
            Op::Along { x, sign } => (self.along(x, sign), Atom),
            Op::Against { x, sign } => (self.against(x, sign), Atom),
            Op::PowerOfTwo { magic } => (self.power_of_two(magic), Atom),
            Op::Row { magic } => (self.row(magic), Atom),
            Op::Entry { row, column } => (self.entry(row, column), Atom),
        }
    }

    /// Whether a node is a negative constant, or an inlined product that begins with one.
    fn is_negative(&self, id: Id) -> bool {
        match self.program.nodes[id].op {
            Op::Constant { value, .. } => value.is_sign_negative(),
            Op::Mul(a, _) => self.bound[id].is_none() && self.is_negative(a),
            _ => false,
        }
    }

    /// a ∓ (−b), b being negative in the sense of [`Self::is_negative`].
    fn negated(&self, a: Id, b: Id, operator: &TokenStream) -> (TokenStream, Binding) {
        let left = self.operand(a, Binding::Sum);
        let right = self.without_sign(b);
        (quote!(#left #operator #right), Binding::Sum)
    }

    fn without_sign(&self, id: Id) -> TokenStream {
        let node = &self.program.nodes[id];
        match node.op {
            Op::Constant { value, .. } => literal::float(-value, node.float),
            Op::Mul(a, b) => {
                let (a, b) = (self.without_sign(a), self.operand(b, Binding::Atom));
                quote!(#a * #b)
            }
            _ => self.operand(id, Binding::Product),
        }
    }

    fn cast(&self, x: Id, float: Float) -> TokenStream {
        let x = self.atom(x);
        quote!(#x as #float)
    }

    fn root(&self, x: Id, float: Float) -> TokenStream {
        let (support, x) = (self.support, self.value(x));
        match float {
            Float::F64 => quote!(#support::root(#x)),
            Float::F32 => quote!(#support::rootf(#x)),
        }
    }

    fn abs(&self, x: Id) -> TokenStream {
        let x = self.atom(x);
        quote!(#x.abs())
    }

    fn min(&self, limit: Id, x: Id) -> TokenStream {
        // A cast before `<` would read as the start of a generic type.
        let (limit, x) = (self.atom(limit), self.value(x));
        quote!(if #limit < #x { #limit } else { #x })
    }

    fn max(&self, limit: Id, x: Id) -> TokenStream {
        let (limit, x) = (self.value(limit), self.atom(x));
        quote!(if #x < #limit { #limit } else { #x })
    }

    fn select(&self, [a, b]: [Id; 2], then: Id, otherwise: Id) -> TokenStream {
        let a = self.atom(a);
        let [b, then, otherwise] = [b, then, otherwise].map(|id| self.value(id));
        quote!(if #a < #b { #then } else { #otherwise })
    }

    fn entry(&self, row: Id, column: usize) -> TokenStream {
        let (row, column) = (self.atom(row), Literal::usize_unsuffixed(column));
        quote!(#row[#column])
    }
}
