//! What each output has to keep.

use super::arc::Arc;
use super::curve::{Curve, Curves, Size};
use super::reduction::Reduction;
use crate::parse::Output;
use crate::scene::{Goal, Scene};

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
    pub(super) goal: Goal,
    unit_of_rounding: f64,
}

/// What full precision may be wrong by, in units of rounding of the largest value.
pub(super) const FULL: f64 = 16.0;

/// What each output has to keep, made of these curves.
pub(super) fn aims(scene: &Scene, curves: &impl Curves) -> Vec<Aim> {
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

impl Aim {
    fn new(scene: &Scene, output: Output, curves: Vec<Curve>, power: usize, steepest: &Curve) -> Self {
        let largest = if output == Output::Position { 1.0 } else { steepest.size.largest };
        let aim = Self::with(scene, output, Size { largest, ..steepest.size });
        Self { curves, power, ..aim }
    }

    pub(super) fn with(scene: &Scene, output: Output, size: Size) -> Self {
        let (curves, unit_of_rounding) = (Vec::new(), scene.float.rounding_unit());
        let goal = scene.goal;
        let mut aim = Self { output, curves, power: 0, size, limit: 0.0, truncation: 0.0, goal, unit_of_rounding };
        aim.at_full_precision();
        if let Goal::Tolerance(tol) = goal {
            aim.limit = size.within(tol);
            aim.truncation = aim.limit.max(aim.floor() / 8.0);
        }
        aim
    }

    /// Its curves over an arc, mirrored if `direction` is negative: a position's height isn't.
    pub(super) fn over(&self, arc: Arc, direction: f64) -> Self {
        let over = |(index, curve): (usize, &Curve)| {
            let curve = curve.clone().over(arc);
            if direction < 0.0 && index == 0 { curve.negated() } else { curve }
        };
        let curves = self.curves.iter().enumerate().map(over).collect();
        Self { curves, power: 0, ..self.clone() }
    }

    /// One unit of rounding of the largest value; of a position that hardly changes, of the change: the 1 beside it is exact.
    pub(super) fn floor(&self) -> f64 {
        let changes = if self.output == Output::Position { self.size.slope } else { f64::INFINITY };
        self.unit_of_rounding * self.size.largest.min(changes)
    }

    /// Sixteen units of rounding of the largest value, of which truncation takes one.
    pub(super) fn at_full_precision(&mut self) {
        // Of a position, whose coordinates are products, rounding takes more.
        let units = if self.output == Output::Position { 3.0 * FULL } else { FULL };
        self.truncation = self.unit_of_rounding * self.size.largest;
        self.limit = units * self.truncation;
    }

    /// Whether an error, in units of the tolerance, is within the limit.
    pub(super) fn is_within(&self, error: f64) -> bool {
        error * self.size.unit <= self.limit.next_up()
    }

    /// As [`Size::phase_error`] for a passage, which rounds w = phase·rate besides, by so much of itself.
    pub(super) fn passage_error(&self, reduction: &Reduction, rounding: f64) -> f64 {
        self.size.phase_error(reduction) + self.size.conditioning(reduction) * rounding
    }
}
