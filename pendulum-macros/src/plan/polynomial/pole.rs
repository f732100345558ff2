//! Nearest singularities, divided out.

use crate::program::{Builder, Id};
use pendulum_runtime::double::Double;

/// ((8p − place)² + height²)^power, which vanishes at the nearest pair of singularities. θ̇ has simple poles there, θ̈
/// and the position double ones, θ itself logarithms, which dividing doesn't remove.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pole {
    pub(super) place: f64,
    pub(super) height_squared: f64,
    power: i32,
}

impl Pole {
    /// Of a curve whose singularities are s = ½ ± i·strip. Numbers near the true ones serve as well: these are exact.
    pub(super) fn new(strip: f64, power: i32) -> Self {
        let round = |x: f64| f64::from(x as f32);
        Self { place: round(2.0 - 8.0 * strip * strip), height_squared: round(64.0 * strip * strip), power }
    }

    /// At 8p − 1 = u.
    pub(super) fn at(self, u: Double) -> Double {
        let distance = u + Double::new(1.0 - self.place);
        let single = distance * distance + Double::new(self.height_squared);
        (1..self.power).fold(single, |product, _| product * single)
    }

    /// The least value for 0 ≤ 8p ≤ 2.
    pub(super) fn least(self) -> f64 {
        let distance = (-self.place).max(self.place - 2.0).max(0.0);
        (distance * distance + self.height_squared).powi(self.power) * (1.0 - 1e-3)
    }

    /// Bounds the magnitude for |s| ≤ `radius`.
    pub(super) fn most(self, radius: f64) -> f64 {
        let distance = 8.0 * radius * radius + self.place.abs();
        (distance * distance + self.height_squared).powi(self.power)
    }

    /// Divides `value`; `centred` is 8p − centre.
    pub(super) fn divide(self, b: &mut Builder, value: Id, centred: Id, centre: f64) -> Id {
        let place = b.constant(self.place - centre);
        let distance = b.sub(centred, place);
        let square = b.mul(distance, distance);
        let height = b.constant(self.height_squared);
        let mut divisor = b.add(square, height);
        let single = b.name(divisor, "d");
        for _ in 1..self.power {
            divisor = b.mul(divisor, single);
        }
        b.div(value, divisor)
    }

    /// Terms of the divisor, for the reader.
    pub(super) fn terms(self) -> usize {
        2 * self.power as usize + 1
    }
}
