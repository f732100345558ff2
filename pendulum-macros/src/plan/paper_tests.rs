//! The methods of the paper: as many terms as a tolerance needs, and errors that are known in closed form.

use super::tests::scene;
use super::{Plan, Refusal, plan};
use crate::motion::Regime;

fn planned(text: &str) -> Result<Plan, Refusal> {
    plan(&scene(text))
}

fn truncation(plan: &Plan) -> f64 {
    plan.parts[0].bound.truncation
}

/// `method = fourier` with `tol` is the smallest `n` that serves.
#[test]
fn a_tolerance_takes_the_fewest_terms_of_the_paper() {
    for (theta0, tol) in [("1", 1e-5), ("7π/8", 1e-4), ("0.97π", 1e-3), ("0.999π", 1e-6)] {
        let chosen = planned(&format!("theta0 = {theta0}, tol = {tol}, method = fourier")).unwrap();
        let fewer = planned(&format!("theta0 = {theta0}, n = {}", chosen.terms() - 1));
        assert!(truncation(&chosen) <= tol, "{theta0} {tol}");
        match fewer {
            // A hundredth of the tolerance is left to rounding.
            Ok(fewer) => assert!(truncation(&fewer) > 0.98 * tol, "{theta0} {tol}: {} do", fewer.terms()),
            Err(refusal) => assert!(matches!(refusal, Refusal::Overshoot { .. }), "{refusal:?}"),
        }
    }
}

/// The terms of the series alternate at t = 0 and have one sign there, so that its error is θ0 less their sum (DESIGN of
/// the series: it is attained at t = 0). The bound from samples of the tail is at most 1/cos(π/16) above.
#[test]
fn the_error_of_the_series_is_that_of_its_sum() {
    for (theta0, tol) in [("1", 1e-5), ("7π/8", 1e-4), ("0.999π", 1e-3)] {
        let text = format!("theta0 = {theta0}, tol = {tol}, method = series");
        let (scene, plan) = (scene(&text), planned(&text).unwrap());
        let Regime::Swing(swing) = &scene.motion.regime else { panic!("a swing") };
        let curves = super::curve::SwingCurves::new(swing, &scene.motion.omega);
        let terms = curves.theta().terms().to_vec();
        let sum = |count: usize| terms.iter().take(count).map(|(_, a)| a.hi).sum::<f64>();
        let error = |count: usize| (swing.amplitude.to_f64() - sum(count)).abs();
        let (stated, exact) = (truncation(&plan), error(plan.terms()));
        assert!(exact <= stated && stated <= 1.02 * exact, "{text}: {stated:e} {exact:e}");
        assert!(error(plan.terms() - 1) > 0.95 * tol, "{text}: one less would do");
    }
}

/// sup |θ0 cos(2πt/T) − θ|/θ0 with 60 digits, by mpmath: the paper's table, recomputed.
#[test]
fn the_error_of_the_harmonic_motion() {
    for (theta0, relative) in [("π/3", 0.0094132), ("π/2", 0.0232892), ("4π/5", 0.0860), ("7π/8", 0.1234)] {
        let text = format!("theta0 = {theta0}, method = harmonic");
        let plan = planned(&text).unwrap();
        let stated = truncation(&plan) / plan.parts[0].largest;
        // The last digit of the table, and the samples' 1/cos(π/16).
        assert!(stated >= relative * 0.999 && stated <= 1.021 * relative, "{text}: {stated}");
    }
}
