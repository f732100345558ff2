//! The part of the motion that a horizon shorter than half a swing (than a turn) meets.
//!
//! There the phase needs no reduction, and what isn't met need not be approximated: polynomials of the time itself take
//! few terms. About the place where the pendulum is at t = 0, if that is an anchor or half-way between two, the motion
//! is even or odd.

use super::reduction::is_half;
use crate::exact::Real;
use crate::scene::Scene;
use pendulum_runtime::double::Double;

/// The phase s = centre + stretch·σ, with σ from −½ to ½ over the arc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Arc {
    pub(super) centre: Double,
    pub(super) stretch: Double,
    /// Whether a symmetry about the centre, if there is one, is made use of.
    symmetric: bool,
}

impl Arc {
    /// From half an anchor before an anchor to half an anchor after it.
    pub(crate) const WHOLE: Self = Self { centre: Double::ZERO, stretch: Double::ONE, symmetric: true };

    /// The greatest |t| of a scene's horizon. Rounded to the type of times it is still part of it.
    pub(super) fn reach(scene: &Scene) -> Option<f64> {
        Some(scene.t_max.as_ref()?.to_f64() * (1.0 + 4.0 * scene.float.rounding_unit()))
    }

    /// Of the times up to ±`reach`, if that is less than from one anchor to the next.
    pub(super) fn new(reach: f64, rate: &Real, launch: &Real) -> Option<Self> {
        let stretch = (rate * rate.context().float(reach)?.scale(1)).to_double();
        (0.0 < stretch.hi && stretch.hi < 1.0).then(|| Self { centre: launch.to_double(), stretch, symmetric: true })
    }

    /// The same, whatever symmetry there may be.
    pub(super) fn lopsided(self) -> Self {
        Self { symmetric: false, ..self }
    }

    /// The phase from the anchor.
    pub(super) fn phase(self, sigma: Double) -> Double {
        self.centre + sigma * self.stretch
    }

    /// Where in it, from −½ to ½, an anchor is, if there is one.
    pub(super) fn anchor(self) -> Option<f64> {
        let sigma = (self.centre.hi.round() - self.centre.hi) / self.stretch.hi;
        (sigma.abs() <= 0.5).then_some(sigma)
    }

    /// The number of halves of an anchor in its centre, if it is that of a symmetry.
    pub(super) fn halves(self) -> Option<i64> {
        (self.symmetric && is_half(self.centre)).then_some((2.0 * self.centre.hi) as i64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is near a centre of symmetry, by a second word or a hundredth, is none.
    #[test]
    fn centres_of_symmetries() {
        let arc = |hi: f64, lo: f64| Arc { centre: Double { hi, lo }, stretch: Double::new(0.5), symmetric: true };
        let halves = |hi: f64, lo: f64| arc(hi, lo).halves();
        assert_eq!([halves(0.0, 0.0), halves(-0.5, 0.0), halves(1.0, 0.0)], [Some(0), Some(-1), Some(2)]);
        assert_eq!([halves(0.5, 1e-20), halves(0.51, 0.0), halves(0.51, 1e-20)], [None; 3]);
        assert_eq!(arc(0.0, 0.0).lopsided().halves(), None);
    }
}
