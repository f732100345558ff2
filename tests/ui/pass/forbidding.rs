//! What a crate forbids no code in it may allow.

#![forbid(warnings, unused, dead_code, deprecated, missing_docs, unsafe_code, unused_qualifications)]

pendula::pendulum! {
    /// A function is used, the others are not; none is deprecated.
    pub struct Clock;
    theta0 = 1, outputs = [theta, velocity, acceleration, position]
}

pendula::pendulum! { struct Unused; velocity0 = 3, outputs = [wrapped] }

fn main() {
    let angle = pendula::pendulum!(theta0 = 1, tol = 1e-6);
    assert!((Clock::theta(0.5) - angle(0.5)).abs() <= 1e-6);
}
