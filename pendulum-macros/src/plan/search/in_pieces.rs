//! All outputs in pieces: how many parts, with which reductions, and at what cost.

use crate::plan::aim::{Aim, Task};
use crate::plan::pieces::Piecewise;
use crate::plan::reduction::Reduction;
use crate::program::cost::{ROW, lanes_lost};
use crate::scene::Scene;
use std::cell::OnceCell;

/// All outputs in pieces.
pub(super) struct InPieces {
    parts: usize,
    /// To the nearest part.
    pub(super) reductions: Vec<Reduction>,
    /// None where one of them takes too many points.
    curves: OnceCell<Option<Vec<Piecewise>>>,
}

/// What holding a remainder between two limits costs, and the powers of a polynomial of some ten terms.
const CLAMP: f64 = 2.6;
const POWERS: f64 = 3.0;

impl InPieces {
    /// Tables of up to 13 kB for each output.
    const PARTS: [usize; 2] = [64, 128];
    /// With more terms than this smaller parts are tried.
    const MOST_TERMS: usize = 16;

    /// `None` where an output has no pieces, or no reduction counts parts.
    pub(super) fn new(scene: &Scene, task: &Task, reductions: &[Reduction]) -> Option<Self> {
        let serves = scene.method.is_none() && task.aims.iter().all(|aim| aim.has_pieces(task));
        let parts = |parts: usize| {
            let reductions: Vec<Reduction> =
                reductions.iter().filter_map(|reduction| reduction.in_parts(parts as f64)).collect();
            let few = |aim: &Aim, reduction: &Reduction| {
                aim.terms_of_pieces(parts, reduction).is_some_and(|terms| terms <= Self::MOST_TERMS)
            };
            let serves = reductions.iter().any(|reduction| task.aims.iter().all(|aim| few(aim, reduction)));
            serves.then(|| Self { parts, reductions, curves: OnceCell::new() })
        };
        Self::PARTS.into_iter().filter(|_| serves).find_map(parts)
    }

    /// The cost of all outputs: the reduction, the clamp, the row and the polynomials, none of it in vectors; `None` where
    /// the phase isn't good enough.
    pub(super) fn estimate(&self, scene: &Scene, aims: &[Aim], reduction: &Reduction) -> Option<f64> {
        let polynomial = |aim: &Aim| {
            let terms = aim.terms_of_pieces(self.parts, reduction)?;
            let sign = f64::from(u8::from(aim.curves.iter().any(|curve| curve.alternates)));
            Some(2.0 * terms as f64 - 2.0 + sign)
        };
        let kernels: f64 = aims.iter().map(polynomial).sum::<Option<f64>>()?;
        Some(lanes_lost(scene.float) * (reduction.operations() as f64 + CLAMP + ROW + POWERS + kernels))
    }

    /// Made when they are wanted first.
    pub(super) fn curves(&self, aims: &[Aim]) -> Option<&[Piecewise]> {
        let all = || aims.iter().map(|aim| aim.piecewise(self.parts)).collect();
        self.curves.get_or_init(all).as_deref()
    }
}
