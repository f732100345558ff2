//! Evaluation of polynomials by their powers.

use crate::program::{Builder, Id};

/// Σ cⱼxʲ by pairs, pairs of pairs and so on (Estrin 1960): the chain of dependent operations grows with the logarithm
/// of the number of terms. `names` are those of x, x², x⁴ and so on.
pub(crate) fn estrin(b: &mut Builder, x: Id, coefficients: &[Id], names: &[&'static str]) -> Id {
    let mut powers = vec![x];
    while 1 << powers.len() < coefficients.len() {
        let last = powers[powers.len() - 1];
        let square = b.mul(last, last);
        // Higher powers than have names occur in kernels that no promise needs; the search tries and drops them.
        if let Some(name) = names.get(powers.len()) {
            b.name(square, name);
        }
        powers.push(square);
    }
    sum(b, &powers, coefficients)
}

/// The same, given x, x², x⁴ and so on.
fn sum(b: &mut Builder, powers: &[Id], coefficients: &[Id]) -> Id {
    let count = coefficients.len();
    let Some(level) = (count - 1).checked_ilog2().map(|level| level as usize) else { return coefficients[0] };
    let (low, high) = coefficients.split_at(1 << level);
    // A short rest is there before the others are, and added to the half of them that waits for the other.
    if level >= 2 && 4 * high.len() <= low.len() {
        let (first, second) = low.split_at(low.len() / 2);
        let [first, second, rest] = [first, second, high].map(|part| sum(b, powers, part));
        let rest = b.mul(rest, powers[level]);
        let sum = b.add(first, rest);
        let second = b.mul(second, powers[level - 1]);
        return b.add(sum, second);
    }
    let [low, high] = [low, high].map(|part| sum(b, powers, part));
    let high = b.mul(high, powers[level]);
    b.add(low, high)
}
