//! Both forms, with attributes, documentation and visibility; Greek names and every kind of number.

#![deny(warnings, missing_docs)]
// The compiler's, wherever a crate has Greek names in it and no other Greek; `theta0`, `omega` and `1π` avoid it.
#![allow(mixed_script_confusables)]

use pendula::pendulum;

mod clocks {
    pendula::pendulum! {
        /// The clock on the wall.
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub(crate) struct Clock;
        θ0 = 157.5deg, g = 9.81, length = 0.994, tol = 1e-9, t_max = 86_400, outputs = [theta, velocity],
    }
}

pendulum! {
    struct Private;
    theta0 = 3*PI/4 - 0.01, ω = sqrt(2), n = 3
}

fn main() {
    let theta: fn(f64) -> f64 = pendulum!(theta0 = 7π/8, n = 4);
    assert!((theta(0.0) - 7.0 * std::f64::consts::PI / 8.0).abs() < 0.02);
    let (x, v) = (clocks::Clock::theta(3.0), clocks::Clock::velocity(3.0));
    assert_eq!((x, v), clocks::Clock::state(3.0));
    assert!(clocks::Clock::MAX_ERROR <= 1e-9);
    assert_eq!(clocks::Clock, clocks::Clock::default());
    assert!(Private::theta(0.0) > 2.0);
    let single: fn(f32) -> f32 = pendulum!(theta0 = 0.3rad, float = f32, tol = 1e-4,);
    assert!((single(0.0) - 0.3).abs() < 2e-4);
}
