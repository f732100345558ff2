//! The cheapest plan: every reduction, with polynomials or the passage through the lowest point, in the order of their
//! estimated cost, until one keeps the promise.

use super::aim::{Aim, Task};
use super::part::{Approximations, Variant};
use super::reduction::{Origin, Reduction};
use super::variables::Variables;
use super::{Part, Plan, Refusal, alternatives, kernel, verify};
use crate::parse::Output;
use crate::program::{Builder, Program};
use crate::scene::{Goal, Scene};
use crate::series::Parity;

/// One way of computing all outputs.
struct Candidate<'a> {
    reduction: &'a Reduction,
    way: Way,
    /// Estimated; no less than a term too low.
    cost: f64,
}

/// The part of 2⁻⁴⁹ (2⁻²⁰) that leaves room for what is observed to stay below half of that: of a billion times in
/// `f64` the worst has been up to 0.63 of what is proven, of all times in `f32`, whose phases are rounded less often,
/// 0.79. Who asks for full precision wants it, rather than the last twentieth of the cost.
const COMFORTABLE: f64 = 0.62;

/// How the outputs follow from the phase.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// Polynomials, each output by its cheapest variant.
    Polynomials,
    /// The passage through the lowest point.
    Passage,
}

/// The cheapest plan.
pub(super) fn plan(scene: &Scene) -> Result<Plan, Refusal> {
    let mut task = Task::new(scene);
    match (cheapest(scene, &task), scene.goal) {
        // The best that can be promised is what full precision promises.
        (Err(Refusal::Unreachable { best }), Goal::Tolerance(_)) => {
            task.aims.iter_mut().for_each(|aim| aim.at_full_precision(scene.float));
            Err(Refusal::Unreachable { best: best.min(most_accurate(scene, &task)) })
        }
        (result, _) => result,
    }
}

fn cheapest(scene: &Scene, task: &Task) -> Result<Plan, Refusal> {
    let approximations: Vec<Approximations> = task.aims.iter().map(Approximations::new).collect();
    let reductions = task.reductions(scene);
    let mut closest = f64::INFINITY;
    let mut rejected = Vec::new();
    let candidates = candidates(scene, &reductions, task, &approximations);
    let mut best: Option<(f64, usize, Plan)> = None;
    for (index, candidate) in candidates.iter().enumerate() {
        match candidate.plan(scene, task, &approximations) {
            Ok(plan) => {
                let part = task.part_of_limits(scene, &plan);
                if best.as_ref().is_none_or(|(least, ..)| part < *least) {
                    best = Some((part, index, plan));
                }
                if part <= comfortable(scene) {
                    break;
                }
            }
            Err(reached) => {
                closest = closest.min(reached);
                rejected.push(format!("{}: it can promise only {reached:.1e}", candidate.describe()));
            }
        }
    }
    let (_, index, plan) = best.ok_or(Refusal::Unreachable { best: closest })?;
    if let Some(output) = verify::broken(scene, task, &plan) {
        return Err(Refusal::Broken { output });
    }
    let next = candidates[index..].iter().find(|next| next.way != candidates[index].way);
    rejected.extend(next.map(|next| format!("{}: it costs about {:.0} operations", next.describe(), next.cost)));
    rejected.extend(alternatives::costs(scene, candidates[index].reduction));
    let rejected = plan.rejected.iter().cloned().chain(rejected).collect();
    Ok(Plan { rejected, ..plan })
}

/// The part of its limits that a plan had better keep.
fn comfortable(scene: &Scene) -> f64 {
    if scene.goal == Goal::Full { COMFORTABLE } else { 1.0 }
}

/// The least that can be promised of the worst output.
fn most_accurate(scene: &Scene, task: &Task) -> f64 {
    let worst_output = |reduction: &Reduction| {
        let least = |aim: &Aim| {
            let all = Approximations::new(aim);
            let polynomial =
                |variant: Variant| aim.part(scene, task, all.choose(variant.divided), reduction, variant.form).ok();
            let parts = aim.variants(&all, reduction).into_iter().filter_map(|(variant, _)| polynomial(variant));
            let passage = task.passage.as_ref().filter(|_| reduction.origin == Origin::Lowest);
            let passage = passage.and_then(|passage| aim.passage_part(scene, task, reduction, passage).ok());
            parts.chain(passage).map(|part| part.bound.total() / part.unit).fold(f64::INFINITY, f64::min)
        };
        task.aims.iter().map(least).fold(0.0, f64::max)
    };
    // The most accurate reduction from either origin is among the best.
    let reductions = task.reductions(scene);
    let of = |origin: Origin| {
        let from_there = reductions.iter().filter(move |reduction| reduction.origin == origin);
        from_there.min_by(|a, b| (a.error + a.relative_error).total_cmp(&(b.error + b.relative_error)))
    };
    [Origin::Anchor, Origin::Lowest].into_iter().filter_map(of).map(worst_output).fold(f64::INFINITY, f64::min)
}

/// All plans of a scene with one output that keep the promise, whatever they cost.
#[cfg(test)]
pub(super) fn every(scene: &Scene) -> Vec<Plan> {
    let task = Task::new(scene);
    let (aim, all) = (&task.aims[0], &Approximations::new(&task.aims[0]));
    let reductions = task.reductions(scene);
    let plans = reductions.iter().flat_map(|reduction| {
        let polynomial = |(variant, _): (Variant, f64)| {
            let part = aim.part(scene, &task, all.choose(variant.divided), reduction, variant.form).ok()?;
            Some((Way::Polynomials, part))
        };
        let passage = task.passage.as_ref().filter(|_| reduction.origin == Origin::Lowest);
        let passage = passage.and_then(|passage| aim.passage_part(scene, &task, reduction, passage).ok());
        let parts = aim.variants(all, reduction).into_iter().filter_map(polynomial);
        let parts: Vec<_> = parts.chain(passage.map(|part| (Way::Passage, part))).collect();
        parts.into_iter().map(|(way, part)| way.plan(reduction, vec![part], Vec::new()))
    });
    plans.collect()
}

/// Every combination that might serve, cheapest first.
fn candidates<'a>(
    scene: &Scene,
    reductions: &'a [Reduction],
    task: &Task,
    approximations: &[Approximations],
) -> Vec<Candidate<'a>> {
    let mut candidates = Vec::new();
    // At full precision the angle of a rotation is to be as good as it can be where it is small, if another output can
    // be had from there.
    let angle = |aim: &Aim| matches!(aim.output, Output::Theta | Output::Wrapped);
    let from_lowest = task.turning && scene.goal == Goal::Full && task.aims.iter().any(angle);
    for reduction in reductions {
        let cheapest = |(aim, all): (&Aim, &Approximations)| Some(aim.variants(all, reduction).first()?.1);
        if let Some(kernels) = task.aims.iter().zip(approximations).map(cheapest).sum::<Option<f64>>() {
            let cost = skeleton(reduction, &task.aims).cost() + kernels;
            candidates.push(Candidate { reduction, way: Way::Polynomials, cost });
        }
    }
    if task.passage.is_some() && scene.method.is_none() {
        for reduction in reductions.iter().filter(|reduction| reduction.origin == Origin::Lowest) {
            let base = skeleton(reduction, &task.aims).cost();
            let kernels: f64 = task.aims.iter().map(Aim::passage_estimate).sum();
            candidates.push(Candidate { reduction, way: Way::Passage, cost: base + kernels });
        }
    }
    let late = |candidate: &Candidate| from_lowest && candidate.reduction.origin != Origin::Lowest;
    candidates.sort_by(|a, b| late(a).cmp(&late(b)).then(a.cost.total_cmp(&b.cost)));
    candidates
}

/// The reduction and the variables, without any kernel.
fn skeleton(reduction: &Reduction, aims: &[Aim]) -> Program {
    let odd = aims.iter().flat_map(|aim| &aim.curves).any(|curve| curve.parity() == Parity::Odd);
    let mut b = Builder::new(reduction.float);
    let t = b.input();
    let phase = reduction.lower(&mut b, t);
    let variables = Variables::lower(&mut b, phase, reduction, odd);
    b.finish(vec![variables.square, variables.magic])
}

impl Way {
    fn word(self) -> &'static str {
        match self {
            Self::Polynomials => "polynomial",
            Self::Passage => "passage",
        }
    }

    fn plan(self, reduction: &Reduction, parts: Vec<Part>, rejected: Vec<String>) -> Plan {
        let functions = kernel::functions(reduction, &parts);
        let (method, reduction) = (self.word(), reduction.clone());
        Plan { method, reduction, parts, functions, coefficients: Vec::new(), rejected }
    }
}

impl Candidate<'_> {
    /// For the reader of the docs.
    fn describe(&self) -> String {
        let kernel = match self.way {
            Way::Polynomials => "polynomials",
            Way::Passage => "the passage through the lowest point",
        };
        format!("{kernel}, phase by {}", self.reduction.describe())
    }

    fn plan(&self, scene: &Scene, task: &Task, approximations: &[Approximations]) -> Result<Plan, f64> {
        let mut rejected = Vec::new();
        let mut part = |(aim, all): (&Aim, &Approximations)| {
            let passage = || match &task.passage {
                Some(passage) if self.reduction.origin == Origin::Lowest && scene.method.is_none() => {
                    aim.passage_part(scene, task, self.reduction, passage)
                }
                _ => Err(f64::INFINITY),
            };
            let mut polynomials = || self.polynomials(scene, task, aim, all, &mut rejected);
            // What one way can't promise of an output the other may.
            match self.way {
                Way::Polynomials => polynomials().or_else(|reached| passage().map_err(|other| other.min(reached))),
                Way::Passage => passage().or_else(|reached| polynomials().map_err(|other| other.min(reached))),
            }
        };
        let parts = task.aims.iter().zip(approximations).map(&mut part).collect::<Result<Vec<Part>, f64>>()?;
        Ok(self.way.plan(self.reduction, parts, rejected))
    }

    /// The output's cheapest variant that keeps the promise; at full precision comfortably, or else with the least
    /// bound. Those that don't, and the next, are described in `rejected`.
    fn polynomials(
        &self,
        scene: &Scene,
        task: &Task,
        aim: &Aim,
        all: &Approximations,
        rejected: &mut Vec<String>,
    ) -> Result<Part, f64> {
        let mut best: Result<Part, f64> = Err(f64::INFINITY);
        let variants = aim.variants(all, self.reduction);
        let word = aim.output.word();
        for (index, (variant, cost)) in variants.iter().enumerate() {
            let found = aim.part(scene, task, all.choose(variant.divided), self.reduction, variant.form);
            let reached = found.as_ref().map_or_else(|&reached| reached, |part| part.bound.total() / part.unit);
            if found.as_ref().is_ok_and(|part| aim.part_of_limit(scene, part, self.reduction) <= comfortable(scene)) {
                let next = variants.get(index + 1).map(|(next, dearer)| {
                    format!("{} for `{word}`: it costs about {:.1} operations more", next.describe(), dearer - cost)
                });
                rejected.extend(next);
                return found;
            }
            if reached.is_finite() {
                rejected.push(format!("{} for `{word}`: it can promise only {reached:.1e}", variant.describe()));
            }
            best = match (best, found) {
                (Ok(best), Ok(found)) if found.bound.total() < best.bound.total() => Ok(found),
                (Ok(best), _) => Ok(best),
                (Err(_), Ok(found)) => Ok(found),
                (Err(closest), Err(reached)) => Err(closest.min(reached)),
            };
        }
        best
    }
}
