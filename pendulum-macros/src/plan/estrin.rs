//! Evaluation of polynomials by their powers.

use crate::program::{Builder, Id};

/// Σ cⱼxʲ by pairs, pairs of pairs and so on (Estrin 1960): the chain of dependent operations grows with the logarithm of
/// the number of terms.
pub(crate) fn estrin(b: &mut Builder, x: Id, coefficients: &[Id], names: &[&'static str]) -> Id {
    let mut sums = coefficients.to_vec();
    let mut power = x;
    let mut level = 0;
    while sums.len() > 1 {
        sums = sums
            .chunks(2)
            .map(|pair| match *pair {
                [low, high] => {
                    let high = b.mul(high, power);
                    b.add(low, high)
                }
                [low] => low,
                _ => unreachable!("chunks of two"),
            })
            .collect();
        if sums.len() > 1 {
            power = b.mul(power, power);
            level += 1;
            // Higher powers than have names occur in kernels that no promise needs; the search tries and drops them.
            if let Some(name) = names.get(level) {
                b.name(power, name);
            }
        }
    }
    sums[0]
}
