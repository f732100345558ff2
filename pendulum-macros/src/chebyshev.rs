//! Chebyshev series on [−1, 1] in double-double arithmetic: sampling, and conversion to powers.

use crate::power::two_to;
use crate::program::rounding::UNDERFLOW;
use crate::supremum::worst;
use pendulum_runtime::double::Double;
use pendulum_runtime::double_trig::{cos_small, sin_small};
use std::ops::{Add, Mul};

/// The cosine of every multiple of π/(2m), from one table of a quarter wave.
pub(crate) struct CosineTable {
    m: usize,
    quarter: Vec<Double>,
}

impl CosineTable {
    /// For m sampling points.
    pub(crate) fn new(m: usize) -> Self {
        let quarter = (0..=m).map(|j| cos_pi(Double::new(j as f64) / (2.0 * m as f64))).collect();
        Self { m, quarter }
    }

    /// cos(πj/(2m)).
    pub(crate) fn get(&self, j: usize) -> Double {
        let j = j % (4 * self.m);
        let j = if j > 2 * self.m { 4 * self.m - j } else { j };
        if j > self.m { -self.quarter[2 * self.m - j] } else { self.quarter[j] }
    }

    /// The points cos(π(2i + 1)/(2m)).
    pub(crate) fn points(&self) -> impl Iterator<Item = Double> + '_ {
        (0..self.m).map(|i| self.get(2 * i + 1))
    }

    /// The coefficients of the interpolant of a function on [−1, 1], and what its values are rounded by besides the
    /// function's own.
    pub(crate) fn interpolant(&self, function: impl Fn(Double) -> Double) -> (Vec<Double>, f64) {
        self.through(&self.points().map(function).collect::<Vec<_>>())
    }

    /// The same of one with these values at the points.
    pub(crate) fn through(&self, values: &[Double]) -> (Vec<Double>, f64) {
        let rounding = self.sampling_error(worst(values.iter().map(|value| value.hi.abs())));
        (self.coefficients(values), rounding)
    }

    /// Bounds what an interpolant's values are rounded by that is at most `largest` at the points.
    ///
    /// With m points a coefficient is 2/m times m products, each wrong by 2⁻⁹⁹ of that with its cosine, added up in sums of
    /// up to m of them, each wrong by 3·2⁻¹⁰⁶ of itself: by (2⁻⁹⁸ + 3m·2⁻¹⁰⁶)·largest together, and m coefficients add up.
    ///
    /// The points xᵢ are wrong by 2⁻¹⁰⁰, which counts by the derivative there, at most m/√(1 − xᵢ²) times the largest value
    /// (Bernstein), which is at most Λ·largest, and is interpolated: the i-th value counts √(1 − xᵢ²)·|Tₘ(x)|/(m|x − xᵢ|).
    /// The sum of |Tₘ(x)/(x − xᵢ)| is at most m²: by Cauchy and Schwarz at most the root of ΣTₘ(x)²(1 − xxᵢ)/(x − xᵢ)², which
    /// is m² (Fejér 1916), times Σ1/(1 − xxᵢ), which is convex, hence largest at x = 1, Tₘ′(1)/Tₘ(1) = m². m being two at
    /// least, all that is less than (4 + Λ)m²·2⁻¹⁰⁰. Where second words underflow, a coefficient's products and what they are
    /// made of lose some 2⁻¹⁰⁷⁰ besides, less than [`UNDERFLOW`] for all of them.
    fn sampling_error(&self, largest: f64) -> f64 {
        let m = self.m as f64;
        (4.0 + lebesgue(self.m)) * m * m * two_to(-100) * largest + UNDERFLOW
    }

    /// The coefficients of the interpolant through `values` at [`Self::points`] (the zeroth one whole, not doubled).
    pub(crate) fn coefficients(&self, values: &[Double]) -> Vec<Double> {
        let coefficient = |j: usize| {
            let sum = (0..self.m).fold(Double::ZERO, |sum, i| sum + values[i] * self.get(j * (2 * i + 1)));
            sum * (if j == 0 { 1.0 } else { 2.0 }) / self.m as f64
        };
        (0..self.m).map(coefficient).collect()
    }
}

/// The part of a limit that an interpolation may be wrong by, so that what is dropped of its terms has nearly all of it.
pub(crate) const OF_INTERPOLATION: f64 = 1.0 / 512.0;

/// Bounds the error of interpolation at so many Chebyshev points, of a function that is analytic inside the ellipse
/// with foci ±1 and parameter ρ, and bounded there: 4Bρ^(1−M)/(ρ − 1) (Trefethen, *Approximation Theory and
/// Approximation Practice*, theorem 8.2, of the other Chebyshev points). At these Tₖ from k = M on is 0 or, but for its
/// sign, a Tⱼ with j < M, as it is there: what is left out and what it is taken for are Σ|aₖ| from M on each.
pub(crate) fn interpolation_error(bound: f64, rho: f64, points: usize) -> f64 {
    4.0 * bound * libm::pow(rho, 1.0 - points as f64) / (rho - 1.0)
}

/// The fewest points for which [`interpolation_error`] is at most `limit`; infinite or NaN where none are.
pub(crate) fn points_for(bound: f64, rho: f64, limit: f64) -> f64 {
    let degree = (libm::log(4.0 * bound / (rho - 1.0) / limit) / libm::log(rho)).ceil();
    if degree < 1.0 { 2.0 } else { degree + 1.0 }
}

/// An interpolation at so many Chebyshev points, and the bound of its error by the ellipse with parameter ρ.
#[derive(Clone, Copy)]
pub(crate) struct Interpolation {
    pub(crate) points: usize,
    pub(crate) rho: f64,
    pub(crate) error: f64,
}

impl Interpolation {
    /// The fewest points, at least `least`, that one of the `ellipses`, given by their bounds and parameters, proves to
    /// be enough for an error of `limit`; `None` if all take more than `most`.
    pub(crate) fn fewest(
        ellipses: impl Iterator<Item = (f64, f64)>,
        limit: f64,
        least: usize,
        most: usize,
    ) -> Option<Self> {
        let of = |(bound, rho): (f64, f64)| {
            let points = points_for(bound, rho, limit);
            (points <= most as f64).then(|| {
                let points = least.max(points as usize);
                Self { points, rho, error: interpolation_error(bound, rho, points) }
            })
        };
        ellipses.filter_map(of).min_by_key(|interpolation| interpolation.points)
    }

    /// Bounds a function by its magnitudes at the points.
    pub(crate) fn supremum(&self, samples: impl IntoIterator<Item = f64>) -> f64 {
        worst(samples) * lebesgue(self.points) + self.error
    }
}

/// Bounds what interpolation at so many Chebyshev points multiplies values with, Lebesgue's constant (Rivlin 1974).
pub(crate) fn lebesgue(points: usize) -> f64 {
    2.0 / std::f64::consts::PI * libm::log(points as f64) + 1.0
}

/// Σ aⱼ Tⱼ(x), by Clenshaw's recurrence.
pub(crate) fn value(series: &[Double], x: Double) -> Double {
    let step = |(next, after): (Double, Double), a: &Double| (*a + x * next * 2.0 - after, next);
    let (first, second) = series.iter().rev().fold((Double::ZERO, Double::ZERO), step);
    first - x * second
}

/// Bounds what [`value`] is rounded by for |x| ≤ 1: what a step is off by, less than 2⁻¹⁰⁰ of the sums Σ|aₖ|Uₖ₋ⱼ that it is
/// made of, counts as if it were aⱼ's; and Uₙ ≤ n + 1.
pub(crate) fn rounding_of_value(series: &[Double]) -> f64 {
    let of = |(j, a): (usize, &Double)| a.hi.abs() * ((j + 1) * (j + 2)) as f64;
    series.iter().enumerate().map(of).sum::<f64>() * two_to(-100)
}

/// Σ cⱼTⱼ(u), j from `first` on, by Clenshaw's recurrence.
pub(crate) fn sum(coefficients: &[f64], first: usize, u: f64) -> f64 {
    let (mut next, mut after) = (0.0, 0.0);
    let doubled = 2.0 * u;
    // By index, since unoptimised iterators would take the planner twice as long. Those before `first` are nought.
    let mut index = coefficients.len();
    while index > 0 {
        index -= 1;
        let this = coefficients[index] + doubled * next - after;
        after = next;
        next = this;
    }
    let mut order = first;
    while order > 1 {
        order -= 1;
        let this = doubled * next - after;
        after = next;
        next = this;
    }
    if first == 0 { next - u * after } else { u * next - after }
}

/// T₀(u), T₁(u), …
pub(crate) fn polynomials(terms: usize, u: f64) -> Vec<f64> {
    let mut all = Vec::with_capacity(terms);
    let (mut this, mut next) = (1.0, u);
    while all.len() < terms {
        all.push(this);
        (this, next) = (next, 2.0 * u * next - this);
    }
    all
}

/// cos πx for |x| ≤ 1.5, within 2⁻¹⁰⁰: cosine or sine on [0, π/4].
pub(crate) fn cos_pi(x: Double) -> Double {
    let x = x.abs();
    if x.hi > 0.5 {
        return -cos_pi(Double::ONE - x);
    }
    if x.hi > 0.25 {
        return sin_small(Double::PI * (Double::new(0.5) - x));
    }
    cos_small(Double::PI * x)
}

/// sin πx for |x| ≤ 1.5, of small x within 2⁻¹⁰⁰ of itself.
pub(crate) fn sin_pi(x: Double) -> Double {
    let magnitude = x.abs();
    let value =
        if magnitude.hi > 0.25 { cos_pi(Double::new(0.5) - magnitude) } else { sin_small(Double::PI * magnitude) };
    if x.hi < 0.0 { -value } else { value }
}

/// The coefficients of the derivative of Σ aⱼ Tⱼ(x): bⱼ₋₁ = bⱼ₊₁ + 2j·aⱼ, but half of that for b₀.
pub(crate) fn derivative(series: &[Double]) -> Vec<Double> {
    let mut slopes = vec![Double::ZERO; series.len() + 1];
    for j in (1..series.len()).rev() {
        slopes[j - 1] = slopes[j + 1] + series[j] * (2 * j) as f64;
    }
    slopes[0] = slopes[0] * 0.5;
    slopes.truncate(series.len().max(2) - 1);
    slopes
}

/// Bounds what [`derivative`], and a factor for all, are rounded by together for |x| ≤ 1: each of n coefficients is a sum of
/// up to n/2 of the same numbers, every part of it wrong by less than 2⁻¹⁰² of all that is added.
pub(crate) fn rounding_of_derivative(series: &[Double]) -> f64 {
    let n = series.len() as f64;
    let size: f64 = series.iter().enumerate().map(|(j, a)| 2.0 * j as f64 * a.hi.abs()).sum();
    n * n * size * two_to(-100) + n * UNDERFLOW
}

/// Coefficients in powers of τ of Σ aⱼ Tⱼ(τ), by Clenshaw's recurrence on polynomials.
pub(crate) fn to_powers(series: &[Double]) -> Vec<Double> {
    // bⱼ = aⱼ + 2τ·bⱼ₊₁ − bⱼ₊₂, the sum being a₀ + τ·b₁ − b₂.
    let degree = series.len() - 1;
    let (mut next, mut after) = (vec![Double::ZERO; degree + 1], vec![Double::ZERO; degree + 1]);
    for j in (0..=degree).rev() {
        let factor = if j == 0 { 1.0 } else { 2.0 };
        let mut current = vec![Double::ZERO; degree + 1];
        for i in 0..=degree - j {
            let shifted = if i == 0 { Double::ZERO } else { next[i - 1] * factor };
            current[i] = shifted - after[i];
        }
        current[0] = current[0] + series[j];
        after = next;
        next = current;
    }
    next
}

/// Bounds what a polynomial changes by where its Chebyshev series becomes powers of another variable by [`to_powers`],
/// [`shift`] and [`scale`], the two words of whose numbers are wrong by 7·2⁻¹⁰⁶; `reach` ≥ 1 bounds |τ| with τ = a·y + b
/// as |a|·|y| + |b|.
///
/// Without their signs the coefficients of Tⱼ add up to at most gʲ with g = reach + √(reach² + 1), those of Uⱼ, too, and
/// the coefficients in powers of y of Σ aⱼTⱼ to S = Σ|aⱼ|gʲ. What bⱼ is rounded by in `to_powers`, 4·2⁻¹⁰⁶ of its Σ|aₖ|Uₖ₋ⱼ,
/// counts as if it were aⱼ's: n times 4·2⁻¹⁰⁶S. To where a coefficient goes in `shift` are n products and n sums at most:
/// 10n; b, wrong by 22·2⁻¹⁰⁶·reach, counts by the derivative, reach times which is nS/2 at most: 11n. A power of a that is
/// wrong itself, and its product: 14n. A product and a quotient of all with the same numbers: 17. Together less than 2⁶n
/// of 2⁻¹⁰⁶S, n being two at least.
pub(crate) fn rounding_of_powers(series: &[Double], reach: f64) -> f64 {
    let growth = reach + (reach * reach + 1.0).sqrt();
    let (sum, _) = series.iter().fold((0.0, 1.0), |(sum, power), c| (sum + c.hi.abs() * power, power * growth));
    series.len() as f64 * two_to(-100) * sum
}

/// Coefficients in powers of x of Σ cⱼ (x + by)ʲ, by repeated synthetic division.
pub(crate) fn shift<T: Copy + Add<Output = T> + Mul<Output = T>>(powers: &[T], by: T) -> Vec<T> {
    let mut all = powers.to_vec();
    let shifted = &mut all[..];
    // By index, since unoptimised iterators would take the planner twice as long.
    for i in 0..powers.len() {
        let mut j = powers.len() - 1;
        let mut higher = shifted[j];
        while j > i {
            j -= 1;
            higher = shifted[j] + higher * by;
            shifted[j] = higher;
        }
    }
    all
}

/// Coefficients in powers of x of Σ cⱼ (scale·x)ʲ.
pub(crate) fn scale(mut powers: Vec<Double>, scale: Double) -> Vec<Double> {
    let mut factor = Double::ONE;
    for coefficient in &mut powers {
        *coefficient = *coefficient * factor;
        factor = factor * scale;
    }
    powers
}

#[cfg(test)]
mod tests;
