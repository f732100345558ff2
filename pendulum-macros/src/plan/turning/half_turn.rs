//! Keeping angles within half a turn, [−π, π).

use crate::parse::Float;
use crate::power::two_to;
use crate::program::rounding::half_ulp;
use crate::program::{Builder, Id, Op};
use pendulum_runtime::double::Double;
use std::f64::consts::PI;

/// An arc that leads no farther beyond π counts as at the top: some more than a curve in two words is wrong by.
pub(in crate::plan) const AT_TOP: f64 = PI * two_to(-70);

/// Less a turn, or more one, to be within [−π, π): beside the top the phase may have been counted from the turn before
/// or after. Both differences are exact, and never are both taken.
pub(super) fn modulo_turn(b: &mut Builder, angle: Id) -> Id {
    let (half, minus) = (b.constant(PI), b.constant(-PI));
    let turn = b.rounded(Double::TURN);
    let back = b.sub(angle, turn);
    let angle = b.push(Op::Select { a: angle, b: half, then: angle, otherwise: back });
    b.name(angle, "angle");
    let forth = b.add(angle, turn);
    let angle = b.push(Op::Select { a: angle, b: minus, then: forth, otherwise: angle });
    b.name(angle, "angle");
    match b.float() {
        Float::F64 => angle,
        Float::F32 => {
            let least = b.constant(least_half_turn(Float::F32));
            b.push(Op::Max { limit: least, x: angle })
        }
    }
}

/// What [`modulo_turn`] changes: by what a turn is rounded, or from −`PI` of `f32` to the next number, an ulp.
pub(super) fn rounding_modulo(float: Float) -> f64 {
    let turn = float.rest(Double::TURN).abs();
    if float == Float::F64 { turn } else { turn.max(2.0 * half_ulp(PI, float)) }
}

/// The nearest number in that interval.
pub(super) fn held(b: &mut Builder, angle: Id, [least, most]: [f64; 2]) -> Id {
    let (most, least) = (b.constant(most), b.constant(least));
    let angle = b.push(Op::Min { limit: most, x: angle });
    b.name(angle, "angle");
    b.push(Op::Max { limit: least, x: angle })
}

/// The nearest number in [−π, π).
pub(super) fn within_half_turn(b: &mut Builder, angle: Id) -> Id {
    let (least, most) = (least_half_turn(b.float()), below_half_turn(b.float()));
    held(b, angle, [least, most])
}

/// The largest number below the `PI` of `f64`, so that results are less than π as users write it, too.
pub(super) fn below_half_turn(float: Float) -> f64 {
    match float {
        Float::F64 => PI.next_down(),
        Float::F32 => f64::from(std::f32::consts::PI.next_down()),
    }
}

/// The least number in [−π, π): the `PI` of `f32` is above π.
fn least_half_turn(float: Float) -> f64 {
    if float == Float::F64 { -PI } else { -below_half_turn(float) }
}

/// By how much an angle, which is no farther beyond π than [`AT_TOP`], exceeds the largest number that it may become.
pub(super) fn beyond_largest_number(angle: Double, float: Float) -> f64 {
    let most = Double::new(below_half_turn(float));
    let [by, to_top] = [angle, Double::PI].map(|angle| (angle - most).hi + AT_TOP);
    by.clamp(0.0, to_top)
}

/// Whether an angle is in [−π, π), of either type: `f32`'s π is above that of `f64`.
#[cfg(test)]
pub(crate) fn is_wrapped(angle: f64) -> bool {
    (-PI..PI).contains(&angle)
}
