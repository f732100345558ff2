//! Where a curve is flat an error of the phase does little, and the approximation may be wrong by more.
//!
//! Of a phase ŝ that is wrong by δ + r|z| at most, z being its distance from the lowest point, |P(ŝ) − f(s)| ≤ |P(ŝ) −
//! f(ŝ)| + δ·|f′| + r·|zf′| with f′ at most δ + r/2 away from ŝ ([`Size::phase_error`](crate::plan::curve::Size)). What
//! counts as truncation is by how much the supremum of the first two exceeds δ·sup |f′|, which is counted as the phase's.

use super::interval::{CELLS, angle};
use crate::plan::curve::Curve;

/// The slopes of a curve that is the steeper the farther the phase is from its anchor, and the error of that.
#[derive(Clone, Debug)]
pub(crate) struct Leeway {
    /// δ, in anchors.
    error: f64,
    /// What it makes where the curve is steepest, over what it leaves there of the promise, about.
    ratio: f64,
    steepest: f64,
    /// Bounds of |f′| between the angles of `interval.rs`.
    slopes: Vec<f64>,
}

impl Leeway {
    /// Of a curve that rises, and a phase that is wrong by `error` and by `relative` to its distance from the lowest point.
    pub(crate) fn new(curve: &Curve, [error, relative]: [f64; 2], ratio: f64) -> Self {
        let steepest = curve.size.slope;
        let slope = |cell: u32| {
            // p = (1 + cos φ)/8, s = ½ cos(φ/2).
            let farther = 0.5 * libm::cos(0.5 * angle(cell)) + error + 0.5 * relative;
            if farther < 0.5 { curve.steepness(farther).min(steepest) } else { steepest }
        };
        Self { error, ratio, steepest, slopes: (0..CELLS).map(slope).collect() }
    }

    pub(super) fn ratio(&self) -> f64 {
        self.ratio
    }

    /// What the approximation may be wrong by at u, in units of what it may where the curve is steepest.
    pub(super) fn at(&self, u: f64) -> f64 {
        let cell = (libm::acos(u.clamp(-1.0, 1.0)) / angle(1)) as usize;
        1.0 + self.ratio * (1.0 - self.slopes[cell.min(self.slopes.len() - 1)] / self.steepest)
    }

    /// By how much less than at most an error of the phase may be felt in the cell from this angle on.
    pub(super) fn spared(&self, cell: usize) -> f64 {
        self.error * (self.steepest - self.slopes[cell])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::task::Task;
    use crate::testing::scene;
    use pendulum_runtime::double::Double;

    /// What an error of the phase changes anywhere is within what is left of its largest effect, and hardly below.
    #[test]
    fn errors_of_phases() {
        for text in ["theta0 = 0.1", "theta0 = 7π/8", "theta0 = -3.1"] {
            let task = Task::new(&scene(&format!("struct Motion; {text}, outputs = [theta, velocity]")));
            let [curve, velocity] = [&task.aims[0].curves[0], &task.aims[1].curves[0]];
            assert!(curve.rises && !velocity.rises);
            let error = 1e-3;
            let leeway = Leeway::new(curve, [error, 1e-6], 2.0);
            let at = |s: f64| curve.at(Double::new(s)).hi;
            for cell in 0..CELLS {
                let [far, near] = [angle(cell), angle(cell + 1)].map(|angle| 0.5 * (0.5 * angle).cos());
                let most = error * curve.size.slope - leeway.spared(cell as usize);
                for part in [0.0, 0.3, 1.0] {
                    let s = near + part * (far - near);
                    let change = (at(s + error) - at(s)).abs().max((at(s - error) - at(s)).abs());
                    assert!(change <= most * (1.0 + 1e-9), "{text} {s}: {change:e} {most:e}");
                    let slack = 0.02 * error * curve.size.slope;
                    assert!(most < change + slack, "{text} {s}: {change:e} {most:e}");
                }
            }
            assert_eq!(leeway.at(1.0), 1.0);
            assert!((leeway.at(-1.0) - 3.0).abs() < 0.1, "{}", leeway.at(-1.0));
        }
    }
}
