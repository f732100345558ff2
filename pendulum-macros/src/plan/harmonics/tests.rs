//! The recurrence, evaluated.

use super::*;
use crate::parse::Float;

/// Clenshaw's recurrence of cosines and sines, with each number of weights.
#[test]
fn the_recurrence() {
    for count in 1..=5 {
        let weights: Vec<Double> = (0..count).map(|n| Double::new(0.7 / f64::from(1 + 3 * n))).collect();
        let mut b = Builder::new(Float::F64);
        let cosine = b.input();
        let (first, second) = clenshaw(&mut b, cosine, &weights);
        let zero = b.constant(0.0);
        let program = b.finish(vec![first, second.unwrap_or(zero)]);
        for s in [0.1f64, 0.4, 1.1] {
            let sum = |wave: fn(f64) -> f64| {
                weights.iter().enumerate().map(|(n, w)| w.hi * wave((2 * n + 1) as f64 * s)).sum::<f64>()
            };
            let found = program.run(s.cos());
            assert!((s.cos() * (found[0] - found[1]) - sum(f64::cos)).abs() < 1e-14, "{count} {s}");
            assert!((s.sin() * (found[0] + found[1]) - sum(f64::sin)).abs() < 1e-14, "{count} {s}");
        }
    }
}
