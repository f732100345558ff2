//! Plans in which one function stands for the arcsine of the sum.

use super::residual::twice_arcsine;
use crate::fuzz::random::Random;
use crate::motion::{Regime, Swing};
use crate::plan::plan;
use crate::plan::tests::scene;
use crate::scene::Scene;
use crate::series::Wave;
use pendulum_runtime::double::Double;

/// (−1)ⁿ⁻¹ k b₂ₙ₋₁.
pub(super) fn weights(swing: &Swing, terms: usize) -> Vec<Double> {
    swing.half_sine_weights(&swing.fourier_coefficients(terms))
}

/// Against the arcsine of the sum, for swings of all amplitudes, released and launched, to either side, and any
/// time.
#[test]
fn plans_compute_twice_the_arcsine() {
    let mut random = Random::new(7);
    let mut wholes = 0;
    for _ in 0..24 {
        let (theta0, terms) = (0.05 + 0.87 * random.unit(), 1 + random.below(5));
        let side = random.choose(&["", "-"]);
        let velocity0 = if random.one_in(3) { 0.2 * random.unit() } else { 0.0 };
        let text = format!("theta0 = {side}{theta0:.4}π, n = {terms}, velocity0 = {velocity0:.3}");
        let scene = scene(&text);
        let Ok(plan) = plan(&scene) else { continue };
        let Regime::Swing(swing) = &scene.motion.regime else { continue };
        let (description, bound) = (&plan.parts[0].description, plan.parts[0].bound);
        let whole = description.contains("twice the arcsine");
        wholes += u32::from(whole);
        let sum = Wave::harmonics(&weights(swing, terms));
        let amplitude = swing.amplitude.to_f64();
        let ulp = amplitude.next_up() - amplitude;
        assert!(bound.phase + bound.evaluation <= 11.0 * ulp || !whole, "{text}: {bound:?}");
        for _ in 0..24 {
            let t = 2f64.powf(60.0 * random.unit() - 6.0);
            let Some(exact) = exact(&scene, swing, &sum, t) else { continue };
            let error = (Double::new(plan.functions[0].program.run(t)[0]) - exact).hi.abs();
            let units = error / ulp;
            // An arcsine multiplies what its argument is wrong by.
            assert!(units <= 8.0 || !whole, "{text} at {t:e}: {units}");
        }
    }
    assert!(wholes > 12, "{wholes}");
}

/// The map is one of anchors, and pieces are parts of one, whatever the unit of the reduced phase.
#[test]
fn in_other_units() {
    let mut random = Random::new(8);
    for (text, how) in [
        ("theta0 = 7π/8, method = fourier, tol = 2e-2, omega = 30", "replaced"),
        ("theta0 = -7π/8, method = fourier, tol = 2e-2, omega = 7", "replaced"),
        ("theta0 = 7π/8, n = 4, omega = 30", "32 polynomials"),
        ("theta0 = -7π/8, n = 4, omega = 7, t_max = 2", "32 polynomials"),
    ] {
        let (scene, plan) = (scene(text), plan(&scene(text)).unwrap());
        let Regime::Swing(swing) = &scene.motion.regime else { panic!("a swing") };
        let (part, sum) = (&plan.parts[0], Wave::harmonics(&weights(swing, 4)));
        let found = (plan.reduction.unit != Double::ONE, part.description.contains(how), plan.coefficients.len());
        assert_eq!(found, (true, true, 4), "{text}: {}", part.description);
        let bias = swing.elliptic.fourier_analysis().supremum(4);
        let own = if text.contains("tol") { part.bound.truncation - bias } else { 1e-15 };
        let most = own + part.bound.phase + part.bound.evaluation;
        for _ in 0..40 {
            let t = 2.0 * random.unit();
            let exact = exact(&scene, swing, &sum, t).unwrap();
            let error = (Double::new(plan.functions[0].program.run(t)[0]) - exact).hi.abs();
            assert!(error <= most, "{text} at {t}: {error:e} {most:e}");
        }
    }
}

fn exact(scene: &Scene, swing: &Swing, sum: &Wave, t: f64) -> Option<Double> {
    let context = scene.motion.omega.context();
    let phase = swing.rate() * context.float(t)? + &swing.launch;
    let passed = phase.round();
    let odd = (&passed - passed.scale(-1).round().scale(1)).is_zero();
    let value = twice_arcsine(sum.at((phase - passed).to_double()))?;
    Some(if odd == swing.mirrored { -value } else { value })
}
