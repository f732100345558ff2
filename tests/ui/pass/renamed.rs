//! The crate under another name: generated code reaches it by the macro's own path.

#![deny(warnings)]

use ::pendula as other;

mod pendula {
    //! Shadows the crate's name, on purpose.
}

other::pendulum! {
    /// Released at a right angle.
    pub struct Right;
    theta0 = 1π/2, tol = 1e-6
}

fn main() {
    let theta = other::pendulum!(theta0 = 1, n = 3);
    assert!(theta(0.0_f64) > 0.9);
    assert!(Right::theta(0.0) > 1.5);
}
