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

macro_rules! clocks {
    ($($(#[$attribute:meta])* $visibility:vis $name:ident { $($parameters:tt)* })*) => {
        $(pendula::pendulum! { $(#[$attribute])* $visibility struct $name; $($parameters)* })*
    };
}

macro_rules! of_terms {
    ($($n:literal)*) => { [$(pendula::pendulum!(theta0 = 7π/8, n = $n) as fn(f64) -> f64),*] };
}

macro_rules! with {
    ($method:ident, $float:ident, $($output:ident)*) => {
        pendula::pendulum!(theta0 = 1, method = $method, float = $float, tol = 1e-2, outputs = [$($output),*])
    };
}

macro_rules! degrees {
    ($angle:literal) => {
        pendula::pendulum!(theta0 = $angle, tol = 1e-6)
    };
}

pendulum_of!(Slow, 1.0 + 0.5, 0.25);
clocks! {
    /// One.
    pub(crate) One { theta0 = 1, tol = 1e-3 }

    Two { theta0 = 2, tol = 1e-3 }
}

fn main() {
    assert!((Slow::theta(0.0) - 1.5).abs() <= 1e-6);
    assert!((One::theta(0.0) - 1.0).abs() <= 1e-3);
    assert!((Two::theta(0.0) - 2.0).abs() <= 1e-3);
    let half = half_of!(1.0 + 0.5);
    assert!((half(0.0) - 0.75_f64).abs() <= 1e-6);
    assert!(of_terms!(4 5 6).iter().all(|theta| theta(0.0) > 2.7));
    assert!(with!(harmonic, f32, theta)(0.0) > 0.9_f32);
    let _ = degrees!(90deg);
}
