//! In which order ways are tried, and which is taken.

use super::candidate::Way;
use super::choice::{COMFORTABLE, DEARER, TOLERABLE};
use super::*;
use crate::plan::observed::observed;
use crate::plan::part::SLOWNESS;
use crate::plan::reduction::Origin;
use crate::plan::tests::probe::Probe;
use crate::plan::{Bound, kernel};
use crate::testing::{Random, scene};

/// The parts of 2⁻⁴⁹ and 2⁻²⁰ that are comfortable and tolerable.
fn limits(scene: &Scene) -> [f64; 2] {
    [COMFORTABLE, TOLERABLE].map(|expected| expected / observed(scene.float))
}

fn prospects(text: &str) -> (Scene, Vec<Prospect>) {
    let scene = scene(&format!("struct Motion; {text}"));
    let prospects = tasks(&scene).into_iter().map(|task| Prospect::new(&scene, task)).collect();
    (scene, prospects)
}

/// What takes at most a part of its limit, at any cost.
fn at_most(candidate: &Candidate, scene: &Scene, most: f64) -> Result<Outputs, Failure> {
    candidate.outputs(scene, Demand { most, dear: f64::INFINITY, hardest: 0 })
}

fn planned(scene: &Scene, candidate: &Candidate) -> Option<Plan> {
    Some(joined(candidate.reduction, at_most(candidate, scene, f64::INFINITY).ok()?.parts))
}

/// Of polynomials the estimates come close to what the plans are that might be taken, so that the cheapest is tried first.
#[test]
fn estimated_costs() {
    let mut looked_at = 0;
    for text in [
        "theta0 = 7π/8, tol = 1e-9, t_max = 1e4",
        "theta0 = 1, tol = 1e-9, t_max = 1",
        "theta0 = 1, tol = 1e-9, t_max = 1, float = f32",
        "theta0 = 3.1, tol = 1e-9, t_max = 1e4, outputs = [velocity]",
        "theta0 = π - 1e-4, tol = 1e-2",
        "velocity0 = 2.1, outputs = [velocity]",
        "velocity0 = 2.001, tol = 1e-5, outputs = [position]",
        "theta0 = π - 1e-6, tol = 1e-4, outputs = [velocity]",
        "theta0 = π - 1e-12, tol = 1e-12, outputs = [acceleration]",
        "theta0 = π - 1e-20, tol = 1e-8, t_max = 1e3",
        "velocity0 = 2, tol = 1e-4, float = f32, outputs = [velocity]",
        "velocity0 = 2",
    ] {
        let (scene, prospects) = prospects(text);
        let mut before = 0.0;
        for candidate in candidates(&scene, &prospects) {
            assert!(candidate.cost >= before, "{text}: {}", candidate.describe());
            before = candidate.cost;
            let Ok(outputs) = at_most(&candidate, &scene, Limits::of(scene.goal, candidate.reduction).tolerable) else {
                continue;
            };
            let plan = joined(candidate.reduction, outputs.parts);
            let ratio = candidate.cost / plan.functions[0].program.cost();
            // A term more or less of the few of a piece makes a difference.
            let expected = match candidate.way {
                Way::Polynomials => 0.9..1.15,
                Way::Pieces(_) => 0.97..1.3,
                Way::Passage => 0.9 * SLOWNESS..1.15 * SLOWNESS,
            };
            assert!(expected.contains(&ratio), "{text}: {ratio} times the cost, {}", candidate.describe());
            looked_at += 1;
        }
    }
    assert!(looked_at > 20, "{looked_at}");
}

/// At full precision the cheapest plan that is comfortable, and of each way the first form that is, unless one that is
/// tolerable costs less by a twentieth; where none is, the one that takes least of its limit, of equal ones the cheapest.
#[test]
fn comfortable_plans() {
    let least = |found: &[(f64, f64)]| found.iter().map(|&(_, taken)| taken).fold(f64::INFINITY, f64::min);
    let (mut uncomfortable, mut tolerable) = (0, 0);
    for text in [
        "theta0 = 2, outputs = [acceleration]",
        "theta0 = 0.97π",
        "theta0 = 0.97π, outputs = [velocity]",
        "theta0 = 0.98π, outputs = [acceleration], float = f32",
        "theta0 = 0.9999π, outputs = [velocity]",
        "velocity0 = 2.1, outputs = [acceleration]",
        "velocity0 = 2.01",
        "theta0 = 2.449, t_max = 1e4, outputs = [acceleration]",
        "theta0 = 0.99π, t_max = 100, outputs = [velocity]",
        "theta0 = 2.449, outputs = [position], float = f32",
    ] {
        let (scene, prospects) = prospects(text);
        let [comfortable, enough] = limits(&scene);
        let best = |found: &[(f64, f64)]| {
            let cheapest = |most: f64| {
                let within = found.iter().copied().filter(|&(_, taken)| taken <= most);
                within.min_by(|a, b| a.0.total_cmp(&b.0))
            };
            let tolerable = cheapest(enough);
            let worth = |&(cost, _): &(f64, f64)| tolerable.is_none_or(|(least, _)| cost <= DEARER * least);
            cheapest(comfortable).filter(worth).or(tolerable).map_or(least(found), |(_, taken)| taken)
        };
        // What is asked of the next: to be tolerable, or where none is to take less.
        let goals = |found: &[(f64, f64)]| [enough, least(found)];
        let (mut found, mut costs) = (Vec::new(), Vec::new());
        let first = |one: &Candidate| one.resort(&scene) == 0 && !one.is_late(&scene);
        for candidate in candidates(&scene, &prospects).into_iter().filter(first) {
            let Prospect { task, approximations, .. } = candidate.prospect;
            let outputs = |most: f64| at_most(&candidate, &scene, most).ok();
            let Some(Outputs { parts, more, .. }) = goals(&found).into_iter().find_map(outputs) else { continue };
            found.push((candidate.cost + more, largest_share(&parts)));
            costs.push(joined(candidate.reduction, parts).functions[0].program.cost());
            if candidate.way != Way::Polynomials {
                continue;
            }
            let (all, reduction) = (&approximations[0], candidate.reduction);
            let mut forms = Vec::new();
            for (variant, cost) in all.variants(reduction) {
                let part = |most: f64| all.part(task, reduction, variant, most).ok();
                forms.extend(goals(&forms).into_iter().find_map(part).map(|part| (cost, part.share)));
            }
            let chosen = [enough, f64::INFINITY].into_iter().find_map(outputs).unwrap();
            assert_eq!(largest_share(&chosen.parts), best(&forms), "{text}: {forms:?}, {}", candidate.describe());
        }
        let chosen = plan(&scene).unwrap();
        assert_eq!(largest_share(&chosen.parts), best(&found), "{text}: {found:?}");
        let first = found.iter().position(|&(_, taken)| taken == best(&found)).unwrap();
        assert_eq!(chosen.functions[0].program.cost(), costs[first], "{text}: {found:?} {costs:?}");
        uncomfortable += usize::from(found[0].1 > comfortable);
        tolerable += usize::from((comfortable..=enough).contains(&largest_share(&chosen.parts)));
    }
    assert!(uncomfortable > 4 && tolerable > 0, "{uncomfortable} {tolerable}");
}

/// Where a phase isn't fine enough none is that goes the same way and is no finer.
#[test]
fn phases_that_are_no_finer() {
    let mut pairs = 0;
    for text in [
        "theta0 = 2.449, t_max = 1e4, outputs = [acceleration]",
        "theta0 = 2.102, t_max = 100, outputs = [theta, velocity, acceleration]",
        "theta0 = π - 9.1e-6, t_max = 1e4, outputs = [theta, velocity]",
        "velocity0 = 2.01, t_max = 50, outputs = [position]",
    ] {
        let (scene, prospects) = prospects(text);
        let candidates = candidates(&scene, &prospects);
        let lost: Vec<bool> = candidates.iter().map(|one| at_most(one, &scene, limits(&scene)[1]).is_err()).collect();
        for (first, other) in candidates.iter().enumerate().filter(|&(first, _)| lost[first]) {
            let is_skipped = |&index: &usize| index != first && candidates[index].is_no_finer(other);
            for index in (0..candidates.len()).filter(is_skipped) {
                assert!(lost[index], "{text}: {} after {}", candidates[index].describe(), other.describe());
                pairs += 1;
            }
        }
    }
    assert!(pairs > 4, "{pairs}");
}

/// What a part takes of its limit: everything, but for the turns of an angle that grows at full precision, where within
/// a horizon the error of the phase counts more, and for what the mean rotation doesn't feel of that.
#[test]
fn what_is_taken_of_limits() {
    for (text, grows) in [
        ("velocity0 = 3", true),
        ("velocity0 = 3, t_max = 1e6", true),
        ("velocity0 = 3, t_max = 1e6, tol = 1e-6", false),
        ("velocity0 = 3, outputs = [wrapped]", false),
        ("theta0 = 3", false),
    ] {
        let (scene, prospects) = prospects(text);
        let Prospect { task, reductions, .. } = prospects.last().unwrap();
        let (part, reduction) = (plan(&scene).unwrap().parts.remove(0), &reductions[0]);
        let limit = task.aims[0].limit;
        let bound = Bound { truncation: 0.125 * limit, phase: 0.25 * limit, evaluation: 0.125 * limit };
        let felt = Bound { phase: part.kernel.finish.felt(reduction, bound.phase), ..bound };
        assert_eq!(felt != bound, text.contains("tol"), "{text}");
        let turns = part.kernel.finish.rounding_of_turns(reduction, &felt);
        assert_eq!(turns > 0.0, text.starts_with('v'), "{text}");
        let accepted = task.aims[0].accept(&part.kernel, bound, reduction).unwrap();
        let met_in_full = if text == "velocity0 = 3, t_max = 1e6" { 0.25 / 0.79 - 0.25 } else { 0.0 };
        let expected = felt.total() / limit + met_in_full + if grows { 0.0 } else { turns / limit };
        assert!((accepted.share / expected - 1.0).abs() < 2e-12, "{text}: {} {expected}", accepted.share);
        assert_eq!(accepted.bound, Bound { evaluation: 0.125 * limit + turns, ..felt }, "{text}");
    }
}

/// Where the angle of a rotation is small it has all its digits at full precision, for which the phase is that from the
/// lowest point; nothing else of it is worth that.
#[test]
fn small_angles_of_rotations() {
    for (text, origin) in [
        ("velocity0 = 3", Origin::Lowest),
        ("velocity0 = -2.1, float = f32", Origin::Lowest),
        ("velocity0 = 3, outputs = [velocity, wrapped]", Origin::Lowest),
        ("velocity0 = 3, outputs = [velocity]", Origin::Anchor),
        ("velocity0 = 3, tol = 1e-6, t_max = 100", Origin::Anchor),
        ("theta0 = 1", Origin::Anchor),
    ] {
        let plan = plan(&prospects(text).0).unwrap();
        assert_eq!(plan.reduction.origin, origin, "{text}");
    }
}

/// What polynomials can't promise of one output the passage may, and the other way round, of several outputs.
#[test]
fn outputs_by_different_ways() {
    for (text, ways) in [
        ("velocity0 = 2.0000002, outputs = [velocity, position]", ["polynomial", "passage"]),
        ("velocity0 = 2.0000001, outputs = [acceleration, theta], float = f32", ["polynomial", "passage"]),
        ("theta0 = π - 1e-5, outputs = [velocity, position], tol = 5e-15", ["polynomial", "passage"]),
    ] {
        let (scene, prospects) = prospects(text);
        let words = |plan: &Plan| -> Vec<&str> { plan.parts.iter().map(|part| part.kernel.core.word()).collect() };
        assert_eq!(words(&plan(&scene).unwrap()), ways, "{text}");
        // Of the same output alone there is but one way to each candidate.
        let single = Scene { outputs: scene.outputs[..1].to_vec(), ..scene.clone() };
        let alone: Vec<Prospect> = tasks(&single).into_iter().map(|task| Prospect::new(&single, task)).collect();
        for (scene, prospects) in [(&scene, &prospects), (&single, &alone)] {
            let mut mixed = 0;
            for candidate in candidates(scene, prospects) {
                let Some(plan) = planned(scene, &candidate) else { continue };
                let own = match candidate.way {
                    Way::Polynomials => "polynomial",
                    Way::Passage => "passage",
                    Way::Pieces(_) => "pieces",
                };
                mixed += usize::from(words(&plan).iter().any(|word| *word != own));
            }
            assert_eq!(mixed > 0, scene.outputs.len() > 1, "{text}: {mixed}");
        }
    }
}

/// Pieces are given terms until what rounding leaves is enough: down to nearly the least that can be promised.
#[test]
fn pieces_leave_room_for_rounding() {
    for tol in ["1.5e-15", "1.6e-15", "1.8e-15", "2.2e-15", "3e-15"] {
        let (scene, prospects) = prospects(&format!("theta0 = π - 1e-6, tol = {tol}"));
        let pieces =
            candidates(&scene, &prospects).into_iter().filter(|candidate| matches!(candidate.way, Way::Pieces(_)));
        assert!(pieces.filter_map(|candidate| planned(&scene, &candidate)).count() > 0, "{tol}");
    }
}

/// The best that can be promised of a tolerance out of reach can be had, and not much less.
#[test]
fn the_best_within_reach() {
    for text in [
        "theta0 = 2",
        "theta0 = π - 1e-6, outputs = [velocity], omega = 3",
        "theta0 = 0.99π, outputs = [acceleration, theta], omega = 1/2",
    ] {
        let at = |tol: f64| plan(&prospects(&format!("{text}, tol = {tol:e}")).0);
        let Err(Refusal::Unreachable { best }) = at(1e-18) else { panic!("{text}: within reach") };
        let best = best.min(least_error(&prospects(text).0));
        assert!(best > 1e-17 && best < 2e-15, "{text}: {best:e}");
        assert!(at(best * 1.001).is_ok(), "{text}: {best:e}");
        assert!(at(best * 0.6).is_err(), "{text}: {best:e}");
    }
}

/// Of the velocity's variants that are little dearer by themselves one of the form of θ, or one that costs less with θ;
/// alone the cheapest.
#[test]
fn velocities_beside_theta() {
    let mut others = 0;
    for text in ["tol = 1e-6, t_max = 1e3", "tol = 1e-9, t_max = 1e3", "tol = 1e-12, t_max = 1e3", "t_max = 1e3"] {
        let planned = |outputs| plan(&prospects(&format!("theta0 = 7π/8, {text}, outputs = {outputs}")).0).unwrap();
        let (both, alone) = (planned("[theta, velocity]"), planned("[velocity]"));
        let [theta, velocity] = [0, 1].map(|index| &both.parts[index]);
        let told = both.rejected.iter().any(|line| line.contains("beside `theta` it costs "));
        assert_eq!(told, velocity.kernel != alone.parts[0].kernel, "{text}: {:?}", both.rejected);
        if told {
            others += 1;
            let form = |part: &Part| part.kernel.polynomial().map(|found| found.form);
            let state = |velocity: &Part| {
                let functions = kernel::functions(&both.reduction, &[theta.clone(), velocity.clone()]);
                functions.last().map_or(f64::NAN, |function| function.program.cost())
            };
            let cheaper = state(velocity) < state(&alone.parts[0]);
            assert!(form(theta) == form(velocity) || cheaper, "{text}: {}", velocity.description);
        }
    }
    assert!(others > 1, "{others}");
}

/// Many pieces serve where few are rounded by too much or take too many points.
#[test]
fn many_pieces_are_the_last_resort() {
    for (text, pieces) in [
        ("theta0 = π - 1e-6", "64"),
        ("theta0 = π - 1e-25, float = f32, method = polynomial, outputs = [acceleration]", "128"),
        ("velocity0 = 1e-60 - 2, tol = 7.1e-9, method = polynomial", "128"),
    ] {
        let (scene, prospects) = prospects(text);
        let plan = cheapest(&scene, &prospects).unwrap();
        let description = &plan.parts[0].description;
        assert!(description.starts_with(&format!("{pieces} polynomials")), "{text}: {description}");
    }
}

/// Whichever output is looked at first, and at no more than what is asked.
#[test]
fn outputs_in_any_order() {
    let (scene, prospects) = prospects("theta0 = 0.95π, t_max = 100, outputs = [theta, velocity, position]");
    let candidates = candidates(&scene, &prospects);
    let serves = |candidate: &Candidate| Some((candidate.cost, at_most(candidate, &scene, f64::INFINITY).ok()?));
    let (candidate, (estimate, found)) =
        candidates.iter().find_map(|candidate| Some((candidate, serves(candidate)?))).unwrap();
    let cost = estimate + found.more;
    for hardest in 0..3 {
        let outputs = |dear: f64| candidate.outputs(&scene, Demand { most: f64::INFINITY, dear, hardest });
        let same = outputs(cost + 0.01).ok().unwrap();
        let kernels = |of: &Outputs| of.parts.iter().map(|part| part.kernel.clone()).collect::<Vec<_>>();
        assert_eq!((kernels(&same), same.more), (kernels(&found), found.more));
        assert_eq!(same.rejected, found.rejected);
        assert!(matches!(outputs(cost - 0.01), Err(Failure::Dear)));
    }
}

/// What can't be had is named, also where another is looked at first that can't.
#[test]
fn outputs_that_cannot_be_had() {
    let (scene, prospects) = prospects("theta0 = 0.95π, outputs = [theta, velocity]");
    let candidates = candidates(&scene, &prospects);
    for hardest in [0, 1] {
        let failure = candidates[0].outputs(&scene, Demand { most: 1e-3, dear: f64::INFINITY, hardest }).err();
        assert!(matches!(failure, Some(Failure::Unreached { output, .. }) if output == hardest));
    }
}

/// The rounding of turns is most of these tolerances, whatever is planned.
#[test]
fn tolerances_next_to_what_turns_are_rounded_by() {
    for text in [
        "velocity0 = 5.15, t_max = 1.27e12, tol = 1e-3",
        "velocity0 = 3, t_max = 1e9, tol = 7e-7",
        "velocity0 = -2.7, t_max = 1e4, tol = 3.8e-12",
        "velocity0 = 3, tol = 30",
        "velocity0 = 2.3, tol = 22.2",
    ] {
        let scene = scene(&format!("struct Motion; {text}"));
        let found = plan(&scene).unwrap();
        let least = every(&scene).iter().map(Plan::cost).fold(f64::INFINITY, f64::min);
        assert!(found.method == "polynomial" && found.cost() <= 1.1 * least, "{text}: {} {least}", found.cost());
    }
}

/// What a variant is said not to promise is more than was asked for.
#[test]
fn reasons_agree_with_the_tolerance() {
    let mut said = 0;
    for (start, tolerance) in [
        ("velocity0 = 5.15, t_max = 1.27e12", "1.3e-3"),
        ("velocity0 = 3, t_max = 1e9", "7e-7"),
        ("velocity0 = -2.7, t_max = 1e4", "3.8e-12"),
        ("velocity0 = 2.7, t_max = 1e4", "5e-12"),
        ("theta0 = 7π/8", "3e-15"),
        ("theta0 = 7π/8, float = f32", "1e-6"),
        ("theta0 = π - 1e-6, t_max = 1e4, outputs = [velocity, acceleration]", "1e-14"),
    ] {
        let plan = plan(&scene(&format!("struct Motion; {start}, tol = {tolerance}"))).unwrap();
        for line in &plan.rejected {
            let Some((_, least)) = line.split_once("no better than ") else { continue };
            let [least, tolerance] = [least, tolerance].map(|number| number.parse::<f64>().unwrap());
            assert!(least >= tolerance, "{start}, tol = {tolerance:e}: {line}");
            said += 1;
        }
    }
    assert!(said > 10, "{said}");
}

/// θ and its velocity by the passage have one exponential in their common function, and each keeps its promise by that.
#[test]
fn passages_share_their_exponential() {
    let mut random = Random::new(24);
    for text in [
        "velocity0 = 2",
        "velocity0 = 2, tol = 1e-5",
        "velocity0 = 2, omega = 1, tol = 1.449e-12, t_max = 77.5",
        "theta0 = π/2, velocity0 = sqrt(2), omega = 1, tol = 1e-7",
        "velocity0 = 2e3, omega = 1e3, tol = 1e-6",
        "theta0 = π - 1e-20",
        "theta0 = π - 1e-20, float = f32",
        "velocity0 = -2 - 1e-20, t_max = 1e3",
    ] {
        let scene = scene(&format!("struct Motion; {text}, outputs = [theta, velocity]"));
        let plan = plan(&scene).unwrap();
        assert!(plan.parts.iter().all(|part| part.kernel.is_passage()), "{text}");
        assert_eq!(plan.parts[0].kernel.core.terms(), plan.parts[1].kernel.core.terms(), "{text}");
        let state = plan.functions.iter().find(|function| function.output.is_none()).unwrap();
        let halves = state.program.nodes.iter().filter(|node| matches!(node.name, Some("even" | "odd")));
        assert_eq!(halves.count(), 2, "{text}");
        for place in 0..2 {
            let mut probe = Probe::of(&scene, &plan, place);
            probe.everywhere(&mut random, 4);
            assert!(probe.worst.1 <= plan.parts[place].bound.total(), "{text}: {:?}", probe.worst);
        }
    }
}
