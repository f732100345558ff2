//! The motion in the planner's terms, in every regime: whole, and the arc that a short horizon meets.

use super::aim::{Aim, aims};
use super::arc::Arc;
use super::curve::{RotationCurves, Size, SwingCurves};
use super::met::Met;
use super::passage::Orbit;
use super::reduction::{Clock, Origin, Reduction};
use super::turning::Mean;
use crate::exact::Real;
use crate::motion::{Motion, Regime, Rotation, Separatrix, Swing, direction};
use crate::parse::Output;
use crate::program::rounding::INFLATION_OF_SUMS;
use crate::scene::Scene;
use pendulum_runtime::double::Double;
use std::f64::consts::PI;

/// The motion in the planner's terms: its outputs as functions of one phase.
pub(super) struct Task {
    pub(super) aims: Vec<Aim>,
    /// Anchors per unit of time, and at t = 0.
    pub(super) rate: Real,
    pub(super) launch: Real,
    /// −1 for a mirror image.
    pub(super) direction: f64,
    /// The passage through the lowest point; absent where the nome makes its series converge slowly, or a method is asked
    /// for.
    passage: Option<Orbit>,
    /// The mean rotation, if turns are added to an angle, or taken off: of all of a rotation, not of an arc.
    pub(super) mean: Option<Mean>,
    /// The most turns within the horizon, each from one anchor to the next, from half-way between those numbered 0 and 1.
    pub(super) turns: f64,
    /// The first and the last phase within the horizon, where that is less than from one anchor to the next.
    pub(super) met: Option<Met>,
    /// Where no more than an arc is met, the time itself.
    unreduced: Option<Reduction>,
}

/// The binary places by which the velocity of a swing is below that of the separatrix whose arc it stands for: enough
/// that the difference is far below rounding, few enough that its Fourier series has no more than 300 terms.
const BESIDE_SEPARATRIX: i64 = 72;

/// ω·t up to which polynomials over an arc may be cheaper than the passage.
const FARTHEST_BESIDE_SEPARATRIX: f64 = 4.0;

impl Task {
    pub(super) fn new(scene: &Scene) -> Self {
        let task = match &scene.motion.regime {
            Regime::Swing(swing) => Self::swing(scene, swing),
            Regime::Rotation(rotation) => Self::rotation(scene, rotation),
            Regime::Separatrix(separatrix) => Self::separatrix(scene, separatrix),
        };
        Self { passage: task.passage.filter(|_| scene.method.is_none()), ..task }
    }

    fn swing(scene: &Scene, swing: &Swing) -> Self {
        let direction = direction(swing.mirrored);
        let aims = aims(scene, &SwingCurves::new(swing, &scene.motion.omega));
        let passage = Orbit::new(&scene.motion, &swing.elliptic, 1.0, direction);
        Self { passage, ..Self::whole(scene, aims, swing.rate(), swing.launch.clone(), direction) }
    }

    fn rotation(scene: &Scene, rotation: &Rotation) -> Self {
        let direction = direction(rotation.mirrored);
        let aims = aims(scene, &RotationCurves::new(rotation, &scene.motion.omega));
        // The turn that passes the lowest point at t = 0 began at the top numbered 0.
        let launch = &rotation.launch + rotation.launch.context().ratio(1, 2);
        let passage = Orbit::new(&scene.motion, &rotation.elliptic, -1.0, direction);
        let rate = rotation.rate();
        let turned = |turns: &Real| (turns * turns.context().pi()).to_double() * (2.0 * direction);
        let horizon = rate.context().float(scene.horizon());
        let most = horizon.map_or(Double::new(f64::INFINITY), |horizon| turned(&(&rate * horizon)).abs());
        let mean = Some(Mean { rate: turned(&rate), start: turned(&rotation.launch), turned: most });
        Self { passage, mean, ..Self::whole(scene, aims, rate, launch, direction) }
    }

    fn separatrix(scene: &Scene, separatrix: &Separatrix) -> Self {
        let omega = scene.motion.omega.to_f64();
        let aims = scene.outputs.iter().map(|&output| {
            // |dθ/dw| ≤ 2 and |d²θ/dw²| ≤ 1; the last are the largest w·2 sech w, w·|sin θ| and w·|d(sin θ)/dw|.
            let (largest, unit, conditioning) = match output {
                Output::Theta | Output::Wrapped => (PI, 1.0, 1.326),
                Output::Velocity => (2.0 * omega, omega, 1.16),
                Output::Acceleration => (omega * omega, omega * omega, 0.93),
                Output::Position => (1.0, 1.0, 1.326),
            };
            Aim::with(scene, output, Size { largest, slope: 2.0 * unit, conditioning: conditioning * unit, unit })
        });
        let (direction, rate) = (direction(separatrix.mirrored), scene.motion.omega.clone());
        let passage = Some(Orbit::separatrix(&scene.motion, direction));
        Self { passage, ..Self::whole(scene, aims.collect(), rate, separatrix.launch.clone(), direction) }
    }

    fn whole(scene: &Scene, aims: Vec<Aim>, rate: Real, launch: Real, direction: f64) -> Self {
        let met = Met::within(scene, &rate, &launch);
        let turns = scene.horizon() * rate.to_f64() + (&launch - rate.context().ratio(1, 2)).to_f64().abs();
        Self { aims, rate, launch, direction, passage: None, mean: None, turns, met, unreduced: None }
    }

    /// Whether turns are added to an angle, or taken off.
    pub(super) fn turns_over(&self) -> bool {
        self.mean.is_some()
    }

    /// The same over no more than the horizon meets, where that is less than from one anchor to the next.
    pub(super) fn over_arc(&self, scene: &Scene) -> Option<Self> {
        let reach = Arc::reach(scene)?;
        if let Regime::Separatrix(_) = &scene.motion.regime {
            return Self::beside_separatrix(scene, reach);
        }
        let mut arc = Arc::new(reach, &self.rate, &self.launch)?;
        let mut aims = self.aims.clone();
        if let Regime::Rotation(rotation) = &scene.motion.regime {
            // The angle from the lowest point is odd about that, not about the top.
            if arc.halves().is_some_and(|halves| halves % 2 == 0)
                && scene.outputs.iter().any(|output| output.is_angle())
            {
                arc = arc.lopsided();
            }
            let angle = RotationCurves::new(rotation, &scene.motion.omega).whole_angle();
            let angles = aims.iter_mut().filter(|aim| aim.output.is_angle());
            angles.for_each(|aim| aim.curves = vec![angle.clone()]);
        }
        let context = self.rate.context();
        Some(Self {
            aims: aims.iter().map(|aim| aim.over(arc, self.direction)).collect(),
            rate: context.integer(1) / context.float(reach)?.scale(1),
            launch: context.integer(0),
            direction: 1.0,
            passage: None,
            mean: None,
            turns: 0.0,
            met: None,
            unreduced: Some(Reduction::time(reach, arc.halves().is_none(), scene.float)?),
        })
    }

    /// The separatrix over an arc, which is that of a swing beside it. With e = v₀·2⁻⁷²/ω, their difference δ has δ(0) = 0,
    /// |δ̇(0)| = ωe and |δ̈| ≤ ω²|δ|: in units of 1, ω and ω² what follows from it is at most e·cosh ωt.
    fn beside_separatrix(scene: &Scene, reach: f64) -> Option<Self> {
        let Motion { theta0, velocity0, omega, .. } = &scene.motion;
        let turned = reach * omega.to_f64();
        if turned > FARTHEST_BESIDE_SEPARATRIX {
            return None;
        }
        let stray = (velocity0 / omega).abs().scale(-BESIDE_SEPARATRIX);
        let slower = velocity0 - velocity0.scale(-BESIDE_SEPARATRIX);
        let beside = Scene { motion: Motion::solve(theta0, &slower, omega).ok()?, ..scene.clone() };
        let Regime::Swing(swing) = &beside.motion.regime else { return None };
        let mut arc = Self::swing(&beside, swing).over_arc(&beside)?;
        let stray = stray.to_f64() * libm::cosh(turned) * INFLATION_OF_SUMS;
        let curves = arc.aims.iter_mut().flat_map(|aim| &mut aim.curves);
        curves.for_each(|curve| curve.stray(stray * curve.size.unit));
        Some(arc)
    }

    /// How far from an anchor the horizon goes, where that isn't all the way.
    pub(super) fn reach(&self) -> Option<f64> {
        self.met?.reach()
    }

    /// The least and the largest distance from a lowest point within the horizon, in units of the reduced phase.
    pub(super) fn distances_from_lowest(&self, reduction: &Reduction) -> [f64; 2] {
        let half = reduction.half();
        let Some(met) = self.met.filter(|_| !reduction.is_linear()) else { return [0.0, half] };
        let ([least, farthest], unit) = (met.distances(), reduction.unit.hi);
        let wrong = 2.0 * (reduction.error + reduction.relative_error);
        let largest = if least == 0.0 { half } else { half.min((0.5 - least + wrong) / unit) };
        [(0.5 - farthest - wrong).max(0.0) / unit, largest]
    }

    /// The reductions of its phase.
    pub(super) fn reductions(&self, scene: &Scene) -> Vec<Reduction> {
        if let Some(time) = &self.unreduced {
            return vec![time.clone()];
        }
        let clock = Clock::new(scene, &self.rate, &self.launch);
        match &scene.motion.regime {
            Regime::Swing(swing) => clock.of_swing(swing),
            Regime::Rotation(_) => clock.reductions(),
            Regime::Separatrix(_) => vec![clock.linear()],
        }
    }

    /// The passage, where phases are from the lowest point.
    pub(super) fn passage_by(&self, reduction: &Reduction) -> Option<&Orbit> {
        self.passage.as_ref().filter(|_| reduction.origin == Origin::Lowest)
    }
}

#[cfg(test)]
mod tests;
