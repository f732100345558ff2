//! An output by the passage through the lowest point.

use super::draft::{Brief, Draft, Drafts};
use crate::plan::Part;
use crate::plan::aim::Aim;
use crate::plan::kernel::Core;
use crate::plan::passage::Passage;
use crate::plan::reduction::Reduction;
use crate::plan::task::Task;
use std::rc::Rc;

impl Aim {
    /// The cost of the passage's kernel: an exponential, an arctangent for an angle, and what joins them, one waiting for
    /// the other. Roughly: near the top others cost several times as much.
    pub(in crate::plan) fn passage_estimate(&self) -> f64 {
        const POWERS_AND_IMAGES: f64 = 30.0;
        const BITS_PER_TERM_OF_POWER: f64 = 5.0;
        const BITS_PER_OPERATION_OF_ARCTANGENT: f64 = 1.3;
        const DIVISION: f64 = 16.0;
        let bits = -libm::log2(self.limit / self.size.unit.max(self.size.largest)).min(-4.0);
        let power = 3.0 + bits / BITS_PER_TERM_OF_POWER;
        let rest = if self.output.is_angle() { bits / BITS_PER_OPERATION_OF_ARCTANGENT } else { DIVISION };
        POWERS_AND_IMAGES + 2.0 * power + rest
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
        let mut limit = self.limit.min(self.truncation) / factor;
        let distances = task.distances_from_lowest(reduction);
        let phase = self.passage_error(reduction, orbit.rounding_of_exponent());
        self.first_kept(reduction, phase, most, |_| {
            let left = limit;
            limit *= 0.125;
            drafts.get(Brief { variant: None, reduction: reduction.clone(), left }, || {
                let kernel = Passage::new(self.output, orbit.clone(), distances, reduction.half(), left);
                let truncation = kernel.truncation * factor;
                let kernel = self.finished(task, Core::Passage(Box::new(kernel)), None);
                Ok(Rc::new(Draft::new(kernel, truncation)))
            })
        })
    }
}
