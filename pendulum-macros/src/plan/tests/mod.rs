//! What the planner chooses, and what it refuses. That plans keep their bounds is tested in `random`, and that
//! these are close in `tight`.

mod asking_less;
mod full_precision;
pub(crate) mod probe;
mod random;
mod tight;
pub(crate) mod truth;

use super::*;
use crate::program::Op;
use crate::testing::{Random, scene};
use probe::{assert_tight, evenly};

fn planned(text: &str) -> Plan {
    plan(&scene(&format!("struct Motion; {text}"))).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"))
}

fn refused(text: &str) -> Refusal {
    plan(&scene(&format!("struct Motion; {text}"))).err().unwrap_or_else(|| panic!("{text} was planned"))
}

/// 100 periods at 7π/8.
const HUNDRED: &str = "t_max = 1216";

#[test]
fn headline_plans_are_cheap() {
    for (text, most) in [
        (format!("theta0 = 7π/8, tol = 1e-6, {HUNDRED}"), 21),
        (format!("theta0 = 7π/8, tol = 1e-9, {HUNDRED}"), 28),
        (format!("theta0 = 7π/8, tol = 1e-12, {HUNDRED}"), 38),
        ("theta0 = 7π/8".to_owned(), 66),
        (format!("theta0 = 7π/8, float = f32, tol = 1e-4, {HUNDRED}"), 19),
        ("theta0 = 7π/8, n = 4".to_owned(), 53),
        ("theta0 = pi - 1e-9".to_owned(), 53),
    ] {
        let operations = planned(&text).operations();
        assert!(operations <= most, "{text}: {operations} operations of at most {most}");
    }
}

#[test]
fn each_scene_gets_its_way() {
    for (text, method) in [
        ("theta0 = 1", "polynomial"),
        ("theta0 = pi - 1e-9", "pieces"),
        ("theta0 = pi - 1e-9, outputs = [position]", "passage"),
        ("theta0 = pi - 1e-5, tol = 1e-9, t_max = 1e4, outputs = [velocity, acceleration]", "polynomial"),
        ("theta0 = pi - 1e-9, tol = 3e-14, outputs = [acceleration, theta]", "pieces"),
        ("velocity0 = -2.001, outputs = [velocity, acceleration]", "pieces"),
        ("theta0 = pi - 1e-4, tol = 1e-2", "polynomial"),
        ("velocity0 = 2", "passage"),
        ("velocity0 = 3", "polynomial"),
        ("theta0 = 1, n = 2", "fourier"),
        ("theta0 = 1, method = fourier, tol = 1e-5", "fourier"),
        ("theta0 = 1, method = series, tol = 1e-5", "series"),
        ("theta0 = 1, method = harmonic", "harmonic"),
        ("theta0 = 1, method = small_angle, t_max = 1", "small_angle"),
        ("theta0 = 1, method = polynomial", "polynomial"),
        // Cheaper as they are.
        ("theta0 = pi - 1e-6, method = polynomial", "polynomial"),
        ("theta0 = pi - 1e-9, method = polynomial", "pieces"),
        ("theta0 = pi - 1e-9, method = polynomial, float = f32, outputs = [velocity, acceleration]", "pieces"),
        ("theta0 = pi - 1e-6, method = polynomial, outputs = [acceleration]", "pieces"),
        ("theta0 = pi - 1e-5, method = polynomial, outputs = [position]", "pieces"),
    ] {
        assert_eq!(planned(text).method, method, "{text}");
    }
}

/// What is the same motion is the same plan, whatever it was written as; another in the sixteenth digit is another.
#[test]
fn plans_are_of_motions() {
    for (text, other) in [
        ("theta0 = 7π/8, tol = 1e-6", "tol = 0.000001, theta0 = 157.5deg"),
        ("theta0 = 1, omega = 3, t_max = 1e3", "theta0 = 1, g = 36, length = 4, t_max = 1_000.0"),
        ("velocity0 = -5/2, outputs = [theta, velocity]", "theta0 = 0, velocity0 = -2.5, outputs = [theta, velocity]"),
        ("theta0 = π - 1e-9", "theta0 = 180deg - 1e-9rad, omega = 1"),
    ] {
        assert_eq!(planned(text), planned(other), "{text}, {other}");
    }
    assert_ne!(planned("theta0 = 1"), planned("theta0 = 1.0000000000000001"));
}

/// Less than a quarter of a period either way, than half a turn, is computed of the time itself.
#[test]
fn short_horizons_need_no_reduction() {
    use super::reduction::Scheme;
    for (text, most) in [
        ("theta0 = 7π/8, tol = 1e-6, t_max = 2", 13),
        ("theta0 = 7π/8, tol = 1e-6, t_max = 2, outputs = [velocity]", 18),
        ("theta0 = 1, t_max = 1, outputs = [position]", 53),
        ("velocity0 = -1, tol = 1e-6, t_max = 1", 15),
        ("theta0 = 1, velocity0 = 1, tol = 1e-6, t_max = 0.5", 16),
        ("theta0 = 1, velocity0 = 3, omega = 1e200, tol = 1e-6, t_max = 1e-201", 10),
        ("velocity0 = 3, tol = 1e-6, t_max = 0.3", 13),
        ("theta0 = -3, velocity0 = -3, tol = 1e-6, t_max = 0.3", 16),
        ("theta0 = π, velocity0 = 1e-3, tol = 1e-6, t_max = 0.1", 7),
        ("theta0 = π, velocity0 = 1e-3, tol = 1e-6, t_max = 0.1, outputs = [wrapped]", 13),
        ("theta0 = -3, velocity0 = -3, t_max = 0.3, outputs = [wrapped]", 40),
        ("theta0 = 1, float = f32, omega = 1e-6, tol = 1e-4, t_max = 1e5", 11),
        ("velocity0 = 2, tol = 1e-6, t_max = 0.1", 9),
        ("theta0 = -π/2, velocity0 = sqrt(2), tol = 1e-6, t_max = 1, outputs = [velocity]", 27),
    ] {
        let plan = planned(text);
        assert!(matches!(plan.reduction.scheme, Scheme::Time { .. }), "{text}: {}", plan.reduction.describe());
        assert!(plan.operations() <= most, "{text}: {} operations, {most} before", plan.operations());
    }
    for text in [
        "theta0 = 1, t_max = 1.68",
        "theta0 = 1, t_max = 1, method = series",
        "velocity0 = 2, tol = 1e-6, t_max = 4",
        "theta0 = 1, float = f32, omega = 1e38, tol = 1e-4, t_max = 1e-39",
    ] {
        let plan = planned(text);
        assert!(!matches!(plan.reduction.scheme, Scheme::Time { .. }), "{text}: {}", plan.reduction.describe());
    }
}

/// Next to the top, before the passage begins, hardly anything happens: that takes a few operations and has a bound as
/// small.
#[test]
fn what_happens_next_to_the_top() {
    for (start, t_max, outputs) in [
        ("π - 1e-30", "22.755688", "velocity"),
        ("π - 1e-30", "29.35056", "acceleration"),
        ("π - 1e-20", "23.7685", "acceleration"),
        ("π - 1e-20", "11.42891", "velocity"),
        ("π - 1e-9", "6", "velocity"),
    ] {
        let text = format!("struct Motion; theta0 = {start}, tol = 1e-7, t_max = {t_max}, outputs = [{outputs}]");
        let plan = plan(&scene(&text)).unwrap();
        assert!(plan.reduction.is_time() && plan.operations() <= 10, "{text}: {}", plan.operations());
        assert_tight(&text, 4.0, evenly(100));
    }
    assert!(planned("theta0 = π - 1e-20, tol = 1e-8, t_max = 13.28784").operations() <= 6);
}

#[test]
fn promises_are_kept_or_refused() {
    for tol in ["0.1", "1e-3", "1e-6", "1e-9", "1e-12", "1e-14"] {
        for theta0 in ["1e-9", "0.1", "1", "7π/8", "0.99π", "pi - 1e-6", "pi - 1e-9"] {
            let text = format!("theta0 = {theta0}, tol = {tol}, outputs = [theta, velocity]");
            for part in &planned(&text).parts {
                assert!(part.bound.total() <= tol.parse::<f64>().unwrap() * part.unit, "{text}: {:?}", part.bound);
            }
        }
    }
    let Refusal::Unreachable { best } = refused("theta0 = 3, tol = 1e-16") else { panic!("another refusal") };
    assert!(best > 1e-16 && best < 1e-14, "the best is {best:e}");
}

/// What a refusal names is kept, and little less is not.
#[test]
fn the_best_that_is_found() {
    for (text, less) in [
        ("theta0 = 2.5, tol = 5e-16", 0.97),
        ("theta0 = 1, float = f32, tol = 1e-9", 0.97),
        ("theta0 = 1.78, omega = 0.0736, float = f32, t_max = 2.6e5, outputs = [acceleration], tol = 1e-10", 0.97),
        ("theta0 = 0.476, float = f32, method = series, outputs = [theta, velocity], tol = 1e-10", 0.6),
        ("theta0 = π - 1e-6, omega = 0.147, float = f32, method = series, outputs = [acceleration], tol = 1e-7", 0.6),
        ("theta0 = π - 1e-40, method = series, tol = 1e-12", 0.1),
    ] {
        let scene = scene(&format!("struct Motion; {text}"));
        let Err(Refusal::Unreachable { best }) = plan(&scene) else { panic!("{text}: another refusal") };
        assert!(plan(&scene.asking(best)).is_ok(), "{text}: {best:e}");
        assert!(plan(&scene.asking(less * best)).is_err(), "{text}: {best:e}");
    }
}

/// In units of what a tolerance of 1 means: of an error of 8 at ω = 4 a velocity has 2.
#[test]
fn the_worst_output() {
    let mut plan = planned("theta0 = 1, omega = 4, tol = 1e-3, outputs = [theta, velocity]");
    plan.parts[0].bound = Bound { truncation: 0.5, phase: 0.25, evaluation: 0.125 };
    plan.parts[1].bound = Bound { truncation: 0.0, phase: 8.0, evaluation: 0.0 };
    assert!((plan.worst() / 2.0 - 1.0).abs() < 2e-12, "{}", plan.worst());
    plan.parts[1].bound.phase = 2.0;
    assert!((plan.worst() / 0.875 - 1.0).abs() < 2e-12, "{}", plan.worst());
}

/// The turns of an angle that grows cost more than full precision's limit, which leaves them out; what can be had with
/// them is known from a plan for full precision all the same.
#[test]
fn growing_angles_are_offered_what_full_precision_promises() {
    for text in
        ["velocity0 = 3, t_max = 10", "velocity0 = 3", "velocity0 = 2000, t_max = 10, outputs = [theta, velocity]"]
    {
        let full = planned(text).worst();
        let Refusal::Unreachable { best } = refused(&format!("{text}, tol = 1e-17")) else { panic!("another refusal") };
        assert!(best <= 1.06 * full, "{text}: {best:e} is offered, {full:e} promised");
    }
}

/// A tolerance is one of the velocity over ω, of the acceleration over ω²: of motions 2¹⁰ times as fast as many bits
/// are the same, and what can be had of them.
#[test]
fn the_best_tolerance_of_other_rates() {
    for outputs in ["velocity", "acceleration"] {
        let best =
            |rate: &str| match refused(&format!("theta0 = 2, omega = {rate}, outputs = [{outputs}], tol = 1e-17")) {
                Refusal::Unreachable { best } => best,
                other => panic!("{other:?}"),
            };
        assert_eq!(best("1"), best("1024"), "{outputs}");
    }
}

/// What is offered can be had, and a fifth less can't: of these scenes full precision promises more than that, or reaches
/// far less than a tolerance would, or a method's worst plan is far from its best, or the first of several outputs is
/// better than the others.
#[test]
fn nothing_finer_than_what_is_offered() {
    const FULL: &str = "that of the float";
    for (text, tol) in [
        ("theta0 = 1.739144, t_max = 0.680, outputs = [acceleration]", "1e-17"),
        ("theta0 = 0.164612, velocity0 = -0.343825", "1e-17"),
        ("velocity0 = 0.714662, t_max = 5.142, outputs = [wrapped]", "1e-17"),
        ("theta0 = 1.666054, velocity0 = -0.744599, t_max = 1.844e2, float = f32", "1e-17"),
        ("theta0 = π - 1.402e-6, t_max = 2.112, float = f32", "1e-17"),
        ("theta0 = 3.14, method = polynomial, t_max = 1e6", "1e-17"),
        ("theta0 = 7π/8, outputs = [theta, velocity, acceleration, position]", "8e-16"),
        ("velocity0 = 2, t_max = 1e4, outputs = [theta, velocity, position]", "1e-15"),
        ("theta0 = 0.7, velocity0 = 3, float = f32, outputs = [wrapped, acceleration]", "1e-7"),
        ("theta0 = π - 1e-20, method = polynomial, outputs = [position]", FULL),
        ("theta0 = π - 1e-50, method = polynomial, outputs = [acceleration], float = f32", FULL),
        ("theta0 = 1e-300, omega = 1e-5, outputs = [velocity]", FULL),
        ("theta0 = 1e-200, omega = 1e-107, outputs = [velocity]", FULL),
        ("theta0 = 1e-10, float = f32, outputs = [position]", "1e-20"),
        ("theta0 = 1e-12, outputs = [position]", "1e-30"),
        ("theta0 = 1e-30, outputs = [position]", "1e-40"),
    ] {
        let asked = if tol == FULL { text.to_owned() } else { format!("{text}, tol = {tol}") };
        let Refusal::Unreachable { best } = refused(&asked) else { panic!("another refusal") };
        planned(&format!("{text}, tol = {best:e}"));
        refused(&format!("{text}, tol = {:e}", 0.8 * best));
    }
    let series = "velocity0 = 2 - 1e-12, t_max = 6.206e6, method = series, tol = 1e-16";
    let Refusal::Unreachable { best } = refused(series) else { panic!("another refusal") };
    assert!(best < 3.0, "{best:e}: more than the motion");
}

#[test]
fn overshoot_names_the_smallest_number_of_terms() {
    for (theta0, n, least) in [("0.731π", 1, 2), ("0.905π", 2, 3), ("0.955π", 4, 5), ("0.987π", 8, 9)] {
        let Refusal::Overshoot { terms, overshoot, smallest } = refused(&format!("theta0 = {theta0}, n = {n}")) else {
            panic!("another refusal")
        };
        assert_eq!((terms, smallest), (n, Some(least)), "{theta0}");
        assert!(overshoot > 0.0 && overshoot < 0.01, "{theta0}: {overshoot}");
    }
}

#[test]
fn a_shorter_horizon_is_never_dearer() {
    let mut before = usize::MAX;
    for t_max in ["1e15", "1e10", "1e6", "1e3", "10"] {
        let operations = planned(&format!("theta0 = 2, tol = 1e-9, t_max = {t_max}")).operations();
        assert!(operations <= before, "t_max = {t_max}: {operations} operations, {before} for longer");
        before = operations;
    }
}

#[test]
fn a_spoilt_plan_is_seen_by_the_planner_itself() {
    let scene = scene("struct Motion; theta0 = 2, tol = 1e-10");
    let task = task::Task::new(&scene);
    let mut plan = plan(&scene).unwrap();
    assert_eq!(verify::broken(&scene, &task, &plan), None);
    let large = |op: &Op| matches!(op, Op::Constant { value, .. } if (1.0..100.0).contains(&value.abs()));
    let node = plan.functions[0].program.nodes.iter_mut().rev().find(|node| large(&node.op)).unwrap();
    let Op::Constant { value, .. } = &mut node.op else { unreachable!() };
    *value *= 1.0 + 1e-8;
    assert_eq!(verify::broken(&scene, &task, &plan), Some(Output::Theta));
}

/// Results that are exact below the largest number, but may be rounded beyond it, are refused.
#[test]
fn nothing_overflows_within_a_promise() {
    let mut refused = 0;
    for text in [
        "theta0 = 1.6420435595868863, omega = 1.844673374775e19, tol = 2.95e-3, t_max = 3.524e-20, outputs = [acceleration]",
        "theta0 = 1.7180980377296755, omega = 1.844673893567e19, tol = 0.0712, t_max = 5.7853e-20, outputs = [acceleration]",
        "velocity0 = 3.40282344729e38, omega = 2.856225489713e37, tol = 0.96, t_max = 3.5011e-36, outputs = [velocity]",
    ] {
        let scene = scene(&format!("struct Motion; {text}, float = f32"));
        match plan(&scene) {
            Ok(plan) => {
                let most = scene.t_max.as_ref().map_or(0.0, Real::to_f64);
                for step in 0..=2000 {
                    let t = scene.float.round_down(most * f64::from(step) / 2000.0);
                    let values = [t, -t].map(|t| plan.functions[0].program.run(t)[0]);
                    assert!(values.into_iter().all(f64::is_finite), "{text} at ±{t:e}: {values:?}");
                }
            }
            Err(refusal) => {
                assert!(matches!(refusal, Refusal::Unreachable { .. }), "{text}: {refusal:?}");
                refused += 1;
            }
        }
    }
    assert_eq!(refused, 2);
}

/// On the other side of the top a wrapped angle is a turn away, to its last place: rounded, it would be off by more than
/// truncation leaves here.
#[test]
fn a_turn_is_exact() {
    let text = "theta0 = π, velocity0 = 7.564e-10, tol = 2.69e-8, outputs = [wrapped]";
    for step in 25..45 {
        let scene = scene(&format!("struct Motion; {text}, t_max = {}", 0.51 + 1e-5 * f64::from(step)));
        assert!(plan(&scene).is_ok(), "{step}");
    }
}

/// Each result of each output that it knows the curve of, by a millionth of it.
#[test]
fn any_spoilt_result_is_seen() {
    for (start, outputs) in [
        ("theta0 = 2", vec!["theta", "velocity", "acceleration", "position"]),
        ("theta0 = -2, omega = 3", vec!["theta", "velocity", "acceleration", "position"]),
        ("theta0 = 1, velocity0 = 0.7", vec!["theta", "velocity"]),
        ("velocity0 = -3", vec!["velocity", "acceleration", "position"]),
    ] {
        for output in outputs {
            let scene = scene(&format!("struct Motion; {start}, tol = 1e-10, outputs = [{output}]"));
            let (task, plan) = (task::Task::new(&scene), plan(&scene).unwrap());
            assert_eq!(verify::broken(&scene, &task, &plan), None);
            for result in 0..plan.functions[0].program.results.len() {
                let mut spoilt = plan.clone();
                let Program { nodes, results, .. } = &mut spoilt.functions[0].program;
                let node = |op| crate::program::Node { op, float: crate::parse::Float::F64, name: None };
                nodes.push(node(Op::Constant { value: 1.0 + 1e-6, rest: 0.0 }));
                nodes.push(node(Op::Mul(results[result], nodes.len() - 1)));
                results[result] = nodes.len() - 1;
                assert_eq!(verify::broken(&scene, &task, &spoilt), Some(scene.outputs[0]), "{start} {output} {result}");
            }
        }
    }
}

/// Beyond the horizon any phase will do, but it is one of the motion: θ is no larger than it ever is.
#[test]
fn beyond_the_horizon_the_motion_goes_on() {
    for text in [
        "theta0 = 2, tol = 1e-6, t_max = 10",
        "theta0 = 2, tol = 1e-6, t_max = 10, omega = 30",
        "theta0 = 2, tol = 1e-3, t_max = 10, float = f32",
        "theta0 = 2, t_max = 10, outputs = [theta, velocity, acceleration]",
        "theta0 = 1, velocity0 = 0.5, t_max = 10",
        "velocity0 = 3, tol = 1e-9, t_max = 10, outputs = [velocity]",
        "theta0 = 7π/8, tol = 1e-6, t_max = 10, outputs = [velocity]",
        "theta0 = 0.2, tol = 1e-9, t_max = 10, omega = 1000, outputs = [velocity]",
        "theta0 = 3.1, tol = 1e-12, t_max = 10, omega = 0.01, outputs = [velocity]",
        "theta0 = 7π/8, tol = 1e-2, t_max = 10, float = f32, outputs = [velocity]",
        "theta0 = 3, tol = 1e-5, t_max = 10, float = f32, outputs = [velocity]",
        "theta0 = 0.62, tol = 2.5e-5, t_max = 10, float = f32, outputs = [velocity]",
        "theta0 = 2.8, tol = 1e-2, t_max = 10, outputs = [velocity]",
        "velocity0 = 2.2, tol = 1e-6, t_max = 10, outputs = [acceleration]",
    ] {
        let plan = planned(text);
        let mut random = Random::new(3);
        for (part, function) in plan.parts.iter().zip(&plan.functions) {
            let most = part.largest + part.bound.total();
            for i in 0..8000 {
                let t = plan.reduction.float.round(10.0 * 1.0115f64.powi(i) * (1.0 + random.unit()));
                let found = if t.is_finite() { function.program.run(t)[0] } else { 0.0 };
                assert!(found.abs() <= most, "{text} {t:e}: {found}");
            }
        }
    }
}

/// A refusal says what would help.
#[test]
fn refusals_are_explained() {
    let message = |text: &str, refusal: Option<Refusal>| {
        let scene = scene(&format!("struct Motion; {text}"));
        refusal.unwrap_or_else(|| plan(&scene).unwrap_err()).explain(&scene).to_string()
    };
    for (text, part) in [
        ("velocity0 = 3, tol = 1e-12", "or give a `t_max`, since the error of an angle grows with its turns, or use"),
        ("velocity0 = 3, tol = 1e-15", "or give a `t_max`, which comes closer"),
        ("velocity0 = 3, tol = 1e-17, t_max = 1e9", "or leave `tol` out for full precision"),
        ("velocity0 = 2.5, tol = 1e-12, t_max = 1e7, outputs = [theta, velocity]", "shorter `t_max`"),
        ("velocity0 = 2.5, tol = 1e-12, t_max = 1e7, outputs = [theta, wrapped]", "or use the output `wrapped`"),
        ("theta0 = 10deg, tol = 1e-2, method = small_angle", "give a short `t_max`"),
        ("velocity0 = 3, tol = 1e-17, outputs = [wrapped]", "or leave `tol` out for full precision"),
        ("velocity0 = 3, tol = 1e-17, t_max = 10", "or leave `tol` out for full precision"),
        ("theta0 = 1, tol = 1e-17", "`tol = 1e-17` is finer than can be promised here: the best found is "),
        ("theta0 = 1, tol = 1e-17", "ask for that, or leave `tol` out for full precision"),
        (
            "velocity0 = 3, tol = 1e-12, outputs = [theta, velocity, wrapped]",
            "finer than can be promised of `theta` here: the best found is ",
        ),
        ("theta0 = 1, tol = 1e-17, outputs = [theta, velocity]", "finer than can be promised here"),
        ("theta0 = 1, tol = 1e-12, float = f32", "or use `float = f64`, which comes closer"),
        ("theta0 = 1, tol = 1e-20, method = series", "finer than `method = series` can promise here"),
        ("theta0 = 1, tol = 1e-9, method = harmonic", "or leave `method` out"),
        ("theta0 = 1, tol = 1e-20, method = series", "or leave `method` and `tol` out for full precision"),
        ("theta0 = 1, tol = 1e-12, method = polynomial, float = f32", "or use `float = f64`"),
        ("theta0 = 1, tol = 1e-12, method = harmonic, float = f32", "or leave `method` out, and use `float = f64`"),
        ("velocity0 = 2.5, tol = 1e-3, float = f32, method = polynomial", "or give a `t_max`"),
        ("theta0 = 0.731π, n = 1", "`n = 1`: the argument of the arcsine in Eq. 22 exceeds 1 by "),
        // It is 1 − 6e-19.
        ("theta0 = 2.841789315695556635, n = 2", "can't be told from one that exceeds 1"),
        ("theta0 = 0.731π, n = 1", "the smallest number of terms that works is `n = 2`"),
        ("theta0 = π - 1e-14, n = 3", "no number of terms that `f64` can use works"),
        ("theta0 = 1, n = 40", "use an `n` from 1 to 10"),
        ("theta0 = 1, n = 40, float = f32", "use an `n` from 1 to 5"),
        ("theta0 = 3e-8, n = 10, float = f32", "; use `n = 1`"),
        ("theta0 = π - 1e-6, n = 500", "use an `n` from 91 to 122"),
        ("theta0 = π - 1e-6, n = 500, outputs = [theta, velocity]", "use an `n` from 92 to 122"),
        (
            "theta0 = π - 1e-7, n = 500, outputs = [velocity]",
            "and no number of terms was found that works for `velocity`: state the error as `tol` instead",
        ),
        ("theta0 = π - 1e-14, method = fourier, tol = 1e-9", "`fourier` can't come near the motion at this amplitude"),
    ] {
        let found = message(text, None);
        assert!(found.contains(part), "{text}: {found}");
    }
    // What can't be had at all, or bounded.
    let infinite = || Some(Refusal::Unreachable { best: f64::INFINITY });
    for (text, part) in [
        ("theta0 = 1, tol = 1e-17", "neither `tol = 1e-17` nor another: choose numbers nearer to 1"),
        (
            "velocity0 = 3, tol = 1e-17, outputs = [theta, velocity]",
            "another: choose numbers nearer to 1, or fewer outputs",
        ),
        ("theta0 = 1", "no error was found that can be promised here, neither the full precision of `f64` nor another"),
        ("theta0 = 1, omega = 1e300", "another: choose a unit of time in which ω, here 1e300, is nearer to 1"),
        (
            "theta0 = 1, n = 2, outputs = [velocity]",
            "`n = 2`: no useful bound can be proven for the error of θ̂'s velocity",
        ),
        ("theta0 = 1, n = 2", "`n = 2`: no bound can be proven for the error of θ̂ here"),
    ] {
        let found = message(text, infinite());
        assert!(found.contains(part), "{text}: {found}");
    }
    let found = message("theta0 = 1", Some(Refusal::Unreachable { best: 0.25 }));
    assert!(found.contains("the best found is 2.50e-1; state `tol = 2.50e-1`"), "{found}");
    let found = message("theta0 = 1", Some(Refusal::Broken { output: Output::Theta }));
    assert!(found.contains("the plan for `theta` misses its own error bound here"), "{found}");
}

#[test]
fn full_precision_is_promised_for_every_output_everywhere() {
    for start in [
        "theta0 = 1e-9",
        "theta0 = 1",
        "theta0 = 7π/8",
        "theta0 = 0.95π",
        "theta0 = 0.97π",
        "theta0 = 0.98π",
        "theta0 = 0.99π",
        "theta0 = 0.995π",
        "theta0 = 0.999π",
        "theta0 = 0.9999π",
        "theta0 = pi - 1e-6",
        "theta0 = pi - 1e-9",
        "theta0 = pi - 1e-12",
        "velocity0 = 1",
        "velocity0 = 1.999",
        "velocity0 = 2",
        "velocity0 = 2 + 1e-9",
        "velocity0 = 2.001",
        "velocity0 = 2.01",
        "velocity0 = 2.1",
        "velocity0 = 3",
        "velocity0 = 1e6",
        "theta0 = 2.9, velocity0 = 0.1, omega = 2",
        "theta0 = 1, velocity0 = 3",
        "theta0 = -1, velocity0 = -3",
        "theta0 = 3, velocity0 = -0.2",
    ] {
        for float in ["f64", "f32"] {
            for outputs in
                ["theta", "velocity", "acceleration", "position", "wrapped", "theta, velocity, acceleration, position"]
            {
                let text = format!("struct Motion; {start}, float = {float}, outputs = [{outputs}]");
                if let Err(refusal) = plan(&scene(&text)) {
                    panic!("{text}: {refusal:?}");
                }
            }
        }
    }
}
