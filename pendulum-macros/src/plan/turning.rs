//! The angle of a rotation: wrapped to [−π, π), or with its turns.

use super::kernel::Kernel;
use super::reduction::Reduction;
use super::variables::Variables;
use crate::parse::Float;
use crate::program::rounding::half_ulp;
use crate::program::{Builder, Id, Op};
use pendulum_runtime::double::Double;

/// What is added to the angle of the latest passage.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Turning {
    /// The angle from the lowest point, or from the top (`from_top`).
    pub(crate) angle: Box<Kernel>,
    pub(crate) from_top: bool,
    /// Whether the result is wrapped; otherwise the turns are added.
    pub(crate) wrapped: bool,
    /// −1 where θ decreases.
    pub(crate) direction: f64,
    /// The most turns within the horizon.
    pub(crate) turns: f64,
}

impl Turning {
    pub(super) fn lower(&self, b: &mut Builder, variables: &Variables, name: &'static str) -> Id {
        let angle = self.angle.lower(b, variables, name)[0];
        if self.wrapped {
            let angle = if self.from_top { self.other_side(b, variables, angle) } else { angle };
            return within_half_turn(b, angle);
        }
        let angle = if self.from_top {
            let half = b.exact(self.direction * Double::PI.hi, self.direction * Double::PI.lo);
            b.sub(angle, half)
        } else {
            angle
        };
        self.with_turns(b, variables.count, angle)
    }

    /// The angle from the lowest point, given that from the top: half a turn back, or forward before the top.
    fn other_side(&self, b: &mut Builder, variables: &Variables, angle: Id) -> Id {
        let zero = b.constant(0.0);
        let half = b.exact(Double::PI.hi, Double::PI.lo);
        let minus = b.exact(-Double::PI.hi, -Double::PI.lo);
        // On the top itself the angle is −π, from either direction.
        let s = variables.distance;
        let offset = if self.direction > 0.0 {
            b.push(Op::Select { a: s, b: zero, then: half, otherwise: minus })
        } else {
            b.push(Op::Select { a: zero, b: s, then: half, otherwise: minus })
        };
        b.add(angle, offset)
    }

    /// 2πn + angle, with 2π in two words.
    fn with_turns(&self, b: &mut Builder, count: Id, angle: Id) -> Id {
        let float = b.float();
        let count = b.convert(count, Float::F64);
        let angle = b.convert(angle, Float::F64);
        let turn = Double::PI * (2.0 * self.direction);
        let (high, low) = (b.exact(turn.hi, 0.0), b.exact(turn.lo, 0.0));
        let small = b.mul(count, low);
        let small = b.add(small, angle);
        let large = b.mul(count, high);
        let sum = b.add(large, small);
        b.convert(sum, float)
    }

    /// The rounding of the sums: half an ulp of the largest values.
    pub(super) fn own_rounding(&self, reduction: &Reduction) -> f64 {
        let float = reduction.float;
        if self.wrapped {
            // One sum, and the distance from π of the largest number below it.
            return 3.0 * half_ulp(3.2, float);
        }
        let largest = 7.0 * (self.turns + 1.0);
        let sums = 3.0 * half_ulp(6.3, float) + 2.0 * half_ulp(largest, Float::F64);
        sums + half_ulp(largest, float)
    }
}

/// Within [−π, π), of which rounding may have put the angle on the wrong end.
fn within_half_turn(b: &mut Builder, angle: Id) -> Id {
    let (most, least) = match b.float() {
        Float::F64 => (std::f64::consts::PI.next_down(), -std::f64::consts::PI),
        Float::F32 => {
            let below = f64::from(std::f32::consts::PI.next_down());
            (below, -below)
        }
    };
    let (most, least) = (b.constant(most), b.constant(least));
    let angle = b.push(Op::Min { limit: most, x: angle });
    b.push(Op::Max { limit: least, x: angle })
}
