//! All outputs in pieces: how many pieces, with which reductions, and at what cost.

use crate::plan::Part;
use crate::plan::aim::Aim;
use crate::plan::met::Met;
use crate::plan::pieces::Piecewise;
use crate::plan::reduction::Reduction;
use crate::plan::task::Task;
use crate::plan::turning::Start;
use crate::program::cost::{CLAMP, ROW, lanes_lost};
use std::cell::OnceCell;

/// All outputs in pieces.
pub(in crate::plan) struct AllInPieces {
    pieces: usize,
    /// Of a short horizon.
    met: Option<Met>,
    /// To the nearest piece.
    pub(in crate::plan) reductions: Vec<Reduction>,
    /// Those of each output; none where one of them takes too many points.
    curves: OnceCell<Option<Vec<Vec<Piecewise>>>>,
}

/// What the powers of a polynomial of some ten terms cost.
const POWERS: f64 = 3.0;

impl AllInPieces {
    /// By few pieces and by many; none where an output has no pieces, or no reduction counts pieces.
    pub(in crate::plan) fn all(task: &Task, reductions: &[Reduction]) -> Vec<Self> {
        let serves = task.aims.iter().all(Aim::has_pieces);
        let all = |pieces: usize| {
            let reductions: Vec<Reduction> =
                reductions.iter().filter_map(|reduction| reduction.in_pieces(pieces)).collect();
            let few = |aim: &Aim, reduction: &Reduction| {
                let terms = aim.terms_of_pieces(pieces, reduction);
                terms.is_some_and(|terms| terms.into_iter().all(|terms| terms <= Piecewise::MOST_TERMS))
            };
            let serves = reductions.iter().any(|reduction| task.aims.iter().all(|aim| few(aim, reduction)));
            serves.then(|| Self { pieces, met: task.met, reductions, curves: OnceCell::new() })
        };
        Piecewise::COUNTS.into_iter().filter(|_| serves).filter_map(all).collect()
    }

    /// The cost of all outputs: the reduction, the clamp, the row, the polynomials and what completes angles, none of it in
    /// vectors; `None` where the phase isn't good enough.
    pub(in crate::plan) fn estimate(&self, task: &Task, reduction: &Reduction) -> Option<f64> {
        let kernel = |aim: &Aim| {
            let polynomials = aim.cost_of_pieces(&aim.terms_of_pieces(self.pieces, reduction)?);
            Some(polynomials + aim.cost_of_finish(task, reduction, Start::Piece))
        };
        let kernels: f64 = task.aims.iter().map(kernel).sum::<Option<f64>>()?;
        Some(lanes_lost(reduction.float) * (reduction.operations() as f64 + CLAMP + ROW + POWERS + kernels))
    }

    /// All outputs with one of its reductions, each of which takes at most a part of the limit of it, or what was reached.
    pub(in crate::plan) fn parts(&self, task: &Task, reduction: &Reduction, most: f64) -> Result<Vec<Part>, f64> {
        let curves = self.curves(&task.aims).ok_or(f64::INFINITY)?;
        let part = |(aim, curves): (&Aim, &Vec<Piecewise>)| aim.pieces_part(task, reduction, curves, most);
        task.aims.iter().zip(curves).map(part).collect()
    }

    /// Made when they are wanted first.
    fn curves(&self, aims: &[Aim]) -> Option<&[Vec<Piecewise>]> {
        let meeting = |curves: Vec<Piecewise>| curves.into_iter().map(|curve| curve.meeting(self.met)).collect();
        let one = |aim: &Aim| aim.piecewise(self.pieces).map(meeting);
        let all = || aims.iter().map(one).collect();
        self.curves.get_or_init(all).as_deref()
    }
}
