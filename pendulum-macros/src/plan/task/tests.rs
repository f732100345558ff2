//! What an error of the phase is taken to cost, against samples of the motion; and the limits that outputs have to
//! keep.

use super::*;
use crate::parse::Float;
use crate::plan::curve::Curve;
use crate::plan::reduction::Origin;
use crate::plan::tests::truth::State;
use crate::testing::scene;
use pendulum_runtime::double::Double;

const ALL: &str = "outputs = [theta, velocity, acceleration, position]";

fn task(text: &str) -> (Scene, Task) {
    let scene = scene(&format!("struct Motion; {text}"));
    let task = Task::new(&scene);
    (scene, task)
}

/// Some reduction of the task, with these errors instead of its own.
fn wrong_by(scene: &Scene, task: &Task, [error, relative_error]: [f64; 2]) -> Reduction {
    Reduction { origin: Origin::Lowest, error, relative_error, ..task.reductions(scene).remove(0) }
}

/// sup |f′| and |w·f′| of a function of w.
fn suprema(f: impl Fn(f64) -> f64) -> [f64; 2] {
    const STEP: f64 = 1e-5;
    let at = |i: i32| {
        let w = f64::from(i) / 400.0;
        let slope = (f(w + STEP) - f(w - STEP)).abs() / (2.0 * STEP);
        [slope, w * slope]
    };
    (0..8000).map(at).fold([0.0, 0.0], |[a, b], [slope, conditioning]| [slope.max(a), conditioning.max(b)])
}

/// 2 gd w, and its derivative.
fn gd(w: f64) -> f64 {
    4.0 * (0.5 * w).tanh().atan()
}

/// The outputs of the separatrix, as functions of w = ωt, for ω = 1.
const SEPARATRIX: [fn(f64) -> f64; 4] = [gd, |w| 2.0 / w.cosh(), |w| -gd(w).sin(), |w| gd(w)];

#[test]
fn the_separatrix() {
    for omega in [3.0f64, 0.125] {
        let (scene, task) = task(&format!("velocity0 = {}, omega = {omega}, {ALL}", 2.0 * omega));
        let units = [1.0, omega, omega * omega, 1.0];
        let largest = [PI, 2.0 * omega, omega * omega, 1.0];
        for (index, (aim, f)) in task.aims.iter().zip(SEPARATRIX).enumerate() {
            assert_eq!((aim.size.largest, aim.size.unit), (largest[index], units[index]), "{:?}", aim.output);
            let suprema = suprema(f).map(|x| x * units[index]);
            let found = [[1.0, 0.0], [0.0, 1.0]].map(|errors| aim.size.phase_error(&wrong_by(&scene, &task, errors)));
            // Of all outputs the angle's is the largest.
            for (found, seen) in found.into_iter().zip(suprema) {
                assert!(seen <= found && found <= 2.02 * seen, "{:?}: {found} for {seen}", aim.output);
            }
            let both = aim.size.phase_error(&wrong_by(&scene, &task, [1e-3, 1e-2]));
            assert!((both / (1e-3 * 1.01 * found[0] + 1e-2 * found[1]) - 1.0).abs() < 1e-14);
        }
    }
}

/// Over an arc the separatrix is a swing's, and strays from that by no more than is said, though not by much less.
#[test]
fn beside_the_separatrix() {
    let starts = ["velocity0 = 6", "theta0 = π/2, velocity0 = -3*sqrt(2)", "theta0 = -2π/3, velocity0 = 3"];
    for (start, t_max) in starts.into_iter().flat_map(|start| [0.01, 0.3, 1.3].map(|t_max| (start, t_max))) {
        let (scene, task) =
            task(&format!("{start}, omega = 3, t_max = {t_max}, outputs = [theta, velocity, acceleration]"));
        let (arc, reach) = (task.over_arc(&scene).unwrap(), Arc::reach(&scene).unwrap());
        for aim in &arc.aims {
            let [curve] = aim.curves.as_slice() else { panic!("{start}") };
            let strayed = |end: f64| {
                let exact = State::at(&scene.motion, 2.0 * end * reach).output(aim.output).remove(0).to_double();
                (curve.at(Double::new(end)) - exact).hi.abs() / aim.size.unit
            };
            let (strayed, most) = (strayed(-0.5).max(strayed(0.5)), curve.omitted() / aim.size.unit);
            assert!(strayed <= most && most < 1e-19, "{start}, {t_max}: {strayed:e} {most:e}");
            assert!(strayed > 0.01 * t_max * most, "{start}, {t_max}, {:?}: {strayed:e} {most:e}", aim.output);
        }
    }
    for (t_max, arcs) in [("1.33", true), ("1.34", false)] {
        let (scene, task) = task(&format!("velocity0 = 6, omega = 3, t_max = {t_max}"));
        assert_eq!(task.over_arc(&scene).is_some(), arcs, "{t_max}");
    }
}

/// The largest |z·df/dz| of a curve, z being the phase from the lowest point.
fn conditioning(curve: &Curve) -> f64 {
    const STEP: f64 = 1e-9;
    let at = |i: u32| {
        let z = f64::from(i) / 8000.0;
        let [before, after] = [-STEP, STEP].map(|step| curve.at(Double::new(0.5 - z) + Double::new(step)));
        (z * (after - before).hi / (2.0 * STEP)).abs()
    };
    (1..=4000).map(at).fold(0.0, f64::max)
}

/// What is relative to the phase costs a passage the largest conditioning of the motion itself, near the top and far from it.
#[test]
fn passages() {
    for start in [
        "theta0 = π - 1e-5",
        "theta0 = π - 1e-9",
        "theta0 = 2.9",
        "theta0 = 2",
        "theta0 = 1",
        "velocity0 = 6.000001",
        "velocity0 = 6.3",
        "velocity0 = 7.5",
    ] {
        let (scene, task) = task(&format!("{start}, omega = 3, {ALL}"));
        let angle = match &scene.motion.regime {
            Regime::Rotation(rotation) => RotationCurves::new(rotation, &scene.motion.omega).whole_angle(),
            _ => task.aims[0].curves[0].clone(),
        };
        for aim in &task.aims {
            let steepest = if aim.curves.len() > 1 || aim.output.is_angle() { &angle } else { &aim.curves[0] };
            let conditioning = conditioning(steepest);
            let error = |errors| aim.passage_error(&wrong_by(&scene, &task, errors), 1e-16);
            let found = error([0.0, 1.0]) / conditioning;
            assert!((1.0..1.15).contains(&found), "{start} {:?}: {found}", aim.output);
            // Without an error of the reduction, that of w is left.
            let least = error([0.0, 0.0]) / conditioning;
            assert!((1e-16..1.15e-16).contains(&least), "{start} {:?}: {least:e}", aim.output);
            // An absolute error costs what it costs other kernels.
            let slope = aim.size.phase_error(&wrong_by(&scene, &task, [1.0, 0.0]));
            assert!((error([1.0, 0.0]) / slope - 1.0).abs() < 1e-12, "{start} {:?}", aim.output);
        }
    }
}

#[test]
fn turns_within_the_horizon() {
    // 1/T of a fast rotation is v/2π.
    let (_, task) = task("velocity0 = 1e9, t_max = 1e6");
    assert!((task.turns / (1e15 / std::f64::consts::TAU) - 1.0).abs() < 1e-12);
    let (_, task) = self::task("velocity0 = 1e9, t_max = 1e-9");
    assert!((task.turns - 1.0 / std::f64::consts::TAU).abs() < 1e-9);
    let (_, task) = self::task("theta0 = -1, velocity0 = 1e9, t_max = 1e-9");
    assert!((task.turns - 2.0 / std::f64::consts::TAU).abs() < 1e-9);
    let (_, task) = self::task("velocity0 = 1e9");
    assert_eq!(task.turns, 2f64.powi(53));
}

#[test]
fn the_fastest() {
    for (text, fastest) in [
        ("theta0 = π/2, omega = 3", 18f64.sqrt()),
        ("velocity0 = 7, omega = 3", 7.0),
        ("velocity0 = 6, omega = 3", 6.0),
    ] {
        assert!((scene(text).motion.fastest().to_f64() / fastest - 1.0).abs() < 1e-15, "{text}");
    }
}

/// At full precision 16 units of rounding of the largest value, 48 of a position; else what is asked for.
#[test]
fn limits() {
    let unit = Float::F64.rounding_unit();
    let largest = [2.0, 2.0 * 1f64.sin() * 3.0, 9.0, 1.0];
    let (_, full) = task(&format!("theta0 = 2, omega = 3, {ALL}"));
    let (_, loose) = task(&format!("theta0 = 2, omega = 3, {ALL}, tol = 1e-6"));
    let (_, tight) = task(&format!("theta0 = 2, omega = 3, {ALL}, tol = 1e-16"));
    for (index, largest) in largest.into_iter().enumerate() {
        let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{index}: {a:e} {b:e}");
        let units = if index == 3 { 48.0 } else { 16.0 };
        near(full.aims[index].size.largest, largest);
        near(full.aims[index].floor(), unit * largest);
        near(full.aims[index].limit, units * unit * largest);
        near(full.aims[index].truncation, unit * largest);
        let scale = [1.0, 3.0, 9.0, 1.0][index];
        near(loose.aims[index].limit, 1e-6 * scale);
        near(loose.aims[index].truncation, 1e-6 * scale);
        near(tight.aims[index].limit, 1e-16 * scale);
        // No less than an eighth of a unit of rounding is asked of truncation.
        near(tight.aims[index].truncation, (1e-16 * scale).max(unit * largest / 8.0));
    }
}

/// Mirror images, and at t = 0 the anchors passed; a rotation passes the lowest point half a turn after the top.
#[test]
fn directions_and_launches() {
    for (text, direction, launch, turning) in [
        ("theta0 = 3", 1.0, 0.0, false),
        ("theta0 = -3", -1.0, 0.0, false),
        ("velocity0 = 5", 1.0, 0.5, true),
        ("velocity0 = -5", -1.0, 0.5, true),
        ("velocity0 = 2", 1.0, 0.0, false),
        ("velocity0 = -2", -1.0, 0.0, false),
    ] {
        let (_, task) = task(text);
        assert_eq!((task.direction, task.launch.to_f64(), task.turns_over()), (direction, launch, turning), "{text}");
        if let Some(passage) = &task.passage {
            assert_eq!(passage.direction, direction, "{text}");
        }
    }
}

/// q′ = exp(−πK/K′) and w = (πK/K′)·phase, by the first terms of K and K′ near the top; none far from it.
#[test]
fn passages_by_their_nome() {
    for (theta0, complement) in [("π - 2e-3", 1e-3f64.sin()), ("π - 2e-5", 1e-5)] {
        let (_, task) = task(&format!("theta0 = {theta0}"));
        let passage = task.passage.unwrap();
        // q′ = (k′/4)² + 8(k′/4)⁴ (DLMF 19.5.5), πK/K′ = −ln q′.
        let quarter = complement * complement / 16.0;
        let nome = quarter + 8.0 * quarter * quarter;
        let found = passage.image.hi * 2f64.powi(passage.image_exponent);
        assert!((found / nome - 1.0).abs() < 1e-10, "{theta0}: {found:e} {nome:e}");
        assert!((passage.rate.hi * std::f64::consts::LN_2 / -nome.ln() - 1.0).abs() < 1e-10, "{theta0}");
        assert!((1.0..2.0).contains(&passage.image.hi), "{theta0}: {:?}", passage.image);
        assert!(passage.sigma == 1.0);
    }
    assert!(task("theta0 = 1").1.passage.is_none());
    // q′ = 0.05 at θ0 = 1.466869 (mpmath).
    assert!(task("theta0 = 1.47").1.passage.is_some() && task("theta0 = 1.46").1.passage.is_none());
}
