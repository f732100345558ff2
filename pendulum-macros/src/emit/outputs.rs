//! What the generated items say of each output.

use crate::parse::Output;

/// One output in the words of the documentation.
pub(super) struct Wording {
    /// What its function returns.
    pub(super) value: &'static str,
    /// What its error is measured in.
    pub(super) unit: &'static str,
    /// The constant that bounds the error, and what that says.
    pub(super) max_error: &'static str,
    pub(super) bound: &'static str,
}

impl Wording {
    pub(super) fn of(output: Output) -> Self {
        match output {
            Output::Theta => Self {
                value: "θ(t), rad",
                unit: "rad",
                max_error: "MAX_ERROR",
                bound: "Proven bound of |θ(t) − exact| over the horizon, rad.",
            },
            Output::Velocity => Self {
                value: "θ̇(t), rad per unit of t",
                unit: "rad·ω",
                max_error: "MAX_VELOCITY_ERROR",
                bound: "Proven bound of the velocity's error over the horizon, in rad·ω.",
            },
            Output::Acceleration => Self {
                value: "θ̈(t) = −ω² sin θ(t), rad per unit of t squared",
                unit: "rad·ω²",
                max_error: "MAX_ACCELERATION_ERROR",
                bound: "Proven bound of the acceleration's error over the horizon, in rad·ω².",
            },
            Output::Position => Self {
                value: "(sin θ, −cos θ) at t, in lengths: x to the right, y upwards from the pivot",
                unit: "lengths",
                max_error: "MAX_POSITION_ERROR",
                bound: "Proven bound of the position's distance from the exact one, in lengths.",
            },
            Output::Wrapped => Self {
                value: "θ(t) wrapped to [−π, π), rad",
                unit: "rad",
                max_error: "MAX_WRAPPED_ERROR",
                bound: "Proven bound of the wrapped angle's error over the horizon, rad.",
            },
        }
    }
}
