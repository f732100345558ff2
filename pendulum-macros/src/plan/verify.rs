//! The planner checks its own promise: a plan of polynomials, in pieces or not, or of a passage of a swing or a rotation,
//! is interpreted at a few times and compared with the exact curves. Those of the paper's formulas and of the separatrix
//! are not.
//!
//! The bound is proven, but a proof is only as good as the program that computes it. Should a value ever be outside,
//! the macro refuses rather than emit a promise that it has just seen broken.

use super::aim::Aim;
use super::task::Task;
use super::{Part, Plan};
use crate::exact::Real;
use crate::parse::Output;
use crate::power::two_to;
use crate::program::rounding::UNDERFLOW;
use crate::scene::Scene;
use pendulum_runtime::double::Double;
use std::f64::consts::TAU;

/// Times at which a plan is checked, in half anchors from t = 0, so that they meet anchors and lowest points of swings
/// released from rest, and places between; of an arc both ends.
const PROBES: [f64; 7] = [0.0, 0.37, 1.0, 1.62, 2.9, -0.93, -1.0];

/// The same in parts of the horizon, at whose ends phases are most wrong and products largest.
const FAR_PROBES: [f64; 3] = [1.0, -1.0, 0.8671];

/// The first output seen outside its bound.
pub(super) fn broken(scene: &Scene, task: &Task, plan: &Plan) -> Option<Output> {
    let context = task.rate.context();
    let horizon = scene.horizon();
    let near = PROBES.map(|probe| (probe / (2.0 * task.rate.to_f64())).clamp(-horizon, horizon));
    let far = FAR_PROBES.map(|probe| probe * horizon);
    let probe = |t: f64| -> Option<Output> {
        let most = scene.float.round_down(horizon);
        let t = scene.float.round(t).clamp(-most, most);
        let phase = &task.rate * &context.float(t)? + &task.launch;
        let number = phase.round();
        let odd = !(number.scale(-1) - number.scale(-1).round()).is_zero();
        let s = (&phase - &number).to_double();
        let broken = |((aim, part), function): ((&Aim, &Part), &super::Function)| {
            let values = function.program.run(t);
            let error = aim.distance(task, s, &number, odd, &values)?;
            // The curves themselves are good to 2⁻⁷⁵ of the largest value, and where that underflows, being sums of up to
            // a thousand terms, to this.
            let most = part.bound.total() + part.largest * two_to(-70) + 16.0 * UNDERFLOW;
            (error.is_nan() || error > most).then_some(part.output)
        };
        let differs = || (!both_alike(plan, t)).then_some(Output::Theta);
        task.aims.iter().zip(&plan.parts).zip(&plan.functions).find_map(broken).or_else(differs)
    };
    near.into_iter().chain(far).find_map(probe)
}

/// Whether the function of θ and velocity, if there is one, gives what the functions of either give: to the bit, but
/// for the sign of a zero.
fn both_alike(plan: &Plan, t: f64) -> bool {
    let values = |output: Option<Output>| {
        let function = plan.functions.iter().find(|function| function.output == output);
        function.map(|function| function.program.run(t))
    };
    let both = values(None).into_iter().flatten();
    let each = [Output::Theta, Output::Velocity].into_iter().filter_map(|output| values(Some(output))).flatten();
    both.zip(each).all(|(one, other)| one == other)
}

impl Aim {
    /// How far `values` are from the output at the phase s from an anchor; `None` where there are no curves, or nothing is
    /// known of them since their sums overflow.
    fn distance(&self, task: &Task, s: Double, number: &Real, odd: bool, values: &[f64]) -> Option<f64> {
        let sign = |alternates: bool| if alternates && odd { -1.0 } else { 1.0 };
        match self.curves.as_slice() {
            curves if curves.iter().any(|curve| curve.omitted().is_infinite()) => None,
            // From the top numbered 0, half a turn before the lowest point; the curve is what it has beside uniform turns.
            [curve] if task.turns_over() && self.output.is_angle() => {
                let exact = curve.at(s) + (s - Double::new(0.5)) * Double::TURN;
                let context = number.context();
                let [value, high, low] = [values[0] * task.direction, exact.hi, exact.lo].map(|x| context.float(x));
                let turn = context.pi().scale(1);
                let apart = (value? - high? - low?) / &turn - number;
                let whole = if self.output == Output::Wrapped { apart.round() } else { context.integer(0) };
                Some(((apart - whole) * turn).abs().to_f64())
            }
            [curve] => {
                let exact = curve.at(s) * (sign(curve.alternates) * task.direction);
                let apart = Double::new(values[0]) - exact;
                let turns = if self.output == Output::Wrapped { (apart.hi / TAU).round() } else { 0.0 };
                Some((apart - Double::PI * (2.0 * turns)).hi.abs())
            }
            [sine, cosine] => {
                let (sine, cosine) = (sine.at(s) * sign(sine.alternates), cosine.at(s));
                let x = Double::new(values[0]) - sine * cosine * (2.0 * task.direction);
                let y = Double::new(values[1]) - (sine * sine - cosine * cosine);
                Some((x.hi * x.hi + y.hi * y.hi).sqrt())
            }
            _ => None,
        }
    }
}
