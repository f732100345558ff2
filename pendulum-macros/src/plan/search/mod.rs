//! The cheapest plan: every reduction, with polynomials, in pieces or with the passage through the lowest point, in the
//! order of their estimated cost, until one keeps the promise.

mod choice;
mod together;

use super::aim::Aim;
use super::curve::Curve;
use super::form::Variant;
use super::memo::Memo;
use super::part::{Approximations, InPieces, observed};
use super::reduction::{Origin, Reduction};
use super::task::Task;
use super::variables::Variables;
use super::{Part, Plan, Refusal, alternatives, verify};
use crate::parse::Float;
use crate::program::{Builder, Program};
use crate::scene::{Goal, Scene};
use crate::series::Parity;
use crate::supremum::worst;
use choice::{Choice, comfortable, tolerable};
use std::rc::Rc;

/// A task, and what all ways of doing it share.
struct Prospect {
    task: Task,
    approximations: Vec<Approximations>,
    reductions: Vec<Reduction>,
    /// Few pieces first.
    pieces: Vec<InPieces>,
    /// What polynomials gave: more than one candidate may ask.
    found: Memo<Asked, Rc<Found>>,
}

/// What polynomials are asked for: an output, by its number, that takes at most such a part of its limit.
#[derive(PartialEq)]
struct Asked {
    output: usize,
    reduction: Reduction,
    most: f64,
}

/// A variant, what it is estimated to cost, and what it can promise if that was looked at.
struct Tried {
    variant: Variant,
    cost: f64,
    reached: Option<f64>,
}

/// A part and what it costs, or what was reached, and why others lost.
struct Found {
    part: Result<(Part, f64), f64>,
    rejected: Vec<String>,
}

/// The outputs of a candidate, what they cost more than was estimated, and why other forms of them lost.
struct Outputs {
    parts: Vec<Part>,
    more: f64,
    rejected: Vec<String>,
}

/// One way of computing all outputs.
struct Candidate<'a> {
    prospect: &'a Prospect,
    reduction: &'a Reduction,
    way: Way,
    /// Estimated, at most by one term too low.
    cost: f64,
}

/// How the outputs follow from the phase.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// Polynomials, each output by its cheapest variant.
    Polynomials,
    /// The passage through the lowest point.
    Passage,
    /// A polynomial for each of many parts, which are one of those of the prospect.
    Pieces(usize),
}

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
        most_accurate(scene, &Prospect::new(scene, task))
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
    let Chosen { candidate: index, parts, mut rejected } = chosen;
    let candidate = &candidates[index];
    let plan = joined(candidate.reduction, candidate.together(scene, parts, &mut rejected));
    if let Some(output) = verify::broken(scene, &candidate.prospect.task, &plan) {
        return Err(Refusal::Broken { output });
    }
    let next = candidates[index..].iter().find(|next| next.way != candidate.way);
    rejected.extend(next.map(|next| format!("{}: it costs as much as {:.0} additions", next.describe(), next.cost)));
    rejected.extend(alternatives::reasons(scene));
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
    /// Why others lost.
    rejected: Vec<String>,
}

/// The choice, at full precision of those with room for its promise if there are any; or the least that any can promise.
fn choose(scene: &Scene, candidates: &[Candidate]) -> Result<Chosen, f64> {
    let tolerable = match scene.goal {
        Goal::Full => choose_within(scene, candidates, tolerable).ok(),
        _ => None,
    };
    tolerable.map_or_else(|| choose_within(scene, candidates, |_, _| f64::INFINITY), Ok)
}

/// The choice of those that take no more than a part of their limit, or the least that any can promise.
fn choose_within(scene: &Scene, candidates: &[Candidate], most: fn(&Scene, &Reduction) -> f64) -> Result<Chosen, f64> {
    let mut choice = Choice::new();
    let mut lost = Vec::new();
    for (index, candidate) in candidates.iter().enumerate() {
        let Candidate { reduction, cost, .. } = *candidate;
        if choice.is_made(cost) || candidate.is_late(scene) && choice.has_any() {
            break;
        }
        let most = most(scene, reduction).min(choice.most(scene, reduction, cost));
        if lost.iter().any(|lost: &Lost| lost.most >= most && candidate.is_no_finer(lost.candidate)) {
            continue;
        }
        match candidate.outputs(scene, most) {
            Ok(outputs) => {
                let Outputs { parts, more, .. } = &outputs;
                choice.offer(scene, reduction, cost + more, largest_share(parts), (index, outputs));
            }
            Err(reached) => lost.push(Lost { candidate, most, reached }),
        }
    }
    let closest = || lost.iter().map(|lost| lost.reached).fold(f64::INFINITY, f64::min);
    let (candidate, Outputs { parts, mut rejected, .. }) = choice.made().ok_or_else(closest)?;
    let error = worst(parts.iter().map(Part::error));
    let worse = lost.iter().filter(|lost| lost.reached > error);
    let line = |lost: &Lost| format!("{}: it can promise only {:.1e}", lost.candidate.describe(), lost.reached);
    rejected.extend(worse.map(line));
    Ok(Chosen { candidate, parts, rejected })
}

/// A candidate that was asked to take no more than a part of its limits and couldn't.
struct Lost<'a> {
    candidate: &'a Candidate<'a>,
    most: f64,
    reached: f64,
}

/// The share of its limit that the output takes which takes most.
fn largest_share(parts: &[Part]) -> f64 {
    worst(parts.iter().map(|part| part.share))
}

/// The same of a task.
fn most_accurate(scene: &Scene, prospect: &Prospect) -> f64 {
    let Prospect { task, approximations, reductions, .. } = prospect;
    let worst_output = |reduction: &Reduction| {
        let least =
            |all: &Approximations| parts(task, all, reduction).map(|part| part.error()).fold(f64::INFINITY, f64::min);
        worst(approximations.iter().map(least))
    };
    // The most accurate reduction from either origin is among the best.
    let of = |origin: Origin| {
        let from_there = reductions.iter().filter(move |reduction| reduction.origin == origin);
        from_there.min_by(|a, b| (a.error + a.relative_error).total_cmp(&(b.error + b.relative_error)))
    };
    let others = [Origin::Anchor, Origin::Lowest].into_iter().filter_map(of).map(worst_output);
    let in_pieces = prospect.pieces.iter().enumerate().flat_map(|(index, pieces)| {
        let one = move |reduction| {
            let candidate = Candidate { prospect, reduction, way: Way::Pieces(index), cost: 0.0 };
            Some(worst(candidate.outputs(scene, f64::INFINITY).ok()?.parts.iter().map(Part::error)))
        };
        pieces.reductions.iter().filter_map(one)
    });
    others.chain(in_pieces).fold(f64::INFINITY, f64::min)
}

/// An output by every variant, and by the passage where that is to be had, as far as these keep the promise.
fn parts<'a>(task: &'a Task, all: &'a Approximations, reduction: &'a Reduction) -> impl Iterator<Item = Part> + 'a {
    let polynomial = move |variant: Variant| all.part(task, reduction, variant, f64::INFINITY).ok();
    let polynomials = all.variants(reduction).into_iter().filter_map(move |(variant, _)| polynomial(variant));
    let passage = all.aim.passage_part(task, &all.drafts, reduction, f64::INFINITY).ok();
    polynomials.chain(passage)
}

/// For the reader: what costs so many additions more.
fn more(additions: f64) -> String {
    if additions < 0.05 { "costs no less".to_owned() } else { format!("costs about {additions:.1} additions more") }
}

/// All plans of a scene with one output that keep the promise, whatever they cost.
#[cfg(test)]
pub(super) fn every(scene: &Scene) -> Vec<Plan> {
    let every = |task: Task| {
        let Prospect { task, approximations, reductions, .. } = Prospect::new(scene, task);
        let plan = |reduction| {
            let parts = parts(&task, &approximations[0], reduction);
            parts.map(|part| joined(reduction, vec![part])).collect::<Vec<Plan>>()
        };
        reductions.iter().flat_map(plan).collect::<Vec<Plan>>()
    };
    tasks(scene).into_iter().flat_map(every).collect()
}

/// Every combination that might serve, cheapest first.
fn candidates<'a>(scene: &Scene, prospects: &'a [Prospect]) -> Vec<Candidate<'a>> {
    let mut candidates: Vec<Candidate> = prospects.iter().flat_map(|prospect| prospect.candidates(scene)).collect();
    candidates.sort_by(|a, b| a.is_late(scene).cmp(&b.is_late(scene)).then(a.cost.total_cmp(&b.cost)));
    candidates
}

impl Prospect {
    fn new(scene: &Scene, task: Task) -> Self {
        let reductions = task.reductions(scene);
        let approximations = task.aims.iter().map(|aim| Approximations::new(aim, &reductions)).collect();
        let pieces = InPieces::all(&task, &reductions);
        let reach = task.reach();
        let reductions = reductions.into_iter().map(|reduction| reduction.reaching(reach)).collect();
        Self { task, approximations, reductions, pieces, found: Memo::default() }
    }

    fn candidates(&self, scene: &Scene) -> Vec<Candidate<'_>> {
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
        // Its operations wait for one another: each takes longer than those of polynomials do.
        let by_passage = |reduction| {
            let passage = candidate(reduction, Way::Passage, aims.iter().map(Aim::passage_estimate).sum());
            Candidate { cost: waiting(scene.float) * passage.cost, ..passage }
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
}

/// How much longer operations of a passage take than those of polynomials: measured in loops over arrays, without and
/// with AVX2.
fn waiting(float: Float) -> f64 {
    match float {
        Float::F64 => 1.45,
        Float::F32 => 2.1,
    }
}

/// The reduction and the variables that all kernels have, without any kernel.
fn skeleton(reduction: &Reduction, aims: &[Aim]) -> Program {
    let odd = aims.iter().flat_map(|aim| &aim.curves).any(|curve| curve.parity() == Parity::Odd);
    let mut b = Builder::new(reduction.float);
    let t = b.input();
    let phase = reduction.lower(&mut b, t);
    let variables = Variables::lower(&mut b, phase, reduction, odd);
    let distance = (odd && !reduction.leaps()).then_some(variables.distance);
    b.finish([variables.square, variables.magic].into_iter().chain(distance).collect())
}

/// Named by how the first output is computed.
fn joined(reduction: &Reduction, parts: Vec<Part>) -> Plan {
    let (method, terms) = parts.first().map_or(("", 0), |part| (part.kernel.word(), part.kernel.terms()));
    Plan::new(method, terms, reduction, parts)
}

impl Candidate<'_> {
    /// After how many others it is looked at: many pieces, of which the table is large, only where fewer don't serve; and
    /// who asks for a polynomial gets one for each of many parts only where one alone doesn't.
    fn resort(&self, scene: &Scene) -> usize {
        match self.way {
            Way::Pieces(index) => index + usize::from(scene.method.is_some()),
            _ => 0,
        }
    }

    /// Whether it is for where no other serves: at full precision the angle of a rotation is to be as good as it can be where
    /// it is small, if another output can be had from there.
    fn is_late(&self, scene: &Scene) -> bool {
        let angle = scene.outputs.iter().any(|output| output.is_angle());
        let turning = self.prospect.task.turning && scene.goal == Goal::Full && angle;
        turning && self.reduction.origin != Origin::Lowest
    }

    /// For the reader of the docs.
    fn describe(&self) -> String {
        let kernel = match self.way {
            Way::Polynomials => "polynomials",
            Way::Passage => "the passage through the lowest point",
            Way::Pieces(_) => "pieces",
        };
        format!("{kernel}, phase by {}", self.reduction.describe())
    }

    /// Whether it goes the same way as another, with a phase from the same origin in the same unit that is no better.
    fn is_no_finer(&self, other: &Self) -> bool {
        let errors = |reduction: &Reduction| {
            let met = if reduction.grows() { 1.0 / observed(reduction.float) } else { 1.0 };
            let &Reduction { error, relative_error, seldom, .. } = reduction;
            [error, relative_error, met * error - seldom, met * relative_error]
        };
        let kind = |of: &Self| (std::ptr::from_ref(of.prospect), of.way, of.reduction.origin, of.reduction.unit.hi);
        let [own, others] = [self, other].map(|of| errors(of.reduction));
        kind(self) == kind(other) && own.iter().zip(others).all(|(own, other)| *own >= other)
    }

    /// The outputs, each of which takes at most a part of the limit of it, or what was reached.
    fn outputs(&self, scene: &Scene, most: f64) -> Result<Outputs, f64> {
        let Prospect { task, approximations, pieces, .. } = self.prospect;
        if let Way::Pieces(index) = self.way {
            let parts = pieces[index].parts(task, self.reduction, most)?;
            return Ok(Outputs { parts, more: 0.0, rejected: Vec::new() });
        }
        let (mut parts, mut more, mut rejected) = (Vec::new(), 0.0, Vec::new());
        for (output, all) in approximations.iter().enumerate() {
            let passage = || {
                let part = all.aim.passage_part(task, &all.drafts, self.reduction, most)?;
                Ok((part, waiting(scene.float) * all.aim.passage_estimate()))
            };
            let mut polynomials = || {
                let asked = Asked { output, reduction: self.reduction.clone(), most };
                let found = self.prospect.found.get(asked, || Rc::new(self.polynomials(scene, all, most)));
                rejected.extend_from_slice(&found.rejected);
                found.part.clone()
            };
            // What one way can't promise of an output the other may; of all of them it is a candidate of its own.
            let mixed = task.aims.len() > 1;
            let (part, cost) = match self.way {
                Way::Passage if mixed => passage().or_else(|reached| polynomials().map_err(|other| other.min(reached))),
                Way::Passage => passage(),
                _ if mixed => polynomials().or_else(|reached| passage().map_err(|other| other.min(reached))),
                _ => polynomials(),
            }?;
            parts.push(part);
            more += cost - self.estimate(scene, all);
        }
        Ok(Outputs { parts, more, rejected })
    }

    /// What an output was estimated to cost.
    fn estimate(&self, scene: &Scene, all: &Approximations) -> f64 {
        match self.way {
            Way::Passage => waiting(scene.float) * all.aim.passage_estimate(),
            _ => all.variants(self.reduction).first().map_or(0.0, |&(_, cost)| cost),
        }
    }

    /// The output's variant that is taken of those that keep the promise, or what was reached. Those that lost, and the
    /// next, are described.
    fn polynomials(&self, scene: &Scene, all: &Approximations, most: f64) -> Found {
        let mut choice = Choice::new();
        let mut tried = Vec::new();
        for (index, (variant, cost)) in all.variants(self.reduction).into_iter().enumerate() {
            if choice.is_made(cost) {
                tried.push(Tried { variant, cost, reached: None });
                break;
            }
            let most = most.min(choice.most(scene, self.reduction, cost));
            let found = all.part(&self.prospect.task, self.reduction, variant, most);
            let reached = found.as_ref().map_or_else(|&reached| reached, Part::error);
            let real = |part: &Part| all.cost_of(part, self.reduction, variant).max(cost);
            let cost = found.as_ref().map_or(cost, real);
            tried.push(Tried { variant, cost, reached: Some(reached) });
            if let Ok(part) = found {
                choice.offer(scene, self.reduction, cost, part.share, (index, (part, cost)));
            }
        }
        let closest = tried.iter().filter_map(|one| one.reached).fold(f64::INFINITY, f64::min);
        let (chosen, part) = choice.made().map_or((None, Err(closest)), |(index, part)| (Some(index), Ok(part)));
        let error = part.as_ref().map_or(0.0, |(part, _)| part.error());
        let least = chosen.map(|index| tried[index].cost);
        let why = |one: &Tried| match (one.reached, least) {
            (Some(reached), _) if reached.is_infinite() => None,
            (Some(reached), _) if reached >= error => Some(format!("can promise only {reached:.1e}")),
            (_, least) => least.map(|least| more(one.cost - least)),
        };
        let (word, parity) = (all.aim.output.word(), all.aim.curves.first().map_or(Parity::Even, Curve::parity));
        let line = |one: &Tried| Some(format!("{} for `{word}`: it {}", one.variant.describe(parity), why(one)?));
        let lost = tried.iter().enumerate().filter(|&(index, _)| chosen != Some(index));
        let rejected = lost.filter_map(|(_, one)| line(one)).collect();
        Found { part, rejected }
    }
}

#[cfg(test)]
mod tests;
