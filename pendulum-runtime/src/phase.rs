//! Phase reduction: from the time to the fraction of a period, exactly enough for 2⁴⁵ periods.

use crate::double::{Double, quick_two_sum, split, two_sum};
use crate::kernel::round;

/// 2⁵⁰ turns, within what `round` can do.
const FAR: f64 = 1_125_899_906_842_624.0;

/// A uniform phase φ(t) = rate · t + offset, in turns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Phase {
    /// A power of two of the order of the rate, so that no product underflows or is split beyond 2⁹⁹⁵.
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

impl Phase {
    /// φ(t) = rate · omega · t + offset, for positive rate and omega.
    pub(crate) fn new(rate: Double, omega: f64, offset: Double) -> Self {
        let scale = binade(omega);
        let rate = rate * (omega / scale);
        Self { scale, rate, halves: split(rate.hi), offset }
    }

    /// φ(0).
    pub(crate) fn offset(&self) -> Double {
        self.offset
    }

    /// The time that φ takes to grow by `turns`.
    pub(crate) fn time(&self, turns: Double) -> f64 {
        (turns / self.rate).to_f64() / self.scale
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
    /// 10³⁰ periods; 0 from there on. `%` with 1 is exact.
    #[cold]
    fn reduce_far(&self, t: f64, x: f64, p: f64) -> Reduced {
        if !t.is_finite() {
            return Reduced { turns: f64::NAN, high: f64::NAN, low: f64::NAN };
        }
        if p.abs() > 1e30 {
            return Reduced { turns: p.clamp(f64::MIN, f64::MAX), high: self.offset.hi, low: 0.0 };
        }
        let e = self.product_error(x, p);
        let fraction = (p % 1.0 + e % 1.0) + ((x * self.rate.lo) % 1.0 + self.offset.hi);
        let more = round(fraction);
        Reduced { turns: p + more, high: fraction - more, low: 0.0 }
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

/// The power of two at or below `x` > 0; for a subnormal the smallest normal one.
pub(crate) fn binade(x: f64) -> f64 {
    f64::from_bits((x.to_bits() & (0x7ff << 52)).max(1 << 52))
}
