//! Poles that serve better than the nearest ones.
//!
//! Of a curve whose nearest pair of poles is divided out the next ones are left. A divisor that isn't bound to the
//! nearest has two numbers free, and two of the coefficients that follow the last term of one curve, or one each of two,
//! can be made to vanish: a Chebyshev–Padé approximation (Clenshaw & Lord, *Rational approximations from Chebyshev
//! series*, 1974). At 7π/8 the poles of θ̇ move by little, and its error falls by a factor of ten: a term less for the
//! same division. θ has logarithms in place of poles. Dividing those places out gains next to nothing, but poles
//! somewhat beyond them, on the way of the cuts, make the error a hundred to a thousand times smaller: three to
//! five terms. Remez's exchange polishes the poles of a single curve (`nearest.rs`): half the error of a velocity again.
//!
//! A second pair takes four operations, and makes the next four coefficients of a curve vanish, or two of each of two. It
//! saves a θ̇ the next row of its poles, and θ as many terms again as the first: next to the top, where each term gains
//! little, and in full precision that is worth it.

use super::Approximation;
use super::leeway::Leeway;
use super::nearest::{Corrections, polished, solved};
use super::pole::Pole;
use super::weight::Weight;
use crate::parse::Float;
use crate::series::Parity;

/// The poles over which the curves take the fewest terms for an error of `limit` each, and how many they are together;
/// `nearest`, unless others save some. `None` where no number of terms is enough.
pub(crate) fn best(curves: &[Approximation], nearest: Pole, limit: f64) -> Option<(Pole, usize)> {
    let series: Vec<Series> = curves.iter().map(Series::new).collect();
    let total = |pole: Pole| terms_of_all(&series, pole, limit);
    let mut best = (nearest, total(nearest)?);
    for terms in 2..best.1 {
        let found = vanishing(&series, terms, nearest.float()).and_then(|pole| Some((pole, total(pole)?)));
        best = found.filter(|found| found.1 < best.1).unwrap_or(best);
    }
    let [single] = &series[..] else { return Some(best) };
    let fewer = |&(pole, terms): &(Pole, usize)| Some((single.polished(pole, terms - 1, limit)?, terms - 1));
    std::iter::successors(Some(best), fewer).last()
}

/// How many terms the curves take together for an error of `limit` each.
fn terms_of_all(all: &[Series], pole: Pole, limit: f64) -> Option<usize> {
    all.iter().map(|series| series.terms(pole, limit)).sum()
}

/// Terms that a second pair had better save, each of which takes an operation and a half.
const WORTH: usize = 2;

/// Two pairs of poles over which the curves take fewer terms for an error of `limit` each than over `first`, from which
/// they are looked for, and enough to be worth it.
pub(crate) fn two(curves: &[Approximation], first: Pole, limit: f64) -> Option<Pole> {
    let series: Vec<Series> = curves.iter().map(Series::new).collect();
    let total = |pole: Pole| terms_of_all(&series, pole, limit);
    let mut most = total(first)?.checked_sub(WORTH)?;
    let mut best = None;
    for terms in 2..=most / series.len() {
        let Some(pole) = vanishing_two(&series, terms, first) else { continue };
        if let [single] = &series[..]
            && single.serves(pole, terms, limit)
        {
            return Some(pole);
        }
        if let Some(found) = total(pole).filter(|&found| found <= most) {
            (best, most) = (Some(pole), found - 1);
        }
    }
    best
}

/// A curve's Chebyshev coefficients, and those of it times powers of p.
struct Series {
    parity: Parity,
    leeway: Option<Leeway>,
    powers: [Vec<f64>; 5],
}

impl Series {
    fn new(curve: &Approximation) -> Self {
        let plain: Vec<f64> = curve.series().iter().map(|c| c.hi).collect();
        let mut powers = [plain, Vec::new(), Vec::new(), Vec::new(), Vec::new()];
        for power in 1..powers.len() {
            powers[power] = times_p(&powers[power - 1]);
        }
        Self { parity: curve.parity(), leeway: curve.leeway().cloned(), powers }
    }

    fn weight(&self, pole: Option<Pole>) -> Weight<'_> {
        Weight { pole, parity: self.parity, leeway: self.leeway.as_ref() }
    }

    /// The coefficient of the power of p.
    fn at(&self, power: usize, index: usize) -> f64 {
        self.powers[power].get(index).copied().unwrap_or(0.0)
    }

    /// The coefficients of what is left over poles.
    fn divided(&self, pole: Pole) -> impl Fn(usize) -> f64 {
        let factors = pole.powers();
        move |index| factors.iter().enumerate().rev().map(|(power, factor)| factor * self.at(power, index)).sum()
    }

    /// How many there may be.
    fn length(&self, pole: Pole) -> usize {
        self.powers[2 * pole.count()].len()
    }

    /// The poles, from these on, over which so many terms serve.
    fn polished(&self, pole: Pole, terms: usize, limit: f64) -> Option<Pole> {
        if !self.can_be_polished(terms, limit) {
            return None;
        }
        if self.serves(pole, terms, limit) {
            return Some(pole);
        }
        let polished = polished(pole, &self.powers[0], terms, self.weight(None));
        polished.filter(|&pole| self.serves(pole, terms, limit))
    }

    /// Whether one word is enough to make so many terms the best there are for an error.
    fn can_be_polished(&self, terms: usize, limit: f64) -> bool {
        // Of a curve of about 1.
        const FINEST: f64 = 1e-12;
        terms >= 2 && limit >= FINEST * self.at(0, 0).abs()
    }

    /// Whether so many terms over these poles are as near as that, where one word can tell.
    fn serves(&self, pole: Pole, terms: usize, limit: f64) -> bool {
        if !self.can_be_polished(terms, limit) {
            return false;
        }
        let dropped: Vec<f64> = (terms..self.length(pole)).map(self.divided(pole)).collect();
        // Of what is left there will be a bound, and rounding.
        Corrections::new(&dropped, terms, self.weight(Some(pole))).left <= 0.9 * limit
    }

    /// The fewest terms that leave an error of `limit`; `None` if all do not.
    fn terms(&self, pole: Pole, limit: f64) -> Option<usize> {
        let divided = self.divided(pole);
        let most = limit * pole.least(0.5) * if self.parity == Parity::Odd { 2.0 } else { 1.0 };
        let length = self.length(pole);
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
fn vanishing(series: &[Series], terms: usize, float: Float) -> Option<Pole> {
    let rows = match series {
        [single] => [(single, terms), (single, terms + 1)],
        [first, second] => [(first, terms), (second, terms)],
        _ => return None,
    };
    let [[a, b, c], [d, e, f]] = rows.map(|(series, index)| [0, 1, 2].map(|power| series.at(power, index)));
    let determinant = a * e - b * d;
    let (constant, linear) = ((b * f - c * e) / determinant, (c * d - a * f) / determinant);
    Pole::of([constant, linear], float)
}

/// Two pairs that make the next four coefficients of a single curve vanish, or the next two of each of two.
fn vanishing_two(series: &[Series], terms: usize, near: Pole) -> Option<Pole> {
    let indices = terms..terms + 4 / series.len();
    let row = |(series, index): (&Series, usize)| {
        (0..4).map(|power| series.at(power, index)).chain([-series.at(4, index)]).collect::<Vec<f64>>()
    };
    let rows = series.iter().flat_map(|series| indices.clone().map(move |index| (series, index))).map(row).collect();
    let quartic: [f64; 4] = solved(rows)?.try_into().ok()?;
    Pole::of_two(quadratics(quartic, near.coefficients())?, near.float())
}

/// The quadratic factors of p⁴ + c₃p³ + c₂p² + c₁p + c₀, each given as what p is multiplied with after its constant, from
/// one that is near (Bairstow's method).
fn quadratics([c0, c1, c2, c3]: [f64; 4], near: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    const STEPS: usize = 40;
    let [mut constant, mut linear] = near;
    for _ in 0..STEPS {
        // The quotient p² + bp + c, and the remainder rp + s.
        let b = c3 - linear;
        let c = c2 - constant - linear * b;
        let (r, s) = (c1 - linear * c - constant * b, c0 - constant * c);
        // Their derivatives, by the linear coefficient and by the constant.
        let slope = linear - b;
        let [r_linear, s_linear] = [constant - c - linear * slope, -constant * slope];
        let [r_constant, s_constant] = [slope, constant - c];
        let determinant = r_linear * s_constant - r_constant * s_linear;
        let [by_linear, by_constant] =
            [(r * s_constant - s * r_constant) / determinant, (s * r_linear - r * s_linear) / determinant];
        linear -= by_linear;
        constant -= by_constant;
        if by_linear.abs() + by_constant.abs() <= 1e-9 * (linear.abs() + constant.abs()) {
            let b = c3 - linear;
            return Some([[constant, linear], [c2 - constant - linear * b, b]]);
        }
    }
    None
}

#[cfg(test)]
mod tests;
