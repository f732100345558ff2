use super::*;
use crate::motion::Regime;
use crate::plan::tests::probe::Probe;
use crate::plan::tests::truth::State;
use crate::plan::{Part, Plan, Refusal, plan};
use crate::testing::scene;
use std::f64::consts::{PI, TAU};

fn rotation(text: &str) -> (Turning, Plan) {
    let plan = plan(&scene(&format!("struct Motion; velocity0 = 3, {text}"))).unwrap();
    let Finish::Turning(turning) = &plan.parts[0].kernel.finish else { panic!("{text}: no turning angle") };
    (*turning, plan)
}

fn is_held(plan: &Plan) -> bool {
    matches!(&plan.parts[0].kernel.finish, Finish::Turning(Turning { turns: Turns::Within { .. }, .. }))
}

/// What turns are rounded by if all else is evaluated with so large an error.
fn rounding(turning: &Turning, reduction: &Reduction, evaluation: f64) -> f64 {
    turning.own_rounding(reduction, &Bound { truncation: 0.0, phase: 0.0, evaluation })
}

#[track_caller]
pub(super) fn assert_near(found: f64, expected: f64, relative: f64) {
    assert!((found / expected - 1.0).abs() <= relative, "{found:e}, not {expected:e}");
}

/// Half units in the last place are 2⁻⁵² up to 4 (2⁻²³ in `f32`), 2⁻⁵¹ up to 8; of 2π·1000 they are 2⁻⁴¹ and 2⁻¹².
/// The `f64` of 2π is 2.449·10⁻¹⁶ below it, the `f32` 1.7485·10⁻⁷ above. From the top the mean is a product, and the sum
/// with it; if wrapped, so is that with half a turn, and what stays within that adds nothing.
#[test]
fn rounding_of_turns() {
    let [single, double] = [1.7485e-7, 2.4493e-16];
    for (text, origin, expected) in [
        (
            "tol = 1e-6, t_max = 10, float = f64",
            Origin::Anchor,
            3.0 * 2f64.powi(-52) + 0.5 * double + 2.0 * 2f64.powi(-41),
        ),
        (
            "tol = 1e-2, t_max = 10, float = f32",
            Origin::Anchor,
            2.0 * 2f64.powi(-23) + 0.5 * single + 2.0 * 2f64.powi(-41) + 2f64.powi(-12),
        ),
        ("tol = 1e-6, t_max = 10, outputs = [wrapped]", Origin::Anchor, 3.0 * 2f64.powi(-52) + double),
        ("tol = 1e-2, t_max = 10, outputs = [wrapped], float = f32", Origin::Anchor, 3.0 * 2f64.powi(-23) + single),
        ("outputs = [wrapped], float = f32", Origin::Lowest, 2.0 * 2f64.powi(-23) + 0.5 * single),
    ] {
        let (turning, plan) = rotation(text);
        assert_eq!(plan.reduction.origin, origin, "{text}");
        let turns = if text.contains("wrapped") { turning.turns } else { Turns::Counted };
        let turning = Turning { turns, most_turns: 1000.0, ..turning };
        assert_near(rounding(&turning, &plan.reduction, 0.0), expected, 1e-3);
    }
}

/// Up to five turns are exact products. Next to them the sums with up to half a turn and of all count, 2⁻⁵¹ up to 8; an error
/// of all else that leads beyond a power of two counts as well.
#[test]
fn rounding_of_few_turns() {
    let (turning, plan) = rotation("tol = 1e-6, t_max = 10");
    assert_eq!(plan.reduction.origin, Origin::Anchor);
    let turning = Turning { turns: Turns::Counted, ..turning };
    let near = |most_turns, error| rounding(&Turning { most_turns, ..turning }, &plan.reduction, error);
    let none = near(0.0, 0.0);
    for (turns, error, expected) in [
        (0.6, 0.0, 2f64.powi(-51)),
        (0.6, 1.2, 2f64.powi(-50) + 2.0 * 2f64.powi(-52)),
        (1.9, 0.0, 2f64.powi(-50)),
        (2.1, 0.0, 2f64.powi(-49)),
        (5.1, 0.0, 2.0 * 2f64.powi(-48)),
        // Their number, too, is rounded.
        (2f64.powi(52) - 0.5, 0.0, 2.0 * 2.0 + 21.0 * 0.5),
        (2f64.powi(52), 0.0, 2.0 * 2.0 + 21.0 * 0.5),
    ] {
        assert_near(near(turns, error) - none, expected - 2f64.powi(-52), 1e-3);
    }
}

/// An error of all else leads the sum of 26.04 with the mean rotation beyond 32.
#[test]
fn rounding_of_means_next_to_errors() {
    let (turning, plan) = rotation("tol = 1e-6, t_max = 10");
    let [exact, wrong] = [0.0, 6.0].map(|error| rounding(&turning, &plan.reduction, error));
    assert_near(wrong - exact, 2f64.powi(-49), 1e-3);
}

/// Only what is periodic feels an error of the phase where the mean rotation is added.
#[test]
fn phases_of_means() {
    let (turning, plan) = rotation("tol = 1e-6, t_max = 10");
    let Start::Top(periodic) = turning.start else { panic!("{turning:?}") };
    let reduction = Reduction { error: 1e-9, relative_error: 0.0, ..plan.reduction };
    assert_near(turning.felt(&reduction, 1.0), 1e-9 * periodic.slope, 1e-12);
    assert_eq!(turning.felt(&reduction, 1e-12), 1e-12);
    assert_eq!(Turning { turns: Turns::Counted, ..turning }.felt(&reduction, 1.0), 1.0);
}

/// So the rounding of what is periodic is analysed as far as the error that isn't felt leaves room for it.
#[test]
fn rounding_next_to_means() {
    for text in [
        "velocity0 = 2.018572, t_max = 7.046, float = f32, tol = 2.760128611116164e-6",
        "velocity0 = 2.020375, t_max = 6.717, float = f32, tol = 2.507793e-6",
        "velocity0 = -2.020375, t_max = 6.717, float = f32, tol = 2.12765253507558e-6",
        "velocity0 = 3.854662, t_max = 8.616, tol = 5.520124742626083e-15",
    ] {
        let plan = plan(&scene(&format!("struct Motion; {text}"))).unwrap();
        let Part { kernel, bound, .. } = &plan.parts[0];
        let evaluation = kernel.rounding(&plan.reduction, f64::INFINITY);
        let turns = kernel.finish.rounding_of_turns(&plan.reduction, &Bound { evaluation, ..*bound });
        assert!(bound.evaluation * (1.0 + 1e-6) >= evaluation + turns, "{text}: {bound:?}, {evaluation:e} {turns:e}");
    }
}

/// Whether it is completed in the cheaper way, given the truncation, the error of the phase and a limit.
fn becomes_cheaper(turning: Turning, reduction: &Reduction, mean: Mean, [truncation, phase, limit]: [f64; 3]) -> bool {
    turning.cheaper_if_good(reduction, mean, [truncation, phase], limit) != turning
}

/// The mean rotation may take all that is left of a limit.
#[test]
fn means_that_are_good() {
    let (turning, plan) = rotation("tol = 1e-6, t_max = 10");
    let (Turns::Steady(mean), Start::Top(periodic)) = (turning.turns, turning.start) else { panic!("{turning:?}") };
    let counted = Turning { turns: Turns::Counted, ..turning };
    let added = rounding(&turning, &plan.reduction, 0.0);
    for ([truncation, phase], limit, good) in [
        ([9.0, 0.0], 9.9, false),
        ([9.0, 0.0], 10.1, true),
        ([0.0, 0.0], 1.1, true),
        ([4.0, 5.0], 9.9, false),
        ([4.0, 5.0], 10.1, true),
        ([4.0, 50.0], 10.1, true),
    ] {
        // Of the phase's error so much is felt.
        let reduction =
            Reduction { error: added * 5.0 / periodic.slope, relative_error: 0.0, ..plan.reduction.clone() };
        let found = becomes_cheaper(counted, &reduction, mean, [truncation, phase, limit].map(|error| error * added));
        assert_eq!(found, good, "{truncation} {phase} {limit}");
    }
}

/// Angles that phases lead beyond half a turn are held there if that adds at most a quarter to other errors.
#[test]
fn held_angles_that_are_good() {
    let (turning, plan) = rotation("tol = 1e-6, t_max = 10, outputs = [wrapped]");
    let modulo = Turning { turns: Turns::Modulo, halfway: false, ..turning };
    let mean = Mean { rate: Double::ONE, start: Double::ZERO, turned: Double::ONE };
    let reduction = Reduction { overshoot: 1e-3, ..plan.reduction };
    let beyond = 1e-3 * turning.slope;
    for ([truncation, phase], limit, good) in [
        ([0.81, 0.0], 2.0, true),
        ([0.79, 0.0], 2.0, false),
        ([0.5, 1.51], 3.0, true),
        ([0.5, 1.49], 3.0, false),
        ([0.81, 0.0], 0.99, false),
        ([0.81, 0.0], 1.01, true),
    ] {
        let found = becomes_cheaper(modulo, &reduction, mean, [truncation, phase, limit].map(|error| error * beyond));
        assert_eq!(found, good, "{truncation} {phase} {limit}");
    }
}

/// What holds an angle leads away from exact ones that are farther beyond half a turn than what is evaluated is wrong.
#[test]
fn rounding_of_held_angles() {
    let (turning, plan) = rotation("tol = 1e-6, t_max = 10, outputs = [wrapped]");
    let held = Turning { turns: Turns::Within { beyond: 1e-3 }, ..turning };
    for (truncation, evaluation, expected) in [(2e-4, 3e-4, 5e-4), (0.0, 0.0, 1e-3), (2e-4, 9e-4, 0.0)] {
        let bound = Bound { truncation, phase: 0.1, evaluation };
        assert!((held.own_rounding(&plan.reduction, &bound) - expected).abs() <= 1e-14, "{truncation} {evaluation}");
    }
}

/// The second word of a rate has lost digits in the lowest binades.
#[test]
fn rates_without_all_digits() {
    for (power, all) in [(-270, true), (-272, false)] {
        let text =
            format!("struct Motion; velocity0 = 3e{power}, omega = 1e{power}, tol = 1e-3, t_max = 10e{}", -power);
        let Finish::Turning(turning) = &plan(&scene(&text)).unwrap().parts[0].kernel.finish else { panic!("no turns") };
        assert_eq!(turning.turns != Turns::Counted, all, "{power}");
    }
}

/// At tolerances the mean rotation is added, unless its rounding is more than what is left of them; at full precision turns
/// are.
#[test]
fn mean_rotations() {
    let steady = |text: &str| matches!(rotation(text).0.turns, Turns::Steady(_));
    for text in [
        "tol = 1e-6, t_max = 1e3",
        "tol = 1e-9, t_max = 1e3",
        "tol = 1e-14, t_max = 10",
        "tol = 1e-3, t_max = 100, float = f32",
        "tol = 30",
    ] {
        assert!(steady(text), "{text}");
    }
    for text in ["t_max = 1e3", "t_max = 10, float = f32", "tol = 3e-15, t_max = 10"] {
        assert!(!steady(text), "{text}");
    }
}

/// Up to 2⁵² of them and a half, at the end of a horizon of as many turns, they lose the half; their number as it is stated is
/// a product that was rounded.
#[test]
fn halves_of_many_turns() {
    for text in [
        "velocity0 = 6.499, t_max = 4463014018575903.5, tol = 5",
        "velocity0 = -3.838, t_max = 7968085813775628, tol = 4.5",
        "velocity0 = 7.086, t_max = 4076665083184175, tol = 6",
        "velocity0 = 7.492, t_max = 3847083445668163.5, tol = 6",
    ] {
        let scene = scene(&format!("struct Motion; {text}"));
        for plan in crate::plan::search::every(&scene) {
            let mut probe = Probe::new(&scene, &plan);
            for t in [probe.horizon, -probe.horizon] {
                assert!(probe.at(t) <= probe.bound, "{text}: {}", plan.reduction.describe());
            }
        }
        assert!(!matches!(plan(&scene), Err(Refusal::Broken { .. })), "{text}");
    }
}

/// Each is exact, and the next isn't.
#[test]
fn products_with_few_turns() {
    let is_exact = |halves: u32| Double::from_product(TAU, 0.5 * f64::from(halves)).lo == 0.0;
    let few = (2.0 * FEW_TURNS) as u32;
    assert!((1..few).all(is_exact) && !is_exact(few));
}

/// Pieces of a turn are counted, whose number is exact as long as it has no more than 53 bits.
#[test]
fn rounding_of_turns_in_pieces() {
    let (turning, plan) = rotation("outputs = [theta, acceleration]");
    let Turning { start: Start::Piece, .. } = turning else { panic!("{turning:?}") };
    for (turns, counted) in [(1000.0, 0.0), (2f64.powi(45), 0.0), (2f64.powi(47), 14.0)] {
        let of_turns = half_ulp(TAU * turns, Float::F64) * 2.0 + half_ulp(turns, Float::F64) * counted;
        let of_angle = 2f64.powi(-52);
        let turning = Turning { most_turns: turns, ..turning };
        assert_near(rounding(&turning, &plan.reduction, 0.0), of_turns + of_angle, 1e-6);
    }
}

/// Of an angle of which next to nothing is periodic no more than that is lost in the sum with the mean.
#[test]
fn rounding_of_next_to_uniform_rotations() {
    let (turning, plan) = rotation("outputs = [wrapped], float = f32");
    let Start::Top(periodic) = turning.start else { panic!("{turning:?}") };
    let uniform = Turning { start: Start::Top(Size { largest: 1e-12, ..periodic }), ..turning };
    // More than staying within half a turn changes.
    let evaluation = 1e-6;
    let lost = rounding(&turning, &plan.reduction, evaluation) - rounding(&uniform, &plan.reduction, evaluation);
    assert_near(lost, 2f64.powi(-23), 1e-3);
}

/// Phases that overshoot by much lead to angles above 4, whose units in the last place are twice as large.
#[test]
fn rounding_of_large_overshoots() {
    let (turning, plan) = rotation("tol = 1e-6, t_max = 10, outputs = [wrapped]");
    let near = |overshoot| {
        let reduction = Reduction { overshoot, ..plan.reduction.clone() };
        rounding(&turning, &reduction, 0.0)
    };
    let (largest, constant) = (PI + 0.2 * turning.slope, 0.2 * 2.4493e-16);
    assert!((4.0..8.0).contains(&largest), "{largest}");
    assert_near(near(0.2) - near(0.0), 3.0 * 2f64.powi(-52) + constant, 1e-3);
}

/// The numbers next to half a turn.
fn next_to_half_a_turn(float: Float) -> impl Iterator<Item = f64> {
    let ulp = 2.0 * half_ulp(PI, float);
    (-20..=20).flat_map(move |i| [1.0, -1.0].map(|sign| sign * (float.round(PI) + f64::from(i) * ulp)))
}

fn finished(finish: &Finish, float: Float, angle: f64) -> Double {
    let mut b = Builder::new(float);
    let t = b.input();
    let result = if *finish == Finish::Wrapped { modulo_turn(&mut b, t) } else { within_half_turn(&mut b, t) };
    let result = b.finish(vec![result]).run(angle)[0];
    assert!(is_wrapped(result), "{result} of {angle}");
    Double::new(result)
}

/// A turn more or less changes an angle by no more than is said, and some by as much.
#[test]
fn what_turns_change() {
    for (float, most) in [(Float::F64, 2.4493e-16), (Float::F32, 2f64.powi(-22))] {
        let changes = next_to_half_a_turn(float).map(|angle| {
            let change = finished(&Finish::Wrapped, float, angle) - Double::new(angle);
            let turns = (change.hi / (2.0 * PI)).round();
            (change - Double::PI * (2.0 * turns)).hi.abs()
        });
        let change = changes.fold(0.0, f64::max);
        assert_near(change, most, 1e-4);
        assert_near(change, Finish::Wrapped.rounding(0.0, float), 1e-4);
    }
}

/// So does what holds an angle within half a turn, that is itself as far beyond as it may be.
#[test]
fn what_staying_within_half_a_turn_changes() {
    for (float, most) in [(Float::F64, 5.6655e-16), (Float::F32, 1.5099e-7)] {
        let mut largest = 0_f64;
        let finish = Finish::Within { largest: Double::PI };
        for angle in next_to_half_a_turn(float) {
            let beyond = (Double::new(angle.abs()) - Double::PI).hi > 0.0;
            let exact = if beyond { Double::PI * angle.signum() } else { Double::new(angle) };
            let before = (exact - Double::new(angle)).hi.abs();
            let after = (exact - finished(&finish, float, angle)).hi.abs();
            assert!(after <= finish.rounding(before, float), "{angle}");
            let finish = Finish::Within { largest: exact.abs() };
            assert!(after <= finish.rounding(before, float), "{angle} {finish:?}");
            largest = largest.max(after);
        }
        assert_near(largest, most, 1e-4);
    }
}

/// After so many turns, whole ones and halves, it is 2π times their number, in every way of computing it.
#[test]
fn turns_are_counted() {
    for (text, direction) in [("velocity0 = 2.5", 1.0), ("velocity0 = -2.5", -1.0), ("velocity0 = -2.01", -1.0)] {
        let scene = scene(&format!("struct Motion; {text}, tol = 1e-6, t_max = 1e4"));
        let Regime::Rotation(rotation) = &scene.motion.regime else { panic!("a rotation") };
        let plans = crate::plan::search::every(&scene);
        assert!(plans.len() > 4);
        let between = |plan: &Plan| plan.functions[0].program.run(0.2 * rotation.period.to_f64())[0];
        let first = between(&plans[0]);
        for plan in plans {
            assert!((between(&plan) - first).abs() <= 2.1e-6, "{text}: {}", plan.reduction.describe());
            for turns in [0.0, 0.5, -0.5, 1.0, -1.0, 1.5, 3.0, 1000.0, -1000.5] {
                let t = turns * rotation.period.to_f64();
                let error = plan.functions[0].program.run(t)[0] - direction * turns * 2.0 * PI;
                assert!(error.abs() <= 1.1e-6, "{text} {turns}: {error}, {}", plan.reduction.describe());
            }
        }
    }
}

/// Beside the top, to which phases may overshoot, they are within half a turn and within their bounds, in every way of
/// computing them; what holds them there is as good as taking off a turn.
#[test]
fn wrapped_angles_beside_the_top() {
    let mut held = 0;
    for (text, tops) in [
        ("velocity0 = 2.5, tol = 1e-6, t_max = 1e4", [0.0, 1.0, -1.0, 1234.0]),
        ("velocity0 = -2.5, tol = 3e-15, t_max = 100", [0.0, 1.0, -7.0, 19.0]),
        ("velocity0 = 2.5, tol = 1e-9", [0.0, -1.0, 1e6, -1e12]),
        ("theta0 = 1, velocity0 = -3, tol = 1e-4, float = f32", [0.0, 1.0, -1.0, 5e4]),
        ("theta0 = π, velocity0 = -1e-3, tol = 1e-5, t_max = 1e5", [0.0, 1.0, -1.0, 5e3]),
        ("theta0 = π, velocity0 = 0.1, float = f32, tol = 1e-5, t_max = 300", [0.0, 1.0, -1.0, 20.0]),
        ("velocity0 = 2.0001, t_max = 1e5", [0.0, 1.0, -2.0, 5e3]),
    ] {
        let scene = scene(&format!("struct Motion; {text}, outputs = [wrapped]"));
        let plans = crate::plan::search::every(&scene);
        let mut probes: Vec<Probe> = plans.iter().map(|plan| Probe::new(&scene, plan)).collect();
        for turns in tops {
            let top = probes[0].first + turns * probes[0].step;
            let ulp = 2.0 * half_ulp(top, scene.float);
            for ulps in [0.0, 1.0, -1.0, 2.0, -2.0, 40.0, -40.0] {
                let t = probes[0].met(top + ulps * ulp);
                let state = State::at(&scene.motion, t);
                for probe in &mut probes {
                    assert!(probe.compare(t, &state) <= probe.bound, "{text}: {t:e}");
                }
            }
        }
        held += plans.iter().filter(|&plan| is_held(plan)).count();
    }
    assert!(held > 20, "{held}");
}

/// Motions that come closer to the top than their errors are.
#[test]
fn angles_of_swings_stay_within_half_a_turn() {
    for (text, times) in [
        ("theta0 = π - 0.0000000082218, tol = 0.00249, float = f32", [0.0, 1.0]),
        ("theta0 = π - 0.0000018052, omega = 0.1, tol = 0.000227", [0.0, 588.461_959_353_386_5]),
        ("theta0 = π - 2e-9, float = f32", [0.0, 0.5]),
        ("theta0 = 2e-9 - π, tol = 1e-3, t_max = 40", [0.0, -1.0]),
        ("velocity0 = 2, tol = 1e-3", [40.0, -1e300]),
        ("theta0 = π - 3.8190685071550958e-6, tol = 0.000025, t_max = 6.1e9", [0.0, 1.0]),
    ] {
        let plan = plan(&scene(&format!("struct Motion; {text}, outputs = [wrapped]"))).unwrap();
        for t in times {
            let angle = plan.functions[0].program.run(t)[0];
            assert!(is_wrapped(angle) && angle.abs() > 3.1, "{text}: {angle}");
            let mirrored = text.replace("0 = ", "0 = -(").replacen(',', "),", 1);
            let mirrored = self::plan(&scene(&format!("struct Motion; {mirrored}, outputs = [wrapped]"))).unwrap();
            assert_eq!(mirrored.functions[0].program.run(t)[0], -angle, "{text}");
        }
    }
}
