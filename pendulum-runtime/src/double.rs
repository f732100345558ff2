//! Double-double arithmetic: a real number as an unevaluated sum of two `f64`, about 106 bits.
//!
//! The building blocks are error-free transformations: `two_sum` (Knuth, TAOCP 2, 4.2.2, theorem B), `quick_two_sum`
//! (Dekker 1971) and `two_prod` with Veltkamp's splitting. No fused multiply-add is used, so the bits are the same on
//! every IEEE target. The error bounds quoted of sums and products are those of Joldes, Muller and Popescu, "Tight and
//! rigorous error bounds for basic building blocks of double-word arithmetic" (ACM TOMS 44, 2017), with u = 2⁻⁵³.
//! Splitting serves up to 2⁹⁹⁶, beyond which it soon overflows, and `two_prod` is inexact where the product's low word
//! underflows; callers stay within that.

#![expect(
    clippy::inline_always,
    reason = "a few operations each, which the macro's planner does by the ten thousand in unoptimised builds"
)]

use core::ops::{Add, Div, Mul, Neg, Sub};

/// `hi + lo` with `|lo| ≤ ulp(hi)/2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Double {
    /// The value rounded to nearest.
    pub hi: f64,
    /// What rounding left over.
    pub lo: f64,
}

/// Numbers up to this are split without overflow, and have room for a factor of 10⁹.
pub(crate) const LARGEST: f64 = 1e290;

/// `a + b = s + e` exactly.
#[inline(always)]
#[must_use]
pub const fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let b_seen = s - a;
    (s, (a - (s - b_seen)) + (b - b_seen))
}

/// `a + b = s + e` exactly, for `|a| ≥ |b|` or `a = 0`.
#[inline(always)]
#[must_use]
pub const fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// Veltkamp's splitting: `a = hi + lo` exactly, with at most 26 significant bits in each.
#[inline(always)]
#[must_use]
pub const fn split(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a; // 2²⁷ + 1
    let hi = c - (c - a);
    (hi, a - hi)
}

/// `a · b = p + e` exactly.
#[inline(always)]
#[must_use]
pub const fn two_prod(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let (ah, al) = split(a);
    let (bh, bl) = split(b);
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

impl Double {
    /// Zero.
    pub const ZERO: Self = Self::new(0.0);
    /// One.
    pub const ONE: Self = Self::new(1.0);
    /// π to 107 bits.
    pub const PI: Self = Self { hi: core::f64::consts::PI, lo: 1.224_646_799_147_353_2e-16 };
    /// ln 2 to 107 bits.
    pub const LN_2: Self = Self { hi: core::f64::consts::LN_2, lo: 2.319_046_813_846_299_6e-17 };
    /// 2π.
    pub const TURN: Self = Self::PI.scale(2.0);
    /// 1/(2π).
    pub(crate) const INVERSE_TURN: Self = Self { hi: 0.159_154_943_091_895_35, lo: -9.839_338_337_591_243e-18 };

    /// An `f64`, exactly.
    #[inline(always)]
    #[must_use]
    pub const fn new(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }

    /// Normalises any two words.
    #[inline(always)]
    #[must_use]
    pub const fn from_sum(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self { hi, lo }
    }

    /// The exact product of two `f64`.
    #[inline(always)]
    #[must_use]
    pub const fn from_product(a: f64, b: f64) -> Self {
        let (hi, lo) = two_prod(a, b);
        Self { hi, lo }
    }

    /// The nearest `f64`.
    #[inline(always)]
    #[must_use]
    pub const fn to_f64(self) -> f64 {
        self.hi + self.lo
    }

    /// |x|.
    #[inline(always)]
    #[must_use]
    pub const fn abs(self) -> Self {
        if self.hi < 0.0 { Self { hi: -self.hi, lo: -self.lo } } else { self }
    }

    /// x · 2ᵏ for an exact power of two `scale` (no rounding short of overflow and underflow).
    #[inline(always)]
    #[must_use]
    pub const fn scale(self, scale: f64) -> Self {
        Self { hi: self.hi * scale, lo: self.lo * scale }
    }

    /// √x for x ≥ 0, within 5u² (Karp's trick: one Newton step from the `f64` root, which is within 1.5u: that leaves half
    /// of its square, and the step is rounded by 2u of itself).
    #[inline(always)]
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Self::ZERO;
        }
        let root = libm::sqrt(self.hi);
        let rest = (self - Self::from_product(root, root)).hi / (2.0 * root);
        let (hi, lo) = quick_two_sum(root, rest);
        Self { hi, lo }
    }
}

impl Neg for Double {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Add for Double {
    type Output = Self;
    /// Relative error ≤ 3u² + 13u³ (algorithm 6 there).
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (s, e) = two_sum(self.hi, other.hi);
        let (t, f) = two_sum(self.lo, other.lo);
        let (s, e) = quick_two_sum(s, e + t);
        let (hi, lo) = quick_two_sum(s, e + f);
        Self { hi, lo }
    }
}

impl Sub for Double {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;
    /// Relative error ≤ 7u² (algorithm 10 there).
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (p, e) = two_prod(self.hi, other.hi);
        let (hi, lo) = quick_two_sum(p, e + (self.hi * other.lo + self.lo * other.hi));
        Self { hi, lo }
    }
}

impl Mul<f64> for Double {
    type Output = Self;
    /// Relative error ≤ 3u² (algorithm 8 there).
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        let (p, e) = two_prod(self.hi, other);
        let (hi, lo) = quick_two_sum(p, e + self.lo * other);
        Self { hi, lo }
    }
}

impl Div for Double {
    type Output = Self;
    /// Relative error ≤ 10u² (long division with two quotient words and a correction: the first product is wrong by 3u²,
    /// the last sum by as much, and what is left by less than u²).
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self - other * first;
        let second = rest.hi / other.hi;
        let rest = rest - other * second;
        let third = rest.hi / other.hi;
        let (hi, lo) = quick_two_sum(first, second);
        Self { hi, lo } + Self::new(third)
    }
}

impl Div<f64> for Double {
    type Output = Self;
    /// Relative error ≤ 3u² (algorithm 15 there).
    #[inline(always)]
    fn div(self, other: f64) -> Self {
        let first = self.hi / other;
        let (p, e) = two_prod(first, other);
        let rest = ((self.hi - p) - e) + self.lo;
        let (hi, lo) = quick_two_sum(first, rest / other);
        Self { hi, lo }
    }
}

/// |x/exact − 1|, for tests.
#[cfg(test)]
pub(crate) fn relative_error(x: Double, exact: Double) -> f64 {
    ((x - exact) / exact).abs().to_f64()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 2⁻⁵³.
    const U: f64 = f64::EPSILON / 2.0;

    #[test]
    fn transformations_lose_nothing() {
        assert_eq!(two_sum(1.0, 1e-30), (1.0, 1e-30));
        assert_eq!(two_sum(1e-30, 1.0), (1.0, 1e-30));
        assert_eq!(quick_two_sum(1.0, U), (1.0, U));
        // (1 + 2⁻³⁰)² = 1 + 2⁻²⁹ + 2⁻⁶⁰
        let x = 1.0 + 1.0 / 1_073_741_824.0;
        assert_eq!(two_prod(x, x), (1.0 + 2.0 / 1_073_741_824.0, U / 128.0));
        let (high, low) = split(core::f64::consts::PI);
        assert_eq!(high + low, core::f64::consts::PI);
        assert_eq!((high.to_bits() | low.to_bits()) & 0x3ff_ffff, 0);
    }

    /// Division, multiplication and root undo one another within the sum of their bounds.
    #[test]
    fn operations_keep_their_bounds() {
        let mut x = Double { hi: 0.731, lo: 3.1e-17 };
        for _ in 0..1000 {
            let y = x * Double::PI + Double::ONE;
            assert!(relative_error(y / x * x, y) <= 20.0 * U * U);
            assert!(relative_error(y.sqrt() * y.sqrt(), y) <= 16.0 * U * U);
            assert!(relative_error((y - Double::ONE) / Double::PI, x) <= 30.0 * U * U);
            assert!(relative_error(y / x.hi * x.hi, y) <= 6.0 * U * U);
            x = Double::ONE / y + x.scale(0.5);
        }
        assert_eq!(Double::ZERO.sqrt(), Double::ZERO);
        assert_eq!((-Double::PI).abs(), Double::PI);
        assert_eq!(Double::from_sum(1e-30, 1.0).to_f64(), 1.0);
    }

    /// Where the first words cancel, what the second words' sum leaves over is the second word.
    #[test]
    fn a_sum_keeps_what_the_small_words_lose() {
        let (a, b) = (Double { hi: 1.0, lo: U / 3.0 }, Double { hi: -1.0, lo: U * U / 7.0 });
        let (t, f) = two_sum(a.lo, b.lo);
        assert!(f != 0.0);
        assert_eq!(a + b, Double { hi: t, lo: f });
        assert!(Double::ZERO.abs().hi.is_sign_positive());
    }

    /// The roots that everything takes: s is the correctly rounded root of x when x lies between the squares of the
    /// midpoints about s.
    #[test]
    fn single_roots_are_correctly_rounded() {
        let mut x = 0.013_f64;
        for _ in 0..1000 {
            x = x * 1.37 % 3.9;
            let s = libm::sqrt(x);
            let (p, e) = two_prod(s, s);
            assert!(((x - p) - e).abs() <= s * (s.next_up() - s) * (1.0 + 1e-15));
        }
        assert!(libm::sqrt(-1.0).is_nan());
        assert_eq!((libm::sqrt(-0.0).to_bits(), libm::sqrt(f64::INFINITY)), ((-0.0_f64).to_bits(), f64::INFINITY));
        assert_eq!(libm::sqrt(5e-324), 2.2227587494850775e-162);
    }

    #[test]
    fn pi_and_the_inverse_turn_have_their_second_words() {
        // sin x for x = the first word of π is π − x to third order.
        assert!((libm::sin(Double::PI.hi) - Double::PI.lo).abs() < U * U);
        assert_eq!(Double::INVERSE_TURN, Double::ONE / Double::TURN);
    }
}
