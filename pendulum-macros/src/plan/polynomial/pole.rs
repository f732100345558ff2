//! Poles at a curve's nearest singularities, or near them, divided out.

use super::interval;
use crate::parse::Float;
use crate::plan::variables::Variables;
use crate::program::{Builder, Id};
use pendulum_runtime::double::Double;

/// Π (−height² − (p − place)²), which vanishes at the nearest pairs of singularities, or near them. θ̇, sin(θ/2) and
/// cos(θ/2) have simple poles there, θ̈ double ones, of which both pairs are the same, θ itself logarithms, which dividing
/// doesn't remove but which poles of other places stand for: see `pade.rs`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pole {
    first: Pair,
    second: Option<Pair>,
    /// The type of which its numbers are.
    float: Float,
}

/// −height² − (p − place)².
///
/// Negative, since a polynomial ends with the sum of a product and a constant: were this another, compilers would pair
/// the two, and the division, which is to be done meanwhile, would wait for the polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pair {
    pub(super) place: Double,
    pub(super) height_squared: Double,
}

impl Pair {
    fn rounded(place: f64, height_squared: f64, float: Float) -> Self {
        let [place, height_squared] = [place, height_squared].map(|x| Double::new(float.round(x)));
        Self { place, height_squared }
    }

    /// Of p² + `linear`·p + `constant`, if its zeros are not real, nor so far away that they change next to nothing.
    fn of([constant, linear]: [f64; 2], float: Float) -> Option<Self> {
        let place = -0.5 * linear;
        let height_squared = constant - place * place;
        (height_squared > 0.0 && height_squared < 1e3).then(|| Self::rounded(place, height_squared, float))
    }

    /// Those of p² + linear·p + constant, constant first.
    fn coefficients(self) -> [f64; 2] {
        [self.place.hi * self.place.hi + self.height_squared.hi, -2.0 * self.place.hi]
    }

    fn at(self, p: Double) -> Double {
        let distance = p - self.place;
        -(distance * distance + self.height_squared)
    }

    fn least_between(self, low: f64, high: f64) -> f64 {
        let distance = (low - self.place.hi).max(self.place.hi - high).max(0.0);
        distance * distance + self.height_squared.hi
    }

    fn most(self, radius: f64) -> f64 {
        let distance = radius * radius + self.place.hi.abs();
        distance * distance + self.height_squared.hi
    }

    fn lower(self, b: &mut Builder, variables: &Variables) -> Id {
        let distance = variables.shifted(b, -self.place);
        let square = b.mul(distance, distance);
        let minus_height = b.rounded(-self.height_squared);
        let divisor = b.sub(minus_height, square);
        b.name(divisor, "d")
    }
}

impl Pole {
    /// Of a curve whose singularities are s = ½ ± i·strip, single or double. Numbers of a type that are near the true ones
    /// serve as well: all are exact.
    pub(crate) fn new(strip: f64, power: usize, float: Float) -> Self {
        let pair = Pair::rounded(0.25 - strip * strip, strip * strip, float);
        Self { first: pair, second: (power == 2).then_some(pair), float }
    }

    /// Of p² + `linear`·p + `constant`, given as [constant, linear], if its zeros are not real.
    pub(super) fn of(coefficients: [f64; 2], float: Float) -> Option<Self> {
        Some(Self { first: Pair::of(coefficients, float)?, second: None, float })
    }

    /// Of a product of two such polynomials.
    pub(super) fn of_two(factors: [[f64; 2]; 2], float: Float) -> Option<Self> {
        let [first, second] = factors.map(|coefficients| Pair::of(coefficients, float));
        Some(Self { first: first?, second: Some(second?), float })
    }

    pub(super) fn float(self) -> Float {
        self.float
    }

    pub(super) fn pairs(self) -> impl Iterator<Item = Pair> {
        std::iter::once(self.first).chain(self.second)
    }

    /// How many pairs there are, the same ones as two.
    pub(super) fn count(self) -> usize {
        1 + usize::from(self.second.is_some())
    }

    /// Whether there are two different pairs.
    pub(super) fn is_of_two(&self) -> bool {
        self.second.is_some_and(|second| second != self.first)
    }

    /// The coefficients of the first pair, p² + linear·p + constant, constant first.
    pub(super) fn coefficients(self) -> [f64; 2] {
        self.first.coefficients()
    }

    /// The coefficients of the product of all, but for its sign: the lowest first, the highest 1.
    pub(super) fn powers(self) -> Vec<f64> {
        self.pairs().fold(vec![1.0], |product, pair| {
            let [constant, linear] = pair.coefficients();
            let mut next = vec![0.0; product.len() + 2];
            for (index, c) in product.into_iter().enumerate() {
                next[index] += constant * c;
                next[index + 1] += linear * c;
                next[index + 2] += c;
            }
            next
        })
    }

    /// The same of p in other units, of which `area` is one, but for the factor [`Self::unit`].
    pub(super) fn scaled(self, area: Double) -> Self {
        let scaled = |Pair { place, height_squared }| Pair {
            place: place / area,
            height_squared: height_squared / (area * area),
        };
        Self { first: scaled(self.first), second: self.second.map(scaled), ..self }
    }

    /// What its value in units of `area` is multiplied with.
    pub(super) fn unit(self, area: Double) -> Double {
        (0..2 * self.count()).fold(Double::ONE, |product, _| product * area)
    }

    /// At 8p − 1 = u.
    pub(super) fn at(self, u: Double) -> Double {
        let p = interval::p_in_two_words(u);
        self.pairs().fold(Double::ONE, |product, pair| product * pair.at(p))
    }

    /// A lower bound of its magnitude for |s| ≤ `phase`, of one pair and of equal ones the least.
    pub(super) fn least(self, phase: f64) -> f64 {
        self.least_between(0.0, phase * phase)
    }

    /// The same for p between these.
    pub(super) fn least_between(self, low: f64, high: f64) -> f64 {
        self.pairs().map(|pair| pair.least_between(low, high)).product()
    }

    /// Bounds the magnitude for |s| ≤ `radius`.
    pub(super) fn most(self, radius: f64) -> f64 {
        self.pairs().map(|pair| pair.most(radius)).product()
    }

    /// Divides `value` by it.
    pub(super) fn divide(self, b: &mut Builder, value: Id, variables: &Variables) -> Id {
        let first = self.first.lower(b, variables);
        let divisor = self.second.map_or(first, |second| {
            let factor = second.lower(b, variables);
            b.mul(first, factor)
        });
        b.div(value, divisor)
    }

    /// Divides a polynomial, given in powers of y = p + `shift`, by a single pair.
    pub(super) fn division(self, powers: &[Double], shift: Double) -> Quotient {
        let Pair { place, height_squared } = self.first;
        let place = place + shift;
        let divisor = [-(place * place + height_squared), place * 2.0, -Double::ONE];
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

    /// Whether s over it has a smaller magnitude at 2·`half` than at `half`, and falls from there on: over the first pair,
    /// D = (p − a)² + h², while the others grow. Its derivative has the sign of D − 4p(p − a), whose own by p is negative
    /// for p > a.
    pub(super) fn falls(self, half: f64) -> bool {
        let [low, high] = [half, 2.0 * half].map(|s| s * s);
        let Pair { place, height_squared } = self.first;
        let distance = high - place.hi;
        let falling = distance > 0.0 && distance * distance + height_squared.hi < 4.0 * high * distance;
        let growing = self.count() == 1 || self.grows(2.0 * half);
        falling && growing && 2.1 * self.least_between(low, low) < self.least_between(high, high)
    }

    /// Whether its magnitude grows from |s| = `half` on.
    pub(super) fn grows(self, half: f64) -> bool {
        self.pairs().all(|pair| pair.place.hi <= half * half)
    }

    /// Terms of the divisor, for the reader.
    pub(super) fn terms(self) -> usize {
        2 * self.count() + 1
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
            let pole = Pole::new(strip, power, Float::F64);
            let (mut least, mut most) = (f64::INFINITY, 0.0f64);
            for i in 0..=1000 {
                let value = pole.at(Double::new(f64::from(i) / 500.0 - 1.0)).hi * (-1.0f64).powi(power as i32);
                (least, most) = (least.min(value), most.max(value));
            }
            let bound = pole.least(0.5);
            let Pair { place, height_squared } = pole.first;
            assert!(bound <= least * (1.0 + 1e-12) && least < 1.001 * bound, "{strip}: {least} {pole:?}");
            // On the circle |s| = radius the magnitude is largest where p is real and negative, or positive.
            for radius in [0.5, 0.8] {
                let magnitude = |angle: f64| {
                    let p = radius * radius;
                    let (re, im) = (p * angle.cos() - place.hi, p * angle.sin());
                    let (re, im) = (re * re - im * im + height_squared.hi, 2.0 * re * im);
                    re.hypot(im).powi(power as i32)
                };
                let seen = (0..=720).map(|i| magnitude(f64::from(i).to_radians() / 2.0)).fold(0.0, f64::max);
                let most = pole.most(radius);
                assert!(seen <= most * (1.0 + 1e-12) && most <= 1.001 * seen, "{strip} {radius}: {most} for {seen}");
            }
            // It vanishes at s = ½ ± i·strip.
            let (re, im) = (0.25 - strip * strip - place.hi, strip);
            assert!((re * re - im * im + height_squared.hi).hypot(2.0 * re * im) < 1e-7, "{pole:?}");
        }
    }

    /// Of two pairs it is the product, which vanishes where either does; the bounds hold, and are those of one where both are
    /// the same.
    #[test]
    fn two_pairs() {
        let [near, far] = [[0.11, -0.36], [0.15, -0.44]];
        let (pole, one, other) = (
            Pole::of_two([near, far], Float::F64).unwrap(),
            Pole::of(near, Float::F64).unwrap(),
            Pole::of(far, Float::F64).unwrap(),
        );
        assert!(pole.is_of_two() && pole.terms() == 5 && !Pole::new(0.3, 2, Float::F64).is_of_two());
        let area = Double::new(0.7);
        for i in 0..=100 {
            let u = Double::new(f64::from(i) / 50.0 - 1.0);
            let (found, expected) = (pole.at(u), one.at(u) * other.at(u));
            assert!((found - expected).hi.abs() < 1e-30);
            assert!(pole.least(0.5) <= found.hi && found.hi <= pole.most(0.5));
            let p = (u.hi + 1.0) / 8.0;
            let powers = pole.powers().iter().rev().fold(0.0, |sum, c| sum * p + c);
            assert!((powers - found.hi).abs() < 1e-16, "{powers} {found:?}");
            let p = p / area.hi;
            let scaled = pole.scaled(area).least_between(p, p) * pole.unit(area).hi;
            assert!((scaled - found.hi).abs() < 1e-15, "{scaled} {found:?}");
        }
        assert_eq!(Pole::of_two([near, [0.01, -0.36]], Float::F64), None);
        assert!(pole.grows(0.5) && !pole.grows(0.45));
        let quotient = |s: f64| s / pole.at(Double::new(8.0 * s * s - 1.0)).hi;
        let falls = (0..400).all(|step| quotient(1.05f64.powi(step + 1)) < quotient(1.05f64.powi(step)));
        assert!(pole.falls(0.5) && falls);
    }

    /// From a half on, wherever it is said to grow.
    #[test]
    fn divisors_that_grow() {
        let mut growing = 0;
        for (strip, half) in (1..40).flat_map(|tenths| [0.5, 0.3].map(|half| (0.05 * f64::from(tenths), half))) {
            let pole = Pole::new(strip, 1, Float::F64);
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
        let pole = Pole::new(0.26, 1, Float::F64).scaled(Double::new(0.7));
        for (terms, shift) in (3..30).flat_map(|terms| [0.0, -0.125].map(|shift| (terms, Double::new(shift)))) {
            let powers: Vec<Double> =
                (0..terms).map(|j| Double::new(2.75 / f64::from(j + 1) * (-3.0_f64).powi(j))).collect();
            let Quotient { polynomial: quotient, remainder, lost } = pole.division(&powers, shift);
            assert_eq!((quotient.len(), lost.len()), (powers.len() - 2, powers.len()));
            for p in [0.0, 0.07, 0.3] {
                let at = |powers: &[Double]| {
                    powers.iter().rev().fold(Double::ZERO, |sum, &c| sum * (shift + Double::new(p)) + c)
                };
                let divisor = pole.first.at(Double::new(p));
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
            let pole = Pole::new(strip, power, Float::F64);
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
        assert!(!Pole::new(2.0, 1, Float::F64).falls(0.5));
    }
}
