//! What becomes of an angle: that of a rotation is wrapped to [−π, π), or gets its turns.

mod half_turn;
mod mean;

use super::Bound;
use super::curve::Size;
use super::reduction::{Origin, ROUNDED, Reduction};
use super::variables::Variables;
use crate::parse::Float;
use crate::power::two_to;
use crate::program::rounding::half_ulp;
use crate::program::{Builder, Id, Op};
use crate::supremum::larger;
use half_turn::{below_half_turn, beyond_largest_number, held, modulo_turn, rounding_modulo, within_half_turn};
use pendulum_runtime::double::Double;
use std::f64::consts::{PI, TAU};

pub(super) use half_turn::AT_TOP;
#[cfg(test)]
pub(crate) use half_turn::is_wrapped;
pub(crate) use mean::Mean;

/// What becomes of what is computed of the phase.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Finish {
    Nothing,
    /// The angle of a rotation is completed.
    Turning(Turning),
    /// An angle near the top, at most so large, is kept within [−π, π).
    Within {
        largest: Double,
    },
    /// One that may be up to a turn beyond that is wrapped.
    Wrapped,
    /// An approximate angle that exceeds the amplitude beyond a short horizon is held to so much: no less than the exact one
    /// and than it is itself within the horizon.
    Held {
        most: f64,
    },
}

impl Finish {
    /// Emits it.
    pub(super) fn lower(&self, b: &mut Builder, variables: &Variables, values: Vec<Id>) -> Vec<Id> {
        match self {
            Self::Nothing => values,
            Self::Turning(turning) => vec![turning.lower(b, variables, values[0])],
            Self::Within { .. } => {
                let most = below_half_turn(b.float());
                vec![held(b, values[0], [-most, most])]
            }
            Self::Held { most } => vec![held(b, values[0], [-most, *most])],
            Self::Wrapped => vec![modulo_turn(b, values[0])],
        }
    }

    /// What an angle is rounded by that was by so much before, without turns.
    pub(super) fn rounding(&self, angle: f64, float: Float) -> f64 {
        match self {
            Self::Nothing | Self::Turning(_) | Self::Held { .. } => angle,
            // It leads away from no angle but one between the largest number that it may be and the top.
            Self::Within { largest } => larger(angle, beyond_largest_number(*largest, float)),
            Self::Wrapped => angle + rounding_modulo(float),
        }
    }

    /// What an error of the phase, which would change the angle itself by so much, does to what is computed of the phase: a
    /// mean rotation is one of the time.
    pub(super) fn felt(&self, reduction: &Reduction, phase: f64) -> f64 {
        if let Self::Turning(turning) = self { turning.felt(reduction, phase) } else { phase }
    }

    /// What the turns of a rotation's angle, and the mean that completes it, are rounded by, given what all else is wrong by.
    pub(crate) fn rounding_of_turns(&self, reduction: &Reduction, bound: &Bound) -> f64 {
        if let Self::Turning(turning) = self { turning.own_rounding(reduction, bound) } else { 0.0 }
    }
}

/// What is added to the angle of the latest passage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Turning {
    /// What is completed.
    pub(crate) start: Start,
    /// Whether the phase is that from the top, half a turn from the lowest points that turns are counted from.
    pub(crate) halfway: bool,
    /// Anchors per unit of the reduced phase.
    pub(crate) unit: Double,
    pub(crate) turns: Turns,
    /// The most that the angle changes by in an anchor, at the rate of the lowest point.
    pub(crate) slope: f64,
    /// −1 where θ decreases.
    pub(crate) direction: f64,
    /// The most turns within the horizon, of the mean rotation from the lowest point numbered 0.
    pub(crate) most_turns: f64,
}

/// Where the angle begins that is computed of the phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Start {
    /// The angle from the lowest point of the latest passage.
    Lowest,
    /// The periodic part of that from the top, of that size; 2π·phase completes it.
    Top(Size),
    /// If wrapped, as [`Self::Lowest`]; otherwise what 2π times the number of turns to the middle of a piece leaves.
    Piece,
}

/// What is done about the number of turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Turns {
    /// They are added.
    Counted,
    /// They are those of the mean rotation, which is added to what is periodic as one product with the time.
    Steady(Mean),
    /// They are left out, and one may have to be taken off, or added, beside the top.
    Modulo,
    /// They are left out, and the exact angle of the phase exceeds half a turn by at most so much.
    Within { beyond: f64 },
}

/// Below this the number of turns, or of pieces of a turn, is exact, halves included.
const EXACT_TURNS: f64 = two_to(52);

/// Below this the product of a number of turns, or halves of them, with 2π is exact.
const FEW_TURNS: f64 = 5.5;

impl Turning {
    fn lower(&self, b: &mut Builder, variables: &Variables, angle: Id) -> Id {
        if let Turns::Steady(mean) = self.turns {
            return mean.lower(b, angle);
        }
        let angle = self.completed(b, variables, angle);
        match self.turns {
            Turns::Modulo => modulo_turn(b, angle),
            Turns::Within { .. } => within_half_turn(b, angle),
            _ => self.with_turns(b, variables.count, angle),
        }
    }

    /// The angle from the lowest point, or left from the top to turns that are counted half-way.
    fn completed(&self, b: &mut Builder, variables: &Variables, angle: Id) -> Id {
        match (self.start, variables.side) {
            (Start::Lowest | Start::Piece, _) => angle,
            (Start::Top(_), Some(side)) => {
                // Uniform rotation from the lowest point is 2πz, without any half turn to be taken off.
                let opposite = b.constant(-1.0);
                let opposite = b.mul(opposite, variables.magnitude);
                let z = b.push(Op::Against { x: opposite, sign: side });
                let mean = self.mean(b, z);
                b.add(mean, angle)
            }
            (Start::Top(_), None) if self.turns != Turns::Counted => self.other_side(b, variables, angle),
            (Start::Top(_), None) => {
                let mean = self.mean(b, variables.distance);
                b.add(mean, angle)
            }
        }
    }

    /// The same in a cheaper way, where the truncation and the error of the phase leave enough of a limit for that. A wrapped
    /// angle is held within half a turn, beyond which it is not if it is from the top, else as far as phases overshoot:
    /// that is hardly ever met, and had better add little to the others. To another the mean rotation is added.
    pub(super) fn cheaper_if_good(
        self,
        reduction: &Reduction,
        mean: Mean,
        [truncation, phase]: [f64; 2],
        limit: f64,
    ) -> Self {
        const LITTLE: f64 = 0.25;
        let turns = match (self.turns, self.start) {
            (Turns::Modulo, Start::Top(_) | Start::Lowest) => {
                let beyond = if self.halfway { 0.0 } else { self.slope * reduction.overshoot.max(0.0) };
                Turns::Within { beyond }
            }
            (Turns::Counted, Start::Top(_)) if mean.is_normal() => Turns::Steady(mean),
            _ => return self,
        };
        let cheaper = Self { turns, ..self };
        let total = |turning: &Self| {
            let bound = Bound { truncation, phase: turning.felt(reduction, phase), evaluation: 0.0 };
            bound.total() + turning.own_rounding(reduction, &bound)
        };
        let [own, others] = [total(&self), total(&cheaper)];
        let is_little = matches!(turns, Turns::Steady(_)) || others - own <= LITTLE * (truncation + phase);
        if is_little && others <= limit { cheaper } else { self }
    }

    /// 2π·phase.
    fn mean(&self, b: &mut Builder, phase: Id) -> Id {
        let turn = b.rounded(self.turn());
        b.mul(phase, turn)
    }

    /// The angle from the lowest point, given the periodic part of that from the top: half a turn back, or forward
    /// before the top.
    fn other_side(&self, b: &mut Builder, variables: &Variables, angle: Id) -> Id {
        let zero = b.constant(0.0);
        let half = b.rounded(Double::PI);
        let minus = b.rounded(-Double::PI);
        // On the top itself the angle is −π, from either direction.
        let s = variables.distance;
        let (low, high) = if self.direction > 0.0 { (s, zero) } else { (zero, s) };
        let offset = b.push(Op::Select { a: low, b: high, then: half, otherwise: minus });
        let mean = self.mean(b, s);
        let angle = b.add(mean, angle);
        b.add(angle, offset)
    }

    /// 2πn + angle, or 2π(n − ½) + angle, with 2π in two words.
    fn with_turns(&self, b: &mut Builder, count: Id, angle: Id) -> Id {
        let float = b.float();
        let mut count = b.convert(count, Float::F64);
        if self.halfway {
            let half = b.constant(0.5);
            count = b.sub(count, half);
        }
        let angle = b.convert(angle, Float::F64);
        let turn = Double::PI * (2.0 * self.direction);
        let (high, low) = (b.constant(turn.hi), b.constant(turn.lo));
        let small = b.mul(count, low);
        let small = b.add(small, angle);
        let large = b.mul(count, high);
        let sum = b.add(large, small);
        b.convert(sum, float)
    }

    /// As [`Finish::felt`].
    fn felt(&self, reduction: &Reduction, phase: f64) -> f64 {
        match (self.turns, self.start) {
            (Turns::Steady(_), Start::Top(periodic)) => phase.min(periodic.phase_error(reduction)),
            _ => phase,
        }
    }

    /// What it rounds by. What holds an angle within half a turn leads away from no other than the exact ones beyond the
    /// numbers that it may be, and there no farther than from these: the exact angles of the phase before it is narrowed,
    /// which counts as the phase's error.
    fn own_rounding(&self, reduction: &Reduction, bound: &Bound) -> f64 {
        let error = bound.total();
        let completed = self.rounding_of_completion(reduction, error);
        match self.turns {
            Turns::Steady(mean) => mean.rounding(self.periodic() + error, reduction.float),
            Turns::Counted => completed + self.rounding_of_sums(reduction, error),
            Turns::Modulo => completed + rounding_modulo(reduction.float),
            Turns::Within { beyond } => {
                let evaluated = bound.truncation + bound.evaluation + completed;
                let held = beyond + beyond_largest_number(Double::PI, reduction.float);
                completed + (held - evaluated).max(0.0)
            }
        }
    }

    /// Of [`Self::with_turns`]: of the number of turns, the products with both words of 2π, the sum of the lesser one with
    /// the angle, the last sum, and its conversion to `f32`.
    fn rounding_of_sums(&self, reduction: &Reduction, error: f64) -> f64 {
        let float = reduction.float;
        let farthest = self.farthest(reduction);
        let count = (self.most_turns + farthest + reduction.overshoot.max(0.0)) * (1.0 + ROUNDED);
        // Beyond, it is a rounded sum of a multiple of 8, the others, and the first number; less a half it is rounded again.
        // Each counts 2π times.
        let exact = count * reduction.pieces < EXACT_TURNS - 0.5;
        let roundings = if self.halfway { 21.0 } else { 14.0 };
        let counted = if exact { 0.0 } else { roundings * half_ulp(count, Float::F64) };
        // 2π ends in three zeros: of few turns, and halves of them, products are exact.
        let few = !reduction.counts_pieces() && count < FEW_TURNS;
        let product = if few { 0.0 } else { half_ulp(TAU * count, Float::F64) };
        let lesser = count * Float::F64.rest(Double::TURN).abs();
        let sum = self.largest_angle(farthest, reduction) + lesser + error;
        let small = half_ulp(lesser, Float::F64) + half_ulp(sum, Float::F64);
        let largest = (TAU * self.most_turns + PI) * (1.0 + ROUNDED) + error;
        let converted = if float == Float::F32 { half_ulp(largest, float) } else { 0.0 };
        counted + product + small + half_ulp(largest, Float::F64) + converted
    }

    /// That of the angle that is made of its periodic part from the top: of the mean, up to half a turn, its constant and
    /// product, and the sum with it, in which no more than the periodic part is lost, of which what approximates it is no
    /// more than four times as large (above Lebesgue's constant of a hundred points); if wrapped, from the top itself half a
    /// turn, too, and the sum with that.
    fn rounding_of_completion(&self, reduction: &Reduction, error: f64) -> f64 {
        if !matches!(self.start, Start::Top(_)) {
            return 0.0;
        }
        let float = reduction.float;
        // Phases, in anchors, overshoot half a turn, as angles do; rounded.
        let farthest = (0.5 + reduction.overshoot.max(0.0)) * (1.0 + ROUNDED);
        let of_half_turn = self.largest_angle(0.5, reduction);
        let mean = half_ulp(of_half_turn, float) + farthest * float.rest(self.turn()).abs() / self.unit.hi;
        let sum = half_ulp(of_half_turn + error, float).min(4.0 * self.periodic());
        let half = match reduction.origin {
            Origin::Anchor if self.turns != Turns::Counted => {
                float.rest(Double::PI).abs() + half_ulp(of_half_turn + error, float)
            }
            _ => 0.0,
        };
        mean + sum + half
    }

    /// The largest angle of what is computed of the phase, where that is periodic.
    fn periodic(&self) -> f64 {
        if let Start::Top(periodic) = self.start { periodic.largest } else { 0.0 }
    }

    /// Bounds the angle of so many turns, and as much farther as phases overshoot.
    fn largest_angle(&self, turns: f64, reduction: &Reduction) -> f64 {
        (TAU * turns + self.slope * reduction.overshoot.max(0.0)) * (1.0 + ROUNDED)
    }

    /// How far angles are from 2π times the number that is counted, in turns: of the nearest lowest point, of the nearest
    /// top, or of the middle of a piece, where the periodic part leads up to half a turn away.
    fn farthest(&self, reduction: &Reduction) -> f64 {
        if self.start == Start::Piece { 0.5 + 0.5 / reduction.pieces } else { 0.5 }
    }

    /// A turn per unit of the phase.
    pub(super) fn turn(&self) -> Double {
        self.of_turns(self.unit)
    }

    /// So many turns.
    pub(super) fn of_turns(&self, turns: Double) -> Double {
        Double::PI * turns * (2.0 * self.direction)
    }
}

#[cfg(test)]
mod tests;
