//! The paper's θ̂ next to an overshoot, where y comes so near to 1 that neither one polynomial nor one in each piece can
//! stand for twice its arcsine: the sum itself in pieces, and the arcsine of its complement ([`Complement`]).

use super::Allowance;
use crate::chebyshev::OF_INTERPOLATION;
use crate::plan::Bound;
use crate::plan::cosines::Cosines;
use crate::plan::curve::Curve;
use crate::plan::kernel::{Core, Kernel};
use crate::plan::paper::bias::supremum;
use crate::plan::pieces::{Complement, Piecewise};
use crate::plan::reduction::Reduction;
use pendulum_runtime::double::Double;
use std::cell::OnceCell;

/// The sum y in pieces.
pub(super) struct SumInPieces {
    weights: Vec<Double>,
    curve: Curve,
    /// For each of the numbers of pieces, made when it is wanted first; `None` if that takes too many points.
    pieces: [OnceCell<Option<Piecewise>>; COUNTS.len()],
    /// What their series may be wrong by.
    negligible: f64,
    /// 1/√c where c = (1 − y)/2 is least: near y = 1 by so much more θ̂ is wrong than y, which is 1/√(c(1 − c)).
    slope: f64,
}

/// The numbers of pieces of half a period that are tried.
const COUNTS: [usize; 3] = [32, 64, 128];

impl SumInPieces {
    /// For a sum of these weights that is nowhere 1, the pieces' series wrong by much less than makes `limit` of θ̂.
    pub(super) fn new(weights: &[Double], limit: f64) -> Option<Self> {
        let sum = Cosines::odd(weights);
        // Infinite, or no number, where c may be 0.
        let slope_between = |low: f64, high: f64| (0.5 * (1.0 - sum.over(low, high).range(0).1)).sqrt().recip();
        let slope = supremum([0.0, 0.5], slope_between);
        let (weights, curve, pieces) = (weights.to_vec(), Curve::harmonics(weights), Default::default());
        slope.is_finite().then(|| Self { weights, curve, pieces, negligible: limit / slope * OF_INTERPOLATION, slope })
    }

    pub(super) fn most_pieces() -> usize {
        COUNTS[COUNTS.len() - 1]
    }

    fn piecewise(&self, index: usize) -> Option<&Piecewise> {
        let made = || Piecewise::new(&self.curve, COUNTS[index], self.negligible);
        self.pieces[index].get_or_init(made).as_ref()
    }

    /// By few pieces, or by more if these don't keep within the allowance, given the phase that a reduction to so many leaves; or
    /// the least that is rounded.
    pub(super) fn kernel(
        &self,
        allowance: impl Fn(&Reduction) -> Allowance,
        reduction: &Reduction,
        direction: f64,
    ) -> Option<(Kernel, Bound)> {
        let mut least: Option<(Kernel, Bound)> = None;
        for (index, count) in COUNTS.into_iter().enumerate() {
            let Some(reduction) = reduction.in_pieces(count) else { continue };
            let Some(piecewise) = self.piecewise(index) else { continue };
            let allowance = allowance(&reduction);
            let made = piecewise.kernel(&reduction, allowance.truncation / self.slope);
            let Some((sine, truncation)) = made.filter(|(sine, _)| sine.terms() <= Piecewise::MOST_TERMS) else {
                continue;
            };
            let complement = Complement::new(sine, truncation, &self.weights, direction);
            // What the pieces are wrong by is in it.
            let bound = Bound { truncation: 0.0, phase: allowance.phase, evaluation: complement.rounding() };
            let best = least.as_ref().is_none_or(|(_, least)| bound.total() < least.total());
            if best {
                least = Some((Core::Complement(Box::new(complement)).into(), bound));
            }
            if bound.evaluation <= allowance.rest {
                break;
            }
        }
        least
    }
}
