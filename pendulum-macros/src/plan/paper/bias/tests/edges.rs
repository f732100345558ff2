//! Next to the arcsine's edge, against two words.

use crate::chebyshev::{cos_pi, sin_pi};
use crate::motion::Swing;
use crate::parse::Output;
use crate::plan::curve::Curves;
use crate::plan::plan;
use crate::testing::{scene, swing};
use pendulum_runtime::double::Double;

/// θ̂ = 2 arcsin y differentiated with respect to the phase, in two words.
fn derivative(swing: &Swing, terms: usize, s: Double) -> Double {
    let (mut y, mut slope) = (Double::ZERO, Double::ZERO);
    for (index, weight) in swing.half_sine_weights(&swing.fourier_coefficients(terms)).into_iter().enumerate() {
        let m = (2 * index + 1) as f64;
        let turns = s * m;
        let turns = turns - Double::new(2.0 * (0.5 * turns.hi).round());
        y = y + weight * cos_pi(turns);
        slope = slope - weight * sin_pi(turns) * Double::PI * m;
    }
    slope * 2.0 / ((Double::ONE - y) * (Double::ONE + y)).sqrt()
}

/// Of sums whose largest value is 1 − 3·10⁻⁴, 1 − 10⁻⁹ and 1 − 10⁻¹³, next to the turning point and far from it.
#[test]
fn velocities_next_to_the_edge_of_the_arcsine_keep_their_bounds() {
    for (theta0, terms) in [("π - 5.52933e-2", 9), ("0.7308281024197π", 1), ("0.730828103425899196π", 1)] {
        let scene = scene(&format!("struct Motion; theta0 = {theta0}, n = {terms}, outputs = [velocity]"));
        let swing = swing(&scene);
        let plan = plan(&scene).unwrap();
        let part = &plan.parts[0];
        assert_eq!(part.output, Output::Velocity);
        let exact = super::SwingCurves::new(swing, &scene.motion.omega).velocity();
        let (rate, mut largest) = (swing.rate().to_double(), 0.0_f64);
        for i in 0..400 {
            let t = 0.49 / rate.hi * 10f64.powf(-8.0 * f64::from(i) / 400.0);
            let (found, s) = (plan.functions[0].program.run(t)[0], rate * t);
            let rounding = (Double::new(found) - derivative(swing, terms, s) * rate).hi.abs();
            assert!(rounding <= part.bound.evaluation + part.bound.phase, "{theta0}, {t:e}: {rounding:e}");
            largest = largest.max((Double::new(found) - exact.at(s)).hi.abs());
        }
        // The supremum is bounded to 3 %, and samples miss the peak by little.
        assert!(
            largest <= part.bound.total() && largest > 0.9 * part.bound.total(),
            "{theta0}: {largest}, {:?}",
            part.bound
        );
    }
}
