//! Theta quotients in their dual form, by one exponential and two polynomials in η = −4 sinh² X: what swings near the
//! top and rotations near the separatrix are made of.
//!
//! Each is returned as (numerator, denominator), for an arctangent or another factor to follow.

use crate::kernel::{exp2_m1, horner};

/// tanh X · N(η)/D(η) from 2X/ln 2, `n` and `d` being N − 1 and D − 1: of the 1 nothing is rounded but the sum with it.
#[inline]
pub(crate) fn tanh_quotient<const N: usize>(exponent: f64, (n, d): &([f64; N], [f64; N])) -> (f64, f64) {
    let g = exp2_m1(exponent);
    let eta = -(g * g) / (1.0 + g);
    let h = g + 2.0;
    (g + g * horner(n, eta), h + h * horner(d, eta))
}

/// ½ sech X · N(η)/D(η) from X/ln 2.
#[inline]
pub(crate) fn sech_quotient<const N: usize, const D: usize>(
    exponent: f64,
    (n, d): &([f64; N], [f64; D]),
) -> (f64, f64) {
    let e = exp2_m1(exponent) + 1.0;
    let inverse = 1.0 / e;
    let eta = -((e - inverse) * (e - inverse));
    (horner(n, eta), (e + inverse) * horner(d, eta))
}

/// 2 sinh X · N(η)/D(η) from X/ln 2.
#[inline]
pub(crate) fn sinh_quotient<const N: usize>(exponent: f64, (n, d): &([f64; N], [f64; N])) -> (f64, f64) {
    let g = exp2_m1(exponent);
    let twice_sinh = g + g / (1.0 + g);
    let eta = -(twice_sinh * twice_sinh);
    (twice_sinh * horner(n, eta), horner(d, eta))
}
