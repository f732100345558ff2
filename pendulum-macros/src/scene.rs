//! What a checked request asks for: the motion itself, and the needs that the plan has to meet.

use crate::exact::Real;
use crate::motion::Motion;
use crate::parse::{Float, Form, Method, Output};

/// A request that makes sense: the input of the planner.
pub(crate) struct Scene {
    pub(crate) form: Form,
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
