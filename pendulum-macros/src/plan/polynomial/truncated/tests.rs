//! Polynomials in other units and forms, over poles and beside them, against the curves and the series that they are of.

use super::super::approximation::Growth;
use super::super::approximation::tests::{PLAIN, curves, nearest};
use super::*;
use crate::exact::Context;
use crate::plan::arc::Arc;
use crate::plan::blocks::LEAST;
use crate::plan::form::{Poles, Variant};
use crate::plan::moebius::Moebius;
use crate::plan::reduction::Phase;
use crate::plan::variables::{Source, Variables};
use crate::program::{Builder, Program};

/// The value of a polynomial at the phase s from an anchor, in anchors.
fn evaluated(polynomial: &Polynomial, unit: Double, s: f64) -> f64 {
    program(polynomial, unit).run(s / unit.hi)[0]
}

fn program(polynomial: &Polynomial, unit: Double) -> Program {
    let mut b = Builder::new(Float::F64);
    let input = b.input();
    let square = b.mul(input, input);
    let phase = Phase { remainder: input, magic: input, count: input };
    let variables = Variables::of_one_kernel([input, square], unit, Source::Square, phase);
    let result = polynomial.magnitude(&mut b, &variables);
    b.finish(vec![result])
}

/// What every form gives but adapted coefficients of large blocks: there may be none, or they are rounded too much.
fn or_adapted(form: Form, polynomial: Option<Polynomial>) -> Option<Polynomial> {
    assert!(polynomial.is_some() || matches!(form, Form::Adapted { chunk } if chunk > LEAST), "{form:?}");
    polynomial
}

/// With another unit of the phase, and in any form, polynomials over poles have the same values.
#[test]
fn values_in_other_units() {
    for (text, index) in [("theta0 = 7π/8", 0), ("theta0 = 7π/8", 1), ("theta0 = 7π/8", 2), ("velocity0 = 2.1", 1)] {
        let (curves, reduction) = curves(text);
        let approximation =
            Approximation::new(&curves[index].0, nearest(&curves[index].0, curves[index].1), 1e-18).unwrap();
        for form in Form::ALL {
            for (unit, s) in [(1.0, 0.3), (0.25, 0.3), (8.0, 0.45), (0.25, 0.0)] {
                let reduction = Reduction { unit: Double::new(unit), ..reduction.clone() };
                let terms = approximation.terms();
                let polynomial =
                    approximation.truncated(terms, &reduction, false).polynomial(form, Numerator::One, 1.0);
                let Some(polynomial) = or_adapted(form, polynomial) else { continue };
                // Plain powers are ill-conditioned, adapted ones more so.
                let most = if matches!(form, Form::Adapted { .. } | PLAIN) { 1e-11 } else { 1e-14 };
                let exact = curves[index].0.at(Double::new(s)).hi;
                let error = (evaluated(&polynomial, reduction.unit, s) - exact).abs();
                assert!(error <= most, "{text} {index} {form:?} {unit} {s}: {error:e}");
            }
        }
    }
}

/// With the poles beside it a polynomial has the values and the bound that it has over them, in two terms less; and so
/// it has negated.
#[test]
fn values_beside_poles() {
    for (text, index) in [("theta0 = 7π/8", 0), ("theta0 = 7π/8", 1), ("theta0 = 0.3", 1), ("velocity0 = 2.1", 1)] {
        let (curves, reduction) = curves(text);
        let curve = &curves[index].0;
        let approximation = Approximation::new(curve, Some(Pole::new(curve.strip(), 1, Float::F64)), 1e-18).unwrap();
        let terms = approximation.terms() - 3;
        let suits = |&form: &Form| Variant { form, poles: Poles::Beside }.suits(terms, Float::F64);
        for form in Form::ALL.into_iter().filter(suits) {
            for (unit, s) in [(1.0, 0.3), (0.25, 0.3), (8.0, 0.45), (0.25, 0.0)] {
                let reduction = Reduction { unit: Double::new(unit), ..reduction.clone() };
                let over = approximation.truncated(terms, &reduction, true).in_powers(form);
                let mut beside = approximation.truncated(terms, &reduction, true).beside_poles(form).unwrap();
                assert_eq!((beside.terms(), beside.blocks.terms() + 2), (terms, terms));
                let what = format!("{text} {index} {form:?} {unit}");
                let times = beside.truncation / over.truncation;
                assert!((1.0 - 1e-6..1.0 + 1e-6).contains(&times), "{what}: {:e} {times}", over.truncation);
                let expected = evaluated(&over, reduction.unit, s);
                let most = if form == PLAIN { 1e-12 } else { 1e-14 };
                let found = evaluated(&beside, reduction.unit, s);
                assert!((found - expected).abs() <= most, "{what} {s}: {found} {expected}");
                beside.negate();
                assert_eq!(evaluated(&beside, reduction.unit, s), -found, "{what} {s}");
            }
        }
    }
}

/// Over two pairs of poles, which are any, a polynomial has the values of the curve.
#[test]
fn values_over_two_pairs() {
    let pole = Pole::of_two([[0.115, -0.37], [0.18, -0.41]], Float::F64);
    for (text, index) in [("theta0 = 7π/8", 0), ("theta0 = 7π/8", 1), ("theta0 = 0.3", 1)] {
        let (curves, reduction) = curves(text);
        let approximation = Approximation::new(&curves[index].0, pole, 1e-18).unwrap();
        let terms = approximation.terms();
        for (form, unit) in Form::ALL.into_iter().flat_map(|form| [1.0, 0.25].map(|unit| (form, unit))) {
            let reduction = Reduction { unit: Double::new(unit), ..reduction.clone() };
            let numerator = if index == 1 { Numerator::One } else { Numerator::Leading };
            let polynomial = approximation.truncated(terms, &reduction, false).polynomial(form, numerator, 1.0);
            let Some(polynomial) = or_adapted(form, polynomial) else { continue };
            assert_eq!(polynomial.variant().poles, Poles::UnderTwo);
            let most = if matches!(form, Form::Adapted { .. } | PLAIN) { 1e-11 } else { 1e-14 };
            for s in [0.0, 0.3, 0.49] {
                let error = (evaluated(&polynomial, reduction.unit, s) - curves[index].0.at(Double::new(s)).hi).abs();
                assert!(error <= most, "{text} {index} {form:?} {unit} {s}: {error:e}");
            }
        }
    }
}

/// With its leading coefficient over the poles a polynomial has the same values and bound, by an operation less; so it has
/// with another number there, by as many operations; and negated the first is still the one with less.
#[test]
fn numerators() {
    for (text, index) in [("theta0 = 7π/8", 0), ("theta0 = 7π/8", 2), ("theta0 = 0.3", 0), ("theta0 = 3.14", 0)] {
        let (curves, reduction) = curves(text);
        let curve = &curves[index].0;
        let pole = Some(Pole::new(curve.strip(), if index == 2 { 2 } else { 1 }, Float::F64));
        let approximation = Approximation::new(curve, pole, 1e-12).unwrap();
        for (form, unit) in Form::ALL.into_iter().flat_map(|form| [1.0, 0.25].map(|unit| (form, unit))) {
            let reduction = Reduction { unit: Double::new(unit), ..reduction.clone() };
            let over = |numerator| approximation.truncated(5, &reduction, false).polynomial(form, numerator, 1.0);
            let Some(one) = or_adapted(form, over(Numerator::One)) else { continue };
            let [mut leading, same] =
                [Numerator::Leading, Numerator::Same(Double::new(-3.0))].map(|numerator| over(numerator).unwrap());
            let operations = |polynomial: &Polynomial| program(polynomial, reduction.unit).operations();
            assert_eq!(operations(&leading) + 1, operations(&one), "{text} {index} {form:?} {unit}");
            assert_eq!(operations(&same), operations(&one), "{text} {index} {form:?} {unit}");
            for s in [0.0, 0.3, 0.49] {
                let [first, second, third] =
                    [&one, &leading, &same].map(|polynomial| evaluated(polynomial, reduction.unit, s));
                let most = 1e-11 * curve.size.largest;
                assert!((first - second).abs() <= most && (first - third).abs() <= most, "{text} {index} {form:?} {s}");
            }
            for other in [&leading, &same] {
                let times = other.truncation / one.truncation;
                assert!((1.0 - 1e-6..1.0 + 1e-6).contains(&times), "{text} {index} {form:?}: {times}");
            }
            let before = evaluated(&leading, reduction.unit, 0.3);
            leading.negate();
            assert_eq!(evaluated(&leading, reduction.unit, 0.3), -before);
            assert_eq!(operations(&leading) + 1, operations(&one), "{text} {index} {form:?} {unit}");
        }
    }
}

/// Without poles there is nothing to put beside.
#[test]
fn nothing_beside() {
    let (curves, reduction) = curves("theta0 = 1");
    let approximation = Approximation::new(&curves[0].0, None, 1e-18).unwrap();
    assert_eq!(approximation.truncated(9, &reduction, true).beside_poles(PLAIN), None);
}

/// Of the image of p, whatever the unit and the form: 1 + T₁ + … of what goes from −1 to 1 with it.
#[test]
fn values_of_the_image() {
    let (_, reduction) = curves("theta0 = 1");
    let map = Moebius { place: 0.5 };
    let approximation = Approximation::known(
        Some(map),
        vec![Double::ONE; 6],
        0.0,
        Growth::Power { power: 0.0, log_rho: f64::INFINITY },
    );
    for form in Form::ALL {
        for (unit, s) in [(1.0, 0.3), (0.25, 0.4), (8.0, 0.45), (1.0, 0.0)] {
            let reduction = Reduction { unit: Double::new(unit), ..reduction.clone() };
            let polynomial = approximation.truncated(6, &reduction, false).polynomial(form, Numerator::Leading, 1.0);
            let Some(polynomial) = or_adapted(form, polynomial) else { continue };
            let image = s * s * 0.75 / (s * s + 0.5);
            let angle = (8.0 * image - 1.0_f64).acos();
            let expected: f64 = (0..6).map(|j| (f64::from(j) * angle).cos()).sum();
            let found = evaluated(&polynomial, reduction.unit, s);
            assert!((found - expected).abs() < 1e-12, "{form:?} {unit} {s}: {found} {expected}");
        }
    }
}

/// A form's variable is nowhere larger than it says: at both ends of what a phase may be, of squares, arcs and images.
#[test]
fn reaches() {
    let (curves, reduction) = curves("theta0 = 1");
    let curve = &curves[0].0;
    let real = |x: f64| Context::settled().float(x).unwrap();
    let arc = Arc::new(0.1, &real(1.0), &real(0.1)).unwrap();
    let map = Moebius { place: 0.5 };
    let square = |s: f64| s * s;
    let kinds: [(_, &dyn Fn(f64) -> f64); 3] = [
        (Approximation::new(curve, None, 1e-9).unwrap(), &square),
        (Approximation::new(&curve.clone().over(arc), None, 1e-9).unwrap(), &|s| 0.25 * (s + 0.5)),
        (
            Approximation::known(
                Some(map),
                vec![Double::ONE; 6],
                0.0,
                Growth::Power { power: 0.0, log_rho: f64::INFINITY },
            ),
            &|s| 0.75 * s * s / (s * s + 0.5),
        ),
    ];
    for (kind, (approximation, area)) in kinds.iter().enumerate() {
        for (unit, overshoot) in [(1.0, -0.2), (1.0, 0.0), (0.25, 1e-3), (8.0, 0.1)] {
            let reduction = Reduction { unit: Double::new(unit), overshoot, ..reduction.clone() };
            let truncated = approximation.truncated(6, &reduction, false);
            for form in Form::ALL {
                let variable = truncated.variable(form, form.shift());
                let end = 0.5 + overshoot.max(0.0);
                let at = |s: f64| (area(s) / variable.area.hi + variable.shift.hi).abs();
                let largest = at(end).max(at(if kind == 1 { -end } else { 0.0 }));
                let loose = variable.reach / largest;
                assert!((1.0..1.3).contains(&loose), "{kind} {unit} {overshoot} {form:?}: {loose}");
            }
        }
    }
}

/// Adapted coefficients are for numbers whose powers stay far from overflow and underflow.
#[test]
fn moderate_polynomials() {
    let moderate = |coefficient: f64, terms: usize, quarter: f64, float: Float| {
        can_be_adapted(&vec![Double::new(coefficient); terms], quarter, float)
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

/// Where powers of the unit underflow or overflow there is no bound, unless the variable is normalised; nor where those
/// of poles do.
#[test]
fn units_without_bounds() {
    let (curves, reduction) = curves("theta0 = 7π/8");
    for (index, power, form, within, beyond) in [
        (0, 0, PLAIN, 30, Some(40)),
        (0, 0, Form::Normalised, 150, None),
        (1, 0, Form::Normalised, 150, None),
        (1, 1, PLAIN, 30, Some(40)),
        (1, 1, Form::Normalised, 60, Some(65)),
        (2, 2, Form::Normalised, 30, Some(35)),
    ] {
        let approximation = Approximation::new(&curves[index].0, nearest(&curves[index].0, power), 1e-9).unwrap();
        let excess = |exponent: i32| {
            let reduction = Reduction { unit: Double::new(10f64.powi(exponent)), ..reduction.clone() };
            let found = approximation.truncated(4, &reduction, true).in_powers(form).truncation;
            found / approximation.truncation(4, reduction.overshoot)
        };
        for sign in [1, -1] {
            assert!((1.0..1.001).contains(&excess(sign * within)), "{index} {power} {form:?} {sign}");
            if let Some(beyond) = beyond {
                assert_eq!(excess(sign * beyond), f64::INFINITY, "{index} {power} {form:?} {sign}");
            }
        }
    }
}

/// With another unit of the phase adapted polynomials are the same ones; and they say by how much they are others than
/// those that they were made of, wherever the phase may be.
#[test]
fn adapted_polynomials() {
    for (text, index, chunk) in [("theta0 = 1", 2, 16), ("velocity0 = 2.1", 1, 16), ("7π/8", 1, 4), ("7π/8", 2, 4)] {
        let (curves, reduction) = curves(&if chunk == 16 { text.to_owned() } else { format!("theta0 = {text}") });
        let approximation =
            Approximation::new(&curves[index].0, nearest(&curves[index].0, curves[index].1), 1e-24).unwrap();
        let terms = if chunk == 16 { 9 } else { approximation.terms() };
        let adapted = |unit: f64| {
            let reduction = Reduction { unit: Double::new(unit), ..reduction.clone() };
            let limit = if chunk == 16 { 1e-3 } else { f64::INFINITY };
            let truncated = approximation.truncated(terms, &reduction, true);
            truncated.polynomial(Form::Adapted { chunk }, Numerator::One, limit).unwrap()
        };
        let place = adapted(1.0).shift.hi;
        for unit in [0.25, 3.0] {
            let polynomial = adapted(unit);
            let (shift, found) = (polynomial.shift.hi, polynomial.blocks.mismatch);
            assert!((shift * unit * unit - place).abs() < 1e-15, "{text} {index}: {shift} {place}");
            let reach = shift.abs().max((shift + 0.25 / (unit * unit)).abs());
            let reduction = Reduction { unit: Double::new(unit), ..reduction.clone() };
            let truncated = approximation.truncated(terms, &reduction, true);
            let variable = Variable { shift: polynomial.shift, area: truncated.area(), reach };
            let powers = truncated.powers(variable);
            let least = Blocks::adapted(&powers, chunk, reach).unwrap().mismatch;
            assert!(least > 0.0 && found >= least, "{text} {index}: {found:e} {least:e}");
            assert!(found <= least * 1.001f64.powi(terms as i32), "{text} {index}");
            // It counts with the truncation, which is as small where no term is left out.
            if chunk == 4 {
                let odd = if curves[index].0.parity() == Parity::Odd { 1.0 / unit } else { 1.0 };
                let poles = unit.powi(4 * curves[index].1 as i32);
                let eighth = 8.0 * variable.area.hi;
                let reach = eighth * reach + (1.0 + eighth * shift).abs();
                let converted = rounding_of_powers(&approximation.series()[..terms], reach);
                let added = polynomial.truncation - approximation.truncation(terms, reduction.overshoot);
                let times = added / (approximation.weight(0.0) * (found * odd * poles + converted));
                assert!((0.99..1.01).contains(&times), "{text} {index}: {times}");
            }
        }
    }
}
