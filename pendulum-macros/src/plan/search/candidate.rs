//! One way of computing all outputs: a reduction, and polynomials, pieces or the passage.

use super::choice::{Choice, Limits};
use super::prospect::{Asked, Found, Prospect, Rejected};
use crate::decimals::at_least;
use crate::plan::Part;
use crate::plan::aim::Aim;
use crate::plan::curve::Curve;
use crate::plan::form::Variant;
use crate::plan::kernel;
use crate::plan::observed::observed;
use crate::plan::part::{Approximations, SLOWNESS};
use crate::plan::reduction::{Origin, Reduction};
use crate::plan::turning::Start;
use crate::plan::variables::Variables;
use crate::program::{Builder, Program};
use crate::scene::{Goal, Scene};
use crate::series::Parity;
use std::iter;
use std::rc::Rc;

/// A variant, what it is estimated to cost, and what it can promise if that was looked at.
struct Tried {
    variant: Variant,
    cost: f64,
    reached: Option<f64>,
}

/// The outputs of a candidate, what they cost more than was estimated, and why other forms of them lost.
#[derive(Default)]
pub(super) struct Outputs {
    pub(super) parts: Vec<Part>,
    pub(super) more: f64,
    pub(super) rejected: Vec<Rejected>,
}

impl Outputs {
    fn and(mut self, others: Self) -> Self {
        self.parts.extend(others.parts);
        self.more += others.more;
        self.rejected.extend(others.rejected);
        self
    }
}

/// What is asked of a candidate.
#[derive(Clone, Copy)]
pub(super) struct Demand {
    /// The part of its limit that each output takes at most.
    pub(super) most: f64,
    /// What is too much for it to cost.
    pub(super) dear: f64,
    /// The output, by its number, that is likely not to be had: it is looked at first.
    pub(super) hardest: usize,
}

/// Why a candidate isn't taken.
pub(super) enum Failure {
    /// An output, by its number, takes more than was asked for, and what was reached.
    Unreached { output: usize, reached: f64 },
    /// It costs too much.
    Dear,
}

/// One way of computing all outputs.
pub(super) struct Candidate<'a> {
    pub(super) prospect: &'a Prospect,
    pub(super) reduction: &'a Reduction,
    pub(super) way: Way,
    /// Estimated, at most by one term too low.
    pub(super) cost: f64,
}

/// How the outputs follow from the phase.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Way {
    /// Polynomials, each output by its cheapest variant.
    Polynomials,
    /// The passage through the lowest point.
    Passage,
    /// A polynomial for each of many pieces, in one of the numbers of the prospect.
    Pieces(usize),
}

impl<'a> Candidate<'a> {
    /// Every combination that might serve.
    pub(super) fn all(prospect: &'a Prospect) -> Vec<Self> {
        let Prospect { task, approximations, reductions, pieces, .. } = prospect;
        let aims = &task.aims;
        let candidate = |reduction, way, kernels: f64| {
            let start = |aim: &Aim| if way == Way::Passage { Start::Lowest } else { Start::Top(aim.size) };
            let finishes: f64 = aims.iter().map(|aim| aim.cost_of_finish(task, reduction, start(aim))).sum();
            Self { prospect, reduction, way, cost: skeleton(reduction, aims).cost() + kernels + finishes }
        };
        let polynomials = reductions.iter().filter_map(|reduction| {
            let cheapest = |all: &Approximations| Some(all.variants(reduction).first()?.1);
            let kernels = approximations.iter().map(cheapest).sum::<Option<f64>>()?;
            Some(candidate(reduction, Way::Polynomials, kernels))
        });
        let by_passage = |reduction| {
            let kernels = aims.iter().map(|aim| aim.passage_estimate(task, reduction)).sum();
            let passage = candidate(reduction, Way::Passage, kernels);
            Self { cost: SLOWNESS * passage.cost, ..passage }
        };
        let passages = reductions.iter().filter(|reduction| task.passage_by(reduction).is_some()).map(by_passage);
        let in_pieces = pieces.iter().enumerate().flat_map(|(index, pieces)| {
            let one = move |reduction| {
                let cost = pieces.estimate(task, reduction)?;
                Some(Self { prospect, reduction, way: Way::Pieces(index), cost })
            };
            pieces.reductions.iter().filter_map(one)
        });
        polynomials.chain(passages).chain(in_pieces).collect()
    }

    /// After how many others it is looked at: many pieces, of which the table is large, only where fewer don't serve; and
    /// who asks for a polynomial gets one for each of many pieces only where one alone doesn't.
    pub(super) fn resort(&self, scene: &Scene) -> usize {
        match self.way {
            Way::Pieces(index) => index + usize::from(scene.method.is_some()),
            _ => 0,
        }
    }

    /// Whether it is for where no other leaves room for the promise: at full precision the angle of a rotation is to be as
    /// good as it can be where it is small, if all outputs can be had from there.
    pub(super) fn is_late(&self, scene: &Scene) -> bool {
        let angle = scene.outputs.iter().any(|output| output.is_angle());
        let turning = self.prospect.task.turns_over() && scene.goal == Goal::Full && angle;
        turning && self.reduction.origin != Origin::Lowest
    }

    /// For the reader of the docs.
    pub(super) fn describe(&self) -> String {
        let kernel = match self.way {
            Way::Polynomials => "polynomials",
            Way::Passage => "the passage through the lowest point",
            Way::Pieces(_) => "pieces",
        };
        format!("{kernel}, phase by {}", self.reduction.describe())
    }

    /// Whether it goes the same way as another, with a phase from the same origin in the same unit that is no better.
    pub(super) fn is_no_finer(&self, other: &Self) -> bool {
        let errors = |reduction: &Reduction| {
            let met = if reduction.grows() { 1.0 / observed(reduction.float) } else { 1.0 };
            let &Reduction { error, relative_error, seldom, .. } = reduction;
            [error, relative_error, met * error - seldom, met * relative_error]
        };
        let kind = |of: &Self| (std::ptr::from_ref(of.prospect), of.way, of.reduction.origin, of.reduction.unit.hi);
        let [own, others] = [self, other].map(|of| errors(of.reduction));
        kind(self) == kind(other) && own.iter().zip(others).all(|(own, other)| *own >= other)
    }

    /// The outputs, or the first reason not to take them.
    pub(super) fn outputs(&self, scene: &Scene, demand: Demand) -> Result<Outputs, Failure> {
        let Demand { most, dear, hardest } = demand;
        let Prospect { task, approximations, pieces, .. } = self.prospect;
        if let Way::Pieces(index) = self.way {
            let parts = pieces[index].parts(task, self.reduction, most);
            // It isn't told of which.
            let parts = parts.map_err(|reached| Failure::Unreached { output: hardest, reached })?;
            return Ok(Outputs { parts, ..Outputs::default() });
        }
        let others = (0..approximations.len()).filter(|&output| output != hardest);
        let (mut ones, mut more) = (Vec::new(), 0.0);
        for output in iter::once(hardest).chain(others) {
            let one = self.output(scene, output, most).map_err(|reached| Failure::Unreached { output, reached })?;
            more += one.more;
            ones.push((output, one));
            // Hardly any output costs less than was estimated.
            if self.cost + more >= dear {
                return Err(Failure::Dear);
            }
        }
        ones.sort_by_key(|&(output, _)| output);
        let ones = ones.into_iter().map(|(_, one)| one);
        Ok(ones.fold(Outputs::default(), Outputs::and))
    }

    /// One of them alone, or what was reached.
    fn output(&self, scene: &Scene, output: usize, most: f64) -> Result<Outputs, f64> {
        let Prospect { task, approximations, found, .. } = self.prospect;
        let all = &approximations[output];
        let mut rejected = Vec::new();
        let passage = || {
            let part = all.aim.passage_part(task, &all.drafts, self.reduction, most)?;
            let operations = kernel::function(self.reduction, &[&part.kernel]).cost();
            let finish = all.aim.cost_of_finish(task, self.reduction, Start::Lowest);
            let cost = SLOWNESS * (operations - finish - skeleton(self.reduction, [&all.aim]).cost());
            Ok((part, cost))
        };
        let mut polynomials = || {
            let asked = Asked { output, reduction: self.reduction.clone(), most };
            let found = found.get(asked, || Rc::new(self.polynomials(scene, all, most)));
            rejected.extend_from_slice(&found.rejected);
            found.part.clone()
        };
        // What one way can't promise of an output the other may; of all of them it is a candidate of its own.
        let mixed = approximations.len() > 1;
        let (part, cost) = match self.way {
            Way::Passage if mixed => passage().or_else(|reached| polynomials().map_err(|other| other.min(reached))),
            Way::Passage => passage(),
            _ if mixed => polynomials().or_else(|reached| passage().map_err(|other| other.min(reached))),
            _ => polynomials(),
        }?;
        Ok(Outputs { parts: vec![part], more: cost - self.estimate(all), rejected })
    }

    /// What an output was estimated to cost.
    fn estimate(&self, all: &Approximations) -> f64 {
        match self.way {
            Way::Passage => SLOWNESS * all.aim.passage_estimate(&self.prospect.task, self.reduction),
            _ => all.variants(self.reduction).first().map_or(0.0, |&(_, cost)| cost),
        }
    }

    /// The output's variant that is taken of those that keep the promise, or what was reached. Those that lost, and the
    /// next, are described.
    fn polynomials(&self, scene: &Scene, all: &Approximations, most: f64) -> Found {
        let limits = Limits::of(scene.goal, self.reduction);
        let mut choice = Choice::new();
        let mut tried = Vec::new();
        for (index, (variant, cost)) in all.variants(self.reduction).into_iter().enumerate() {
            if cost >= choice.dear() {
                tried.push(Tried { variant, cost, reached: None });
                break;
            }
            let most = most.min(choice.most(limits, cost));
            let found = all.part(&self.prospect.task, self.reduction, variant, most);
            let reached = found.as_ref().map_or_else(|&reached| reached, Part::error);
            let real = |part: &Part| all.cost_of(part, self.reduction, variant).max(cost);
            let cost = found.as_ref().map_or(cost, real);
            tried.push(Tried { variant, cost, reached: Some(reached) });
            if let Ok(part) = found {
                choice.offer(limits, cost, part.share, (index, (part, cost)));
            }
        }
        let closest = tried.iter().filter_map(|one| one.reached).fold(f64::INFINITY, f64::min);
        let (chosen, part) = choice.made().map_or((None, Err(closest)), |(index, part)| (Some(index), Ok(part)));
        let least = chosen.map(|index| tried[index].cost);
        let why = |one: &Tried| match (one.reached, least) {
            (Some(reached), _) if reached.is_infinite() => None,
            // If it is cheaper, it isn't the one for what it leaves of its limit: see [`Choice`].
            (Some(reached), least) if !all.aim.is_within(reached) || least.is_some_and(|least| one.cost < least) => {
                Some(unfit(reached, &all.aim))
            }
            (_, least) => least.map(|least| more(one.cost - least)),
        };
        let (output, parity) = (all.aim.output, all.aim.curves.first().map_or(Parity::Even, Curve::parity));
        let lost = tried.iter().enumerate().filter(|&(index, _)| chosen != Some(index));
        let rejected = lost.filter_map(|(_, one)| {
            Some(Rejected { output, variant: one.variant, parity, why: format!("it {}", why(one)?) })
        });
        let rejected = rejected.collect();
        Found { part, rejected }
    }
}

/// The reduction and the variables that all kernels have, without any kernel.
fn skeleton<'a>(reduction: &Reduction, aims: impl IntoIterator<Item = &'a Aim>) -> Program {
    let odd = aims.into_iter().flat_map(|aim| &aim.curves).any(|curve| curve.parity() == Parity::Odd);
    let mut b = Builder::new(reduction.float);
    let t = b.input();
    let reduction = &reduction.with_signs(odd);
    let phase = reduction.lower(&mut b, t);
    let variables = Variables::lower(&mut b, phase, reduction, odd);
    let distance = (odd && !reduction.leaps()).then_some(variables.distance);
    b.finish([variables.p, variables.magic].into_iter().chain(distance).collect())
}

/// For the reader: why what came to `reached`, in units of the tolerance, isn't taken. Within the limit that is for being
/// mostly rounding, or since full precision asks for room.
pub(super) fn unfit(reached: f64, aim: &Aim) -> String {
    match aim.goal {
        _ if !aim.is_within(reached) => format!("can promise no better than {}", at_least(reached, 1)),
        Goal::Tolerance(_) => "is rounded by too much".to_owned(),
        _ => "leaves less room".to_owned(),
    }
}

/// For the reader: what costs so many additions more.
pub(super) fn more(additions: f64) -> String {
    match additions {
        ..0.05 => "costs no less".to_owned(),
        0.05..0.95 => format!("costs {additions:.1} additions more"),
        0.95..1.05 => "costs 1 addition more".to_owned(),
        _ => format!("costs {} additions more", (10.0 * additions).round() / 10.0),
    }
}
