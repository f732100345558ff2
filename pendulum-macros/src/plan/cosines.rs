//! Sums of cosines near a point: where the sum and its derivatives lie, by Taylor's theorem.

use crate::power::power;
use pendulum_runtime::double::Double;
use std::f64::consts::PI;

/// Derivatives that are computed; the next one is bounded everywhere.
const ORDER: usize = 8;

/// Σ aₘ cos(mπs) in one word.
pub(super) struct Cosines {
    /// (mπ, aₘ).
    terms: Vec<(f64, f64)>,
    /// Σ |aₘ| (mπ)ʲ for j ≤ ORDER.
    magnitudes: [f64; ORDER + 1],
}

/// The sum and its derivatives over an interval.
pub(super) struct Local {
    derivatives: [f64; ORDER],
    remainder: f64,
    /// What the derivatives may be off by for their rounding.
    slack: [f64; ORDER],
    half: f64,
}

impl Cosines {
    pub(super) fn new(terms: impl Iterator<Item = (u32, f64)>) -> Self {
        let terms: Vec<(f64, f64)> = terms.map(|(m, a)| (f64::from(m) * PI, a)).collect();
        let magnitude = |j: i32| terms.iter().map(|(m, a)| a.abs() * power(*m, j)).sum();
        let magnitudes = std::array::from_fn(|j| magnitude(j as i32));
        Self { terms, magnitudes }
    }

    /// Of a series' terms.
    pub(super) fn of(terms: &[(u32, Double)]) -> Self {
        Self::new(terms.iter().map(|&(m, a)| (m, a.hi)))
    }

    /// Σ wₙ cos((2n−1)πs).
    pub(super) fn odd(weights: &[Double]) -> Self {
        Self::new((1..).step_by(2).zip(weights.iter().map(|w| w.hi)))
    }

    /// A sum of which Σ bₙ sin((2n−1)πs) is the derivative.
    pub(super) fn integral_of_sines(weights: &[Double]) -> Self {
        Self::new((1..).step_by(2).zip(weights).map(|(m, w)| (m, -w.hi / (f64::from(m) * PI))))
    }

    /// The largest the derivative of this order can be.
    pub(super) fn magnitude(&self, order: usize) -> f64 {
        self.magnitudes[order]
    }

    /// Over the interval from `low` to `high`.
    pub(super) fn over(&self, low: f64, high: f64) -> Local {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low).abs());
        let mut derivatives = [0.0; ORDER];
        for &(m, a) in &self.terms {
            let (sine, cosine) = libm::sincos(m * middle);
            let (sine, cosine) = (a * sine, a * cosine);
            let (m2, m3, m4) = (m * m, m * m * m, m * m * m * m);
            // Written out, since unoptimised this loop is most of the planner's work near the top.
            derivatives[0] += cosine;
            derivatives[1] -= sine * m;
            derivatives[2] -= cosine * m2;
            derivatives[3] += sine * m3;
            derivatives[4] += cosine * m4;
            derivatives[5] -= sine * (m4 * m);
            derivatives[6] -= cosine * (m4 * m * m);
            derivatives[7] += sine * (m4 * m * m * m);
        }
        // A sum of n terms is rounded n − 1 times, a term up to a dozen; and the angle mπs by 2.7e-16 of itself: the product
        // mπ of the rounded π, and that with s.
        let rounding = 1e-14_f64.max((self.terms.len() + 12) as f64 * f64::EPSILON / 2.0);
        let of_angle = 2.7e-16 * middle.abs();
        let slack = std::array::from_fn(|j| rounding * self.magnitudes[j] + of_angle * self.magnitudes[j + 1]);
        Local { derivatives, remainder: self.magnitudes[ORDER] * (1.0 + rounding), slack, half }
    }
}

impl Local {
    /// The derivative of this order in the middle.
    pub(super) fn middle(&self, order: usize) -> f64 {
        self.derivatives[order]
    }

    /// How far it is from that anywhere in the interval, at most.
    pub(super) fn spread(&self, order: usize) -> f64 {
        let mut weight = 1.0;
        let mut sum = self.slack[order];
        for j in order + 1..=ORDER {
            weight *= self.half / (j - order) as f64;
            sum += weight * if j < ORDER { self.derivatives[j].abs() + self.slack[j] } else { self.remainder };
        }
        sum
    }

    pub(super) fn range(&self, order: usize) -> (f64, f64) {
        let (middle, spread) = (self.middle(order), self.spread(order));
        (middle - spread, middle + spread)
    }

    pub(super) fn largest(&self, order: usize) -> f64 {
        self.middle(order).abs() + self.spread(order)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chebyshev::{cos_pi, sin_pi};

    /// At a point there is no spread but that of roundings, which are those of m·π·s in one word.
    #[test]
    fn roundings_of_high_harmonics() {
        for m in [1, 31, 401, 799] {
            let sum = Cosines::new([(m, 0.75)].into_iter());
            for s in [0.0, 0.1, 0.3, 0.49, 0.5, 0.9, 1.7, -3.6] {
                let local = sum.over(s, s);
                // m·s less the nearest even number, exactly.
                let phase = Double::new(f64::from(m)) * s;
                let phase = phase - Double::new(2.0 * (0.5 * phase.hi).round());
                let mut scale = Double::new(0.75);
                for order in 0..ORDER {
                    let wave = if order % 2 == 0 { cos_pi(phase) } else { sin_pi(phase) };
                    let exact = wave * scale * if matches!(order % 4, 1 | 2) { -1.0 } else { 1.0 };
                    let error = (exact - Double::new(local.middle(order))).hi.abs();
                    let most = scale.hi * (1e-14 + 2.8e-16 * PI * f64::from(m) * s.abs());
                    assert!(error <= local.spread(order) && local.spread(order) <= most, "{m} {s} {order}: {error:e}");
                    scale = scale * Double::PI * f64::from(m);
                }
            }
        }
    }

    /// About its summit the bound of a cosine is Taylor's series of cosh, of a slope that of sinh.
    #[test]
    fn spreads_about_a_summit() {
        let half = 0.3;
        let local = Cosines::new([(1, 1.0)].into_iter()).over(-half, half);
        let x = PI * half;
        for (order, known) in [(0, x.cosh() - 1.0), (1, PI * x.sinh()), (2, PI * PI * (x.cosh() - 1.0))] {
            assert!((local.spread(order) / known - 1.0).abs() < 2e-4, "{order}: {} {known}", local.spread(order));
        }
    }

    #[test]
    fn intervals_hold_samples_and_are_not_wide() {
        let sum = Cosines::new([(1, 0.9), (3, -0.4), (15, 0.01), (31, -1e-3)].into_iter());
        let at = |s: f64| sum.over(s, s);
        for cell in 0..64 {
            let (low, high) = (f64::from(cell) / 128.0, f64::from(cell + 1) / 128.0);
            let local = sum.over(low, high);
            for order in 0..3 {
                let samples = (0..=50).map(|i| at(low + (high - low) * f64::from(i) / 50.0).middle(order));
                let (least, most) =
                    samples.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)));
                let (from, to) = local.range(order);
                assert!(from <= least && most <= to, "{cell}, {order}");
                // Of waves as long as the cell is four times.
                let width = 0.3 * sum.magnitude(order) * (high - low) * 31.0 * PI;
                assert!(to - from <= 2.0 * (most - least) + width, "{cell}, {order}: {from} to {to}");
            }
        }
    }
}
