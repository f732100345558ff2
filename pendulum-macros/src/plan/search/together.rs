//! θ and its velocity in one function, `state`.

use super::candidate::{Candidate, more};
use super::choice::Limits;
use super::prospect::{Prospect, Rejected};
use crate::parse::Output;
use crate::plan::Part;
use crate::plan::form::Variant;
use crate::plan::kernel::{self, Kernel};
use crate::plan::polynomial::Polynomial;
use crate::scene::Scene;

/// Operations at most that a velocity may cost more by itself for what it shares with θ.
const SHARED: f64 = 3.0;

/// What a call of the velocity alone counts beside one of both, which who lists both will want more often.
const ALONE: f64 = 0.75;

impl Candidate<'_> {
    /// The parts, of which the velocity may be another of its variants: one that costs little more by itself and less
    /// beside θ, with which it may share its variable and the powers of that.
    pub(super) fn together(&self, scene: &Scene, mut parts: Vec<Part>, rejected: &mut Vec<Rejected>) -> Vec<Part> {
        let place = |output| parts.iter().position(|part| part.output == output);
        let (Some(theta), Some(velocity)) = (place(Output::Theta), place(Output::Velocity)) else { return parts };
        self.share_exponential(scene, &mut parts, [theta, velocity]);
        let both = parts[theta].kernel.polynomial().and(parts[velocity].kernel.polynomial());
        let Some(found) = both else { return parts };
        let (parity, first) = (found.parity, found.variant());
        let cost = |part: &Part| self.cost_beside(&parts[theta], part);
        let before = cost(&parts[velocity]);
        let others = self.others(scene, velocity, first).map(|(other, part)| (cost(&part), other, part));
        let cheaper = others.filter(|(cost, ..)| *cost < before).min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((less, other, part)) = cheaper else { return parts };
        let output = Output::Velocity;
        rejected.retain(|one| (one.output, one.variant) != (output, other));
        let why = format!("beside `{}` it {}", Output::Theta.word(), more(before - less));
        rejected.push(Rejected { output, variant: first, parity, why });
        parts[velocity] = part;
        parts
    }

    /// Passages take the nearer of both exponentials, if it costs less that they have one.
    fn share_exponential(&self, scene: &Scene, parts: &mut [Part], [theta, velocity]: [usize; 2]) {
        let cost = |[theta, velocity]: [&Part; 2]| {
            let alone = kernel::function(self.reduction, &[&theta.kernel]).cost();
            self.cost_beside(theta, velocity) + ALONE * alone
        };
        let comfortable = Limits::of(scene.goal, self.reduction).comfortable;
        let with_that_of = |one: usize, other: usize| {
            let aim = &self.prospect.approximations[one].aim;
            let part = aim.with_exponential_of(self.reduction, &parts[one], &parts[other])?;
            (part.share <= parts[one].share.max(comfortable)).then_some(part)
        };
        let (Some(own), Some(others)) = (with_that_of(theta, velocity), with_that_of(velocity, theta)) else { return };
        if cost([&own, &others]) < cost([&parts[theta], &parts[velocity]]) {
            (parts[theta], parts[velocity]) = (own, others);
        }
    }

    /// What both cost in one function, and the velocity in one of its own.
    fn cost_beside(&self, theta: &Part, velocity: &Part) -> f64 {
        let waiting = velocity.kernel.polynomial().map_or(0.0, Polynomial::waiting);
        let cost = |kernels: &[&Kernel]| kernel::function(self.reduction, kernels).cost() + waiting;
        cost(&[&theta.kernel, &velocity.kernel]) + ALONE * cost(&[&velocity.kernel])
    }

    /// The output's variants that by themselves are little dearer than this one and keep the promise comfortably.
    fn others(&self, scene: &Scene, output: usize, first: Variant) -> impl Iterator<Item = (Variant, Part)> {
        let Prospect { task, approximations, .. } = self.prospect;
        let all = &approximations[output];
        let variants = all.variants(self.reduction);
        let cost = variants.iter().find(|(variant, _)| *variant == first).map_or(0.0, |(_, cost)| *cost);
        let near = variants.into_iter().filter(move |&(variant, other)| variant != first && other <= cost + SHARED);
        let most = Limits::of(scene.goal, self.reduction).comfortable;
        near.filter_map(move |(variant, _)| Some((variant, all.part(task, self.reduction, variant, most).ok()?)))
    }
}
