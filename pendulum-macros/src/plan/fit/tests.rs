//! Truncation errors against samples.

use super::*;
use crate::parse::Float;
use crate::program::Op;

/// sup |polynomial − function| on [0, end].
fn sampled(fit: &Fit, end: f64, function: impl Fn(Double) -> Double) -> f64 {
    let at = |i: u32| {
        let z = Double::new(end * f64::from(i) / 500.0);
        let value = fit.coefficients.iter().rev().fold(Double::ZERO, |sum, c| sum * z + *c);
        (value - function(z)).hi.abs()
    };
    (0..=500).map(at).fold(0.0, f64::max)
}

/// 1/(1 + z/4) on [0, 1] has its pole at −4: on the ellipse that reaches −3 it is at most 4.
#[test]
fn truncation_errors() {
    let inverse = |z: Double| Double::ONE / (Double::ONE + z * 0.25);
    for limit in [1e-3, 1e-6, 1e-12, 1e-16] {
        let fit = Fit::new(&Domain::reaching(1.0, -3.0, 4.0), limit, inverse);
        let seen = sampled(&fit, 1.0, inverse);
        assert!(seen <= fit.truncation && fit.truncation <= limit, "{seen:e} of {:e}", fit.truncation);
        // Interpolation takes a sixteenth of the limit at most, and what is dropped has one sign.
        assert!(fit.truncation <= 1.05 * seen + limit / 16.0, "{seen:e} of {:e}", fit.truncation);
        // A term less would not do.
        assert!(seen > limit / 50.0, "{seen:e} for {limit:e}");
    }
    // Of one that never falls below the limit all points count.
    assert_eq!(Fit::new(&Domain { end: 1.0, rho: 1.01, bound: 4.0 }, 1e-30, inverse).terms(), 200);
}

/// The parameter ρ of an ellipse with foci 0 and Z is that of x = 1 − 2z/Z, ρ + 1/ρ = 2|x|.
#[test]
fn ellipses() {
    for (end, furthest) in [(1.0, -3.0), (0.25, -2.0)] {
        let domain = Domain::reaching(end, furthest, 1.0);
        let reach: f64 = 2.0 * (end - 2.0 * furthest) / end;
        assert!(domain.rho > 1.0 && ((domain.rho + 1.0 / domain.rho) / reach - 1.0).abs() < 1e-14);
    }
}

/// The truncation is charged to the constant, once.
#[test]
fn truncation_is_part_of_the_rounding() {
    let cosine = |z: Double| Double::ONE - z * 0.5;
    let fit = Fit { truncation: 1e-9, ..Fit::new(&Domain::reaching(1.0, -1.0, 2.0), 1e-6, cosine) };
    let mut b = Builder::new(Float::F64);
    let z = b.input();
    let value = fit.lower(&mut b, z, &["z", "z2"]);
    let program = b.finish(vec![value]);
    let rest = |value: f64| {
        let constant = |op: Op| matches!(op, Op::Constant { value: found, .. } if (found - value).abs() < 1e-9);
        match program.nodes.iter().find(|node| constant(node.op)).map(|node| node.op) {
            Some(Op::Constant { rest, .. }) => rest,
            other => panic!("{value}: {other:?}"),
        }
    };
    assert!((1e-9..1.001e-9).contains(&rest(1.0)) && rest(-0.5) < 1e-15, "{:e} {:e}", rest(1.0), rest(-0.5));
}
