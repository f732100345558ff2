//! Eq. 22 of the paper as it is written there: N sines and an arcsine.

use pendula_stress::motion::Regime;

use super::Motion;
use crate::contestant::{Contestant, Family};
use crate::real::Real;

/// Name of the formula as it is written.
pub const AS_WRITTEN: &str = "Eq. 22 as written";

/// θ̂ = 2 arcsin(k Σ b₂ₙ₋₁ sin((2n−1)π(t + K)/(2K))), for N of 1 to 32.
///
/// The argument of the arcsine is limited to 1, which it exceeds near the turning points for small N; without that the
/// formula gives NaN there and could not be drawn.
pub(super) fn contestants<R: Real>(motion: &Motion) -> Vec<Contestant<R>> {
    vec![
        as_written::<R, 1>(motion),
        as_written::<R, 2>(motion),
        as_written::<R, 3>(motion),
        as_written::<R, 4>(motion),
        as_written::<R, 6>(motion),
        as_written::<R, 8>(motion),
        as_written::<R, 12>(motion),
        as_written::<R, 16>(motion),
        as_written::<R, 24>(motion),
        as_written::<R, 32>(motion),
    ]
}

fn as_written<R: Real, const N: usize>(motion: &Motion) -> Contestant<R> {
    let quarter = motion.period / 4.0;
    let rate = R::of(std::f64::consts::PI / (2.0 * quarter));
    let modulus = R::of(motion.modulus);
    let shift = R::of(quarter);
    let Regime::Swing(series) = &motion.exact.regime else { unreachable!("a pendulum released at rest swings") };
    let exact = series.paper_coefficients(N);
    let coefficients: [R; N] = std::array::from_fn(|n| R::of(exact[n].to_f64()));
    Contestant::function(Family::Paper, AS_WRITTEN, &format!("N = {N}"), move |t: R| {
        let x = rate * (t + shift);
        let mut sum = R::zero();
        for (n, &coefficient) in coefficients.iter().enumerate() {
            sum = sum + coefficient * (R::of((2 * n + 1) as f64) * x).sin();
        }
        R::of(2.0) * (modulus * sum).max(-R::one()).min(R::one()).asin()
    })
}
