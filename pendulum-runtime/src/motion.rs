//! The motion itself, in `f64`: what `Pendulum<f64>` and `Pendulum<f32>` both evaluate.

#![expect(
    clippy::inline_always,
    reason = "a point passed in memory is stored by words and loaded by pairs, which store buffers do not forward; \
              inlined, consecutive evaluations overlap and take half the time"
)]

use crate::agm::complete;
use crate::double::{Double, LARGEST, two_prod, two_sum};
use crate::kernel::{sin_turns, two_to};
use crate::nome::nome_of;
use crate::phase::{Phase, Reduced, unit_of};
use crate::regime::Regime;
use crate::rotation::Rotation;
use crate::swing::{Swing, SwingPhase};
use core::f64::consts::TAU;

/// A motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Motion {
    pub(crate) shape: Shape,
    /// Whole turns of the initial angle, 2πn.
    pub(crate) base: Double,
    /// The shape is traversed as it is (+1) or mirrored (−1).
    pub(crate) direction: f64,
    /// The largest |θ̇|.
    pub(crate) top_speed: f64,
    /// The largest |θ − base|.
    pub(crate) amplitude: f64,
    /// √(energy/2) in units of ω: sin(θ0/2) for a swing, v0/(2ω) for a rotation through the bottom at v0.
    pub(crate) k: Double,
    pub(crate) moduli: Moduli,
    pub(crate) theta: f64,
    pub(crate) velocity: f64,
    pub(crate) omega: f64,
}

/// The elliptic modulus (k, or 1/k for a rotation), its complement, and AGM(1, complement).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moduli {
    pub(crate) k: Double,
    pub(crate) kc: Double,
    pub(crate) mean: Double,
}

/// θ as a function of phase, and phase as a function of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shape {
    /// Phase counted from the positive turning point.
    Swing(Swing, Phase),
    /// Phase counted from the bottom, one per turn.
    Rotation(Rotation, Phase),
    /// ωt from the bottom to t = 0; negative before the bottom.
    Separatrix(Rotation, Double),
}

/// A point of the motion, ready for any output.
pub(crate) enum Point<'a> {
    Swing(&'a Swing, SwingPhase),
    Rotation(&'a Rotation, Reduced),
}

impl Motion {
    pub(crate) fn regime(&self) -> Regime {
        match self.shape {
            Shape::Swing(..) if self.amplitude == 0.0 && self.velocity == 0.0 => Regime::Rest,
            Shape::Swing(..) => Regime::Swing,
            Shape::Separatrix(..) => Regime::Separatrix,
            Shape::Rotation(..) => Regime::Rotation,
        }
    }

    /// The one phase reduction all outputs share.
    #[inline(always)]
    pub(crate) fn at(&self, t: f64) -> Point<'_> {
        match &self.shape {
            Shape::Swing(swing, phase) => Point::Swing(swing, SwingPhase::new(phase.reduce(t))),
            Shape::Rotation(rotation, phase) => Point::Rotation(rotation, phase.reduce(t)),
            Shape::Separatrix(rotation, start) => Point::Rotation(rotation, self.separatrix_phase(*start, t)),
        }
    }

    /// ωt + u₀, where only |u| < 42 matters; NaN for NaN and ±∞.
    fn separatrix_phase(&self, start: Double, t: f64) -> Reduced {
        let product = self.omega * t;
        let unit = unit_of(self.omega); // scaled so that neither factor is split beyond 2⁹⁹⁶
        let exact = Double::from_product(self.omega / unit, t * unit) + start;
        let u = if product.abs() < 1e9 { exact.hi } else { product };
        let high = if t.is_finite() { u.clamp(-1e9, 1e9) } else { f64::NAN };
        Reduced { turns: 0.0, high, low: 0.0 }
    }

    /// θ.
    #[inline(always)]
    pub(crate) fn angle(&self, point: &Point<'_>) -> f64 {
        match point {
            Point::Swing(swing, phase) => with_turns(self.base, 0.0, self.direction * swing.angle(*phase)),
            Point::Rotation(rotation, phase) => {
                with_turns(self.base, self.direction * phase.turns, self.direction * rotation.angle(*phase))
            }
        }
    }

    /// θ less whole turns, in [−π, π).
    #[inline(always)]
    pub(crate) fn wrapped(&self, point: &Point<'_>) -> f64 {
        self.direction
            * match point {
                Point::Swing(swing, phase) => swing.angle(*phase),
                Point::Rotation(rotation, phase) => rotation.angle(*phase),
            }
    }

    /// θ̇.
    #[inline(always)]
    pub(crate) fn velocity_at(&self, point: &Point<'_>) -> f64 {
        self.direction
            * self.top_speed
            * match point {
                Point::Swing(swing, phase) => swing.velocity(*phase),
                Point::Rotation(rotation, phase) => rotation.velocity(*phase),
            }
    }

    /// (sin θ, −cos θ), without an arctangent; no more than 1, so that users may take an arccosine.
    #[inline(always)]
    pub(crate) fn position(&self, point: &Point<'_>) -> (f64, f64) {
        let (sine, cosine) = match point {
            Point::Swing(swing, phase) => swing.half_angle(*phase),
            Point::Rotation(rotation, phase) => rotation.half_angle(*phase),
        };
        let (x, y) = (self.direction * 2.0 * (sine * cosine), (sine - cosine) * (sine + cosine));
        (x.clamp(-1.0, 1.0), y.clamp(-1.0, 1.0))
    }

    /// θ̈ = −ω² sin θ.
    #[inline(always)]
    pub(crate) fn acceleration(&self, point: &Point<'_>) -> f64 {
        (-self.omega * (self.omega * self.position(point).0)).clamp(f64::MIN, f64::MAX)
    }

    /// The time of a full swing or of one turn.
    pub(crate) fn period(&self) -> f64 {
        match &self.shape {
            Shape::Swing(_, phase) | Shape::Rotation(_, phase) => phase.period(),
            Shape::Separatrix(..) => f64::INFINITY,
        }
    }

    /// K.
    pub(crate) fn complete_integral(&self) -> f64 {
        complete(self.moduli.kc)
    }

    /// K′.
    pub(crate) fn complementary_integral(&self) -> f64 {
        complete(self.moduli.k)
    }

    /// q = exp(−πK′/K).
    pub(crate) fn nome(&self) -> f64 {
        nome_of(self.moduli.k, self.moduli.kc)
    }

    /// θ̇²/2ω² + 1 − cos θ = 2k²; ∞ where that is no number.
    pub(crate) fn energy(&self) -> f64 {
        // In units of 2⁵¹² neither word of a square overflows.
        let unit = if self.k.hi < 1e150 { 1.0 } else { two_to(512) };
        let k = self.k.scale(1.0 / unit);
        (k * k).scale(2.0).to_f64() * unit * unit
    }

    /// Eq. 3, the linearised motion from the same initial state, about the lowest point next to it: θ cos ωt + (θ̇/ω) sin ωt.
    pub(crate) fn small_angle(&self, t: f64) -> f64 {
        let (sine, cosine) = sine_cosine(Phase::new(Double::INVERSE_TURN, self.omega, Double::ZERO).reduce(t));
        let cosine_part = (Double::new(self.theta) - self.base).to_f64() * cosine;
        let angle = if self.velocity == 0.0 { cosine_part } else { cosine_part + self.velocity / self.omega * sine };
        with_turns(self.base, 0.0, angle)
    }

    /// Eq. 17: the exact period and amplitude, but a cosine; NaN unless the motion is a swing (or rest).
    pub(crate) fn harmonic(&self, t: f64) -> f64 {
        match &self.shape {
            Shape::Swing(_, phase) => {
                let cosine = sine_cosine(phase.reduce(t)).1;
                with_turns(self.base, 0.0, self.direction * (self.amplitude * cosine))
            }
            Shape::Rotation(..) | Shape::Separatrix(..) => f64::NAN,
        }
    }
}

/// base + 2π · turns + angle, within the finite numbers.
#[inline]
pub(crate) fn with_turns(base: Double, turns: f64, angle: f64) -> f64 {
    if turns == 0.0 && base.hi == 0.0 {
        return angle;
    }
    if turns.abs() > LARGEST {
        return (turns * TAU).clamp(f64::MIN, f64::MAX);
    }
    let (p, e) = two_prod(turns, Double::TURN.hi);
    let (sum, f) = two_sum(p, base.hi);
    let (sum, g) = two_sum(sum, angle);
    sum + (g + (f + (e + (turns * Double::TURN.lo + base.lo))))
}

/// (sin 2πs, cos 2πs).
fn sine_cosine(phase: Reduced) -> (f64, f64) {
    let (to_half, to_quarter) = phase.folded();
    let sine = sin_turns(to_half);
    (if phase.high < 0.0 { -sine } else { sine }, sin_turns(to_quarter))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Next to a zero of the sine or of the cosine the second word is as large as what is left of the first.
    #[test]
    fn second_words_count_next_to_zeros() {
        let at = |high: f64, low: f64| sine_cosine(Reduced { turns: 0.0, high, low });
        let near = |found: f64, turns: f64| assert!((found / (TAU * turns) - 1.0).abs() < 4e-16, "{found:e} {turns:e}");
        near(at(1e-17, 3e-18).0, 1.3e-17);
        near(at(-1e-17, -3e-18).0, -1.3e-17);
        near(at(0.5, 3e-18).0, -3e-18);
        near(at(0.25, 3e-18).1, -3e-18);
        near(at(-0.25, 3e-18).1, 3e-18);
    }
}
