//! Parameters that arrive as fragments captured by a user's own macro.

#![deny(warnings)]

macro_rules! pendulum_of {
    ($name:ident, $angle:expr, $rate:literal) => {
        pendula::pendulum! {
            pub struct $name;
            theta0 = $angle, omega = $rate, tol = 1e-6
        }
    };
}

macro_rules! half_of {
    ($angle:expr) => {
        pendula::pendulum!(theta0 = $angle / 2, tol = 1e-6)
    };
}

pendulum_of!(Slow, 1.0 + 0.5, 0.25);

fn main() {
    assert!((Slow::theta(0.0) - 1.5).abs() <= 1e-6);
    let half = half_of!(1.0 + 0.5);
    assert!((half(0.0) - 0.75_f64).abs() <= 1e-6);
}
