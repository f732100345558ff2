//! [`Scene`] → [`Plan`]: the cheapest program found that provably keeps the promise.

pub(crate) mod curve;
pub(crate) mod polynomial;
pub(crate) mod reduction;
mod search;
pub(crate) mod variables;

use crate::exact::Real;
use crate::motion::Regime;
use crate::parse::{Method, Output};
use crate::program::{Op, Program};
use crate::scene::Scene;
use polynomial::Polynomial;
use reduction::Reduction;

/// What is emitted, and what it promises.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub(crate) method: Method,
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
    pub(crate) kernels: Vec<Polynomial>,
    /// What the kernels are, for the reader.
    pub(crate) description: String,
    pub(crate) bound: Bound,
    /// What an error of 1 in the output's own unit is: 1, ω, ω².
    pub(crate) unit: f64,
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
}

impl Refusal {
    /// The error at the token to blame.
    pub(crate) fn explain(&self, scene: &Scene) -> syn::Error {
        match self {
            Self::Unreachable { best } => syn::Error::new_spanned(
                &scene.blame.goal,
                format!(
                    "this error can't be promised with `{}`: the best is {best:.2e}; ask for that, or leave `tol` out",
                    scene.float.word()
                ),
            ),
        }
    }
}

/// Plans a scene.
pub(crate) fn plan(scene: &Scene) -> Result<Plan, Refusal> {
    let Regime::Swing(swing) = &scene.motion.regime else { todo!("other regimes") };
    search::plan(scene, swing)
}

impl Plan {
    /// The cost of all functions; `state` stands for the two that it joins.
    pub(crate) fn cost(&self) -> f64 {
        self.functions.iter().map(|function| function.program.cost()).sum()
    }

    /// Operations of the first function.
    pub(crate) fn operations(&self) -> usize {
        self.functions.first().map_or(0, |function| function.program.operations())
    }

    /// Terms of the first output's first kernel.
    pub(crate) fn terms(&self) -> usize {
        let kernel = self.parts.first().and_then(|part| part.kernels.first());
        kernel.map_or(self.coefficients.len(), |kernel| kernel.coefficients.len())
    }

    /// Whether `core` alone can evaluate it at compile time: it can't take roots there.
    pub(crate) fn is_const(&self) -> bool {
        let has_root = |program: &Program| program.nodes.iter().any(|node| matches!(node.op, Op::Sqrt(_)));
        !self.functions.iter().any(|function| has_root(&function.program))
    }
}

#[cfg(test)]
mod tests;
