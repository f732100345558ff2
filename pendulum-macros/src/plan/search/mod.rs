//! The cheapest plan: every reduction, with polynomials, in pieces or with the passage through the lowest point, in the
//! order of their estimated cost, until none that is left can be cheaper.

mod candidate;
mod choice;
mod prospect;
mod together;

use super::aim::Aim;
use super::reduction::Reduction;
use super::task::Task;
use super::{Part, Plan, Refusal, alternatives, verify};
use crate::scene::{Goal, Scene};
use crate::supremum::worst;
use candidate::{Candidate, Demand, Failure, Outputs, unfit};
use choice::{Choice, Limits};
use prospect::{Prospect, Rejected};

/// The cheapest plan, or the best that was reached; of several outputs to a tolerance nothing, since what the first came
/// to says nothing of the others.
pub(super) fn plan(scene: &Scene) -> Result<Plan, Refusal> {
    let prospects: Vec<Prospect> = tasks(scene).into_iter().map(|task| Prospect::new(scene, task)).collect();
    cheapest(scene, &prospects).map_err(|refusal| match (refusal, scene.goal) {
        (Refusal::Unreachable { .. }, Goal::Tolerance(_)) if scene.outputs.len() > 1 => {
            Refusal::Unreachable { best: f64::INFINITY }
        }
        (refusal, _) => refusal,
    })
}

/// The least that can be promised of the worst output, whatever it costs.
pub(super) fn least_error(scene: &Scene) -> f64 {
    let least = |mut task: Task| {
        task.aims.iter_mut().for_each(Aim::at_full_precision);
        Prospect::new(scene, task).most_accurate()
    };
    tasks(scene).into_iter().map(least).fold(f64::INFINITY, f64::min)
}

/// The whole motion, and the part of it that a short horizon meets.
fn tasks(scene: &Scene) -> Vec<Task> {
    let whole = Task::new(scene);
    whole.over_arc(scene).into_iter().chain([whole]).collect()
}

fn cheapest(scene: &Scene, prospects: &[Prospect]) -> Result<Plan, Refusal> {
    let candidates = candidates(scene, prospects);
    let (candidates, chosen) = by_resorts(scene, candidates).map_err(|best| Refusal::Unreachable { best })?;
    let Chosen { candidate: index, parts, rejected: mut variants, coarser } = chosen;
    let candidate = &candidates[index];
    let plan = joined(candidate.reduction, candidate.together(scene, parts, &mut variants));
    if let Some(output) = verify::broken(scene, &candidate.prospect.task, &plan) {
        return Err(Refusal::Broken { output });
    }
    let next = candidates[index..].iter().find(|next| next.way != candidate.way);
    let dearer = next.map(|next| {
        let costs = format!("it costs as much as {:.0} additions, this plan as {:.0}", next.cost, candidate.cost);
        format!("{}: {costs}", next.describe())
    });
    let variants = variants.iter().map(Rejected::to_string);
    let rejected = variants.chain(coarser).chain(dearer).chain(alternatives::reasons(scene)).collect();
    Ok(Plan { rejected, ..plan })
}

/// The first of the resorts in which there is a choice, and that; or the least that any can promise.
fn by_resorts<'a>(scene: &Scene, mut all: Vec<Candidate<'a>>) -> Result<(Vec<Candidate<'a>>, Chosen), f64> {
    let mut reached = f64::INFINITY;
    for resort in 0.. {
        let (candidates, later): (Vec<_>, Vec<_>) = all.into_iter().partition(|one| one.resort(scene) == resort);
        match choose(scene, &candidates) {
            Ok(chosen) => return Ok((candidates, chosen)),
            Err(best) => reached = reached.min(best),
        }
        if later.is_empty() {
            break;
        }
        all = later;
    }
    Err(reached)
}

/// What is to become a plan.
struct Chosen {
    candidate: usize,
    parts: Vec<Part>,
    /// Why other variants of its outputs lost.
    rejected: Vec<Rejected>,
    /// Other candidates, which can't promise as much.
    coarser: Vec<String>,
}

/// The choice, at full precision of those with room for its promise if there are any; or the least that any can promise.
fn choose(scene: &Scene, candidates: &[Candidate]) -> Result<Chosen, f64> {
    let tolerable = match scene.goal {
        Goal::Full => choose_within(scene, candidates, |limits| limits.tolerable).ok(),
        _ => None,
    };
    tolerable.map_or_else(|| choose_within(scene, candidates, |_| f64::INFINITY), Ok)
}

/// The choice of those that take no more than a part of their limit, or the least that any can promise.
fn choose_within(scene: &Scene, candidates: &[Candidate], most: fn(Limits) -> f64) -> Result<Chosen, f64> {
    let mut choice = Choice::new();
    let mut lost = Vec::new();
    for (index, candidate) in candidates.iter().enumerate() {
        let Candidate { reduction, cost, .. } = *candidate;
        let dear = choice.dear();
        if cost >= dear || candidate.is_late(scene) && choice.has_room() {
            break;
        }
        let limits = Limits::of(scene.goal, reduction);
        let most = most(limits).min(choice.most(limits, cost));
        if lost.iter().any(|lost: &Lost| lost.most >= most && candidate.is_no_finer(lost.candidate)) {
            continue;
        }
        // What the last couldn't give the next is asked for first.
        let hardest = lost.last().map_or(0, |lost| lost.output);
        match candidate.outputs(scene, Demand { most, dear, hardest }) {
            Ok(outputs) => {
                let Outputs { parts, more, .. } = &outputs;
                choice.offer(limits, cost + more, largest_share(parts), (index, outputs));
            }
            Err(Failure::Dear) => {}
            Err(Failure::Unreached { output, reached }) => lost.push(Lost { candidate, most, output, reached }),
        }
    }
    let closest = || lost.iter().map(|lost| lost.reached).fold(f64::INFINITY, f64::min);
    let (candidate, Outputs { parts, rejected, .. }) = choice.made().ok_or_else(closest)?;
    let error = worst(parts.iter().map(Part::error));
    let worse = lost.iter().filter(|lost| lost.reached > error);
    let line = |Lost { candidate, output, reached, .. }: &Lost| {
        format!("{}: it {}", candidate.describe(), unfit(*reached, &candidate.prospect.approximations[*output].aim))
    };
    let coarser = worse.map(line).collect();
    Ok(Chosen { candidate, parts, rejected, coarser })
}

/// A candidate that was asked to take no more than a part of its limits and couldn't.
struct Lost<'a> {
    candidate: &'a Candidate<'a>,
    most: f64,
    output: usize,
    reached: f64,
}

/// The share of its limit that the output takes which takes most.
fn largest_share(parts: &[Part]) -> f64 {
    worst(parts.iter().map(|part| part.share))
}

/// All plans of a scene with one output that keep the promise, whatever they cost.
#[cfg(test)]
pub(super) fn every(scene: &Scene) -> Vec<Plan> {
    let every = |task: Task| {
        let prospect = Prospect::new(scene, task);
        let plan = |reduction| {
            let parts = prospect.parts(&prospect.approximations[0], reduction);
            parts.map(|part| joined(reduction, vec![part])).collect::<Vec<Plan>>()
        };
        prospect.reductions.iter().flat_map(plan).collect::<Vec<Plan>>()
    };
    tasks(scene).into_iter().flat_map(every).collect()
}

/// Every combination that might serve, cheapest first.
fn candidates<'a>(scene: &Scene, prospects: &'a [Prospect]) -> Vec<Candidate<'a>> {
    let mut candidates: Vec<Candidate> = prospects.iter().flat_map(Candidate::all).collect();
    candidates.sort_by(|a, b| a.is_late(scene).cmp(&b.is_late(scene)).then(a.cost.total_cmp(&b.cost)));
    candidates
}

/// Named by how the first output is computed.
fn joined(reduction: &Reduction, parts: Vec<Part>) -> Plan {
    let (method, terms) = parts.first().map_or(("", 0), |part| (part.kernel.core.word(), part.kernel.core.terms()));
    Plan::new(method, terms, reduction, parts)
}

#[cfg(test)]
mod tests;
