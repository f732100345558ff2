use super::*;
use crate::plan::curve::{Curves, SwingCurves};
use crate::testing::{scene, swing};
use pendulum_runtime::Pendulum;
use std::f64::consts::PI;

/// At t = 0 angle and velocity are those of the start, whichever way it goes.
#[test]
fn it_starts_as_the_motion_does() {
    for start in [
        "theta0 = 1",
        "theta0 = -2",
        "theta0 = 1, velocity0 = 0.5",
        "theta0 = 1, velocity0 = -0.5",
        "theta0 = -1, velocity0 = 0.5",
        "theta0 = -1, velocity0 = -0.5",
        "velocity0 = 1.5",
        "velocity0 = -1.5",
        "theta0 = 1e-30, velocity0 = 1e-50",
        "theta0 = -1e-50, velocity0 = 1e-30",
    ] {
        let scene = scene(&format!("{start}, omega = 3"));
        let (motion, swing) = (&scene.motion, swing(&scene));
        let Linearised { amplitude, launch } = Linearised::new(motion, swing);
        let (sine, cosine) = (&launch * launch.context().pi()).sin_cos();
        let direction = if swing.mirrored { -1.0 } else { 1.0 };
        let angle = (&amplitude * cosine).to_f64() * direction;
        let velocity = (-(&amplitude * sine) * &motion.omega).to_f64() * direction;
        let near = |found: f64, x: f64| assert!((found - x).abs() <= 1e-60 + 1e-15 * x.abs(), "{start}: {found} {x}");
        near(angle, motion.theta0.to_f64());
        near(velocity, motion.velocity0.to_f64());
        assert!(launch.abs() <= launch.context().ratio(1, 2) && amplitude <= swing.amplitude, "{start}");
    }
}

/// What is seen of it is no more than the bounds, and of horizons up to half a swing no less than a quarter.
#[test]
fn bounds_of_the_departure() {
    const SAMPLES: u32 = 400;
    for (theta0, velocity0) in [(0.1, 0.0), (1.0, 0.0), (1.0, 0.5), (1.0, -0.5), (0.0, 1.5), (2.5, 0.3), (0.001, 1.9)] {
        let scene = scene(&format!("theta0 = {theta0}, velocity0 = {velocity0}"));
        let (swing, omega) = (swing(&scene), &scene.motion.omega);
        let theta = SwingCurves::new(swing, omega).angle();
        let pendulum = Pendulum::<f64>::from_state(theta0, velocity0, 1.0).unwrap();
        for x in [0.2, 1.0, 2.0, 3.0, 9.0] {
            let bound = Departure::new(swing, &theta, omega, x);
            let mut seen = [0.0_f64; 3];
            for t in (0..=SAMPLES).flat_map(|i| [1.0, -1.0].map(|way| way * x * f64::from(i) / f64::from(SAMPLES))) {
                let (angle, velocity) = pendulum.state(t);
                let (sine, cosine) = t.sin_cos();
                let linear = theta0 * cosine + velocity0 * sine;
                let off =
                    [linear - angle, velocity0 * cosine - theta0 * sine - velocity, -linear - pendulum.acceleration(t)];
                seen = std::array::from_fn(|i| seen[i].max(off[i].abs()));
            }
            let most = if x < 3.5 { 4.0 } else { f64::INFINITY };
            for (bound, seen) in [bound.angle, bound.velocity, bound.acceleration].into_iter().zip(seen) {
                let text = format!("{theta0} {velocity0} {x}: {bound:e} {seen:e}");
                assert!(seen <= bound + 1e-15 && bound <= most * seen + 1e-13, "{text}");
            }
        }
    }
}

/// A moment after a start at the lowest point it is (ωt)⁵(θ̇0/ω)³/120, and over more than some periods it isn't known.
#[test]
fn departures_of_moments() {
    let scene = scene("velocity0 = 1");
    let (swing, omega) = (swing(&scene), &scene.motion.omega);
    let theta = SwingCurves::new(swing, omega).angle();
    let bound = |x: f64| Departure::new(swing, &theta, omega, x).angle;
    let known = 0.01_f64.powi(5) / 120.0;
    assert!(known <= bound(0.01) && bound(0.01) <= 1.2 * known, "{:e} {known:e}", bound(0.01));
    assert!(bound(1e-100) < 1e-200 && bound(9.9) < f64::INFINITY);
    assert_eq!(bound(10.1), f64::INFINITY);
}

/// At the top it is π(1 − cos ωt).
#[test]
fn departures_at_the_top() {
    for start in ["theta0 = π - 1e-20", "theta0 = π - 1e-30, velocity0 = 1e-31"] {
        let scene = scene(start);
        let (swing, omega) = (swing(&scene), &scene.motion.omega);
        let theta = SwingCurves::new(swing, omega).angle();
        for x in [1e-6_f64, 0.1, 1.0] {
            let (bound, known) = (Departure::new(swing, &theta, omega, x).angle, PI * 2.0 * (0.5 * x).sin().powi(2));
            assert!(known * (1.0 - 1e-12) <= bound && bound <= 1.001 * known, "{start} {x}: {bound:e} {known:e}");
        }
    }
}
