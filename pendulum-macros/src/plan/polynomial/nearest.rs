//! Polynomials of so many terms, over poles or not, that are nearest to a curve where it counts: over the poles, times an
//! odd curve's phase, and over what the phase leaves at each of its values.
//!
//! What dropping Chebyshev coefficients leaves out is almost level on [−1, 1], hence almost the least there is; but over
//! poles it is largest where these are near, and times the phase of an odd curve largest at one end and nothing at the
//! other. Remez's exchange makes it level with these weights (Cheney, *Introduction to Approximation Theory*, ch. 3 and
//! 5): it halves the error of a velocity, and near the top makes a third of it. It needn't be exact, since whatever it
//! gives is bounded as any other series is.

use super::interval::p;
use super::pole::Pole;
use super::weight::Weight;
use crate::chebyshev::{polynomials, sum};
use crate::series::Parity;
use crate::supremum::larger;
use std::f64::consts::PI;

/// Points looked at between two extrema.
const CELLS: usize = 8;

/// Exchanges at most, and what is level enough to do without another.
const ROUNDS: usize = 5;
const LEVEL: f64 = 1.02;

/// What is added to a series of so many terms for those that it lacks.
pub(super) struct Corrections {
    pub(super) of_terms: Vec<f64>,
    /// The largest error that is left, about.
    pub(super) left: f64,
}

impl Corrections {
    /// Of the first `terms` coefficients of a Chebyshev series of which the others, `dropped`, are left out.
    pub(super) fn new(dropped: &[f64], terms: usize, weight: Weight) -> Self {
        let points = Points::new(terms + 1, |u| weight.at(u));
        let left: Vec<f64> = points.cosines.iter().map(|&u| sum(dropped, terms, u)).collect();
        let levelled = |reference: &[usize]| {
            let row = |(index, &point): (usize, &usize)| {
                let level = sign(index) / points.weights[point];
                polynomials(terms, points.cosines[point]).into_iter().chain([level, left[point]]).collect()
            };
            let mut of_terms = solved(reference.iter().enumerate().map(row).collect())?;
            of_terms.truncate(terms);
            let error = |(left, &u): (&f64, &f64)| left - sum(&of_terms, 0, u);
            let errors = left.iter().zip(&points.cosines).map(error).collect();
            Some((of_terms, errors))
        };
        let none = (vec![0.0; terms], largest(&points.weighted(&left)));
        let (of_terms, left) =
            points.exchange(terms + 1, weight.parity, levelled).filter(|best| best.1 < none.1).unwrap_or(none);
        Self { of_terms, left }
    }
}

/// The poles over which so many terms come nearest to a curve, given by its series, or by that of an odd one over its
/// phase; looked for from `pole` on. Of a single pair the equations are linear but for the product of the error, which
/// is small, with its coefficients.
pub(super) fn polished(pole: Pole, series: &[f64], terms: usize, weight: Weight) -> Option<Pole> {
    let count = terms + 3;
    let points = Points::new(count, |u| weight.at(u));
    let values: Vec<f64> = points.cosines.iter().map(|&u| sum(series, 0, u)).collect();
    let mut divisor = pole.coefficients();
    let levelled = |reference: &[usize]| {
        let at = |[constant, linear]: [f64; 2], u: f64| constant + p(u) * (linear + p(u));
        let row = |(index, &point): (usize, &usize)| {
            let (u, value) = (points.cosines[point], values[point]);
            let level = sign(index) * at(divisor, u) / points.weights[point];
            polynomials(terms, u).into_iter().chain([-value, -p(u) * value, level, p(u) * p(u) * value]).collect()
        };
        let mut numerator = solved(reference.iter().enumerate().map(row).collect())?;
        let free = numerator.split_off(terms);
        divisor = [free[0], free[1]];
        let found = Pole::of(divisor, pole.float())?;
        let error = |(value, &u): (&f64, &f64)| sum(&numerator, 0, u) / at(divisor, u) - value;
        let errors = values.iter().zip(&points.cosines).map(error).collect();
        Some((found, errors))
    };
    points.exchange(count, weight.parity, levelled).map(|(pole, _)| pole)
}

fn sign(index: usize) -> f64 {
    if index.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// Where errors are looked at, and what they count there.
struct Points {
    cosines: Vec<f64>,
    weights: Vec<f64>,
}

impl Points {
    /// Enough for so many extrema.
    fn new(extrema: usize, weight: impl Fn(f64) -> f64) -> Self {
        let cells = CELLS * extrema;
        let cosines: Vec<f64> = (0..=cells).map(|cell| libm::cos(PI * cell as f64 / cells as f64)).collect();
        let weights = cosines.iter().map(|&u| weight(u)).collect();
        Self { cosines, weights }
    }

    /// The best of what `levelled` makes, with the errors that it leaves, at so many points, and the largest of these.
    fn exchange<T>(
        &self,
        count: usize,
        parity: Parity,
        mut levelled: impl FnMut(&[usize]) -> Option<(T, Vec<f64>)>,
    ) -> Option<(T, f64)> {
        let mut best: Option<(T, f64)> = None;
        let mut reference = self.extrema(count, parity);
        for _ in 0..ROUNDS {
            let Some((found, errors)) = levelled(&reference) else { break };
            let weighted = self.weighted(&errors);
            let largest = largest(&weighted);
            if best.as_ref().is_none_or(|(_, least)| largest < *least) {
                best = Some((found, largest));
            }
            let Some(next) = exchanged(&reference, &weighted, largest) else { break };
            reference = next;
        }
        best
    }

    /// About those of Tₙ, or those on one side of the odd T₂ₙ₊₁ of the phase.
    fn extrema(&self, count: usize, parity: Parity) -> Vec<usize> {
        let whole = 2 * (count - 1) + usize::from(parity == Parity::Odd);
        (0..count).map(|index| 2 * index * (self.cosines.len() - 1) / whole).collect()
    }

    /// What errors count. By index here and below, since unoptimised iterators would take the planner twice as
    /// long.
    fn weighted(&self, errors: &[f64]) -> Vec<f64> {
        let mut weighted = errors.to_vec();
        let mut point = 0;
        while point < weighted.len() {
            weighted[point] *= self.weights[point];
            point += 1;
        }
        weighted
    }
}

fn largest(weighted: &[f64]) -> f64 {
    let (mut most, mut point) = (0.0, 0);
    while point < weighted.len() {
        most = larger(most, weighted[point].abs());
        point += 1;
    }
    most
}

/// As many points at which the weighted errors are extreme and alternate, the largest among them; `None` where that
/// is no gain: where they are level at the points that there are, or don't alternate so often.
fn exchanged(reference: &[usize], weighted: &[f64], largest: f64) -> Option<Vec<usize>> {
    let size = |point: usize| weighted[point].abs();
    let least = reference.iter().map(|&point| size(point)).fold(f64::INFINITY, f64::min);
    if largest <= LEVEL * least {
        return None;
    }
    let mut extrema: Vec<usize> = Vec::new();
    let mut start = 0;
    while start < weighted.len() {
        // The largest of those of the same sign.
        let (mut last, mut point) = (start, start + 1);
        while point < weighted.len() && (weighted[last] < 0.0) == (weighted[point] < 0.0) {
            if size(point) > size(last) {
                last = point;
            }
            point += 1;
        }
        extrema.push(last);
        start = point;
    }
    while extrema.len() > reference.len() {
        let (&first, &last) = (extrema.first()?, extrema.last()?);
        extrema.remove(if size(first) < size(last) { 0 } else { extrema.len() - 1 });
    }
    (extrema.len() == reference.len()).then_some(extrema)
}

/// What is left of an equation without its first unknown, by one that has it. By index, since unoptimised iterators would
/// take the planner three times as long.
fn subtract(row: &mut [f64], pivot: &[f64]) {
    let factor = row[0] / pivot[0];
    let mut index = 0;
    while index < row.len() {
        row[index] -= factor * pivot[index];
        index += 1;
    }
}

/// The solution of linear equations, each given with its right-hand side last, by elimination; `None` if there isn't one.
pub(super) fn solved(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let count = rows.len();
    for column in 0..count {
        let (done, below) = rows.split_at_mut(column + 1);
        let pivot = &mut done[column];
        for row in &mut *below {
            if row[column].abs() >= pivot[column].abs() {
                std::mem::swap(row, pivot);
            }
        }
        for row in below {
            subtract(&mut row[column..], &pivot[column..]);
        }
    }
    let mut solution = vec![0.0; count];
    for index in (0..count).rev() {
        let known: f64 = (index + 1..count).map(|column| rows[index][column] * solution[column]).sum();
        solution[index] = (rows[index][count] - known) / rows[index][index];
    }
    solution.iter().all(|x| x.is_finite()).then_some(solution)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::Float;

    #[test]
    fn linear_equations() {
        // The first pivot is nought.
        let rows = vec![vec![0.0, 2.0, 1.0, 7.0], vec![1.0, 1.0, 1.0, 6.0], vec![2.0, -1.0, 3.0, 9.0]];
        let found = solved(rows).unwrap();
        assert!(found.iter().zip([1.0, 2.0, 3.0]).all(|(x, known)| (x - known).abs() < 1e-14), "{found:?}");
        assert_eq!(solved(vec![vec![1.0, 2.0, 3.0], vec![2.0, 4.0, 5.0]]), None);
    }

    /// The largest magnitude, and the extrema between the zeros.
    fn extrema(errors: impl Iterator<Item = f64>) -> (f64, Vec<f64>) {
        let mut extrema: Vec<f64> = Vec::new();
        for error in errors {
            match extrema.last_mut() {
                Some(last) if *last * error >= 0.0 => *last = if error.abs() > last.abs() { error } else { *last },
                _ => extrema.push(error),
            }
        }
        (extrema.iter().fold(0.0, |most: f64, error| most.max(error.abs())), extrema)
    }

    /// How many are within a twentieth of the largest: as many of alternating signs as there are numbers free, and one
    /// more, and nothing is nearer by more than that (de la Vallée Poussin).
    fn level((largest, extrema): &(f64, Vec<f64>)) -> usize {
        extrema.iter().filter(|error| error.abs() > 0.95 * largest).count()
    }

    fn plain(parity: Parity) -> Weight<'static> {
        Weight { pole: None, parity, leeway: None }
    }

    fn at(i: u32) -> f64 {
        (PI * f64::from(i) / 5000.0).cos()
    }

    #[test]
    fn level_errors() {
        let pole = Pole::of([0.03, -0.3], Float::F64);
        let dropped = [1.0, -0.2, 0.05];
        let (even, odd) = (Parity::Even, Parity::Odd);
        for (pole, parity, gain) in [(None, even, 1.1), (pole, even, 1.3), (None, odd, 1.7), (pole, odd, 1.9)] {
            let found = Corrections::new(&dropped, 5, Weight { pole, ..plain(parity) });
            let phase = |u: f64| if parity == Parity::Odd { p(u).sqrt() } else { 1.0 };
            let weight = |u: f64| phase(u) / pole.map_or(1.0, |pole| pole.least_between(p(u), p(u)));
            let weighted = |of_terms: &[f64]| {
                extrema((0..=5000).map(|i| (sum(&dropped, 5, at(i)) - sum(of_terms, 0, at(i))) * weight(at(i))))
            };
            let (before, after) = (weighted(&[0.0; 5]), weighted(&found.of_terms));
            assert!(before.0 > gain * after.0, "{parity:?}: {before:?} {after:?}");
            assert!((0.97..1.001).contains(&(found.left / after.0)), "{parity:?}: {} {after:?}", found.left);
            assert!(level(&after) >= 6, "{parity:?}: {after:?}");
        }
    }

    /// Of 1/((p − 0.3)² + 0.02) itself the poles are found; of a curve with logarithms those that make the error level.
    #[test]
    fn polished_poles() {
        let points = |function: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let table = crate::chebyshev::CosineTable::new(60);
            let value = |u: pendulum_runtime::double::Double| pendulum_runtime::double::Double::new(function(p(u.hi)));
            table.coefficients(&table.points().map(value).collect::<Vec<_>>()).iter().map(|c| c.hi).collect()
        };
        let near = Pole::of([0.12, -0.58], Float::F64).unwrap();
        let found =
            polished(near, &points(&|p| (1.0 + p) / ((p - 0.3).powi(2) + 0.02)), 3, plain(Parity::Even)).unwrap();
        let [constant, linear] = found.coefficients();
        assert!((constant - 0.11).abs() < 1e-6 && (linear + 0.6).abs() < 1e-6, "{found:?}");
        for parity in [Parity::Even, Parity::Odd] {
            let series = points(&|p| ((p - 0.27).powi(2) + 0.03).ln());
            let pole = polished(near, &series, 4, plain(parity)).unwrap();
            let [constant, linear] = pole.coefficients();
            let divided = points(&|p| ((p - 0.27).powi(2) + 0.03).ln() * (constant + p * (linear + p)));
            let found = Corrections::new(&divided[4..], 4, Weight { pole: Some(pole), ..plain(parity) });
            let error = |i: u32| {
                let (u, weight) = (at(i), plain(parity).at(at(i)));
                (sum(&divided[4..], 4, u) - sum(&found.of_terms, 0, u)) * weight / (constant + p(u) * (linear + p(u)))
            };
            let errors = extrema((0..=5000).map(error));
            assert!(level(&errors) >= 7, "{parity:?}: {errors:?}");
        }
    }
}
