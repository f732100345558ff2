//! Which shift makes the roots of the odd parts real, and with how much rounding: estimates, which proofs follow.

use super::Block;
use super::roots::{factored, roots};
use crate::power::power;
use crate::supremum::largest;
use pendulum_runtime::double::Double;

/// A shift that makes all roots real, and what rounding does to the value with it, in units of rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shift {
    pub(crate) by: f64,
    pub(crate) rounding: f64,
}

/// The shifts to choose from: the best, and none, which saves an operation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shifts {
    pub(super) best: Shift,
    unshifted: Option<Shift>,
}

impl Shifts {
    /// The shifts tried, in 32nds: the square of the phase goes from 0 to ¼.
    const TRIED: std::ops::RangeInclusive<i32> = -26..=16;

    /// More terms than a polynomial has that adapted blocks serve: longer ones are of curves that bend too much.
    const MOST_TERMS: usize = 48;

    /// For `powers` of p between 0 and ¼, lowest first.
    pub(crate) fn new(powers: &[Double], chunk: usize) -> Option<Self> {
        if powers.len() > Self::MOST_TERMS {
            return None;
        }
        let rough: Vec<f64> = powers.iter().map(|c| c.hi).collect();
        let shift = |step: i32, most: f64| {
            let by = f64::from(step) / 32.0;
            Some(Shift { by, rounding: rounding(&rough, by, chunk, most)? })
        };
        let better =
            |best: Option<Shift>, step: i32| shift(step, best.map_or(f64::INFINITY, |best| best.rounding)).or(best);
        Some(Self { best: Self::TRIED.fold(None, better)?, unshifted: shift(0, f64::INFINITY) })
    }

    /// The cheapest whose rounding, in units of rounding, is below `limit`. Without a shift it has to be far below:
    /// what rounding takes, truncation lacks.
    pub(crate) fn within(self, limit: f64) -> Option<Shift> {
        let far_below = |shift: &Shift| shift.rounding <= limit / 16.0;
        self.unshifted.filter(far_below).or(Some(self.best)).filter(|shift| shift.rounding <= limit)
    }
}

/// Estimates the rounding of the value, by a running error analysis of the first order at some points; `None` unless it
/// is less than `most`.
fn rounding(powers: &[f64], shift: f64, chunk: usize, most: f64) -> Option<f64> {
    const POINTS: u32 = 12;
    let shifted = crate::chebyshev::shift(powers, -shift);
    let blocks: Option<Vec<_>> = shifted.chunks(chunk).map(rough_block).collect();
    let blocks = blocks?;
    let at = |index: u32| {
        let y = 0.25 * f64::from(index) / f64::from(POINTS) + shift;
        let power = power(y.abs(), chunk as i32);
        blocks.iter().rev().fold((0.0, 0.0), |(value, error): (f64, f64), block| {
            let (own, own_error) = rough_value(block, y);
            (own + value * power, own_error + power * (error + 4.0 * value.abs()) + own.abs())
        })
    };
    Some(largest((0..=POINTS).map(|index| at(index).1), most)).filter(|&rounding| rounding < most)
}

fn rough_block(powers: &[f64]) -> Option<Block<f64>> {
    Some(factored(powers, &roots(powers)?))
}

/// The value at y, and the sum of its roundings in units of rounding.
fn rough_value(Block { head, factors }: &Block<f64>, y: f64) -> (f64, f64) {
    let w = y * y;
    let z = head.iter().rev().fold((0.0, 0.0), |(value, error): (f64, f64), c| {
        let product: f64 = value * y;
        (product + c, error * y.abs() + 2.0 * product.abs() + c.abs() + (product + c).abs())
    });
    factors.iter().fold(z, |(value, error), &(alpha, beta)| {
        let factor = w - alpha;
        let (product, next) = (value * factor, value * factor + beta);
        let inexact = value.abs() * (3.0 * w + alpha.abs() + factor.abs());
        (next, error * factor.abs() + inexact + product.abs() + beta.abs() + next.abs())
    })
}
