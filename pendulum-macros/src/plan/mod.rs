//! [`Scene`] → [`Plan`]: the cheapest program found that provably keeps the promise.

mod aim;
mod alternatives;
mod arc;
mod arcsine;
mod bias;
mod blocks;
mod cosines;
pub(crate) mod curve;
mod estrin;
mod fit;
mod form;
mod harmonics;
pub(crate) mod kernel;
mod memo;
mod met;
mod moebius;
mod moments;
mod paper;
mod part;
mod passage;
mod pieces;
pub(crate) mod polynomial;
mod pulses;
pub(crate) mod reduction;
mod refusal;
mod search;
mod turning;
pub(crate) mod variables;
mod verify;

use crate::exact::Real;
use crate::motion::Regime;
use crate::parse::{Method, Output};
use crate::program::Program;
use crate::scene::{Goal, Scene};
use crate::supremum::worst;
use kernel::Kernel;
use reduction::Reduction;
pub(crate) use refusal::Refusal;

/// What is emitted, and what it promises.
#[derive(Clone, Debug)]
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
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) output: Output,
    pub(crate) kernel: Kernel,
    /// What the kernel is, for the reader.
    pub(crate) description: String,
    pub(crate) bound: Bound,
    /// What an error of 1 in the output's own unit is: 1, ω, ω².
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

impl Part {
    /// The bound of its error, in units of the tolerance.
    pub(crate) fn error(&self) -> f64 {
        self.bound.total() / self.unit
    }
}

impl Bound {
    pub(crate) fn total(self) -> f64 {
        (self.truncation + self.phase + self.evaluation) * (1.0 + 1e-12)
    }
}

/// One emitted function.
#[derive(Clone, Debug)]
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
    let least = if is_of_paper(scene) { f64::INFINITY } else { search::least_error(scene) };
    let (best, full, tol) = match scene.goal {
        Goal::Terms(_) => return planned,
        // It is that of which `best` tells.
        Goal::Full => (best, f64::INFINITY, 0.0),
        // Of an angle that grows without bound, full precision promises what its turns cost.
        Goal::Tolerance(tol) => {
            let full = match cheapest(&Scene { goal: Goal::Full, ..scene.clone() }) {
                Ok(plan) => plan.worst(),
                Err(Refusal::Unreachable { best }) => best,
                Err(_) => f64::INFINITY,
            };
            (best.min(least), full, tol)
        }
    };
    let reached = if best < full { [best, full] } else { [full, best] };
    let offers = reached.into_iter().flat_map(|error| OFFERS.map(|factor| error * factor)).map(three_digits);
    let decades = if is_quick(scene) { 1..10 } else { 1..1 };
    let decades = decades.map(|decade| three_digits(tol.max(scene.float.unit()) * 10f64.powi(decade)));
    let offers: Vec<f64> = offers.chain(decades).filter(|offer| offer.is_finite()).collect();
    let best = first_kept(scene, &offers, least).map_or(f64::INFINITY, |kept| finest(scene, kept));
    // What keeps a finer promise keeps this one: pieces may serve the finer one only.
    if best <= tol { cheapest(&asking(scene, best)) } else { Err(Refusal::Unreachable { best }) }
}

/// Whether plans are found quickly: the paper's methods take a hundred harmonics near the top, and polynomials of several
/// outputs as many terms.
fn is_quick(scene: &Scene) -> bool {
    let one_polynomial = scene.method == Some(Method::Polynomial) && scene.outputs.len() == 1;
    scene.method.is_none() || one_polynomial
}

/// A tolerance that can be promised, and the bound of the plan that promises it.
#[derive(Clone, Copy)]
struct Kept {
    tolerance: f64,
    bound: f64,
}

/// The scene that asks for that tolerance.
fn asking(scene: &Scene, tolerance: f64) -> Scene {
    Scene { goal: Goal::Tolerance(tolerance), ..scene.clone() }
}

/// Asks for another tolerance.
fn kept(scene: &Scene, tolerance: f64) -> Result<Kept, Refusal> {
    let plan = cheapest(&asking(scene, tolerance))?;
    Ok(Kept { tolerance, bound: plan.worst() })
}

/// The first of the tolerances that can be promised; those below what was reached where another was refused come last.
/// Where polynomials take too many points for one, they do for a little more, too. Whatever is asked, `least` is reached.
fn first_kept(scene: &Scene, offers: &[f64], least: f64) -> Option<Kept> {
    let (mut reached, mut hopeless) = (0.0, 0.0);
    let mut unlikely = Vec::new();
    for &offer in offers {
        if offer < hopeless {
            continue;
        }
        if offer < reached {
            unlikely.push(offer);
            continue;
        }
        match kept(scene, offer) {
            Ok(kept) => return Some(kept),
            Err(Refusal::Unreachable { best }) if best.min(least).is_finite() => reached = best.min(least),
            Err(Refusal::Unreachable { .. }) if scene.method == Some(Method::Polynomial) => hopeless = 3.0 * offer,
            Err(_) => {}
        }
    }
    unlikely.into_iter().find_map(|offer| kept(scene, offer).ok())
}

/// The finest that can be promised, too: where a promise leaves more than half, what it takes is asked for; of one output
/// whose plans are quick a fifth less, and then parts as long as these are kept.
fn finest(scene: &Scene, found: Kept) -> f64 {
    let offer = |of: &Kept, part: f64| three_digits(part * of.tolerance.min(1.01 * of.bound));
    let finer = |of: &Kept, part: f64| kept(scene, Some(offer(of, part)).filter(|&offer| offer < of.tolerance)?).ok();
    let half_left = |of: &Kept| if offer(of, 1.0) < 0.5 * of.tolerance { finer(of, 1.0) } else { None };
    let found = last(found, half_left);
    if scene.outputs.len() > 1 || !is_quick(scene) {
        return found.tolerance;
    }
    let found = finer(&found, 1.0).unwrap_or(found);
    let Some(less) = finer(&found, 0.8) else { return found.tolerance };
    [0.03, 0.5, 0.8].into_iter().fold(less, |found, part| last(found, |of| finer(of, part))).tolerance
}

/// What is left when nothing finer is found any more.
fn last(found: Kept, finer: impl Fn(&Kept) -> Option<Kept>) -> Kept {
    std::iter::successors(Some(found), finer).last().unwrap_or(found)
}

/// What an error that was reached, for another goal or by a part of the scene, is multiplied with to be asked for.
const OFFERS: [f64; 5] = [1.01, 1.05, 1.25, 2.0, 4.0];

/// As a message prints it.
fn three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}

pub(crate) fn cheapest(scene: &Scene) -> Result<Plan, Refusal> {
    let plan = match &scene.motion.regime {
        Regime::Swing(swing) if is_of_paper(scene) => {
            paper::plan(scene, swing, scene.method.unwrap_or(Method::Fourier))
        }
        _ => search::plan(scene),
    }?;
    // What overflows where units are far from 1 is known by no bound if it precedes what is given to the analysis.
    let finite = plan.functions.iter().all(|function| function.program.is_finite());
    if finite { Ok(plan) } else { Err(Refusal::Unreachable { best: f64::INFINITY }) }
}

/// Whether it is to be planned by a method of the paper's, or the series of θ.
fn is_of_paper(scene: &Scene) -> bool {
    let forced = scene.method.is_some_and(|method| method != Method::Polynomial);
    matches!(scene.motion.regime, Regime::Swing(_)) && (forced || matches!(scene.goal, Goal::Terms(_)))
}

impl Plan {
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
mod full_precision_tests;
#[cfg(test)]
mod random_tests;
#[cfg(test)]
pub(crate) mod tests;
#[cfg(test)]
mod truth;
