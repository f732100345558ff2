//! Bounds of approximations against dense samples: never exceeded, and no more than a few times too large.

use super::super::Polynomial;
use super::*;
use crate::chebyshev::value;
use crate::parse::Float;
use crate::plan::form::Form;
use crate::plan::reduction::Reduction;
use crate::plan::task::Task;
use crate::testing::scene;

pub(in super::super) const PLAIN: Form = Form::Powers { shift: 0.0, largest_last: false };

impl Polynomial {
    /// At the phase s from an anchor, in anchors.
    fn at(&self, s: Double) -> Double {
        let p = s * s;
        let x = if self.form == Form::Normalised { p * 8.0 } else { p } + self.shift;
        let sum = self.blocks.powers().iter().rev().fold(Double::ZERO, |sum, c| sum * x + *c);
        let over = self.over().map_or(Double::ONE, |(numerator, pole)| pole.at(p * 8.0 - Double::ONE) / numerator);
        sum / over * if self.parity == Parity::Odd { s } else { Double::ONE }
    }
}

/// The nearest poles of that power, if it is one.
pub(in super::super) fn nearest(curve: &Curve, power: usize) -> Option<Pole> {
    (power > 0).then(|| Pole::new(curve.strip(), power, Float::F64))
}

/// sup |polynomial − curve| for |s| ≤ ½ + `overshoot`.
fn sampled(polynomial: &Polynomial, curve: &Curve, overshoot: f64) -> f64 {
    const SAMPLES: u32 = 120;
    let at = |i: u32| {
        // Denser at the ends.
        let part = (std::f64::consts::FRAC_PI_2 * f64::from(i) / f64::from(SAMPLES)).sin();
        let s = Double::new((0.5 + overshoot) * part);
        (polynomial.at(s) - curve.at(s)).hi.abs()
    };
    (0..=SAMPLES).map(at).fold(0.0, f64::max)
}

/// All curves of a motion, and the power of their poles.
pub(in super::super) fn curves(text: &str) -> (Vec<(Curve, usize)>, Reduction) {
    let scene = scene(&format!("struct Motion; {text}, outputs = [theta, velocity, acceleration, position]"));
    let task = Task::new(&scene);
    let unlike = |reduction: &Reduction| (reduction.unit.hi - 1.0).abs();
    let reductions = task.reductions(&scene).into_iter();
    let reduction = reductions.min_by(|a, b| unlike(a).total_cmp(&unlike(b))).unwrap();
    let aims = task.aims.iter().flat_map(|aim| aim.curves.iter().map(|curve| (curve.clone(), aim.power)));
    (aims.collect(), reduction)
}

/// Widened as far as a reduction in `f64` does, and as one in `f32` of a long horizon may, in forms of which either end has
/// the largest variable. Farther out the bound of what interpolation leaves grows faster than that.
#[test]
fn truncation_errors() {
    let forms = [Form::Powers { shift: -0.15625, largest_last: false }, PLAIN, Form::Normalised];
    let widened = [(0.0, 1.2), (1e-4, 1.3), (0.01, 1.4), (0.1, f64::INFINITY)];
    for text in ["theta0 = 1", "theta0 = 7π/8", "theta0 = 0.99π", "velocity0 = 2.1", "velocity0 = 4"] {
        let (curves, reduction) = curves(text);
        for (index, (curve, power)) in curves.iter().enumerate() {
            for power in [0, *power] {
                let approximation = Approximation::new(curve, nearest(curve, power), 1e-20).unwrap();
                for ((overshoot, most), terms) in widened.iter().flat_map(|of| [3, 6, 11].map(|terms| (*of, terms))) {
                    let reduction = Reduction { overshoot, ..reduction.clone() };
                    let truncated = approximation.truncated(terms, &reduction, false);
                    for form in forms {
                        let polynomial = truncated.in_powers(form);
                        let (bound, seen) = (polynomial.truncation, sampled(&polynomial, curve, overshoot));
                        let about = format!("{text} {index} {power} {terms} {overshoot} {form:?}");
                        assert!(seen <= bound && bound <= most * seen, "{about}: {seen:e} of {bound:e}");
                    }
                }
            }
        }
    }
}

/// A whole series is wrong by what its interpolation is, bounded on an ellipse: crudely, but with at most five points
/// more than would have done.
#[test]
fn interpolation_errors() {
    for text in ["theta0 = 1", "theta0 = 7π/8", "velocity0 = 2.1"] {
        let (curves, reduction) = curves(text);
        for (index, (curve, power)) in curves.iter().enumerate() {
            let precise = Approximation::new(curve, nearest(curve, *power), 1e-20).unwrap();
            for negligible in [1e-3, 1e-7] {
                let approximation = Approximation::new(curve, nearest(curve, *power), negligible).unwrap();
                let polynomial = approximation.truncated(approximation.terms(), &reduction, false).in_powers(PLAIN);
                let (bound, seen) = (polynomial.truncation, sampled(&polynomial, curve, 0.0));
                let about = format!("{text} {index} {negligible}: {seen:e} of {bound:e}");
                assert!(seen <= bound && bound <= 1.01 * negligible, "{about}");
                let needed = precise.terms_for(negligible, 0.0).unwrap();
                assert!(
                    approximation.terms() <= 2 * needed + 1,
                    "{about}: {} terms, {needed} needed",
                    approximation.terms()
                );
            }
        }
    }
}

/// Near the top one polynomial takes more points than there may be.
#[test]
fn too_many_points() {
    let (curves, _) = curves("theta0 = π - 1e-60");
    assert!(Approximation::new(&curves[0].0, None, 1e-3).is_some());
    assert!(Approximation::new(&curves[0].0, None, 1e-20).is_none());
}

/// What an error of the polynomial is multiplied with: by s ≤ ½ if it is odd, and over the least value of its poles; and
/// a little for the rounding of sums.
#[test]
fn weights() {
    let (curves, _) = curves("theta0 = 7π/8");
    for (index, power, odd) in [(0, 0, 1.0), (1, 0, 0.5), (1, 1, 0.5), (2, 2, 1.0)] {
        let approximation = Approximation::new(&curves[index].0, nearest(&curves[index].0, power), 1e-12).unwrap();
        let least = approximation.pole.map_or(1.0, |pole| pole.least(0.5));
        let excess = approximation.weight(0.0) / (odd / least) - 1.0;
        assert!((5e-13..2e-12).contains(&excess), "{index} {power}");
        assert_eq!(approximation.pole.is_some(), power > 0);
    }
}

/// Terms that a curve's series omits change the value by so much, twice if it is even, times what poles are at most over
/// what they are at least.
#[test]
fn omitted_terms() {
    let (curves, _) = curves("theta0 = 7π/8");
    for (index, power) in [(0, 0), (1, 0), (1, 1), (2, 2)] {
        let truncation = |omitted: f64| {
            let curve = curves[index].0.clone().omitting(omitted);
            let approximation = Approximation::new(&curve, nearest(&curve, power), 1e-9).unwrap();
            (approximation.truncation(approximation.terms(), 0.0), approximation.pole)
        };
        let ((less, pole), (more, _)) = (truncation(0.0), truncation(1.0));
        let times = pole.map_or(1.0, |pole| pole.most(0.5) / pole.least(0.5));
        let odd = if curves[index].0.parity() == Parity::Odd { 1.0 } else { 2.0 };
        assert!(((more - less) / (odd * times) - 1.0).abs() < 1e-9, "{index} {power}: {more} {less}");
    }
}

/// Two at least, also of a motion as good as uniform.
#[test]
fn terms_of_nearly_nothing() {
    let (curves, _) = curves("velocity0 = 1e6");
    let approximation = Approximation::new(&curves[1].0, None, 1.0).unwrap();
    assert_eq!((approximation.terms(), approximation.terms_for(1.0, 0.0)), (2, Some(2)));
}

fn magnitudes(approximation: &Approximation, terms: usize) -> f64 {
    (terms..approximation.series.len()).map(|j| approximation.without(j, 0.0)).sum::<f64>()
        + approximation.least_truncation(0.0)
}

/// What is cut at once and what is cut later is the same error.
#[test]
fn dropped_terms() {
    let (curves, _) = curves("theta0 = 7π/8");
    for (index, power) in [(0, 0), (1, 1)] {
        let curve = &curves[index].0;
        let pole = nearest(curve, power);
        let interpolation = Interpolation { points: 30, rho: 3.0, error: 1e-9 };
        let approximation = |negligible: f64| Approximation::with_points(curve, pole, negligible, &interpolation);
        let (long, short) = (approximation(0.0), approximation(1e-2));
        let terms = short.terms();
        assert!(long.terms() == 30 && terms + 3 < 30);
        for terms in [terms, terms - 1] {
            let (long, short) = (magnitudes(&long, terms), magnitudes(&short, terms));
            assert!((long / short - 1.0).abs() < 1e-14, "{index}: {long:e} {short:e}");
        }
        let sum = short.series.iter().map(|c| c.hi.abs()).sum::<f64>() + short.remainder;
        let excess = magnitudes(&short, 0) / (sum * short.weight(0.0)) - 1.0;
        assert!(excess.abs() < 1e-14, "{index}: {excess:e}");
    }
}

/// A thousandth of an anchor beyond the interval's end Tⱼ is cosh(j arcosh(1 + ε)), an odd curve a five-hundredth
/// longer; half an anchor beyond it nothing is known.
#[test]
fn truncation_beyond_the_end() {
    const BEYOND: f64 = 1e-3;
    let (curves, _) = curves("theta0 = 7π/8");
    for (index, odd) in [(0, 1.0), (1, 1.0 + 2.0 * BEYOND)] {
        let approximation = Approximation::new(&curves[index].0, None, 1e-9).unwrap();
        let last = approximation.terms() - 1;
        for weight in [Approximation::weight, Approximation::weight_beyond] {
            let stretch = weight(&approximation, BEYOND) / weight(&approximation, 0.0);
            assert!((stretch - odd).abs() < 1e-12, "{index}: {stretch}");
        }
        let exact = |j: usize| (j as f64 * (1.0 + 8.0 * BEYOND * (1.0 + BEYOND)).acosh()).cosh();
        if index == 0 {
            // Of a single term, for which others don't make up.
            let term = |beyond| approximation.truncation(last, beyond) - approximation.truncation(last + 1, beyond);
            let stretch = term(BEYOND) / term(0.0);
            assert!(stretch >= exact(last) && stretch <= 1.01 * exact(last), "{stretch}");
        }
        // Of the points, the tail that follows included.
        let stretch = approximation.truncation(last + 1, BEYOND) / approximation.truncation(last + 1, 0.0);
        let Growth::Points { points, .. } = approximation.growth else { panic!("an interpolant") };
        let first = exact(points);
        assert!(stretch > first && stretch < 1.5 * first, "{index}: {stretch} {first}");
        assert_eq!(approximation.truncation(last, 0.5), f64::INFINITY);
    }
}

/// Beyond the end an odd curve's phase is longer and poles may be nearer: never below what is found there, and hardly
/// above.
#[test]
fn what_is_left_out_beyond_the_end() {
    const BEYOND: f64 = 0.005;
    let (curves, _) = curves("theta0 = 7π/8");
    for (index, place) in [(0, None), (1, None), (0, Some(0.3)), (1, Some(0.3)), (1, Some(0.26))] {
        let pole = place.and_then(|place| Pole::of([place * place + 1e-3, -2.0 * place], Float::F64));
        let approximation = Approximation::new(&curves[index].0, pole, 1e-12).unwrap();
        for terms in [3, 5] {
            let at = |s: f64| {
                let u = Double::new(8.0 * s * s - 1.0);
                let kept = &approximation.shortened(terms, BEYOND).series;
                let dropped = value(&approximation.series, u) - value(kept, u);
                let weight = if index == 1 { s } else { 1.0 };
                dropped.hi.abs() * weight / pole.map_or(1.0, |pole| pole.at(u).hi.abs())
            };
            let seen = (0..=2000).map(|i| at((0.5 + BEYOND) * f64::from(i) / 2000.0)).fold(0.0, f64::max);
            let bound = approximation.truncation(terms, BEYOND);
            assert!(seen <= bound && bound < 1.02 * seen, "{index} {place:?} {terms}: {bound:e} for {seen:e}");
        }
    }
}

/// Of a wrong phase the truncation and what the error makes where the curve is steepest are together never below what is
/// found, and hardly above; and they take less than the parts would.
#[test]
fn errors_with_a_leeway() {
    const ERROR: f64 = 5e-6;
    let (curves, reduction) = curves("theta0 = 7π/8");
    let curve = &curves[0].0;
    for (place, terms) in [(None, 7), (Some((0.1772, 0.1319)), 4)] {
        let pole = place.and_then(|(place, height)| Pole::of([place * place + height, -2.0 * place], Float::F64));
        let strict = Approximation::new(curve, pole, 1e-12).unwrap();
        let lenient = strict.with(Leeway::new(curve, [ERROR, 0.0], 2.0));
        let polynomial = lenient.truncated(terms, &reduction, false).in_powers(PLAIN);
        let phase = ERROR * curve.size.slope;
        let error = |i: u32| {
            let s = Double::new(0.25 - 0.25 * (f64::from(i) * std::f64::consts::PI / 2000.0).cos());
            let apart = |error: f64| (polynomial.at(s) - curve.at(s + Double::new(error))).hi.abs();
            apart(ERROR).max(apart(-ERROR))
        };
        let seen = (0..=2000).map(error).fold(0.0, f64::max);
        let bound = polynomial.truncation + phase;
        assert!(seen <= bound && bound < 1.05 * seen, "{place:?} {terms}: {seen:e} of {bound:e}");
        let (least, most) = (polynomial.truncation, strict.truncation(terms, 0.0));
        assert!(least < 0.85 * most, "{place:?} {terms}: {least:e} {most:e}");
    }
}

/// A known error grows by a power of the ellipse's parameter.
#[test]
fn growth_of_known_errors() {
    let growth = Growth::Power { power: 50.0, log_rho: 5e-3 };
    let approximation = Approximation::known(None, vec![Double::ONE; 6], 1e-9, growth);
    let stretch = approximation.truncation(6, 1e-6) / approximation.truncation(6, 0.0);
    assert!((stretch / (50.0 * 4e-3f64).exp() - 1.0).abs() < 1e-6, "{stretch}");
    assert_eq!(approximation.truncation(6, 2e-6), f64::INFINITY);
}

/// 4Bρ^(1−M)/(ρ − 1) with the bounds of the curve and of its poles, over s if it is odd, on the image of the ellipse:
/// there s = ½ cos φ with Im φ = ½ ln ρ, and |s| is from ½ sinh ½ ln ρ to ½ cosh ½ ln ρ.
fn interpolation_error(curve: &Curve, pole: Option<Pole>, (half_log, bound): (f64, f64), points: usize) -> f64 {
    let (nearest, farthest) = (0.5 * half_log.sinh(), 0.5 * half_log.cosh());
    let odd = if curve.parity() == Parity::Odd { nearest } else { 1.0 };
    let bound = bound * pole.map_or(1.0, |pole| pole.most(farthest)) / odd;
    let rho = (2.0 * half_log).exp();
    4.0 * bound * rho.powf(1.0 - points as f64) / (rho - 1.0)
}

/// The error is that of the best ellipse, which near the top is one between the poles: there it takes a third of the
/// points.
#[test]
fn points_and_their_error() {
    for (text, fewer) in
        [("theta0 = 1", 1.0), ("theta0 = 7π/8", 1.2), ("theta0 = 0.9999999π", 2.3), ("velocity0 = 2.000001", 2.0)]
    {
        let (curves, _) = curves(text);
        for (index, (curve, power)) in curves.iter().enumerate() {
            for power in [0, *power] {
                let pole = nearest(curve, power);
                let Interpolation { points, error, .. } = enough_points(curve, pole, 1e-12).unwrap();
                let all = || curve.ellipses();
                let best = all().map(|ellipse| (error / interpolation_error(curve, pole, ellipse, points) - 1.0).abs());
                assert!(error <= 1e-12 && best.fold(1.0, f64::min) < 1e-9, "{text} {index} {power}: {error:e}");
                let fail = |ellipse| interpolation_error(curve, pole, ellipse, points - 1) > 1e-12;
                assert!(points == FEWEST_POINTS || all().all(fail), "{text} {index} {power}: {points}");
                let strip = all().take(curve.heights().len());
                let alone = (points..1000).find(|&points| {
                    strip.clone().any(|ellipse| interpolation_error(curve, pole, ellipse, points) <= 1e-12)
                });
                let times = alone.unwrap() as f64 / points as f64;
                assert!(times >= fewer, "{text} {index} {power}: {times}");
            }
        }
    }
}
