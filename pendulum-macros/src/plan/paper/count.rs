//! How many terms a formula takes.

use super::bias::{Approximate, MOST_HARMONICS};
use super::{Sum, plan};
use crate::motion::Swing;
use crate::parse::{Method, Output};
use crate::plan::curve::{Curve, Curves, SwingCurves};
use crate::plan::met::Met;
use crate::scene::{Goal, Scene};
use crate::series::Wave;

/// More terms than this aren't chosen for a tolerance: the analysis of longer sums takes the compiler longer than a
/// second.
pub(super) const MOST_CHOSEN: usize = 128;

/// How many terms more than the fewest are tried.
pub(super) const MORE: [usize; 8] = [0, 1, 2, 3, 5, 8, 13, 21];

/// The part of a tolerance that terms left out may come to when terms are first counted: the rest is for phase and
/// rounding, mostly far less, and where it isn't enough more terms are tried ([`MORE`]).
const OF_TRUNCATION: f64 = 0.98;

/// What the terms of a series that are left out may come to.
fn negligible(scene: &Scene, curve: &Curve) -> f64 {
    match scene.goal {
        Goal::Tolerance(tol) => tol * curve.size.unit * OF_TRUNCATION,
        _ => scene.float.rounding_unit() * curve.size.largest,
    }
}

/// As many terms of the series as θ takes to come within what is asked, and so many that what derivatives leave out may be
/// as little.
pub(super) fn fewest_of_series(scene: &Scene, swing: &Swing) -> usize {
    let curves = SwingCurves::new(swing, &scene.motion.omega);
    let theta = curves.angle();
    let most = theta.terms().len().min(MOST_HARMONICS);
    let serves = |kept: usize| {
        let sum = Sum::series(scene, swing, &theta, kept);
        Approximate::new(&sum, &theta).angle().0 <= negligible(scene, &theta)
    };
    let of_theta = first_serving(negligible_after(scene, &theta), most, serves);
    let of_derivative = |output: &Output| match output {
        Output::Velocity => negligible_after(scene, &curves.velocity()),
        Output::Acceleration => negligible_after(scene, &curves.acceleration()),
        _ => 0,
    };
    scene.outputs.iter().map(of_derivative).fold(of_theta, usize::max)
}

/// How many terms there are before one that is no more than twice what may be left out: with fewer its own harmonic is too
/// much.
fn negligible_after(scene: &Scene, curve: &Curve) -> usize {
    let (terms, negligible) = (curve.terms(), negligible(scene, curve));
    (1..terms.len()).find(|&kept| terms[kept].1.hi.abs() / 2.0 <= negligible).unwrap_or(terms.len())
}

/// The least number from `least` on that serves, or `most`, by bisection: more are better.
fn first_serving(least: usize, most: usize, serves: impl Fn(usize) -> bool) -> usize {
    let (mut fails, mut found, mut step) = (least, least, 1);
    while found < most && !serves(found) {
        (fails, found, step) = (found, most.min(found + step), 2 * step);
    }
    while found > fails + 1 {
        let middle = usize::midpoint(fails, found);
        *(if serves(middle) { &mut found } else { &mut fails }) = middle;
    }
    found
}

/// The first number of terms from `smallest` on, of a few, that is planned: without overshoot an error may still be too
/// near to it to be bounded.
pub(in crate::plan) fn planned(scene: &Scene, swing: &Swing, smallest: usize) -> Option<usize> {
    let ask = |n: usize| plan(&Scene { goal: Goal::Terms(n), ..scene.clone() }, swing, Method::Fourier);
    (smallest..=swing.most_useful_terms(scene.float.rounding_unit())).take(3).find(|&n| ask(n).is_ok())
}

/// The terms of Eq. 22 that are asked for, or the fewest that don't overshoot and come within the tolerance, by bisection:
/// more terms are better, and where as many as are chosen don't suffice those tell what can be had. Where none are, one.
/// Within a moment fewer may do than at any time.
pub(super) fn fewest(scene: &Scene, swing: &Swing) -> usize {
    let tol = match scene.goal {
        Goal::Terms(n) => return n,
        Goal::Tolerance(tol) => tol * OF_TRUNCATION,
        Goal::Full => scene.float.rounding_unit() * swing.amplitude.to_f64(),
    };
    let Some(smallest) = swing.smallest_working_terms(scene.float.rounding_unit()) else { return 1 };
    let (analysis, most) = (swing.elliptic.fourier_analysis(), smallest.max(MOST_CHOSEN - 1));
    let least = least_at_turning(swing);
    let from = (smallest..most).find(|&n| least(n) < tol).unwrap_or(most);
    let at_any_time = first_serving(from, most, |n| analysis.supremum(n) < tol);
    if Met::within(scene, &swing.rate(), &swing.launch).is_none() {
        return at_any_time;
    }
    let theta = SwingCurves::new(swing, &scene.motion.omega).angle();
    let serves = |n| Sum::fourier(scene, swing, n).is_ok_and(|sum| Approximate::new(&sum, &theta).angle().0 < tol);
    first_serving(smallest, at_any_time, serves)
}

/// A lower bound of the error of so many terms, that at a turning point: there what is left out alternates, and is at least
/// its first term less the second. With y for k less that, θ̂/2 is arcsin k − arcsin y off, of which the sine is
/// (k² − y²)/(k√(1 − y²) + yk′), or more where y is above k.
fn least_at_turning(swing: &Swing) -> impl Fn(usize) -> f64 {
    let sine = Wave::half_sine(swing);
    let (k, complementary) = (swing.elliptic.modulus.to_f64(), swing.elliptic.complementary.to_f64());
    move |n| {
        let size = |n: usize| sine.terms().get(n).map_or(0.0, |(_, amplitude)| amplitude.hi.abs());
        let off = size(n) - size(n + 1);
        let squares = off * (2.0 * k - off);
        2.0 * squares / (k * (complementary * complementary + squares).sqrt() + (k - off) * complementary)
    }
}
