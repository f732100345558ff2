//! Reads the reference data; the scripts beside it say where the numbers come from.
#![allow(dead_code, unreachable_pub, reason = "each test crate uses its own part of this module")]

use pendula_stress::reference::{Exact, bits, rows};

/// A state at time `t` of the motion that starts from a given state.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    pub theta0: f64,
    pub velocity0: f64,
    pub omega: f64,
    pub t: f64,
    pub theta: Exact,
    pub velocity: Exact,
}

/// `reference.csv`: releases from rest and launches from the bottom, ω = 1.
pub fn reference() -> impl Iterator<Item = Row> {
    rows(include_str!("reference.csv")).map(|cells| {
        let parameter = bits(cells[1]);
        let (theta0, velocity0) = if cells[0] == "rest" { (parameter, 0.0) } else { (0.0, parameter) };
        Row {
            theta0,
            velocity0,
            omega: 1.0,
            t: bits(cells[2]),
            theta: Exact::read(&cells[3..]),
            velocity: Exact::read(&cells[5..]),
        }
    })
}

/// `states.csv`: arbitrary states.
pub fn states() -> impl Iterator<Item = Row> {
    rows(include_str!("states.csv")).map(|cells| Row {
        theta0: bits(cells[0]),
        velocity0: bits(cells[1]),
        omega: bits(cells[2]),
        t: bits(cells[3]),
        theta: Exact::read(&cells[4..]),
        velocity: Exact::read(&cells[6..]),
    })
}

/// `elliptic.csv`: whether the modulus is the complementary one, it, u, φ, and K, K′, q, sn, cn, dn, am, F(φ).
pub fn elliptic() -> impl Iterator<Item = (bool, [f64; 3], [f64; 8])> {
    rows(include_str!("elliptic.csv")).map(|cells| {
        let at = |i: usize| bits(cells[i]);
        (cells[0] == "kc", core::array::from_fn(|i| at(1 + i)), core::array::from_fn(|i| at(4 + i)))
    })
}
