//! Each operation's interval and error, worked out by hand: a bound that is too large is as wrong here as one too
//! small.

use super::*;
use crate::program::Builder;
use pendulum_runtime::double::Double;

/// Half a unit in the last place of 1.
const U: f64 = f64::EPSILON / 2.0;
const U32: f64 = f32::EPSILON as f64 / 2.0;

/// An operation on the nodes 0, 1 and so on.
fn after(op: Op, float: Float, known: &[Known]) -> Known {
    step(op, float, known)
}

#[track_caller]
fn expect(found: Known, (low, high): (f64, f64), error: f64, local: f64) {
    let near = |a: f64, b: f64| a == b || (a - b).abs() <= 1e-14 * b.abs();
    assert_eq!((found.low, found.high), (low, high), "{found:?}");
    assert!(near(found.error, error), "error {:e}, not {error:e}", found.error);
    assert!(near(found.local, local), "local error {:e}, not {local:e}", found.local);
}

#[test]
fn halves_of_units_in_the_last_place() {
    for (magnitude, float, half) in [
        (1.0, Float::F64, U),
        (1.999, Float::F64, U),
        (2.0, Float::F64, 2.0 * U),
        (0.3, Float::F64, U / 4.0),
        (0.0, Float::F64, f64::from_bits(1)),
        (1.0, Float::F32, U32),
        (1e-45, Float::F32, f64::from(f32::from_bits(1))),
    ] {
        assert_eq!(half_ulp(magnitude, float), half, "{magnitude} {float:?}");
    }
    // Next above a power of two as far as that, but no less than below it, of which the last binary places are unknown.
    for (above, most) in [(-1e-20, U / 2.0), (1e-18, U / 2.0), (0.75 * U, 0.75 * U), (1.5 * U, U), (0.5, U)] {
        let found = rounding_up_to(Double::from_sum(1.0, above), Float::F64);
        assert!((most..most * (1.0 + 1e-12)).contains(&found), "{above:e}: {found:e}");
    }
    // Up to a power of two the numbers below it count.
    for (magnitude, half) in [(1.0, U / 2.0), (1.25, U), (4.0, 2.0 * U)] {
        assert_eq!(rounding(0.0, magnitude, |_| true, Float::F64), half, "{magnitude}");
    }
}

#[test]
fn sums_and_differences() {
    let (a, b) = (Known::within(1.0, 1.5, 3e-10), Known::within(0.25, 0.5, 5e-10));
    // Up to 2, which is reached exactly.
    expect(after(Op::Add(0, 1), Float::F64, &[a, b]), (1.25, 2.0), 8e-10 + U, U);
    expect(after(Op::Sub(0, 1), Float::F64, &[a, b]), (0.5, 1.25), 8e-10 + U, U);
    expect(after(Op::Sub(1, 0), Float::F64, &[a, b]), (-1.25, -0.5), 8e-10 + U, U);
    // To a power of two by rounding at either end: the sum may be above, also where a product with its rest is 0.
    for power in [1.0, 2f64.powi(-600)] {
        let tiny = 0.75 * U * power;
        let next = Known::between(tiny, tiny);
        let sum = after(Op::Add(0, 1), Float::F64, &[Known::between(0.0, power), next]);
        expect(sum, (tiny, power), tiny, tiny);
    }
    // No more than the smaller operand is lost.
    for (low, high) in [(1e-20, 1e-20), (-1e-20, 5e-21)] {
        let tiny = Known::between(low, high);
        let sum = after(Op::Add(0, 1), Float::F64, &[Known::within(1.0, 1.5, 1e-9), tiny]);
        expect(sum, (1.0, 1.5), 1e-9 + 1e-20, 1e-20);
        let difference = after(Op::Sub(1, 0), Float::F32, &[Known::within(1.0, 1.5, 1e-9), tiny]);
        expect(difference, (-1.5, -1.0), 1e-9 + 1e-20, 1e-20);
    }
    // That of the other end doesn't matter.
    let (c, d) = (Known::between(0.1, 0.5), Known::between(0.2, 0.5));
    expect(after(Op::Add(0, 1), Float::F64, &[c, d]), (0.1 + 0.2, 1.0), U / 2.0, U / 2.0);
    // 1 + 2⁻²⁴ is exact in two words of `f64` but rounded to 1 in `f32`, by as much as results above 1 are.
    let close = Known::between(2f64.powi(-24), 2f64.powi(-24));
    expect(after(Op::Add(0, 1), Float::F32, &[Known::between(0.0, 1.0), close]), (2f64.powi(-24), 1.0), U32, U32);
    let half = Known::between(0.25, 0.5);
    expect(after(Op::Add(0, 1), Float::F32, &[half, half]), (0.5, 1.0), U32 / 2.0, U32 / 2.0);
}

#[test]
fn products_of_intervals() {
    assert_eq!(super::products((-1.0, 2.0), (-3.0, 1.0)), (-6.0, 3.0));
    assert_eq!(super::products((-2.0, -1.0), (-3.0, 1.0)), (-2.0, 6.0));
}

#[test]
fn products() {
    let (a, b) = (Known::within(-1.5, 3.0, 3e-10), Known::within(-2.5, 0.75, 5e-10));
    // −2.5·3 and 1.5·2.5; 2.5·3e-10 + 3·5e-10 + 15e-20.
    let inherited = 7.5e-10 + 15e-10 + 15e-20;
    expect(after(Op::Mul(0, 1), Float::F64, &[a, b]), (-7.5, 3.75), inherited + 4.0 * U, 4.0 * U);
    // To a power of two exactly, and by rounding.
    let c = Known::between(0.0, 0.5);
    expect(after(Op::Mul(0, 1), Float::F64, &[c, c]), (0.0, 0.25), U / 8.0, U / 8.0);
    let (d, e) = (Known::between(0.0, 1.0 + f64::EPSILON), Known::between(0.0, 1.0 - U));
    expect(after(Op::Mul(0, 1), Float::F64, &[d, e]), (0.0, 1.0), U, U);
    // From below it may.
    let e = Known::between(0.0, 1.0 - f64::EPSILON);
    expect(after(Op::Mul(0, 1), Float::F64, &[d, e]), (0.0, 1.0), U / 2.0, U / 2.0);
    let (d, e) =
        (Known::between(0.0, f64::from(1.0 + f32::EPSILON)), Known::between(0.0, f64::from(1.0 - f32::EPSILON / 2.0)));
    expect(after(Op::Mul(0, 1), Float::F32, &[d, e]), (0.0, 1.0), U32, U32);
    // By a power of two, of either sign, there is nothing to round, even if another number was meant.
    for power in [4.0, -4.0] {
        let (x, scale) = (Known::within(0.1, 0.3, 1e-9), Known::between(power, power));
        let ends = if power > 0.0 { (4.0 * 0.1, 4.0 * 0.3) } else { (-4.0 * 0.3, -4.0 * 0.1) };
        expect(after(Op::Mul(0, 1), Float::F64, &[x, scale]), ends, 4e-9, 0.0);
        expect(after(Op::Mul(1, 0), Float::F64, &[x, scale]), ends, 4e-9, 0.0);
    }
    // Of one below 1 there is what underflows.
    for (float, least) in [(Float::F64, f64::from_bits(1)), (Float::F32, f64::from(f32::from_bits(1)))] {
        let half = after(Op::Mul(0, 1), float, &[Known::between(-0.75, 0.5), Known::between(0.5, 0.5)]);
        expect(half, (-0.375, 0.25), least, least);
    }
    let (x, scale) = (Known::between(0.1, 0.3), Known::within(4.0, 4.0, 1e-9));
    expect(after(Op::Mul(0, 1), Float::F64, &[x, scale]), (0.4, 1.2), 0.3e-9, 0.0);
    let (x, scale) = (Known::between(0.1, 0.3), Known::between(2.0, 4.0));
    expect(after(Op::Mul(0, 1), Float::F64, &[x, scale]), (0.2, 1.2), U, U);
}

/// Of numbers what is lost is known.
#[test]
fn operations_on_numbers() {
    let number = |x: f64| Known::within(x, x, 1e-9);
    let (third, single) = (1.0 / 3.0, f64::from(1.0f32 / 3.0));
    for (op, a, b, float, result, lost) in [
        (Op::Add(0, 1), 1.0, 0.5, Float::F64, 1.5, 0.0),
        (Op::Sub(0, 1), 1.0, 2f64.powi(-60), Float::F64, 1.0, 2f64.powi(-60)),
        (Op::Add(0, 1), 1.0, 2f64.powi(-26), Float::F32, 1.0, 2f64.powi(-26)),
        (Op::Mul(0, 1), 1.5, 3.0, Float::F32, 4.5, 0.0),
        (Op::Mul(0, 1), third, third, Float::F64, third * third, two_prod(third, third).1.abs()),
        (Op::Mul(0, 1), single, 3.0, Float::F32, 1.0, (3.0 * single - 1.0).abs()),
    ] {
        let found = after(op, float, &[number(a), number(b)]);
        assert_eq!((found.low, found.high), (result, result), "{a} {b}");
        let excess = found.local - lost;
        assert!((0.0..1e-44).contains(&excess), "{a} {b}: {excess:e}");
    }
    // Too large to tell.
    let huge = after(Op::Mul(0, 1), Float::F64, &[number(1e305), number(1.1)]);
    assert_eq!(huge.local, half_ulp(1.1e305, Float::F64));
}

#[test]
fn squares() {
    for (low, high, least, most) in [
        (-1.5, 0.5, 0.0, 2.25),
        (0.5, 1.5, 0.25, 2.25),
        (-1.5, -0.5, 0.25, 2.25),
        (0.0, 1.5, 0.0, 2.25),
        (-1.5, 0.0, 0.0, 2.25),
    ] {
        let x = Known::within(low, high, 1e-9);
        let error = 3e-9 + 1e-18 + 2.0 * U;
        expect(after(Op::Mul(0, 0), Float::F64, &[x]), (least, most), error, 2.0 * U);
    }
    // Rounded as the program rounds.
    let x = Known::between(f64::from(0.1f32), f64::from(0.3f32));
    let square = after(Op::Mul(0, 0), Float::F32, &[x]);
    assert_eq!((square.low, square.high), (f64::from(0.1f32 * 0.1), f64::from(0.3f32 * 0.3)));
}

#[test]
fn quotients() {
    let a = Known::within(-3.0, 6.0, 3e-10);
    for (low, high) in [(2.0, 4.0), (-4.0, -2.0)] {
        let b = Known::within(low, high, 5e-10);
        let ends = if low > 0.0 { (-1.5, 3.0) } else { (-3.0, 1.5) };
        let inherited = (3e-10 + 3.0 * 5e-10) / (2.0 - 5e-10);
        expect(after(Op::Div(0, 1), Float::F64, &[a, b]), ends, inherited + 2.0 * U, 2.0 * U);
    }
    // The quotient of exact operands counts, though it is rounded down in `f32`.
    let one = Known::between(1.0, 1.0);
    let three = Known::within(f64::from(1.0 + 3.0 * f32::EPSILON), f64::from(1.0 + 3.0 * f32::EPSILON), 1e-3);
    let quotient = after(Op::Div(0, 1), Float::F32, &[one, three]);
    let exact = 1.0 / three.low;
    assert!(quotient.high < exact, "rounded down");
    expect(quotient, (quotient.high, quotient.high), exact * 1e-3 / (three.low - 1e-3) + U32 / 2.0, U32 / 2.0);
    // Nothing is known where the divisor may vanish, or its exact value may.
    for (low, high, error) in
        [(-1.0, 1.0, 0.0), (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), (1e-9, 1.0, 1e-9), (-1.0, -1e-9, 2e-9)]
    {
        let quotient = after(Op::Div(0, 1), Float::F64, &[a, Known::within(low, high, error)]);
        assert_eq!(quotient.error, f64::INFINITY, "{low} {high} {error}");
        assert_eq!((quotient.low, quotient.high), (f64::NEG_INFINITY, f64::INFINITY));
    }
}

#[test]
fn roots() {
    let local = |most: f64| ROOT_ERROR * U * most;
    let within = 1.0 - 1e-6..1.0 + 1e-6;
    for (low, high, error, inherited) in
        [(4.0, 9.0, 1e-9, 0.5e-9), (0.0, 9.0, 1e-10, 1e-5), (1e-16, 9.0, 1e-10, 1e-5), (-1e-9, 9.0, 1e-10, 1e-5)]
    {
        let root = after(Op::Root(0), Float::F64, &[Known::within(low, high, error)]);
        assert!((root.error / (inherited + local(3.0)) - 1.0).abs() < 1e-9, "{low}: {:e}", root.error);
        assert!((root.local / local(3.0) - 1.0).abs() < 1e-9, "{low}: {:e}", root.local);
        assert!(root.high > 3.0 && within.contains(&(root.high / (3.0 * (1.0 + 1e-6)))), "{low}: {}", root.high);
        let least = low.max(0.0).sqrt();
        assert!(root.low <= least && root.low >= least * (1.0 - 2e-6) - NEXT_TO_ZERO, "{low}: {}", root.low);
        assert!(least == 0.0 || root.low < least, "{low}: {}", root.low);
    }
    // What is computed of less than that is no number.
    assert_eq!(after(Op::Root(0), Float::F64, &[Known::within(-0.21, 1.0, 1e-9)]).error, f64::INFINITY);
}

#[test]
fn what_only_passes_values_on() {
    let x = Known::within(-3.0, 2.0, 1e-9);
    let limit = Known::within(1.0, 1.0, 1e-8);
    expect(after(Op::Abs(0), Float::F64, &[x]), (0.0, 3.0), 1e-9, 0.0);
    expect(after(Op::Abs(0), Float::F64, &[Known::within(-3.0, -2.0, 1e-9)]), (2.0, 3.0), 1e-9, 0.0);
    expect(after(Op::Abs(0), Float::F64, &[Known::within(2.0, 3.0, 1e-9)]), (2.0, 3.0), 1e-9, 0.0);
    expect(after(Op::Abs(0), Float::F64, &[Known::within(-2.0, 0.0, 1e-9)]), (0.0, 2.0), 1e-9, 0.0);
    expect(after(Op::Abs(0), Float::F64, &[Known::within(0.0, 2.0, 1e-9)]), (0.0, 2.0), 1e-9, 0.0);
    expect(after(Op::Min { limit: 1, x: 0 }, Float::F64, &[x, limit]), (-3.0, 1.0), 1e-8, 0.0);
    expect(after(Op::Max { limit: 1, x: 0 }, Float::F64, &[x, limit]), (1.0, 2.0), 1e-8, 0.0);
    for op in [
        Op::Alternate { x: 0, magic: 0, bit: 0 },
        Op::CopySign { magnitude: 0, sign: 0 },
        Op::Along { x: 0, sign: 0 },
        Op::Against { x: 0, sign: 0 },
    ] {
        expect(after(op, Float::F64, &[x]), (-3.0, 3.0), 1e-9, 0.0);
    }
    expect(after(Op::Widen(0), Float::F64, &[x]), (-3.0, 2.0), 1e-9, 0.0);
    let narrow = after(Op::Narrow(0), Float::F32, &[Known::within(-0.1, 3.0, 1e-9)]);
    expect(narrow, (f64::from(-0.1f32), 3.0), 1e-9 + 2.0 * U32, 2.0 * U32);
    let constant = after(Op::Constant { value: 0.5, rest: -1e-20 }, Float::F64, &[]);
    expect(constant, (0.5, 0.5), 1e-20, 1e-20);
}

/// What the analysis itself rounds is covered in both errors, that with its operands' and that of the operation alone.
#[test]
fn inflation() {
    let Known { low, high, error, local } = inflate(Known::result((1.0, 2.0), 3e-9, 1e-9));
    assert_eq!((low, high), (1.0, 2.0));
    for (inflated, before) in [(error, 4e-9), (local, 1e-9)] {
        assert!((1e-12..2e-12).contains(&(inflated / before - 1.0 + 1e-15)), "{inflated:e}");
    }
}

/// t + 1 and its square, forwards and by derivatives, both inflated.
#[test]
fn programs() {
    let mut b = Builder::new(Float::F64);
    let t = b.input();
    let third = b.rounded(Double { hi: 0.3, lo: 1e-18 });
    let sum = b.add(t, third);
    let square = b.mul(sum, sum);
    let back = b.sub(square, t);
    let program = b.finish(vec![square, back]);
    let known = program.rounding(&[(0, Known::between(1.0, 1.5))]);
    // |sum| ≤ 1.8 and |square| ≤ 3.24 are rounded by U and 2U, |back| ≤ 2.24 by 2U.
    let square = 2.0 * 1.8 * (1e-18 + U) + 2.0 * U;
    for (known, error) in known.iter().zip([square, square + 2.0 * U]) {
        assert!(known.error >= error && known.error <= error * (1.0 + 1e-11), "{:e} for {error:e}", known.error);
    }
    assert_eq!((known[0].low, known[0].high), (1.3 * 1.3, 1.8 * 1.8));
    // Of x·x − x the derivative is at most 2x − 1, which errors of x forwards don't know.
    let mut b = Builder::new(Float::F64);
    let t = b.input();
    let x = b.rounded(Double { hi: 0.5, lo: 1e-10 });
    let x = b.add(t, x);
    let square = b.mul(x, x);
    let result = b.sub(square, x);
    let program = b.finish(vec![result]);
    let error = program.rounding(&[(0, Known::between(0.0, 0.25))])[0].error;
    assert!((0.5e-10..0.5001e-10).contains(&error), "{error:e}");
}

/// Of a sum of what is bounded by no number nothing is known, though what is added to it is known to be exact.
#[test]
fn what_is_no_number_is_not_passed_over() {
    let mut b = Builder::new(Float::F64);
    let x = b.input();
    let one = b.constant(1.0);
    let sum = b.add(x, one);
    let result = b.push(Op::Against { x: sum, sign: x });
    let program = b.finish(vec![result]);
    let unknown = [
        Known::within(f64::NAN, f64::NAN, f64::NAN),
        Known::within(0.0, 1.0, f64::NAN),
        Known { low: 0.0, high: f64::NAN, error: 0.0, local: 0.0 },
    ];
    for known in unknown {
        let [found] = program.rounding(&[(sum, known)])[..] else { panic!("one result") };
        assert_eq!(found.error, f64::INFINITY, "{known:?}: {found:?}");
    }
}

/// Each coefficient is off by so much at most, times a power of the variable.
#[test]
fn underflow_of_coefficients() {
    assert_eq!(lost_to_underflow(3, 10.0), 111.0 * UNDERFLOW);
    assert_eq!(lost_to_underflow(2, 1e-100), UNDERFLOW);
    assert!([1e-100, 1e100].into_iter().all(|reach| lost_to_underflow(3, reach).is_infinite()));
}

/// Next to the largest numbers a product in two words has no second word: then nothing tells that it is rounded from below.
#[test]
fn products_rounded_to_a_power_of_two_from_beyond() {
    for power in [0, 900, 1000] {
        let big = 2f64.powi(power);
        let (a, b) = (Known::between(0.0, big * (1.0 + 2.0 * U)), Known::between(-(1.0 - U), 0.0));
        let found = after(Op::Mul(0, 1), Float::F64, &[a, b]);
        assert!(found.error >= big * (U - 2.0 * U * U), "2^{power}: {:e}", found.error);
    }
}

/// What overflows is wrong by more than any number: a sum by more than its smaller term, a product with a power of two though
/// that rounds nothing.
#[test]
fn overflow_is_no_small_error() {
    for (float, most) in [(Float::F32, f64::from(f32::MAX)), (Float::F64, f64::MAX)] {
        let large = Known::between(0.5 * most, 0.9 * most);
        let small = Known::between(0.0, 0.2 * most);
        let two = Known::within(2.0, 2.0, 0.0);
        let opposite = |Known { low, high, .. }| Known::between(-high, -low);
        for (op, other) in [(Op::Add(0, 1), small), (Op::Sub(0, 1), opposite(small)), (Op::Mul(0, 1), two)] {
            let found = [large, opposite(large)].map(|large| after(op, float, &[large, other]).error);
            let overflows = [true, matches!(op, Op::Mul(..))];
            assert_eq!(found.map(|error| error == f64::INFINITY), overflows, "{op:?} {float:?}: {found:?}");
        }
    }
}

/// Of numbers below all normal ones a root is next to 0, whatever it is.
#[test]
fn roots_next_to_zero() {
    for (low, high) in [(1e-44, 1e-40), (0.0, 1e-40), (1e-44, 1.0)] {
        let found = after(Op::Root(0), Float::F32, &[Known::between(low, high)]);
        let result = f64::from(pendulum_runtime::support::rootf(1e-44));
        assert!(found.low <= result && result <= found.high, "{low:e} to {high:e}: {found:?}");
        assert!(found.error >= (result - 1e-44_f64.sqrt()).abs(), "{low:e} to {high:e}: {found:?}");
    }
}

/// Sums of subnormal products, of which each is rounded by half of the smallest number, and a quarter of them by less.
#[test]
fn roundings_that_underflow() {
    for terms in [2, 8, 20, 40] {
        let mut b = Builder::new(Float::F64);
        let x = b.input();
        let factors: Vec<f64> = (0..terms).map(|i| 0.3 + 0.001 * f64::from(i)).collect();
        let constants: Vec<Id> = factors.iter().map(|&factor| b.constant(factor)).collect();
        let products: Vec<Id> = constants.into_iter().map(|c| b.mul(x, c)).collect();
        let sum = products.into_iter().reduce(|sum, product| b.add(sum, product)).unwrap();
        let quarter = b.constant(0.25);
        let result = b.mul(sum, quarter);
        let program = b.finish(vec![result]);
        let (low, high) = (800_u64, 1600);
        let bound = program.rounding(&[(0, Known::between(f64::from_bits(low), f64::from_bits(high)))])[0].error;
        let quanta = |x: f64| x.to_bits() as f64;
        for bits in low..=high {
            let exact = factors.iter().sum::<f64>() * 0.25 * bits as f64;
            let error = (quanta(program.run(f64::from_bits(bits))[0]) - exact).abs();
            assert!(error <= quanta(bound), "{terms} terms, {bits}: {error} quanta, not {}", quanta(bound));
        }
    }
}
