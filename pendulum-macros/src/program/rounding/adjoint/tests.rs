//! The derivatives of each operation, by hand.

use super::*;
use crate::parse::Float;
use crate::program::Builder;
use pendulum_runtime::double::Double;

/// The slopes passed to operands, given these values of them, but for what they are widened by for their rounding.
fn passed(op: Op, slope: (f64, f64), known: &[Known]) -> Option<Vec<(f64, f64)>> {
    let mut slopes = vec![Slope::ZERO; known.len()];
    let slope = Slope { low: slope.0, high: slope.1 };
    let ends = |slope: &Slope| (f64::from(slope.low as f32), f64::from(slope.high as f32));
    pass_back(known.len(), op, slope, known, &mut slopes).then(|| slopes.iter().map(ends).collect())
}

/// In x − (±x) the sign, unknown as it is, would be of one x.
#[test]
fn signs_that_are_passed_by() {
    let known = [Known::within(1.0, 2.0, 0.0), Known::within(-1.0, 1.0, 0.0)];
    let slope = Slope { low: 1.0, high: 1.0 };
    let sign = 1;
    for op in [Op::Alternate { x: 0, magic: 1, bit: 0 }, Op::Along { x: 0, sign }, Op::Against { x: 0, sign }] {
        for (before, passes) in [(0.0, true), (-1.0, false)] {
            let mut slopes = vec![Slope { low: before, high: before }, Slope::ZERO];
            assert_eq!(pass_back(2, op, slope, &known, &mut slopes), passes, "{op:?}");
        }
    }
}

#[test]
fn derivatives_of_operations() {
    // With their errors from 1 to 4, and from −4 to −2.
    let (a, b) = (Known::within(1.5, 3.5, 0.5), Known::within(-3.75, -2.25, 0.25));
    let slope = (-1.0, 2.0);
    for (op, expected) in [
        (Op::Add(0, 1), [(-1.0, 2.0), (-1.0, 2.0)]),
        (Op::Sub(0, 1), [(-1.0, 2.0), (-2.0, 1.0)]),
        (Op::Mul(0, 1), [(-8.0, 4.0), (-4.0, 8.0)]),
        // 1/b is from −1/2 to −1/4 and −a/b² from −1 to −1/16.
        (Op::Div(0, 1), [(-1.0, 0.5), (-2.0, 1.0)]),
        (Op::Root(0), [(-0.5, 1.0), (0.0, 0.0)]),
        (Op::Abs(0), [(-1.0, 2.0), (0.0, 0.0)]),
        (Op::Abs(1), [(0.0, 0.0), (-2.0, 2.0)]),
        (Op::Min { limit: 0, x: 1 }, [(-1.0, 2.0), (-1.0, 2.0)]),
        (Op::Max { limit: 0, x: 1 }, [(-1.0, 2.0), (-1.0, 2.0)]),
        (Op::Widen(0), [(-1.0, 2.0), (0.0, 0.0)]),
        (Op::Narrow(0), [(-1.0, 2.0), (0.0, 0.0)]),
        (Op::Alternate { x: 0, magic: 1, bit: 5 }, [(-1.0, 2.0), (0.0, 0.0)]),
        (Op::Along { x: 0, sign: 1 }, [(-1.0, 2.0), (0.0, 0.0)]),
        (Op::Against { x: 0, sign: 1 }, [(-1.0, 2.0), (0.0, 0.0)]),
        (Op::Input, [(0.0, 0.0); 2]),
    ] {
        assert_eq!(passed(op, slope, &[a, b]), Some(expected.to_vec()), "{op:?}");
    }
    // The same of a positive slope, and of one that reaches from nought.
    for (op, slope, expected) in [
        (Op::Div(0, 1), (1.0, 2.0), [(-1.0, -0.25), (-2.0, -0.0625)]),
        (Op::Root(0), (1.0, 2.0), [(0.25, 1.0), (0.0, 0.0)]),
        (Op::Mul(0, 1), (0.0, 1.0), [(-4.0, 0.0), (0.0, 4.0)]),
        (Op::Mul(0, 1), (-1.0, 0.0), [(0.0, 4.0), (-4.0, 0.0)]),
    ] {
        assert_eq!(passed(op, slope, &[a, b]), Some(expected.to_vec()), "{op:?}");
    }
    // Of what doesn't matter nothing depends on anything, be it infinite.
    let infinite = Known::between(f64::NEG_INFINITY, f64::INFINITY);
    assert_eq!(passed(Op::Mul(0, 1), (0.0, 0.0), &[infinite, a]), Some(vec![(0.0, 0.0); 2]));
    // The same operand twice gets both.
    assert_eq!(passed(Op::Mul(0, 0), (1.0, 1.0), &[a]), Some(vec![(2.0, 8.0)]));
    // Of 1/4 to 4, by whose ends a root's slope is divided.
    let wide = Known::within(0.5, 3.75, 0.25);
    assert_eq!(passed(Op::Root(0), (1.0, 2.0), &[wide]), Some(vec![(0.25, 2.0)]));
    // Of a positive slope the minimum passes none or all.
    assert_eq!(passed(Op::Min { limit: 0, x: 1 }, (1.0, 2.0), &[a, b]), Some(vec![(0.0, 2.0); 2]));
}

#[test]
fn where_there_is_no_derivative() {
    let (a, zero) = (Known::within(1.5, 3.5, 0.5), Known::within(1e-3, 1.0, 1e-2));
    assert_eq!(passed(Op::Div(0, 1), (1.0, 1.0), &[a, zero]), None);
    assert_eq!(passed(Op::Div(0, 1), (1.0, 1.0), &[a, Known::between(0.0, 1.0)]), None);
    assert_eq!(passed(Op::Div(0, 1), (1.0, 1.0), &[a, Known::between(-1.0, 0.0)]), None);
    assert_eq!(passed(Op::Root(0), (1.0, 1.0), &[zero]), None);
    assert_eq!(passed(Op::Root(0), (1.0, 1.0), &[Known::between(0.0, 1.0)]), None);
    for unknown in [Op::Head(0), Op::PowerOfTwo { magic: 0 }] {
        assert_eq!(passed(unknown, (1.0, 1.0), &[a]), None);
    }
    assert_eq!(passed(Op::Abs(0), (1.0, 1.0), &[zero]), Some(vec![(-1.0, 1.0)]));
    assert_eq!(passed(Op::Abs(0), (1.0, 1.0), &[Known::between(0.0, 1.0)]), Some(vec![(1.0, 1.0)]));
}

/// What cancels leaves what it was rounded by.
#[test]
fn slopes_that_cancel() {
    let tenth = Slope { low: 0.1, high: 0.1 };
    let sum = tenth.plus(Slope { low: 0.2, high: 0.2 }).plus(Slope { low: -0.3, high: -0.3 });
    let exact = tenth.times(3.0, 3.0).plus(Slope { low: -0.3, high: -0.3 });
    assert!(sum.low <= 0.0 && sum.high >= 5.5e-17 && sum.high < 2e-16, "{sum:?}");
    assert!(exact.low <= 0.0 && exact.high >= 1.6e-17 && exact.high < 2e-16, "{exact:?}");
}

/// (t + c)·(−3): the error of c and the sum's rounding, three times, and the product's.
#[test]
fn roundings_are_weighted_by_derivatives() {
    let mut b = Builder::new(Float::F64);
    let t = b.input();
    let c = b.rounded(Double { hi: 0.25, lo: 1e-12 });
    let sum = b.add(t, c);
    let minus = b.constant(-3.0);
    let product = b.mul(sum, minus);
    let mut program = b.finish(vec![product]);
    let (given, time) = ([0].as_slice(), Known::between(1.0, 1.25));
    let forward = |program: &Program| {
        let mut known = vec![time];
        (1..program.nodes.len())
            .for_each(|id| known.push(super::super::step(program.nodes[id].op, Float::F64, &known)));
        known
    };
    let error = |program: &Program, known: &[Known], given: &[Id]| {
        let is_given: Vec<bool> = (0..known.len()).map(|id| given.contains(&id)).collect();
        program.adjoint_error(4, known, &is_given)
    };
    let unit = f64::EPSILON / 2.0;
    let found = error(&program, &forward(&program), given);
    let expected = 3.0 * (1e-12 + unit) + 4.0 * unit;
    assert!((found / (expected * INFLATION) - 1.0).abs() < 1e-14, "{found:e} for {expected:e}");
    // What is given is given with its error, which counts, and has no operands.
    program.nodes[2].op = Op::Head(0);
    let known = forward(&program);
    assert_eq!(error(&program, &known, given), f64::INFINITY);
    let mut known = known;
    known[2] = Known::within(1.0, 1.5, 1e-9);
    known[4] = super::super::step(program.nodes[4].op, Float::F64, &known);
    let found = error(&program, &known, &[0, 2]);
    let expected = 3e-9 + 4.0 * unit;
    assert!((found / (expected * INFLATION) - 1.0).abs() < 1e-14, "{found:e} for {expected:e}");
}
