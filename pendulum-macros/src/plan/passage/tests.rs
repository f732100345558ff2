//! The kernel against the curves, with and without the terms that small images make unnecessary.

use super::quotient::linear;
use super::*;
use crate::motion::Regime;
use crate::plan::curve::{Curve, Curves, RotationCurves, SwingCurves};
use crate::plan::kernel::{Core, Kernel, function};
use crate::plan::part::Drafts;
use crate::plan::reduction::{Origin, Reduction};
use crate::plan::task::Task;
use crate::program::Op;
use crate::scene::Scene;
use crate::supremum::norm;
use crate::testing::scene;

const OUTPUTS: [Output; 4] = [Output::Theta, Output::Velocity, Output::Acceleration, Output::Position];

/// θ, θ̇ and θ̈ by the phase from an anchor; the first without the uniform part of a rotation.
fn curves(scene: &Scene) -> [Curve; 3] {
    match &scene.motion.regime {
        Regime::Swing(swing) => {
            let curves = SwingCurves::new(swing, &scene.motion.omega);
            [curves.angle(), curves.velocity(), curves.acceleration()]
        }
        Regime::Rotation(rotation) => {
            let curves = RotationCurves::new(rotation, &scene.motion.omega);
            [curves.angle(), curves.velocity(), curves.acceleration()]
        }
        Regime::Separatrix(_) => unreachable!("not tested"),
    }
}

struct Trial {
    scene: Scene,
    reduction: Reduction,
    orbit: Orbit,
    curves: [Curve; 3],
}

impl Trial {
    fn new(text: &str, float: &str) -> Self {
        let scene = scene(&format!("struct Motion; {text}, omega = 3, float = {float}"));
        let (task, curves) = (Task::new(&scene), curves(&scene));
        let reduction = task.reductions(&scene).into_iter().filter(|reduction| reduction.origin == Origin::Lowest);
        let reduction = reduction.into_iter().find(|reduction| reduction.unit == Double::ONE).unwrap();
        let orbit = task.passage_by(&reduction).unwrap().clone();
        Self { scene, reduction, orbit, curves }
    }

    /// |θ|, |θ̇|, |θ̈| or (sin |θ|, −cos θ) at the phase z ≥ 0 from the lowest point.
    fn exact(&self, output: Output, z: f64) -> Vec<f64> {
        let s = Double::new(0.5 - z);
        let angle = || {
            let angle = self.curves[0].at(s);
            // A rotation's angle is from the top.
            if self.orbit.sigma < 0.0 { (Double::PI - Double::PI * (s * 2.0) - angle).hi } else { angle.hi }
        };
        match output {
            Output::Velocity => vec![self.curves[1].at(s).hi.abs()],
            Output::Acceleration => vec![self.curves[2].at(s).hi.abs()],
            Output::Position => vec![angle().sin(), -angle().cos()],
            _ => vec![angle()],
        }
    }

    /// The kernel, the bound of its error, and what is seen of it.
    fn errors(&self, output: Output, limit: f64) -> (Passage, f64, f64) {
        let factor = match output {
            Output::Velocity => self.scene.motion.fastest().to_double(),
            Output::Acceleration => Double::new(9.0),
            _ => Double::ONE,
        };
        let passage = Passage::new(output, self.orbit.clone(), [0.0, 0.5], 0.5, limit);
        let kernel = Kernel::from(Core::Passage(Box::new(passage.clone())));
        let program = function(&self.reduction, &[&kernel]);
        let bound = (passage.truncation * factor.hi + passage.rounding(&program, f64::INFINITY)) / factor.hi;
        let phase = program.named("z").unwrap();
        let at =
            |i: u32| {
                // Denser at the lowest point.
                let z = self.reduction.float.round(0.5 * (f64::from(i) / 40.0).powi(2));
                let mut given = program.clone();
                given.nodes[phase].op = Op::Constant { value: z, rest: 0.0 };
                let exact = self.exact(output, z);
                let found = given.run(0.0);
                norm(
                    found.iter().zip(&exact).enumerate().map(|(index, (found, exact))| {
                        if index == 0 { found.abs() - exact.abs() } else { found - exact }
                    }),
                )
            };
        let seen = (0..=40).map(at).fold(0.0, f64::max) / factor.hi;
        (passage, bound, seen)
    }
}

/// Where the images are too many for the terms there are, they leave up to 5q′⁶.
#[test]
fn bounds_are_kept_and_tight() {
    for (text, float) in [
        ("theta0 = 1.6", "f64"),
        ("theta0 = π - 1e-4", "f64"),
        ("theta0 = π - 1e-4", "f32"),
        ("velocity0 = 6.3", "f64"),
        ("velocity0 = 6.0000001", "f64"),
    ] {
        let trial = Trial::new(text, float);
        let unit = trial.reduction.float.rounding_unit();
        for output in OUTPUTS {
            // The last is asked for at full precision, where Q/P is formed with care.
            for limit in [1e-2, 1e-6, 1e-13, 4e-16] {
                let (kernel, bound, seen) = trial.errors(output, limit);
                let about = format!("{text} {output:?} {limit:e}: {seen:e} of {bound:e}");
                // Not in the bound: the rounding of w, which counts with the phase, and that of the exact value.
                let beside = 1.33 * trial.orbit.rounding_of_exponent() + Float::F64.rounding_unit();
                assert!(seen <= bound + beside && bound <= 9.0 * seen, "{about}");
                let left = 5.0 * trial.orbit.q().powi(6);
                assert!(bound <= limit + left + unit * 110.0, "{about}");
                // No term is there that isn't needed: what the first omitted one would leave is little, or allowed.
                let weight = if output == Output::Velocity { 2.5 } else { 4.5 };
                let q = trial.orbit.q();
                let levels =
                    [(Images::Sum, q.sqrt()), (Images::Denominator, 2.0 * q), (Images::Correction, 2.0 * q.powi(3))];
                for (level, size) in levels {
                    assert_eq!(kernel.images >= level, weight * size > limit / 8.0, "{about}: {size:e}");
                }
            }
        }
    }
}

/// The velocity at the lowest point is the exact one, whatever is left out.
#[test]
fn velocities_at_the_lowest_point() {
    for (text, limits) in
        [("theta0 = 1.6", [1e-2, 1e-12]), ("velocity0 = 6.003", [1e-2, 1e-12]), ("velocity0 = 6.0000001", [1e-2, 1e-5])]
    {
        let trial = Trial::new(text, "f64");
        let fastest = trial.scene.motion.fastest().to_double();
        for limit in limits {
            let kernel = Passage::new(Output::Velocity, trial.orbit.clone(), [0.0, 0.5], 0.5, limit);
            let program = function(&trial.reduction, &[&Core::Passage(Box::new(kernel)).into()]);
            let mut given = program.clone();
            given.nodes[program.named("z").unwrap()].op = Op::Constant { value: 0.0, rest: 0.0 };
            let error = given.run(0.0)[0].abs() / fastest.hi - 1.0;
            assert!(error.abs() < 8.0 * f64::EPSILON, "{text} {limit:e}: {error:e}");
        }
    }
}

/// Beyond 24 binades E goes on to nought and G to what it is at the top. 1/(2³⁰E + 2⁻¹⁰) is largest where E is nought,
/// and 1/(1 + 2⁻¹⁰ − 2¹⁵G) where 2⁻¹⁵ is G: both 1024, with half a unit in the last place that is 2⁻⁴⁴.
#[test]
fn the_last_binade_stands_for_all_that_follow() {
    let kernel = |q: f64, image_exponent: i32| {
        let motion = &scene("struct Motion; velocity0 = 2").motion;
        let (rate, image) = (Double::new(60.0), Double::new(q));
        let orbit = Orbit { rate, sigma: 1.0, image, image_exponent, ..Orbit::separatrix(motion, 1.0) };
        Passage::new(Output::Theta, orbit, [0.0, 0.5], 0.5, 1e-16)
    };
    for (name, factor, constant) in [("power", 2f64.powi(30), 0.0), ("image_power", -(2f64.powi(15)), 1.0)] {
        let mut b = Builder::new(Float::F64);
        let t = b.input();
        let power = b.push(Op::PowerOfTwo { magic: t });
        b.name(power, name);
        let (factor, constant) = (b.constant(factor), b.constant(constant + 2f64.powi(-10)));
        let scaled = b.mul(power, factor);
        let sum = b.add(constant, scaled);
        let one = b.constant(1.0);
        let result = b.div(one, sum);
        let program = b.finish(vec![result]);
        // q′ = 2⁻⁴⁵, so that 30 binades on G is 2⁻¹⁵.
        let found = kernel(1.0, -45).rounding(&program, f64::INFINITY);
        assert!(found >= 2f64.powi(-44), "{name}: {found:e}");
    }
}

/// Of constants but 1, which are computed from the nome, the last bits are in doubt.
#[test]
fn constants_in_doubt() {
    for (constant, slack) in [(1.0, 0.0), (0.75, 6.0)] {
        let mut b = Builder::new(Float::F64);
        let x = b.input();
        let result = linear(&mut b, constant, 0.5, x);
        let program = b.finish(vec![result]);
        assert_eq!(program.run(3.0), [constant + 1.5]);
        let mut rests = program.nodes.iter().filter_map(|node| match node.op {
            Op::Constant { value, rest } => Some((value, rest / Float::F64.rounding_unit())),
            _ => None,
        });
        assert_eq!([rests.next(), rests.next()], [Some((constant, slack)), Some((0.5, 4.0))]);
    }
}

/// Parts of E and G: 2^(±f) = 1 + f²C ± fS.
#[test]
fn series_of_exponentials() {
    for f in [-0.5f64, -0.2, 1e-9, 0.3, 0.5] {
        let v = Double::new(f) * Double::new(f);
        let (even, odd) = (v * series(v, 2), Double::new(f) * series(v, 1));
        for (sum, known) in [(Double::ONE + even + odd, f.exp2()), (Double::ONE + even - odd, (-f).exp2())] {
            assert!((sum.hi - known).abs() < 4e-16, "{f}: {} {known}", sum.hi);
        }
    }
    // 2^½·2^½ = 2, in two words.
    let half = Double::new(0.25);
    let root = Double::ONE + half * series(half, 2) + series(half, 1) * 0.5;
    assert!((root * root - Double::new(2.0)).hi.abs() < 1e-30);
}

/// arctan 1 = π/4 and arctan 1/√3 = π/6, in two words, and the series 1 − v/3 + v²/5 − … for small v.
#[test]
fn arctangents() {
    let quarter = arctangent_ratio(Double::ONE) * 4.0 - Double::PI;
    let third = Double::ONE / 3.0;
    let sixth = arctangent_ratio(third) * third.sqrt() * 6.0 - Double::PI;
    assert!(quarter.hi.abs() < 1e-30 && sixth.hi.abs() < 1e-30, "{quarter:?} {sixth:?}");
    for v in [1e-6, 1e-5, 1e-4].map(Double::new) {
        let series = (0..8).rev().fold(Double::ZERO, |sum, j| Double::ONE / f64::from(2 * j + 1) - v * sum);
        assert!((arctangent_ratio(v) - series).hi.abs() < 1e-28, "{v:?}");
    }
}

/// A horizon of less than an anchor meets phases between these, from the lowest point, in units of the reduced phase.
#[test]
fn what_of_a_passage_is_met() {
    // Half a period of these takes 22.6 and 23.5.
    for (start, t_max, least, largest) in [
        ("theta0 = π - 1e-4", 5.0, 0.2786, 0.5),
        ("theta0 = π - 1e-4", 12.0, 0.0, 0.5),
        ("theta0 = π - 1e-4", 100.0, 0.0, 0.5),
        ("velocity0 = 1.999999999", 5.0, 0.0, 0.211),
    ] {
        let scene = scene(&format!("struct Motion; {start}, tol = 1e-6, t_max = {t_max}"));
        let task = Task::new(&scene);
        for reduction in task.reductions(&scene) {
            let unit = reduction.unit.hi;
            let found = task.distances_from_lowest(&reduction);
            let near = |found: f64, expected: f64| (found * unit - expected).abs() < 1e-2;
            assert!(near(found[0], least) && near(found[1], largest), "{start} {t_max}: {found:?} of {reduction:?}");
            assert!(found[1] <= reduction.half() && (least > 0.0) == (found[0] > 0.0), "{found:?}");
        }
    }
}

/// Whatever the unit of the phase, half of a passage is as long.
#[test]
fn passages_in_other_units() {
    let scene = scene("struct Motion; theta0 = π - 1e-4, tol = 1e-6, t_max = 100");
    let task = Task::new(&scene);
    let lowest: Vec<Reduction> =
        task.reductions(&scene).into_iter().filter(|reduction| reduction.origin == Origin::Lowest).collect();
    let orbit = task.passage_by(&lowest[0]).unwrap();
    let mut units = 0;
    for reduction in &lowest {
        let part = task.aims[0].passage_part(&task, &Drafts::default(), reduction, f64::INFINITY).unwrap();
        let Core::Passage(kernel) = part.kernel.core else { panic!("another kernel") };
        let (rate, half) = (kernel.orbit.rate, kernel.distances[1]);
        assert!((rate / (orbit.rate * reduction.unit) - Double::ONE).hi.abs() < 1e-30, "{reduction:?}");
        let length = rate.hi * half / (orbit.rate.hi * (0.5 + reduction.overshoot));
        assert!((1.0..1.0 + 1e-14).contains(&length), "{reduction:?}: {length}");
        units += usize::from(reduction.unit != Double::ONE);
    }
    assert!(units > 0);
}

/// The product with a rate in two words, of phases: never more than is said, and nearly as much.
#[test]
fn what_the_exponent_is_rounded_by() {
    for text in ["theta0 = π - 1e-3", "theta0 = π - 1e-9", "velocity0 = 6.001"] {
        let orbit = Trial::new(text, "f64").orbit;
        let relative = |i: u32| {
            let z = 0.5 * f64::from(i) / 100_003.0;
            let exact = orbit.rate * z;
            ((exact - Double::new(orbit.rate.hi * z)).hi / exact.hi).abs()
        };
        let (seen, bound) = (largest((1..=100_003).map(relative), 1.0), orbit.rounding_of_exponent());
        assert!(seen <= bound && bound < 1.02 * seen, "{text}: {seen:e} of {bound:e}");
    }
}
