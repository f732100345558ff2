//! Largest values, slopes and conditioning of curves are what bounds of the phase's error stand on: here against samples.

use super::*;
use crate::motion::Regime;
use crate::plan::task::Task;
use crate::power::two_to;
use crate::program::rounding::LOST;
use crate::testing::{Random, scene, swing};
use std::f64::consts::TAU;

/// sup |f|, |f′| and |z·f′|, with `mean` added to f′, z being the phase from the lowest point, a quarter of the
/// cosine's period off the anchor.
fn sampled(curve: &Curve, mean: f64) -> [f64; 3] {
    const SAMPLES: u32 = 2000;
    const STEP: f64 = 1e-5;
    let at = |s: f64| curve.at(Double::new(s)).to_f64();
    let mut suprema = [0.0_f64; 3];
    for i in 0..=SAMPLES {
        let s = 0.5 * f64::from(i) / f64::from(SAMPLES);
        let slope = ((at(s + STEP) - at(s - STEP)) / (2.0 * STEP) + mean).abs();
        let here = [at(s).abs(), slope, (0.5 - s) * slope];
        suprema = std::array::from_fn(|i| suprema[i].max(here[i]));
    }
    suprema
}

/// The stated suprema aren't exceeded, by more than differences and samples are wrong, nor more than `times` too large.
#[track_caller]
fn stated(name: &str, curve: &Curve, times: [f64; 3]) {
    let stated = [curve.size.largest, curve.size.slope, curve.size.conditioning];
    for ((sampled, stated), times) in sampled(curve, 0.0).into_iter().zip(stated).zip(times) {
        assert!(sampled <= stated * (1.0 + 1e-6), "{name}: {sampled} exceeds {stated}");
        assert!(stated <= times * sampled, "{name}: {stated} for {sampled}");
    }
}

#[test]
fn curves_of_swings() {
    for theta0 in ["1e-300", "1e-170", "1e-9", "1e-8", "0.1", "1.7", "7π/8", "0.99π"] {
        let scene = scene(&format!("theta0 = {theta0}, omega = 3"));
        let swing = swing(&scene);
        let curves = SwingCurves::new(swing, &scene.motion.omega);
        // Each slice of the conditioning is a tenth longer than the one before, at most; of the acceleration's two factors
        // each is bounded by itself.
        stated(theta0, &curves.angle(), [1.001, 1.001, 1.1]);
        stated(theta0, &curves.velocity(), [1.001, 1.001, 1.1]);
        stated(theta0, &curves.acceleration(), [1.001, 1.001, 1.11]);
        // Their slopes count with the other factor's.
        for half in [curves.half_sine(), curves.half_cosine()] {
            assert!(sampled(&half, 0.0)[0] <= half.size.largest * (1.0 + 1e-9));
        }
    }
    stated("sine", &Curve::sine(), [1.001, 1.001, 6.0]);
}

/// |θ̈|'s phase times slope is largest somewhere between the anchor and the lowest point, where samples see it.
#[test]
fn the_moment_of_accelerations() {
    let scene = scene("theta0 = 0.5, omega = 3");
    let swing = swing(&scene);
    let acceleration = SwingCurves::new(swing, &scene.motion.omega).acceleration();
    stated("of a small swing", &acceleration, [1.001, 1.001, 1.2]);
}

#[test]
fn curves_of_rotations() {
    for velocity0 in ["6.01", "7", "20", "2000"] {
        let scene = scene(&format!("velocity0 = {velocity0}, omega = 3"));
        let Regime::Rotation(rotation) = &scene.motion.regime else { panic!("a rotation") };
        let curves = RotationCurves::new(rotation, &scene.motion.omega);
        // Without the uniform part, whose slope is counted.
        let angle = curves.angle();
        let [largest, slope, conditioning] = sampled(&angle, TAU);
        assert!(
            largest <= angle.size.largest
                && slope <= angle.size.slope * (1.0 + 1e-6)
                && conditioning <= angle.size.conditioning,
            "{velocity0}"
        );
        assert!(
            angle.size.conditioning < 1.1 * conditioning,
            "{velocity0}: {} for {conditioning}",
            angle.size.conditioning
        );
        // Alone, what is periodic is steepest at the lowest point.
        let periodic = angle.periodic();
        let [largest, slope, conditioning] = sampled(&angle, 0.0);
        assert!(largest <= periodic.largest && periodic.largest < 1.8 * largest, "{velocity0}: {largest}");
        assert!((periodic.slope / slope - 1.0).abs() < 1e-5, "{velocity0}: {} for {slope}", periodic.slope);
        assert!(conditioning <= periodic.conditioning && periodic.conditioning <= 0.5001 * slope, "{velocity0}");
        for curve in [curves.velocity(), curves.acceleration()] {
            let [largest, slope, conditioning] = sampled(&curve, 0.0);
            // Differences of a velocity that hardly changes are wrong by a millionth.
            let slack = 1.0 + 1e-5;
            assert!(largest <= curve.size.largest * (1.0 + 1e-9) && slope <= curve.size.slope * slack, "{velocity0}");
            assert!(
                conditioning <= curve.size.conditioning * slack && curve.size.conditioning < 1.1 * conditioning,
                "{velocity0}: {} for {conditioning}",
                curve.size.conditioning
            );
        }
        // v₀ at the lowest point, and π at the top.
        let (fastest, turn) = (rotation.fastest.to_f64(), rotation.period.to_f64());
        assert!((angle.size.slope / (fastest * turn) - 1.0).abs() < 1e-9, "{velocity0}: {}", angle.size.slope);
        for half in [curves.half_sine(), curves.half_cosine()] {
            assert!(sampled(&half, 0.0)[0] <= half.size.largest * (1.0 + 1e-9) && !half.alternates);
        }
        // Nothing of a rotation changes its sign from turn to turn.
        assert!(![angle, curves.velocity(), curves.acceleration()].iter().any(|curve| curve.alternates));
    }
}

/// Slopes are a little more than the known suprema, 2kω and ω²·sup |sin θ|, v₀ and ω², against rounding.
#[test]
fn slopes_are_rounded_up() {
    let above = |slope: f64, known: f64| {
        let excess = slope / known - 1.0;
        assert!((5e-13..2e-12).contains(&excess), "{slope} for {known}: {excess:e}");
    };
    let swinging = scene("theta0 = 2, omega = 3");
    let swing = swing(&swinging);
    let curves = SwingCurves::new(swing, &swinging.motion.omega);
    let (fastest, anchor) = (6.0 * 1f64.sin(), swing.period.to_f64() / 2.0);
    above(curves.angle().size.slope, fastest * anchor);
    above(curves.velocity().size.slope, 9.0 * anchor);
    above(curves.acceleration().size.slope, 9.0 * fastest * anchor);
    let turning = scene("velocity0 = 7, omega = 3");
    let Regime::Rotation(rotation) = &turning.motion.regime else { panic!("a rotation") };
    let curves = RotationCurves::new(rotation, &turning.motion.omega);
    let turn = rotation.period.to_f64();
    above(curves.angle().size.slope, 7.0 * turn);
    above(curves.velocity().size.slope, 9.0 * turn);
    above(curves.acceleration().size.slope, 63.0 * turn);
    // That of what is periodic is the sum of its series.
    let excess = curves.angle().periodic().slope / (7.0 * turn - TAU) - 1.0;
    assert!((5e-10..2e-9).contains(&excess), "{excess:e}");
}

/// What depends on the anchor passed: all but the height, and cos(θ/2) with it.
#[test]
fn signs_of_swings() {
    let scene = scene("theta0 = 2");
    let swing = swing(&scene);
    let curves = SwingCurves::new(swing, &scene.motion.omega);
    for curve in [curves.angle(), curves.velocity(), curves.acceleration(), curves.half_sine()] {
        assert!(curve.alternates);
    }
    let cosine = Curve::harmonics(&[Double::ONE]);
    assert!(!curves.half_cosine().alternates && Curve::sine().alternates && cosine.alternates);
}

/// An error of the phase costs its slope, and a part relative to that from the lowest point the conditioning; one relative to
/// any other can't be told.
#[test]
fn errors_of_phases() {
    let scene = scene("theta0 = 2");
    let reductions = Task::new(&scene).reductions(&scene);
    let mut curve = Curve::sine();
    (curve.size.slope, curve.size.conditioning) = (3.0, 5.0);
    let cost = |origin, error, relative_error| {
        curve.size.phase_error(&Reduction { origin, error, relative_error, overshoot: 0.0, ..reductions[0].clone() })
    };
    assert_eq!(cost(Origin::Lowest, 0.5, 0.25), 1.5 * 1.25 + 1.25);
    assert_eq!([cost(Origin::Anchor, 0.5, 0.0), cost(Origin::Anchor, 0.5, 0.25)], [1.5, f64::INFINITY]);
}

/// Phases that overshoot half an anchor go where a phase times the slope there is more than it is anywhere before: of a
/// velocity below 90° it is largest there.
#[test]
fn conditioning_beyond_half_an_anchor() {
    let scene = scene("theta0 = 1");
    let velocity = SwingCurves::new(swing(&scene), &scene.motion.omega).velocity();
    let reductions = Task::new(&scene).reductions(&scene);
    let beyond = Reduction { origin: Origin::Lowest, overshoot: 0.01, ..reductions[0].clone() };
    let relative = |z: f64| z * velocity.steepness(0.5 - z);
    let met = (0..=510).map(|index| relative(f64::from(index) / 1000.0)).fold(0.0, f64::max);
    let Size { conditioning, .. } = velocity.size;
    assert!(met > conditioning && met <= velocity.size.conditioning(&beyond), "{met} {conditioning}");
}

/// What a tolerance comes to is no more than that again.
#[test]
fn tolerances_in_units() {
    let mut random = Random::new(3);
    for _ in 0..10_000 {
        let (tol, unit) = (random.unit(), 10.0 * random.unit());
        let within = Size { unit, ..Curve::sine().size }.within(tol);
        assert!(within / unit <= tol && within >= tol * unit * (1.0 - 4e-16), "{tol} {unit}");
    }
}

/// Sums of harmonics are what they say.
#[test]
fn sums_of_harmonics() {
    let weights = [0.7, -0.1, 0.01].map(Double::new);
    let curve = Curve::harmonics(&weights);
    for s in [0.0, 0.1, 0.37, 0.5] {
        let wave = |n: f64| (n * std::f64::consts::PI * s).cos();
        let known = 0.7 * wave(1.0) - 0.1 * wave(3.0) + 0.01 * wave(5.0);
        assert!((curve.at(Double::new(s)).hi - known).abs() < 1e-15, "{s}");
    }
    assert!(curve.alternates && curve.omitted() == 0.0);
}

/// The sum of the first terms of a series differs from it by about the next, and is bounded by no more in its strip.
#[test]
fn first_terms() {
    for theta0 in ["1", "7π/8", "π - 1e-9"] {
        let scene = scene(&format!("theta0 = {theta0}"));
        let swing = swing(&scene);
        let curves = SwingCurves::new(swing, &scene.motion.omega);
        for whole in [curves.angle(), curves.velocity()] {
            let first = whole.clone().first(4);
            let [.., fourth, fifth] = &whole.terms()[..5] else { panic!("more terms") };
            assert_eq!((first.terms().last(), first.omitted_slope()), (Some(fourth), 0.0));
            // What six numbers lose to underflow.
            assert_eq!(first.omitted(), 6.0 * LOST);
            // About an anchor cosines are all there is; half-way all sines are.
            let s = Double::new(if whole.parity() == Parity::Even { 0.0 } else { 0.5 });
            let apart = (whole.at(s) - first.at(s)).hi.abs() / fifth.1.hi.abs();
            // The next ones are each smaller by the nome, but for 1 + q²ⁿ⁻¹, and of the velocity they add up.
            let most = 2.0 / (1.0 - swing.elliptic.nome.to_f64());
            assert!((0.5..most).contains(&apart), "{theta0}: {apart}");
            let height = 0.9 * whole.strip();
            assert!(first.strip() == whole.strip() && first.bound(height) < whole.bound(height), "{theta0}");
        }
    }
}

/// What a series leaves out of the derivative is about what it leaves out times the first m·π left out, and the terms
/// that follow.
#[test]
fn omitted_slopes() {
    for theta0 in ["1", "7π/8", "0.999π"] {
        let scene = scene(&format!("theta0 = {theta0}"));
        let swing = swing(&scene);
        let theta = SwingCurves::new(swing, &scene.motion.omega).angle();
        let first = f64::from(theta.terms().last().unwrap().0 + 2) * std::f64::consts::PI;
        let times = theta.omitted_slope() / (theta.omitted() * first);
        assert!((1.0 - 1e-12..1.1).contains(&times), "{theta0}: {times}");
        assert_eq!(Curve::sine().omitted_slope(), 0.0);
    }
}

/// Sums of harmonics are rounded by no more than they say, and by next to nothing.
#[test]
fn values_are_sums() {
    for theta0 in ["0.1", "7π/8", "π - 1e-9", "π - 1e-40"] {
        let scene = scene(&format!("theta0 = {theta0}"));
        let swing = swing(&scene);
        let curves = SwingCurves::new(swing, &scene.motion.omega);
        let context = swing.amplitude.context();
        for curve in [curves.angle(), curves.velocity(), curves.acceleration(), curves.half_sine()] {
            for s in [0.0, 0.0625, 0.3, 0.49, 0.5, -0.2] {
                let turn = context.pi() * context.float(s).unwrap();
                let term = |&(m, a): &(u32, Double)| {
                    let (sine, cosine) = (&turn * context.integer(i64::from(m))).sin_cos();
                    let wave = if curve.parity() == Parity::Even { cosine } else { sine };
                    wave * (context.float(a.hi).unwrap() + context.float(a.lo).unwrap())
                };
                let exact = curve.terms().iter().map(term).fold(context.integer(0), |sum, term| sum + term);
                let error = (curve.at(Double::new(s)) - exact.to_double()).hi.abs();
                let (most, sum) = (curve.sampling_error(), curve.size.largest);
                assert!(error <= most && most < 1e-22 * sum, "{theta0} {s}: {error:e}, at most {most:e} of {sum}");
            }
        }
    }
}

/// In a unit whose smallest parts are next to the smallest numbers a series is that in units of 1, but for what it says.
#[test]
fn values_that_underflow() {
    let unit = Double::new(two_to(-1016));
    for start in ["theta0 = 1", "theta0 = π - 1e-9", "velocity0 = 2 + 1e-9", "velocity0 = 3"] {
        let (regime, rate) = (scene(start).motion.regime, Double::new(0.03));
        let in_units = |unit: Double| match &regime {
            Regime::Swing(swing) => Wave::swing(swing, 2, rate, unit),
            Regime::Rotation(rotation) => Wave::rotation(rotation, 2, rate, unit),
            Regime::Separatrix(_) => panic!("harmonics"),
        };
        let [one, small] = [Double::ONE, unit].map(in_units);
        for s in [0.0, 0.05, 0.3, 0.49, -0.2] {
            let [value, exact] = [&small, &one].map(|wave| wave.at(Double::new(s)));
            // The words of the one are multiples of those of the other, or below the smallest number.
            let error = (value.hi - exact.hi * unit.hi).abs() + (value.lo - exact.lo * unit.hi).abs();
            let most = small.sampling_error() + small.omitted();
            assert!(error <= most + f64::from_bits(2), "{start} {s}: {error:e}, at most {most:e}");
            assert!(most < f64::from_bits(16 * small.terms().len() as u64 + 1024), "{start}: {most:e}");
        }
    }
}
