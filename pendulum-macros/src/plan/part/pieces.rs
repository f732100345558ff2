//! An output in pieces.

use super::draft::Draft;
use crate::plan::Part;
use crate::plan::aim::{Aim, Task};
use crate::plan::curve::Curve;
use crate::plan::kernel::Kernel;
use crate::plan::pieces::Piecewise;
use crate::plan::reduction::Reduction;
use crate::scene::Scene;
use std::rc::Rc;

impl Aim {
    /// Whether it can be had in pieces: one curve, all of which is met.
    pub(in crate::plan) fn has_pieces(&self, task: &Task) -> bool {
        let whole = self.curves.len() == 1 && !self.curves.iter().any(Curve::is_arc);
        whole && !(task.turning && self.output.is_angle())
    }

    /// About how many terms each of so many pieces takes; `None` where the phase leaves nothing.
    pub(in crate::plan) fn terms_of_pieces(&self, parts: usize, reduction: &Reduction) -> Option<usize> {
        let curve = self.curves.first()?;
        let left = Some(self.share(self.limit - self.size.phase_error(reduction))).filter(|&left| left > 0.0)?;
        let terms = |left: f64| Piecewise::estimate(curve, parts, left);
        // Of logarithms the coefficients fall off with their number besides.
        Some(if self.power == 0 { terms(left * terms(left) as f64) } else { terms(left) })
    }

    /// Its curve in so many pieces.
    pub(in crate::plan) fn piecewise(&self, parts: usize) -> Option<Piecewise> {
        let curve = self.curves.first()?;
        Piecewise::new(curve, parts, (self.truncation.min(curve.size.largest) / 512.0).max(self.floor() / 512.0))
    }

    /// The kernel in pieces, or what it reaches.
    pub(in crate::plan) fn pieces_part(
        &self,
        scene: &Scene,
        task: &Task,
        reduction: &Reduction,
        approximation: &Piecewise,
        most: f64,
    ) -> Result<Part, f64> {
        let phase = self.size.phase_error(reduction);
        self.first_kept(scene, reduction, phase, most, |left| {
            let (mut pieces, truncation) =
                approximation.kernel(reduction, left.min(self.truncation)).ok_or(f64::INFINITY)?;
            if task.direction < 0.0 {
                pieces.negate();
            }
            let kernel = self.turned(scene, task, Kernel::Pieces(Box::new(pieces)), None);
            Ok(Rc::new(Draft::new(kernel, truncation)))
        })
    }
}
