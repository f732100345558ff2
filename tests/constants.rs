//! The associated constants are the correctly rounded values of the exact reals: to the bit, in both precisions.
// Greek names and no other Greek, on purpose.
#![allow(mixed_script_confusables)]

macro_rules! check {
    ($float:ident; $($theta0:tt $($n:literal)?),*) => {$({
        pendula::pendulum! {
            struct Motion;
            theta0 = $theta0, float = $float, $(n = $n)?
        }
        let name = stringify!($theta0).replace([' ', '(', ')'], "");
        let row = include_str!("../pendulum-macros/tests/data/amplitudes.csv")
            .lines()
            .find_map(|line| line.strip_prefix(&format!("{name},")))
            .unwrap_or_else(|| panic!("amplitudes.csv lacks {name}"));
        // `parse` rounds the 60 digits correctly.
        let exact: Vec<$float> = row.split(',').map(|cell| cell.parse().expect("a decimal")).collect();
        let [k, quarter, complementary, nome, period] = [0, 1, 2, 3, 4].map(|i| exact[i].to_bits());
        assert_eq!(Motion::MODULUS.to_bits(), k, "k at {name}");
        assert_eq!(Motion::K.to_bits(), quarter, "K at {name}");
        assert_eq!(Motion::K_PRIME.to_bits(), complementary, "K' at {name}");
        assert_eq!(Motion::NOME.to_bits(), nome, "q at {name}: {} {}", Motion::NOME, exact[3]);
        assert_eq!(Motion::PERIOD.to_bits(), period, "T at {name}");
        assert_eq!(Motion::OMEGA, 1.0);
        $(
            // The columns are b1, b3, b5, b7.
            for (i, b) in Motion::COEFFICIENTS.iter().enumerate().take(4) {
                assert_eq!(b.to_bits(), exact[5 + i].to_bits(), "b{} at {name}", 2 * i + 1);
            }
            assert_eq!((Motion::COEFFICIENTS.len(), Motion::TERMS), ($n, $n));
        )?
    })*};
}

#[test]
fn f64_to_the_bit() {
    check! { f64;
        1e-300, 1e-100, 1e-9, 3e-9, 1e-8 1, 1e-6 1, 1e-4 2, 0.001 2, 0.01 3, 0.1 4, (1/3) 4, 0.5 4, 1 4, (π/6) 4,
        (π/4) 4, (π/3) 4, 1.2345678901234567890123456789 4, (π/2) 4, 90.5deg 4, 2 4, (2π/3) 4, (3*PI/4-0.01) 4, (4π/5) 4,
        2.5 4, (7π/8) 4, 157.5deg 4, (0.9π) 4, (0.95π) 4, (0.96π) 5, 3 5, (0.97π) 6, (0.99π) 10, 3.14 24
    }
}

#[test]
fn f32_to_the_bit() {
    check! { f32;
        1e-4 1, 0.01 2, 0.1 2, 0.5 3, 1 4, (π/3) 4, (π/2) 4, 2 4, (3*PI/4-0.01) 4, (4π/5) 4, (7π/8) 4, (0.95π) 4,
        (0.97π) 6
    }
}

#[test]
fn angles_in_degrees_and_radians_are_the_same_reals() {
    pendula::pendulum! {
        struct Degrees;
        theta0 = 157.5deg, g = 9.81, length = 0.994, n = 4
    }
    pendula::pendulum! {
        struct Radians;
        θ0 = 7π/8 + 0rad, ω = sqrt(9.81/0.994), n = 4
    }
    assert_eq!(Degrees::THETA0.to_bits(), Radians::THETA0.to_bits());
    assert_eq!(Degrees::OMEGA.to_bits(), Radians::OMEGA.to_bits());
    assert_eq!(Degrees::PERIOD.to_bits(), Radians::PERIOD.to_bits());
    assert_eq!(Degrees::COEFFICIENTS.map(f64::to_bits), Radians::COEFFICIENTS.map(f64::to_bits));
    assert_eq!(Degrees::theta(0.3).to_bits(), Radians::theta(0.3).to_bits());
}

/// A state and a horizon as they were given; a horizon is rounded down, since the promise ends there.
#[test]
fn the_launch_and_the_horizon() {
    pendula::pendulum! {
        struct Launched;
        theta0 = 0.3, velocity0 = -4/5, tol = 1e-6, t_max = 0.1, float = f32
    }
    pendula::pendulum! {
        struct Released;
        theta0 = 1, omega = 2
    }
    assert_eq!((Launched::THETA0, Launched::VELOCITY0, Launched::OMEGA), (0.3, -0.8, 1.0));
    assert_eq!(Launched::T_MAX, 0.1_f32.next_down());
    assert_eq!((Released::VELOCITY0, Released::T_MAX), (0.0, 2f64.powi(53) * Released::PERIOD));
}
