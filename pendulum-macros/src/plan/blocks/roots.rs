//! The odd parts of blocks: their roots, and what division by them leaves.

use super::Block;
use std::ops::{Add, Mul};

/// Divides powers of y, lowest first, by y² − α for each root α of their odd part, given in this order: the last to be
/// evaluated comes first.
pub(super) fn factored<T: Copy + Add<Output = T> + Mul<Output = T>>(powers: &[T], alphas: &[T]) -> Block<T> {
    let mut head = powers.to_vec();
    let mut factors: Vec<(T, T)> = alphas.iter().map(|&alpha| (alpha, divide(&mut head, alpha))).collect();
    factors.reverse();
    Block { head, factors }
}

/// Divides powers of y by y² − α; the constant of the remainder, whose other coefficient is nought where α is a root of
/// the odd part.
fn divide<T: Copy + Add<Output = T> + Mul<Output = T>>(powers: &mut Vec<T>, alpha: T) -> T {
    for i in (2..powers.len()).rev() {
        powers[i - 2] = powers[i - 2] + alpha * powers[i];
    }
    let remainder = powers[0];
    powers.drain(..2);
    remainder
}

/// The roots of the odd part of a block, in w, the smallest first; `None` unless all are real.
pub(super) fn roots(powers: &[f64]) -> Option<Vec<f64>> {
    if powers.len() < 4 {
        return Some(Vec::new());
    }
    let odd: Vec<f64> = powers.iter().skip(1).step_by(2).copied().collect();
    let mut roots = real_roots(&odd)?;
    roots.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    Some(roots)
}

/// All roots of a polynomial, lowest power first, between those of its derivative; `None` unless all are real.
fn real_roots(powers: &[f64]) -> Option<Vec<f64>> {
    let (&leading, lower) = powers.split_last()?;
    if let [constant] = lower {
        let root = -constant / leading;
        return root.is_finite().then(|| vec![root]);
    }
    let derivative: Vec<f64> = powers.iter().enumerate().skip(1).map(|(power, c)| power as f64 * c).collect();
    // Cauchy's bound.
    let bound = 1.0 + lower.iter().map(|c| (c / leading).abs()).fold(0.0, f64::max);
    let mut ends = real_roots(&derivative)?;
    ends.insert(0, -bound);
    ends.push(bound);
    ends.windows(2).map(|ends| root_between(powers, ends[0], ends[1])).collect()
}

/// By index, since unoptimised iterators would take the planner three times as long.
fn value(powers: &[f64], x: f64) -> f64 {
    let mut sum = 0.0;
    let mut index = powers.len();
    while index > 0 {
        index -= 1;
        sum = sum * x + powers[index];
    }
    sum
}

/// The root between two points where the signs differ, by the Illinois variant of the false position.
fn root_between(powers: &[f64], mut a: f64, mut b: f64) -> Option<f64> {
    let (mut at_a, mut at_b) = (value(powers, a), value(powers, b));
    if !(at_a.is_finite() && at_b.is_finite()) || at_a * at_b > 0.0 {
        return None;
    }
    for _ in 0..100 {
        let x = b - at_b * (b - a) / (at_b - at_a);
        let x = if x.is_finite() { x } else { 0.5 * (a + b) };
        let at_x = value(powers, x);
        if at_x == 0.0 || (x - b).abs() <= 1e-13 * x.abs() {
            return Some(x);
        }
        if at_x * at_b < 0.0 {
            (a, at_a) = (b, at_b);
        } else {
            at_a *= 0.5;
        }
        (b, at_b) = (x, at_x);
    }
    Some(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_found_and_missed() {
        let roots = real_roots(&[-6.0, 11.0, -6.0, 1.0]).unwrap();
        for (found, expected) in roots.iter().zip([1.0, 2.0, 3.0]) {
            assert!((found - expected).abs() < 1e-12, "{roots:?}");
        }
        assert_eq!(real_roots(&[1.0, 0.0, 1.0]), None);
    }
}
