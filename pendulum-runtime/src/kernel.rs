//! The three elementary functions that every evaluation needs, on exactly the intervals it needs them on.
//!
//! Only + − × ÷, comparisons and integer operations in a fixed order, so the bits are the same on every IEEE target.
//! The polynomials interpolate at Chebyshev nodes; `tools/constants.py` prints their coefficients and errors.

use crate::double::Double;

/// 1.5 · 2⁵²: adding and subtracting it rounds an `f64` below 2⁵¹ to the nearest integer (ties to even).
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// The nearest integer to `x`, for |x| ≤ 2⁵¹.
#[inline]
pub(crate) fn round(x: f64) -> f64 {
    (x + ROUNDER) - ROUNDER
}

/// Horner's rule, lowest coefficient first.
#[inline]
pub(crate) fn horner<const N: usize>(coefficients: &[f64; N], x: f64) -> f64 {
    let mut sum = coefficients[N - 1];
    for &c in coefficients[..N - 1].iter().rev() {
        sum = sum * x + c;
    }
    sum
}

/// 2ⁿ exactly, as far as it is a number.
#[must_use]
pub const fn two_to(n: i32) -> f64 {
    match n {
        ..-1074 => 0.0,
        -1074..-1022 => f64::from_bits(1 << (n + 1074)),
        -1022..1024 => f64::from_bits(((n + 1023) as u64) << 52),
        1024.. => f64::INFINITY,
    }
}

/// xⁿ for n ≥ 0 by squaring.
#[must_use]
pub fn power(x: f64, n: i32) -> f64 {
    let (mut result, mut base, mut n) = (1.0, x, n);
    while n > 0 {
        if n & 1 == 1 {
            result *= base;
        }
        base *= base;
        n >>= 1;
    }
    result
}

/// (sin(2πz)/z − 2π)/z² and (cos(2πz) − 1)/z² in powers of z² on |z| ≤ ⅛: degree 6, weighted errors 5.6e-21 and
/// 1.2e-19.
const SINE_AND_COSINE: [[f64; 7]; 2] = [
    [
        -41.34170224039976,
        81.60524927607504,
        -76.70585975304292,
        42.0586939378057,
        -15.094641279579799,
        3.8198307439800163,
        -0.7124440626783193,
    ],
    [
        -19.739208802178716,
        64.93939402266824,
        -85.4568172066438,
        60.24464135270201,
        -26.426253275854723,
        7.903206911569678,
        -1.6990343940660637,
    ],
];

/// sin(2πz) for |z| ≤ ¼, odd to the bit; relative error below 1.8 · 2⁻⁵³, and far less near ¼.
///
/// Above ⅛ it is the cosine of ¼ − z. Both are a leading part plus a factor times a polynomial, chosen by table and
/// selection rather than by a branch that random phases would mispredict.
#[inline]
pub(crate) fn sin_turns(z: f64) -> f64 {
    let a = z.abs();
    let upper = a > 0.125;
    let b = if upper { 0.25 - a } else { a };
    let [c0, c1, c2, c3, c4, c5, c6] = SINE_AND_COSINE[usize::from(upper)];
    let x = b * b;
    let x2 = x * x;
    let tail = (c0 + c1 * x) + ((c2 + c3 * x) + ((c4 + c5 * x) + c6 * x2) * x2) * x2;
    let (leading, factor, rest) = if upper { (1.0, 1.0, 0.0) } else { (b * Double::TURN.hi, b, Double::TURN.lo) };
    let sine = leading + factor * (x * tail + rest);
    if z < 0.0 { -sine } else { sine }
}

/// (2ᶠ − 1)/f in powers of f on |f| ≤ ½: degree 10, relative error 1.3e-17.
const EXPONENTIAL: [f64; 11] = [
    core::f64::consts::LN_2,
    0.24022650695910097,
    0.0555041086648216,
    0.009618129107606888,
    0.0013333558146416936,
    0.0001540353044173605,
    1.525273382983612e-05,
    1.321544258792169e-06,
    1.0178062445845774e-07,
    7.072585949269223e-09,
    4.4549605981865186e-10,
];

/// Exponents are held below this: beyond, 2⁻⁶⁰ says that the motion stands at the top, and no power of the exponential
/// in a theta series can overflow.
const LARGEST_EXPONENT: f64 = 60.0;

/// 2ˣ − 1 for x ≥ 0, beyond `LARGEST_EXPONENT` as there; relative error below 3 · 2⁻⁵³ (that of the argument apart).
#[inline]
pub(crate) fn exp2_m1(x: f64) -> f64 {
    let x = if x > LARGEST_EXPONENT { LARGEST_EXPONENT } else { x }; // keeps NaN
    let n = round(x);
    let f = x - n; // exact
    let [c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10] = EXPONENTIAL;
    let f2 = f * f;
    let f4 = f2 * f2;
    let tail =
        ((c1 + c2 * f) + (c3 + c4 * f) * f2) + ((c5 + c6 * f) + (c7 + c8 * f) * f2) * f4 + (c9 + c10 * f) * (f4 * f4);
    let small = f * c0 + f2 * tail;
    let power = f64::from_bits(((n as i64 + 1023) as u64) << 52);
    small * power + (power - 1.0)
}

/// (atan(r)/r − 1)/r² in powers of r² on |r| ≤ ⅛: degree 5, weighted error 8.2e-18.
const ARCTANGENT: [f64; 6] = [
    -0.3333333333333328,
    0.19999999999768858,
    -0.1428571411634192,
    0.11111065673231692,
    -0.09085388729062223,
    0.07381784557280516,
];

/// 4 atan(j/4) in two words.
const FOUR_ATAN: [(f64, f64); 5] = [
    (0.0, 0.0),
    (0.9799146525074566, 4.2795022474937806e-17),
    (1.8545904360032244, 9.079510981184675e-17),
    (2.5740044351731375, 6.333914020577714e-17),
    (Double::PI.hi, Double::PI.lo),
];

/// 4 atan(n/d) for 0 ≤ n ≤ 1.1 d with one division; relative error below 2.5 · 2⁻⁵³.
///
/// With b the multiple of ¼ nearest to n/d, atan(n/d) = atan b + atan(r/4), r/4 = (n − bd)/(d + bn), |r| ≤ ½.
#[inline]
pub(crate) fn four_atan(n: f64, d: f64) -> f64 {
    let n8 = 8.0 * n;
    let j = usize::from(n8 > d) + usize::from(n8 > 3.0 * d) + usize::from(n8 > 5.0 * d) + usize::from(n8 > 7.0 * d);
    let (high, low) = FOUR_ATAN[j];
    let b = 0.25 * j as f64;
    let r = 4.0 * (n - b * d) / (d + b * n);
    let x = 0.0625 * (r * r);
    let [c0, c1, c2, c3, c4, c5] = ARCTANGENT;
    let x2 = x * x;
    let tail = (c0 + c1 * x) + ((c2 + c3 * x) + (c4 + c5 * x) * x2) * x2;
    high + (r + (r * (x * tail) + low))
}

/// (sin 2α, cos 2α) from tan α = n/d.
#[inline]
pub(crate) fn double_angle(n: f64, d: f64) -> (f64, f64) {
    let norm = n * n + d * d;
    (2.0 * (n * d) / norm, (d - n) * (d + n) / norm)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::double_trig::{half_angle, sin_small};

    /// 2⁻⁵³.
    const U: f64 = f64::EPSILON / 2.0;

    #[test]
    fn powers() {
        assert_eq!([0, -53, 1023, -1022].map(two_to), [1.0, U, 2.0 / f64::MIN_POSITIVE, f64::MIN_POSITIVE]);
        assert_eq!([-1023, -1074, -1075, 1024].map(two_to), [0.5 * f64::MIN_POSITIVE, 5e-324, 0.0, f64::INFINITY]);
        assert_eq!((power(3.0, 0), power(3.0, 5), power(0.0, 0), power(0.0, 2)), (1.0, 243.0, 1.0, 0.0));
    }

    #[test]
    fn sine_of_turns() {
        for i in 0..=4000 {
            let z = 0.25 * f64::from(i) / 4000.0;
            let exact = half_angle(Double::PI * (4.0 * z)).0;
            let error = (Double::new(sin_turns(z)) - exact).to_f64().abs();
            assert!(error <= 1.8 * U * exact.hi, "{z}: {}", error / exact.hi / U);
            assert_eq!(sin_turns(-z), -sin_turns(z));
        }
        assert!(sin_turns(0.0).is_sign_positive());
        let (tiny, exact) = (sin_turns(1e-300), sin_small(Double::PI * 2e-300).hi);
        assert!((tiny / exact - 1.0).abs() <= 2.0 * U);
    }

    /// Against Taylor's series in two words.
    #[test]
    fn exponential_less_one() {
        for i in 0..=4000 {
            let x = LARGEST_EXPONENT * (f64::from(i) / 4000.0) * (f64::from(i) / 4000.0);
            let whole = x as i32;
            let y = Double::LN_2 * (x - f64::from(whole));
            let small = (1..28).rev().fold(Double::ZERO, |sum, n| (sum + Double::ONE) * y / f64::from(n));
            let power = power(2.0, whole);
            let exact = small * power + Double::new(power - 1.0);
            let error = (Double::new(exp2_m1(x)) - exact).to_f64().abs();
            assert!(error <= 3.0 * U * exact.hi, "{x}: {}", error / exact.hi / U);
        }
        assert_eq!(exp2_m1(1e300), exp2_m1(LARGEST_EXPONENT));
        assert!(exp2_m1(f64::NAN).is_nan());
    }

    /// sin(a/4) d − cos(a/4) n measures the error of a, in two words.
    #[test]
    fn four_arctangents() {
        for i in 1..=4400 {
            let (n, d) = (1.7 * f64::from(i) / 4000.0, 1.7);
            let angle = four_atan(n, d);
            let (sine, cosine) = half_angle(Double::new(0.5 * angle));
            let length = libm::sqrt(n * n + d * d);
            let error = 4.0 * (sine * d - cosine * n).to_f64().abs() / length;
            assert!(error <= 2.5 * U * angle, "{n}/{d}: {}", error / angle / U);
        }
        assert_eq!(four_atan(0.0, 1.0), 0.0);
        assert_eq!(four_atan(1.0, 1.0), core::f64::consts::PI);
        assert_eq!(four_atan(1e-305, 1.0), 4e-305);
    }
}
