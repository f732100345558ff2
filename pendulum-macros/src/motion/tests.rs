use super::*;
use crate::check::check;
use crate::exact::Context;
use crate::parse::parse;
use crate::report::Report;
use crate::testing::Random;
use std::time::{Duration, Instant};

/// Solved as the macro does, its working precision chosen by the checks.
fn motion(parameters: &str) -> Motion {
    let mut report = Report::default();
    let request = parse(parameters.parse().unwrap(), &mut report).unwrap();
    let scene = check(request, &mut report);
    report.finish().unwrap_or_else(|error| panic!("{parameters}: {error}"));
    scene.unwrap().motion
}

fn swing(parameters: &str) -> Swing {
    let Regime::Swing(swing) = motion(parameters).regime else { panic!("{parameters} is no swing") };
    swing
}

/// The rows of a table after its comment and its header.
fn rows(table: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    table.lines().skip(2).map(|line| line.split(',').collect())
}

/// Correctly rounded to `f64` and `f32`: 60 digits round as the number itself does.
fn assert_rounds_to(value: &Real, truth: &str, what: &str) {
    assert_eq!(value.to_f64(), truth.parse::<f64>().unwrap(), "{what}");
    assert_eq!(value.to_f32(), truth.parse::<f32>().unwrap(), "{what}, as f32");
}

#[test]
fn constants_are_correctly_rounded() {
    let mut count = 0;
    for row in rows(include_str!("../../tests/data/amplitudes.csv")) {
        let [theta0, truth @ ..] = row.as_slice() else { unreachable!() };
        let swing = swing(&format!("theta0 = {theta0}"));
        let Elliptic { modulus, quarter, quarter_complementary, nome, .. } = &swing.elliptic;
        let all = swing.fourier_coefficients(8);
        let coefficients = [1, 2, 3, 4, 8].map(|n| &all[n - 1]);
        let constants = [modulus, quarter, quarter_complementary, nome, &swing.period].into_iter().chain(coefficients);
        for (column, (value, truth)) in constants.zip(truth).enumerate() {
            assert_rounds_to(value, truth, &format!("theta0 = {theta0}, column {column}"));
        }
        count += 1;
    }
    assert!(count >= 40, "{count} amplitudes");
}

#[test]
fn launches_agree_with_incomplete_integrals() {
    let mut count = 0;
    for row in rows(include_str!("../../tests/data/launches.csv")) {
        let [theta0, velocity0, omega, regime, mirrored, launch, extent, period] = row[..] else { unreachable!() };
        let parameters = format!("theta0 = {theta0}, velocity0 = {velocity0}, omega = {omega}");
        let motion = motion(&parameters);
        let (found, flipped, phase) = match &motion.regime {
            Regime::Swing(swing) => {
                assert_rounds_to(&swing.amplitude, extent, &parameters);
                assert_rounds_to(&swing.period, period, &parameters);
                ("swing", swing.mirrored, &swing.launch)
            }
            Regime::Rotation(rotation) => {
                assert_rounds_to(&rotation.fastest, extent, &parameters);
                assert_rounds_to(&rotation.period, period, &parameters);
                ("rotation", rotation.mirrored, &rotation.launch)
            }
            Regime::Separatrix(separatrix) => ("separatrix", separatrix.mirrored, &separatrix.launch),
        };
        assert_eq!((found, flipped), (regime, mirrored == "true"), "{parameters}");
        assert_rounds_to(phase, launch, &parameters);
        count += 1;
    }
    assert!(count >= 35, "{count} launches");
}

#[test]
fn the_top_in_motion_is_half_a_turn() {
    for (theta0, velocity0, launch) in [("π", "1", 0.5), ("-180deg", "1", -0.5), ("π", "-1e-9", -0.5)] {
        let motion = motion(&format!("theta0 = {theta0}, velocity0 = {velocity0}"));
        let Regime::Rotation(rotation) = motion.regime else { panic!("over the top") };
        assert_eq!(rotation.launch.to_f64(), launch);
        assert_eq!(rotation.slowest.to_f64(), velocity0.parse::<f64>().unwrap().abs());
    }
}

#[test]
fn released_from_rest_the_launch_phase_is_exactly_zero() {
    for theta0 in ["1", "-1"] {
        let swing = swing(&format!("theta0 = {theta0}, velocity0 = 0"));
        assert!(swing.launch.is_zero());
        assert_eq!(swing.mirrored, theta0 == "-1");
    }
}

#[test]
fn states_without_motion_are_told_apart() {
    let context = Context::for_digits(20);
    let solve = |theta0: &Real, velocity0: i64| {
        Motion::solve(theta0, &context.integer(velocity0), &context.integer(1)).map(|_| ()).err()
    };
    assert_eq!(solve(&context.integer(0), 0), Some(NoMotion::Hanging));
    assert_eq!(solve(&context.pi(), 0), Some(NoMotion::Balanced));
    assert_eq!(solve(&context.decimal("3.15").unwrap(), 0), Some(NoMotion::BeyondTop));
    assert_eq!(solve(&context.decimal("-3.15").unwrap(), 9), Some(NoMotion::BeyondTop));
    assert_eq!(solve(&context.pi(), 1), None);
}

/// Contrived input that is nearer to the separatrix than its digits suggest gets a second, higher precision.
#[test]
fn the_precision_follows_the_cancellation() {
    let near = motion("theta0 = 0, velocity0 = 2 - 1e-40*1e-40*1e-40");
    let Regime::Swing(swing) = &near.regime else { panic!("just below the separatrix") };
    // k′² = 1 − (1 − δ/2)² = δ to first order, δ = 1e-120.
    let expected = near.omega.context().decimal("1e-60").unwrap();
    let relative = (&swing.elliptic.complementary / &expected - near.omega.context().integer(1)).abs();
    assert!(relative < near.omega.context().decimal("1e-59").unwrap());
    assert!(near.omega.context().spare_bits() >= near.cancelled_bits());
}

/// An angle that took more digits to evaluate is as exact as any other, no more.
#[test]
fn states_that_cancelled_are_on_the_separatrix() {
    for theta0 in
        ["100.0 - 100.0 + 90deg", "0.1 - 0.1 + π/2", "(1 + 1e-30 - 1)*1e30*π/2", "(1/3 + 1e-40 - 1/3)*1e40*π/2"]
    {
        let regime = motion(&format!("theta0 = {theta0}, velocity0 = sqrt(2)")).regime;
        assert!(matches!(regime, Regime::Separatrix(_)), "{theta0}: {regime:?}");
    }
    for theta0 in ["(1+1e-20-1)*1e20*π", "(1+1e-25-1)*1e25*π", "(1/3 + 1e-40 - 1/3)*1e40*π", "π + 1e-30 - 1e-30"] {
        let top = motion(&format!("theta0 = {theta0}, velocity0 = 1")).regime;
        assert!(matches!(top, Regime::Rotation(_)), "{theta0}: {top:?}");
    }
}

/// The last of two thousand digits decides between neighbouring floats, and between a swing and the separatrix.
#[test]
fn every_digit_counts() {
    let tie = "1.00000000000000011102230246251565404236316680908203125";
    let zeros = "0".repeat(2000);
    for (last, nearest) in [("", 1.0), ("1", 1.0 + f64::EPSILON)] {
        let released = motion(&format!("theta0 = {tie}{zeros}{last}"));
        let Regime::Swing(swing) = &released.regime else { panic!("released from rest") };
        assert_eq!([&released.theta0, &swing.amplitude].map(Real::to_f64), [nearest; 2]);
    }

    let nearly_two = motion(&format!("velocity0 = 1.{}", "9".repeat(2000)));
    let Regime::Swing(swing) = &nearly_two.regime else { panic!("just below the separatrix") };
    // k′² = 1 − (1 − δ/2)² = δ to first order, δ = 1e-2000.
    let expected = Context::settled().integer(10).power(1000);
    let relative = (&swing.elliptic.complementary * &expected - Context::settled().integer(1)).abs();
    assert!(relative < Context::settled().decimal("1e-99").unwrap());
}

/// Carlson's `R_F` by duplication, the neglected ε⁶ far below 1e-60: ε falls fourfold a step, to about 4⁻²⁴
/// (DLMF 19.36.1).
fn carlson(mut x: Real, mut y: Real, mut z: Real) -> Real {
    for _ in 0..28 {
        let (a, b, c) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = &a * &b + &b * &c + &c * &a;
        (x, y, z) = ((x + &shift).scale(-2), (y + &shift).scale(-2), (z + &shift).scale(-2));
    }
    let context = x.context();
    let mean = (&x + &y + &z) / context.integer(3);
    let one = context.integer(1);
    let (u, v) = (&one - &x / &mean, &one - &y / &mean);
    let w = -(&u + &v);
    let (e2, e3) = (&u * &v - w.square(), u * v * w);
    let series = one - &e2 * context.ratio(1, 10) + &e3 * context.ratio(1, 14) + e2.square() * context.ratio(1, 24)
        - e2 * e3 * context.ratio(3, 44);
    series / mean.sqrt()
}

/// Of either sign, its magnitude log-uniform in [10^`least`, 10^`most`).
fn signed(random: &mut Random, least: f64, most: f64) -> f64 {
    random.choose(&[-1.0, 1.0]) * 10.0_f64.powf(least + (most - least) * random.unit())
}

/// F(φ, k) from the lowest point with sin φ = s/k (swing) or φ = θ0/2 (rotation), by Legendre's form of `R_F`; the
/// implementation takes it from the turning point and by Gauss' transformation.
#[test]
fn launch_phases_agree_with_carlson_duplication() {
    let context = Context::for_digits(20);
    let mut random = Random::new(2019);
    let tolerance = context.decimal("1e-57").unwrap();
    let (mut swings, mut rotations) = (0, 0);
    for round in 0..200 {
        let theta0 = signed(&mut random, -6.0, 0.497);
        // Half of them close to the separatrix, where v0 = 2ω cos(θ0/2).
        let velocity0 = if round % 2 == 0 {
            signed(&mut random, -6.0, 1.5)
        } else {
            2.0 * (theta0 / 2.0).cos() * (1.0 + signed(&mut random, -12.0, -1.0))
        };
        let [theta0, velocity0] = [theta0, velocity0].map(|x| context.float(x).unwrap());
        let one = context.integer(1);
        let motion = Motion::solve(&theta0, &velocity0, &one).unwrap();
        let (sine, cosine) = theta0.scale(-1).sin_cos();
        let speed = velocity0.scale(-1).abs();
        let (phase, other) = match &motion.regime {
            Regime::Swing(Swing { launch, elliptic, .. }) => {
                swings += 1;
                let k = &elliptic.modulus;
                let sin_am = (&sine / k).abs();
                let from_bottom = &sin_am * carlson((&speed / k).square(), cosine.square(), one.clone());
                let quarter = carlson(context.integer(0), elliptic.complementary.square(), one.clone());
                assert!((&quarter - &elliptic.quarter).abs() < tolerance);
                (launch.abs(), (one - from_bottom / quarter).scale(-1))
            }
            Regime::Rotation(Rotation { launch, elliptic, .. }) => {
                rotations += 1;
                let dn = &one - &(&sine * &elliptic.modulus).square();
                let from_bottom = sine.abs() * carlson(cosine.square(), dn, one);
                (launch.abs(), (from_bottom / &elliptic.quarter).scale(-1))
            }
            Regime::Separatrix(_) => unreachable!("random states are not on it"),
        };
        assert!((phase - other).abs() < tolerance, "θ0 = {}, v0 = {}", theta0.to_f64(), velocity0.to_f64());
    }
    assert!(swings > 50 && rotations > 50);
}

/// Mirroring the state mirrors the motion; reversing time reverses the phase.
#[test]
fn symmetries_hold_to_the_bit() {
    let context = Context::for_digits(20);
    let mut random = Random::new(7);
    for _ in 0..50 {
        let theta0 = context.float(signed(&mut random, -3.0, 0.497)).unwrap();
        let velocity0 = context.float(signed(&mut random, -3.0, 1.0)).unwrap();
        let described = |theta0: &Real, velocity0: &Real| match Motion::solve(theta0, velocity0, &context.integer(1))
            .unwrap()
            .regime
        {
            Regime::Swing(swing) => (swing.mirrored, swing.launch, true),
            Regime::Rotation(rotation) => (rotation.mirrored, rotation.launch, false),
            Regime::Separatrix(_) => unreachable!("random states are not on it"),
        };
        let (mirrored, launch, swings) = described(&theta0, &velocity0);
        assert_eq!(described(&-theta0.clone(), &-velocity0.clone()), (!mirrored, launch.clone(), swings));
        // A rotation run backwards is the mirrored one, at the mirrored angle.
        assert_eq!(described(&theta0, &-velocity0), (mirrored ^ !swings, -launch, swings));
    }
}

/// The budget of one expansion is 30 ms in an unoptimised build; solving a release from rest may take a small part of
/// it (measured: 0.9 ms). Ten times the target, since a test machine may be busy.
#[test]
fn solving_takes_a_small_part_of_an_expansion() {
    let context = Context::for_digits(20);
    let theta0 = context.pi() * context.ratio(7, 8);
    let fastest = (0..20)
        .map(|_| {
            let start = Instant::now();
            Motion::solve(&theta0, &context.integer(0), &context.integer(1)).unwrap();
            start.elapsed()
        })
        .min();
    assert!(fastest.unwrap() < Duration::from_millis(10), "{fastest:?}");
}
