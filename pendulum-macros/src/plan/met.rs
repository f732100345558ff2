//! What a horizon of less than an anchor meets of a curve: a polynomial may be as wrong elsewhere as it likes, as long as
//! an angle that is confined stays so.

use super::curve::Curve;
use pendulum_runtime::double::Double;

/// The distances from the nearest anchor that are met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Met {
    pub(super) least: f64,
    pub(super) farthest: f64,
    /// What the curve may be wrong by elsewhere: half of it by truncation, half by rounding.
    pub(super) spare: f64,
}

/// Taken for met on both sides, more than a phase is wrong by over so short a horizon.
const MARGIN: f64 = 0.01;

impl Met {
    /// Of the phases from the first to the last.
    pub(super) fn new([first, last]: [f64; 2]) -> Self {
        let passes = |origin: f64| (last - origin).floor() >= (first - origin).ceil();
        let ends = [first, last].map(|s| (s - s.round()).abs());
        let least = if passes(0.0) { 0.0 } else { ends[0].min(ends[1]) };
        let farthest = if passes(0.5) { 0.5 } else { ends[0].max(ends[1]) };
        Self { least, farthest, spare: f64::INFINITY }
    }

    /// A little more of it, on both sides.
    pub(super) fn with_margin(self) -> Self {
        Self { least: self.least - MARGIN, farthest: self.farthest + MARGIN, ..self }
    }

    /// The same of the angle of a swing, which at every other time stays within its amplitude: from that it falls to the
    /// lowest point.
    pub(super) fn confined(self, angle: &Curve) -> Self {
        let elsewhere = if self.least > 0.0 { 0.0 } else { self.farthest.min(0.5) };
        let highest = angle.at(Double::new(elsewhere)).hi.abs();
        Self { spare: 0.5 * (angle.size.largest - highest) * (1.0 - 1e-9), ..self }
    }

    /// Whether a distance between two others may be met.
    pub(super) fn overlaps(self, [low, high]: [f64; 2]) -> bool {
        low <= self.farthest && high >= self.least
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Regime;
    use crate::plan::curve::{Curves, SwingCurves};
    use crate::plan::tests::scene;

    #[test]
    fn distances_from_anchors() {
        for (phases, least, farthest) in [
            ([-0.125, 0.25], 0.0, 0.25),
            ([0.125, 0.25], 0.125, 0.25),
            ([0.25, 0.625], 0.25, 0.5),
            ([0.625, 0.75], 0.25, 0.375),
            ([-3.375, -2.875], 0.0, 0.375),
            ([1.75, 2.25], 0.0, 0.25),
        ] {
            let met = Met::new(phases);
            assert_eq!((met.least, met.farthest), (least, farthest), "{phases:?}");
        }
        let met = Met::new([0.125, 0.25]).with_margin();
        assert_eq!((met.least, met.farthest), (0.125 - MARGIN, 0.25 + MARGIN));
        let met = Met { least: 0.15, farthest: 0.25, spare: 0.0 };
        let overlaps = [[0.0, 0.1], [0.0, 0.2], [0.2, 0.21], [0.3, 0.5]].map(|distances| met.overlaps(distances));
        assert_eq!(overlaps, [false, true, true, false]);
    }

    /// Where the turning point is met, the angle is farther from its amplitude at all other times; else it isn't.
    #[test]
    fn room_elsewhere() {
        let scene = scene("theta0 = 2");
        let Regime::Swing(swing) = &scene.motion.regime else { panic!("a swing") };
        let angle = SwingCurves::new(swing, &scene.motion.omega).angle();
        let spare = |phases| Met::new(phases).confined(&angle).spare;
        let expected = 1.0 - 0.5 * angle.at(Double::new(0.25)).hi;
        assert!((spare([-0.1, 0.25]) / expected - 1.0).abs() < 1e-8, "{}", spare([-0.1, 0.25]));
        assert!(spare([0.125, 0.25]).abs() < 1e-15);
        assert_eq!(Met::new([0.125, 0.25]).spare, f64::INFINITY);
    }
}
