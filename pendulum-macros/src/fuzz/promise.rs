//! Whether a plan keeps what it promises.

use crate::plan::tests::{probe::Probe, truth::State};
use crate::plan::{Part, Plan};
use crate::scene::{Goal, Scene};
use crate::testing::Random;
use std::hash::{DefaultHasher, Hash, Hasher};

/// Of its bounds, and at a few times that the text of the invocation settles.
pub(super) fn promise_is_kept(scene: &Scene, plan: &Plan, text: &str) -> Result<(), String> {
    let mut hasher = DefaultHasher::new();
    text.hash(&mut hasher);
    let mut random = Random::new(hasher.finish());
    let mut probes: Vec<Probe> = (0..plan.parts.len()).map(|output| Probe::of(scene, plan, output)).collect();
    for t in probes[0].here_and_there(&mut random, 3) {
        let t = probes[0].met(t);
        let state = State::at(&scene.motion, t);
        for (part, probe) in plan.parts.iter().zip(&mut probes) {
            let error = probe.compare(t, &state);
            if error > probe.bound {
                return Err(format!("{:?} is {error:e} off at t = {t:e}, bound {:?}", part.output, part.bound));
            }
        }
    }
    plan.parts.iter().try_for_each(|part| bound_is_stated(scene, part))
}

/// A bound has finite parts, is no more than what is stated, and that no more than what was asked for.
fn bound_is_stated(scene: &Scene, part: &Part) -> Result<(), String> {
    let bound = part.bound;
    let parts = [bound.truncation, bound.phase, bound.evaluation];
    if parts.iter().any(|part| !(part.is_finite() && *part >= 0.0)) || bound.total() <= 0.0 {
        return Err(format!("the bound of {:?} is {bound:?}", part.output));
    }
    let stated = scene.float.round_up(part.error());
    if stated * part.unit * (1.0 + 1e-12) < bound.total() {
        return Err(format!("{:?} promises {stated:e}, less than {bound:?}", part.output));
    }
    match scene.goal {
        Goal::Tolerance(tol) if stated > tol => {
            Err(format!("{:?} promises {stated:e} where {tol:e} was asked", part.output))
        }
        _ => Ok(()),
    }
}
