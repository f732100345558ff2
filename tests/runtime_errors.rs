//! Bad input at run time: the matching variant, and a message that names value and remedy.

use pendula::{Error, Pendulum};

#[test]
fn released_at_rest() {
    let error = |theta0, omega| Pendulum::<f64>::new(theta0, omega).expect_err("bad input");
    assert_eq!(error(3.2, 1.0), Error::Amplitude { value: 3.2 });
    assert_eq!(error(-core::f64::consts::PI.next_up(), 1.0), Error::Amplitude { value: -3.1415926535897936 });
    assert_eq!(error(1.0, 0.0), Error::Frequency { value: 0.0 });
    assert_eq!(error(1.0, -2.0), Error::Frequency { value: -2.0 });
    assert_eq!(error(f64::INFINITY, 1.0), Error::NotFinite { parameter: "theta0", value: f64::INFINITY });
    assert!(matches!(error(f64::NAN, 1.0), Error::NotFinite { parameter: "theta0", .. }));
    assert!(matches!(error(1.0, f64::NAN), Error::NotFinite { parameter: "omega", .. }));
    // f32's π is above π.
    assert!(matches!(Pendulum::<f32>::new(core::f32::consts::PI, 1.0), Err(Error::Amplitude { .. })));
}

#[test]
fn launched() {
    let error = |theta, velocity, omega| Pendulum::<f64>::from_state(theta, velocity, omega).expect_err("bad input");
    assert!(matches!(error(f64::NAN, 0.0, 1.0), Error::NotFinite { parameter: "theta", .. }));
    assert!(matches!(error(0.0, f64::NEG_INFINITY, 1.0), Error::NotFinite { parameter: "velocity", .. }));
    assert_eq!(error(0.0, 1e300, 1.0), Error::Velocity { value: 1e300 });
    assert_eq!(error(0.0, 1.0, -1.0), Error::Frequency { value: -1.0 });
}

#[test]
fn never_reached() {
    let p = Pendulum::<f64>::new(1.0, 1.0).expect("a swing");
    assert_eq!(p.time_at(1.5), Err(Error::NeverReached { angle: 1.5 }));
    // A quarter of a period, 1.675/ω, that is a number, and one that isn't.
    let slow = |omega| Pendulum::<f64>::new(1.0, omega).expect("a swing").time_at(0.0);
    assert!(slow(1e-308).is_ok_and(f64::is_finite));
    assert_eq!(slow(9e-309), Err(Error::NeverReached { angle: 0.0 }));
    let slow = |omega| Pendulum::<f32>::new(1.0, omega).expect("a swing").time_at(0.0);
    assert!(slow(5e-39).is_ok_and(|t| (t / 3.349_988e38 - 1.0).abs() < 1e-6));
    assert_eq!(slow(4e-39), Err(Error::NeverReached { angle: 0.0 }));
    // In `f32` the amplitude is rounded: to more than the motion reaches, and to less.
    for velocity in [0.227_424_12, 0.5, 0.7, 0.9] {
        let p = Pendulum::<f32>::from_state(1.812_973_1, velocity, 1.5).expect("a swing");
        for angle in [p.amplitude(), -p.amplitude()] {
            let t = p.time_at(angle).expect("a turning point");
            assert!(p.velocity(t).abs() < 1e-5 && (p.theta(t) - angle).abs() < 1e-6, "{velocity}: {angle} at {t}");
        }
    }
    // Where it starts it is at t = 0, even if that rounds to what the amplitude rounds to.
    for (theta, velocity, omega) in
        [(1.0, 1e-4, 1.0), (1.0, -1e-4, 1.0), (-2.959_347_5, 1e-4, 28.23), (1.872_483, -1.254_337_3e-4, 1.927_650_1)]
    {
        let p = Pendulum::<f32>::from_state(theta, velocity, omega).expect("a swing");
        assert_eq!((p.amplitude(), p.time_at(theta)), (theta.abs(), Ok(0.0)));
    }
    assert!(matches!(p.time_at(f64::NAN), Err(Error::NotFinite { parameter: "theta", .. })));
}

#[test]
fn messages_name_value_and_remedy() {
    let says = |error: Error, parts: &[&str]| {
        let message = error.to_string();
        assert!(parts.iter().all(|part| message.contains(part)), "{message}");
        assert!(std::error::Error::source(&error).is_none());
    };
    says(Error::Amplitude { value: 3.2 }, &["theta0 = 3.2 rad", "183.3", "below pi", "from_state"]);
    says(Error::Frequency { value: -2.0 }, &["omega = -2", "positive", "sqrt(g/length)"]);
    says(Error::NotFinite { parameter: "omega", value: f64::NAN }, &["omega = NaN", "finite"]);
    says(Error::Velocity { value: 1e300 }, &["velocity = 1e300 ", "theta + velocity * t"]);
    says(Error::NeverReached { angle: 1.5 }, &["theta = 1.5 rad", "amplitude", "1e15 turns"]);
    says(
        Error::Overshoot { terms: 3, overshoot: 1.25e-3, smallest: 6 },
        &["N = 3", "1.25e-3", "smallest N that works is 6"],
    );
    says(Error::NoTerms, &["N = 0", "at least 1"]);
    says(Error::NotASwing, &["Eq. 22", "`theta`"]);
}
