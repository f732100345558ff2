//! A curve by one polynomial for each of many equal pieces of its period, of few terms, whose coefficients are looked up.
//!
//! Loops over arrays vectorise with it only where the machine gathers. But where one polynomial for all phases needs many
//! terms, near the top and for the paper's θ̂, it takes half of the operations or less, in one shallow chain, and the row
//! is known before the remainder is.

mod complement;
mod halves;
mod piecewise;

pub(crate) use complement::Complement;
pub(crate) use halves::Halves;
pub(crate) use piecewise::{Piecewise, half, phase};

use super::estrin::estrin;
use super::reduction::Reduction;
use super::turning::{Turning, Turns};
use super::variables::clamp;
use crate::program::rounding::Known;
use crate::program::{Builder, Id, Node, Op, Program, RESULT};
use crate::series::Parity;
use crate::supremum::worst;
use pendulum_runtime::double::Double;

/// The polynomials of all pieces from one anchor to the next.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Pieces {
    /// To the nearest piece.
    reduction: Reduction,
    /// Powers of the remainder, a row for each piece, of which the first is about an anchor.
    rows: Vec<Vec<Double>>,
    /// Of the curve, about an anchor.
    pub(crate) parity: Parity,
    /// Set where the sign changes from anchor to anchor.
    alternates: bool,
}

const POWERS: [&str; 5] = ["r", "r2", "r4", "r8", "r16"];

impl Pieces {
    /// Of a curve that is even or odd about an anchor, of which `half` has the powers in the pieces from there to the
    /// middle between two.
    fn new(reduction: Reduction, half: &[Vec<Double>], parity: Parity, alternates: bool) -> Self {
        let pieces = 2 * (half.len() - 1);
        // From the next anchor back: once reversed for the parity, and once if the curve alternates.
        let reversed = (parity == Parity::Odd) != alternates;
        let mirrored = |(power, c): (usize, &Double)| if (power % 2 == 1) == reversed { *c } else { -*c };
        let row = |piece: usize| match half.get(piece) {
            Some(row) => row.clone(),
            None => half[pieces - piece].iter().enumerate().map(mirrored).collect(),
        };
        Self { reduction, rows: (0..pieces).map(row).collect(), parity, alternates }
    }

    pub(crate) fn negate(&mut self) {
        self.rows.iter_mut().flatten().for_each(|c| *c = -*c);
    }

    /// Of the periodic part of a rotation's angle from the top that from the lowest point, or what turns to the middle of a
    /// piece leave of it. The rate of both is that of the whole.
    pub(crate) fn complete(&mut self, turning: &Turning) {
        let pieces = self.rows.len();
        let from_lowest = |piece: usize| Double::new(piece as f64 / pieces as f64 - 0.5);
        for (piece, row) in self.rows.iter_mut().enumerate() {
            row[1] = row[1] + turning.turn();
            if turning.turns != Turns::Counted {
                row[0] = row[0] + turning.of_turns(from_lowest(piece));
            }
        }
    }

    pub(crate) fn count(&self) -> usize {
        self.rows.len()
    }

    pub(crate) fn terms(&self) -> usize {
        self.rows[0].len()
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        let whole = if self.alternates { "half a period" } else { "a turn" };
        format!("{} polynomials of {} terms, one for each part of {whole}", self.rows.len(), self.terms())
    }

    /// Emits it, with a phase of its own that shares what it can with the others.
    pub(crate) fn lower(&self, b: &mut Builder, name: &'static str) -> Id {
        let (value, magic) = self.within_anchor(b, name);
        if self.alternates { self.alternate(b, value, magic) } else { value }
    }

    /// The value without the sign that anchors give, and the sum that counts pieces.
    fn within_anchor(&self, b: &mut Builder, name: &'static str) -> (Id, Id) {
        let (value, _, magic) = self.looked_up(b, &self.rows);
        (b.name(value, name), magic)
    }

    /// The polynomial by the first numbers of a piece's row, the others, and the sum that counts pieces.
    fn looked_up(&self, b: &mut Builder, rows: &[Vec<Double>]) -> (Id, Vec<Id>, Id) {
        let t = b.input();
        let phase = self.reduction.lower(b, t);
        let remainder = clamp(b, phase.remainder, self.reduction.half());
        b.name(remainder, POWERS[0]);
        let mut powers = b.look_up(rows, phase.magic);
        let others = powers.split_off(self.terms());
        (estrin(b, remainder, &powers, &POWERS), others, phase.magic)
    }

    /// With the other sign from anchor to anchor, which are passed once for all pieces.
    fn alternate(&self, b: &mut Builder, x: Id, magic: Id) -> Id {
        let bit = self.rows.len().ilog2();
        b.push(Op::Alternate { x, magic, bit })
    }

    /// Bounds the rounding over the whole range of the remainder, taken as exact.
    pub(crate) fn rounding(&self) -> f64 {
        let mut b = Builder::new(self.reduction.float);
        let result = self.lower(&mut b, RESULT);
        self.rounding_of(&b.finish(vec![result]))
    }

    /// The norm of what all rows of a program's table, whose pieces are these, are rounded by. A row and its mirror image
    /// are rounded alike.
    fn rounding_of(&self, program: &Program) -> f64 {
        let remainder = (POWERS[0], Known::between(-self.reduction.half(), self.reduction.half()));
        worst(program.table[..=program.table.len() / 2].iter().map(|row| rounding_of_row(program, row, remainder)))
    }
}

/// The norm of what a program's results are rounded by with the numbers of that row, given what is known of the node of
/// that name.
fn rounding_of_row(program: &Program, row: &[Double], (name, known): (&str, Known)) -> f64 {
    let number = |(id, node): (Id, &Node)| match node.op {
        Op::Entry { column, .. } => {
            let value = node.float.round(row[column].hi);
            Some((id, Known::within(value, value, (row[column] - Double::new(value)).hi.abs())))
        }
        _ => None,
    };
    let numbers = program.nodes.iter().enumerate().filter_map(number);
    let given: Vec<(Id, Known)> = numbers.chain(program.named(name).map(|id| (id, known))).collect();
    program.norm_of_rounding(&given)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Context;
    use crate::parse::Float;
    use crate::plan::reduction::Clock;
    use crate::testing::Random;
    use std::f64::consts::PI;

    /// cos πs of s = t/2 in 8 pieces from anchor to anchor, by Taylor's series.
    fn cosine(terms: u32, direction: f64) -> Pieces {
        let rate = Context::for_digits(40).ratio(1, 2);
        let clock = Clock { rate: &rate, launch: Double::ZERO, horizon: 200.0, float: Float::F64 };
        let in_pieces = |reduction: &Reduction| reduction.in_pieces(8);
        let reduction = clock.reductions().iter().find_map(in_pieces).unwrap();
        let derivative = |angle: f64, order: u32| {
            let (sine, cosine) = libm::sincos(angle);
            [cosine, -sine, -cosine, sine][order as usize % 4]
        };
        let power = |piece: u32, order: u32| {
            let vanishes = piece == 0 && order % 2 == 1 || piece == 4 && order.is_multiple_of(2);
            let factorial: f64 = (1..=order).map(f64::from).product();
            let c = derivative(f64::from(piece) * PI / 8.0, order) * PI.powi(order as i32) / factorial;
            Double::new(if vanishes { 0.0 } else { c })
        };
        let quarter: Vec<Vec<Double>> =
            (0..=4).map(|piece| (0..terms).map(|order| power(piece, order)).collect()).collect();
        let mut pieces = Pieces::new(reduction, &quarter, Parity::Even, true);
        if direction < 0.0 {
            pieces.negate();
        }
        pieces
    }

    fn run(pieces: &Pieces, s: f64) -> f64 {
        let mut b = Builder::new(Float::F64);
        let result = pieces.lower(&mut b, "result");
        b.finish(vec![result]).run(2.0 * s)[0]
    }

    #[test]
    fn a_cosine_in_pieces() {
        let (pieces, mirrored) = (cosine(12, 1.0), cosine(12, -1.0));
        let rounding = pieces.rounding();
        // Sums of numbers up to 1, and one beyond ½, whose roundings are a part of that.
        assert!((2e-16..4e-16).contains(&rounding), "{rounding:e}");
        let mut random = Random::new(5);
        let mut worst = 0.0_f64;
        for _ in 0..4000 {
            let t = 40.0 * random.unit() - 20.0;
            let value = run(&pieces, t);
            // (t − n)π is rounded once, where t and n are close.
            let exact = libm::cos((t - 2.0 * (t / 2.0).round()) * PI);
            worst = worst.max((value - exact).abs());
            assert_eq!(value.to_bits(), run(&pieces, -t).to_bits(), "{t}");
            assert_eq!(value.to_bits(), (-run(&mirrored, t)).to_bits(), "{t}");
        }
        assert!(worst <= rounding + 5e-16 && worst > rounding / 3.0, "{worst:e} {rounding:e}");
        // Half a period later all is reversed, from the lowest point on too.
        for t in [0.0, 0.03125, 0.0625, 0.109375, 0.4375, 0.5, 0.515625, 0.9375, 1.0] {
            assert_eq!(run(&pieces, t), -run(&pieces, t + 1.0), "{t}");
            assert_eq!(run(&pieces, 0.5 - t), -run(&pieces, 0.5 + t), "{t}");
        }
    }

    /// Beyond the horizon the remainder is anything, and held.
    #[test]
    fn any_time_is_one_of_the_motion() {
        let pieces = cosine(12, 1.0);
        for t in [1e9, 1e15, -1e17, 1.5e200, -f64::MAX / 2.0] {
            assert!(run(&pieces, t).abs() <= 1.0 + 1e-12, "{t}");
        }
        assert!([f64::NAN, f64::INFINITY, f64::NEG_INFINITY].iter().all(|&t| run(&pieces, t).is_nan()));
    }

    /// With few terms the truncation shows, and the rounding is what it was.
    #[test]
    fn few_terms() {
        let pieces = cosine(4, 1.0);
        assert_eq!((pieces.terms(), pieces.rows.len()), (4, 8));
        let error = (run(&pieces, 0.0624) - libm::cos(0.0624 * PI)).abs();
        assert!((error - (0.0624 * PI).powi(4) / 24.0).abs() < 1e-7, "{error:e}");
    }
}
