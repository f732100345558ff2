//! An output by the passage through the lowest point.

use super::draft::{Brief, Draft, Drafts};
use crate::plan::aim::Aim;
use crate::plan::kernel::{Core, Kernel};
use crate::plan::passage::{Orbit, Passage};
use crate::plan::reduction::Reduction;
use crate::plan::task::Task;
use crate::plan::turning::Start;
use crate::plan::{Bound, Part};
use std::rc::Rc;

/// How much more operations of a passage count than those of polynomials, since each waits for the one before: 1.4 to 1.8
/// times as much in loops over arrays, of both types, without and with AVX2. In chains of calls, which don't count here, a
/// passage takes 1.3 to 2 times as long as what costs as much.
pub(in crate::plan) const SLOWNESS: f64 = 1.75;

impl Aim {
    /// What the passage's kernel is estimated to cost, where there is one.
    pub(in crate::plan) fn passage_estimate(&self, task: &Task, reduction: &Reduction) -> f64 {
        let cost = |orbit: &Orbit| orbit.cost(self.output, self.passage_limit(orbit), reduction.float);
        task.passage_by(reduction).map_or(f64::INFINITY, cost)
    }

    /// What a passage's kernel may leave out at most, in units of the output's factor.
    fn passage_limit(&self, orbit: &Orbit) -> f64 {
        self.limit.min(self.truncation) / orbit.factor(self.output).hi
    }

    /// The kernel of the passage through the lowest point, or what it reaches.
    pub(in crate::plan) fn passage_part(
        &self,
        task: &Task,
        drafts: &Drafts,
        reduction: &Reduction,
        most: f64,
    ) -> Result<Part, f64> {
        let orbit = task.passage_by(reduction).ok_or(f64::INFINITY)?.in_units(reduction.unit);
        let factor = orbit.factor(self.output).hi;
        let distances = task.distances_from_lowest(reduction);
        let phase = self.passage_error(reduction, orbit.rounding_of_exponent());
        let all = self.passage_limit(&orbit);
        // What the phase leaves, as far as a round is worth it.
        let mut limit = ((self.limit - phase) / factor).clamp(0.125 * all, all);
        self.first_kept(reduction, phase, most, |_| {
            let left = limit;
            limit *= 0.125;
            drafts.get(Brief { variant: None, reduction: reduction.clone(), left }, || {
                let kernel = Passage::new(self.output, orbit.clone(), distances, reduction.half(), left);
                let truncation = kernel.truncation * factor;
                let finish = self.finish(self.turning(task, reduction, Start::Lowest, [truncation, phase]));
                Ok(Rc::new(Draft::new(Kernel { core: Core::Passage(Box::new(kernel)), finish }, truncation)))
            })
        })
    }

    /// An output's part with the exponential of another's, if it keeps the promise: in one function they share it.
    pub(in crate::plan) fn with_exponential_of(
        &self,
        reduction: &Reduction,
        part: &Part,
        other: &Part,
    ) -> Option<Part> {
        let (Core::Passage(own), Core::Passage(others)) = (&part.kernel.core, &other.kernel.core) else { return None };
        let shared = own.with_exponential_of(others);
        if shared == **own {
            return Some(part.clone());
        }
        let core = Core::Passage(Box::new(shared));
        let kernel = Kernel { core, finish: part.kernel.finish.clone() };
        let bound = Bound { evaluation: kernel.rounding(reduction, f64::INFINITY), ..part.bound };
        self.accept(&kernel, bound, reduction).ok()
    }
}
