//! What becomes of an angle: that of a rotation is wrapped to [−π, π), or gets its turns.

use super::reduction::Reduction;
use super::variables::Variables;
use crate::parse::Float;
use crate::program::rounding::half_ulp;
use crate::program::{Builder, Id, Op};
use pendulum_runtime::double::Double;
use std::f64::consts::{PI, TAU};

/// What becomes of what is computed of the phase.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Finish {
    Nothing,
    /// The angle of a rotation is completed.
    Turning(Turning),
    /// An angle near the top is kept within [−π, π).
    Within,
    /// One that may be up to a turn beyond that is wrapped.
    Wrapped,
}

impl Finish {
    /// Emits it.
    pub(super) fn lower(&self, b: &mut Builder, variables: &Variables, values: Vec<Id>) -> Vec<Id> {
        match self {
            Self::Nothing => values,
            Self::Turning(turning) => vec![turning.lower(b, variables, values[0])],
            Self::Within => vec![within_half_turn(b, values[0])],
            Self::Wrapped => vec![modulo_turn(b, values[0])],
        }
    }

    /// What it rounds by, without turns.
    pub(super) fn rounding(&self, float: Float) -> f64 {
        match self {
            Self::Nothing | Self::Turning(_) => 0.0,
            Self::Within => rounding_within(float),
            Self::Wrapped => rounding_modulo(float),
        }
    }

    /// What the turns of a rotation's angle, and the mean that completes it, are rounded by.
    pub(crate) fn rounding_of_turns(&self, reduction: &Reduction) -> f64 {
        if let Self::Turning(turning) = self { turning.own_rounding(reduction) } else { 0.0 }
    }
}

/// What is added to the angle of the latest passage.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Turning {
    /// Whether the angle is the periodic part of that from the top, which 2π·phase completes, not that from the lowest
    /// point.
    pub(crate) from_top: bool,
    /// Anchors per unit of the reduced phase.
    pub(crate) unit: Double,
    /// Whether the result is wrapped; otherwise the turns are added.
    pub(crate) wrapped: bool,
    /// −1 where θ decreases.
    pub(crate) direction: f64,
    /// The most turns within the horizon.
    pub(crate) turns: f64,
}

/// Below this, 2⁵², the number of turns is exact, halves of them included.
const EXACT_TURNS: f64 = (1_u64 << 52) as f64;

impl Turning {
    fn lower(&self, b: &mut Builder, variables: &Variables, angle: Id) -> Id {
        let angle = match (self.from_top, variables.side) {
            (false, _) => angle,
            (true, Some(side)) => {
                // Uniform rotation from the lowest point is 2πz, without any half turn to be taken off.
                let opposite = b.constant(-1.0);
                let opposite = b.mul(opposite, variables.magnitude);
                let z = b.push(Op::Against { x: opposite, sign: side });
                let mean = self.mean(b, z);
                b.add(mean, angle)
            }
            (true, None) if self.wrapped => self.other_side(b, variables, angle),
            (true, None) => {
                let mean = self.mean(b, variables.distance);
                let angle = b.add(mean, angle);
                let half = b.exact(Double::PI.scale(self.direction));
                b.sub(angle, half)
            }
        };
        if self.wrapped { modulo_turn(b, angle) } else { self.with_turns(b, variables.count, angle) }
    }

    /// 2π·phase.
    fn mean(&self, b: &mut Builder, phase: Id) -> Id {
        let turn = Double::PI * self.unit * (2.0 * self.direction);
        let turn = b.exact(turn);
        b.mul(phase, turn)
    }

    /// The angle from the lowest point, given the periodic part of that from the top: half a turn back, or forward
    /// before the top.
    fn other_side(&self, b: &mut Builder, variables: &Variables, angle: Id) -> Id {
        let zero = b.constant(0.0);
        let half = b.exact(Double::PI);
        let minus = b.exact(-Double::PI);
        // On the top itself the angle is −π, from either direction.
        let s = variables.distance;
        let (low, high) = if self.direction > 0.0 { (s, zero) } else { (zero, s) };
        let offset = b.push(Op::Select { a: low, b: high, then: half, otherwise: minus });
        let mean = self.mean(b, s);
        let angle = b.add(mean, angle);
        b.add(angle, offset)
    }

    /// 2πn + angle, with 2π in two words.
    fn with_turns(&self, b: &mut Builder, count: Id, angle: Id) -> Id {
        let float = b.float();
        let count = b.convert(count, Float::F64);
        let angle = b.convert(angle, Float::F64);
        let turn = Double::PI * (2.0 * self.direction);
        let (high, low) = (b.constant(turn.hi), b.constant(turn.lo));
        let small = b.mul(count, low);
        let small = b.add(small, angle);
        let large = b.mul(count, high);
        let sum = b.add(large, small);
        b.convert(sum, float)
    }

    /// The rounding of the sums: half an ulp of the largest values.
    fn own_rounding(&self, reduction: &Reduction) -> f64 {
        let float = reduction.float;
        if self.wrapped {
            // The mean and its constant, two sums, a turn, and the distance from π of the largest number below it.
            return 7.0 * half_ulp(3.2, float);
        }
        // The mean and its constant, the sum with it, π's constant and the sum with that; the product of the turns with
        // the first word of 2π, and the last sum. At last the conversion to `f32`; in `f64`, which needs none, as much is
        // more than the product with the second word and its sum are rounded by.
        let largest = 7.0 * (self.turns + 1.0);
        // So many are a rounded sum of a multiple of 8, the others, and the first number.
        let counted = if self.turns < EXACT_TURNS { 0.0 } else { 14.0 * half_ulp(self.turns + 1.0, Float::F64) };
        let sums = 5.0 * half_ulp(6.3, float) + 2.0 * half_ulp(largest, Float::F64) + counted;
        sums + half_ulp(largest, float)
    }
}

/// Less a turn, or more one, to be within [−π, π): beside the top the phase may have been counted from the turn before
/// or after.
fn modulo_turn(b: &mut Builder, angle: Id) -> Id {
    let (half, minus) = (b.constant(PI), b.constant(-PI));
    let turn = Double::PI * 2.0;
    let turn = b.exact(turn);
    let back = b.sub(angle, turn);
    let angle = b.push(Op::Select { a: angle, b: half, then: angle, otherwise: back });
    b.name(angle, "angle");
    let forth = b.add(angle, turn);
    let angle = b.push(Op::Select { a: angle, b: minus, then: forth, otherwise: angle });
    b.name(angle, "angle");
    // Rounding may put it on the wrong end.
    let most = below_half_turn(b.float());
    between(b, angle, if b.float() == Float::F64 { -PI } else { -most }, most)
}

/// What [`modulo_turn`] rounds by: the sum with a turn, the turn's own rounding, and the distance from π of the largest
/// number below it.
fn rounding_modulo(float: Float) -> f64 {
    3.0 * half_ulp(TAU, float)
}

/// What [`within_half_turn`] changes: from the largest number that it may be to π itself it is 0.63 units of π in `f32`,
/// 1.27 in `f64`; less than this and the rounding of the angle's own last sum, half a unit.
fn rounding_within(float: Float) -> f64 {
    2.0 * half_ulp(PI, float)
}

/// The nearest number from above −π to below π: of mirror images the same.
fn within_half_turn(b: &mut Builder, angle: Id) -> Id {
    let most = below_half_turn(b.float());
    between(b, angle, -most, most)
}

/// The largest number below the `PI` of `f64`, so that results are less than π as users write it, too.
fn below_half_turn(float: Float) -> f64 {
    match float {
        Float::F64 => PI.next_down(),
        Float::F32 => f64::from(std::f32::consts::PI.next_down()),
    }
}

/// Whether an angle is in [−π, π), of either type: `f32`'s π is above that of `f64`.
#[cfg(test)]
pub(crate) fn is_wrapped(angle: f64) -> bool {
    (-PI..PI).contains(&angle)
}

fn between(b: &mut Builder, angle: Id, least: f64, most: f64) -> Id {
    let (most, least) = (b.constant(most), b.constant(least));
    let angle = b.push(Op::Min { limit: most, x: angle });
    b.name(angle, "angle");
    b.push(Op::Max { limit: least, x: angle })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Regime;
    use crate::plan::tests::scene;
    use crate::plan::{Plan, plan};
    use std::f64::consts::PI;

    fn rotation(text: &str) -> (Turning, Plan) {
        let plan = plan(&scene(&format!("struct Motion; velocity0 = 3, {text}"))).unwrap();
        let Finish::Turning(turning) = &plan.parts[0].kernel.finish else { panic!("{text}: no turning angle") };
        (turning.clone(), plan)
    }

    /// Half units in the last place: 2⁻⁵¹ up to 6.3 (2⁻²² in `f32`), 2⁻⁵² up to 3.2; of 7·1001 = 7007 they are 2⁻⁴¹ and
    /// 2⁻¹².
    #[test]
    fn rounding_of_turns() {
        for (text, expected) in [
            ("tol = 1e-6, t_max = 10, float = f64", 5.0 * 2f64.powi(-51) + 3.0 * 2f64.powi(-41)),
            ("tol = 1e-2, t_max = 10, float = f32", 5.0 * 2f64.powi(-22) + 2.0 * 2f64.powi(-41) + 2f64.powi(-12)),
            ("tol = 1e-6, t_max = 10, outputs = [wrapped]", 7.0 * 2f64.powi(-52)),
        ] {
            let (turning, plan) = rotation(text);
            let turning = Turning { turns: 1000.0, ..turning };
            assert_eq!(turning.own_rounding(&plan.reduction), expected, "{text}");
        }
    }

    /// After so many turns, whole ones and halves, it is 2π times their number, in every way of computing it.
    #[test]
    fn turns_are_counted() {
        for (text, direction) in [("velocity0 = 2.5", 1.0), ("velocity0 = -2.5", -1.0), ("velocity0 = -2.01", -1.0)] {
            let scene = scene(&format!("struct Motion; {text}, tol = 1e-6, t_max = 1e4"));
            let Regime::Rotation(rotation) = &scene.motion.regime else { panic!("a rotation") };
            let plans = crate::plan::search::every(&scene);
            assert!(plans.len() > 4);
            let between = |plan: &Plan| plan.functions[0].program.run(0.2 * rotation.period.to_f64())[0];
            let first = between(&plans[0]);
            for plan in plans {
                assert!((between(&plan) - first).abs() <= 2.1e-6, "{text}: {}", plan.reduction.describe());
                for turns in [0.0, 0.5, -0.5, 1.0, -1.0, 1.5, 3.0, 1000.0, -1000.5] {
                    let t = turns * rotation.period.to_f64();
                    let error = plan.functions[0].program.run(t)[0] - direction * turns * 2.0 * PI;
                    assert!(error.abs() <= 1.1e-6, "{text} {turns}: {error}, {}", plan.reduction.describe());
                }
            }
        }
    }

    /// Motions that come closer to the top than their errors are.
    #[test]
    fn angles_of_swings_stay_within_half_a_turn() {
        for (text, times) in [
            ("theta0 = π - 0.0000000082218, tol = 0.00249, float = f32", [0.0, 1.0]),
            ("theta0 = π - 0.0000018052, omega = 0.1, tol = 0.000227", [0.0, 588.461_959_353_386_5]),
            ("theta0 = π - 2e-9, float = f32", [0.0, 0.5]),
            ("theta0 = 2e-9 - π, tol = 1e-3, t_max = 40", [0.0, -1.0]),
            ("velocity0 = 2, tol = 1e-3", [40.0, -1e300]),
            ("theta0 = π - 3.8190685071550958e-6, tol = 0.000025, t_max = 6.1e9", [0.0, 1.0]),
        ] {
            let plan = plan(&scene(&format!("struct Motion; {text}, outputs = [wrapped]"))).unwrap();
            for t in times {
                let angle = plan.functions[0].program.run(t)[0];
                assert!(is_wrapped(angle) && angle.abs() > 3.1, "{text}: {angle}");
                let mirrored = text.replace("0 = ", "0 = -(").replacen(',', "),", 1);
                let mirrored = self::plan(&scene(&format!("struct Motion; {mirrored}, outputs = [wrapped]"))).unwrap();
                assert_eq!(mirrored.functions[0].program.run(t)[0], -angle, "{text}");
            }
        }
    }
}
