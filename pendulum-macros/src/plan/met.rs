//! What a horizon of less than an anchor meets.

use super::arc::Arc;
use crate::exact::Real;
use crate::scene::{Goal, Scene};
use pendulum_runtime::double::Double;

/// The first and the last phase within the horizon, where that is less than from one anchor to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Met {
    pub(super) first: f64,
    pub(super) last: f64,
}

/// More than a phase is wrong by over so short a horizon, and little beside what next to poles a curve changes on it.
const MARGIN: f64 = 1e-3;

impl Met {
    pub(super) fn within(scene: &Scene, rate: &Real, launch: &Real) -> Option<Self> {
        let arc = Arc::new(Arc::reach(scene)?, rate, launch)?;
        let at = |sigma: f64| arc.phase(Double::new(sigma)).hi;
        Some(Self { first: at(-0.5), last: at(0.5) })
    }

    /// The least and the largest distance from the nearest anchor.
    pub(super) fn distances(self) -> [f64; 2] {
        let Self { first, last } = self;
        let passes = |origin: f64| (last - origin).floor() >= (first - origin).ceil();
        let ends = [first, last].map(|s| (s - s.round()).abs());
        let least = if passes(0.0) { 0.0 } else { ends[0].min(ends[1]) };
        let farthest = if passes(0.5) { 0.5 } else { ends[0].max(ends[1]) };
        [least, farthest]
    }

    /// The same of what a reduction may give for these phases.
    pub(super) fn distances_as_reduced(self, launch: &Real, scene: &Scene) -> [f64; 2] {
        let ([least, farthest], wrong) = (self.distances(), self.wrong(launch, scene));
        [(least - wrong).max(0.0), (farthest + wrong).min(0.5)]
    }

    /// What that may be wrong by over so short a horizon: some units of rounding of an anchor or, where an anchor is passed at
    /// t = 0, of the farthest phase. To reproduce the paper's θ̂ may take pieces, and in `f32` these a phase that is rounded
    /// once from `f64`, however short the horizon.
    pub(super) fn wrong(self, launch: &Real, scene: &Scene) -> f64 {
        const UNITS: f64 = 16.0;
        // A piece, of 32 or more; and phases nearer to an anchor underflow.
        let least = if let Goal::Terms(_) = scene.goal { 1.0 / 32.0 } else { 1e-30 };
        UNITS * scene.float.rounding_unit() * if launch.is_zero() { self.farthest().max(least) } else { 1.0 }
    }

    /// How far polynomials have to reach, `None` if as far as ever.
    pub(super) fn reach(self) -> Option<f64> {
        Some(self.farthest() + MARGIN).filter(|&reach| reach < 0.5)
    }

    fn farthest(self) -> f64 {
        self.distances()[1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_from_anchors() {
        for (phases, least, farthest) in [
            ((-0.125, 0.25), 0.0, 0.25),
            ((0.125, 0.25), 0.125, 0.25),
            ((0.25, 0.625), 0.25, 0.5),
            ((0.625, 0.75), 0.25, 0.375),
            ((-3.375, -2.875), 0.0, 0.375),
            ((1.75, 2.25), 0.0, 0.25),
        ] {
            let (first, last) = phases;
            assert_eq!(Met { first, last }.distances(), [least, farthest], "{phases:?}");
        }
        let reach = |last: f64| Met { first: 0.0, last }.reach();
        assert_eq!([reach(0.25), reach(0.4995), reach(0.5)], [Some(0.25 + MARGIN), None, None]);
    }
}
