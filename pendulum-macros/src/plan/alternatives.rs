//! Why the methods of the paper lost: for the documentation of the plan that was chosen.

use super::aim::FULL;
use super::curve::{Curve, Curves, SwingCurves};
use crate::motion::Regime;
use crate::parse::{Method, Output};
use crate::scene::{Goal, Scene};
use crate::supremum::worst;
use pendulum_runtime::double::Double;
use std::f64::consts::{FRAC_PI_4, PI};

/// Why each method of the paper lost, where θ was planned for a swing by choice.
pub(super) fn reasons(scene: &Scene) -> Vec<String> {
    let Regime::Swing(swing) = &scene.motion.regime else { return Vec::new() };
    if scene.method.is_some() || !scene.outputs.contains(&Output::Theta) {
        return Vec::new();
    }
    let theta = SwingCurves::new(swing, &scene.motion.omega).angle();
    let aim = match scene.goal {
        Goal::Tolerance(tol) => tol,
        _ => FULL * scene.float.rounding_unit() * swing.amplitude.to_f64(),
    };
    let mut lost = Vec::new();
    if theta.terms().len() > 1 {
        let error = error_of_cosine(&theta);
        let enough = if error <= aim { ", and a cosine costs no less" } else { "" };
        lost.push(format!("`{}`: it is wrong by about {error:.0e} rad{enough}", Method::Harmonic.word()));
    }
    // The mean of |error·cos| is half of the first coefficient that is left out, and at most 2/π of the largest error.
    let needed = |after: usize| theta.terms().iter().skip(after).all(|(_, a)| a.hi.abs() * FRAC_PI_4 <= aim);
    let harmonics = (1..theta.terms().len()).find(|&terms| needed(terms)).unwrap_or(theta.terms().len());
    let word = if harmonics == 1 { "harmonic" } else { "harmonics" };
    lost.push(format!(
        "`{}`: it takes {harmonics} {word} at least, of three operations each, and a cosine",
        Method::Series.word()
    ));
    lost.push(format!(
        "`{}`: a polynomial for the arcsine of its sum takes no fewer terms than one for θ, and the sum has an error besides",
        Method::Fourier.word()
    ));
    lost
}

/// About sup |θ − θ0 cos πs|, s being the phase from the turning point.
fn error_of_cosine(theta: &Curve) -> f64 {
    const SAMPLES: u32 = 16;
    let error = |index: u32| {
        let s = 0.5 * f64::from(index) / f64::from(SAMPLES);
        (theta.at(Double::new(s)).hi - theta.size.largest * libm::cos(PI * s)).abs()
    };
    worst((0..=SAMPLES).map(error))
}
