//! What is known of sums of harmonics, against the sums; and the recurrence, evaluated.

use super::*;
use crate::fuzz::random::Random;
use crate::parse::Float;
use crate::plan::plan;
use crate::plan::tests::scene;
use std::f64::consts::PI;

/// Operation by operation, for two weights: u₂ = b, X = 4c² − 2, Xu₂, u₁ = a + Xu₂, u₁ − u₂, c(u₁ − u₂).
#[test]
fn errors_of_the_recurrence() {
    let (a, b, unit, cosine) = (0.75, 0.125, 1e-3, 1e-5);
    let weights = [a, b].map(Double::new);
    assert_eq!([0, 1, 2].map(|n| total(&weights, n)), [a + 2.0 * b, b, 0.0]);
    let found = recurrence_error(&weights, cosine, unit);
    // |u₁| ≤ a + 2b. A constant, a product below 2b, their sum; and u₂'s constant, which counts as three roundings too.
    let (first, second) = (a + (2.0 * b + 2.0 * b) + (a + 2.0 * b) + a, 3.0 * b);
    // X is off by 8|c| errors of the cosine and by the roundings of 4c² ≤ 4 and of itself.
    let x = (8.0 * cosine + 6.0 * unit) * b;
    // The difference and the product.
    let last = 2.0 * (a + 3.0 * b);
    let expected = unit * (first + second + last) + x;
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} for {expected}");
    let single = recurrence_error(&[Double::new(a)], cosine, unit);
    assert!((single / (5.0 * a * unit) - 1.0).abs() < 1e-12, "{single}");
}

/// Clenshaw's recurrence of cosines and sines, with each number of weights.
#[test]
fn the_recurrence() {
    for count in 1..=5 {
        let weights: Vec<Double> = (0..count).map(|n| Double::new(0.7 / f64::from(1 + 3 * n))).collect();
        let mut b = Builder::new(Float::F64);
        let cosine = b.input();
        let (first, second) = clenshaw(&mut b, cosine, &weights);
        let zero = b.constant(0.0);
        let program = b.finish(vec![first, second.unwrap_or(zero)]);
        for s in [0.1f64, 0.4, 1.1] {
            let sum = |wave: fn(f64) -> f64| {
                weights.iter().enumerate().map(|(n, w)| w.hi * wave((2 * n + 1) as f64 * s)).sum::<f64>()
            };
            let found = program.run(s.cos());
            assert!((s.cos() * (found[0] - found[1]) - sum(f64::cos)).abs() < 1e-14, "{count} {s}");
            assert!((s.sin() * (found[0] + found[1]) - sum(f64::sin)).abs() < 1e-14, "{count} {s}");
        }
    }
}

fn harmonics(text: &str) -> (Harmonics, Reduction) {
    let plan = plan(&scene(&format!("struct Motion; {text}"))).unwrap();
    let Kernel::Harmonics(harmonics) = &plan.parts.last().unwrap().kernel else { panic!("{text}: no harmonics") };
    (harmonics.as_ref().clone(), plan.reduction.clone())
}

/// The intervals hold the sums, and are hardly wider than they.
#[test]
fn intervals_of_sums() {
    for text in [
        "theta0 = 2, method = series, tol = 1e-6",
        "theta0 = 2, method = series, tol = 1e-6, outputs = [velocity]",
        "theta0 = 2, n = 3, outputs = [velocity]",
        "theta0 = 2, method = series, tol = 1e-6, t_max = 100",
    ] {
        let (harmonics, reduction) = harmonics(text);
        let unit = reduction.unit.hi;
        for errors in [[0.0; 2], [1e-3, 1e-2]] {
            for slice in 0..64 {
                let (low, high) = (f64::from(slice) / 128.0, f64::from(slice + 1) / 128.0);
                let known = harmonics.known(&reduction, errors, low / unit, high / unit);
                assert_eq!(
                    known.len(),
                    usize::from(!harmonics.cosines.is_empty()) + usize::from(!harmonics.sines.is_empty())
                );
                for (name, known) in known {
                    let (weights, wave): (_, fn(f64) -> f64) =
                        if name == "slope" { (&harmonics.sines, f64::sin) } else { (&harmonics.cosines, f64::cos) };
                    let at = |i: i32| {
                        let phase = low + (high - low) * f64::from(i) / 20.0;
                        let s = if reduction.origin == Origin::Anchor { phase } else { 0.5 - phase };
                        weights.iter().enumerate().map(|(n, w)| w.hi * wave((2 * n + 1) as f64 * PI * s)).sum::<f64>()
                    };
                    let values: Vec<f64> = (0..=20).map(at).collect();
                    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
                    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                    let error = if name == "slope" { errors[1] } else { errors[0] };
                    // An error of the factor counts with the largest sum there can be, that of the cosine of X eight times for
                    // each weight.
                    let sum: f64 = weights.iter().map(|w| w.hi.abs()).sum();
                    assert!(known.error >= sum * error, "{text} {slice} {name}: {:e}", known.error);
                    let most_error = (sum + 1.0) * (40.0 * error.max(errors[0]) + 60.0 * reduction.float.unit()) * 4.0;
                    assert!(known.error <= most_error, "{text} {slice} {name}: {:e} {most_error:e}", known.error);
                    let bend: f64 =
                        weights.iter().enumerate().map(|(n, w)| w.hi.abs() * ((2 * n + 1) as f64 * PI).powi(2)).sum();
                    let slack = bend / (8.0 * 128.0 * 128.0);
                    assert!(
                        known.low <= least - known.error && known.high >= most + known.error,
                        "{text} {slice} {name}"
                    );
                    let near = 1e-12 + slack * 1.000_001 + known.error;
                    let wave_slack = bend / (8.0 * 128.0 * 128.0);
                    assert!(known.low >= least - near - wave_slack, "{text} {slice} {name}: {known:?} {least}");
                    assert!(known.high <= most + near + wave_slack, "{text} {slice} {name}: {known:?} {most}");
                }
            }
        }
    }
}

/// The rounding of whole kernels is more than is ever seen, and not a hundred times as much.
#[test]
fn rounding_of_kernels() {
    let mut random = Random::new(5);
    for text in
        ["theta0 = 2, method = series, tol = 1e-6", "theta0 = 2, method = series, tol = 1e-6, outputs = [velocity]"]
    {
        let (harmonics, reduction) = harmonics(text);
        let kernel = Kernel::Harmonics(Box::new(harmonics.clone()));
        let bound = kernel.rounding(&reduction, f64::INFINITY);
        let velocity = harmonics.is_odd();
        let program = crate::plan::kernel::function(&reduction, &[&kernel]);
        let phase = program.named("s").unwrap();
        let mut seen = 0.0_f64;
        for _ in 0..4000 {
            let s = 0.5 * random.unit();
            // The program with its phase given.
            let mut given = program.clone();
            given.nodes[phase].op = Op::Constant { value: s, rest: 0.0 };
            let found = given.run(0.0)[0];
            let weights = if velocity { &harmonics.sines } else { &harmonics.cosines };
            let wave = |n: usize| {
                let x = Double::new(s) * (2 * n + 1) as f64;
                let turns = (0.5 * x.hi).round_ties_even() * 2.0;
                let x = x - Double::new(turns);
                if velocity { crate::chebyshev::sin_pi(x) } else { crate::chebyshev::cos_pi(x) }
            };
            let exact = weights.iter().enumerate().fold(Double::ZERO, |sum, (n, w)| sum + *w * wave(n));
            let error = (Double::new(found.abs()) - if exact.hi < 0.0 { -exact } else { exact }).hi.abs();
            seen = seen.max(error);
        }
        assert!(seen <= bound && bound <= 60.0 * seen, "{text}: {seen:e} of {bound:e}");
    }
}
