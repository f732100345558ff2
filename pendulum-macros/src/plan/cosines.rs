//! Sums of cosines near a point: where the sum and its derivatives lie, by Taylor's theorem; and suprema by bisection.

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
        let magnitude = |j: i32| terms.iter().map(|(m, a)| a.abs() * m.powi(j)).sum();
        let magnitudes = std::array::from_fn(|j| magnitude(j as i32));
        Self { terms, magnitudes }
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
            let (sine, cosine) = (m * middle).sin_cos();
            let waves = [a * cosine, -a * sine, -a * cosine, a * sine];
            let mut power = 1.0;
            for (j, derivative) in derivatives.iter_mut().enumerate() {
                *derivative += waves[j % 4] * power;
                power *= m;
            }
        }
        // Sums of some hundred terms, and cosines of angles that are rounded.
        let slack = std::array::from_fn(|j| 1e-14 * self.magnitudes[j] + 2.3e-16 * self.magnitudes[j + 1]);
        Local { derivatives, remainder: self.magnitudes[ORDER], slack, half }
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
            sum += weight * self.derivatives.get(j).map_or(self.remainder, |derivative| derivative.abs());
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

/// Bounds a function on [low, high], given one on any interval, by halving the interval with the largest bound: until that
/// gains less than a part in `precision`, or `most` times.
pub(super) fn by_halves([low, high]: [f64; 2], cells: u32, most: usize, bound: impl Fn(f64, f64) -> f64) -> f64 {
    const GAIN: f64 = 0.97;
    let at = |index: u32| low + (high - low) * f64::from(index) / f64::from(cells);
    let cell = |low: f64, high: f64| (bound(low, high), low, high);
    let mut open: Vec<(f64, f64, f64)> = (0..cells).map(|index| cell(at(index), at(index + 1))).collect();
    let mut settled: f64 = 0.0;
    for _ in 0..most {
        let worst = (0..open.len()).max_by(|&a, &b| open[a].0.total_cmp(&open[b].0));
        let Some(worst) = worst.filter(|&worst| open[worst].0 > settled) else { break };
        let (before, low, high) = open.swap_remove(worst);
        let middle = 0.5 * (low + high);
        let halves = [cell(low, middle), cell(middle, high)];
        let after = halves[0].0.max(halves[1].0);
        if before.is_finite() && after > GAIN * before {
            settled = settled.max(after);
        } else {
            open.extend(halves);
        }
    }
    open.iter().fold(settled, |most, cell| most.max(cell.0))
}

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    fn halving_finds_a_narrow_peak() {
        // sup of s/(s² + a²) is 1/(2a), at s = a.
        let a = 1e-6;
        let bound = |low: f64, high: f64| high / (low * low + a * a);
        let found = by_halves([0.0, 1.0], 16, 200, bound);
        assert!(found >= 0.5 / a && found < 0.56 / a, "{found}");
        assert_eq!(by_halves([0.0, 1.0], 4, 10, |low, _| if low == 0.0 { f64::INFINITY } else { 1.0 }), f64::INFINITY);
    }

    /// From the first number to the last, whole or in cells.
    #[test]
    fn halving_covers_its_interval() {
        for most in [0, 3] {
            assert_eq!(by_halves([1.0, 3.0], 4, most, |_, high| high), 3.0);
            assert_eq!(by_halves([1.0, 3.0], 4, most, |low, _| 1.0 / low), 1.0);
        }
    }
}
