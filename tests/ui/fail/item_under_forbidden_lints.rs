#![forbid(missing_docs, unused)]
//! A stub without documentation of its own is no second mistake.

pendula::pendulum! {
    /// Nothing that a swing can do.
    pub struct Clock;
    theta0 = 4
}

fn main() {
    let _angle = Clock::theta(0.0);
}
