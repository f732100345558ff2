//! One output's kernel, by polynomials, by the passage through the lowest point or in pieces, and whether it keeps the
//! promise.

mod all_in_pieces;
mod draft;
mod passage;
mod pieces;
mod polynomials;

use super::aim::Aim;
use super::curve::Curve;
use super::kernel::{Core, Kernel};
use super::observed::observed;
use super::reduction::{Origin, Reduction};
use super::task::Task;
use super::turning::{AT_TOP, Finish, Start, Turning, Turns};
use super::variables::Variables;
use super::{Bound, MOSTLY_ROUNDING, Part};
use crate::parse::{Float, Output};
use crate::program::Builder;
use crate::program::rounding::half_ulp;
use crate::scene::Goal;
pub(super) use all_in_pieces::AllInPieces;
use draft::Draft;
#[cfg(test)]
pub(super) use draft::Drafts;
pub(super) use passage::SLOWNESS;
use pendulum_runtime::double::Double;
pub(super) use polynomials::Approximations;
use std::f64::consts::PI;
use std::rc::Rc;

/// From these tolerances on a bound had better not be mostly of rounding, which is hardly ever at its worst: `MAX_ERROR` is
/// to be at most four times what can be observed.
fn close_from(float: Float) -> f64 {
    match float {
        Float::F64 => 1e-12,
        Float::F32 => 1e-5,
    }
}

/// Turns are rounded besides.
fn with_turns(kernel: &Kernel, bound: Bound, reduction: &Reduction) -> Bound {
    Bound { evaluation: bound.evaluation + kernel.finish.rounding_of_turns(reduction, &bound), ..bound }
}

impl Aim {
    /// The kernel of the first of three rounds that keeps the promise, or the least bound reached, in units of the
    /// tolerance. A round is told what the phase and the rounding of the kernel of the one before leave, and gives a
    /// draft; or what can be reached at best, which ends the search. One that takes more than `most` of the limit is of no
    /// use: neither is a second round then, nor what it would reach.
    fn first_kept(
        &self,
        reduction: &Reduction,
        phase: f64,
        most: f64,
        mut round: impl FnMut(f64) -> Result<Rc<Draft>, f64>,
    ) -> Result<Part, f64> {
        let room = (most * self.limit - self.beyond_bound(reduction, phase)).min(self.limit);
        let rounds = if room < self.limit { 1 } else { 3 };
        if phase > room && rounds == 1 {
            return Err(phase / self.size.unit);
        }
        let (mut rounding, mut reached) = (0.0, f64::INFINITY);
        for _ in 0..rounds {
            let draft = round(self.limit - phase - rounding).map_err(|best| best.min(reached))?;
            let Draft { kernel, truncation, .. } = &*draft;
            // What of the phase isn't felt is room: a rounding cut short below what there is of it would count as proven.
            let felt = kernel.finish.felt(reduction, phase);
            let evaluation = draft.rounding(reduction, room - felt - truncation);
            let bound = Bound { truncation: *truncation, phase, evaluation };
            rounding = self.judged(kernel, bound, reduction).evaluation;
            match self.accept(kernel, bound, reduction) {
                Ok(part) if part.share <= most => return Ok(part),
                Ok(part) => reached = reached.min(part.error()),
                Err(total) => reached = reached.min(total),
            }
        }
        Err(reached)
    }

    /// The part if it keeps the promise, else the bound reached, in units of the tolerance.
    pub(super) fn accept(&self, kernel: &Kernel, bound: Bound, reduction: &Reduction) -> Result<Part, f64> {
        let bound = Bound { phase: kernel.finish.felt(reduction, bound.phase), ..bound };
        let judged = self.judged(kernel, bound, reduction);
        if judged.total().is_nan() || judged.total() > self.limit {
            return Err(judged.total() / self.size.unit);
        }
        let (output, unit, largest) = (self.output, self.size.unit, self.size.largest);
        // What turns are rounded by is the same whatever is chosen.
        let doubt = if self.is_mostly_rounding(&kernel.core, &bound, reduction) { self.limit } else { 0.0 };
        let share = (judged.total() + self.beyond_bound(reduction, bound.phase) + doubt) / self.limit;
        Ok(Part {
            output,
            description: kernel.core.describe(),
            kernel: kernel.clone(),
            bound: with_turns(kernel, bound, reduction),
            unit,
            largest,
            share,
        })
    }

    /// Those of the mirror image, if that is what moves: it changes the sign of a curve, but for the height's, and cos(θ/2)
    /// with it, or sin where the angle is from the top.
    fn mirror<K>(&self, task: &Task, kernels: &mut [K], negate: impl Fn(&mut K)) {
        let mirrors = |curve: &Curve| self.output != Output::Position || curve.mirrors(task.turns_over());
        let mirrored = kernels.iter_mut().zip(&self.curves).filter(|(_, curve)| task.direction < 0.0 && mirrors(curve));
        mirrored.for_each(|(kernel, _)| negate(kernel));
    }

    /// Whether rounding takes much of a tolerance and more of the bound than the rest does, as with coefficients that are
    /// many times as large as what they add up to, or with times of which most of the digits are before the point. Then it
    /// counts as more than the whole of its limit, which serves where nothing else does. Evaluating a passage is mostly
    /// wrong by what its series leave out.
    fn is_mostly_rounding(&self, core: &Core, bound: &Bound, reduction: &Reduction) -> bool {
        const MUCH: f64 = 0.125;
        let Goal::Tolerance(tolerance) = self.goal else { return false };
        let of_phase = if reduction.is_rounded_late() { bound.phase } else { 0.0 };
        let rounding = bound.evaluation + of_phase;
        !matches!(core, Core::Passage(_))
            && tolerance >= close_from(reduction.float)
            && rounding > MUCH * self.limit
            && rounding > MOSTLY_ROUNDING * (bound.truncation + bound.phase - of_phase)
    }

    /// By how much more than its bound an error takes of the limit: less what is hardly ever met of the phase's, and what
    /// of it is met in full counts more.
    fn beyond_bound(&self, reduction: &Reduction, phase: f64) -> f64 {
        let in_full = self.goal == Goal::Full && reduction.grows();
        let more = if in_full { (1.0 / observed(reduction.float) - 1.0) * phase } else { 0.0 };
        more - (self.size.slope * reduction.seldom).min(phase)
    }

    /// The bound that the promise is about: at full precision the turns of an angle that grows without bound cost what
    /// they cost.
    fn judged(&self, kernel: &Kernel, bound: Bound, reduction: &Reduction) -> Bound {
        let grows = self.goal == Goal::Full && self.output == Output::Theta;
        if grows { bound } else { with_turns(kernel, bound, reduction) }
    }

    /// The angle of a rotation, wrapped or with its turns, or that of another motion that might pass π; anything else
    /// as it is.
    fn finish(&self, turning: Option<Turning>) -> Finish {
        match turning {
            Some(turning) => Finish::Turning(turning),
            None if self.output == Output::Wrapped => self.finished_near_top(),
            None => Finish::Nothing,
        }
    }

    /// What that costs, of an angle that is computed from there.
    pub(in crate::plan) fn cost_of_finish(&self, task: &Task, reduction: &Reduction, start: Start) -> f64 {
        // About what the approximation will be wrong by.
        let finish = self.finish(self.turning(task, reduction, start, [0.5 * self.limit, 0.0]));
        if finish == Finish::Nothing {
            return 0.0;
        }
        let cost = |finish: &Finish| {
            let mut b = Builder::new(reduction.float);
            let t = b.input();
            let phase = reduction.lower(&mut b, t);
            let variables = Variables::lower(&mut b, phase, reduction, true);
            let angle = b.add(variables.p, variables.distance);
            let finished = finish.lower(&mut b, &variables, vec![angle]);
            b.finish(finished.into_iter().chain([variables.magic]).collect()).cost()
        };
        cost(&finish) - cost(&Finish::Nothing)
    }

    /// What completes the angle of a rotation that is computed from there, given the truncation and the error of the phase.
    fn turning(&self, task: &Task, reduction: &Reduction, start: Start, errors: [f64; 2]) -> Option<Turning> {
        let mean = task.mean.filter(|_| self.output.is_angle())?;
        let turning = Turning {
            start,
            halfway: matches!(start, Start::Top(_)) && reduction.origin == Origin::Anchor,
            unit: reduction.unit,
            turns: if self.output == Output::Wrapped { Turns::Modulo } else { Turns::Counted },
            slope: self.size.slope,
            direction: task.direction,
            most_turns: task.turns,
        };
        // At full precision an angle is as good as it can be where it is small, and its turns don't count.
        let as_good = self.goal == Goal::Full && turning.turns == Turns::Counted;
        Some(if as_good { turning } else { turning.cheaper_if_good(reduction, mean, errors, self.limit) })
    }

    /// An arc may lead over the top; a whole swing doesn't, but its largest angle is rounded.
    fn finished_near_top(&self) -> Finish {
        let met = self.curves.first().and_then(Curve::largest_met);
        let whole = || Double::from_sum(self.size.largest, half_ulp(self.size.largest, Float::F64));
        let largest = met.unwrap_or_else(whole);
        if met.is_some_and(|largest| (largest - Double::PI).hi > AT_TOP) {
            Finish::Wrapped
        } else if largest.hi + self.limit >= PI.next_down() {
            Finish::Within { largest }
        } else {
            Finish::Nothing
        }
    }
}
