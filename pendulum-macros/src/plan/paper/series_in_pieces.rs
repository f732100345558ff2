//! The series of θ and of its derivatives, piece by piece.
//!
//! Where harmonics fall off slowly, from about 0.9π on, Clenshaw's recurrence is rounded by more than full precision
//! leaves, and to bound a long one takes the compiler more than a second. The sum of the first harmonics of a curve is a
//! curve, too, bounded in the strip of the whole by what the whole is bounded by; so it is interpolated as that would be.

use super::parts::Wanted;
use super::{Sum, in_units};
use crate::plan::aim::Aim;
use crate::plan::harmonics::harmonics;
use crate::plan::part::AllInPieces;
use crate::plan::task::Task;
use crate::plan::{Bound, Part, Plan};

impl Sum<'_> {
    /// In few pieces if those serve, with the cheapest reduction that keeps the promise; or the error reached, in units of
    /// the tolerance.
    pub(super) fn in_pieces(&self, wanted: &[Wanted]) -> Result<Plan, f64> {
        let mut task = Task::new(self.scene);
        task.aims.iter_mut().zip(wanted).for_each(|(aim, wanted)| self.restrict(aim, wanted));
        let bias = in_units(wanted, |of| of.bias);
        let all = AllInPieces::all(&task, &self.reductions());
        let pieces = all.first().ok_or(f64::INFINITY)?;
        let mut reached = f64::INFINITY;
        for reduction in pieces.reductions.iter().filter(|reduction| self.serves(wanted, reduction)) {
            match pieces.parts(&task, reduction, f64::INFINITY) {
                Ok(parts) => {
                    let parts = parts.into_iter().zip(wanted).map(|(part, wanted)| self.of_sum(part, wanted));
                    return Ok(self.joined(reduction, parts.collect()));
                }
                Err(best) => reached = reached.min(best + bias),
            }
        }
        Err(reached)
    }

    /// The sum in place of the whole curve, with what is left to it.
    fn restrict(&self, aim: &mut Aim, wanted: &Wanted) {
        aim.curves = vec![wanted.curve.clone().first(self.weights.len())];
        // A sum has no logarithms.
        aim.power = 1;
        aim.limit = self.left(wanted);
        aim.truncation = aim.limit;
    }

    /// An output that is of the sum, as one of the curve.
    fn of_sum(&self, part: Part, wanted: &Wanted) -> Part {
        let bound = Bound { truncation: part.bound.truncation + wanted.bias, ..part.bound };
        let description = format!("{}, their sum as {}", harmonics(self.weights.len()), part.description);
        Part { bound, description, share: 0.0, ..part }
    }
}

#[cfg(test)]
mod tests;
