//! Nearest singularities, divided out.

use crate::plan::variables::Variables;
use crate::program::{Builder, Id};
use pendulum_runtime::double::Double;

/// (−height² − (p − place)²)^power, which vanishes at the nearest pair of singularities, or near it. θ̇, sin(θ/2) and
/// cos(θ/2) have simple poles there, θ̈ double ones, θ itself logarithms, which dividing doesn't remove but which poles
/// of other places stand for: see `pade.rs`.
///
/// Negative, since a polynomial ends with the sum of a product and a constant: were this another, compilers would pair
/// the two, and the division, which is to be done meanwhile, would wait for the polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pole {
    pub(super) place: Double,
    pub(super) height_squared: Double,
    power: i32,
}

impl Pole {
    /// Of a curve whose singularities are s = ½ ± i·strip. Numbers near the true ones serve as well: all are exact.
    pub(crate) fn new(strip: f64, power: i32) -> Self {
        Self::rounded(0.25 - strip * strip, strip * strip, power)
    }

    /// Of p² + `linear`·p + `constant`, if its zeros are not real.
    pub(super) fn of(constant: f64, linear: f64) -> Option<Self> {
        let place = -0.5 * linear;
        let height_squared = constant - place * place;
        (height_squared > 0.0 && height_squared < 1e3).then(|| Self::rounded(place, height_squared, 1))
    }

    fn rounded(place: f64, height_squared: f64, power: i32) -> Self {
        let [place, height_squared] = [place, height_squared].map(|x| Double::new(f64::from(x as f32)));
        Self { place, height_squared, power }
    }

    /// Those of p² + linear·p + constant, constant first, whatever the power.
    pub(super) fn coefficients(self) -> [f64; 2] {
        [self.place.hi * self.place.hi + self.height_squared.hi, -2.0 * self.place.hi]
    }

    /// The same of p in other units, of which `area` is one, but for the factor [`Self::unit`].
    pub(super) fn scaled(self, area: Double) -> Self {
        Self { place: self.place / area, height_squared: self.height_squared / (area * area), ..self }
    }

    /// What its value in units of `area` is multiplied with.
    pub(super) fn unit(self, area: Double) -> Double {
        (0..2 * self.power).fold(Double::ONE, |product, _| product * area)
    }

    /// At 8p − 1 = u.
    pub(super) fn at(self, u: Double) -> Double {
        let distance = (u + Double::ONE) * 0.125 - self.place;
        let single = -(distance * distance + self.height_squared);
        (1..self.power).fold(single, |product, _| product * single)
    }

    /// The least magnitude for |s| ≤ `phase`.
    pub(super) fn least(self, phase: f64) -> f64 {
        self.least_between(0.0, phase * phase)
    }

    /// The least magnitude for p between these.
    pub(super) fn least_between(self, low: f64, high: f64) -> f64 {
        let distance = (low - self.place.hi).max(self.place.hi - high).max(0.0);
        (distance * distance + self.height_squared.hi).powi(self.power)
    }

    /// Bounds the magnitude for |s| ≤ `radius`.
    pub(super) fn most(self, radius: f64) -> f64 {
        let distance = radius * radius + self.place.hi.abs();
        (distance * distance + self.height_squared.hi).powi(self.power)
    }

    /// Divides `value` by it.
    pub(super) fn divide(self, b: &mut Builder, value: Id, variables: &Variables) -> Id {
        let distance = variables.shifted(b, -self.place);
        let square = b.mul(distance, distance);
        let minus_height = b.exact(-self.height_squared);
        let mut divisor = b.sub(minus_height, square);
        let single = b.name(divisor, "d");
        for _ in 1..self.power {
            divisor = b.mul(divisor, single);
        }
        b.div(value, divisor)
    }

    /// Divides a polynomial, given in powers of y = p + `shift`, by it if it is single.
    pub(super) fn division(self, powers: &[Double], shift: Double) -> Quotient {
        let place = self.place + shift;
        let divisor = [-(place * place + self.height_squared), place * 2.0, -Double::ONE];
        let mut left = powers.to_vec();
        let mut polynomial = vec![Double::ZERO; powers.len() - 2];
        for (index, c) in polynomial.iter_mut().enumerate().rev() {
            *c = -left[index + 2];
            left[index + 1] = left[index + 1] - *c * divisor[1];
            left[index] = left[index] - *c * divisor[0];
        }
        let remainder = [left[0], left[1]];
        let mut product = vec![Double::ZERO; powers.len()];
        for (index, &c) in polynomial.iter().enumerate().rev() {
            for (sum, factor) in product[index..].iter_mut().zip(divisor) {
                *sum = *sum + c * factor;
            }
        }
        let mut lost: Vec<Double> = powers.iter().zip(product).map(|(c, product)| *c - product).collect();
        for (left, c) in lost.iter_mut().zip(remainder) {
            *left = *left - c;
        }
        Quotient { polynomial, remainder, lost }
    }

    /// Whether s over it has a smaller magnitude at 2·`half` than at `half`, and falls from there on: with D = (p − a)² + h²
    /// its derivative has the sign of D − 4·power·p(p − a), whose own by p is negative for p > a.
    pub(super) fn falls(self, half: f64) -> bool {
        let [low, high] = [half, 2.0 * half].map(|s| s * s);
        let distance = high - self.place.hi;
        let falling = distance > 0.0 && distance * distance + self.height_squared.hi < 4.0 * high * distance;
        falling && 2.1 * self.least_between(low, low) < self.least_between(high, high)
    }

    /// Whether its magnitude grows from |s| = `half` on.
    pub(super) fn grows(self, half: f64) -> bool {
        self.place.hi <= half * half
    }

    /// Terms of the divisor, for the reader.
    pub(super) fn terms(self) -> usize {
        2 * self.power as usize + 1
    }
}

/// What comes of dividing a polynomial by poles, in powers as it is given, the lowest first.
pub(super) struct Quotient {
    pub(super) polynomial: Vec<Double>,
    pub(super) remainder: [Double; 2],
    /// What the polynomial is more than the quotient times the divisor and the remainder, by rounding.
    pub(super) lost: Vec<Double>,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The least and the largest magnitude, and where it vanishes.
    #[test]
    fn poles() {
        for (strip, power) in [(0.1, 1), (0.4, 2), (0.6, 1), (0.9, 2)] {
            let pole = Pole::new(strip, power);
            let (mut least, mut most) = (f64::INFINITY, 0.0f64);
            for i in 0..=1000 {
                let value = pole.at(Double::new(f64::from(i) / 500.0 - 1.0)).hi * (-1.0f64).powi(power);
                (least, most) = (least.min(value), most.max(value));
            }
            let bound = pole.least(0.5);
            assert!(bound <= least * (1.0 + 1e-12) && least < 1.001 * bound, "{strip}: {least} {pole:?}");
            // On the circle |s| = radius the magnitude is largest where p is real and negative, or positive.
            for radius in [0.5, 0.8] {
                let magnitude = |angle: f64| {
                    let p = radius * radius;
                    let (re, im) = (p * angle.cos() - pole.place.hi, p * angle.sin());
                    let (re, im) = (re * re - im * im + pole.height_squared.hi, 2.0 * re * im);
                    re.hypot(im).powi(power)
                };
                let seen = (0..=720).map(|i| magnitude(f64::from(i).to_radians() / 2.0)).fold(0.0, f64::max);
                let most = pole.most(radius);
                assert!(seen <= most * (1.0 + 1e-12) && most <= 1.001 * seen, "{strip} {radius}: {most} for {seen}");
            }
            // It vanishes at s = ½ ± i·strip.
            let (re, im) = (0.25 - strip * strip - pole.place.hi, strip);
            assert!((re * re - im * im + pole.height_squared.hi).hypot(2.0 * re * im) < 1e-7, "{pole:?}");
        }
    }

    /// From a half on, wherever it is said to grow.
    #[test]
    fn divisors_that_grow() {
        let mut growing = 0;
        for (strip, half) in (1..40).flat_map(|tenths| [0.5, 0.3].map(|half| (0.05 * f64::from(tenths), half))) {
            let pole = Pole::new(strip, 1);
            let most = |s: f64| pole.at(Double::new(8.0 * s * s - 1.0)).hi.abs();
            let grows = (0..400).all(|step| most(half * 1.05f64.powi(step + 1)) > most(half * 1.05f64.powi(step)));
            assert!(grows || !pole.grows(half), "{strip} {half}");
            growing += u32::from(pole.grows(half));
        }
        assert!((40..78).contains(&growing), "{growing}");
    }

    /// Quotient times divisor and remainder are what was divided; and a multiple of the divisor leaves no remainder.
    #[test]
    fn quotients_and_remainders() {
        let pole = Pole::new(0.26, 1).scaled(Double::new(0.7));
        for (terms, shift) in (3..30).flat_map(|terms| [0.0, -0.125].map(|shift| (terms, Double::new(shift)))) {
            let powers: Vec<Double> =
                (0..terms).map(|j| Double::new(2.75 / f64::from(j + 1) * (-3.0_f64).powi(j))).collect();
            let Quotient { polynomial: quotient, remainder, lost } = pole.division(&powers, shift);
            assert_eq!((quotient.len(), lost.len()), (powers.len() - 2, powers.len()));
            for p in [0.0, 0.07, 0.3] {
                let at = |powers: &[Double]| {
                    powers.iter().rev().fold(Double::ZERO, |sum, &c| sum * (shift + Double::new(p)) + c)
                };
                let distance = Double::new(p) - pole.place;
                let divisor = -(distance * distance + pole.height_squared);
                let error = at(&quotient) * divisor + at(&remainder) - at(&powers);
                assert!((error + at(&lost)).hi.abs() < 1e-29, "{terms} {p}: {error:?}");
                assert!(at(&lost).hi.abs() < 1e-29, "{terms} {p}: {lost:?}");
            }
        }
        // −(p² − 2·place·p + place² + height²)(1 + 2p).
        let [constant, linear] = pole.coefficients().map(|c| -c);
        let multiple = [constant, linear + 2.0 * constant, -1.0 + 2.0 * linear, -2.0].map(Double::new);
        let Quotient { polynomial: quotient, remainder, .. } = pole.division(&multiple, Double::ZERO);
        assert!(remainder.iter().all(|c| c.hi.abs() < 1e-15), "{remainder:?}");
        assert!(quotient.iter().zip([1.0, 2.0]).all(|(c, expected)| (c.hi - expected).abs() < 1e-14), "{quotient:?}");
    }

    /// Beyond a whole anchor the quotient is less than at a half, wherever it is said to fall; it does by the poles of all
    /// but the smallest swings.
    #[test]
    fn quotients_that_fall() {
        let mut falling = 0;
        for (strip, power) in (1..40).flat_map(|tenths| [1, 2].map(|power| (0.05 * f64::from(tenths), power))) {
            let pole = Pole::new(strip, power);
            if !pole.falls(0.5) {
                continue;
            }
            falling += 1;
            assert!(pole.scaled(Double::new(16.0)).falls(0.125), "{strip}: not so in other units");
            let quotient = |s: f64| s / pole.at(Double::new(8.0 * s * s - 1.0)).hi.abs();
            let mut before = quotient(0.5);
            for s in (0..400).map(|step| 1.05f64.powi(step)) {
                assert!(quotient(s) < before, "{strip}: {} at {s}", quotient(s));
                before = quotient(s);
            }
        }
        assert!(falling > 20, "{falling}");
        assert!(!Pole::new(2.0, 1).falls(0.5));
    }
}
