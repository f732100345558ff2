//! The conditioning of the motion: what an error of the phase that is relative to z, the phase from the lowest point,
//! costs. These are suprema of |z·df/dz|, for the angle, the velocity and the acceleration.
//!
//! From the lowest point to the anchor v = θ̇ falls, so that in a slice of z it lies between its values at the ends. By
//! the energy, 1 − cos θ = (F² − v²)/(2ω²) with F = v(0) rises as it falls. θ̈ = −ω² sin θ and θ⃛ = −ω² v cos θ are bounded
//! by the same intervals.

use crate::power::power;
use crate::program::rounding::INFLATION_OF_SUMS;
use crate::series::Wave;
use crate::supremum::larger;

/// Of θ, θ̇/ω and θ̈/ω².
#[derive(Clone, Copy, Debug)]
pub(super) struct Conditioning {
    pub(super) angle: f64,
    pub(super) velocity: f64,
    pub(super) acceleration: f64,
}

/// Slices, each longer than the one before by the same factor, which is also about that by which the suprema are
/// exceeded.
const SLICES: i32 = 64;

/// What samples of the velocity may be wrong by, relative to the largest.
const SLACK: f64 = 1e-10;

impl Conditioning {
    /// Of dθ/ds by the phase s from an anchor.
    pub(super) fn of_wave(slope: &Wave, rate: f64, fastest: f64) -> Self {
        Self::new(|z| slope.roughly(0.5 - z).abs() * rate, rate, fastest)
    }

    /// Of |θ̇|/ω by z, good to [`SLACK`]. `rate` is the number of anchors per unit of ωt, `fastest` is F/ω.
    pub(super) fn new(speed: impl Fn(f64) -> f64, rate: f64, fastest: f64) -> Self {
        // Where the motion is fast, all of it happens in the first thousandths.
        let first = (0.3 * rate / fastest).min(0.02);
        let ratio = libm::pow(0.5 / first, 1.0 / f64::from(SLICES - 1));
        let end = |slice: i32| if slice == 0 { 0.0 } else { first * power(ratio, slice - 1) };
        let mut conditioning = [0.0f64; 3];
        let mut before = fastest;
        for slice in 0..SLICES {
            let z = end(slice + 1).min(0.5);
            let here = speed(z);
            let (slow, fast) = (here - SLACK * fastest, before + SLACK * fastest);
            let [(low, of_low), (high, of_high)] = [fast, slow.max(0.0)].map(|v| height_and_sine(v, fastest));
            let sine = if low <= 1.0 && high >= 1.0 { 1.0 } else { larger(of_low, of_high) };
            let cosine = larger((1.0 - low).abs(), (1.0 - high).abs());
            let steepest = [fast, sine, cosine * fast];
            for (condition, steepest) in conditioning.iter_mut().zip(steepest) {
                *condition = larger(*condition, z * steepest / rate);
            }
            before = here;
        }
        let [angle, velocity, acceleration] = conditioning.map(|condition| condition * INFLATION_OF_SUMS);
        Self { angle, velocity, acceleration }
    }
}

/// 1 − cos θ and sin θ at the velocity v, in units of ω. The sine is √((1 − cos θ)(1 + cos θ)): of a small swing 1 − cos² θ
/// would keep no digit, and of a tiny one 1 − cos θ is 0.
fn height_and_sine(v: f64, fastest: f64) -> (f64, f64) {
    let height = (0.5 * (fastest - v) * (fastest + v)).clamp(0.0, 2.0);
    let root = (fastest - v).max(0.0).sqrt() * (fastest + v).sqrt();
    (height, root * (1.0 - 0.5 * height).sqrt())
}
