//! The runtime at the edges of its domain: the separatrix at other rates than 1, the fastest launch, the smallest modulus,
//! the largest angles.

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

/// Where θ² underflows cos(θ/2) is 1: as near to the lowest point as that, a speed of 2ω is still the separatrix, and
/// keeps the angle it starts from: near the lowest point θ = θ0 + 2ωt.
#[test]
fn the_separatrix_from_beside_the_lowest_point() {
    for (omega, start) in [(1.0, 1e-170), (3.0, -1e-200), (1e-6, 1e-280)] {
        let p = Pendulum::<f64>::from_state(start, 2.0 * omega, omega).unwrap();
        assert_eq!(p.regime(), Regime::Separatrix);
        for t in [0.0, start.abs() / omega, -3.0 * start.abs() / omega] {
            let expected = start + 2.0 * omega * t;
            assert!((p.theta(t) - expected).abs() <= 4.0 * f64::EPSILON * start.abs(), "{omega} {start} {t}");
        }
        let back = p.time_at(0.0);
        if start < 0.0 {
            assert!((back.unwrap() * 2.0 * omega / -start - 1.0).abs() <= 4.0 * f64::EPSILON);
        } else {
            assert!(matches!(back, Err(Error::NeverReached { .. })));
        }
    }
}

/// The first passage of an angle: sinh ωt = tan(θ/2).
#[test]
fn times_on_the_separatrix() {
    for omega in [1e-3, 3.0] {
        let p = Pendulum::<f64>::from_state(0.0, 2.0 * omega, omega).unwrap();
        for angle in [1e-9, FRAC_PI_2, 3.0] {
            let expected = (angle / 2.0).tan().asinh() / omega;
            let t = p.time_at(angle).unwrap();
            assert!((t - expected).abs() <= 8.0 * f64::EPSILON * expected, "{omega} {angle}: {t} {expected}");
        }
        assert!(p.time_at(-1e-9).is_err());
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
    assert!(Pendulum::<f64>::from_state(0.0, 1e290, 1.0).is_ok());
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

/// Zero, not minus zero, which some formatters show.
#[test]
fn a_pendulum_at_rest_stays_at_zero() {
    let p = Pendulum::<f64>::new(0.0, 1.0).unwrap();
    assert_eq!(p.regime(), Regime::Rest);
    for t in [0.0, 0.3, 1.57, 1e6] {
        assert_eq!((p.theta(t), p.velocity(t)), (0.0, 0.0), "{t}");
    }
    assert!(p.theta(0.0).is_sign_positive());
}

/// What it was made of is known again, and makes the same once more.
#[test]
fn equal_parameters_are_equal_motions() {
    let pushed = |omega: f64| Pendulum::<f64>::from_state(0.4, 1.1, omega).unwrap();
    assert_eq!(pushed(2.5).omega(), 2.5);
    assert_eq!(Pendulum::<f32>::new(1.0, 0.1).unwrap().omega(), 0.1);
    assert_eq!(pushed(pushed(2.5).omega()), pushed(2.5));
    assert_ne!(pushed(2.5), pushed(2.5_f64.next_up()));
}

/// v²/2ω², as long as there are floats for it.
#[test]
fn energies_of_the_fastest() {
    let energy = |velocity: f64| Pendulum::<f64>::from_state(0.0, velocity, 1.0).unwrap().energy();
    assert!((energy(1e150) / 0.5e300 - 1.0).abs() <= 2.0 * f64::EPSILON);
    assert!((energy(1e154) / 0.5e308 - 1.0).abs() <= 2.0 * f64::EPSILON);
    assert_eq!([energy(1e155), energy(1e200), energy(1e290)], [f64::INFINITY; 3]);
}

/// k′ and K′ of every regime: k² + k′² = 1, q = exp(−πK′/K); next to the top k′ = sin ½(π − θ0) where k is 1.
#[test]
fn complements() {
    let of = |theta: f64, velocity: f64| {
        let p = Pendulum::<f64>::from_state(theta, velocity, 2.0).unwrap();
        (p, p.complementary_modulus(), p.complementary_integral())
    };
    for (theta, velocity) in [(0.5, 0.0), (3.0, 0.0), (1.0, 2.0), (0.3, 5.0), (-2.0, 9.0)] {
        let (p, complementary, quarter) = of(theta, velocity);
        assert!((p.modulus().hypot(complementary) - 1.0).abs() <= f64::EPSILON, "{theta} {velocity}");
        let nome = (-PI * quarter / p.complete_integral()).exp();
        assert!((p.nome() / nome - 1.0).abs() <= 1e-14, "{theta} {velocity}");
        // T = 4K/ω of a swing, 2κK/ω of a rotation.
        let half = if p.regime() == Regime::Swing { 2.0 } else { p.modulus() };
        assert!((p.period() / (half * p.complete_integral()) - 1.0).abs() <= 1e-15, "{theta} {velocity}");
    }
    let (p, complementary, _) = of(PI - 1e-9, 0.0);
    let below = (PI - (PI - 1e-9)) + 1.224_646_799_147_353_2e-16;
    assert_eq!(p.modulus(), 1.0);
    assert!((complementary / (0.5 * below) - 1.0).abs() <= 2.0 * f64::EPSILON);
    let (at_rest, on_separatrix) = (of(0.0, 0.0), of(0.0, 4.0));
    assert_eq!((at_rest.1, at_rest.2), (1.0, f64::INFINITY));
    assert_eq!((on_separatrix.1, on_separatrix.2), (0.0, PI / 2.0));
}

/// Eq. 17 has the turning points and the passages of the motion, from any state.
#[test]
fn harmonic_approximations_in_motion() {
    for (theta, velocity) in [(-1.0, 0.0), (0.5, 1.1), (-0.5, 1.1), (0.5, -1.1), (-0.5, -1.1)] {
        let p = Pendulum::<f64>::from_state(theta, velocity, 2.5).unwrap();
        for angle in [p.amplitude(), 0.0, -p.amplitude()] {
            let found = p.harmonic(p.time_at(angle).unwrap());
            assert!((found - angle).abs() <= 1e-15, "{theta} {velocity}: {found}, not {angle}");
        }
    }
}

/// Eq. 3 from any state, where ω isn't 1: θ cos ωt + (θ̇/ω) sin ωt.
#[test]
fn small_angles_in_motion() {
    let (theta, velocity, omega) = (0.02, 0.07, 2.5);
    let p = Pendulum::<f64>::from_state(theta, velocity, omega).unwrap();
    for t in [0.0, 0.1, 0.7, -1.3] {
        let (sine, cosine) = f64::sin_cos(omega * t);
        assert!((p.small_angle(t) - (theta * cosine + velocity / omega * sine)).abs() <= 1e-16, "{t}");
    }
}

/// Turns of the initial angle are turns of the approximations, too.
#[test]
fn approximations_from_other_turns() {
    let (turn, velocity) = (TAU, 0.05);
    let launch = |theta: f64| Pendulum::<f64>::from_state(theta, velocity, 1.0).unwrap();
    let (here, there) = (launch(0.25), launch(0.25 + 3.0 * turn));
    for t in [0.0, 0.4, 2.5, 100.0] {
        assert!((there.small_angle(t) - here.small_angle(t) - 3.0 * turn).abs() <= 1e-14, "{t}");
        assert!((there.harmonic(t) - here.harmonic(t) - 3.0 * turn).abs() <= 1e-14, "{t}");
    }
}

/// Times are in units of 1/ω, whatever its magnitude.
#[test]
fn times_scale_with_omega() {
    let launch = |omega: f64, speed: f64| Pendulum::<f64>::from_state(0.5, speed * omega, omega).unwrap();
    for speed in [0.7, 2.5] {
        let unit = launch(1.0, speed);
        for omega in [1e-9, 0.3, 3.0, 1e9] {
            let p = launch(omega, speed);
            let times = [(p.period(), unit.period()), (p.time_at(0.6).unwrap(), unit.time_at(0.6).unwrap())];
            for (time, expected) in times {
                // The speed is rounded, and the passage from 0.5 to 0.6 a small difference.
                assert!((time * omega / expected - 1.0).abs() <= 1e-14, "{omega} {speed}");
            }
        }
    }
}

/// Next to 3π the distance from the top is known by itself: a million periods later θ is that of mpmath.
#[test]
fn released_next_to_the_top_of_another_turn() {
    let p = Pendulum::<f64>::from_state(9.42477796076938, 0.0, 1.0).unwrap();
    let theta = p.theta(1.6e8);
    assert!((theta - 3.300338672093233).abs() <= 10.0 * f64::EPSILON, "{theta}");
}

/// What is farther than any number is never reached; an angle of as many turns is one.
#[test]
fn the_farthest_angles() {
    let p = Pendulum::<f64>::from_state(1e300, 0.1, 1.0).unwrap();
    assert!(p.time_at(-f64::MAX).is_err());
    for (u, k) in [(1e301, 0.5), (1e305, 0.0), (f64::MAX, 0.9)] {
        let am = pendula::elliptic::am(u, k);
        let expected = u / pendula::elliptic::quarter_period(k) * FRAC_PI_2;
        assert!((am / expected - 1.0).abs() < 1e-14, "{u:e} {k}: {am:e}");
    }
}

/// 29π/2 + 6.2e-19, beyond a quarter turn by less than the first word of π/2 tells; by mpmath.
#[test]
fn an_integral_just_beyond_a_quarter_turn() {
    let found = pendula::elliptic::complementary::incomplete(45.553_093_477_052, 1e-8);
    assert!((found - 574.402_278_047_157_3).abs() <= 2e-13, "{found}");
}

/// The largest angle is no less than the first, wherever it was rounded to; and 0 keeps its sign.
#[test]
fn amplitudes_and_zeros_of_starts() {
    let theta = 0.960_536_323_522_031_7;
    let p = Pendulum::<f64>::from_state(theta, 1e-12, 1.0).unwrap();
    assert!(p.amplitude() >= theta);
    assert!(p.time_at(p.amplitude()).unwrap() < 1.3e-12);
    assert!((p.time_at(-p.amplitude()).unwrap() - 3.332_948_093_1).abs() < 1e-10);
    let [rest, mirrored] = [0.0_f64, -0.0].map(|zero| Pendulum::new(zero, 1.0).unwrap());
    for t in [0.0, 2.0] {
        assert_eq!(mirrored.theta(t).to_bits(), (-rest.theta(t)).to_bits());
    }
    assert_eq!(mirrored.theta(0.0).to_bits(), (-0.0_f64).to_bits());
}

/// Through the lowest point nothing cancels, however near to the separatrix and whatever ω: (v, ω, t, θ less its turns),
/// of these numbers, by mpmath with 120 digits (2 asin(k sn) with k = v/2ω, or 2 asin(sn) with k = 2ω/v).
#[test]
fn next_to_the_separatrix_from_the_lowest_point() {
    for (velocity, omega, t, expected) in [
        (1.7332905167658963, 0.8666539249221973, 31367.761454270298, 0.2664904636460345),
        (1.7332905167658963, 0.8666539249221973, 972395824718581.1, 0.6294970618698269),
        (1.7333078496710637, 0.8666539249221973, 57936.69645137091, 0.9283792459244079),
        (1.7333078496710637, 0.8666539249221973, 1796020355483586.8, 1.718105933951976),
        (5.9999999999994, 3.0, 21341.956452520364, 1.8981260425297501),
        (5.9999999999994, 3.0, 661588917232528.4, -1.7128594825430707),
        (5.9999994, 3.0, 12137.742871340322, 0.0900283206989733),
        (5.9999994, 3.0, 376082453088541.2, -0.17808027166089774),
        (2.8571428571400002e-06, 1.4285714285714286e-06, 41614684351.1352, 1.9233166135939221),
        (2.8571428571400002e-06, 1.4285714285714286e-06, 1.2894356093965587e+21, -1.27185722533514),
        (1.7333078500177255, 0.8666539249221973, 28968.378149095366, 0.5274660182101292),
        (1.7333078500177255, 0.8666539249221973, 898010177655555.0, -0.6141771192642572),
        (6.0000000000005995, 3.0, 10671.409286922673, 0.7432986875257038),
        (6.0000000000005995, 3.0, 330809755929654.3, -0.8771148755589894),
    ] {
        let p = Pendulum::<f64>::from_state(0.0, velocity, omega).unwrap();
        let error = (p.wrapped(t) - expected).abs();
        assert!(error <= 4.0 * f64::EPSILON, "{velocity} {omega} {t}: {error:e}");
    }
}

/// 2 arcsin √((θ̇/2ω)² + sin²(θ/2)) by mpmath.
#[test]
fn amplitudes_of_states_are_rounded_once() {
    for ([theta, velocity, omega], amplitude) in [
        ([1.7440748104781916, -0.14787283964684655, 1.0], 1.7551852462328663),
        ([-0.31935223003353697, 1.2, 3.0], 0.5167307072277888),
        ([0.3, 1.2, 1.0], 1.333231560328171),
        ([1e-200, 2e-200, 0.75], 2.848001248439177e-200),
        ([-0.2, 1.9, 1.0], 2.5408807276404177),
        ([2.9, 0.23, 1.0], 3.069579387781483),
        ([5.0, 0.7, 2.0], 1.3465083952820267),
        ([0.0, 1.9999999, 1.0], 3.1409601980549398),
    ] {
        let p = Pendulum::<f64>::from_state(theta, velocity, omega).unwrap();
        assert_eq!(p.amplitude(), amplitude, "{theta} {velocity} {omega}");
    }
}

/// Of motions that come to the top one place in twenty was beyond it, by up to two ulp.
#[test]
fn positions_are_on_no_larger_circle() {
    let motions = [(PI, 0.0), (PI - 1e-9, 0.0), (PI, 1e-3), (0.0, 2.0), (1.0, 2.5)];
    let mut next_to_top = 0;
    for (theta0, velocity0) in motions {
        let p = Pendulum::from_state(theta0, velocity0, 1.0).unwrap();
        for i in -20_000..20_000 {
            let (x, y) = p.position(f64::from(i) * 1e-3);
            assert!(x.abs() <= 1.0 && y.abs() <= 1.0, "({x}, {y}) at {i} ms from {theta0}, {velocity0}");
            next_to_top += u32::from(y == 1.0);
        }
    }
    assert!(next_to_top > 100);
}
