//! Full precision is kept for every output at all amplitudes: proven to be within 16 units of rounding of the largest
//! value (48 of 1 for a position), and seen within half of that (a position within all of it).
//!
//! ```text
//! PENDULA_SCENES=500 cargo test --release -p pendulum-macros plan::tests::full_precision::many -- --ignored --nocapture
//! ```

use super::probe::{Probe, assert_tight, evenly, largest_error};
use crate::fuzz::setting;
use crate::parse::Float;
use crate::plan::curve::{Curves as _, SwingCurves};
use crate::plan::observed::{FOR_A_MOMENT, observed};
use crate::plan::*;
use crate::testing::{Random, scene, swing};
use pendulum_runtime::double::Double;

/// From 1e-9 to π − 1e-9, and as near to the separatrix from above; launched anywhere; for any time or a short one.
fn random_start(random: &mut Random) -> String {
    let small = 10f64.powf(0.49 - 9.49 * random.unit());
    let start = match random.below(8) {
        0..4 => format!("theta0 = π - {small:.6e}"),
        4 => format!("theta0 = {small:.6e}"),
        5 => format!("velocity0 = 2 + {small:.6e}"),
        6 => format!("theta0 = {:.6}, velocity0 = {:.6}", 3.1 * random.unit(), 2.2 * random.unit()),
        _ => format!("theta0 = -{:.6}, velocity0 = {small:.6e}", 3.1 * random.unit()),
    };
    let horizon =
        if random.one_in(4) { format!(", t_max = {:.2e}", 10f64.powf(9.0 * random.unit())) } else { String::new() };
    format!("struct Motion; {start}{horizon}")
}

/// All outputs of one motion, which share the reduction of the phase.
fn together(start: &str) {
    for float in [Float::F64, Float::F32] {
        let word = float.word();
        let text = format!("{start}, float = {word}, outputs = [velocity, acceleration, wrapped, position]");
        let plan = plan(&scene(&text)).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
        for part in plan.parts {
            let units = if part.output == Output::Position { 48.0 } else { 16.0 };
            assert!(part.bound.total() <= units * float.rounding_unit() * part.largest, "{text}: {:?}", part.output);
        }
    }
}

/// The largest proven and observed errors of each output, as parts of what is allowed, and where they are.
fn run(scenes: u64, seed: u64, density: usize) -> Vec<[(f64, String); 2]> {
    let mut random = Random::new(seed);
    let mut worst = vec![[(0.0, String::new()), (0.0, String::new())]; 5];
    for _ in 0..scenes {
        let start = random_start(&mut random);
        let outputs = ["velocity", "acceleration", "wrapped", "position", "theta"];
        together(&start);
        for (output, worst) in outputs.iter().zip(&mut worst) {
            let float = random.choose(&[Float::F64, Float::F64, Float::F32]);
            let text = format!("{start}, float = {}, outputs = [{output}]", float.word());
            let scene = scene(&text);
            if *output == "theta" && matches!(scene.motion.regime, Regime::Rotation(_)) {
                continue;
            }
            let plan = plan(&scene).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
            let part = &plan.parts[0];
            let units = if *output == "position" { 48.0 } else { 16.0 };
            let allowed = units * float.rounding_unit() * part.largest;
            let mut probe = Probe::new(&scene, &plan);
            probe.everywhere(&mut random, density);
            assert!(probe.worst.1 <= part.bound.total(), "{text}: {:?}, {:?}", probe.worst, part.bound);
            for (found, worst) in [part.bound.total(), probe.worst.1].into_iter().zip(worst) {
                if found / allowed > worst.0 {
                    *worst = (found / allowed, format!("{text} {}", part.description));
                }
            }
        }
    }
    worst
}

/// Whether what is promised is kept of each output.
fn check(worst: Vec<[(f64, String); 2]>) {
    for [(proven, proven_of), (observed, observed_of)] in worst {
        let most = if observed_of.contains("[position]") { 1.0 } else { 0.5 };
        assert!(proven > 0.0 && proven <= 1.0, "{proven}: {proven_of}");
        assert!(observed <= most, "{observed}: {observed_of}");
    }
}

#[test]
fn full_precision_is_kept() {
    check(run(25, 1, 2));
}

/// sin(θ/2) and cos(θ/2) in pieces, squared: of swings one of them changes its sign at the lowest point, of rotations
/// both do at the top.
#[test]
fn positions_in_pieces() {
    let mut random = Random::new(6);
    for start in [
        "theta0 = π - 1e-6",
        "theta0 = 1e-7 - π, omega = 3",
        "theta0 = π - 1e-5, velocity0 = 1e-5, t_max = 1e4",
        "theta0 = -3, velocity0 = 0.14147440333",
        "velocity0 = 2 + 1e-13",
        "velocity0 = -2 - 1e-14, t_max = 1e3",
        "theta0 = 3, velocity0 = -0.1414744033355",
    ] {
        for float in [Float::F64, Float::F32] {
            let text =
                format!("struct Motion; {start}, method = polynomial, outputs = [position], float = {}", float.word());
            let (scene, plan) = (scene(&text), plan(&scene(&text)).unwrap());
            let part = &plan.parts[0];
            assert!(part.description.contains("as many of"), "{text}: {}", part.description);
            let error = largest_error(&text, &scene, &plan, &mut random, 8);
            let bound = part.bound.total();
            assert!(bound <= 12.0 * error, "{text}: {error:e} of {bound:e}");
            assert!(
                bound <= 48.0 * float.rounding_unit() && error <= 24.0 * float.rounding_unit(),
                "{text}: {error:e} of {bound:e}"
            );
        }
    }
}

/// The same, of `PENDULA_SCENES` scenes from `PENDULA_FUZZ_SEED`, densely.
#[test]
#[ignore = "minutes"]
fn many() {
    let worst = run(setting("PENDULA_SCENES", 150), setting("PENDULA_FUZZ_SEED", 2), 6);
    for (part, text) in worst.iter().flatten() {
        println!("{part:.3} {text}");
    }
    check(worst);
}

/// Where the most was seen of what was proven, of scenes near 2⁻⁴⁹ and 2⁻²⁰.
#[test]
fn half_is_not_exceeded() {
    for (text, t) in [
        ("theta0 = 0.6501, float = f32, outputs = [velocity]", 1.666_752_6),
        ("theta0 = 0.3292, float = f32, outputs = [theta]", 389.003_48),
        ("theta0 = 0.6103, float = f32, outputs = [velocity]", 146.355_56),
        ("theta0 = 0.6073, float = f32, outputs = [velocity]", 27.338_154),
        ("theta0 = 0.6467, t_max = 10, float = f32, outputs = [velocity]", 8.028_992_652_893_066),
        ("theta0 = 0.3865, float = f32, outputs = [theta]", 42.743_392_944_335_94),
        ("velocity0 = 1.2811, t_max = 10, outputs = [acceleration]", 9.547_491_909_459_476),
        ("theta0 = 1.4584, outputs = [acceleration]", 35.717_975_700_732_886),
    ] {
        let scene = scene(&format!("struct Motion; {text}"));
        let plan = plan(&scene).unwrap();
        let mut probe = Probe::new(&scene, &plan);
        probe.at(scene.float.round(t));
        let half = 8.0 * scene.float.rounding_unit() * plan.parts[0].largest;
        let worst = margin(&scene, &plan, &mut Random::new(1), 2000);
        assert!(probe.worst.1.max(worst) < half, "{text}: {:e} and {worst:e} of {half:e}", probe.worst.1);
    }
}

/// Beside the angle of a fast rotation its acceleration, which is a sine of the phase, leaves little room: it had up to 1.33
/// times 2⁻⁵⁰, at these times, where the first plan that kept 2⁻⁴⁹ was taken.
#[test]
fn accelerations_beside_angles_of_fast_rotations() {
    let mut random = Random::new(21);
    for (start, outputs, t) in [
        ("theta0 = -2, velocity0 = 123.8, t_max = 50.756", "theta, acceleration", 0.016_215_864_472_490_92),
        ("theta0 = 1, velocity0 = 13.94, t_max = 0.317154", "theta, acceleration", -0.071_253_166_345_114_61),
        ("theta0 = -2, velocity0 = 10.1, t_max = 0.439834", "acceleration, wrapped", 0.214_072_291_768_057_34),
        ("velocity0 = 388.6, t_max = 16168.9", "acceleration, wrapped", 3_698.173_271_190_751),
    ] {
        let scene = scene(&format!("struct Motion; {start}, outputs = [{outputs}]"));
        let plan = plan(&scene).unwrap();
        let place = plan.parts.iter().position(|part| part.output == Output::Acceleration).unwrap();
        let mut probe = Probe::of(&scene, &plan, place);
        probe.at(t);
        let horizon = probe.horizon;
        for _ in 0..100 {
            probe.at(horizon * (2.0 * random.unit() - 1.0));
        }
        let (t, error) = probe.worst;
        assert!(error <= 2f64.powi(-50) * plan.parts[place].largest, "{start}: {error:e} at {t:e}");
    }
}

/// Near the separatrix angles of rotations are made in pieces, launched anywhere, in either direction and type: wrapped as
/// good as those of swings, with their turns as what is promised of those.
#[test]
fn angles_of_rotations_in_pieces() {
    let mut random = Random::new(22);
    for (start, outputs) in [
        ("velocity0 = 2 + 1e-10", "wrapped"),
        ("velocity0 = -2 - 1e-10, t_max = 1e3", "theta, acceleration"),
        ("velocity0 = 2.0001, omega = 1, t_max = 1e6", "theta, acceleration"),
        ("theta0 = 2, velocity0 = -1.080605, t_max = 1e4", "theta, acceleration"),
        ("theta0 = -3, velocity0 = 0.141475", "wrapped, acceleration"),
        ("velocity0 = -2 - 1e-9, float = f32, method = polynomial", "wrapped, acceleration"),
        ("velocity0 = 3, t_max = 1e3", "theta, acceleration"),
    ] {
        let scene = scene(&format!("struct Motion; {start}, outputs = [{outputs}]"));
        let plan = plan(&scene).unwrap();
        let angle = plan.parts.iter().position(|part| part.output.is_angle()).unwrap();
        let part = &plan.parts[angle];
        assert_eq!(part.kernel.core.word(), "pieces", "{start}");
        let mut probe = Probe::of(&scene, &plan, angle);
        probe.everywhere(&mut random, 70);
        let (t, error) = probe.worst;
        assert!(error <= probe.bound, "{start}: {error:e} at {t:e}");
        if part.output == Output::Wrapped {
            assert!(error <= 8.0 * scene.float.rounding_unit() * part.largest, "{start}: {error:e} at {t:e}");
        }
    }
}

/// Where no plan of full precision's own is to be had, one of a finer tolerance is one.
#[test]
fn finer_promises_serve() {
    for text in [
        "theta0 = π - 1e-20, method = polynomial, outputs = [theta]",
        "theta0 = π - 1e-16, method = polynomial, outputs = [acceleration]",
        "velocity0 = 2 - 1e-30, method = polynomial, outputs = [velocity]",
    ] {
        let scene = scene(&format!("struct Motion; {text}"));
        assert!(cheapest(&scene).is_err(), "{text} is no example any more");
        let plan = plan(&scene).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
        let mut probe = Probe::new(&scene, &plan);
        probe.everywhere(&mut Random::new(5), 6);
        let full = 16.0 * scene.float.rounding_unit() * plan.parts[0].largest;
        assert!(plan.parts[0].bound.total() <= full && probe.worst.1 <= 0.5 * full, "{text}: {:?}", probe.worst);
    }
}

/// The largest error of a swing's θ, velocity or acceleration at so many random times, by series of two words.
fn margin(scene: &Scene, plan: &Plan, random: &mut Random, times: usize) -> f64 {
    let swing = swing(scene);
    let curves = SwingCurves::new(swing, &scene.motion.omega);
    let curve = match plan.parts[0].output {
        Output::Theta => curves.angle(),
        Output::Velocity => curves.velocity(),
        _ => curves.acceleration(),
    };
    let (rate, launch, period) = (swing.rate().to_double(), swing.launch.to_double(), swing.period.to_f64());
    let most = scene.t_max.as_ref().map_or(1e5 * period, Real::to_f64);
    let error = |t: f64| {
        let phase = rate * Double::new(t) + launch;
        let anchor = phase.hi.round();
        let exact = curve.at(phase - Double::new(anchor)) * if anchor % 2.0 == 0.0 { 1.0 } else { -1.0 };
        ((plan.functions[0].program.run(t)[0] - exact.hi) - exact.lo).abs()
    };
    let mut worst = (0.0, 0.0);
    for index in 0..times {
        let part = random.unit();
        let near = (worst.0 % period) + 0.1 * period * (random.unit() - 0.5) * part + period * (30.0 * part).floor();
        let t = match index % 4 {
            0 => 2.0 * period * part,
            1 => most * part,
            2 => near.abs(),
            _ => period * (most / period).powf(part),
        };
        let t = scene.float.round(t.min(most * 0.999_999));
        worst = if error(t) > worst.1 { (t, error(t)) } else { worst };
    }
    worst.1
}

/// What is observed of what is proven, on which the choice of plans rests (`observed`): of `PENDULA_SCENES` swings from
/// `PENDULA_FUZZ_SEED` that take most of 2⁻⁴⁹ or 2⁻²⁰.
#[test]
#[ignore = "minutes"]
fn margins() {
    let mut random = Random::new(setting("PENDULA_FUZZ_SEED", 2));
    for index in 0..setting("PENDULA_SCENES", 600) {
        let start = match index % 4 {
            0 => format!("theta0 = {:.4}", 0.02 + 1.5 * random.unit()),
            1 => format!("theta0 = {:.4}", 0.3 + 2.8 * random.unit()),
            2 => format!("theta0 = {:.4}, velocity0 = {:.4}", 1.4 * random.unit(), 0.02 + 1.2 * random.unit()),
            _ => format!("velocity0 = {:.4}", 0.02 + 1.9 * random.unit()),
        };
        let [output, float, horizon] = [
            &["theta", "velocity", "acceleration"][..],
            &["f32", "f64"],
            &["", "", "", ", t_max = 1", ", t_max = 10", ", t_max = 100", ", t_max = 3e3"],
        ]
        .map(|choices| random.choose(choices));
        let scene = scene(&format!("struct Motion; {start}{horizon}, float = {float}, outputs = [{output}]"));
        let plan = plan(&scene).unwrap();
        let Part { bound, largest, share, description, .. } = &plan.parts[0];
        let (proven, limit) = (bound.total(), 16.0 * scene.float.rounding_unit() * largest);
        let mut seen = margin(&scene, &plan, &mut random, 30_000);
        if seen > 0.4 * limit {
            seen = seen.max(margin(&scene, &plan, &mut random, 1_000_000));
        }
        let [of_proven, of_limit] = [proven, limit].map(|whole| seen / whole);
        println!("{of_proven:.3} {of_limit:.3} {share:.3} {start}{horizon} {float} {output} {description}");
        assert!(seen <= proven && of_limit <= 0.5, "{start}{horizon} {float} {output}: {of_limit}");
        // The choice of plans rests on no more being observed of what is mostly proven.
        let expected = if plan.reduction.is_time() { FOR_A_MOMENT } else { observed(scene.float) };
        assert!(proven < 0.6 * limit || of_proven <= expected, "{start}{horizon} {float} {output}: {of_proven}");
    }
}

/// Next to the lowest points before and after t = 0, on both sides of them, where the phase has to have all its digits;
/// of releases from rest the values at t and −t are one, to the bit.
#[test]
fn the_first_passages_keep_their_digits() {
    for (start, float) in [
        ("theta0 = π - 7.194052e-7", Float::F64),
        ("theta0 = -(π - 1e-9)", Float::F64),
        ("theta0 = π - 1e-142", Float::F32),
        ("theta0 = π - 1e-5, velocity0 = 1e-6", Float::F64),
        ("theta0 = 0.3, velocity0 = 1.9765", Float::F64),
        ("theta0 = -2, velocity0 = 1.08", Float::F64),
    ] {
        for output in ["theta", "velocity", "acceleration", "position"] {
            let scene = scene(&format!("struct Motion; {start}, float = {}, outputs = [{output}]", float.word()));
            let swing = swing(&scene);
            let plan = plan(&scene).unwrap();
            let mut probe = Probe::new(&scene, &plan);
            let (half, launch) = (swing.period.to_f64() / 2.0, swing.launch.to_f64());
            for lowest in [-0.5, 0.5, -1.5, 1.5] {
                for off in [1e-6, 1e-3, 0.02, 0.025, 0.1].into_iter().flat_map(|off| [off, -off]) {
                    let t = float.round((lowest + off - launch) * half);
                    probe.at(t);
                    let run = |t: f64| plan.functions[0].program.run(t);
                    let even = if output == "velocity" { -1.0 } else { 1.0 };
                    let mirrored: Vec<f64> = run(-t).into_iter().map(|value| value * even).collect();
                    assert!(launch != 0.0 || run(t) == mirrored, "{start}, {output} at {t:e}");
                }
            }
            let ((t, error), bound) = (probe.worst, plan.parts[0].bound.total());
            assert!(error <= bound, "{start}, {output}: {error:e} at {t:e}, bound {bound:e}");
        }
    }
}

/// Less than a quarter of a period, or half a turn, either way: before t = 0 as well as after it.
#[test]
fn moments_keep_their_digits() {
    let mut random = Random::new(3);
    for index in 0..20 {
        let start = match index % 4 {
            0 => "theta0 = 1.638165, velocity0 = 1.281984".to_owned(),
            1 => format!("theta0 = {:.6}", 3.1 * random.unit()),
            2 => format!("velocity0 = {:.6}", 2.1 + 3.0 * random.unit()),
            _ => format!("theta0 = {:.6}, velocity0 = {:.6}", 3.1 * random.unit(), 3.0 * random.unit() - 1.5),
        };
        let t_max = if index == 0 { 1.311 } else { 0.2 + 1.3 * random.unit() };
        let float = random.choose(&["f64", "f64", "f32"]);
        for output in ["velocity", "acceleration", "position", "theta"] {
            let text = format!("struct Motion; {start}, t_max = {t_max:.4}, float = {float}, outputs = [{output}]");
            let scene = scene(&text);
            let plan = plan(&scene).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
            let mut probe = Probe::new(&scene, &plan);
            for _ in 0..24 {
                probe.at(t_max * (2.0 * random.unit() - 1.0));
            }
            [1.0, 0.986_497_0, 0.98, 0.94].into_iter().flat_map(|part| [part, -part]).for_each(|part| {
                probe.at(t_max * part);
            });
            let ((t, error), bound) = (probe.worst, plan.parts[0].bound.total());
            assert!(error <= bound, "{text}: {error:e} at {t:e}, bound {bound:e}, {}", plan.parts[0].description);
        }
    }
}

/// A release from rest is even about t = 0, to the bit: at turning points too, where a phase is half an anchor from
/// either lowest point.
#[test]
fn releases_are_even() {
    let mut random = Random::new(5);
    for theta0 in ["3", "-3", "2.9", "0.99π", "7π/8", "π - 1e-7", "1"] {
        for (float, unit) in [(Float::F64, 2f64.powi(-53)), (Float::F32, 2f64.powi(-24))] {
            for output in ["theta", "velocity", "acceleration", "position"] {
                let text = format!("struct Motion; theta0 = {theta0}, float = {}, outputs = [{output}]", float.word());
                let scene = scene(&text);
                let swing = swing(&scene);
                let plan = plan(&scene).unwrap();
                let run = |t: f64| plan.functions[0].program.run(t);
                let sign = if output == "velocity" { -1.0 } else { 1.0 };
                let half = swing.period.to_f64() / 2.0;
                for index in 0..200 {
                    let turn = half * f64::from(index % 20);
                    let off = unit * 8.0 * (random.unit() - 0.5) * (turn + 1.0);
                    let t = float.round(if index < 100 { turn + off } else { 1e3 * random.unit() });
                    let mirrored: Vec<f64> = run(-t).iter().map(|value| sign * value).collect();
                    assert_eq!(run(t), mirrored, "{text} at {t:e}");
                }
            }
        }
    }
}

/// Over the top within a moment, either way round.
#[test]
fn moments_at_the_top_are_wrapped() {
    for start in [
        "theta0 = π, velocity0 = 1e-3, t_max = 0.1",
        "theta0 = -π, velocity0 = -2, t_max = 0.7",
        "theta0 = 3, velocity0 = 1, t_max = 0.5",
        "theta0 = -3, velocity0 = -3, t_max = 0.3",
        "theta0 = 1, velocity0 = 9, t_max = 0.34",
    ] {
        for goal in ["", ", tol = 1e-3", ", tol = 1e-10", ", float = f32"] {
            let text = format!("struct Motion; {start}{goal}, outputs = [wrapped]");
            let coarse = goal.contains("tol = 1e-3");
            assert!(!coarse || plan(&scene(&text)).unwrap().reduction.is_time(), "{text}");
            assert_tight(&text, if coarse { 4.0 } else { f64::INFINITY }, evenly(60));
        }
    }
}

/// A position from which a swing hardly moves: beside its cosine, which is 1, only its sine is rounded, far below a unit
/// of 1.
#[test]
fn positions_of_small_swings() {
    let mut random = Random::new(28);
    for (theta0, float, tol) in
        [("1e-10", "f32", 2e-17), ("3e-5", "f32", 1e-9), ("1e-12", "f64", 6e-25), ("1e-30", "f64", 4e-27)]
    {
        let scene =
            scene(&format!("struct A; theta0 = {theta0}, float = {float}, tol = {tol:e}, outputs = [position]"));
        let plan = plan(&scene).unwrap();
        let mut probe = Probe::new(&scene, &plan);
        probe.everywhere(&mut random, 20);
        let (bound, (t, error)) = (plan.parts[0].bound.total(), probe.worst);
        assert!(error <= bound && bound <= tol, "{theta0} at {t:e}: {error:e} of {bound:e}");
    }
}
