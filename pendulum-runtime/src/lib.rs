//! wip
#![no_std]

mod agm;
mod angle;
mod carlson;
pub mod double;
mod double_trig;
mod error;
mod kernel;
mod launch;
mod motion;
mod pendulum;
mod phase;
mod regime;
mod rotation;
mod scalar;
#[doc(hidden)]
pub mod support;
mod swing;
mod theta_polynomial;

pub use error::Error;
pub use pendulum::Pendulum;
pub use regime::Regime;
pub use scalar::Scalar;
