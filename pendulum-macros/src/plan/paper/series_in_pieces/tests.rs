//! The series of θ: its terms, its error, and its sum in pieces.

use super::super::tests::{planned, truncation};
use super::super::*;
use crate::plan::tests::probe::largest_error;
use crate::testing::{Random, scene, swing};

/// The error of the series is the supremum of its tail, here from samples of it. (It isn't θ0 less the sum, which is the
/// error at t = 0: elsewhere it is larger by twice the nome.)
#[test]
fn the_error_of_the_series_is_that_of_its_tail() {
    for (theta0, tol) in [("1", 1e-5), ("7π/8", 1e-4), ("0.999π", 1e-3), ("0.99π", 1e-9)] {
        let text = format!("theta0 = {theta0}, tol = {tol}, method = series");
        let (scene, plan) = (scene(&text), planned(&text).unwrap());
        let swing = swing(&scene);
        let terms = SwingCurves::new(swing, &scene.motion.omega).angle().terms().to_vec();
        let error = |kept: usize| {
            let at = |i: u32| {
                let phi = std::f64::consts::PI * f64::from(i) / 4000.0;
                terms.iter().skip(kept).map(|&(m, a)| a.hi * (f64::from(m) * phi).cos()).sum::<f64>().abs()
            };
            (0..=2000).map(at).fold(0.0, f64::max)
        };
        let (stated, exact) = (truncation(&plan), error(plan.terms));
        assert!(exact <= stated && stated <= 1.025 * exact, "{text}: {stated:e} {exact:e}");
        assert!(error(plan.terms - 1) > 0.95 * tol, "{text}: one less would do");
    }
}

/// Half as much again as the first term left out is enough for it and all that follow.
#[test]
fn the_series_takes_no_term_too_many() {
    let text = |tol: f64| format!("theta0 = 1, tol = {tol:e}, method = series");
    let scene = scene(&text(1.0));
    let swing = swing(&scene);
    for (left_out, &(_, a)) in
        SwingCurves::new(swing, &scene.motion.omega).angle().terms().iter().enumerate().skip(1).take(3)
    {
        assert_eq!(planned(&text(1.5 * a.hi.abs())).unwrap().parts[0].kernel.core.terms(), left_out);
    }
}

/// At full precision the series leaves a unit of rounding of θ0 and takes no term more: each is smaller by the nome.
#[test]
fn the_series_at_full_precision() {
    for (theta0, float) in [("1e-5", "f64"), ("1", "f64"), ("7π/8", "f64"), ("7π/8", "f32")] {
        let text = format!("theta0 = {theta0}, method = series, float = {float}");
        let (scene, plan) = (scene(&text), planned(&text).unwrap());
        let swing = swing(&scene);
        let aim = scene.float.rounding_unit() * swing.amplitude.to_f64();
        let (stated, nome) = (truncation(&plan), swing.elliptic.nome.to_f64());
        assert!(stated <= aim && stated >= 0.9 * nome * aim, "{text}: {stated:e} of {aim:e}");
    }
}

/// Where the recurrence is rounded by more than full precision leaves, or has too many harmonics, their sum is taken in
/// pieces: what is promised is kept, and no recurrence would do.
#[test]
fn the_series_in_pieces() {
    let mut random = Random::new(4);
    for (start, float) in [
        ("theta0 = 0.9π, outputs = [velocity]", "f64"),
        ("theta0 = -0.995π", "f64"),
        ("theta0 = 0.999π, t_max = 1e6, outputs = [velocity]", "f64"),
        ("theta0 = 2, velocity0 = 3.23, omega = 3, outputs = [velocity]", "f64"),
        ("theta0 = 0.999999π, outputs = [velocity]", "f32"),
        ("theta0 = π - 1e-9, t_max = 100", "f32"),
        ("theta0 = π - 1e-9, tol = 3e-14", "f64"),
        ("theta0 = π - 1e-9", "f64"),
        ("theta0 = π - 1e-9, outputs = [velocity]", "f64"),
        ("theta0 = -0.9π, outputs = [acceleration]", "f64"),
        ("theta0 = π - 1e-6, omega = 3, t_max = 100, outputs = [acceleration]", "f64"),
        ("theta0 = π - 1e-4, outputs = [acceleration]", "f32"),
    ] {
        let text = format!("struct A; {start}, method = series, float = {float}");
        let (scene, plan) = (scene(&text), planned(&text).unwrap());
        let part = &plan.parts[0];
        assert!(part.description.contains("harmonics, their sum as"), "{text}: {}", part.description);
        assert_eq!((plan.method, &plan.terms.to_string()[..]), ("series", part.description.split(' ').next().unwrap()));
        let promise = match scene.goal {
            Goal::Tolerance(tol) => tol,
            _ => FULL * scene.float.rounding_unit() * part.largest,
        };
        let error = largest_error(&text, &scene, &plan, &mut random, 6);
        let bound = part.bound.total();
        assert!(bound <= promise, "{text}: {error:e} {bound:e} {promise:e}");
        assert!(error <= promise / 2.0 || text.contains("tol"), "{text}: {error:e} {promise:e}");
    }
}

/// What is offered instead of what is out of reach is kept.
#[test]
fn the_best_of_the_series() {
    for start in ["theta0 = 0.995π", "theta0 = 0.9π, outputs = [velocity]", "theta0 = π - 1e-9"] {
        let text = |tol: f64| format!("struct A; {start}, method = series, tol = {tol:.3e}");
        let Err(Refusal::Unreachable { best }) = planned(&text(1e-16)) else { panic!("{start} was planned") };
        assert!(best < 4e-15 && planned(&text(best)).is_ok(), "{start}: {best:e}");
    }
}
