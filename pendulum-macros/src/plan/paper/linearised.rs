//! Eq. 3, the linearised motion from the initial state: its amplitude and phase, and how it departs from the motion.

use super::bias::MOST_HARMONICS;
use crate::exact::Real;
use crate::motion::{Motion, Swing};
use crate::plan::cosines::Cosines;
use crate::plan::curve::Curve;
use crate::program::rounding::INFLATION_OF_SUMS;
use std::f64::consts::FRAC_PI_2;

/// θ0 cos ωt + (θ̇0/ω) sin ωt = A cos π(launch + ωt/π), of the motion before mirroring.
///
/// A² = θ0² + (θ̇0/ω)² is at most the amplitude's square: by the energy it is θ0² + 2(cos θ0 − cos amplitude), and the
/// derivative of that by the amplitude is 2 sin amplitude, less than twice the amplitude.
pub(super) struct Linearised {
    pub(super) amplitude: Real,
    /// Half periods after the positive turning point, in [−½, ½] as that of the swing.
    pub(super) launch: Real,
}

impl Linearised {
    pub(super) fn new(motion: &Motion, swing: &Swing) -> Self {
        let angle = motion.theta0.abs().settled();
        let context = angle.context();
        if motion.velocity0.is_zero() {
            return Self { amplitude: angle, launch: context.integer(0) };
        }
        let speed = (&motion.velocity0 / &motion.omega).settled();
        let quarter = if angle.is_zero() { context.ratio(1, 2) } else { speed.abs().atan2(&angle) / context.pi() };
        let rising = speed.is_negative() == swing.mirrored;
        let launch = if rising { -quarter } else { quarter };
        Self { amplitude: (angle.square() + speed.square()).sqrt(), launch }
    }
}

/// Bounds of |e|, of |e′|/ω and of |e″|/ω² for e = θ̂ − θ up to ωt = ±x, θ̂ being the linearised motion.
///
/// From e = e′ = 0 on it obeys e″ + ω²e = ω²(sin θ − θ), so that with d = |θ| − sin |θ|
/// |e| ≤ ∫₀ˣ |sin(x − ξ)| d(ξ) dξ, |e′|/ω ≤ ∫₀ˣ d(ξ) dξ and |e″|/ω² ≤ |e| + d.
#[derive(Clone, Copy, Debug)]
pub(super) struct Departure {
    pub(super) angle: f64,
    pub(super) velocity: f64,
    pub(super) acceleration: f64,
}

impl Departure {
    /// Of what nothing is known.
    pub(super) const ANY: Self = Self { angle: f64::INFINITY, velocity: f64::INFINITY, acceleration: f64::INFINITY };

    /// Over so much of ωt to either side of the start; of more than some periods the integrals say little.
    pub(super) fn new(swing: &Swing, theta: &Curve, omega: &Real, x: f64) -> Self {
        if x > MOST_RADIANS {
            return Self::ANY;
        }
        // So near the top that θ has many harmonics it stays there.
        let few = theta.terms().len() <= MOST_HARMONICS;
        let cosines = Cosines::of(if few { theta.terms() } else { &[] });
        let [launch, step] = [swing.launch.to_f64(), (swing.rate() / omega).to_f64() * x / f64::from(SLICES)];
        let largest = swing.amplitude.to_f64() * (1.0 + f64::EPSILON);
        let [onwards, back] = [step, -step].map(|step| {
            let slice = |index: u32| {
                let at = |index: u32| launch + step * f64::from(index);
                let angle = || cosines.over(at(index), at(index + 1)).largest(0) + theta.omitted();
                excess_of_arc(if few { angle().min(largest) } else { largest })
            };
            Self::through((0..SLICES).map(slice), x / f64::from(SLICES))
        });
        let worst = |of: fn(&Self) -> f64| of(&onwards).max(of(&back)) * INFLATION_OF_SUMS;
        Self {
            angle: worst(|at| at.angle),
            velocity: worst(|at| at.velocity),
            acceleration: worst(|at| at.acceleration),
        }
    }

    /// Of slices of ωt with these bounds of d. |sin| is replaced by what it is at most up to there: so the last time is the
    /// worst.
    fn through(bounds: impl Iterator<Item = f64>, width: f64) -> Self {
        let (mut angle, mut velocity, mut most) = (0.0, 0.0, 0.0_f64);
        for (index, d) in bounds.enumerate() {
            let [from, to] = [index as u32, index as u32 + 1].map(|index| f64::from(SLICES - index) * width);
            angle += d * (integral_of_sine(from) - integral_of_sine(to));
            velocity += d * width;
            most = most.max(d);
        }
        Self { angle, velocity, acceleration: angle + most }
    }
}

/// So many radians of ωt, in so many slices.
const MOST_RADIANS: f64 = 10.0;
const SLICES: u32 = 48;

/// x − sin x ≤ x³/6, for 0 ≤ x < π.
fn excess_of_arc(x: f64) -> f64 {
    let cubic = x * x * x / 6.0;
    if x < 0.5 { cubic } else { cubic.min(x - libm::sin(x)) }
}

/// ∫₀ˣ of the sine up to π/2, of 1 from there on.
fn integral_of_sine(x: f64) -> f64 {
    if x > FRAC_PI_2 {
        return 1.0 + (x - FRAC_PI_2);
    }
    let half = libm::sin(0.5 * x);
    2.0 * half * half
}

#[cfg(test)]
mod tests;
