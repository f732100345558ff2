//! 2 arcsin y where y, a curve in pieces, comes near 1: π − 4 arcsin √c with c = (1 − y)/2.
//!
//! What y is wrong by, half a unit of rounding of 1 at least, the arcsine multiplies by 2/√(1 − y²). The powers of a
//! piece make c itself, wrong by units of its own and of what it changes by in the piece; and that the arcsine multiplies by
//! no more than 2/√(c(1 − c)), of which the product with c is small where c is.
//!
//! Beyond the lowest point y is negative, and the arcsine that of the mirror image: with σ = −1 in those pieces, c =
//! (1 − σy)/2, and π and 4 change their signs. So both are numbers of the row.

use super::{POWERS, Pieces, rounding_of_row};
use crate::plan::arcsine::Arcsine;
use crate::plan::cosines::Cosines;
use crate::program::rounding::Known;
use crate::program::{Builder, Id, RESULT};
use crate::supremum::{by_halves, worst};
use pendulum_runtime::double::Double;

/// Twice the arcsine of a sum of harmonics, by its complement.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Complement {
    sine: Pieces,
    /// What the pieces of y are wrong by before they are rounded.
    truncation: f64,
    arcsine: Arcsine,
    /// −1 for the mirror image.
    direction: f64,
    /// The weights of y, which tell where it is.
    weights: Vec<Double>,
}

/// The name of c.
const REST: &str = "c";

/// How the remainder's range is divided for the analysis of the rounding, and how many parts of it are halved.
const CELLS: u32 = 4;
const MOST_HALVED: usize = 400;

impl Complement {
    /// Of y = Σ wₙ cos((2n−1)πs), |y| < 1, in pieces that are wrong by `truncation`.
    pub(crate) fn new(sine: Pieces, truncation: f64, weights: &[Double], direction: f64) -> Self {
        // Half a piece beyond the lowest point y is as far beyond 0.
        let reach = sine.reduction.half() * sine.reduction.unit.hi;
        let beyond = Cosines::odd(weights).over(0.5, 0.5 + reach).largest(0);
        let arcsine = Arcsine::of_complement(beyond, sine.reduction.float.rounding_unit() / 2.0);
        Self { sine, truncation, arcsine, direction, weights: weights.to_vec() }
    }

    pub(crate) fn count(&self) -> usize {
        self.sine.count()
    }

    pub(crate) fn terms(&self) -> usize {
        self.sine.terms()
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        let arcsine = self.arcsine.terms();
        format!(
            "that of what it is less than 1, by {}, and one of {arcsine} terms for the arcsine",
            self.sine.describe()
        )
    }

    /// Emits it, with a phase of its own.
    pub(crate) fn lower(&self, b: &mut Builder, name: &'static str) -> Id {
        let (c, signed, magic) = self.sine.looked_up(b, &self.rows());
        b.name(c, REST);
        let angle = self.arcsine.lower_of_complement(b, c, [signed[0], signed[1]]);
        b.name(angle, name);
        self.sine.alternate(b, angle, magic)
    }

    /// The powers of c, and π and 4 with their sign.
    fn rows(&self) -> Vec<Vec<Double>> {
        let last = self.sine.rows.len() / 2;
        let row = |(index, powers): (usize, &Vec<Double>)| {
            let sign = if index <= last { 1.0 } else { -1.0 };
            let rest = |(power, of_y): (usize, &Double)| {
                let one = if power == 0 { Double::ONE } else { Double::ZERO };
                (one - *of_y * sign) * 0.5
            };
            let signed = [Double::PI, Double::new(4.0)].map(|x| x * (sign * self.direction));
            powers.iter().enumerate().map(rest).chain(signed).collect()
        };
        self.sine.rows.iter().enumerate().map(row).collect()
    }

    /// Bounds the rounding over the whole range of the remainder, taken as exact, and what the pieces are wrong by.
    pub(crate) fn rounding(&self) -> f64 {
        let mut b = Builder::new(self.sine.reduction.float);
        let result = self.lower(&mut b, RESULT);
        let program = b.finish(vec![result]);
        let (before, after) = (program.up_to(REST), program.after_named(&[REST]));
        let (pieces, half, unit) = (self.sine.rows.len(), self.sine.reduction.half(), self.sine.reduction.unit.hi);
        let y = Cosines::odd(&self.weights);
        let rest_between = |index: usize, low: f64, high: f64| {
            let remainder = (POWERS[0], Known::between(low, high));
            let error = rounding_of_row(&before, &program.table[index], remainder) + 0.5 * self.truncation;
            let [from, to] = [low, high].map(|remainder| index as f64 / pieces as f64 + remainder * unit);
            let (least, most) = y.over(from, to).range(0);
            Known::within(0.5 * (1.0 - most) - error, 0.5 * (1.0 - least) + error, error)
        };
        // Where c can't be told from 0 its root is wrong by one of its error, however narrow the cell, and halving would
        // not end. So every cell has to tell it first; and a row of which one can't is bounded without that.
        let of_row = |index: usize| {
            let halved = |apart: bool| {
                by_halves([-half, half], CELLS, MOST_HALVED, |low, high| {
                    let c = rest_between(index, low, high);
                    let told = !apart || c.low > 0.0;
                    if told { rounding_of_row(&after, &program.table[index], (REST, c)) } else { f64::INFINITY }
                })
            };
            let apart = halved(true);
            if apart.is_finite() { apart } else { halved(false) }
        };
        // A row and its mirror image are rounded alike.
        worst((0..=pieces / 2).map(of_row))
    }
}
