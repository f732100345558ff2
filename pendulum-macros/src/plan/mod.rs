//! [`Scene`] → [`Plan`]: the cheapest program found that provably keeps the promise.

mod aim;
mod alternatives;
mod arc;
mod arcsine;
mod blocks;
mod conditioning;
mod cosines;
mod curve;
mod estrin;
mod fit;
mod form;
mod harmonics;
mod kernel;
mod memo;
mod met;
mod moebius;
mod observed;
mod offer;
mod paper;
mod part;
mod passage;
mod phases;
mod pieces;
mod polynomial;
mod pulses;
pub(crate) mod reduction;
mod refusal;
mod search;
mod task;
mod turning;
mod variables;
mod verify;

use crate::exact::Real;
use crate::motion::{Regime, Swing};
use crate::parse::{Method, Output};
use crate::program::Program;
use crate::program::rounding::INFLATION;
use crate::scene::{Goal, Scene};
use crate::supremum::worst;
use kernel::Kernel;
use reduction::Reduction;
pub(crate) use refusal::Refusal;
#[cfg(test)]
pub(crate) use turning::is_wrapped;

/// What is emitted, and what it promises.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Plan {
    /// The name of the way it is computed.
    pub(crate) method: &'static str,
    pub(crate) reduction: Reduction,
    pub(crate) parts: Vec<Part>,
    pub(crate) functions: Vec<Function>,
    /// Harmonics of a sum, or terms of the first output's polynomial.
    pub(crate) terms: usize,
    /// The b₂ₙ₋₁ of a plan with the paper's formula, else empty.
    pub(crate) coefficients: Vec<Real>,
    /// The alternatives and why each lost.
    pub(crate) rejected: Vec<String>,
}

/// One output's kernel and its error.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Part {
    pub(crate) output: Output,
    pub(crate) kernel: Kernel,
    /// What the kernel is, for the reader.
    pub(crate) description: String,
    pub(crate) bound: Bound,
    /// What a tolerance of 1 is in the output's own unit: 1, ω, ω².
    pub(crate) unit: f64,
    /// The largest magnitude of the exact output.
    pub(crate) largest: f64,
    /// The share of its limit that the error takes, but for turns that are no part of the promise and for what is hardly ever
    /// met; what is met in full counts more. 0 where there is no limit.
    pub(crate) share: f64,
}

/// A proven bound of the error over the horizon, in the output's unit, and what it is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bound {
    /// The approximation's distance from the curve; with a leeway what it and the phase make together beyond `phase`.
    pub(crate) truncation: f64,
    /// What the error of the phase makes of it.
    pub(crate) phase: f64,
    /// Rounding of coefficients and operations.
    pub(crate) evaluation: f64,
}

/// A bound of which rounding is more than so many times the rest is far above what is seen, as roundings hardly ever add up.
const MOSTLY_ROUNDING: f64 = 1.5;

impl Part {
    /// The bound of its error, in units of the tolerance. A quotient that underflows is rounded up, too.
    pub(crate) fn error(&self) -> f64 {
        self.bound.total() / self.unit + f64::from_bits(1)
    }
}

impl Bound {
    pub(crate) fn total(self) -> f64 {
        (self.truncation + self.phase + self.evaluation) * INFLATION
    }
}

/// One emitted function.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Function {
    /// What it computes; `None` is θ and velocity together.
    pub(crate) output: Option<Output>,
    pub(crate) program: Program,
}

impl Function {
    pub(crate) fn name(&self) -> &'static str {
        self.output.map_or("state", Output::word)
    }
}

/// Plans a scene. Where a goal is out of reach, the best that can be asked for is found by asking.
pub(crate) fn plan(scene: &Scene) -> Result<Plan, Refusal> {
    let planned = cheapest(scene);
    let Err(Refusal::Unreachable { best }) = planned else { return planned };
    if matches!(scene.goal, Goal::Terms(_)) {
        return planned;
    }
    let best = offer::best(scene, best);
    // What keeps a finer promise keeps this one: pieces may serve the finer one only.
    let refused = Refusal::Unreachable { best };
    match scene.goal {
        Goal::Tolerance(tol) if best <= tol => cheapest(&scene.asking(best)),
        Goal::Full if best.is_finite() => {
            let finer = cheapest(&scene.asking(best)).ok();
            finer.filter(|plan| plan.is_full(scene)).ok_or(refused)
        }
        _ => Err(refused),
    }
}

pub(crate) fn cheapest(scene: &Scene) -> Result<Plan, Refusal> {
    let plan = match of_paper(scene) {
        Some((swing, method)) => paper::plan(scene, swing, method),
        None => search::plan(scene),
    }?;
    // What overflows where units are far from 1 is known by no bound if it precedes what is given to the analysis.
    let finite = plan.functions.iter().all(|function| function.program.is_finite());
    if finite { Ok(plan) } else { Err(Refusal::Unreachable { best: f64::INFINITY }) }
}

/// A swing to be planned by a method of the paper's, or the series of θ, and that.
pub(crate) fn of_paper(scene: &Scene) -> Option<(&Swing, Method)> {
    let Regime::Swing(swing) = &scene.motion.regime else { return None };
    match scene.method {
        Some(Method::Polynomial) => None,
        None if matches!(scene.goal, Goal::Terms(_)) => Some((swing, Method::Fourier)),
        method => Some((swing, method?)),
    }
}

impl Plan {
    fn new(method: &'static str, terms: usize, reduction: &Reduction, parts: Vec<Part>) -> Self {
        let functions = kernel::functions(reduction, &parts);
        let (reduction, coefficients, rejected) = (reduction.clone(), Vec::new(), Vec::new());
        Self { method, reduction, parts, functions, terms, coefficients, rejected }
    }

    /// Whether it is within full precision, with no more than half of that to be observed: what is approximated may be in
    /// full, of the rest a part.
    fn is_full(&self, scene: &Scene) -> bool {
        let full = aim::FULL * scene.float.rounding_unit();
        self.parts.iter().all(|part| {
            let seldom = (1.0 - observed::observed(scene.float)) * (part.bound.total() - part.bound.truncation);
            part.bound.total() <= full * part.largest && part.bound.total() - seldom <= 0.5 * full * part.largest
        })
    }

    /// The largest of the outputs' bounds, in units of the tolerance.
    pub(crate) fn worst(&self) -> f64 {
        worst(self.parts.iter().map(Part::error))
    }

    /// Estimated cost of all functions, in loops over arrays, calls and chains of calls.
    fn cost(&self) -> f64 {
        self.functions.iter().map(|function| function.program.cost_of_calls_too()).sum()
    }

    /// Operations of the first function.
    pub(crate) fn operations(&self) -> usize {
        self.functions.first().map_or(0, |function| function.program.operations())
    }
}

#[cfg(test)]
pub(crate) mod tests;
