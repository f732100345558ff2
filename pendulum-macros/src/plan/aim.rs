//! What each output has to keep, in every regime.

use super::arc::Arc;
use super::curve::{Curve, Curves, RotationCurves, Size, SwingCurves};
use super::met::{self, Met};
use super::passage::{LN_2, Orbit, Passage};
use super::reduction::{Clock, Reduction};
use crate::exact::Real;
use crate::motion::{Elliptic, Motion, Regime, Rotation, Separatrix, Swing, direction};
use crate::parse::{Float, Output};
use crate::scene::{Goal, Scene};
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
    pub(super) passage: Option<Orbit>,
    pub(super) turning: bool,
    /// Where no more than an arc is met, the time itself.
    unreduced: Option<Reduction>,
}

/// One output's promise.
#[derive(Clone)]
pub(super) struct Aim {
    pub(super) output: Output,
    /// The functions of the phase that make it; none on the separatrix.
    pub(super) curves: Vec<Curve>,
    /// The power of the nearest poles in the curves, 0 if they are logarithms.
    pub(super) power: usize,
    /// Of the output itself.
    pub(super) size: Size,
    /// For the total error, in the output's own unit, and for truncation alone.
    pub(super) limit: f64,
    pub(super) truncation: f64,
    unit_of_rounding: f64,
}

/// What full precision may be wrong by, in units of rounding of the largest value.
pub(super) const FULL: f64 = 16.0;

/// The binary places by which the velocity of a swing is below that of the separatrix whose arc it stands for: enough
/// that the difference is far below rounding, few enough that its Fourier series has no more than 300 terms.
const BESIDE_SEPARATRIX: i64 = 72;

/// ω·t up to which polynomials over an arc may be cheaper than the passage.
const FARTHEST_BESIDE_SEPARATRIX: f64 = 4.0;

/// Above this complementary nome the images of a passage are too many for [`Passage`].
const LARGEST_IMAGE: f64 = 0.05;

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
        Self {
            aims: aims(scene, &SwingCurves::new(swing, &scene.motion.omega)),
            rate: swing.rate(),
            launch: swing.launch.clone(),
            direction,
            passage: passage(&swing.elliptic, 1.0, direction),
            turning: false,
            unreduced: None,
        }
    }

    fn rotation(scene: &Scene, rotation: &Rotation) -> Self {
        let direction = direction(rotation.mirrored);
        // The turn that passes the lowest point at t = 0 began at the top numbered 0.
        let half = rotation.launch.context().ratio(1, 2);
        Self {
            aims: aims(scene, &RotationCurves::new(rotation, &scene.motion.omega)),
            rate: rotation.rate(),
            launch: &rotation.launch + half,
            direction,
            passage: passage(&rotation.elliptic, -1.0, direction),
            turning: true,
            unreduced: None,
        }
    }

    fn separatrix(scene: &Scene, separatrix: &Separatrix) -> Self {
        let omega = scene.motion.omega.to_f64();
        let aims = scene.outputs.iter().map(|&output| {
            // |dθ/dw| ≤ 2 and |d²θ/dw²| ≤ 1; the last are the largest w·2 sech w, w·|sin θ| and w·|d(sin θ)/dw|.
            let (largest, unit, moment) = match output {
                Output::Theta | Output::Wrapped => (PI, 1.0, 1.326),
                Output::Velocity => (2.0 * omega, omega, 1.16),
                Output::Acceleration => (omega * omega, omega * omega, 0.93),
                Output::Position => (1.0, 1.0, 1.326),
            };
            Aim::with(scene, output, Size { largest, slope: 2.0 * unit, moment: moment * unit, unit })
        });
        let direction = direction(separatrix.mirrored);
        let rate = Double::ONE / LN_2;
        let passage = Orbit { rate, sigma: 0.0, image: Double::ZERO, image_exponent: 0, direction };
        Self {
            aims: aims.collect(),
            rate: scene.motion.omega.clone(),
            launch: separatrix.launch.clone(),
            direction,
            passage: Some(passage),
            turning: false,
            unreduced: None,
        }
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
            turning: false,
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
        let stray = stray.to_f64() * libm::cosh(turned) * (1.0 + 1e-9);
        let curves = arc.aims.iter_mut().flat_map(|aim| &mut aim.curves);
        curves.for_each(|curve| curve.stray(stray * curve.size.unit));
        Some(arc)
    }

    /// The first and the last phase within the horizon, where that is less than from one anchor to the next.
    pub(super) fn met(&self, scene: &Scene) -> Option<(f64, f64)> {
        met::phases(scene, &self.rate, &self.launch)
    }

    /// How far from an anchor the horizon goes, where that isn't all the way.
    pub(super) fn reach(&self, scene: &Scene) -> Option<f64> {
        let met = self.met(scene).filter(|_| self.unreduced.is_none())?;
        Met::new(met).reach()
    }

    /// The least and the largest distance from a lowest point within the horizon, in units of the reduced phase.
    pub(super) fn met_from_lowest(&self, scene: &Scene, reduction: &Reduction) -> (f64, f64) {
        let half = reduction.half();
        let Some(met) = self.met(scene).filter(|_| !reduction.is_linear()) else { return (0.0, half) };
        let (Met { least, farthest }, unit) = (Met::new(met), reduction.unit.hi);
        let wrong = 2.0 * (reduction.error + reduction.relative_error);
        let largest = if least == 0.0 { half } else { half.min((0.5 - least + wrong) / unit) };
        ((0.5 - farthest - wrong).max(0.0) / unit, largest)
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

    /// Turns within the horizon, each from one anchor to the next.
    pub(super) fn turns(&self, scene: &Scene) -> f64 {
        scene.horizon() * self.rate.to_f64() + 2.0
    }

    /// |θ̇| at the lowest point.
    pub(super) fn fastest(scene: &Scene) -> Double {
        scene.motion.fastest().to_double()
    }
}

/// What each output has to keep, made of these curves.
fn aims(scene: &Scene, curves: &impl Curves) -> Vec<Aim> {
    let aim = |&output: &Output| {
        let (functions, power) = match output {
            Output::Theta | Output::Wrapped => (vec![curves.angle()], 0),
            Output::Velocity => (vec![curves.velocity()], 1),
            Output::Acceleration => (vec![curves.acceleration()], 2),
            Output::Position => (vec![curves.half_sine(), curves.half_cosine()], 1),
        };
        let steepest = if output == Output::Position { curves.angle() } else { functions[0].clone() };
        Aim::new(scene, output, functions, power, &steepest)
    };
    scene.outputs.iter().map(aim).collect()
}

/// The passage through the lowest point: w = (πK/K′)·phase, in units of ln 2.
fn passage(elliptic: &Elliptic, sigma: f64, direction: f64) -> Option<Orbit> {
    let rate = elliptic.span().to_double() / LN_2;
    if libm::exp2(-rate.hi) > LARGEST_IMAGE {
        return None;
    }
    let image_exponent = (-rate.hi).floor() as i32;
    let image = elliptic.nome_complementary().scale(-i64::from(image_exponent)).to_double();
    Some(Orbit { rate, sigma, image, image_exponent, direction })
}

impl Aim {
    fn new(scene: &Scene, output: Output, curves: Vec<Curve>, power: usize, steepest: &Curve) -> Self {
        let largest = if output == Output::Position { 1.0 } else { steepest.size.largest };
        let aim = Self::with(scene, output, Size { largest, ..steepest.size });
        Self { curves, power, ..aim }
    }

    fn with(scene: &Scene, output: Output, size: Size) -> Self {
        let mut aim =
            Self { output, curves: Vec::new(), power: 0, size, limit: 0.0, truncation: 0.0, unit_of_rounding: 0.0 };
        aim.at_full_precision(scene.float);
        if let Goal::Tolerance(tol) = scene.goal {
            aim.limit = size.within(tol);
            aim.truncation = aim.limit.max(aim.truncation / 8.0);
        }
        aim
    }

    /// Its curves over an arc, mirrored if `direction` is negative: a position's height isn't.
    fn over(&self, arc: Arc, direction: f64) -> Self {
        let over = |(index, curve): (usize, &Curve)| {
            let curve = curve.clone().over(arc);
            if direction < 0.0 && index == 0 { curve.negated() } else { curve }
        };
        let curves = self.curves.iter().enumerate().map(over).collect();
        Self { curves, power: 0, ..self.clone() }
    }

    /// One unit of rounding of the largest value.
    pub(super) fn floor(&self) -> f64 {
        self.unit_of_rounding * self.size.largest
    }

    /// Sixteen units of rounding of the largest value, of which truncation takes one.
    pub(super) fn at_full_precision(&mut self, float: Float) {
        // Of a position, whose coordinates are products, rounding takes more.
        let units = if self.output == Output::Position { 3.0 * FULL } else { FULL };
        self.unit_of_rounding = float.unit();
        self.limit = units * self.floor();
        self.truncation = self.floor();
    }

    /// As [`Size::phase_error`] for a [`Passage`] kernel, which rounds w = phase·rate besides.
    pub(super) fn passage_error(&self, reduction: &Reduction) -> f64 {
        self.size.phase_error(reduction) + self.size.moment * Passage::relative_error()
    }
}

#[cfg(test)]
mod tests;
