//! Where an interpreted plan is tried against the exact motion in multiple precision, for tests.

use super::truth::{State, distance};
use crate::plan::turning::is_wrapped;
use crate::plan::*;
use crate::testing::{Random, scene};
use std::slice;

/// Where a plan is tried.
pub(crate) struct Probe<'a> {
    scene: &'a Scene,
    pub(in crate::plan) program: &'a Program,
    output: Output,
    /// Time between two turning points, or two passages over the top.
    pub(in crate::plan) step: f64,
    /// The time of the first anchor.
    pub(in crate::plan) first: f64,
    pub(in crate::plan) horizon: f64,
    pub(crate) bound: f64,
    pub(crate) worst: (f64, f64),
}

impl<'a> Probe<'a> {
    pub(in crate::plan) fn new(scene: &'a Scene, plan: &'a Plan) -> Self {
        Self::of(scene, plan, 0)
    }

    /// Of one of the outputs.
    pub(crate) fn of(scene: &'a Scene, plan: &'a Plan, output: usize) -> Self {
        let (step, launch) = match &scene.motion.regime {
            Regime::Swing(swing) => (swing.period.to_f64() / 2.0, swing.launch.to_f64()),
            Regime::Rotation(rotation) => (rotation.period.to_f64(), rotation.launch.to_f64() + 0.5),
            Regime::Separatrix(separatrix) => {
                let step = (5.0 / scene.motion.omega.to_f64()).min(f64::MAX / 8.0);
                (step, separatrix.launch.to_f64() / 5.0)
            }
        };
        let periods = if matches!(scene.motion.regime, Regime::Rotation(_)) { 53 } else { 54 };
        let unlimited = 2f64.powi(periods) * step;
        let horizon = scene.t_max.as_ref().map_or(unlimited, Real::to_f64).min(scene.float.largest());
        let (program, part) = (&plan.functions[output].program, &plan.parts[output]);
        Self {
            scene,
            program,
            output: part.output,
            step,
            first: -launch * step,
            horizon,
            bound: part.bound.total() * (1.0 + 1e-9),
            worst: (0.0, 0.0),
        }
    }

    /// The error at the time that is met nearest to `t`.
    pub(in crate::plan) fn at(&mut self, t: f64) -> f64 {
        let t = self.met(t);
        self.compare(t, &State::at(&self.scene.motion, t))
    }

    /// The time of the scene's type within the horizon that is nearest to `t`.
    pub(crate) fn met(&self, t: f64) -> f64 {
        let most = self.scene.float.round_down(self.horizon);
        self.scene.float.round(t).clamp(-most, most)
    }

    pub(crate) fn compare(&mut self, t: f64, state: &State) -> f64 {
        let exact = state.output(self.output);
        let values = self.program.run(t);
        let context = self.scene.motion.omega.context();
        let mut error = distance(context, &values, &exact);
        if self.output == Output::Wrapped {
            // At the top π and −π are one angle.
            assert!(is_wrapped(values[0]), "{t}: {values:?}");
            let turn = context.pi().scale(1);
            let others = [&exact[0] + &turn, &exact[0] - &turn];
            error = others.iter().map(|other| distance(context, &values, slice::from_ref(other))).fold(error, f64::min);
        }
        if error > self.worst.1 {
            self.worst = (t, error);
        }
        error
    }

    /// At `count` phases of the anchor nearest to `t`, of which ½ and −½, and where the error was largest finer.
    fn anchor(&mut self, t: f64, count: usize) {
        let anchor = self.first + ((t - self.first) / self.step).round() * self.step;
        let step = self.step;
        let at = |index: f64| anchor + (index / count as f64 - 0.5) * step;
        let errors: Vec<f64> = (0..=count).map(|index| self.at(at(index as f64))).collect();
        let place = |index: usize| errors[index] * (1.0 - index as f64 * 1e-9);
        let peak = (0..=count).max_by(|&a, &b| place(a).total_cmp(&place(b))).unwrap_or(0);
        for fraction in [-0.6, -0.3, -0.1, 0.1, 0.3, 0.6] {
            self.at(at(peak as f64 + fraction));
        }
    }

    /// Everywhere that is known to be bad, and at random.
    pub(in crate::plan) fn everywhere(&mut self, random: &mut Random, density: usize) {
        let horizon = self.horizon;
        for t in [0.0, self.first, horizon, -horizon, horizon * (2.0 * random.unit() - 1.0)] {
            self.anchor(t, density);
        }
        for t in self.here_and_there(random, density) {
            self.at(t);
        }
    }

    /// Three times for each of a count: anywhere, about the first anchors, and at the ends, where the phase is most wrong, as
    /// the motion is fastest.
    pub(crate) fn here_and_there(&self, random: &mut Random, count: usize) -> Vec<f64> {
        let &Self { step, horizon, first, .. } = self;
        let times = |_| {
            let (anywhere, early) = (horizon * (2.0 * random.unit() - 1.0), step * (4.0 * random.unit() - 2.0));
            let end = random.choose(&[1.0, -1.0]) * horizon * (1.0 - 0.01 * random.unit());
            let lowest = first + (((end - first) / step).floor() + 0.5) * step;
            [anywhere, early, lowest + step * 0.02 * (random.unit() - 0.5)]
        };
        (0..count).flat_map(times).collect()
    }
}

/// The largest error found of a plan, which is within its bound.
pub(in crate::plan) fn largest_error(
    text: &str,
    scene: &Scene,
    plan: &Plan,
    random: &mut Random,
    density: usize,
) -> f64 {
    let mut probe = Probe::new(scene, plan);
    probe.everywhere(random, density);
    let part = &plan.parts[0];
    let (t, error) = probe.worst;
    let bound = part.bound.total();
    assert!(error <= bound, "{text}: {error:e} at t = {t:e}, bound {bound:e} ({:?}), {}", part.bound, part.description);
    error
}

/// So many parts of a horizon to either side, its ends among them.
pub(in crate::plan) fn evenly(count: i32) -> impl Iterator<Item = f64> {
    (-count..=count).map(move |i| f64::from(i) / f64::from(count))
}

/// At these parts of the horizon the error is within its bound, which is at most `most` times the largest.
pub(in crate::plan) fn assert_tight(text: &str, most: f64, parts: impl Iterator<Item = f64>) {
    let scene = scene(text);
    let plan = plan(&scene).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
    let mut probe = Probe::new(&scene, &plan);
    for part in parts {
        probe.at(probe.horizon * part);
    }
    let ((t, seen), part) = (probe.worst, &plan.parts[0]);
    let bound = part.bound.total();
    let tight = seen <= bound && bound <= most * seen;
    assert!(tight, "{text}: {seen:e} of {bound:e} at t = {t:e}, {}", part.description);
}
