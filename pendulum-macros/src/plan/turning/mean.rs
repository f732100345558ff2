//! The mean rotation.

use crate::parse::Float;
use crate::power::two_to;
use crate::program::rounding::{half_ulp, rounding_up_to};
use crate::program::{Builder, Id};
use pendulum_runtime::double::Double;

/// The uniform rotation that an angle deviates from periodically.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mean {
    /// In rad per time.
    pub(crate) rate: Double,
    /// The angle at t = 0.
    pub(crate) start: Double,
    /// The most that it turns by within the horizon.
    pub(crate) turned: Double,
}

impl Mean {
    pub(super) fn lower(self, b: &mut Builder, periodic: Id) -> Id {
        let rate = b.rounded(self.rate);
        let t = b.input();
        let mean = b.mul(t, rate);
        let angle = b.offset(periodic, self.start);
        b.add(mean, angle)
    }

    /// What that is rounded by: the rate, the product, the angle at t = 0, the sum of that with what is periodic, at most so
    /// large, and of both, which no sum is larger than with the largest product, as it is rounded. Since what is rounded to
    /// a sum isn't farther from it than a part of it that is a number, no more is lost than the other part.
    pub(super) fn rounding(self, periodic: f64, float: Float) -> f64 {
        let of_rate = self.turned.hi * (float.rest(self.rate) / self.rate.hi).abs();
        let turned = self.turned + Double::new(of_rate);
        let product = of_rate + rounding_up_to(turned, float);
        let of_start = float.rest(self.start).abs();
        let angle = self.start.hi.abs() + of_start + periodic;
        let shifted = if self.start == Double::ZERO { 0.0 } else { half_ulp(angle, float).min(periodic) };
        let added = angle + shifted;
        let sum = rounding_up_to(Double::from_sum(float.round(turned.hi), added), float).min(added);
        product + of_start + shifted + sum
    }

    /// Whether the second word of its rate has all digits. In `f32` the first has, since a turn takes no more than the
    /// largest number.
    pub(super) fn is_normal(self) -> bool {
        self.rate.hi.abs() >= two_to(-900)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::assert_near;
    use super::*;
    use std::f64::consts::TAU;

    /// Of the mean rotation the rate and the product with the time are rounded, and the sum with what is periodic; the angle at
    /// t = 0, and the sum with that, if there is one.
    #[test]
    fn rounding_of_means() {
        let mean = |rate: Double, start: Double, turns: f64, periodic: f64| {
            Mean { rate, start, turned: Double::new(TAU * turns) }.rounding(periodic, Float::F64)
        };
        let rate = Double::new(2.5);
        for (start, turns, periodic, expected) in [
            (0.0, 1000.0, 0.1, 2.0 * 2f64.powi(-41)),
            (-3.0, 1000.0, 0.1, 2.0 * 2f64.powi(-41) + 2f64.powi(-52)),
            // 3.77, which what is periodic, and the angle at t = 0, may lead beyond 4.
            (0.0, 0.6, 0.2, 2.0 * 2f64.powi(-52)),
            (0.0, 0.6, 0.3, 2f64.powi(-52) + 2f64.powi(-51)),
            (-3.9, 0.6, 0.2, 2f64.powi(-52) + 2.0 * 2f64.powi(-51)),
        ] {
            assert_near(mean(rate, Double::new(start), turns, periodic), expected, 1e-3);
            assert_near(mean(-rate, Double::new(start), turns, periodic), expected, 1e-3);
        }
        let in_two_words = Double::from_sum(2.5, 2f64.powi(-54));
        let of_rate = TAU * 1000.0 * 2f64.powi(-54) / 2.5;
        assert_near(mean(in_two_words, Double::ZERO, 1000.0, 0.1), 2.0 * 2f64.powi(-41) + of_rate, 1e-3);
        let start = Double::from_sum(-3.9, 1e-16);
        assert_near(mean(rate, start, 0.6, 0.2), 1e-16 + 2f64.powi(-52) + 2.0 * 2f64.powi(-51), 1e-3);
    }

    /// Products are rounded to a power of two that is nearer than half a unit above it, and sums count from there.
    #[test]
    fn rounding_of_means_up_to_powers_of_two() {
        let next = |above: f64, of_rate: f64, periodic: f64| {
            let (rate, turned) = (Double::from_sum(4.0, of_rate), Double::from_sum(4.0, above));
            Mean { rate, start: Double::ZERO, turned }.rounding(periodic, Float::F64)
        };
        let below = 2f64.powi(-52);
        for (above, of_rate, expected) in [
            (-1e-17, 0.0, below),
            (2e-16, 0.0, below),
            (3e-16, 0.0, 3e-16),
            (5e-16, 0.0, 2.0 * below),
            (2e-16, 1e-16, 3e-16 + 1e-16),
        ] {
            assert_near(next(above, of_rate, 0.0), expected, 1e-3);
        }
        for (periodic, sum) in [(1e-17, 1e-17), (3e-16, 3e-16), (5e-16, 2.0 * below), (1e-9, 2.0 * below)] {
            assert_near(next(2e-16, 0.0, periodic), below + sum, 1e-3);
        }
        // In `f32`, half a unit above it, 2⁻²², products may be rounded to the next number.
        let single = Mean { rate: Double::new(4.0), start: Double::ZERO, turned: Double::new(4.0 + 2f64.powi(-22)) };
        for (periodic, sum) in [(1e-9, 1e-9), (1e-3, 2f64.powi(-22))] {
            assert_near(single.rounding(periodic, Float::F32), 2f64.powi(-22) + sum, 1e-3);
        }
    }

    /// No sum loses more than what is periodic, if that is next to nothing.
    #[test]
    fn rounding_of_means_that_are_all() {
        let mean = |start: f64, periodic: f64| {
            let mean = Mean { rate: Double::new(2.5), start: Double::new(start), turned: Double::new(100.0) };
            mean.rounding(periodic, Float::F64)
        };
        let product = mean(0.0, 0.0);
        assert_near(product, 2f64.powi(-47), 1e-9);
        for periodic in [1e-20, 1e-17] {
            assert_near(mean(0.0, periodic) - product, periodic, 1e-3);
            // Next to the start it is lost once, and that is rounded with the product.
            assert_near(mean(1.0, periodic) - product, product + periodic, 1e-3);
        }
    }
}
