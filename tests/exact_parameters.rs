//! Full precision against 30-digit truth of the *exact* parameter, in every regime, from 1e-9 to π − 1e-9 and across
//! the separatrix, zero crossings ± 1 ulp and t up to 2⁵³ periods among the times; and against the runtime.
// Greek names and no other Greek, on purpose.
#![allow(mixed_script_confusables)]

use pendula::Pendulum;
use pendula_stress::promised::{ANY_TIME, UNIT, worst};
use pendula_stress::reference::{self, Exact, bits};
use std::collections::HashMap;

struct Row {
    t: f64,
    theta: Exact,
    velocity: Exact,
}

/// The rows of each `kind,parameter`.
fn rows() -> HashMap<String, Vec<Row>> {
    let mut all = HashMap::<String, Vec<Row>>::new();
    for cells in reference::rows(include_str!("truth/exact.csv")) {
        let row = Row { t: bits(cells[2]), theta: Exact::read(&cells[3..]), velocity: Exact::read(&cells[5..]) };
        all.entry(format!("{},{}", cells[0], cells[1])).or_default().push(row);
    }
    all
}

/// A compiled motion with ω = 1.
struct Compiled {
    name: &'static str,
    /// Infinite on the separatrix.
    period: f64,
    /// What the error of θ is relative to: the amplitude, or the larger of 1 and |θ(t)| where θ grows.
    amplitude: Option<f64>,
    fastest: f64,
    state: fn(f64) -> (f64, f64),
    theta: fn(f64) -> f64,
}

/// `compiled! { kind "rest" theta0: values… }`: motions of one kind, started by one parameter.
macro_rules! compiled {
    ($kind:ident $label:literal $parameter:ident: $($value:tt)*) => {
        [$({
            pendula::pendulum! {
                struct Motion;
                $parameter = $value, outputs = [theta, velocity]
            }
            let (period, amplitude, fastest) = compiled!(@$kind Motion);
            Compiled {
                name: concat!($label, ",", stringify!($value)),
                period,
                amplitude,
                fastest,
                state: Motion::state,
                theta: pendula::pendulum!($parameter = $value),
            }
        }),*]
    };
    (@swing $motion:ident) => { ($motion::PERIOD, Some($motion::AMPLITUDE), 2.0 * $motion::MODULUS) };
    (@rotation $motion:ident) => { ($motion::PERIOD, None, 2.0 / $motion::MODULUS) };
    (@separatrix $motion:ident) => { (f64::INFINITY, Some(core::f64::consts::PI), 2.0) };
}

fn check(compiled: &[Compiled]) {
    let rows = rows();
    let mut largest = [0.0_f64; 2];
    let mut checked = 0;
    let mut wrong = Vec::new();
    for motion in compiled {
        let name = motion.name.replace([' ', '(', ')'], "");
        for row in rows.get(&name).unwrap_or_else(|| panic!("exact.csv lacks {name}")) {
            if row.t.abs() > ANY_TIME * motion.period {
                continue;
            }
            let (theta, velocity) = (motion.state)(row.t);
            let alone = (motion.theta)(row.t);
            let scale = motion.amplitude.unwrap_or(row.theta.nearest.abs().max(1.0));
            let errors = [
                worst([theta, alone].map(|theta| row.theta.distance(theta))) / (scale * UNIT),
                row.velocity.distance(velocity) / (motion.fastest * UNIT),
            ];
            if !errors.iter().all(|&error| error <= 1.0) {
                wrong.push(format!("{name} at {:e}: {errors:.2?} of the promise", row.t));
            }
            largest = [0, 1].map(|i| worst([largest[i], errors[i]]));
            checked += 1;
        }
    }
    assert!(wrong.is_empty(), "{} of {checked}:\n{}", wrong.len(), wrong.join("\n"));
    println!("{checked} rows: theta {:.2}, velocity {:.2} of the promise", largest[0], largest[1]);
    assert!(checked >= 15 * compiled.len());
}

#[test]
fn releases_from_rest() {
    check(&compiled! { swing "rest" theta0:
        1e-9 1e-6 1e-4 1e-3 1e-2 (1π/180) (1π/18) (1π/6) (1π/4) (1/2) 1 (1π/3) (3/2) (1π/2) 2 (2π/3) (3π/4) (4π/5)
        (5π/6) (7π/8) (9π/10) (19π/20) 3
    });
}

#[test]
fn releases_near_the_top() {
    check(&compiled! { swing "rest" theta0:
        (99π/100) (999π/1000) (π-1e-3) (π-1e-4) (π-1e-6) (π-1e-9)
    });
}

#[test]
fn launches_from_the_bottom() {
    check(&compiled! { swing "launch" velocity0: 1e-9 1 (1999/1000) (2-1e-9) (2-1e-12) });
}

#[test]
fn the_separatrix() {
    check(&compiled! { separatrix "launch" velocity0: 2 });
}

#[test]
fn rotations() {
    check(&compiled! { rotation "launch" velocity0:
        (2+1e-12) (2+1e-9) (2+1e-6) (2001/1000) (201/100) (21/10) (5/2) 3 4 10 100 1e6
    });
}

/// The runtime sees the f64; from parameters that are f64 the two agree within what both promise, 2·2⁻⁵⁰.
#[test]
fn the_macro_and_the_runtime_agree() {
    let compiled = compiled! { swing "rest" theta0: (1/2) 1 (3/2) 2 3 };
    for (motion, theta0) in compiled.iter().zip([0.5, 1.0, 1.5, 2.0, 3.0]) {
        let runtime = Pendulum::new(theta0, 1.0).expect("a valid amplitude");
        approx::assert_relative_eq!(runtime.period(), motion.period, max_relative = f64::EPSILON);
        for i in -2000..2000 {
            let t = f64::from(i) * 0.37 * if i % 2 == 0 { 1.0 } else { 1e9 };
            let (theta, velocity) = (motion.state)(t);
            approx::assert_abs_diff_eq!(runtime.theta(t), theta, epsilon = 2.0 * UNIT * theta0);
            approx::assert_abs_diff_eq!(runtime.velocity(t), velocity, epsilon = 2.0 * UNIT * motion.fastest);
        }
    }
}
