//! The series of θ and of its derivative, piece by piece.
//!
//! Where harmonics fall off slowly, from about 0.9π on, Clenshaw's recurrence is rounded by more than full precision
//! leaves, and to bound a long one takes the compiler more than a second. The sum of the first harmonics of a curve is a
//! curve, too, bounded in the strip of the whole by what the whole is bounded by; so it is interpolated as that would be.

use super::Sum;
use super::parts::{SHARES, Wanted, kernel_in_pieces};
use crate::motion::{Swing, direction};
use crate::plan::harmonics::harmonics;
use crate::plan::part::observed;
use crate::plan::pieces::Piecewise;
use crate::plan::reduction::Reduction;
use crate::plan::{Bound, Part, Plan};
use crate::scene::Scene;
use crate::supremum::worst;

/// By how much better than what is left of the promise sums are interpolated.
const NEGLIGIBLE: f64 = 512.0 * SHARES[1];

impl Sum {
    /// With the cheapest reduction to pieces that keeps the promise; or the error reached, in units of the tolerance.
    pub(super) fn in_pieces(&self, scene: &Scene, swing: &Swing, wanted: &[Wanted]) -> Result<Plan, f64> {
        let sums = |pieces: usize| Some((pieces, self.piecewise(scene, wanted, pieces)?));
        let sums = Piecewise::COUNTS.into_iter().find_map(sums);
        let (pieces, sums) = sums.ok_or(f64::INFINITY)?;
        let counted =
            self.reductions(scene, swing).into_iter().filter_map(|reduction| reduction.in_pieces(pieces as f64));
        let mut reached = f64::INFINITY;
        for reduction in counted.filter(|reduction| Self::serves(scene, wanted, reduction)) {
            let part = |(wanted, sum)| self.part_in_pieces(scene, swing, wanted, sum, &reduction);
            let parts: Vec<Result<Part, f64>> = wanted.iter().zip(&sums).map(part).collect();
            let error = |part: &Result<Part, f64>| part.as_ref().map_or_else(|&error| error, Part::error);
            reached = reached.min(worst(parts.iter().map(error)));
            if let Ok(parts) = parts.into_iter().collect() {
                return Ok(self.joined(&reduction, parts));
            }
        }
        Err(reached)
    }

    /// What the promise leaves to the phase and pieces.
    pub(super) fn left(&self, scene: &Scene, wanted: &Wanted) -> f64 {
        self.promise_observed(observed(scene.float), scene, wanted) - wanted.bias
    }

    /// The outputs' sums in so many pieces; `None` if these take too many terms or points.
    fn piecewise(&self, scene: &Scene, wanted: &[Wanted], pieces: usize) -> Option<Vec<Piecewise>> {
        let one = |wanted: &Wanted| {
            let (sum, left) = (wanted.curve.clone().first(self.weights.len()), self.left(scene, wanted));
            let few = Piecewise::estimate(&sum, pieces, left) <= Piecewise::MOST_TERMS;
            few.then(|| Piecewise::new(&sum, pieces, left.min(sum.size.largest) / NEGLIGIBLE))?
        };
        wanted.iter().map(one).collect()
    }

    /// The part, or the error reached, in units of the tolerance.
    fn part_in_pieces(
        &self,
        scene: &Scene,
        swing: &Swing,
        wanted: &Wanted,
        sum: &Piecewise,
        reduction: &Reduction,
    ) -> Result<Part, f64> {
        let Wanted { curve, bias, .. } = wanted;
        let phase = curve.size.phase_error(reduction);
        let left = self.left(scene, wanted) - phase;
        let made = |share: f64| kernel_in_pieces(sum, left / share, reduction, direction(swing.mirrored));
        let mut reached = f64::INFINITY;
        for (kernel, truncation, evaluation) in SHARES.into_iter().filter_map(made) {
            let bound = Bound { truncation: bias + truncation, phase, evaluation };
            if truncation + evaluation <= left {
                let description = format!("{}, their sum as {}", harmonics(self.weights.len()), kernel.describe());
                return Ok(wanted.part(kernel, description, bound));
            }
            reached = reached.min(bound.total() / curve.size.unit);
        }
        Err(reached)
    }
}
