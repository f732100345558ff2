//! Real numbers of 448 bits, by a library that `pendula` does not use.

use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use astro_float::{BigFloat, Consts, Radix, RoundingMode, Sign, WORD_BIT_SIZE, Word};

/// 2⁵³ periods take 53 bits of the phase, 1 − k² at π − 1e-12 takes 80, results need 120.
const BITS: usize = 448;
const ROUND: RoundingMode = RoundingMode::None;

thread_local! {
    static CONSTANTS: RefCell<Consts> = RefCell::new(Consts::new().expect("memory for the constants"));
}

/// A real number to about 134 digits.
#[derive(Clone, Debug)]
pub struct Big(BigFloat);

impl Big {
    /// π.
    pub fn pi() -> Self {
        Self(CONSTANTS.with_borrow_mut(|constants| constants.pi(BITS, ROUND)))
    }

    /// A decimal number; `None` if it is none.
    pub fn decimal(text: &str) -> Option<Self> {
        let value = CONSTANTS.with_borrow_mut(|constants| BigFloat::parse(text, Radix::Dec, BITS, ROUND, constants));
        (!value.is_nan()).then_some(Self(value))
    }

    /// √x.
    #[must_use]
    pub fn sqrt(&self) -> Self {
        Self(self.0.sqrt(BITS, ROUND))
    }

    /// eˣ.
    #[must_use]
    pub fn exp(&self) -> Self {
        Self(CONSTANTS.with_borrow_mut(|constants| self.0.exp(BITS, ROUND, constants)))
    }

    /// sin x.
    #[must_use]
    pub fn sin(&self) -> Self {
        Self(CONSTANTS.with_borrow_mut(|constants| self.0.sin(BITS, ROUND, constants)))
    }

    /// cos x.
    #[must_use]
    pub fn cos(&self) -> Self {
        Self(CONSTANTS.with_borrow_mut(|constants| self.0.cos(BITS, ROUND, constants)))
    }

    /// arctan x.
    #[must_use]
    pub fn atan(&self) -> Self {
        Self(CONSTANTS.with_borrow_mut(|constants| self.0.atan(BITS, ROUND, constants)))
    }

    /// arcsin x.
    #[must_use]
    pub fn asin(&self) -> Self {
        Self(CONSTANTS.with_borrow_mut(|constants| self.0.asin(BITS, ROUND, constants)))
    }

    /// The largest integer not above x.
    #[must_use]
    pub fn floor(&self) -> Self {
        Self(self.0.floor())
    }

    /// x less the nearest integer, in [−½, ½).
    #[must_use]
    pub fn less_turns(&self) -> Self {
        self - &(self + &0.5.into()).floor()
    }

    /// Whether x < 0.
    pub fn is_negative(&self) -> bool {
        self.0.is_negative() && !self.0.is_zero()
    }

    /// Whether x = 0.
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// log₂|x| rounded up to an integer, or so; very small for 0.
    pub fn magnitude(&self) -> i32 {
        if self.0.is_zero() { i32::MIN } else { self.0.exponent().unwrap_or(i32::MAX) }
    }

    /// The nearest `f64`, ties to even.
    pub fn to_f64(&self) -> f64 {
        let Some((words, _, sign, exponent, _)) = self.0.as_raw_parts() else { return f64::NAN };
        // The value is 0.words · 2^exponent.
        let top = word(words, 0);
        if top == 0 {
            return 0.0;
        }
        // Any lower bit breaks a tie; it may as well be the lowest of the upper word.
        let lower = &words[..words.len().saturating_sub(WORDS)];
        let sticky = u64::from(lower.iter().any(|&word| word != 0));
        let magnitude = scaled(top | sticky, exponent - 64);
        if sign == Sign::Neg { -magnitude } else { magnitude }
    }

    /// The nearest `f32`, ties to even, within the range of normal numbers.
    pub fn to_f32(&self) -> f32 {
        let near = self.to_f64();
        let rest = (self - &near.into()).to_f64();
        let rounded = near as f32;
        // Only where the `f64` is half-way between two `f32` does what it lacks matter.
        let towards = if rest > 0.0 { near.next_up() } else { near.next_down() };
        if rest == 0.0 { rounded } else { towards as f32 }
    }

    /// The value as a sum of two `f64`, good to 106 bits.
    pub fn to_pair(&self) -> [f64; 2] {
        let high = self.to_f64();
        [high, (self - &high.into()).to_f64()]
    }

    /// Bits of ⌊|x|·2^shift⌋ by words of 64, the least significant first, modulo 2²⁵⁶.
    pub fn fixed(&self, shift: i32) -> [u64; 4] {
        let mut fixed = [0; 4];
        let Some((words, _, _, exponent, _)) = self.0.as_raw_parts() else { return fixed };
        // x = W·2^(exponent − 64·length), so bit i of the result is bit i + offset of W.
        let length = words.len().div_ceil(WORDS) as i32;
        let offset = 64 * length - exponent - shift;
        let word = |index: i32| usize::try_from(length - 1 - index).map_or(0, |from_top| word(words, from_top));
        for (i, result) in fixed.iter_mut().enumerate() {
            let bit = 64 * i as i32 + offset;
            let (index, within) = (bit.div_euclid(64), bit.rem_euclid(64));
            let upper = if within == 0 { 0 } else { word(index + 1) << (64 - within) };
            *result = word(index) >> within | upper;
        }
        fixed
    }
}

/// The library's words in 64 bits: 32-bit machines take two.
const WORDS: usize = 64 / WORD_BIT_SIZE;

/// One of a mantissa's words of 64 bits, counted from the most significant, which the library has last; 0 beyond the
/// least.
fn word(mantissa: &[Word], from_top: usize) -> u64 {
    let wide = |word: Word| -> u64 { Into::into(word) };
    let part = |j: usize| mantissa.len().checked_sub(1 + from_top * WORDS + j).map_or(0, |at| wide(mantissa[at]));
    (0..WORDS).map(|j| part(j) << (64 - WORD_BIT_SIZE * (j + 1))).sum()
}

/// integer·2^exponent, rounded once. A subnormal result loses the bits below its last, as one rounding.
fn scaled(integer: u64, exponent: i32) -> f64 {
    let length = 64 - integer.leading_zeros() as i32;
    // The lowest bit a result may have is 2⁻¹⁰⁷⁴.
    let excess = (length - 53).max(-1074 - exponent);
    if excess <= 0 {
        return power(exponent) * integer as f64;
    }
    if excess > 64 {
        return 0.0;
    }
    let wide = u128::from(integer);
    let (kept, lost, half) = (wide >> excess, wide & ((1 << excess) - 1), 1_u128 << (excess - 1));
    let up = lost > half || lost == half && kept & 1 == 1;
    let kept = (kept + u128::from(up)) as f64;
    let exponent = exponent + excess;
    // In two steps, each exact, since 2^exponent may itself be out of range.
    kept * power(exponent / 2) * power(exponent - exponent / 2)
}

fn power(exponent: i32) -> f64 {
    2.0_f64.powi(exponent)
}

impl From<f64> for Big {
    fn from(value: f64) -> Self {
        // The library misreads subnormal numbers (0.9.6).
        if value.is_subnormal() {
            return &Self::from(value * power(600)) * &Self::from(power(-600));
        }
        Self(BigFloat::from_f64(value, BITS))
    }
}

impl Neg for &Big {
    type Output = Big;

    fn neg(self) -> Big {
        Big(BigFloat::neg(&self.0))
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for &Big {
            type Output = Big;

            fn $method(self, other: Self) -> Big {
                Big(self.0.$method(&other.0, BITS, ROUND))
            }
        }

        impl $operator for Big {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                (&self).$method(&other)
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

#[cfg(test)]
mod tests {
    use super::Big;

    #[test]
    fn rounds_to_nearest_even() {
        let tie = Big::from(1.0) + Big::from(f64::EPSILON / 2.0);
        assert_eq!(tie.to_f64(), 1.0);
        assert_eq!((&tie + &1e-60.into()).to_f64(), 1.0_f64.next_up());
        assert_eq!((&tie - &1e-60.into()).to_f64(), 1.0);
        let decimal = |text| Big::decimal(text).expect("a decimal").to_f64();
        // The standard library's conversions are correctly rounded.
        for text in
            ["1e-300", "4.9e-324", "7e-324", "2.4e-324", "3.3e-310", "2.2250738585072011e-308", "1.7e308", "-0.1"]
        {
            assert_eq!(decimal(text), text.parse().expect("a decimal"), "{text}");
        }
    }

    #[test]
    fn numbers_come_back() {
        for value in [1.0, -0.1, 3e-300, 1e300, f64::MIN_POSITIVE, 1.3e-312, -5e-324, 2.2e-308] {
            assert_eq!(Big::from(value).to_f64(), value);
            assert_eq!((&Big::from(value) * &3.0.into()).to_f64(), value * 3.0);
        }
    }

    #[test]
    fn fixed_point_holds_integer_and_fraction() {
        let value = Big::from(5.75);
        assert_eq!(value.fixed(192), [0, 0, 3 << 62, 5]);
        assert_eq!(value.fixed(2), [23, 0, 0, 0]);
        assert_eq!(value.fixed(-1), [2, 0, 0, 0]);
    }
}
