//! The supremum of what dropping coefficients leaves out. Their magnitudes add up to half as much again, where poles have
//! made those vanish that were by far the largest.

use super::interval::{CELLS, angle, p};
use super::weight::Weight;
use crate::chebyshev::sum;
use crate::power::power;
use crate::program::rounding::INFLATION_OF_SUMS;
use crate::supremum::{larger, worst};

/// Bounds |Σ cⱼTⱼ(u)|, j from `first` on, times its weight, for |u| ≤ 1, where p = (1 + u)/8, the square of a phase or its
/// image, is up to `farthest`; less what a leeway spares there, if there is one.
///
/// With u = cos φ the sum is one of cos jφ: between two angles it exceeds the larger of its values by at most h²/8 times
/// its largest second derivative there, h being their distance. That is at most Σ j²|cⱼ|, which will do unless the sum is
/// small where this cell is, and large elsewhere, as over poles near one end; and exceeds the larger of its values at
/// those angles by h²/8 times the largest fourth derivative, of which the same holds: over double poles the sum may be
/// thousands of times as large elsewhere.
pub(super) fn supremum(coefficients: &[f64], first: usize, weight: Weight, farthest: f64) -> f64 {
    let eighth = power(angle(1), 2) / 8.0;
    // Σ j²cⱼ cos jφ, and so on, and the sums of their terms' magnitudes.
    let derivative = |order: usize| {
        let terms = coefficients.iter().zip(first..).map(|(c, j)| power(j as f64, 2 * order as i32) * c);
        let terms: Vec<f64> = terms.collect();
        (terms.iter().map(|c| c.abs()).sum::<f64>(), terms)
    };
    let derivatives: Vec<(f64, Vec<f64>)> = (0..=DEEPEST + 1).map(derivative).collect();
    let rounding = |order: usize| ROUNDING * (derivatives[order].0 + derivatives[order + 1].0);
    let magnitude = |order: usize, u: f64| sum(&derivatives[order].1, first, u).abs() + rounding(order);
    let at = |cell: u32| {
        let u = libm::cos(angle(cell));
        (p(u), magnitude(0, u))
    };
    let at_ends =
        |order: usize, cell: usize| worst([cell, cell + 1].map(|cell| magnitude(order, libm::cos(angle(cell as u32)))));
    let bent = |cell: usize, depth: usize| {
        let largest = |higher: f64, order: usize| derivatives[order].0.min(at_ends(order, cell) + eighth * higher);
        (1..=depth).rev().fold(derivatives[depth + 1].0, largest)
    };
    let points: Vec<(f64, f64)> = (0..=CELLS).map(at).collect();
    // What an error in a cell counts, with the rounding of that.
    let counts = |pair: &[(f64, f64)]| weight.between(pair[1].0, pair[0].0) * INFLATION_OF_SUMS;
    let counts: Vec<f64> = points.windows(2).map(counts).collect();
    // In a cell where the second derivative is at most so much.
    let error = |cell: usize, second: f64| {
        let sum = larger(points[cell].1, points[cell + 1].1) + eighth * second;
        let spared = weight.leeway.map_or(0.0, |leeway| leeway.spared(cell));
        sum * counts[cell] - spared
    };
    // Those that are met come last.
    let first_met = points[1..].iter().take_while(|(p, _)| *p > farthest).count();
    let met = first_met..counts.len();
    let close = CLOSE * worst(met.clone().map(|cell| error(cell, 0.0)));
    let bound = |cell: usize| {
        let (mut depth, mut bound) = (0, error(cell, derivatives[1].0));
        while bound > close && depth < DEEPEST {
            depth += 1;
            bound = error(cell, bent(cell, depth));
        }
        bound
    };
    worst(met.map(bound))
}

/// Bounds |Σ cⱼTⱼ(u)| beyond the end, where u = cosh η, η from 0 to `ellipse`, and Tⱼ = cosh jη: by its values at some η
/// and, as above, its second derivative, Σ j²cⱼ cosh jη, and the fourth.
pub(super) fn supremum_beyond(coefficients: &[f64], first: usize, ellipse: f64) -> f64 {
    let degrees = || (first..).map(|j| j as f64);
    let highest = (first + coefficients.len()) as f64;
    // The highest term bends little within each.
    let cells = (2.0 * highest * ellipse).ceil().clamp(1.0, MOST_BEYOND) as u32;
    let step = ellipse / f64::from(cells);
    let eighth = step * step / 8.0;
    let second: Vec<f64> = coefficients.iter().zip(degrees()).map(|(c, j)| j * j * c).collect();
    let magnitude = |coefficients: &[f64], order: i32| -> f64 {
        let terms = coefficients.iter().zip(degrees());
        terms.map(|(c, j)| power(j, order) * c.abs() * at_most_cosh(j * ellipse)).sum()
    };
    let fourth = magnitude(&second, 2);
    let sums = [coefficients, &second].map(|all| (all, ROUNDING * (magnitude(all, 0) + magnitude(all, 2))));
    let at = |index: u32| {
        let u = libm::cosh(step * f64::from(index));
        sums.map(|(all, rounding)| sum(all, first, u).abs() + rounding)
    };
    let points: Vec<[f64; 2]> = (0..=cells).map(at).collect();
    let largest = |order: usize, pair: &[[f64; 2]]| worst([pair[0][order], pair[1][order]]);
    let bounds = points.windows(2).map(|pair| largest(0, pair) + eighth * (largest(1, pair) + eighth * fourth));
    worst(bounds) * INFLATION_OF_SUMS
}

/// What a sum is rounded by, of Σ(1 + j²)|cⱼTⱼ|: as in [`crate::chebyshev::rounding_of_value`], where a step is off by five
/// halves of a unit of the sums it is made of in one word, and (j + 1)(j + 2) ≤ 3(1 + j²); and coefficients are rounded.
const ROUNDING: f64 = 5.0 * f64::EPSILON;

/// Parts at most that what is beyond the end is cut into.
const MOST_BEYOND: f64 = 16.0;

/// Bounds of so many times what the sum is at the angles need be no nearer.
const CLOSE: f64 = 1.01;

/// So many even derivatives, from the second on, are sampled at the angles; of the next the sum of magnitudes is taken.
const DEEPEST: usize = 3;

/// cosh x, or hardly more: 1 + x²/2 + x⁴/24·cosh x where x is small, as nearly always.
pub(super) fn at_most_cosh(x: f64) -> f64 {
    if x < 0.1 { 1.0 + 0.5005 * x * x } else { libm::cosh(x) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::Float;
    use crate::plan::polynomial::Pole;
    use crate::plan::polynomial::nearest::Corrections;
    use crate::series::Parity;
    use pendulum_runtime::double::Double;
    use std::f64::consts::PI;

    /// Never below what is found densely, and hardly above.
    #[test]
    fn suprema() {
        let poles = [None, Some(Pole::new(0.26, 1, Float::F64)), Some(Pole::new(0.1, 2, Float::F64))];
        for (pole, parity) in poles.into_iter().flat_map(|pole| [(pole, Parity::Even), (pole, Parity::Odd)]) {
            for (coefficients, first) in [(vec![1.0], 2), (vec![1.0, 1.0, -0.5], 6), (vec![0.1, -1.0, 0.7, 0.3], 20)] {
                let at = |i: u32| {
                    let u = (f64::from(i) * PI / 1e5).cos();
                    let phase = if parity == Parity::Odd { ((1.0 + u) / 8.0).max(0.0).sqrt() } else { 1.0 };
                    let over = pole.map_or(1.0, |pole| pole.at(Double::new(u)).hi);
                    (sum(&coefficients, first, u) * phase / over).abs()
                };
                let seen = (0..=100_000).map(at).fold(0.0, f64::max);
                let bound = supremum(&coefficients, first, Weight { pole, parity, leeway: None }, 0.25);
                assert!(seen <= bound && bound < 1.12 * seen, "{pole:?} {first}: {bound} for {seen}");
            }
        }
    }

    /// T₁₉₅ − T₁₈₉ = −2 sin 192φ·sin 3φ vanishes at all angles that are looked at.
    #[test]
    fn what_lies_between_angles() {
        let mut coefficients = vec![0.0; 7];
        (coefficients[0], coefficients[6]) = (-1.0, 1.0);
        for reach in [0.5, 0.3] {
            let at = |i: u32| (f64::from(i) * PI / 1e5).cos();
            let met = (0..=100_000).map(at).filter(|&u| p(u) <= reach * reach);
            let seen = met.map(|u| sum(&coefficients, 189, u).abs()).fold(0.0, f64::max);
            let bound =
                supremum(&coefficients, 189, Weight { pole: None, parity: Parity::Even, leeway: None }, reach * reach);
            assert!(seen > 1.9 && seen <= bound && bound < 1.6 * seen, "{reach}: {bound} for {seen}");
        }
    }

    /// Beyond the end, too, where terms grow and cancel as before: of the last there is a summit in between.
    #[test]
    fn suprema_beyond_the_end() {
        let level: Vec<f64> = (0..20).map(|j: i32| (-0.7_f64).powi(j)).collect();
        let mut summit = vec![0.0; 9];
        (summit[0], summit[8]) = (1.0, -0.02);
        let sums = [(vec![1.0], 2), (vec![1.0, 1.0, -0.5], 6), (vec![0.1, -1.0, 0.8], 20), (level, 3), (summit, 2)];
        for (coefficients, first) in sums {
            for ellipse in [0.0, 1e-6, 1e-3, 0.1, 0.3] {
                let at = |i: u32| sum(&coefficients, first, libm::cosh(ellipse * f64::from(i) / 1e4)).abs();
                let seen = (0..=10_000).map(at).fold(0.0, f64::max);
                let bound = supremum_beyond(&coefficients, first, ellipse);
                assert!(seen <= bound && bound < 1.1 * seen, "{first} {ellipse}: {bound} for {seen}");
            }
        }
    }

    /// Where a sum is level over poles next to one end, it is many times as large at the other; over double poles,
    /// thousands of times.
    #[test]
    fn suprema_over_near_poles() {
        let dropped = [1.0, -0.3];
        let poles = [(0.04, 1, 20), (0.04, 2, 20), (0.033, 2, 33)];
        for ((strip, power, terms), parity) in
            poles.into_iter().flat_map(|pole| [(pole, Parity::Even), (pole, Parity::Odd)])
        {
            let pole = Some(Pole::new(strip, power, Float::F64));
            let weight = Weight { pole, parity, leeway: None };
            let corrections = Corrections::new(&dropped, terms, weight).of_terms;
            let left: Vec<f64> = corrections.iter().map(|correction| -correction).chain(dropped).collect();
            let at = |i: u32| {
                let u = (f64::from(i) * PI / 1e5).cos();
                let phase = if parity == Parity::Odd { p(u).sqrt() } else { 1.0 };
                (sum(&left, 0, u) * phase / pole.map_or(1.0, |pole| pole.least_between(p(u), p(u)))).abs()
            };
            let seen = (0..=100_000).map(at).fold(0.0, f64::max);
            let bound = supremum(&left, 0, weight, 0.25);
            assert!(seen <= bound && bound < 1.25 * seen, "{pole:?} {parity:?}: {bound} for {seen}");
        }
    }
}
