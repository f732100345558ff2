//! Release angles from 1e-300 to the last number below π: the run-time pendulum of each, and a few hundred compiled
//! plans.

use std::f64::consts::PI;

use pendula::Pendulum;

use crate::finding::Finding;
use crate::generated::{Generated, generated};
use crate::motion::{Motion, Start};
use crate::promised::{RUN_TIME, UNIT};
use crate::random::Random;
use crate::report::Row;
use crate::session::{Merge, Session};
use crate::truth::{Output, Truth};

/// Times per amplitude.
const TIMES: u64 = 16;
/// Times per compiled plan.
const PLAN_TIMES: u64 = 256;

/// The run-time pendulum at `count` amplitudes, and all compiled plans.
pub fn run(session: &Session, count: u64) -> Vec<Row> {
    let mut rows = runtime(session, count);
    rows.extend(compiled(session, PLAN_TIMES));
    rows
}

/// The run-time pendulum at `count` amplitudes.
pub fn runtime(session: &Session, count: u64) -> Vec<Row> {
    session.share("run time", count, sweep).rows()
}

/// Ranges of amplitudes; accuracy is promised in the middle.
const RANGES: [(&str, f64, f64); 4] = [
    ("1e-300 to 1e-9", 1e-300, 1e-9),
    ("1e-9 to 1", 1e-9, 1.0),
    ("1 to π − 1e-12", 1.0, PI - 1e-12),
    ("π − 1e-12 to π − 3e-16", PI - 1e-12, PI),
];

/// Errors of θ and θ̇ by range, in units of the amplitude and the largest velocity.
#[derive(Default)]
struct Sweep([[Finding; 2]; RANGES.len()]);

impl Merge for Sweep {
    fn merge(&mut self, other: Self) {
        for (mine, others) in self.0.iter_mut().flatten().zip(other.0.into_iter().flatten()) {
            mine.merge(others);
        }
    }
}

impl Sweep {
    fn rows(self) -> Vec<Row> {
        let mut rows = Vec::new();
        for ((name, ..), findings) in RANGES.into_iter().zip(self.0) {
            for (output, found) in ["theta", "velocity"].into_iter().zip(findings) {
                let subject = format!("run time, θ0 from {name}");
                rows.push(Row { subject, output: output.into(), promise: UNIT, proven: None, observable: UNIT, found });
            }
        }
        rows
    }
}

/// The `number`-th amplitude: in turn evenly by logarithm, by angle, and by logarithm of the distance from the top.
fn amplitude(number: u64, random: &mut Random) -> f64 {
    // The `f64` called π is the last one below it.
    let last = PI;
    match (number, number % 4) {
        (0, _) => 1e-300,
        (1, _) => last,
        (_, 0) => random.scaled(1e-300, 1e-9).abs(),
        (_, 1) => random.scaled(1e-9, 1.0).abs(),
        (_, 2) => last * random.unit(),
        _ => (PI - random.scaled(1e-16, 1.0).abs()).min(last),
    }
}

fn sweep(number: u64, sweep: &mut Sweep) {
    let mut random = Random::new(number);
    let theta0 = amplitude(number, &mut random);
    let omega = random.scaled(1e-3, 1e3).abs();
    let range = RANGES.iter().position(|&(_, _, most)| theta0 <= most).unwrap_or(RANGES.len() - 1);
    let [angles, velocities] = &mut sweep.0[range];
    let (pendulum, mirror) = match (Pendulum::<f64>::new(theta0, omega), Pendulum::<f64>::new(-theta0, omega)) {
        (Ok(pendulum), Ok(mirror)) => (pendulum, mirror),
        other => return angles.fault(|| format!("θ0 = {theta0:e}, ω = {omega:e}: {other:?}")),
    };
    let motion = Motion::new(Start { theta0: theta0.into(), velocity0: 0.0.into(), omega: omega.into() });
    let fastest = 2.0 * (0.5 * theta0).sin() * omega;
    let [theta, velocity] = [Output::Theta, Output::Velocity].map(|one| Truth::without_tables(motion.clone(), one));
    for i in 0..TIMES {
        let t = match i {
            0 => 0.0,
            1 => pendulum.period() / 4.0,
            _ => random.scaled(1e-3, RUN_TIME) * pendulum.period(),
        };
        let (angle, speed) = pendulum.state(t);
        angles.tried += 1;
        velocities.tried += 1;
        angles.observe(theta.direct(t, [angle, 0.0]) / theta0, theta0);
        velocities.observe(velocity.direct(t, [speed, 0.0]) * omega / fastest, theta0);
        let symmetric =
            pendulum.theta(-t).to_bits() == angle.to_bits() && mirror.theta(t).to_bits() == (-angle).to_bits();
        if !symmetric || angle.abs() > theta0 || angle.is_nan() {
            angles.fault(|| format!("θ0 = {theta0:e}, ω = {omega:e} at {t:e}: {angle:e}, {}", pendulum.theta(-t)));
        }
    }
    if let Some(fault) = edges(&pendulum, theta0) {
        angles.fault(|| format!("θ0 = {theta0:e}, ω = {omega:e}: {fault}"));
    }
}

/// What else holds at any amplitude.
fn edges(pendulum: &Pendulum<f64>, theta0: f64) -> Option<String> {
    let period = pendulum.period();
    if !(period > 0.0 && period.is_finite()) || pendulum.amplitude() != theta0 || pendulum.theta(0.0) != theta0 {
        return Some(format!("{period:e}, {:e}, {:e}", pendulum.amplitude(), pendulum.theta(0.0)));
    }
    for t in [f64::MAX, -f64::MAX, 1e22, 5e-324, f64::MIN_POSITIVE] {
        let ((theta, velocity), (x, y)) = (pendulum.state(t), pendulum.position(t));
        let acceleration = pendulum.acceleration(t);
        let finite = [theta, velocity, acceleration, x, y].iter().all(|value| value.is_finite());
        if !finite || theta.abs() > theta0 || x.hypot(y) > 1.0 + UNIT {
            return Some(format!("{theta:e}, {velocity:e}, {acceleration:e}, {x:e}, {y:e} at {t:e}"));
        }
    }
    let not_finite = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    not_finite.into_iter().find(|&t| !pendulum.theta(t).is_nan()).map(|t| format!("a number at {t}"))
}

/// The error of every compiled plan at `times` times, in units of its proven bound, by what was asked for.
pub fn compiled(session: &Session, times: u64) -> Vec<Row> {
    let plans = generated();
    let mut rows: Vec<Row> = Vec::new();
    let mut scenes: Vec<(&str, Output, &str)> = Vec::new();
    for plan in &plans {
        let scene = (plan.float, plan.output, if plan.coefficients.is_empty() { plan.asked } else { "n" });
        if !scenes.contains(&scene) {
            scenes.push(scene);
        }
    }
    for scene in scenes {
        let same: Vec<&Generated> = plans
            .iter()
            .filter(|plan| (plan.float, plan.output) == (scene.0, scene.1))
            .filter(|plan| plan.asked == scene.2 || (scene.2 == "n" && !plan.coefficients.is_empty()))
            .collect();
        let asked = if scene.2.is_empty() { "full precision" } else { scene.2.trim_end_matches(',') };
        let subject = format!("{} compiled plans, {}, {asked}", same.len(), scene.0);
        let found = session.share(&subject, same.len() as u64, |i, found: &mut Finding| {
            examine(same[i as usize], times, found);
        });
        rows.push(Row { subject, output: scene.1.name().into(), promise: 1.0, proven: None, observable: 1.0, found });
        if session.stopped() {
            break;
        }
    }
    rows
}

fn examine(plan: &Generated, times: u64, found: &mut Finding) {
    let motion = plan.motion();
    let period = motion.period().to_f64();
    let truth = Truth::without_tables(motion, plan.output);
    let mut random = Random::new(plan.proven.to_bits());
    let horizon = plan.horizon();
    // The bound's own type may round it up.
    let most = plan.tolerance().map_or(f64::INFINITY, |tol| tol * (1.0 + f64::from(f32::EPSILON)));
    if plan.proven > most {
        found.fault(|| format!("{} {}: the bound {:e} exceeds the tolerance", plan.theta0, plan.asked, plan.proven));
    }
    for i in 0..times {
        let t = match i % 4 {
            0 => horizon * random.signed(),
            1 => random.scaled(1e-3 * period, horizon),
            2 => (random.scaled(0.5, horizon / period * 8.0) / 8.0).round() * period,
            _ => period * random.signed(),
        };
        let t = if plan.float == "f32" { f64::from(t as f32) } else { t };
        if t.abs() > horizon {
            continue;
        }
        let error = truth.direct(t, (plan.evaluate)(t));
        found.tried += 1;
        found.require(error / plan.proven, 1.0, t, || {
            format!("{} {} {} at {t:e}: {error:e} > {:e}", plan.theta0, plan.float, plan.asked, plan.proven)
        });
    }
}
