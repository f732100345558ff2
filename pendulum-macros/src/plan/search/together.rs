//! θ and its velocity in one function, `state`.

use super::Candidate;
use crate::parse::Output;
use crate::plan::Part;
use crate::plan::aim::Aim;
use crate::plan::kernel::{self, Kernel};
use crate::plan::part::{Approximations, Variant};
use crate::plan::polynomial::Polynomial;
use crate::scene::Scene;

/// Operations at most that a velocity may cost more by itself for what it shares with θ.
const SHARED: f64 = 3.0;

/// Operations that it saves if both polynomials are of one form: in scalar calls at 7π/8 a tenth of the time to 1e-9, a
/// quarter to 1e-12; in loops over arrays nothing.
const PAIRED: f64 = 3.0;

impl Candidate<'_> {
    /// The parts, of which the velocity may be another of its variants: one that costs little more by itself and less
    /// beside θ, with which it may share its variable and the powers of that. Where two polynomials are alike, compilers
    /// compute them in the lanes of one vector, besides.
    pub(super) fn together(&self, scene: &Scene, mut parts: Vec<Part>, rejected: &mut Vec<String>) -> Vec<Part> {
        let place = |output| parts.iter().position(|part| part.output == output);
        let (Some(theta), Some(velocity)) = (place(Output::Theta), place(Output::Velocity)) else { return parts };
        let cost = |part: &Part| self.beside(&parts[theta], part);
        let Some((found, _)) = polynomial(&parts[velocity]).zip(polynomial(&parts[theta])) else { return parts };
        let parity = found.parity;
        let (first, before) = (found.variant(), cost(&parts[velocity]));
        let (aim, all) = (&self.prospect.task.aims[velocity], &self.prospect.approximations[velocity]);
        let others = self.others(aim, all, first).into_iter();
        let kept = others.filter_map(|other| Some((other, self.kept(scene, aim, all, other)?)));
        let costs = kept.map(|(other, part)| (cost(&part), other, part)).filter(|(cost, ..)| *cost < before);
        let Some((less, other, part)) = costs.min_by(|a, b| a.0.total_cmp(&b.0)) else { return parts };
        let name = format!("{} for `{}`: ", other.describe(parity), Output::Velocity.word());
        rejected.retain(|line| !line.starts_with(&name));
        rejected.push(format!(
            "{} for `{}`: beside `{}` it costs about {:.1} operations more",
            first.describe(parity),
            Output::Velocity.word(),
            Output::Theta.word(),
            before - less
        ));
        parts[velocity] = part;
        parts
    }

    /// What both cost in one function, and three quarters of what the velocity costs in one of its own.
    fn beside(&self, theta: &Part, velocity: &Part) -> f64 {
        let cost = |kernels: &[&Kernel]| kernel::function(self.reduction, kernels).cost();
        let waiting = polynomial(velocity).map_or(0.0, |found| found.form.waiting(found.terms()));
        let form = |part| polynomial(part).map(|found| found.form);
        let paired = if form(theta) == form(velocity) { PAIRED } else { 0.0 };
        cost(&[&theta.kernel, &velocity.kernel]) + 0.75 * cost(&[&velocity.kernel]) + 1.75 * waiting - paired
    }

    /// The variants that by themselves are little dearer than this one.
    fn others(&self, aim: &Aim, all: &Approximations, first: Variant) -> Vec<Variant> {
        let variants = aim.variants(all, self.reduction);
        let cost = variants.iter().find(|(variant, _)| *variant == first).map_or(0.0, |(_, cost)| *cost);
        let near = variants.into_iter().filter(|&(variant, other)| variant != first && other <= cost + SHARED);
        near.map(|(variant, _)| variant).collect()
    }

    /// The part by that variant, if it keeps the promise comfortably.
    fn kept(&self, scene: &Scene, aim: &Aim, all: &Approximations, variant: Variant) -> Option<Part> {
        let part = aim.part(scene, &self.prospect.task, all.choose(variant.divided), self.reduction, variant.form).ok();
        part.filter(|part| part.taken <= super::comfortable(scene, self.reduction))
    }
}

pub(super) fn polynomial(part: &Part) -> Option<&Polynomial> {
    if let Kernel::Polynomial(polynomial) = &part.kernel { Some(polynomial) } else { None }
}
