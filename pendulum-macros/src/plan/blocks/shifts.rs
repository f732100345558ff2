//! Which shift makes the roots of the odd parts real, and with how much rounding: estimates, which proofs follow.

use crate::supremum::largest;
use pendulum_runtime::double::Double;
use std::ops::{Add, Mul};

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
        let power = y.abs().powi(chunk as i32);
        blocks.iter().rev().fold((0.0, 0.0), |(value, error): (f64, f64), block| {
            let (own, own_error) = rough_value(block, y);
            (own + value * power, own_error + power * (error + 4.0 * value.abs()) + own.abs())
        })
    };
    Some(largest((0..=POINTS).map(|index| at(index).1), most)).filter(|&rounding| rounding < most)
}

/// A block, no more accurate than an estimate needs.
struct Rough {
    /// z, in powers of y.
    head: Vec<f64>,
    /// (α, β).
    factors: Vec<(f64, f64)>,
}

fn rough_block(powers: &[f64]) -> Option<Rough> {
    let mut left = powers.to_vec();
    let mut factors = Vec::new();
    for root in roots(powers)? {
        factors.push((root, divide(&mut left, root)));
    }
    factors.reverse();
    Some(Rough { head: left, factors })
}

/// Divides powers of y by y² − α; the constant of the remainder, whose other coefficient is nought where α is a root of
/// the odd part.
pub(super) fn divide<T: Copy + Add<Output = T> + Mul<Output = T>>(powers: &mut Vec<T>, alpha: T) -> T {
    for i in (2..powers.len()).rev() {
        powers[i - 2] = powers[i - 2] + alpha * powers[i];
    }
    let remainder = powers[0];
    powers.drain(..2);
    remainder
}

/// The value at y, and the sum of its roundings in units of rounding.
fn rough_value(Rough { head, factors }: &Rough, y: f64) -> (f64, f64) {
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

/// The roots of the odd part of a block, in w, the smallest first; `None` unless all are real.
pub(super) fn roots(powers: &[f64]) -> Option<Vec<f64>> {
    if powers.len() < 4 {
        return Some(Vec::new());
    }
    let odd: Vec<f64> = powers.iter().skip(1).step_by(2).copied().collect();
    let mut roots = real_roots(&odd)?;
    roots.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    Some(roots)
}

/// All roots of a polynomial, lowest power first, between those of its derivative; `None` unless all are real.
fn real_roots(powers: &[f64]) -> Option<Vec<f64>> {
    let (&leading, lower) = powers.split_last()?;
    if lower.is_empty() {
        return Some(Vec::new());
    }
    let derivative: Vec<f64> = powers.iter().enumerate().skip(1).map(|(power, c)| power as f64 * c).collect();
    // Cauchy's bound.
    let bound = 1.0 + lower.iter().map(|c| (c / leading).abs()).fold(0.0, f64::max);
    let mut ends = real_roots(&derivative)?;
    ends.insert(0, -bound);
    ends.push(bound);
    ends.windows(2).map(|ends| root_between(powers, ends[0], ends[1])).collect()
}

/// By index, since unoptimised iterators would take the planner three times as long.
fn value(powers: &[f64], x: f64) -> f64 {
    let mut sum = 0.0;
    let mut index = powers.len();
    while index > 0 {
        index -= 1;
        sum = sum * x + powers[index];
    }
    sum
}

/// The root between two points where the signs differ, by the Illinois variant of the false position.
fn root_between(powers: &[f64], mut a: f64, mut b: f64) -> Option<f64> {
    let (mut at_a, mut at_b) = (value(powers, a), value(powers, b));
    if !(at_a.is_finite() && at_b.is_finite()) || at_a * at_b > 0.0 {
        return None;
    }
    for _ in 0..100 {
        let x = b - at_b * (b - a) / (at_b - at_a);
        let x = if x.is_finite() { x } else { 0.5 * (a + b) };
        let at_x = value(powers, x);
        if at_x == 0.0 || (x - b).abs() <= 1e-13 * x.abs() {
            return Some(x);
        }
        if at_x * at_b < 0.0 {
            (a, at_a) = (b, at_b);
        } else {
            at_a *= 0.5;
        }
        (b, at_b) = (x, at_x);
    }
    Some(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_found_and_missed() {
        let roots = real_roots(&[-6.0, 11.0, -6.0, 1.0]).unwrap();
        for (found, expected) in roots.iter().zip([1.0, 2.0, 3.0]) {
            assert!((found - expected).abs() < 1e-12, "{roots:?}");
        }
        assert_eq!(real_roots(&[1.0, 0.0, 1.0]), None);
    }
}
