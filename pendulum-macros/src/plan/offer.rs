//! The best tolerance that can be offered in place of one out of reach.

use super::{Refusal, cheapest, of_paper, search};
use crate::parse::Method;
use crate::power::power;
use crate::scene::{Goal, Scene};

/// The best that is found to be promised, infinite if nothing is, where the goal is refused with what was reached.
pub(super) fn best(scene: &Scene, reached: f64) -> f64 {
    let least = if of_paper(scene).is_some() { f64::INFINITY } else { search::least_error(scene) };
    let (best, full, tol) = match scene.goal {
        Goal::Tolerance(tol) => (reached.min(least), of_full_precision(scene), tol),
        // It is that of which `reached` tells.
        _ => (reached, f64::INFINITY, 0.0),
    };
    let reached = if best < full { [best, full] } else { [full, best] };
    let offers = reached.into_iter().flat_map(|error| OFFERS.map(|factor| error * factor)).map(three_digits);
    let decades = if is_quick(scene) { 1..10 } else { 1..1 };
    let decades = decades.map(|decade| three_digits(tol.max(scene.float.rounding_unit()) * power(10f64, decade)));
    let offers: Vec<f64> = offers.chain(decades).filter(|offer| offer.is_finite()).collect();
    let mut asked = Asking { scene, refused: vec![tol] };
    if let Some(kept) = asked.first_kept(&offers, least) {
        let far_below = if is_quick(scene) { asked.far_below(kept) } else { None };
        let (kept, below) = far_below.map_or((kept, Below::Near), |far_below| (far_below, Below::Anything));
        return asked.finest(kept, below);
    }
    if scene.is_far() {
        return f64::INFINITY;
    }
    let coarse = COARSE.into_iter().filter(|&coarse| coarse > tol).find_map(|coarse| asked.ask(coarse).ok());
    coarse.map_or(f64::INFINITY, |kept| asked.finest(kept, Below::Coarse))
}

/// What full precision promises, or reaches: of an angle that grows without bound, what its turns cost.
fn of_full_precision(scene: &Scene) -> f64 {
    match cheapest(&Scene { goal: Goal::Full, ..scene.clone() }) {
        Ok(plan) => plan.worst(),
        Err(Refusal::Unreachable { best }) => best,
        Err(_) => f64::INFINITY,
    }
}

/// Whether plans are found quickly: the paper's methods take a hundred harmonics near the top, and polynomials of several
/// outputs as many terms.
fn is_quick(scene: &Scene) -> bool {
    let one_polynomial = scene.method == Some(Method::Polynomial) && scene.outputs.len() == 1;
    scene.method.is_none() || one_polynomial
}

/// A tolerance that can be promised, and the bound of the plan that promises it.
#[derive(Clone, Copy)]
struct Kept {
    tolerance: f64,
    bound: f64,
}

/// Which tolerances have been asked for in vain.
struct Asking<'a> {
    scene: &'a Scene,
    refused: Vec<f64>,
}

impl Asking<'_> {
    fn ask(&mut self, tolerance: f64) -> Result<Kept, Refusal> {
        let planned = cheapest(&self.scene.asking(tolerance));
        planned.map(|plan| Kept { tolerance, bound: plan.worst() }).inspect_err(|_| self.refused.push(tolerance))
    }

    /// The first of the tolerances that can be promised; those below what was reached where another was refused come last,
    /// the coarsest first. Where polynomials take too many points for one, they do for a little more, too. Whatever is
    /// asked, `least` is reached.
    fn first_kept(&mut self, offers: &[f64], least: f64) -> Option<Kept> {
        let (mut reached, mut hopeless) = (0.0, 0.0);
        let mut unlikely = Vec::new();
        for &offer in offers {
            if offer < hopeless {
                continue;
            }
            if offer < reached {
                unlikely.push(offer);
                continue;
            }
            match self.ask(offer) {
                Ok(kept) => return Some(kept),
                Err(Refusal::Unreachable { best }) if best.min(least).is_finite() => reached = best.min(least),
                Err(Refusal::Unreachable { .. }) if self.scene.method == Some(Method::Polynomial) => {
                    hopeless = 3.0 * offer;
                }
                Err(_) => {}
            }
        }
        unlikely.into_iter().rev().find_map(|offer| self.ask(offer).ok())
    }

    /// What was reached for another goal may be far from what can be promised: that is asked for in strides, each of twice
    /// as many decades as the one before. `None` if there is nothing.
    fn far_below(&mut self, Kept { mut tolerance, .. }: Kept) -> Option<Kept> {
        let (mut found, mut stride) = (None, FIRST_STRIDE);
        loop {
            let next = three_digits(tolerance / stride);
            let is_new = next > 0.0 && self.refused.iter().all(|&refused| refused < next);
            let Some(kept) = is_new.then(|| self.ask(next).ok()).flatten() else { return found };
            (found, tolerance, stride) = (Some(kept), next, stride * stride);
        }
    }

    /// What a promise takes is asked for, or what was reached where another was refused; then what is between it and the
    /// largest tolerance that was refused, but no farther `below`.
    fn finest(mut self, mut found: Kept, below: Below) -> f64 {
        let thorough = is_quick(self.scene) && self.scene.outputs.len() == 1;
        let close = if thorough { 1.02 } else { 1.5 };
        let mut reached = found.bound;
        for _ in 0..below.asks(thorough) {
            let refused = self.refused.iter().copied().filter(|&refused| refused < found.tolerance);
            let refused = refused.fold((found.tolerance / below.step()).max(f64::from_bits(1)), f64::max);
            let [taken, between] = [OFFERS[0] * reached, refused.sqrt() * found.tolerance.sqrt()].map(three_digits);
            let next = if taken > refused && taken * close < found.tolerance { taken } else { between };
            if next * close.sqrt() > found.tolerance {
                break;
            }
            match self.ask(next) {
                Ok(kept) => (found, reached) = (kept, kept.bound),
                Err(Refusal::Unreachable { best }) if best.is_finite() => {
                    if !thorough && best * close > found.tolerance {
                        break;
                    }
                    reached = best;
                }
                Err(_) => {}
            }
        }
        found.tolerance
    }
}

/// What an error that was reached, for another goal or by a part of the scene, is multiplied with to be asked for.
const OFFERS: [f64; 5] = [1.01, 1.05, 1.25, 2.0, 4.0];

/// What is asked for where none of these can be promised, unless it is the unit of time that is in the way.
const COARSE: [f64; 2] = [1e-3, 1.0];

/// Where the best tolerance is, from one that can be promised.
#[derive(Clone, Copy)]
enum Below {
    /// Next to it: it was found from what was reached.
    Near,
    /// It is coarse.
    Coarse,
    /// Above what was refused.
    Anything,
}

impl Below {
    /// So much below it hardly any is kept.
    fn step(self) -> f64 {
        match self {
            Self::Near => 8.0,
            Self::Coarse => 1e8,
            Self::Anything => f64::INFINITY,
        }
    }

    /// How often something between is asked for.
    fn asks(self, thorough: bool) -> usize {
        match (self, thorough) {
            (Self::Anything, _) => 16,
            (_, true) => 8,
            (Self::Coarse, false) => 6,
            (Self::Near, false) => 3,
        }
    }
}

/// As many times less is asked for first where nothing is known.
const FIRST_STRIDE: f64 = 64.0;

/// As a message prints it.
fn three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}
