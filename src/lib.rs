#![no_std]
//! wip

pub use pendulum_runtime::{Error, Fourier, Pendulum, Regime, Scalar, elliptic};

#[doc(hidden)]
pub mod __private {
    pub use pendulum_macros::pendulum;
    pub use pendulum_runtime::support;
}

/// The motion of a pendulum, generated at compile time.
#[macro_export]
macro_rules! pendulum {
    ($($input:tt)*) => { $crate::__private::pendulum! { [$crate] $($input)* } };
}
