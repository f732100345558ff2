//! Horizons of less than a quarter of a period.

use super::*;

/// A position is on the circle, whatever θ̂ does beyond a moment.
#[test]
fn positions_of_a_moment() {
    for (start, most) in [
        ("velocity0 = 1.4, tol = 2e-4, t_max = 0.02, float = f32", 1.3),
        ("velocity0 = 1.99843, tol = 8.049e-8, t_max = 9.9233e-2", 1.3),
    ] {
        assert_tight(&format!("struct A; {start}, method = fourier, outputs = [position]"), most, evenly(100));
    }
}

/// Of horizons below all times but 0, too, there are plans.
#[test]
fn the_shortest_moments() {
    for (horizon, float) in [("1e-225", "f32"), ("1e-300", "f64"), ("1e-44", "f32"), ("1e-30", "f64")] {
        for output in ["theta", "velocity", "acceleration", "position"] {
            let text =
                format!("struct A; theta0 = 7.24deg, n = 1, t_max = {horizon}, float = {float}, outputs = [{output}]");
            assert!(planned(&text).is_ok(), "{text}");
        }
    }
}

/// In a moment the polynomials of cosine and sine are off by more than rounding, of which a sum by steps has its part.
#[test]
fn waves_of_a_moment() {
    for (text, most) in [
        ("theta0 = 0.0009765625, omega = 2, t_max = 0.0055, method = harmonic, tol = 1e-3", 2.0),
        ("theta0 = 1, t_max = 0.01, method = series", 1.8),
        ("theta0 = 1, t_max = 0.01, method = series, tol = 1e-7", 1.8),
        ("theta0 = 2.5, t_max = 0.0498, method = series, tol = 1.6e-7", 7.0),
        ("theta0 = 0.0009765625, t_max = 0.01, method = small_angle, tol = 1", 2.5),
        ("theta0 = -1.5, omega = 2, t_max = 0.0049, method = series", 6.0),
    ] {
        let later_half = (0..1000).map(|i| 1.0 - f64::from(i) / 2000.0);
        assert_tight(&format!("struct A; {text}, float = f32, outputs = [velocity]"), most, later_half);
    }
}

/// Over a horizon of less than a quarter of a period no more counts than what it meets, forwards and backwards.
#[test]
fn within_a_moment_only_what_is_met_counts() {
    for (text, most) in [
        ("theta0 = 1, method = harmonic, tol = 0.01, t_max = 0.05", 1.3),
        ("theta0 = 1, method = harmonic, tol = 0.01, t_max = 1", 1.1),
        ("theta0 = -2, velocity0 = 1, method = harmonic, tol = 0.5, t_max = 0.3", 1.3),
        ("theta0 = 1, method = small_angle, tol = 0.01, t_max = 0.05", 1.8),
        ("theta0 = 0.5, method = small_angle, tol = 0.1, t_max = 1.5", 1.8),
        ("theta0 = 0.5, velocity0 = 0.1, float = f32, method = harmonic, tol = 0.1, t_max = 0.0639", 1.3),
        ("velocity0 = 2 - 2.51e-9, method = fourier, tol = 6.18e-6, t_max = 2.83", 1.2),
        // By one polynomial in the image of s² under a map, of which a moment meets more than of s² itself.
        ("theta0 = 0.8183, velocity0 = 0.7561, method = fourier, tol = 9.77e-3, t_max = 1.09e-5", 1.2),
        // Next to the top, far from which the horizon ends: what the sum exceeds the amplitude by, and what is rounded next to
        // the turning point, would be tens or hundreds of times as much.
        ("theta0 = 1, velocity0 = 1.755, method = fourier, tol = 1e-2, t_max = 0.1", 1.2),
        ("theta0 = 1, velocity0 = 1.755, method = fourier, tol = 1e-4, t_max = 0.1", 1.2),
        ("theta0 = 1, velocity0 = 1.755, n = 11, t_max = 0.1", 1.2),
        ("velocity0 = 1.99999, method = fourier, tol = 1e-8, t_max = 0.5", 1.2),
        (
            "theta0 = 2.19744, velocity0 = 0.909, method = fourier, tol = 1e-2, float = f32, t_max = 1.6, outputs = [velocity]",
            2.5,
        ),
        (
            "theta0 = 2.19744, velocity0 = 0.909, method = fourier, tol = 1e-2, float = f32, t_max = 0.1, outputs = [acceleration]",
            2.5,
        ),
        (
            "velocity0 = 2 - 1.878e-4, method = fourier, float = f32, tol = 2.17e-3, t_max = 2.05e-6, outputs = [position]",
            4.0,
        ),
    ] {
        assert_tight(&format!("struct A; {text}"), most, evenly(100));
    }
}

/// Rounding counts where the linearised motion's own phase is, not where that of the exact motion is.
#[test]
fn phases_of_small_angles_over_a_moment() {
    let scene =
        scene("struct A; theta0 = 1, velocity0 = 1.5, method = small_angle, outputs = [velocity], t_max = 0.01");
    let swing = swing(&scene);
    let sum = Sum::new(&scene, swing, Method::SmallAngle, 1).ok().unwrap();
    let [least, farthest] = sum.wanted()[0].met.unwrap();
    let is_met = [&sum.launch, &swing.launch].map(|launch| {
        let phase = launch.to_f64();
        (least..=farthest).contains(&(phase - phase.round()).abs())
    });
    assert_eq!(is_met, [true, false], "{least} {farthest}");
}

/// Beyond a moment a slope is divided by a root that a turning point next to an overshoot makes 0, or next to it.
#[test]
fn slopes_beyond_a_moment() {
    for (text, t) in [
        (
            "theta0 = 0.964778886843908, velocity0 = -1.767739383753302, tol = 0.7823, t_max = 2.64, float = f32",
            -2_174.123_5,
        ),
        ("theta0 = 1, velocity0 = 1.751088215085365009069172, tol = 0.9, t_max = 0.3, float = f32", 3.682_978_9),
        ("theta0 = 1, velocity0 = 1.551491793566870649331619, tol = 0.9, t_max = 0.3", 1.757_442_226_734_976_3),
    ] {
        let plan = planned(&format!("struct A; {text}, method = fourier, outputs = [velocity]")).expect("a plan");
        let slopes = (0..100).flat_map(|k| plan.functions[0].program.run(t * (1.0 + f64::from(k) * 1e-8)));
        assert!(slopes.clone().all(f64::is_finite), "{text}: {:?}", slopes.collect::<Vec<_>>());
    }
    let by_terms = "theta0 = 0.211251588389127, velocity0 = 1.970500993776005, n = 3, t_max = 1.637, float = f32";
    assert!(planned(&format!("struct A; {by_terms}, outputs = [velocity]")).is_err());
    assert!(planned(&format!("struct A; {by_terms}")).is_ok());
}
