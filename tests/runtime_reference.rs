//! The runtime against independent truth. `cargo test --release --test runtime_reference -- --nocapture` prints the
//! table of the worst errors per regime and decade of t.

use pendula::{Pendulum, Regime};
use pendula_stress::motion::{Motion, Start};
use pendula_stress::promised::{RUN_TIME, UNIT};
use pendula_stress::random::Random;
use pendula_stress::reference::{Row, releases_and_launches, states};
use pendula_stress::truth::{Output, Truth};
use std::collections::BTreeMap;

fn pendulum(row: &Row) -> Pendulum<f64> {
    let made = if row.velocity0 == 0.0 {
        Pendulum::new(row.theta0, row.omega)
    } else {
        Pendulum::from_state(row.theta0, row.velocity0, row.omega)
    };
    made.expect("the reference data hold valid states")
}

fn periods(p: &Pendulum<f64>, t: f64) -> f64 {
    if p.regime() == Regime::Separatrix { 0.0 } else { t.abs() / p.period() }
}

/// Errors of θ and θ̇ as fractions of what is allowed: the promise, and beside the separatrix 2⁻⁴⁵ of what an ulp of
/// the initial velocity does to the phase by then.
fn errors(p: &Pendulum<f64>, row: &Row) -> (f64, f64) {
    let scale = if row.velocity0 == 0.0 { row.theta0.abs() } else { row.theta.nearest.abs().max(1.0) };
    let top_speed = row.omega * (2.0 * p.energy()).sqrt();
    let (theta, velocity) = p.state(row.t);
    let shift = time_shift(p, row) / (1_u64 << 45) as f64;
    (
        row.theta.distance(theta) / (scale * UNIT + top_speed * shift),
        row.velocity.distance(velocity) / (top_speed * (UNIT + row.omega * shift)),
    )
}

/// How much earlier or later everything happens about t if the initial velocity is an ulp larger. Released from rest
/// there is no such allowance.
fn time_shift(p: &Pendulum<f64>, row: &Row) -> f64 {
    if row.velocity0 == 0.0 || p.regime() == Regime::Separatrix {
        return 0.0;
    }
    let nearby = Row { velocity0: row.velocity0.next_up(), ..*row };
    let change = (pendulum(&nearby).period() - p.period()) / p.period();
    if change.is_finite() { row.t.abs() * change.abs() } else { 0.0 }
}

/// The decade of t in periods, as a label that sorts.
fn decade(periods: f64) -> String {
    match periods {
        x if x < 1.0 => "          < 1".into(),
        x => format!("10^{:02} .. 10^{:02}", x.log10() as u32, x.log10() as u32 + 1),
    }
}

#[test]
fn every_row_keeps_the_promise() {
    let mut worst = BTreeMap::<(String, String), (f64, f64, u32)>::new();
    for row in releases_and_launches().chain(states()) {
        let p = pendulum(&row);
        let periods = periods(&p, row.t);
        if periods > RUN_TIME {
            continue;
        }
        let (theta, velocity) = errors(&p, &row);
        assert!(theta <= 1.0, "theta is off by {theta} of the promise after {periods:e} periods: {row:?}");
        assert!(velocity <= 1.0, "velocity is off by {velocity} of the promise after {periods:e} periods: {row:?}");
        let kind = if row.velocity0 == 0.0 { "released" } else { "launched" };
        let entry = worst.entry((format!("{:?}, {kind}", p.regime()), decade(periods))).or_default();
        *entry = (entry.0.max(theta), entry.1.max(velocity), entry.2 + 1);
    }
    assert!(worst.len() > 20, "{} decades of regimes", worst.len());
    println!("worst error in units of the promise (2^-50 of |theta0|, or of max(|theta|, 1) when launched)");
    println!("{:22} {:>15} {:>8} {:>9} {:>6}", "regime", "periods", "theta", "velocity", "rows");
    for ((regime, decade), (theta, velocity, rows)) in worst {
        println!("{regime:22} {decade:>15} {theta:8.3} {velocity:9.3} {rows:6}");
    }
}

/// Products of the half angle's sine and cosine, each rounded: within 2⁻⁴⁹, which is twice what θ̇ keeps.
#[test]
fn positions_and_accelerations_keep_twice_the_unit() {
    let mut random = Random::new(50);
    // First some that are wrong by more than one unit.
    let mut looks = vec![
        ([-3.0265845364483854, 0.0, 3.0], 231.13079196817262),
        ([3.0556945370520467, 0.0, 3.0], -100_011_992.934_832_98),
        ([3.0556945370520467, 0.0, 3.0], 3677.721683936648),
        ([1.9490213953747402, 8.422385628739885, 3.0], -13984.884436131788),
        ([-2.8344627941297977, 0.2048165908710281, 1.0], 11.09574219064645),
        ([-0.022084060269600636, -2.134965806162988, 1.0], 666333.3662886379),
        // And rotations past the top by the dual series where they are rounded most.
        ([2.220399012934108, -1.301601728321415, 1.0], 3.3383386426105726),
        ([-2.6550974844977424, -1.044716850733133, 1.0], 4.671896964232301),
        ([1.1361040105337015, -1.9460260387919648, 1.0], 2.5531071314849),
        ([0.41077333542744415, 2.1835112567255317, 1.0], 5.8975865917432255),
    ];
    for i in 0..96 {
        let (theta0, launch) = (3.1 * random.signed(), 4.0 * random.signed());
        looks.push(([theta0, if i % 2 == 0 { 0.0 } else { launch }, 1.0], 1e6 * random.signed()));
    }
    let mut worst = [0.0_f64; 2];
    for ([theta0, velocity0, omega], t) in looks {
        let p = Pendulum::<f64>::from_state(theta0, velocity0, omega).expect("valid");
        let motion = Motion::new(Start { theta0: theta0.into(), velocity0: velocity0.into(), omega: omega.into() });
        let truth = |output| Truth::without_tables(motion.clone(), output);
        let (x, y) = p.position(t);
        let largest = if p.amplitude() < core::f64::consts::FRAC_PI_2 { p.amplitude().sin() } else { 1.0 };
        let errors = [
            truth(Output::Position).direct(t, [x, y]),
            truth(Output::Acceleration).direct(t, [p.acceleration(t), 0.0]) / largest,
        ];
        assert!(errors.iter().all(|error| *error <= 2.0 * UNIT), "{theta0} {velocity0} {omega} at {t}: {errors:?}");
        worst = [0, 1].map(|i| worst[i].max(errors[i] / UNIT));
    }
    println!("worst errors of position and acceleration in units of 2^-50: {worst:.3?}");
}

/// Where θ falls from θ0 to −θ0 for the first time, `time_at` of the f64 nearest to θ(t) is t, less the time that the
/// rest takes at θ̇. Turning points are left out: there the rest takes √rest.
#[test]
fn time_at_is_within_an_ulp() {
    let (mut worst, mut rows) = (0.0_f64, 0);
    for row in releases_and_launches().filter(|row| row.velocity0 == 0.0 && row.t > 0.0) {
        let p = pendulum(&row);
        let top_speed = (2.0 * p.energy()).sqrt();
        if row.t < p.period() / 2.0 && row.velocity.nearest < -0.01 * top_speed {
            let found = p.time_at(row.theta.nearest).expect("the motion was there");
            let delay = -row.theta.rest / row.velocity.nearest;
            let error = ((found - row.t) - delay).abs() / (row.t * f64::EPSILON);
            worst = worst.max(error);
            assert!(error <= 1.0, "{error} ulp: {row:?} {found:e}");
            rows += 1;
        }
    }
    assert!(rows > 20, "{rows} rows");
    println!("worst error of time_at: {worst:.2} ulp");
}

#[test]
fn beyond_the_horizon_all_is_finite_and_bounded() {
    let extremes = [2f64.powi(60), 1e22, -1e100, 1e300, f64::MAX, f64::MIN];
    for row in releases_and_launches() {
        let p = pendulum(&row);
        for t in [row.t].into_iter().chain(extremes) {
            let (theta, velocity) = p.state(t);
            let (x, y) = p.position(t);
            let all = [theta, velocity, x, y, p.acceleration(t), p.wrapped(t), p.small_angle(t)];
            assert!(all.iter().all(|value| value.is_finite()), "{row:?} at {t:e}: {all:?}");
            assert!(p.regime() == Regime::Rotation || theta.abs() <= p.amplitude(), "{row:?} at {t:e}: {theta}");
            assert!(p.wrapped(t).abs() <= core::f64::consts::PI);
        }
    }
}

#[test]
fn f32_rounds_the_exact_motion_of_its_own_parameters_once() {
    // 2⁻²⁴ is the rounding to f32; the f64 underneath is off by 2⁻⁵⁰ more.
    for row in states() {
        let [theta0, velocity0, omega, t] = [row.theta0, row.velocity0, row.omega, row.t].map(|x| x as f32);
        let narrow = Pendulum::<f32>::from_state(theta0, velocity0, omega).expect("valid");
        let wide = Pendulum::<f64>::from_state(theta0.into(), velocity0.into(), omega.into()).expect("valid");
        let (theta, velocity) = narrow.state(t);
        let (exact, speed) = wide.state(t.into());
        assert_eq!((theta, velocity), (exact as f32, speed as f32));
        assert_eq!(narrow.theta(t), theta);
    }
}
