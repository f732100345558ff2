//! What mutation testing found untested: the separatrix at other rates than 1, the fastest launch, the smallest modulus
//! and the largest angles.

use pendula::{Error, Pendulum, Regime};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// θ = 4 atan tanh(ωt/2), of which ωt is all that counts: also where ω and t are far from 1.
#[test]
fn the_separatrix_at_any_rate() {
    for omega in [1e-12, 0.3, 3.0, 1e9] {
        let p = Pendulum::<f64>::from_state(0.0, 2.0 * omega, omega).unwrap();
        assert_eq!(p.regime(), Regime::Separatrix);
        for z in [-3.0, -0.1, 1e-9, 0.1, 1.0, 20.0] {
            let expected = 4.0 * (z / 2.0f64).tanh().atan();
            // z/ω, its product with ω and the library's functions round a few times.
            assert!((p.theta(z / omega) - expected).abs() <= 8.0 * f64::EPSILON * expected.abs(), "{omega} {z}");
        }
        assert_eq!(p.theta(1e30 / omega), PI);
    }
}

/// The first passage of an angle, from the lowest point and from elsewhere.
#[test]
fn times_on_the_separatrix() {
    for omega in [1e-3, 3.0] {
        for start in [0.0, -1.0] {
            // The separatrix passes −1 with 2ω cos ½, which has to be rounded so that the regime is decided alike.
            let speed = 2.0 * omega * (start / 2.0f64).cos();
            let near = [speed.next_down(), speed, speed.next_up()];
            let found = near.iter().filter_map(|&v| Pendulum::<f64>::from_state(start, v, omega).ok());
            let Some(p) = found.into_iter().find(|p| p.regime() == Regime::Separatrix) else { continue };
            for angle in [FRAC_PI_2, 3.0] {
                let t = p.time_at(angle).unwrap();
                let since_bottom = |angle: f64| (angle / 2.0).sin().atanh() / omega;
                let expected = since_bottom(angle) - since_bottom(start);
                assert!((t - expected).abs() <= 1e-13 * expected, "{omega} {start} {angle}: {t} {expected}");
            }
        }
    }
}

/// The documented limit is relative to ω: 10²⁹⁰ times it.
#[test]
fn the_fastest_launch_is_relative_to_omega() {
    for omega in [0.75, 1.0, 1.5] {
        assert!(Pendulum::<f64>::from_state(0.0, 0.99e290 * omega, omega).is_ok(), "{omega}");
        let refused = Pendulum::<f64>::from_state(0.0, 1.01e290 * omega, omega);
        assert!(matches!(refused, Err(Error::Velocity { .. })), "{omega}");
    }
}

/// θ grows by 2π a period, as far as there are floats.
#[test]
fn angles_beyond_all_turns() {
    for velocity in [2.5, -40.0] {
        let p = Pendulum::<f64>::from_state(0.5, velocity, 1.0).unwrap();
        for t in [1e17, 1e100, 1e292, 1e300] {
            let expected = TAU * (t / p.period()) * velocity.signum();
            // The period is rounded to half a unit in the last place.
            assert!((p.theta(t) / expected - 1.0).abs() < 1e-15, "{velocity} {t}");
        }
    }
}

/// q = (k²/16)(1 + k²/2 + …).
#[test]
fn the_nome_of_tiny_moduli() {
    for k in [1e-100, 1e-20, 3e-11, 0.9e-10] {
        let expected = k * k / 16.0;
        assert!((pendula::elliptic::nome(k) / expected - 1.0).abs() <= 3.0 * f64::EPSILON, "{k}");
    }
}
