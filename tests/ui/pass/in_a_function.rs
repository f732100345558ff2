//! Items and expressions inside functions, generic code and constants.

#![deny(warnings)]

use pendula::pendulum;

fn sum<F: Fn(f64) -> f64>(motion: F) -> f64 {
    (0..10).map(|i| motion(f64::from(i))).sum()
}

fn main() {
    pendulum! {
        struct Local;
        theta0 = 2, tol = 1e-9
    }
    const START: f64 = Local::theta(0.0);
    assert!((START - 2.0).abs() <= 1e-9);
    assert_eq!(sum(Local::theta), sum(pendulum!(theta0 = 2, tol = 1e-9)));
}
