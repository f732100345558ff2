//! The best tolerance that can be offered in place of one out of reach.

use super::{Refusal, cheapest, of_paper, search};
use crate::parse::Method;
use crate::power::power;
use crate::scene::{Goal, Scene};

/// Whether what is offered is the least that is found: of several outputs, and of the series and Eq. 22, whose plans
/// take long, somewhat less may be had.
pub(super) fn is_finest(scene: &Scene) -> bool {
    let without_terms = matches!(scene.method, Some(Method::SmallAngle | Method::Harmonic));
    scene.outputs.len() == 1 && (is_quick(scene) || without_terms)
}

/// The best that can be asked for, infinite if that isn't known, where the goal is refused with what was reached.
pub(super) fn best(scene: &Scene, reached: f64) -> f64 {
    let least = if of_paper(scene).is_some() { f64::INFINITY } else { search::least_error(scene) };
    let (best, full, tol) = match scene.goal {
        Goal::Tolerance(tol) => (reached.min(least), of_full_precision(scene), tol),
        // It is that of which `reached` tells.
        _ => (reached, f64::INFINITY, 0.0),
    };
    let reached = if best < full { [best, full] } else { [full, best] };
    let offers = reached.into_iter().flat_map(offers_from);
    let decades = if is_quick(scene) { 1..10 } else { 1..1 };
    let decades = decades.map(|decade| three_digits(tol.max(scene.float.unit()) * power(10f64, decade)));
    let offers: Vec<f64> = offers.chain(decades).filter(|offer| offer.is_finite()).collect();
    first_kept(scene, offers, least).map_or(f64::INFINITY, |kept| finest(scene, kept))
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

/// Asks for another tolerance.
fn kept(scene: &Scene, tolerance: f64) -> Result<Kept, Refusal> {
    let plan = cheapest(&scene.asking(tolerance))?;
    Ok(Kept { tolerance, bound: plan.worst() })
}

/// The first of the tolerances that can be promised; those below what was reached where another was refused come last.
/// Where more was reached than all of them, a sum that lacked terms told less than it would reach: from there on others are
/// tried. Where polynomials take too many points for one, they do for a little more, too. Whatever is asked, `least` is
/// reached.
fn first_kept(scene: &Scene, mut offers: Vec<f64>, least: f64) -> Option<Kept> {
    let (mut reached, mut hopeless) = (0.0, 0.0);
    let (mut tried, mut further) = (0, 0);
    let mut unlikely = Vec::new();
    while let Some(&offer) = offers.get(tried) {
        tried += 1;
        if offer < hopeless {
            continue;
        }
        if offer < reached {
            unlikely.push(offer);
            continue;
        }
        match kept(scene, offer) {
            Ok(kept) => return Some(kept),
            Err(Refusal::Unreachable { best }) if best.min(least).is_finite() => {
                reached = best.min(least);
                if further < FURTHER && offers.iter().all(|&offer| offer < reached) {
                    offers.extend(offers_from(reached));
                    further += 1;
                }
            }
            Err(Refusal::Unreachable { .. }) if scene.method == Some(Method::Polynomial) => hopeless = 3.0 * offer,
            Err(_) => {}
        }
    }
    unlikely.into_iter().find_map(|offer| kept(scene, offer).ok())
}

/// The finest that can be promised, too: where a promise leaves more than half, what it takes is asked for; of one output
/// whose plans are quick a fifth less, and then parts as long as these are kept.
fn finest(scene: &Scene, found: Kept) -> f64 {
    let offer = |of: &Kept, part: f64| three_digits(part * of.tolerance.min(1.01 * of.bound));
    let finer = |of: &Kept, part: f64| kept(scene, Some(offer(of, part)).filter(|&offer| offer < of.tolerance)?).ok();
    let half_left = |of: &Kept| if offer(of, 1.0) < 0.5 * of.tolerance { finer(of, 1.0) } else { None };
    let found = last(found, half_left);
    if scene.outputs.len() > 1 || !is_quick(scene) {
        return found.tolerance;
    }
    let found = finer(&found, 1.0).unwrap_or(found);
    let Some(less) = finer(&found, 0.8) else { return found.tolerance };
    [0.03, 0.5, 0.8].into_iter().fold(less, |found, part| last(found, |of| finer(of, part))).tolerance
}

/// What is left when nothing finer is found any more.
fn last(found: Kept, finer: impl Fn(&Kept) -> Option<Kept>) -> Kept {
    std::iter::successors(Some(found), finer).last().unwrap_or(found)
}

/// What an error that was reached, for another goal or by a part of the scene, is multiplied with to be asked for.
const OFFERS: [f64; 5] = [1.01, 1.05, 1.25, 2.0, 4.0];

/// How often others are tried beyond all.
const FURTHER: usize = 2;

fn offers_from(reached: f64) -> [f64; 5] {
    OFFERS.map(|factor| three_digits(reached * factor))
}

/// As a message prints it.
fn three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}
