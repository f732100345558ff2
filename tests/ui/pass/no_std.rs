//! Without the standard library in scope; strict lints.

#![no_std]
#![deny(warnings)]
#![deny(clippy::all, clippy::pedantic)]
#![forbid(unsafe_code)]

// For the runtime of `main` alone: nothing of it is in scope.
extern crate std as _;

pendula::pendulum! {
    /// A pendulum in a controller.
    pub struct Controlled;
    theta0 = 1, float = f32, tol = 1e-4, t_max = 1000, outputs = [theta, velocity]
}

pendula::pendulum! {
    /// The paper's own approximation.
    pub struct Paper;
    theta0 = 7π/8, n = 4
}

fn main() {
    assert!(Controlled::theta(0.0) > 0.99);
    assert!(Paper::theta(0.0) > 2.7);
}
