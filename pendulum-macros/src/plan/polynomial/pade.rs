//! Poles that serve better than the nearest ones.
//!
//! Of a curve whose nearest pair of poles is divided out the next ones are left. A divisor that isn't bound to the
//! nearest has two numbers free, and two of the coefficients that follow the last term of one curve, or one each of two,
//! can be made to vanish: a Chebyshev–Padé approximation (Clenshaw & Lord, *Rational approximations from Chebyshev
//! series*, 1974). At 7π/8 the poles of θ̇ move by little, and its error falls by a factor of ten: a term less for the
//! same division. θ has logarithms in place of poles. Dividing those places out gains next to nothing, but poles
//! somewhat beyond them, on the way of the cuts, make the error a hundred to a thousand times smaller: three to
//! five terms. Remez's exchange polishes the poles of a single curve (`nearest.rs`): half the error of a velocity again.

use super::Approximation;
use super::leeway::Leeway;
use super::nearest::{Corrections, polished};
use super::pole::Pole;
use crate::series::Parity;

/// The poles over which the curves take the fewest terms for an error of `limit` each, and how many they are together;
/// `nearest`, unless others save some. `None` where no number of terms is enough.
pub(crate) fn best(curves: &[Approximation], nearest: Pole, limit: f64) -> Option<(Pole, usize)> {
    let series: Vec<Series> = curves.iter().map(Series::new).collect();
    let total = |pole: Pole| series.iter().map(|series| series.terms(pole, limit)).sum::<Option<usize>>();
    let mut best = (nearest, total(nearest)?);
    for terms in 2..best.1 {
        let found = vanishing(&series, terms).and_then(|pole| Some((pole, total(pole)?)));
        best = found.filter(|found| found.1 < best.1).unwrap_or(best);
    }
    let [single] = &series[..] else { return Some(best) };
    let fewer = |&(pole, terms): &(Pole, usize)| Some((single.polished(pole, terms - 1, limit)?, terms - 1));
    std::iter::successors(Some(best), fewer).last()
}

/// A curve's Chebyshev coefficients, and those of it times p and p².
struct Series {
    parity: Parity,
    leeway: Option<Leeway>,
    powers: [Vec<f64>; 3],
}

impl Series {
    fn new(curve: &Approximation) -> Self {
        let plain: Vec<f64> = curve.series().iter().map(|c| c.hi).collect();
        let once = times_p(&plain);
        let twice = times_p(&once);
        Self { parity: curve.parity(), leeway: curve.leeway().cloned(), powers: [plain, once, twice] }
    }

    /// The coefficient of the power of p.
    fn at(&self, power: usize, index: usize) -> f64 {
        self.powers[power].get(index).copied().unwrap_or(0.0)
    }

    /// The coefficients of what is left over poles.
    fn divided(&self, pole: Pole) -> impl Fn(usize) -> f64 {
        let [constant, linear] = pole.coefficients();
        move |index| self.at(2, index) + linear * self.at(1, index) + constant * self.at(0, index)
    }

    /// The poles, from these on, over which so many terms serve.
    fn polished(&self, pole: Pole, terms: usize, limit: f64) -> Option<Pole> {
        // Of a curve of about 1, in one word.
        const FINEST: f64 = 1e-12;
        // Of what is left there will be a bound, and rounding.
        let limit = 0.9 * limit;
        let serves = |&pole: &Pole| {
            let dropped: Vec<f64> = (terms..self.powers[2].len()).map(self.divided(pole)).collect();
            Corrections::new(&dropped, terms, Some(pole), self.parity, self.leeway.as_ref()).left <= limit
        };
        if terms < 2 || limit < FINEST * self.at(0, 0).abs() {
            return None;
        }
        Some(pole)
            .filter(serves)
            .or_else(|| polished(pole, &self.powers[0], terms, self.parity, self.leeway.as_ref()).filter(serves))
    }

    /// The fewest terms that leave an error of `limit`; `None` if all do not.
    fn terms(&self, pole: Pole, limit: f64) -> Option<usize> {
        let divided = self.divided(pole);
        let most = limit * pole.least(0.5) * if self.parity == Parity::Odd { 2.0 } else { 1.0 };
        let length = self.powers[2].len();
        let mut left = 0.0;
        let last = (0..length).rev().find(|&index| {
            left += divided(index).abs();
            left > most
        });
        Some(last? + 1).filter(|&terms| terms < length)
    }
}

/// The coefficients of the series times p = (1 + x)/8, with x·Tⱼ = (Tⱼ₊₁ + Tⱼ₋₁)/2.
fn times_p(series: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; series.len() + 1];
    for (index, c) in series.iter().enumerate() {
        let half = if index == 0 { c / 8.0 } else { c / 16.0 };
        product[index] += c / 8.0;
        product[index + 1] += half;
        if index > 0 {
            product[index - 1] += half;
        }
    }
    product
}

/// The poles that make coefficients after so many terms vanish: the next two of a single curve, or the next of each of
/// two.
fn vanishing(series: &[Series], terms: usize) -> Option<Pole> {
    let rows = match series {
        [single] => [(single, terms), (single, terms + 1)],
        [first, second] => [(first, terms), (second, terms)],
        _ => return None,
    };
    let [[a, b, c], [d, e, f]] = rows.map(|(series, index)| [0, 1, 2].map(|power| series.at(power, index)));
    let determinant = a * e - b * d;
    let (constant, linear) = ((b * f - c * e) / determinant, (c * d - a * f) / determinant);
    Pole::of(constant, linear)
}

#[cfg(test)]
mod tests;
