//! Phase reduction: from the time to the fraction of a period, exactly enough for 2⁴⁵ periods.

use crate::double::{Double, quick_two_sum, split, two_sum};
use crate::kernel::{round, two_to};

/// 2⁵⁰ turns, within what `round` can do.
const FAR: f64 = two_to(50);

/// A uniform phase φ(t) = rate · t + offset, in turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Phase {
    /// A power of two of the order of the rate, so that no product underflows or is split beyond 2⁹⁹⁶.
    scale: f64,
    /// rate/scale in two words.
    rate: Double,
    /// Veltkamp's halves of `rate.hi`.
    halves: (f64, f64),
    /// φ(0), in [−½, ½].
    offset: Double,
}

/// φ(t) = turns + (high + low) with high + low in [−½, ½].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reduced {
    /// Whole turns, a whole number.
    pub(crate) turns: f64,
    /// The rest, rounded.
    pub(crate) high: f64,
    /// What rounding the rest left over.
    pub(crate) low: f64,
}

impl Reduced {
    /// |high + low|, in two words.
    #[inline]
    pub(crate) fn magnitude(&self) -> (f64, f64) {
        if self.high < 0.0 { (-self.high, -self.low) } else { (self.high, self.low) }
    }

    /// From the magnitude s: turns to the nearest multiple of ½, and ¼ − s.
    ///
    /// ¼ − s is exact from s = ⅛ on, ½ − s from ¼ on (Sterbenz), so what is steep near a multiple of ¼ keeps relative
    /// accuracy.
    #[inline]
    pub(crate) fn folded(&self) -> (f64, f64) {
        let (s, low) = self.magnitude();
        (if s <= 0.25 { s + low } else { (0.5 - s) - low }, (0.25 - s) - low)
    }
}

impl Phase {
    /// φ(t) = rate · omega · t + offset, for positive rate and omega.
    pub(crate) fn new(rate: Double, omega: f64, offset: Double) -> Self {
        let scale = unit_of(omega);
        let rate = rate * (omega / scale);
        Self { scale, rate, halves: split(rate.hi), offset }
    }

    /// The time that φ takes to grow by a turn.
    pub(crate) fn period(&self) -> f64 {
        (Double::ONE / self.rate).to_f64() / self.scale
    }

    /// Reduces φ(t). NaN for NaN and ±∞.
    ///
    /// t·rate.hi = p + e exactly (Dekker's product), p less its nearest whole number is exact, and e + t·rate.lo is
    /// below 2⁻⁷ with rounding error 2⁻⁶⁰ as long as |p| ≤ 2⁴⁵; what the two words of the rate leave out is
    /// 2⁻¹⁰² p < 2⁻⁵⁷.
    #[inline]
    pub(crate) fn reduce(&self, t: f64) -> Reduced {
        let x = t * self.scale;
        let p = x * self.rate.hi;
        if p.abs() < FAR {
            let e = self.product_error(x, p);
            let whole = round(p);
            let (sum, error) = two_sum(p - whole, self.offset.hi);
            normalise(whole, sum, error + (e + (x * self.rate.lo + self.offset.lo)))
        } else {
            self.reduce_far(t, x, p)
        }
    }

    /// t · rate.hi − p, exactly.
    #[inline]
    fn product_error(&self, t: f64, p: f64) -> f64 {
        let (th, tl) = split(t);
        let (rh, rl) = self.halves;
        ((th * rh - p) + th * rl + tl * rh) + tl * rl
    }

    /// Beyond 2⁵⁰ periods: still the true phase of the two words of the rate, which say less and less about it, up to
    /// 10³⁰ periods; that of t = 0 from there on.
    #[cold]
    fn reduce_far(&self, t: f64, x: f64, p: f64) -> Reduced {
        if !t.is_finite() {
            return Reduced { turns: f64::NAN, high: f64::NAN, low: f64::NAN };
        }
        if p.abs() > 1e30 {
            return Reduced { turns: p.clamp(f64::MIN, f64::MAX), high: self.offset.hi, low: 0.0 };
        }
        let e = self.product_error(x, p);
        let part = fraction(p); // below 2⁵² p may have one
        let rest = (part + fraction(e)) + (fraction(x * self.rate.lo) + self.offset.hi);
        let more = round(rest);
        Reduced { turns: (p - part) + more, high: rest - more, low: 0.0 }
    }
}

/// A sum of `whole` and `sum + low`, the latter below 2 in magnitude, as whole turns and a rest in [−½, ½].
#[inline]
fn normalise(whole: f64, sum: f64, low: f64) -> Reduced {
    let (high, low) = quick_two_sum(sum, low);
    let more = round(high);
    let (high, low) = quick_two_sum(high - more, low);
    Reduced { turns: whole + more, high, low }
}

/// 2⁵³, from which on there are only even numbers.
const EVEN: f64 = two_to(53);

/// The fractional part of a finite x, with its sign: x less what a cast leaves of it, exactly.
fn fraction(x: f64) -> f64 {
    if x.abs() < EVEN { x - (x as i64) as f64 } else { 0.0 }
}

/// Whether a whole number is odd.
#[inline]
pub(crate) fn is_odd(x: f64) -> bool {
    x.abs() < EVEN && (x as i64) & 1 == 1
}

/// The power of two at or below `x` > 0; for a subnormal the smallest normal one.
pub(crate) fn unit_of(x: f64) -> f64 {
    f64::from_bits((x.to_bits() & (0x7ff << 52)).max(1 << 52))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1/3 in two words: 3n periods' worth of time are whole turns, exactly known.
    fn third() -> Phase {
        Phase::new(Double::ONE / 3.0, 1.0, Double::ZERO)
    }

    /// 1,000,003·2ᵉ is 1 more than a multiple of 3 for even e, 1 less for odd; its product with the rate is not exact.
    #[test]
    fn far_times_lose_what_the_two_words_leave_out() {
        for offset in [0.0, 0.125] {
            let phase = Phase::new(Double::ONE / 3.0, 1.0, Double::new(offset));
            for e in 30..78 {
                let whole = 1_000_003_u128 << e;
                let (t, sign) = (whole as f64, if e % 2 == 0 { 1.0 } else { -1.0 });
                let reduced = phase.reduce(t);
                // 2⁻¹⁰⁶ of the turns, and the rounding of a sum of four fractions.
                let slack = t * two_to(-106) + 2.0 * f64::EPSILON;
                let off = reduced.high - (sign / 3.0 + offset);
                assert!((off - round(off)).abs() <= slack && reduced.high.abs() <= 0.5, "2^{e} {offset}: {reduced:?}");
                // As long as floats count turns, they are counted.
                let turns = ((whole + 1) / 3) as f64 + round(sign / 3.0 + offset);
                if whole < 3 << 52 {
                    assert_eq!(reduced.turns, turns, "2^{e} {offset}");
                }
                assert!((reduced.turns / turns - 1.0).abs() <= 2.0 * f64::EPSILON, "2^{e}");
            }
        }
    }

    #[test]
    fn long_times_lose_nothing() {
        for n in [1.0, 7.0, 1e9, 35_184_372_088_832.0] {
            for (t, fraction) in [(3.0 * n, 0.0), (3.0 * n + 1.0, 1.0 / 3.0), (3.0 * n - 1.0, -1.0 / 3.0)] {
                let reduced = third().reduce(t);
                assert_eq!(reduced.turns, n);
                // 2⁻⁶⁰ from the products, n 2⁻¹⁰⁸ from 1/3.
                assert!(((reduced.high - fraction) + reduced.low).abs() <= f64::EPSILON / 4.0, "{t} {reduced:?}");
            }
            assert!((third().reduce(3.0 * n).high).abs() <= 1e-18 * (1.0 + n * 1e-13), "{n}");
        }
    }

    #[test]
    fn odd_to_the_bit() {
        for t in [0.1, 1.7, 123.456, 1e12, 1e17, 1e40] {
            let (plus, minus) = (third().reduce(t), third().reduce(-t));
            assert_eq!((plus.high, plus.low, plus.turns), (-minus.high, -minus.low, -minus.turns));
        }
    }

    #[test]
    fn every_finite_time_has_a_phase() {
        for omega in [5e-324, 1e-300, 1.0, 1e300] {
            let phase = Phase::new(Double::ONE / Double::PI, omega, Double::new(0.25));
            for t in [0.0, 5e-324, 1e-300, 1e16, 1e100, f64::MAX, f64::MIN] {
                let reduced = phase.reduce(t);
                assert!(reduced.high.abs() <= 0.5 && reduced.turns.is_finite(), "{omega:e} {t:e} {reduced:?}");
            }
            for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                assert!(phase.reduce(t).high.is_nan());
            }
        }
    }

    #[test]
    fn whole_numbers_and_what_follows_their_point() {
        for x in [0.0, 0.75, 1.0, 2.5, 1e15 + 0.5, EVEN - 1.0, EVEN, EVEN + 2.0, 1e300, f64::MAX] {
            for x in [x, -x] {
                assert_eq!(fraction(x), x % 1.0, "{x:e}");
                if x % 1.0 == 0.0 {
                    assert_eq!(is_odd(x), x % 2.0 != 0.0, "{x:e}");
                }
            }
        }
    }

    #[test]
    fn units() {
        assert_eq!((unit_of(1.0), unit_of(1.99), unit_of(2.0), unit_of(0.3)), (1.0, 1.0, 2.0, 0.25));
        assert_eq!((unit_of(5e-324), unit_of(0.0)), (f64::MIN_POSITIVE, f64::MIN_POSITIVE));
    }
}
