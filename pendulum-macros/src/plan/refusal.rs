//! Why a scene can't be planned, and what its author is told.

use super::{cheapest, of_paper, paper};
use crate::motion::{ALWAYS_OVERSHOOTS, Regime};
use crate::parse::{Float, Method, Output, source};
use crate::report::list;
use crate::scene::{Goal, Scene};

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Refusal {
    /// No plan reaches the goal; the best promises this, if it is finite.
    Unreachable { best: f64 },
    /// The argument of the paper's arcsine exceeds 1 by this; the smallest number of terms that works, if any does.
    Overshoot { terms: usize, overshoot: f64, smallest: Option<usize> },
    /// More terms than this can't be used; the smallest number of them that works, if any does.
    Useless { terms: usize, most: usize, smallest: Option<usize> },
    /// The planner saw its own promise broken.
    Broken { output: Output },
}

impl Refusal {
    /// The error at the token to blame.
    pub(crate) fn explain(&self, scene: &Scene) -> syn::Error {
        let blame = &scene.blame;
        let (tokens, message) = match *self {
            Self::Unreachable { best } => {
                let by_rate = scene.goal == Goal::Full && scene.is_far();
                (if by_rate { &blame.rate } else { &blame.goal }, unreachable(best, scene))
            }
            Self::Overshoot { .. } if !matches!(scene.goal, Goal::Terms(_)) => {
                (&blame.method, ALWAYS_OVERSHOOTS.to_owned())
            }
            Self::Overshoot { terms, overshoot, smallest } => {
                (&blame.goal, exceeds_one(terms, overshoot, smallest, scene))
            }
            Self::Useless { terms, most, smallest } => (&blame.goal, useless(terms, most, smallest, scene)),
            Self::Broken { output } => {
                let message = format!(
                    "the plan for `{}` misses its own error bound here: this is a bug of pendula; please report the invocation, \
                     and try another `tol` until it is mended",
                    output.word()
                );
                (&blame.start, message)
            }
        };
        syn::Error::new_spanned(tokens, message)
    }
}

fn unreachable(best: f64, scene: &Scene) -> String {
    let (asked, offer) = match scene.goal {
        Goal::Terms(n) => return unbounded(n, scene),
        Goal::Tolerance(_) => (format!("`tol = {}`", source::value(&scene.blame.goal)), "ask for that".to_owned()),
        Goal::Full => (format!("the full precision of `{}`", scene.float.word()), format!("state `tol = {best:.2e}`")),
    };
    let promise = scene
        .method
        .map_or_else(|| "can be promised".to_owned(), |method| format!("`method = {}` can promise", method.word()));
    let remedy = closer(best, scene);
    if best.is_infinite() {
        format!("no error was found that {promise} here, neither {asked} nor another: {remedy}")
    } else {
        let of_some = of_some(scene);
        format!("{asked} is finer than {promise}{of_some} here: the best found is {best:.2e}; {offer}, or {remedy}")
    }
}

/// The outputs that can't be promised even alone, where others can.
fn of_some(scene: &Scene) -> String {
    if scene.outputs.len() == 1 {
        return String::new();
    }
    let refused: Vec<Output> = scene.outputs.iter().copied().filter(|&output| !is_planned(&scene.of(output))).collect();
    if refused.is_empty() || refused.len() == scene.outputs.len() {
        return String::new();
    }
    format!(" of {}", list(&refused.into_iter().map(Output::word).collect::<Vec<_>>()))
}

/// What else than a larger tolerance would help.
fn closer(best: f64, scene: &Scene) -> String {
    by_another_method(scene)
        .map(str::to_owned)
        .or_else(|| with_fewer_turns(best, scene))
        .or_else(|| at_full_precision(best, scene).map(str::to_owned))
        .unwrap_or_else(|| by_other_numbers(scene))
}

fn by_other_numbers(scene: &Scene) -> String {
    match (scene.float, scene.outputs.len()) {
        (Float::F32, _) => "use `float = f64`, which comes closer".to_owned(),
        (Float::F64, _) if scene.is_far() => {
            let omega = scene.motion.omega.to_f64();
            format!("choose a unit of time in which ω, here {omega:e}, is nearer to 1")
        }
        (Float::F64, 1) => "choose numbers nearer to 1".to_owned(),
        (Float::F64, _) => "choose numbers nearer to 1, or fewer outputs".to_owned(),
    }
}

/// Where a method is forced.
fn by_another_method(scene: &Scene) -> Option<&'static str> {
    let in_f64 = |scene: Scene| Scene { float: Float::F64, ..scene };
    match (scene.method?, scene.float) {
        (Method::SmallAngle, _) if is_planned(&scene.over_a_period()) => {
            Some("give a short `t_max`, since the period of small angles isn't that of this one, or leave `method` out")
        }
        _ if is_planned(&scene.by_any_method()) => Some("leave `method` out"),
        (_, Float::F32) if is_planned(&in_f64(scene.clone())) => Some("use `float = f64`"),
        (_, Float::F32) if is_planned(&in_f64(scene.by_any_method())) => {
            Some("leave `method` out, and use `float = f64`")
        }
        _ => None,
    }
}

/// Where it is the rounding of a rotation's turns that is in the way of a tolerance.
fn with_fewer_turns(best: f64, scene: &Scene) -> Option<String> {
    let turns = matches!(scene.motion.regime, Regime::Rotation(_)) && scene.outputs.contains(&Output::Theta);
    if !turns || !matches!(scene.goal, Goal::Tolerance(_)) {
        return None;
    }
    let over_a_period = scene.over_a_period();
    let (free, unlimited) = (scene.method.is_none(), scene.t_max.is_none());
    let give = if unlimited { "give a `t_max`" } else { "give a shorter `t_max`" };
    match (is_planned(&over_a_period), is_planned(&scene.wrapped())) {
        (true, true) => Some(format!("{give}, {GROWS}, or use the output `wrapped`")),
        (true, false) => Some(format!("{give}, {GROWS}")),
        (false, true) => Some(format!("use the output `wrapped`, {GROWS}")),
        (false, false) if free && unlimited && best.is_finite() => Some(format!("{give}, which comes closer, {GROWS}")),
        (false, false) if !free && is_planned(&over_a_period.by_any_method()) => {
            Some(format!("leave `method` out, and give a short `t_max`, {GROWS}"))
        }
        (false, false) => None,
    }
}

const GROWS: &str = "since the error of an angle grows with its turns";

/// Where a tolerance is finer than that.
fn at_full_precision(best: f64, scene: &Scene) -> Option<&'static str> {
    let full = || Scene { goal: Goal::Full, ..scene.by_any_method() };
    match (scene.goal, scene.method, scene.float) {
        (Goal::Tolerance(_), Some(_), _) if is_planned(&full()) => {
            Some("leave `method` and `tol` out for full precision")
        }
        (Goal::Tolerance(_), None, Float::F64) if best.is_finite() && is_planned(&full()) => {
            Some("leave `tol` out for full precision")
        }
        _ => None,
    }
}

/// A remedy is tried before it is advised.
fn is_planned(scene: &Scene) -> bool {
    cheapest(scene).is_ok()
}

/// `n` terms have an error whatever it is, but not everywhere one that can be bounded.
fn unbounded(n: usize, scene: &Scene) -> String {
    if scene.outputs.contains(&Output::Velocity) {
        let another = of_paper(scene).and_then(|(swing, _)| paper::planned(scene, swing, n + 1));
        let another = another.map_or_else(String::new, |another| format!("choose `n = {another}`, "));
        format!(
            "`n = {n}`: no useful bound can be proven for the error of θ̂'s velocity at this amplitude, where the argument \
             of the arcsine in Eq. 22 comes too near 1: {another}ask for `theta` alone, or {}",
            by_tolerance(scene)
        )
    } else {
        format!("`n = {n}`: no bound can be proven for the error of θ̂ here: {}", by_tolerance(scene))
    }
}

/// In place of a number of terms: with the method, of which none may do, that tolerance may be out of reach.
fn by_tolerance(scene: &Scene) -> &'static str {
    match scene.method {
        Some(_) => "state the error as `tol` instead, and leave `method` out",
        None => "state the error as `tol` instead",
    }
}

fn useless(terms: usize, most: usize, smallest: Option<usize>, scene: &Scene) -> String {
    let remedy = match smallest {
        None => format!(", and {}: {}", none_works(scene), by_tolerance(scene)),
        Some(least) if least < most => format!("; use an `n` from {least} to {most}"),
        Some(_) => format!("; use `n = {most}`"),
    };
    format!(
        "`n = {terms}` is beyond what `{}` can use at this amplitude: the terms after the first {most} are together less \
         than half a unit in the last place of the sum{remedy}",
        scene.float.word()
    )
}

fn none_works(scene: &Scene) -> String {
    if scene.outputs.contains(&Output::Velocity) {
        "no number of terms was found that works for `velocity`".to_owned()
    } else {
        format!("no number of terms that `{}` can use works", scene.float.word())
    }
}

/// What is less than this beyond 1 is found with moduli in two words, but by margins in one.
const UNTOLD: f64 = 1e-15;

fn exceeds_one(terms: usize, overshoot: f64, smallest: Option<usize>, scene: &Scene) -> String {
    let remedy = smallest.map_or_else(
        || format!("{}: {}", none_works(scene), by_tolerance(scene)),
        |smallest| format!("the smallest number of terms that works is `n = {smallest}`"),
    );
    let exceeds = if overshoot > UNTOLD {
        format!("exceeds 1 by {overshoot:.2e}")
    } else {
        "can't be told from one that exceeds 1".to_owned()
    };
    format!(
        "`n = {terms}`: the argument of the arcsine in Eq. 22 {exceeds} at this amplitude, where θ̂ would be NaN; {remedy}"
    )
}
