//! What is known of sums of harmonics, against the sums.

use super::*;
use crate::plan::kernel::{Core, Kernel};
use crate::plan::plan;
use crate::program::Op;
use crate::testing::{Random, scene};
use std::f64::consts::PI;

fn harmonics(text: &str) -> (Harmonics, Reduction) {
    let plan = plan(&scene(&format!("struct Motion; {text}"))).unwrap();
    let Core::Harmonics(harmonics) = &plan.parts.last().unwrap().kernel.core else { panic!("{text}: no harmonics") };
    (harmonics.as_ref().clone(), plan.reduction.clone())
}

/// The sums lie in their intervals, which are hardly longer.
#[test]
fn intervals_of_sums() {
    for text in [
        "theta0 = 2, method = series, tol = 1e-6",
        "theta0 = 2, method = series, tol = 1e-6, outputs = [velocity]",
        "theta0 = 0.73π, n = 1, outputs = [velocity]",
        "theta0 = 2, method = series, tol = 1e-6, t_max = 100",
    ] {
        let (harmonics, anchored) = harmonics(text);
        let lowest = Reduction { origin: Origin::Lowest, ..anchored.clone() };
        let in_units = Reduction { unit: Double::new(3.0), ..anchored.clone() };
        let errors = [1e-3, 1e-2];
        for (reduction, errors) in [(&anchored, [0.0; 2]), (&anchored, errors), (&lowest, errors), (&in_units, errors)]
        {
            for slice in 0..16 {
                intervals_hold(&harmonics, reduction, errors, [f64::from(slice) / 32.0, f64::from(slice + 1) / 32.0]);
            }
        }
    }
}

fn intervals_hold(harmonics: &Harmonics, reduction: &Reduction, errors: [f64; 2], [low, high]: [f64; 2]) {
    let unit = reduction.unit.hi;
    let from_anchor = |phase: f64| if reduction.origin == Origin::Anchor { phase } else { 0.5 - phase };
    let known = harmonics.sums(reduction, errors);
    let known: Vec<_> = known.iter().map(|sum| (sum.name, sum.known(reduction, low / unit, high / unit))).collect();
    let [cosines, sines] = [harmonics.cosines(), harmonics.sines().map(|sines| sines.weights.as_slice())];
    assert_eq!(known.len(), [cosines, sines].into_iter().flatten().count());
    for (name, known) in known {
        let of_sines = name == SLOPE || cosines.is_none();
        let (weights, wave, error): (_, fn(f64) -> f64, _) =
            if of_sines { (sines.unwrap(), f64::sin, errors[1]) } else { (cosines.unwrap(), f64::cos, errors[0]) };
        let at = |part: f64| {
            let s = from_anchor(low + (high - low) * part);
            weights.iter().enumerate().map(|(n, w)| w.hi * wave((2 * n + 1) as f64 * PI * s)).sum::<f64>()
        };
        let values: Vec<f64> = (0..=20).map(|i| at(f64::from(i) / 20.0)).collect();
        let (least, most) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &x| (a.min(x), b.max(x)));
        assert!(known.low <= least - known.error && known.high >= most + known.error, "{name} {low}: {known:?}");
        let sum = if harmonics.folded().is_some() {
            error
        } else {
            let sine = of_sines.then_some(errors[1]);
            let [low, high] = [low, high].map(from_anchor);
            let of = if of_sines { Cosines::integral_of_sines } else { Cosines::odd };
            let known = of(weights).over(low, high);
            Recurrence::new(weights, errors[0], sine, reduction.float).error(low, high, &known)
        };
        assert!((known.error / sum - 1.0).abs() < 1e-12 || sum == 0.0, "{name}: {:e} {sum:e}", known.error);
        // What Taylor's theorem leaves is little beside what the sum does in the interval.
        let [below, above] = [least - sum - known.low, known.high - most - sum];
        let room = 0.2 * (most - least) + 0.02 * most.abs().max(least.abs());
        assert!(below <= room && above <= room, "{name} {low}: {known:?} for {least} to {most}");
    }
}

/// Of the cosine and the sine themselves.
#[test]
fn errors_of_cosine_and_sine() {
    for (text, float) in [("tol = 1e-6", "f64"), ("tol = 1e-3", "f32")] {
        let (harmonics, reduction) =
            harmonics(&format!("theta0 = 2, method = series, {text}, float = {float}, outputs = [velocity]"));
        let unit = reduction.float.rounding_unit();
        let [cosine, sine] = harmonics.errors(&reduction);
        assert!(
            (0.5 * unit..7.0 * unit).contains(&cosine) && (0.5 * unit..7.0 * unit).contains(&sine),
            "{cosine:e} {sine:e}"
        );
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
        let kernel = Kernel::from(Core::Harmonics(Box::new(harmonics.clone())));
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
            let weights =
                if velocity { harmonics.sines().unwrap().weights.as_slice() } else { harmonics.cosines().unwrap() };
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
