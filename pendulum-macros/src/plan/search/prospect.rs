//! A task, the whole motion or an arc of it, and all ways of doing it.

use crate::parse::Output;
use crate::plan::Part;
use crate::plan::form::Variant;
use crate::plan::memo::Memo;
use crate::plan::part::{AllInPieces, Approximations};
use crate::plan::reduction::{Origin, Reduction};
use crate::plan::task::Task;
use crate::scene::Scene;
use crate::series::Parity;
use crate::supremum::worst;
use std::fmt;
use std::rc::Rc;

/// A task, and what all ways of doing it share.
pub(super) struct Prospect {
    pub(super) task: Task,
    pub(super) approximations: Vec<Approximations>,
    pub(super) reductions: Vec<Reduction>,
    /// Few pieces first.
    pub(super) pieces: Vec<AllInPieces>,
    /// What polynomials gave: more than one candidate may ask.
    pub(super) found: Memo<Asked, Rc<Found>>,
}

/// What polynomials are asked for: an output, by its number, that takes at most such a part of its limit.
#[derive(PartialEq)]
pub(super) struct Asked {
    pub(super) output: usize,
    pub(super) reduction: Reduction,
    pub(super) most: f64,
}

/// A variant of an output that isn't taken, and why.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Rejected {
    pub(super) output: Output,
    pub(super) variant: Variant,
    pub(super) parity: Parity,
    pub(super) why: String,
}

impl fmt::Display for Rejected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} for `{}`: {}", self.variant.describe(self.parity), self.output.word(), self.why)
    }
}

/// A part and what it costs, or what was reached, and why others lost.
pub(super) struct Found {
    pub(super) part: Result<(Part, f64), f64>,
    pub(super) rejected: Vec<Rejected>,
}

impl Prospect {
    pub(super) fn new(scene: &Scene, task: Task) -> Self {
        let reductions = task.reductions(scene);
        let approximations = task.aims.iter().map(|aim| Approximations::new(aim, &reductions)).collect();
        let pieces = AllInPieces::all(&task, &reductions);
        let reach = task.reach();
        let reductions = reductions.into_iter().map(|reduction| reduction.reaching(reach)).collect();
        Self { task, approximations, reductions, pieces, found: Memo::default() }
    }

    /// The least that can be promised of the worst output, whatever it costs.
    pub(super) fn most_accurate(&self) -> f64 {
        let Self { approximations, reductions, .. } = self;
        let worst_output = |reduction: &Reduction| {
            let least = |all: &Approximations| {
                self.parts(all, reduction).map(|part| part.error()).fold(f64::INFINITY, f64::min)
            };
            worst(approximations.iter().map(least))
        };
        // The most accurate reduction from either origin is among the best.
        let of = |origin: Origin| {
            let from_there = reductions.iter().filter(move |reduction| reduction.origin == origin);
            from_there.min_by(|a, b| (a.error + a.relative_error).total_cmp(&(b.error + b.relative_error)))
        };
        let others = [Origin::Anchor, Origin::Lowest].into_iter().filter_map(of).map(worst_output);
        let in_pieces = self.pieces.iter().flat_map(|pieces| {
            let one = |reduction| {
                let parts = pieces.parts(&self.task, reduction, f64::INFINITY).ok()?;
                Some(worst(parts.iter().map(Part::error)))
            };
            pieces.reductions.iter().filter_map(one)
        });
        others.chain(in_pieces).fold(f64::INFINITY, f64::min)
    }

    /// An output by every variant, and by the passage where that is to be had, as far as these keep the promise.
    pub(super) fn parts<'a>(
        &'a self,
        all: &'a Approximations,
        reduction: &'a Reduction,
    ) -> impl Iterator<Item = Part> + 'a {
        let polynomial = move |variant: Variant| all.part(&self.task, reduction, variant, f64::INFINITY).ok();
        let polynomials = all.variants(reduction).into_iter().filter_map(move |(variant, _)| polynomial(variant));
        let passage = all.aim.passage_part(&self.task, &all.drafts, reduction, f64::INFINITY).ok();
        polynomials.chain(passage)
    }
}
