//! What must hold of any motion, whatever the numbers: property tests over all regimes, with shrinking.

use core::f64::consts::PI;
use pendula::{Error, Pendulum, Regime};
use pendula_stress::promised::UNIT;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

fn amplitude() -> impl Strategy<Value = f64> {
    prop_oneof![
        0.01..3.1,
        (-300.0..0.0).prop_map(|e| 10_f64.powf(e)),
        (-15.6..-1.0).prop_map(|e| (PI - 10_f64.powf(e)).min(PI)),
    ]
}

/// Any regime, away from the separatrix by at least 1e-6 in k² so that conditioning stays out of the tolerances.
fn state() -> impl Strategy<Value = (f64, f64)> {
    (-3.1..3.1, prop_oneof![-3.0..3.0, -40.0..40.0]).prop_filter(
        "beside the separatrix",
        |(theta, velocity): &(f64, f64)| {
            let k2 = (velocity / 2.0).powi(2) + (theta / 2.0).sin().powi(2);
            (k2 - 1.0).abs() > 1e-6 && k2 > 1e-6
        },
    )
}

fn released(theta0: f64) -> Pendulum<f64> {
    Pendulum::new(theta0, 1.0).expect("an amplitude below pi")
}

fn launched((theta, velocity): (f64, f64)) -> Pendulum<f64> {
    Pendulum::from_state(theta, velocity, 1.0).expect("a finite state")
}

/// The largest |θ̇|, from the energy.
fn top_speed(p: &Pendulum<f64>) -> f64 {
    (2.0 * p.energy()).sqrt()
}

/// The same 2000 cases every time; the environment variables `PROPTEST_CASES` and `PROPTEST_RNG_SEED` choose others.
fn config() -> ProptestConfig {
    let chosen = ProptestConfig::default();
    let given = |name| std::env::var_os(name).is_some();
    ProptestConfig {
        cases: if given("PROPTEST_CASES") { chosen.cases } else { 2000 },
        rng_seed: if given("PROPTEST_RNG_SEED") { chosen.rng_seed } else { RngSeed::Fixed(1656) },
        failure_persistence: None,
        max_global_rejects: u32::MAX,
        ..chosen
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn mirrored_in_time_and_angle_to_the_bit(theta0 in amplitude(), t in -1e9_f64..1e9) {
        let (p, mirrored) = (released(theta0), released(-theta0));
        prop_assert_eq!(p.theta(-t).to_bits(), p.theta(t).to_bits());
        prop_assert_eq!(mirrored.theta(t).to_bits(), (-p.theta(t)).to_bits());
        prop_assert_eq!(p.velocity(-t), -p.velocity(t));
        prop_assert_eq!(mirrored.velocity(t), -p.velocity(t));
        prop_assert!(p.theta(t).abs() <= theta0);
    }

    /// From 1e-300 to the last `f64` below π: starts at θ0, passes zero at T/4 and −θ0 at T/2, with its whole energy.
    #[test]
    fn every_amplitude_keeps_its_landmarks(theta0 in amplitude()) {
        let p = released(theta0);
        let (quarter, half) = (p.period() / 4.0, p.period() / 2.0);
        prop_assert_eq!((p.amplitude(), p.state(0.0)), (theta0, (theta0, 0.0)));
        prop_assert!(p.theta(half) + theta0 <= UNIT * theta0, "{}", p.theta(half));
        // T is rounded by up to 2⁻⁵³ of itself, half of which is T/4's share of it at top speed.
        let speed = 2.0 * (theta0 / 2.0).sin();
        prop_assert!(p.theta(quarter).abs() <= UNIT * theta0 + speed * quarter * f64::EPSILON);
        prop_assert!((p.velocity(quarter) + speed).abs() <= UNIT * speed);
        prop_assert!((p.period() / 4.0 - p.complete_integral()).abs() <= f64::EPSILON * quarter);
    }

    #[test]
    fn mirrored_states_move_mirrored(start in state(), t in -1e6_f64..1e6) {
        let (p, mirrored) = (launched(start), launched((-start.0, -start.1)));
        prop_assert_eq!(mirrored.theta(t), -p.theta(t));
        prop_assert_eq!(mirrored.velocity(t), -p.velocity(t));
    }

    /// Against (sin(θ/2))² + (θ̇/2ω)² = k²: both squares carry twice a promised error.
    #[test]
    fn energy_is_constant(start in state(), t in -1e6_f64..1e6) {
        let p = launched(start);
        let (theta, velocity) = (p.wrapped(t), p.velocity(t));
        let energy = velocity * velocity / 2.0 + 2.0 * (theta / 2.0).sin().powi(2);
        prop_assert!((energy - p.energy()).abs() <= 8.0 * UNIT * p.energy().max(1.0), "{} {}", energy, p.energy());
    }

    /// The outputs agree: θ̈ = −sin θ, position = (sin θ, −cos θ), wrapped θ.
    #[test]
    fn outputs_agree(start in state(), t in -1e6_f64..1e6) {
        let p = launched(start);
        let wrapped = p.wrapped(t);
        let (x, y) = p.position(t);
        prop_assert!((x - wrapped.sin()).abs() <= 4.0 * UNIT);
        prop_assert!((y + wrapped.cos()).abs() <= 4.0 * UNIT);
        prop_assert_eq!(p.acceleration(t), -x);
        prop_assert_eq!(p.state(t), (p.theta(t), p.velocity(t)));
        prop_assert!(wrapped.abs() <= PI);
        let turns = (p.theta(t) - wrapped) / (2.0 * PI);
        prop_assert!((turns - turns.round()).abs() <= 8.0 * UNIT * turns.abs().max(1.0));
    }

    /// The equation of motion by central differences of the computed θ and θ̇. With step h the truncation is at most
    /// h²/6 times the third derivative (at most v(v² + 1) for θ, (v² + 1)² for θ̇), the rounding 4 promised errors / h.
    #[test]
    fn the_equation_of_motion_holds(start in state(), t in -1e3_f64..1e3) {
        let p = launched(start);
        let h = 1.0 / 8192.0; // t ± h is exact
        let t = (t * 8192.0_f64).round() / 8192.0;
        let v = top_speed(&p) + 1.0;
        let scale = p.theta(t).abs() + v;
        let rounding = 8.0 * UNIT * scale / h;
        let rate = (p.theta(t + h) - p.theta(t - h)) / (2.0 * h);
        prop_assert!((rate - p.velocity(t)).abs() <= h * h * v.powi(3) + rounding);
        let change = (p.velocity(t + h) - p.velocity(t - h)) / (2.0 * h);
        prop_assert!((change - p.acceleration(t)).abs() <= h * h * v.powi(4) + rounding);
    }

    /// Resumed from its own state at t1, a motion goes on as it was. The state's rounding (2⁻⁵⁰) changes energy and so
    /// the period: its effect grows with t2 like the derivative of the period, bounded here by staying 1e-2 away from
    /// the separatrix and from rest in k².
    #[test]
    fn motions_compose(start in state(), t1 in -1e3..1e3, t2 in -30.0_f64..30.0) {
        let p = launched(start);
        let k2 = p.energy() / 2.0;
        prop_assume!((k2 - 1.0).abs() > 1e-2 && k2 > 1e-2);
        let resumed = { let (theta, velocity) = p.state(t1); launched((theta, velocity)) };
        prop_assert_eq!(resumed.regime(), p.regime());
        let (angle, speed) = (p.theta(t1 + t2), p.velocity(t1 + t2));
        // t1 + t2 rounds by up to 2⁻⁴⁴, during which the angle moves at most at top speed.
        let scale = angle.abs() + top_speed(&p) + 1.0;
        let tolerance = scale * (2.0_f64.powi(-43) + 4e3 * UNIT * (1.0 + t2.abs()));
        prop_assert!((resumed.theta(t2) - angle).abs() <= tolerance, "{} {}", resumed.theta(t2), angle);
        prop_assert!((resumed.velocity(t2) - speed).abs() <= tolerance * scale);
    }

    /// θ(time_at(θ(t))) = θ(t), at most t for t in the first period, and no earlier time on a fine grid does.
    #[test]
    fn time_at_inverts_theta(start in state(), fraction in 0.0_f64..1.0) {
        let p = launched(start);
        let t = fraction * p.period();
        let theta = p.theta(t);
        let found = p.time_at(theta).expect("reached, since it was there");
        let slack = 4.0 * UNIT * (theta.abs().max(1.0) + top_speed(&p) * found);
        prop_assert!((p.theta(found) - theta).abs() <= slack, "{} {} at {}", p.theta(found), theta, found);
        // At a turning point half an ulp of θ is √ulp of t.
        prop_assert!(found <= t + 1e-7 * p.period(), "{} {}", found, t);
        for i in 0..64 {
            let (a, b) = (found * f64::from(i) / 64.0, found * f64::from(i + 1) / 64.0);
            let (x, y) = (p.theta(a) - theta, p.theta(b) - theta);
            let touches = x.abs().min(y.abs()) < 1e-9 * (1.0 + theta.abs());
            prop_assert!(i == 63 || x * y > 0.0 || touches, "passed between {} and {}", a, b);
        }
    }

    #[test]
    fn time_at_refuses_what_is_never_reached(theta0 in 0.01_f64..3.1, beyond in 1e-9_f64..3.0) {
        let refused = |angle| matches!(released(theta0).time_at(angle), Err(Error::NeverReached { .. }));
        prop_assert!(refused(theta0 + beyond) && refused(-theta0 - beyond));
        let rotation = launched((0.0, 2.0 + theta0));
        prop_assert!(rotation.time_at(-beyond).is_err() && rotation.time_at(100.0 * beyond).is_ok());
        prop_assert!(rotation.time_at(0.0) == Ok(0.0));
    }

    /// Direct series (θ0 below 165°) and dual series meet: neighbouring amplitudes across the switch give neighbouring
    /// motions. At 2 asin √(1 − 0.12²) dθ/dθ0 is below 40 within a period.
    #[test]
    fn direct_and_dual_series_agree_at_the_switch(fraction in -0.5_f64..0.5) {
        let switch = 2.0 * 0.12_f64.acos();
        let (below, above) = (released(switch - 1e-15), released(switch + 1e-15));
        let t = fraction * below.period();
        prop_assert!((below.theta(t) - above.theta(t)).abs() <= 40.0 * 4e-15);
        prop_assert!((below.velocity(t) - above.velocity(t)).abs() <= 40.0 * 4e-15);
        // Rotation: κ′ = 0.45, v0 = 2/κ.
        let v0 = 2.0 / (1.0 - 0.45_f64.powi(2)).sqrt();
        let (below, above) = (launched((0.0, v0 - 1e-15)), launched((0.0, v0 + 1e-15)));
        let t = fraction * below.period();
        prop_assert!((below.theta(t) - above.theta(t)).abs() <= 1e-13);
        prop_assert!((below.velocity(t) - above.velocity(t)).abs() <= 1e-13);
    }

    /// The series of θ itself, θ = 8 Σ (−1)^{n−1} q^{n−½}/((2n−1)(1 + q^{2n−1})) cos((2n−1)x), where it converges.
    #[test]
    fn theta_quotients_equal_the_fourier_series_of_theta(theta0 in 1e-6_f64..3.13, fraction in -0.5_f64..0.5) {
        let p = released(theta0);
        let t = fraction * p.period();
        let (q, x) = (p.nome(), 2.0 * PI * t / p.period());
        let mut sum = 0.0;
        for n in (1..=200).rev() {
            let odd = f64::from(2 * n - 1);
            let sign = if n % 2 == 1 { 1.0 } else { -1.0 };
            sum += sign * 8.0 * q.powf(f64::from(n) - 0.5) / (odd * (1.0 + q.powf(odd))) * (odd * x).cos();
        }
        // x is rounded (2π/2⁵³ of θ̇ T/2π ≤ 60 near the top); up to 200 terms of size θ0 and below.
        prop_assert!((p.theta(t) - sum).abs() <= 1e-13 * theta0 + 60.0 * 2e-15, "{} {}", p.theta(t), sum);
    }

    #[test]
    fn everything_is_finite_for_finite_t(start in state(), bits in any::<u64>()) {
        let (p, t) = (launched(start), f64::from_bits(bits));
        let ((theta, velocity), (x, y)) = (p.state(t), p.position(t));
        let all = [theta, velocity, x, y, p.acceleration(t), p.wrapped(t), p.small_angle(t)];
        let as_it_should = |x: &f64| if t.is_finite() { x.is_finite() } else { x.is_nan() };
        prop_assert!(all.iter().all(as_it_should), "{:?} at {:e}", all, t);
    }

    #[test]
    fn any_input_gives_a_motion_or_an_error(input in any::<[f64; 4]>()) {
        let [theta, velocity, omega, t] = input;
        if let Ok(p) = Pendulum::from_state(theta, velocity, omega) {
            let (angle, speed) = p.state(t);
            let finite = [angle, speed].map(f64::is_finite);
            prop_assert_eq!(finite, [t.is_finite(); 2], "{} {}", angle, speed);
            let _ = (p.time_at(angle), p.period(), p.energy(), p.nome(), p.modulus(), p.fourier::<1>());
        }
        if let Ok(p) = Pendulum::<f64>::new(theta, omega) {
            prop_assert!(p.theta(t).abs() <= theta.abs() || !t.is_finite());
        }
    }
}

#[test]
fn regimes_are_decided_exactly() {
    let regime = |theta, velocity, omega| Pendulum::<f64>::from_state(theta, velocity, omega).expect("valid").regime();
    assert_eq!(regime(0.0, 2.0, 1.0), Regime::Separatrix);
    assert_eq!(regime(0.0, -6.5, 3.25), Regime::Separatrix);
    assert_eq!(regime(0.0, 2.0_f64.next_down(), 1.0), Regime::Swing);
    assert_eq!(regime(0.0, 2.0_f64.next_up(), 1.0), Regime::Rotation);
    assert_eq!(regime(PI, 0.0, 1.0), Regime::Swing); // the last f64 below π
    assert_eq!(regime(PI, 1e-15, 1.0), Regime::Rotation); // 1e-15 > 2 cos(PI/2) = 1.2e-16
    assert_eq!(regime(4.0, 0.0, 1.0), Regime::Swing); // about 2π
    assert_eq!(regime(0.0, 0.0, 1.0), Regime::Rest);
    assert_eq!(Pendulum::<f32>::from_state(0.0, 2.0, 1.0).expect("valid").regime(), Regime::Separatrix);
}

#[test]
fn the_separatrix_is_the_gudermannian() {
    let p = launched((0.0, 2.0));
    for t in [-30.0, -1.0, 0.0, 0.25, 1.0, 5.0, 30.0, 1e300] {
        let exact = 4.0 * (t / 2.0_f64).tanh().atan();
        assert!((p.theta(t) - exact).abs() <= 4.0 * UNIT, "{t}: {} {exact}", p.theta(t));
        assert!((p.velocity(t) - 2.0 / t.cosh()).abs() <= 4.0 * UNIT);
    }
    assert_eq!(p.period(), f64::INFINITY);
    for no_swing in [p, launched((0.0, 2.5))] {
        assert!(no_swing.harmonic(1.0).is_nan());
        assert_eq!(no_swing.fourier::<3>(), Err(Error::NotASwing));
    }
}
