//! Over the top, and just not: what a user who pushes hard sees of the generated motion.

use core::f64::consts::PI;
use pendula::{Pendulum, pendulum};
use pendula_stress::promised::UNIT;
use pendula_stress::random::Random;

/// The angle less full turns, in [−π, π).
fn less_turns(theta: f64) -> f64 {
    let rest = theta - 2.0 * PI * (theta / (2.0 * PI)).round();
    if rest >= PI { rest - 2.0 * PI } else { rest }
}

/// Against the runtime, which is exact to 2⁻⁵⁰ of θ from the same state.
macro_rules! agrees {
    ($theta0:literal $velocity0:literal $omega:literal within $t_max:literal) => {{
        pendulum! {
            struct Motion;
            theta0 = $theta0, velocity0 = $velocity0, omega = $omega, tol = 1e-9, t_max = $t_max,
            outputs = [theta, velocity, acceleration, position, wrapped]
        }
        let runtime =
            Pendulum::from_state(f64::from($theta0), f64::from($velocity0), f64::from($omega)).expect("a valid state");
        assert!(Motion::MAX_ERROR <= 1e-9 && Motion::MAX_WRAPPED_ERROR <= 1e-9 && Motion::MAX_POSITION_ERROR <= 1e-9);
        let mut random = Random::new(11);
        for _ in 0..4000 {
            let t = f64::from($t_max) * random.signed();
            let (theta, velocity) = runtime.state(t);
            let (x, y) = Motion::position(t);
            // What the runtime may be off by.
            let slack = UNIT * theta.abs().max(1.0);
            approx::assert_abs_diff_eq!(Motion::theta(t), theta, epsilon = Motion::MAX_ERROR + slack);
            approx::assert_abs_diff_eq!(
                Motion::velocity(t) / Motion::OMEGA,
                velocity / Motion::OMEGA,
                epsilon = Motion::MAX_VELOCITY_ERROR + 8.0 * slack
            );
            approx::assert_abs_diff_eq!(x, theta.sin(), epsilon = Motion::MAX_POSITION_ERROR + slack);
            approx::assert_abs_diff_eq!(y, -theta.cos(), epsilon = Motion::MAX_POSITION_ERROR + slack);
            approx::assert_abs_diff_eq!(
                Motion::acceleration(t) / (Motion::OMEGA * Motion::OMEGA),
                -theta.sin(),
                epsilon = Motion::MAX_ACCELERATION_ERROR + slack
            );
            let wrapped = Motion::wrapped(t);
            assert!((-PI..PI).contains(&wrapped), "{wrapped}");
            // Modulo a turn: just above −π and just below π are neighbours.
            let off = less_turns(wrapped - theta).abs();
            assert!(off <= Motion::MAX_WRAPPED_ERROR + 4.0 * slack, "{wrapped} for {theta} at {t}: {off:e}");
        }
    }};
}

#[test]
fn every_output_over_the_top() {
    agrees!(0 3 1 within 100);
    agrees!(0 -2.5 1 within 100);
    agrees!(1 3 1 within 1000);
    agrees!(1.5 -2.75 0.5 within 20);
    agrees!(0 100 1 within 10);
    agrees!(0 2.0625 1 within 1000);
}

#[test]
fn every_output_on_the_separatrix() {
    agrees!(0 2 1 within 100);
    agrees!(0 -5 2.5 within 100);
}

#[test]
fn turning_the_other_way_is_the_mirror_image() {
    macro_rules! mirrored {
        ($($velocity0:tt $mirror:tt $($parameters:ident = $value:tt),*;)*) => {$({
            pendulum! {
                struct Right;
                velocity0 = $velocity0, outputs = [theta, velocity, wrapped], $($parameters = $value),*
            }
            pendulum! {
                struct Left;
                velocity0 = $mirror, outputs = [theta, velocity, wrapped], $($parameters = $value),*
            }
            let mut random = Random::new(12);
            for _ in 0..2000 {
                let t = 100.0 * random.signed();
                // Each is within 2⁻⁵⁰ of the exact one, which mirrors.
                let allowed = 2.0 * UNIT * Right::theta(t).abs().max(1.0);
                approx::assert_abs_diff_eq!(Left::theta(t), -Right::theta(t), epsilon = allowed);
                approx::assert_abs_diff_eq!(Right::theta(-t), -Right::theta(t), epsilon = allowed);
                let allowed = 2.0 * UNIT * Right::velocity(0.0);
                approx::assert_abs_diff_eq!(Left::velocity(t), -Right::velocity(t), epsilon = allowed);
                approx::assert_abs_diff_eq!(Right::velocity(-t), Right::velocity(t), epsilon = allowed);
                approx::assert_abs_diff_eq!(Left::wrapped(t), -Right::wrapped(t), epsilon = 2.0 * UNIT * PI);
            }
        })*};
    }
    mirrored! {
        3 (-3);
        (201/100) (-201/100);
        2 (-2);
        10 (-10) tol = 1e-6, t_max = 100;
    }
}

/// κ = 0.8, by mpmath; T = 2κK.
#[test]
fn constants_of_a_rotation() {
    pendulum! {
        struct Motion;
        velocity0 = 2.5, outputs = [wrapped]
    }
    assert_eq!([Motion::MODULUS, Motion::K, Motion::K_PRIME], [0.8, 1.995_302_777_664_729_4, 1.750_753_802_915_752_6]);
    assert_eq!([Motion::NOME, Motion::PERIOD], [0.063_510_393_400_745_82, 3.192_484_444_263_567]);
}

#[test]
fn a_turn_takes_one_period() {
    pendulum! {
        struct Motion;
        velocity0 = 2.5, outputs = [theta, velocity, wrapped]
    }
    for turns in 0..100 {
        let t = 0.3 + f64::from(turns) * Motion::PERIOD;
        // t is good to half an ulp of 100 periods, and θ̇ ≤ 2.5.
        approx::assert_abs_diff_eq!(
            Motion::theta(t),
            Motion::theta(0.3) + 2.0 * PI * f64::from(turns),
            epsilon = 4e-13
        );
        approx::assert_abs_diff_eq!(Motion::wrapped(t), Motion::theta(0.3), epsilon = 4e-13);
    }
}

#[test]
fn the_separatrix_tends_to_the_top_and_stays() {
    pendulum! {
        struct Motion;
        velocity0 = 2, outputs = [theta, velocity]
    }
    assert_eq!(Motion::MODULUS, 1.0);
    assert_eq!(Motion::theta(0.0), 0.0);
    for t in [40.0, 700.0, 800.0, 1e9, 1e300, f64::MAX] {
        approx::assert_abs_diff_eq!(Motion::theta(t), PI, epsilon = Motion::MAX_ERROR);
        approx::assert_abs_diff_eq!(Motion::velocity(t), 0.0, epsilon = Motion::MAX_VELOCITY_ERROR);
        assert_eq!(Motion::theta(-t), -Motion::theta(t));
    }
    assert!(Motion::theta(f64::INFINITY).is_nan());
}
