//! A task, the whole motion or an arc of it, and all ways of doing it.

use super::candidate::{Asked, Candidate, Found, Way};
use crate::plan::Part;
use crate::plan::aim::Aim;
use crate::plan::form::Variant;
use crate::plan::memo::Memo;
use crate::plan::part::{AllInPieces, Approximations, SLOWNESS};
use crate::plan::reduction::{Origin, Reduction};
use crate::plan::task::Task;
use crate::plan::variables::Variables;
use crate::program::{Builder, Program};
use crate::scene::Scene;
use crate::series::Parity;
use crate::supremum::worst;
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

impl Prospect {
    pub(super) fn new(scene: &Scene, task: Task) -> Self {
        let reductions = task.reductions(scene);
        let approximations = task.aims.iter().map(|aim| Approximations::new(aim, &reductions)).collect();
        let pieces = AllInPieces::all(&task, &reductions);
        let reach = task.reach();
        let reductions = reductions.into_iter().map(|reduction| reduction.reaching(reach)).collect();
        Self { task, approximations, reductions, pieces, found: Memo::default() }
    }

    /// Every combination that might serve.
    pub(super) fn candidates(&self) -> Vec<Candidate<'_>> {
        let Self { task, approximations, reductions, pieces, .. } = self;
        let aims = &task.aims;
        let candidate = |reduction, way, kernels: f64| {
            let cost = skeleton(reduction, aims).cost() + kernels;
            Candidate { prospect: self, reduction, way, cost }
        };
        let polynomials = reductions.iter().filter_map(|reduction| {
            let cheapest = |all: &Approximations| Some(all.variants(reduction).first()?.1);
            let kernels = approximations.iter().map(cheapest).sum::<Option<f64>>()?;
            Some(candidate(reduction, Way::Polynomials, kernels))
        });
        let by_passage = |reduction| {
            let kernels = aims.iter().map(|aim| aim.passage_estimate(task, reduction)).sum();
            let passage = candidate(reduction, Way::Passage, kernels);
            Candidate { cost: SLOWNESS * passage.cost, ..passage }
        };
        let passages = reductions.iter().filter(|reduction| task.passage_by(reduction).is_some()).map(by_passage);
        let in_pieces = pieces.iter().enumerate().flat_map(|(index, pieces)| {
            let one = move |reduction| {
                let cost = pieces.estimate(aims, reduction)?;
                Some(Candidate { prospect: self, reduction, way: Way::Pieces(index), cost })
            };
            pieces.reductions.iter().filter_map(one)
        });
        polynomials.chain(passages).chain(in_pieces).collect()
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

/// The reduction and the variables that all kernels have, without any kernel.
pub(super) fn skeleton<'a>(reduction: &Reduction, aims: impl IntoIterator<Item = &'a Aim>) -> Program {
    let odd = aims.into_iter().flat_map(|aim| &aim.curves).any(|curve| curve.parity() == Parity::Odd);
    let mut b = Builder::new(reduction.float);
    let t = b.input();
    let reduction = &reduction.with_signs(odd);
    let phase = reduction.lower(&mut b, t);
    let variables = Variables::lower(&mut b, phase, reduction, odd);
    let distance = (odd && !reduction.leaps()).then_some(variables.distance);
    b.finish([variables.p, variables.magic].into_iter().chain(distance).collect())
}
