//! [`Scene`] → [`Plan`]: the cheapest program found that provably keeps the promise.

mod adapted;
mod aim;
mod alternatives;
mod arcsine;
pub(crate) mod curve;
mod fit;
mod form;
mod harmonics;
mod hyperbolic;
pub(crate) mod kernel;
mod paper;
mod part;
pub(crate) mod polynomial;
pub(crate) mod reduction;
mod search;
mod turning;
pub(crate) mod variables;
mod velocity_bias;
mod verify;

use crate::exact::Real;
use crate::motion::Regime;
use crate::parse::{Method, Output};
use crate::program::Program;
use crate::scene::{Goal, Scene};
use kernel::Kernel;
use reduction::Reduction;

/// What is emitted, and what it promises.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    /// The name of the way it is computed.
    pub(crate) method: &'static str,
    pub(crate) reduction: Reduction,
    pub(crate) parts: Vec<Part>,
    pub(crate) functions: Vec<Function>,
    /// The b₂ₙ₋₁ of a plan with the paper's formula, else empty.
    pub(crate) coefficients: Vec<Real>,
    /// The alternatives and why each lost.
    pub(crate) rejected: Vec<String>,
}

/// One output's polynomials and its error.
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
}

/// A proven bound of the error over the horizon, in the output's unit, and what it is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bound {
    /// The approximation's distance from the curve.
    pub(crate) truncation: f64,
    /// What the error of the phase makes of it.
    pub(crate) phase: f64,
    /// Rounding of coefficients and operations.
    pub(crate) evaluation: f64,
}

impl Bound {
    pub(crate) fn total(self) -> f64 {
        (self.truncation + self.phase + self.evaluation) * (1.0 + 1e-12)
    }
}

/// One emitted function.
#[derive(Clone, Debug)]
pub(crate) struct Function {
    pub(crate) name: &'static str,
    pub(crate) program: Program,
}

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Refusal {
    /// No plan reaches the tolerance; the best promises this.
    Unreachable { best: f64 },
    /// The argument of the paper's arcsine exceeds 1 by this; the smallest number of terms that works, if any does.
    Overshoot { terms: usize, overshoot: f64, smallest: Option<usize> },
    /// The planner saw its own promise broken.
    Broken { output: Output },
    /// The method doesn't give this output.
    Output { method: Method, output: Output },
}

impl Refusal {
    /// The error at the token to blame.
    pub(crate) fn explain(&self, scene: &Scene) -> syn::Error {
        let blame = &scene.blame;
        let float = scene.float.word();
        match self {
            Self::Unreachable { best } => {
                let asked = match scene.goal {
                    Goal::Tolerance(_) => format!("`tol = {}` is", blame.goal),
                    _ => format!("the full precision of `{float}` is"),
                };
                let remedy = match scene.goal {
                    Goal::Tolerance(_) => "ask for that, or leave `tol` out for full precision",
                    _ => "state it, or more, as `tol`",
                };
                if best.is_infinite() {
                    let remedy = match scene.method {
                        Some(method) => format!("with `method = {}`: leave `method` out", method.word()),
                        None => "here: choose numbers nearer to 1, or fewer outputs".to_owned(),
                    };
                    let message = format!("{asked} more than can be promised {remedy}");
                    return syn::Error::new_spanned(&blame.goal, message);
                }
                let message = format!("{asked} more than can be promised here: the best is {best:.2e}; {remedy}");
                syn::Error::new_spanned(&blame.goal, message)
            }
            Self::Overshoot { smallest: None, .. } if !matches!(scene.goal, Goal::Terms(_)) => {
                let message = "`fourier` can't come near the motion at this amplitude: with as many terms as can be used \
                               the argument of the arcsine in Eq. 22 still exceeds 1; leave `method` out";
                syn::Error::new_spanned(&blame.method, message)
            }
            Self::Overshoot { terms, overshoot, smallest } => {
                let remedy = smallest.map_or_else(
                    || format!("no number of terms that `{float}` can use works: state the error as `tol` instead"),
                    |smallest| format!("the smallest number of terms that works is `n = {smallest}`"),
                );
                let asked =
                    if let Goal::Terms(_) = scene.goal { format!("`n = {terms}`") } else { format!("{terms} terms") };
                let message = format!(
                    "{asked}: the argument of the arcsine in Eq. 22 exceeds 1 by {overshoot:.2e} at this amplitude, \
                     where θ̂ would be NaN; {remedy}"
                );
                syn::Error::new_spanned(&blame.goal, message)
            }
            Self::Broken { output } => syn::Error::new_spanned(
                &blame.start,
                format!(
                    "the plan for `{}` misses its own error bound here: this is a bug of pendula; please report the invocation, \
                     and try another `tol` until it is mended",
                    output.word()
                ),
            ),
            Self::Output { method, output } => syn::Error::new_spanned(
                &blame.method,
                format!(
                    "`{}` gives θ and its derivative, not `{}`: use `method = polynomial`, or leave `method` out",
                    method.word(),
                    output.word()
                ),
            ),
        }
    }
}

/// Plans a scene. Where a tolerance is out of reach, the best that can be asked for is found by asking.
pub(crate) fn plan(scene: &Scene) -> Result<Plan, Refusal> {
    let planned = cheapest(scene);
    let (Err(Refusal::Unreachable { best }), Goal::Tolerance(tol)) = (&planned, scene.goal) else { return planned };
    let kept =
        |offer: &f64| offer.is_finite() && cheapest(&Scene { goal: Goal::Tolerance(*offer), ..scene.clone() }).is_ok();
    // Of an angle that grows without bound, full precision promises what its turns cost.
    let full = cheapest(&Scene { goal: Goal::Full, ..scene.clone() }).map_or(f64::INFINITY, |plan| plan.worst());
    let reached = if *best < full { [*best, full] } else { [full, *best] };
    let offers = reached.into_iter().flat_map(|error| OFFERS.map(|factor| error * factor)).map(three_digits);
    // A forced method is refused as such.
    let decades = if scene.method.is_some() { 1..1 } else { 1..10 };
    let decades = decades.map(|decade| three_digits(tol.max(scene.float.unit()) * 10f64.powi(decade)));
    let mut offers = offers.chain(decades);
    Err(Refusal::Unreachable { best: offers.find(kept).unwrap_or(f64::INFINITY) })
}

/// What an error that was reached, for another goal or by a part of the scene, is multiplied with to be asked for.
const OFFERS: [f64; 5] = [1.01, 1.05, 1.25, 2.0, 4.0];

/// As a message prints it.
fn three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}

pub(crate) fn cheapest(scene: &Scene) -> Result<Plan, Refusal> {
    match (&scene.motion.regime, scene.method, scene.goal) {
        (Regime::Swing(swing), Some(method), _) if method != Method::Polynomial => paper::plan(scene, swing, method),
        (Regime::Swing(swing), _, Goal::Terms(_)) => paper::plan(scene, swing, Method::Fourier),
        _ => search::plan(scene),
    }
}

impl Plan {
    /// The largest of the outputs' bounds, in units of the tolerance.
    pub(crate) fn worst(&self) -> f64 {
        self.parts.iter().map(|part| part.bound.total() / part.unit).fold(0.0, f64::max)
    }

    /// Operations of the first function.
    pub(crate) fn operations(&self) -> usize {
        self.functions.first().map_or(0, |function| function.program.operations())
    }

    /// Terms of the first output.
    pub(crate) fn terms(&self) -> usize {
        self.parts.first().map_or(0, |part| part.kernel.terms())
    }
}

#[cfg(test)]
mod random_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod truth;
