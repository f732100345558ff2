//! Bounds over the range of phases.

use super::reduction::{Origin, Phase, Reduction};
use super::variables::Variables;
use crate::program::rounding::Known;
use crate::program::{Builder, Id};
use crate::supremum::{Halving, largest};

/// The norm of the rounding of what is computed of the phase as it is reduced, of which nothing else is known, but for the
/// signs: of either the rounding is the same, and bounded better where the sign is known. `odd` tells whether the sign
/// matters.
pub(super) fn rounding_of(
    reduction: &Reduction,
    odd: bool,
    cap: f64,
    lower: impl FnOnce(&mut Builder, &Variables) -> Vec<Id>,
) -> f64 {
    let mut b = Builder::new(reduction.float);
    let remainder = b.input();
    b.name(remainder, reduction.origin.phase());
    let phase = Phase { remainder, magic: remainder, count: remainder };
    let variables = Variables::lower(&mut b, phase, reduction, odd).unsigned();
    let results = lower(&mut b, &variables);
    let program = b.finish(results);
    let phase = program.named(reduction.origin.phase());
    over_phases(reduction, cap, |low, high| {
        program.norm_of_rounding(phase.map(|phase| (phase, Known::between(low, high))).as_slice())
    })
}

/// The largest of the bounds on parts of the range of phases, or some number above `cap`. The motion is fastest, and the
/// rounding mostly worst, at the lowest point: near the top so near to it that uniform slices bound it by several times
/// what it is.
pub(super) fn over_phases(reduction: &Reduction, cap: f64, bound: impl Fn(f64, f64) -> f64) -> f64 {
    let [low, high] = reduction.range();
    let slice = (high - low) / f64::from(ENDS);
    let (first, last) = ([low, low + slice], [high - slice, high]);
    let ends = if reduction.origin == Origin::Anchor { [last, first] } else { [first, last] };
    let at_ends = largest(ends.into_iter().map(|[from, to]| bound(from, to)), cap);
    let least = if cap.is_finite() { cap / NOTHING } else { 0.0 };
    let halving = Halving { cells: CELLS, slices: SLICES, most: MOST_HALVED, least, cap };
    if at_ends > cap { at_ends } else { halving.largest([low, high], bound) }
}

/// The parts of the range of phases on which rounding is analysed separately at first; where it is worst they are halved
/// until there would be so many slices, and further as often as that gains something.
const CELLS: u32 = 8;
pub(super) const SLICES: u32 = 64;
/// The parts that the range's ends, which are looked at before, would be two of.
const ENDS: u32 = 4096;
const MOST_HALVED: usize = 48;
/// A rounding that many times less than what there is room for needs to be known no better.
const NOTHING: f64 = 512.0;
