//! What the methods of the paper would have cost: for the documentation of the plan that was chosen.

use super::curve::{Curves, SwingCurves};
use super::reduction::Reduction;
use crate::motion::Regime;
use crate::parse::{Method, Output};
use crate::scene::{Goal, Scene};

/// Operations of the cosine that a sum of harmonics starts from, and of one harmonic.
const COSINE: usize = 18;
const HARMONIC: usize = 3;

/// Why each method of the paper lost, where θ was planned for a swing by choice.
pub(super) fn costs(scene: &Scene, reduction: &Reduction) -> Vec<String> {
    let Regime::Swing(swing) = &scene.motion.regime else { return Vec::new() };
    if scene.method.is_some() || !scene.outputs.contains(&Output::Theta) {
        return Vec::new();
    }
    let theta = SwingCurves::new(swing, &scene.motion.omega).angle();
    let aim = match scene.goal {
        Goal::Tolerance(tol) => tol,
        _ => scene.float.unit() * swing.amplitude.to_f64(),
    };
    // The first neglected term is nearly all of the error.
    let needed = |after: usize| theta.terms().iter().skip(after).all(|(_, a)| a.hi.abs() <= aim);
    let terms = (1..theta.terms().len()).find(|&terms| needed(terms)).unwrap_or(theta.terms().len());
    let base = reduction.operations() + COSINE;
    let mut lost = Vec::new();
    if terms > 1 {
        let error = theta.terms().get(1).map_or(0.0, |(_, a)| 2.0 * a.hi.abs());
        lost.push(format!("`{}`: it is wrong by about {error:.0e}", Method::Harmonic.word()));
    }
    let series = base + HARMONIC * terms;
    lost.push(format!("`{}`: {terms} harmonics, about {series} operations", Method::Series.word()));
    lost.push(format!(
        "`{}`: about {} harmonics, the arcsine of whose sum bends more than θ does",
        Method::Fourier.word(),
        terms + 1
    ));
    lost
}
