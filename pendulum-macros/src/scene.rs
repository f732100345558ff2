//! What a checked request asks for: the motion itself, and the needs that the plan has to meet.

use crate::exact::Real;
use crate::motion::Motion;
use crate::parse::{Float, Method, Output, Shape};
use proc_macro2::TokenStream;

/// A request that makes sense: the input of the planner.
#[derive(Clone)]
pub(crate) struct Scene {
    pub(crate) shape: Shape,
    /// The parameters as written, for the generated documentation.
    pub(crate) source: String,
    pub(crate) motion: Motion,
    pub(crate) float: Float,
    pub(crate) goal: Goal,
    pub(crate) method: Option<Method>,
    /// The promise holds for |t| up to this; `None` is 2⁵³ periods.
    pub(crate) t_max: Option<Real>,
    /// In the order of declaration of [`Output`], not empty.
    pub(crate) outputs: Vec<Output>,
    pub(crate) blame: Blame,
}

impl Scene {
    /// The greatest |t| promised of those that the type of times has.
    pub(crate) fn horizon(&self) -> f64 {
        let longest = || self.motion.longest_horizon();
        self.t_max.clone().or_else(longest).map_or(f64::INFINITY, |t| t.to_f64()).min(self.float.largest())
    }

    /// Whether ω² is almost beyond the range of floats: some products with it are.
    pub(crate) fn is_far(&self) -> bool {
        !(1e-140..=1e140).contains(&self.motion.omega.to_f64())
    }

    /// The scene over one period.
    pub(crate) fn over_a_period(&self) -> Self {
        Self { t_max: self.motion.period().cloned(), ..self.clone() }
    }

    /// The scene with the angle less its whole turns.
    pub(crate) fn wrapped(&self) -> Self {
        let others = self.outputs.iter().copied().filter(|output| !output.is_angle());
        Self { outputs: others.chain([Output::Wrapped]).collect(), ..self.clone() }
    }

    /// The scene with that output alone.
    pub(crate) fn of(&self, output: Output) -> Self {
        Self { outputs: vec![output], ..self.clone() }
    }

    /// The scene by whatever method serves.
    pub(crate) fn by_any_method(&self) -> Self {
        Self { method: None, ..self.clone() }
    }

    /// The scene asking for that tolerance.
    pub(crate) fn asking(&self, tolerance: f64) -> Self {
        Self { goal: Goal::Tolerance(tolerance), ..self.clone() }
    }
}

/// The tokens at fault where only the planner can tell that a request can't be kept: overshoot of the arcsine's
/// argument, a tolerance out of reach.
#[derive(Clone, Debug)]
pub(crate) struct Blame {
    /// The value of `n` or `tol`, else that of `method`, else that of the start.
    pub(crate) goal: TokenStream,
    /// The value of `theta0`, else that of `velocity0`.
    pub(crate) start: TokenStream,
    /// The value of `omega`, else that of `length`, else that of the start.
    pub(crate) rate: TokenStream,
    /// The value of `method`, else that of the goal.
    pub(crate) method: TokenStream,
}

/// How good the result has to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Goal {
    /// The paper's θ̂ with this many terms, whatever its error.
    Terms(usize),
    /// Sup error at most this, in the unit of each output.
    Tolerance(f64),
    /// As good as the type of float allows.
    Full,
}
