//! Bounds of approximations against dense samples: never exceeded, and no more than a few times too large.

use super::*;
use crate::plan::aim::Task;
use crate::plan::curve::Curve;
use crate::plan::reduction::Reduction;
use crate::plan::tests::scene;

impl Polynomial {
    /// At the phase s from an anchor, in anchors.
    fn at(&self, s: Double) -> Double {
        let (p, centre) = (s * s, self.form.centre());
        let x = if let Form::Centred { .. } = self.form { p * 8.0 - Double::new(centre) } else { p };
        let sum = self.coefficients.iter().rev().fold(Double::ZERO, |sum, c| sum * x + *c);
        let over = self.pole.map_or(Double::ONE, |pole| pole.at(p * 8.0 - Double::ONE));
        sum / over * if self.parity == Parity::Odd { s } else { Double::ONE }
    }
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
fn curves(text: &str) -> (Vec<(Curve, i32)>, Reduction) {
    let scene = scene(&format!("struct Motion; {text}, outputs = [theta, velocity, acceleration, position]"));
    let task = Task::new(&scene);
    let reduction = task.reductions(&scene).into_iter().find(|reduction| reduction.unit == Double::ONE).unwrap();
    let aims = task.aims.iter().flat_map(|aim| aim.curves.iter().map(|curve| (curve.clone(), aim.power)));
    (aims.collect(), reduction)
}

/// Widened by 10⁻⁴, a hundred times as far as a reduction ever does.
#[test]
fn truncation_errors() {
    for (text, most) in [
        ("theta0 = 1", 2.5),
        ("theta0 = 7π/8", 12.0),
        ("theta0 = 0.99π", 60.0),
        ("velocity0 = 2.1", 12.0),
        ("velocity0 = 4", 3.0),
    ] {
        let (curves, reduction) = curves(text);
        for (index, (curve, power)) in curves.iter().enumerate() {
            let variants = [0, *power].map(|power| [(power, 0.0), (power, 1e-4)]).concat();
            for (power, overshoot) in variants {
                let approximation = Approximation::new(curve, power, 1e-20).unwrap();
                let reduction = Reduction { overshoot, ..reduction.clone() };
                for terms in [3, 6, 11] {
                    let polynomial = approximation.in_powers(terms, Form::Centred { centre: 1.25 }, &reduction, false);
                    let (bound, seen) = (polynomial.truncation, sampled(&polynomial, curve, overshoot));
                    let most = if overshoot == 0.0 { 2.5 } else { most };
                    let about = format!("{text} {index} {power} {terms} {overshoot}: {seen:e} of {bound:e}");
                    assert!(seen <= bound && bound <= most * seen, "{about}");
                }
            }
        }
    }
}

/// A whole series is wrong by what its interpolation is, bounded on an ellipse: crudely, but with at most five points more than
/// would have done.
#[test]
fn interpolation_errors() {
    for text in ["theta0 = 1", "theta0 = 7π/8", "velocity0 = 2.1"] {
        let (curves, reduction) = curves(text);
        for (index, (curve, power)) in curves.iter().enumerate() {
            let precise = Approximation::new(curve, *power, 1e-20).unwrap();
            for negligible in [1e-3, 1e-7] {
                let approximation = Approximation::new(curve, *power, negligible).unwrap();
                let polynomial = approximation.in_powers(approximation.terms(), Form::Plain, &reduction, false);
                let (bound, seen) = (polynomial.truncation, sampled(&polynomial, curve, 0.0));
                let about = format!("{text} {index} {negligible}: {seen:e} of {bound:e}");
                assert!(seen <= bound && bound <= 1.01 * negligible, "{about}");
                let needed = precise.terms_for(negligible, 0.0).unwrap();
                assert!(
                    approximation.terms() <= 2 * needed,
                    "{about}: {} terms, {needed} needed",
                    approximation.terms()
                );
            }
        }
    }
}

#[test]
fn poles() {
    for (strip, power) in [(0.1, 1), (0.4, 2), (0.6, 1), (0.9, 2)] {
        let pole = Pole::new(strip, power);
        let (mut least, mut most) = (f64::INFINITY, 0.0f64);
        for i in 0..=1000 {
            let value = pole.at(Double::new(f64::from(i) / 500.0 - 1.0)).hi;
            (least, most) = (least.min(value), most.max(value));
        }
        assert!(pole.least() <= least && least < 1.002 * pole.least(), "{strip}: {least} {pole:?}");
        // On the circle |s| = radius the magnitude is largest where p is real and negative, or positive.
        for radius in [0.5, 0.8] {
            let magnitude = |angle: f64| {
                let p = 8.0 * radius * radius;
                let (re, im) = (p * angle.cos() - pole.place, p * angle.sin());
                let (re, im) = (re * re - im * im + pole.height_squared, 2.0 * re * im);
                re.hypot(im).powi(power)
            };
            let seen = (0..=720).map(|i| magnitude(f64::from(i).to_radians() / 2.0)).fold(0.0, f64::max);
            let most = pole.most(radius);
            assert!(seen <= most * (1.0 + 1e-12) && most <= 1.001 * seen, "{strip} {radius}: {most} for {seen}");
        }
        // It vanishes at s = ½ ± i·strip.
        let (re, im) = (8.0 * (0.25 - strip * strip) - pole.place, 8.0 * strip);
        assert!((re * re - im * im + pole.height_squared).hypot(2.0 * re * im) < 1e-6, "{pole:?}");
    }
}

/// Near the top one polynomial takes more points than there may be.
#[test]
fn too_many_points() {
    let (curves, _) = curves("theta0 = π - 1e-6");
    assert!(Approximation::new(&curves[0].0, 0, 1e-3).is_some());
    assert!(Approximation::new(&curves[0].0, 0, 1e-20).is_none());
}

/// Adapted coefficients are for numbers whose powers stay far from overflow and underflow.
#[test]
fn moderate_polynomials() {
    let (curves, reduction) = curves("theta0 = 1");
    let approximation = Approximation::new(&curves[0].0, 0, 1e-20).unwrap();
    let moderate = |coefficient: f64, terms: usize, quarter: f64, float: Float| {
        let polynomial = approximation.in_powers(2, Form::Plain, &reduction, true);
        let coefficients = vec![Double::new(coefficient); terms];
        Polynomial { coefficients, ..polynomial }.is_moderate(quarter, float)
    };
    for (coefficient, terms, quarter, float, expected) in [
        (1.0, 5, 0.25, Float::F64, true),
        (1.0, 5, 1e11, Float::F64, true),
        (1.0, 5, 1e-11, Float::F64, true),
        (1.0, 5, 1e13, Float::F64, false),
        (1.0, 5, 1e-13, Float::F64, false),
        (1.0, 5, 1e4, Float::F32, false),
        (1.0, 5, 1e2, Float::F32, true),
        // 10^(11·14) is too large, 10^(11·13) isn't; of a small first coefficient it makes a moderate one.
        (1.0, 15, 1e11, Float::F64, false),
        (1.0, 14, 1e11, Float::F64, true),
        (1e-155, 5, 1e11, Float::F64, true),
        (1e-155, 5, 0.25, Float::F64, false),
        (-1e-155, 5, 0.25, Float::F64, false),
        (-1e155, 5, 0.25, Float::F64, false),
    ] {
        assert_eq!(moderate(coefficient, terms, quarter, float), expected, "{coefficient} {terms} {quarter} {float:?}");
    }
}

/// What an error of the polynomial is multiplied with: by s ≤ ½ if it is odd, and over the least value of its poles.
#[test]
fn weights() {
    let (curves, _) = curves("theta0 = 7π/8");
    for (index, power, odd) in [(0, 0, 1.0), (1, 0, 0.5), (1, 1, 0.5), (2, 2, 1.0)] {
        let approximation = Approximation::new(&curves[index].0, power, 1e-12).unwrap();
        let least = approximation.pole.map_or(1.0, Pole::least);
        assert_eq!(approximation.weight(), odd / least, "{index} {power}");
        assert_eq!(approximation.pole.is_some(), power > 0);
    }
}
