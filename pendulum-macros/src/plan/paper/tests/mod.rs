//! The methods of the paper: as many terms as a tolerance needs, and errors that are known in closed form.

mod moments;

use super::*;
use crate::parse::Float;
use crate::plan::Bound;
use crate::plan::kernel::Core;
use crate::plan::plan;
use crate::plan::tests::probe::{assert_tight, evenly, largest_error};
use crate::plan::tests::truth::{State, distance};
use crate::testing::{Random, scene, swing};
use pendulum_runtime::fourier_analysis::FourierAnalysis;

pub(super) fn planned(text: &str) -> Result<Plan, Refusal> {
    plan(&scene(text))
}

pub(super) fn truncation(plan: &Plan) -> f64 {
    plan.parts[0].bound.truncation
}

/// `method = fourier` with `tol` is the smallest `n` that serves.
#[test]
fn a_tolerance_takes_the_fewest_terms_of_the_paper() {
    for (theta0, tol) in [("1", 1e-5), ("7π/8", 1e-4), ("0.97π", 1e-3), ("0.999π", 1e-6)] {
        let chosen = planned(&format!("theta0 = {theta0}, tol = {tol}, method = fourier")).unwrap();
        let fewer = planned(&format!("theta0 = {theta0}, n = {}", chosen.terms - 1));
        assert!(truncation(&chosen) <= tol, "{theta0} {tol}");
        match fewer {
            // A hundredth of the tolerance is left to rounding, or what an arcsine near 1 needs.
            Ok(fewer) => assert!(truncation(&fewer) > 0.7 * tol, "{theta0} {tol}: {} do", fewer.terms),
            Err(refusal) => assert!(matches!(refusal, Refusal::Overshoot { .. }), "{refusal:?}"),
        }
    }
}

/// The velocity of θ̂ comes as close as θ̂ itself, by as many terms as bring it there: each is smaller by the nome.
#[test]
fn velocities_of_the_paper() {
    for tol in ["1e-3", "1e-6", "1e-9", "1e-12"] {
        let terms = |output: &str| {
            let text = format!("struct A; theta0 = 2, tol = {tol}, method = fourier, outputs = [{output}]");
            planned(&text).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}")).terms
        };
        let (theta, velocity) = (terms("theta"), terms("velocity"));
        assert!(velocity <= theta + 2, "{tol}: {theta} {velocity}");
    }
}

/// That the cheapest phase leaves too little to the sum doesn't speak against finer ones: at every horizon there is
/// one.
#[test]
fn sums_that_leave_little_to_the_phase() {
    let least = truncation(&planned("theta0 = 2, tol = 1e-9, method = series").unwrap());
    // From half a period on: of a shorter horizon less counts.
    for exponent in 2..45 {
        let text = format!("theta0 = 2, tol = {:e}, t_max = {:e}, method = series", 1.1 * least, 2f64.powi(exponent));
        let plan = planned(&text).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
        assert!((truncation(&plan) / least - 1.0).abs() < 1e-6, "{text}: {:e} {least:e}", truncation(&plan));
    }
}

/// The velocity takes terms that θ doesn't.
#[test]
fn a_derivative_may_need_more_terms() {
    let terms = |output: &str| {
        let text = format!("struct A; theta0 = 0.9999π, tol = 1e-6, method = series, outputs = [{output}]");
        planned(&text).unwrap().terms
    };
    let (theta, velocity) = (terms("theta"), terms("velocity"));
    assert!(velocity > theta + 4, "{theta} {velocity}");
}

/// A tolerance out of reach is answered with what can be had: a few units of rounding of θ0.
#[test]
fn what_many_terms_reach() {
    for (theta0, float) in [("1e-3", "f64"), ("1", "f64"), ("1", "f32"), ("7π/8", "f32")] {
        for method in ["fourier", "series"] {
            let text = format!("theta0 = {theta0}, method = {method}, tol = 1e-20, float = {float}, t_max = 10");
            let Err(Refusal::Unreachable { best }) = planned(&text) else { panic!("{text}") };
            let scene = scene(&text);
            let swing = swing(&scene);
            assert!(best <= 20.0 * scene.float.rounding_unit() * swing.amplitude.to_f64(), "{text}: {best:e}");
        }
    }
}

/// sup |θ0 cos(2πt/T) − θ|/θ0 with 60 digits, by mpmath: the paper's table, recomputed.
#[test]
fn the_error_of_the_harmonic_motion() {
    for (theta0, relative) in [("π/3", 0.0094132), ("π/2", 0.0232892), ("4π/5", 0.0860), ("7π/8", 0.1234)] {
        let text = format!("theta0 = {theta0}, method = harmonic");
        let plan = planned(&text).unwrap();
        let stated = truncation(&plan) / plan.parts[0].largest;
        // The last digit of the table, and the samples' 1/cos(π/16).
        assert!(stated >= relative * 0.999 && stated <= 1.021 * relative, "{text}: {stated}");
    }
}

/// Small angles, Eq. 3: by the end of the horizon the phases differ by `(ω − 2π/T)·t_max`, here by far more than the
/// cosine does from the shape; and at most two amplitudes.
#[test]
fn the_drift_of_small_angles() {
    for (theta0, t_max) in [(0.1_f64, 10.0), (0.1, 1000.0), (0.3, 40.0)] {
        let text = format!("theta0 = {theta0}, t_max = {t_max}, method = small_angle");
        let plan = planned(&text).unwrap();
        // T/2π = 1 + θ0²/16 + 11θ0⁴/3072 (Lima's Eq. 6 and on).
        let slower = theta0 * theta0 / 16.0 + 11.0 * theta0.powi(4) / 3072.0;
        let angle: f64 = t_max * (1.0 - 1.0 / (1.0 + slower));
        let apart = 2.0 * theta0 * (0.5 * angle).min(std::f64::consts::FRAC_PI_2).sin();
        let shape = truncation(&planned(&format!("theta0 = {theta0}, method = harmonic")).unwrap());
        assert!(
            (truncation(&plan) / (apart + shape) - 1.0).abs() < 1e-4,
            "{text}: {:e} {apart:e} {shape:e}",
            truncation(&plan)
        );
    }
}

/// Of all times it is these two amplitudes, however slow the motion.
#[test]
fn small_angles_at_any_time() {
    for omega in ["1", "1e-20", "1e20"] {
        let planned = |method: &str| planned(&format!("theta0 = 0.3, omega = {omega}, method = {method}")).unwrap();
        let (found, shape) = (truncation(&planned("small_angle")), truncation(&planned("harmonic")));
        assert!((found / (0.6 + shape) - 1.0).abs() < 1e-12, "{omega}: {found:e}");
    }
}

/// The phase's error counts as on the steeper of the two curves, θ and A sin ωt about the lowest point: where both are
/// compared at one time it is ours that it moves along.
#[test]
fn phases_of_small_angles() {
    for theta0 in [0.5, 2.0, 3.0] {
        let scene = scene(&format!(
            "struct A; theta0 = {theta0}, omega = 3, method = small_angle, t_max = 1e-3, \
             outputs = [theta, velocity, acceleration]"
        ));
        let swing = swing(&scene);
        let sum = Sum::new(&scene, swing, Method::SmallAngle, 1).unwrap();
        for wanted in sum.wanted() {
            // A sin x, A cos x, A sin x again; x from the lowest point.
            let derivative = |x: f64| if wanted.output == Output::Velocity { -x.sin() } else { x.cos() };
            let unit = match wanted.output {
                Output::Velocity => 3.0,
                Output::Acceleration => 9.0,
                _ => 1.0,
            };
            let size = wanted.curve.size;
            for i in 0..=100 {
                let x = std::f64::consts::FRAC_PI_2 * f64::from(i) / 100.0;
                let slope = (theta0 * unit * derivative(x)).abs();
                assert!(std::f64::consts::PI * slope <= size.slope, "{theta0} {:?} at {x}", wanted.output);
                assert!(x * slope <= size.conditioning, "{theta0} {:?} at {x}", wanted.output);
            }
        }
    }
}

/// Its velocity comes to be twice as large as either is, when the phases have drifted half a period apart; before that
/// it is off by the sine of half the drift.
#[test]
fn velocities_of_small_angles() {
    for (t_max, most) in [(50.0, 1.15), (2000.0, 1.02)] {
        let text = format!("struct A; theta0 = 0.3, method = small_angle, outputs = [velocity], t_max = {t_max}");
        let scene = scene(&text);
        let swing = swing(&scene);
        let apart = t_max * (1.0 - std::f64::consts::TAU / swing.period.to_f64());
        let fastest = 2.0 * 0.15f64.sin();
        let seen = 2.0 * fastest * (0.5 * apart).min(std::f64::consts::FRAC_PI_2).sin();
        let stated = truncation(&planned(&text).unwrap());
        assert!(stated >= seen && stated <= most * seen, "{text}: {stated} {seen}");
    }
}

/// θ̂ as one polynomial is off by what that is off, besides.
#[test]
fn the_whole_arcsine_is_off_by_two_errors() {
    for (theta0, tol) in [("1", "1e-4"), ("1", "1e-6"), ("2", "1e-4")] {
        let text = format!("theta0 = {theta0}, method = fourier, tol = {tol}");
        let (scene, plan) = (scene(&text), planned(&text).unwrap());
        let swing = swing(&scene);
        let (k, complement) = (&swing.elliptic.modulus, &swing.elliptic.complementary);
        let bias = FourierAnalysis::new(k.to_double(), complement.to_double()).certified_bound(plan.terms, 1e-3);
        let Core::Polynomial(polynomial) = &plan.parts[0].kernel.core else { panic!("{text}: another kernel") };
        let expected = bias + polynomial.truncation;
        assert!(polynomial.truncation > 0.0 && (truncation(&plan) / expected - 1.0).abs() < 1e-12, "{text}");
    }
}

/// Velocities of motions 2²⁰ times as fast have as many terms, and what can be had of them is the same in their units.
#[test]
fn sums_of_other_rates() {
    for (method, tol) in
        [("fourier", "0.01"), ("fourier", "1e-10"), ("series", "1e-4"), ("series", "1e-10"), ("harmonic", "0.5")]
    {
        let ways = |tol: &str| {
            ["1", "1048576"].map(|omega| {
                let goal = format!("method = {method}, tol = {tol}, outputs = [velocity]");
                planned(&format!("struct A; theta0 = 2, omega = {omega}, {goal}"))
            })
        };
        let [slow, fast] = ways(tol).map(Result::unwrap);
        assert_eq!(slow.terms, fast.terms, "{method} {tol}");
        assert!((slow.worst() / fast.worst() - 1.0).abs() < 1e-4, "{method} {tol}");
        let [slow, fast] = ways("1e-20").map(|refused| match refused {
            Err(Refusal::Unreachable { best }) => best,
            other => panic!("{other:?}"),
        });
        assert!((slow / fast - 1.0).abs() < 0.1, "{method} {tol}: {slow:e} {fast:e}");
    }
    // The cheapest phase that will do.
    for exponent in (0..40).step_by(2) {
        let reduction = |log_omega: i32| {
            let (omega, t_max) = (2f64.powi(log_omega), 2f64.powi(exponent - log_omega));
            let goal = "method = series, tol = 1e-9, outputs = [velocity]";
            planned(&format!("struct A; theta0 = 2, omega = {omega}, t_max = {t_max:e}, {goal}")).unwrap().reduction
        };
        assert_eq!(reduction(0).describe(), reduction(20).describe(), "{exponent}");
    }
}

/// Near the top the harmonic motion and the exact one come to be as far apart as the amplitude, and no farther.
#[test]
fn the_harmonic_motion_near_the_top() {
    let plan = planned("theta0 = π - 1e-30, method = harmonic, t_max = 100").unwrap();
    // The number nearest to the amplitude is below it.
    let excess = truncation(&plan) / std::f64::consts::PI - 1.0;
    assert!(excess > 0.0 && excess < 1e-14, "{excess:e}");
}

/// Methods that can't keep a tolerance say what they reach.
#[test]
fn what_methods_cannot_do() {
    let Err(Refusal::Unreachable { best }) = planned("theta0 = 1, tol = 1e-3, method = harmonic") else {
        panic!("planned")
    };
    let reached = truncation(&planned("theta0 = 1, method = harmonic").unwrap());
    assert!(best >= reached && best < 1.1 * reached, "{best:e} {reached:e}");
    // As many terms as are asked for; for a tolerance no more than are of use.
    assert_eq!(planned("theta0 = π - 1e-7, n = 139").unwrap().terms, 139);
    assert!(planned("theta0 = π - 1e-14, tol = 1e-9, method = fourier").is_err());
}

/// θ̂ and its derivative 2y′/√(1 − y²), y = Σ(−1)ⁿ⁻¹k·b₂ₙ₋₁ cos((2n−1)πs), of swings to either side; and the distance
/// of both from the exact motion, which is what is promised of them.
#[test]
fn the_paper_and_its_derivative() {
    for (start, n, most) in [("theta0 = 1", 1, 1.1), ("theta0 = -0.7π", 2, 1.4), ("theta0 = 7π/8, omega = 2", 4, 12.0)]
    {
        let text = format!("struct Motion; {start}, n = {n}, outputs = [theta, velocity]");
        let (scene, plan) = (scene(&text), planned(&text).unwrap());
        let swing = swing(&scene);
        let k = swing.elliptic.modulus.to_f64();
        let weights: Vec<f64> = plan.coefficients.iter().map(|b| k * b.to_f64()).collect();
        assert_eq!((weights.len(), plan.terms), (n, n));
        let rate = 2.0 / swing.period.to_f64();
        let side = direction(swing.mirrored);
        let mut worst = [0.0_f64; 2];
        for i in 0..60 {
            let t = (f64::from(i) + 0.37) / 15.0 / rate;
            let sum = |f: &dyn Fn(f64) -> f64| {
                let term = |(n, w): (usize, &f64)| {
                    if n % 2 == 0 { w * f((2 * n + 1) as f64) } else { -w * f((2 * n + 1) as f64) }
                };
                weights.iter().enumerate().map(term).sum::<f64>()
            };
            let phase = std::f64::consts::PI * rate * t;
            let y = sum(&|m| (m * phase).cos());
            let slope = sum(&|m| -m * (m * phase).sin()) * std::f64::consts::PI * rate;
            let known = [2.0 * y.asin() * side, 2.0 * slope / (1.0 - y * y).sqrt() * side];
            let found = [plan.functions[0].program.run(t)[0], plan.functions[1].program.run(t)[0]];
            let both = plan.functions[2].program.run(t);
            assert_eq!(both, found, "{text} {t}");
            let state = State::at(&scene.motion, t);
            for (index, output) in [Output::Theta, Output::Velocity].into_iter().enumerate() {
                assert!((found[index] - known[index]).abs() < 1e-13, "{text} {t} {index}: {found:?} {known:?}");
                worst[index] = worst[index].max((found[index] - state.output(output)[0].to_f64()).abs());
            }
        }
        for (index, (part, worst)) in plan.parts.iter().zip(worst).enumerate() {
            let bound = part.bound.total();
            let most = if index == 0 { 1.2 } else { most };
            assert!(worst <= bound && bound <= most * worst, "{text} {index}: {worst:e} of {bound:e}");
        }
    }
}

/// What follows from θ̂: −ω² sin θ̂ and (sin θ̂, −cos θ̂), of swings to either side; and the distance of both from the exact
/// motion.
#[test]
fn what_follows_from_the_paper() {
    for (start, n, most) in [("theta0 = 1", 1, 1.1), ("theta0 = -0.7π", 2, 1.1), ("theta0 = 7π/8, omega = 2", 4, 1.2)]
    {
        let text = format!("struct Motion; {start}, n = {n}, outputs = [theta, acceleration, position]");
        let (scene, plan) = (scene(&text), planned(&text).unwrap());
        let square = scene.motion.omega.square().to_f64();
        let mut worst = [0.0_f64; 2];
        for i in 0..160 {
            let t = (f64::from(i) + 0.37) / 8.0;
            let [theta, acceleration, position] =
                [0, 1, 2].map(|function: usize| plan.functions[function].program.run(t));
            let (sine, cosine) = theta[0].sin_cos();
            let known = [(acceleration[0], -square * sine), (position[0], sine), (position[1], -cosine)];
            assert!(known.iter().all(|(found, known)| (found - known).abs() < 1e-14 * square), "{text} {t}: {known:?}");
            let state = State::at(&scene.motion, t);
            let context = scene.motion.omega.context();
            for (index, (output, found)) in
                [(Output::Acceleration, acceleration), (Output::Position, position)].into_iter().enumerate()
            {
                worst[index] = worst[index].max(distance(context, &found, &state.output(output)));
            }
        }
        for (part, worst) in plan.parts[1..].iter().zip(worst) {
            let bound = part.bound.total();
            assert!(worst <= bound && bound <= most * worst, "{text} {:?}: {worst:e} of {bound:e}", part.output);
        }
    }
}

/// The second derivative of a sum, −Σ wₙ((2n − 1)π·rate)² cos((2n−1)πs), and its distance from θ̈.
#[test]
fn accelerations_of_sums() {
    for (start, method, most) in [
        ("theta0 = 1", "harmonic", 1.05),
        ("theta0 = -2, omega = 3", "series, tol = 1e-3", 1.05),
        ("theta0 = 3, velocity0 = 0.05", "series, tol = 1e-6", 1.2),
        ("theta0 = 0.1, omega = 0.5, t_max = 30", "small_angle", 1.3),
        ("theta0 = 1.5, float = f32", "series, tol = 1e-4", 1.2),
    ] {
        let text = format!("struct A; {start}, method = {method}, outputs = [theta, acceleration]");
        let (scene, plan) = (scene(&text), planned(&text).unwrap());
        // θ̂″ from θ̂ by differences, whose step leaves as much as their rounding does.
        let theta = |t: f64| plan.functions[0].program.run(t)[0];
        let h = if scene.float == Float::F64 { 2f64.powi(-12) } else { 2f64.powi(-5) } / scene.motion.omega.to_f64();
        let square = scene.motion.omega.square().to_f64();
        for i in 0..40 {
            let t = f64::from(i - 20) / 8.0;
            let second = (theta(t + h) - 2.0 * theta(t) + theta(t - h)) / (h * h);
            let found = plan.functions[1].program.run(t)[0];
            let off = (found - second).abs() / square;
            assert!(off < if scene.float == Float::F64 { 1e-6 } else { 2e-3 }, "{text} {t}: {found} {second}");
        }
        let alone = text.replace("theta, acceleration", "acceleration");
        let (scene, plan) = (self::scene(&alone), planned(&alone).unwrap());
        let error = largest_error(&alone, &scene, &plan, &mut Random::new(3), 12);
        let bound = plan.parts[0].bound.total();
        assert!(bound <= most * error, "{text}: {error:e} of {bound:e}");
    }
}

/// Of a wave of weight 1, which is the result itself, what its polynomial is off by counts as of any other.
#[test]
fn waves_of_weight_one() {
    for float in ["f64", "f32"] {
        let evaluation = |theta0: &str| {
            let text = format!("struct A; theta0 = {theta0}, method = harmonic, t_max = 1e-4, float = {float}");
            planned(&text).unwrap().parts[0].bound.evaluation
        };
        let (one, less) = (evaluation("1"), evaluation("1 - 1e-9"));
        let truncation = 1e-3 * if float == "f64" { f64::EPSILON } else { f64::from(f32::EPSILON) };
        // Without the rounding of a product.
        assert!(one > truncation && one < 1.01 * less, "{float}: {one:e} {less:e}");
    }
}

/// Next to the top, where terms are hardly more than rounding, there is a smallest number still: one less overshoots.
#[test]
fn the_smallest_number_next_to_the_top() {
    let asked = |n: usize| planned(&format!("theta0 = π - 1e-8, n = {n}"));
    let Err(Refusal::Overshoot { smallest: Some(smallest), .. }) = asked(1) else { panic!("no number") };
    assert_eq!(asked(smallest).unwrap().terms, smallest);
    assert!(matches!(asked(smallest - 1), Err(Refusal::Overshoot { .. })), "{smallest}");
}

/// An argument of 1 − 9.1e-18 is told from one that exceeds 1; on a grid of 800 phases θ̂ is up to 0.51757 off, by mpmath.
#[test]
fn next_to_an_overshoot() {
    let error = planned("theta0 = 2.8417893156955566, n = 2").unwrap().parts[0].bound.total();
    assert!((0.51757..0.53).contains(&error), "{error}");
}

/// Where k′ has no float any more the argument of the arcsine exceeds 1 by as much as where it still has one.
#[test]
fn overshoots_next_to_the_top() {
    let overshoot = |theta0: &str| match planned(&format!("theta0 = {theta0}, n = 5")) {
        Err(Refusal::Overshoot { overshoot, .. }) => overshoot,
        other => panic!("{other:?}"),
    };
    let [far, near] = ["π - 1e-300", "π - 1e-400"].map(overshoot);
    assert!((near / far - 1.0).abs() < 0.01 && far > 0.17, "{near} {far}");
}

/// However small θ0 is, rounding takes no more than 8 units in its last place of θ̂, and 16 of its velocity, by a longer
/// formula; beside that one term leaves θ0³/64, and of the velocity three times as much and more.
#[test]
fn small_amplitudes_keep_their_digits() {
    for (float, unit) in [("f64", 2f64.powi(-53)), ("f32", 2f64.powi(-24))] {
        for theta0 in [1e-2, 1e-4, 1e-5, 5e-7, 1e-9, 1e-15, 1e-30] {
            for (output, units, part) in [("theta", 16.0, 64.0), ("velocity", 32.0, 12.0)] {
                let text = format!("struct A; theta0 = {theta0:e}, n = 1, float = {float}, outputs = [{output}]");
                let bound = planned(&text).unwrap().parts[0].bound;
                let rounding = bound.phase + bound.evaluation;
                assert!(rounding <= units * unit * theta0, "{text}: {rounding:e}");
                let left = theta0.powi(3) * (1.0 + theta0 * theta0) / part;
                assert!(bound.truncation <= left + units * unit * theta0, "{text}: {:e}", bound.truncation);
            }
        }
    }
}

/// Next to an overshoot a tolerance that is much coarser than the formula's error leaves the pieces no more than that.
#[test]
fn tolerances_far_above_the_formula() {
    assert_tight("struct A; theta0 = π - 2.955e-4, method = fourier, tol = 2.25e-2, t_max = 100", 2.0, evenly(1000));
}

/// A velocity's error of more than twice the largest velocity says nothing, if it wasn't asked for.
#[test]
fn useful_bounds() {
    let scenes = ["n = 2", "method = fourier, tol = 1e-3"]
        .map(|goal| scene(&format!("struct A; theta0 = 1, {goal}, outputs = [theta, velocity]")));
    for (scene, is_vague) in scenes.iter().zip([true, false]) {
        let parts = plan(scene).unwrap().parts;
        for (part, is_vague) in parts.iter().zip([false, is_vague]) {
            let useful = |evaluation: f64| {
                let bound = Bound { evaluation, ..part.bound };
                is_useful(&Part { bound, ..part.clone() }, scene)
            };
            let found = [1.5 * part.largest, 2.5 * part.largest, f64::INFINITY].map(useful);
            assert_eq!(found, [true, !is_vague, false], "{:?}", part.output);
        }
    }
}
