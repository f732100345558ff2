//! An output in pieces.

use super::draft::Draft;
use super::polynomials::SQUARING;
use crate::chebyshev::OF_INTERPOLATION;
use crate::plan::Part;
use crate::plan::aim::Aim;
use crate::plan::curve::Curve;
use crate::plan::kernel::{Core, Kernel};
use crate::plan::pieces::{Halves, Pieces, Piecewise};
use crate::plan::reduction::Reduction;
use crate::plan::task::Task;
use crate::plan::turning::Start;
use crate::supremum::norm;
use std::rc::Rc;

impl Aim {
    /// Whether it can be had in pieces: curves all of which is met.
    pub(in crate::plan) fn has_pieces(&self) -> bool {
        !self.curves.is_empty() && !self.curves.iter().any(Curve::is_arc)
    }

    /// About how many terms each of so many pieces of each curve takes; `None` where the phase leaves nothing.
    pub(in crate::plan) fn terms_of_pieces(&self, pieces: usize, reduction: &Reduction) -> Option<Vec<usize>> {
        let left = Some(self.truncation_of_each(self.left(reduction))).filter(|&left| left > 0.0)?;
        let of = |curve: &Curve| {
            let terms = |left: f64| Piecewise::estimate(curve, pieces, left);
            // Of logarithms the coefficients fall off with their number besides.
            if self.power == 0 { terms(left * terms(left) as f64) } else { terms(left) }
        };
        Some(self.curves.iter().map(of).collect())
    }

    /// What the polynomials cost of which each has so many terms: two operations a term, the sign, and what makes a
    /// position of its halves.
    pub(in crate::plan) fn cost_of_pieces(&self, terms: &[usize]) -> f64 {
        let polynomials: f64 = terms.iter().map(|&terms| 2.0 * terms as f64 - 2.0).sum();
        let sign = f64::from(u8::from(self.curves.iter().any(|curve| curve.alternates)));
        polynomials + sign + if self.curves.len() > 1 { SQUARING } else { 0.0 }
    }

    /// Its curves in so many pieces.
    pub(in crate::plan) fn piecewise(&self, pieces: usize) -> Option<Vec<Piecewise>> {
        let negligible = |curve: &Curve| self.truncation.min(curve.size.largest).max(self.floor()) * OF_INTERPOLATION;
        self.curves.iter().map(|curve| Piecewise::new(curve, pieces, negligible(curve))).collect()
    }

    /// The kernel in pieces, or what it reaches.
    pub(in crate::plan) fn pieces_part(
        &self,
        task: &Task,
        reduction: &Reduction,
        approximations: &[Piecewise],
        most: f64,
    ) -> Result<Part, f64> {
        let phase = self.size.phase_error(reduction);
        self.first_kept(reduction, phase, most, |left| {
            let each = self.truncation_of_each(left);
            let made = approximations.iter().map(|curve| curve.kernel(reduction, each)).collect::<Option<Vec<_>>>();
            let (mut pieces, truncations): (Vec<Pieces>, Vec<f64>) = made.ok_or(f64::INFINITY)?.into_iter().unzip();
            self.mirror(task, &mut pieces, Pieces::negate);
            let kernel = match <[Pieces; 2]>::try_from(pieces) {
                Ok([sine, cosine]) => Core::Halves(Box::new(Halves { sine, cosine })).into(),
                Err(mut single) => {
                    let (mut angle, turning) =
                        (single.swap_remove(0), self.turning(task, reduction, Start::Piece, [0.0; 2]));
                    if let Some(turning) = &turning {
                        angle.complete(turning);
                    }
                    Kernel { core: Core::Pieces(Box::new(angle)), finish: self.finish(turning) }
                }
            };
            Ok(Rc::new(Draft::new(kernel, self.error(norm(truncations.into_iter())))))
        })
    }
}
