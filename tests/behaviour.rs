//! What holds to the bit, and at the edges of the input.

use core::f64::consts::PI;
use pendula::{Pendulum, pendulum};
use pendula_stress::random::Random;

/// Motions released from rest, each with its mirror image.
macro_rules! mirrored {
    ($($float:ident $theta0:tt $mirror:tt within $periods:literal: $($parameters:ident = $value:tt),*;)*) => {$({
        pendulum! {
            struct Right;
            theta0 = $theta0, float = $float, $($parameters = $value),*
        }
        pendulum! {
            struct Left;
            theta0 = $mirror, float = $float, $($parameters = $value),*
        }
        let asked = stringify!($float $theta0 $($parameters = $value),*);
        let mut random = Random::new(7);
        for i in 0..2000 {
            // The first periods, and 2⁻¹⁰⁰ … 1 of the horizon.
            let t = if i % 2 == 0 { 40.0 * random.signed() } else { $periods * (-100.0 * random.unit()).exp2() };
            let t = t as $float * Right::PERIOD;
            assert_eq!(Right::theta(-t).to_bits(), Right::theta(t).to_bits(), "{asked}: θ(−t) = θ(t) at {t:e}");
            assert_eq!(Left::theta(t).to_bits(), (-Right::theta(t)).to_bits(), "{asked}: θ0 → −θ0 at {t:e}");
        }
        // Beyond the horizon, too, up to the last of all numbers.
        for i in 0..4000 {
            let t = $float::MAX.powf(0.1 + 0.225 * f64::from(i % 5) as $float * random.unit() as $float);
            assert_eq!(Right::theta(-t).to_bits(), Right::theta(t).to_bits(), "{asked}: θ(−t) = θ(t) at {t:e}");
            assert_eq!(Left::theta(t), -Right::theta(t), "{asked}: θ0 → −θ0 at {t:e}");
        }
    })*};
}

#[test]
fn time_and_amplitude_mirror_to_the_bit() {
    mirrored! {
        f64 (7π/8) (-7π/8) within 9e15:;
        f64 1 (-1) within 9e15:;
        f64 1e-9 (-1e-9) within 9e15:;
        f64 2 (-2) within 100.0: tol = 1e-9, t_max = 1000;
        f64 (7π/8) (-7π/8) within 1.0: t_max = 2;
        f64 3 (-3) within 1.0: tol = 1e-6, t_max = 0.01;
        f32 1 (-1) within 1.0: tol = 1e-3, t_max = 1;
        f64 1 (-1) within 9e15: tol = 1e-3, method = series;
        f64 (0.999π) (-0.999π) within 9e15: method = series;
        f64 0.1 (-0.1) within 9e15: tol = 1e-2, method = harmonic;
        f32 (7π/8) (-7π/8) within 9e15:;
        f32 2 (-2) within 10.0: tol = 1e-4, t_max = 100;
    }
}

#[test]
fn the_papers_function_mirrors_too() {
    mirrored! {
        f64 (7π/8) (-7π/8) within 9e15: n = 4;
        f64 (0.95π) (-0.95π) within 9e15: n = 6;
        f32 1 (-1) within 9e15: n = 3;
        f32 1 (-1) within 100.0: tol = 1e-3, t_max = 1000, method = fourier;
    }
}

#[test]
fn velocity_is_odd_in_time_where_theta_is_even() {
    let mut random = Random::new(8);
    macro_rules! check {
        ($($theta0:tt $float:ident: $($parameters:ident = $value:tt),*;)*) => {$({
            pendulum! {
                struct Motion;
                theta0 = $theta0, float = $float, $($parameters = $value,)*
                outputs = [theta, velocity, acceleration, position]
            }
            let asked = stringify!($theta0 $float $($parameters = $value),*);
            for i in 0..6000 {
                let power = random.unit();
                let t = if i % 2 == 0 { (1e6 * random.signed()) as $float } else { $float::MAX.powf(power as $float) };
                assert_eq!(Motion::velocity(-t), -Motion::velocity(t), "{asked} at {t:e}");
                assert_eq!(Motion::acceleration(-t), Motion::acceleration(t), "{asked} at {t:e}");
                assert_eq!(Motion::position(-t), Motion::position(t), "{asked} at {t:e}");
                assert_eq!(Motion::state(t), (Motion::theta(t), Motion::velocity(t)), "{asked} at {t:e}");
            }
        })*};
    }
    check! {
        (7π/8) f64:;
        (7π/8) f32:;
        2 f64: tol = 1e-9, t_max = 1000;
        2 f32: tol = 1e-4, t_max = 100;
        // In pieces, by its passages, from the lowest point, and by the paper's.
        (0.99999π) f64: tol = 1e-12;
        (3.14159265) f64:;
        1e-9 f64:;
        1 f64: tol = 1e-3, method = fourier;
        1 f64: n = 3, t_max = 1000;
    }
}

/// NaN or ±∞ in, NaN out, from a function of one or two results.
trait Nan {
    fn is_all_nan(&self) -> bool;
    fn is_all_finite(&self) -> bool;
}

impl Nan for f64 {
    fn is_all_nan(&self) -> bool {
        self.is_nan()
    }
    fn is_all_finite(&self) -> bool {
        self.is_finite()
    }
}

impl Nan for f32 {
    fn is_all_nan(&self) -> bool {
        self.is_nan()
    }
    fn is_all_finite(&self) -> bool {
        self.is_finite()
    }
}

impl<T: Nan> Nan for (T, T) {
    fn is_all_nan(&self) -> bool {
        self.0.is_all_nan() && self.1.is_all_nan()
    }
    fn is_all_finite(&self) -> bool {
        self.0.is_all_finite() && self.1.is_all_finite()
    }
}

/// So slow that no finite time is at the top for good.
#[test]
fn the_slowest_separatrices() {
    pendulum! { struct Lowest; omega = 1e-306, velocity0 = 2e-306, outputs = [theta, velocity] }
    pendulum! { struct Launched; omega = 1e-306, theta0 = 1π/2, velocity0 = sqrt(2)*1e-306, outputs = [theta, velocity] }
    for state in [Lowest::state, Launched::state] {
        for t in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(state(t).is_all_nan(), "{:?} at {t}", state(t));
        }
        for t in [f64::MIN, -1e306, 0.0, 1e-300, 1e306, f64::MAX] {
            assert!(state(t).is_all_finite() && state(t).0.abs() <= PI, "{:?} at {t}", state(t));
        }
    }
}

#[test]
fn what_is_not_a_time_gives_nan() {
    macro_rules! check {
        ($float:ident: $($function:ident)*; $($parameters:tt)*) => {{
            pendulum! {
                struct Motion;
                float = $float, outputs = [$($function),*], $($parameters)*
            }
            let asked = stringify!($float, $($parameters)*);
            for t in [$float::NAN, -$float::NAN, $float::INFINITY, $float::NEG_INFINITY] {
                $({
                    let result = Motion::$function(t);
                    assert!(result.is_all_nan(), "{}({t}) with {asked} is {result:?}", stringify!($function));
                })*
            }
            let tiny = [0.0, $float::MIN_POSITIVE, $float::from_bits(1)];
            for t in tiny.into_iter().chain([1e15, 1e22, -1e30, 1e38, $float::MAX, $float::MIN]) {
                $({
                    let result = Motion::$function(t);
                    assert!(result.is_all_finite(), "{}({t}) with {asked} is {result:?}", stringify!($function));
                })*
            }
            for exponent in 0..130 {
                let limit = Motion::AMPLITUDE + Motion::MAX_ERROR;
                let t = $float::from_bits((($float::MAX.to_bits() >> ($float::MANTISSA_DIGITS - 1)) - exponent)
                    << ($float::MANTISSA_DIGITS - 1)) * 1.2345;
                assert!(t.is_infinite() || Motion::theta(t).abs() <= limit, "{asked}: {} at {t:e}", Motion::theta(t));
            }
        }};
    }
    check!(f64: theta velocity acceleration position; theta0 = 7π/8);
    check!(f64: theta velocity acceleration position; theta0 = 1e-9);
    check!(f64: theta velocity acceleration position; theta0 = 1, velocity0 = 1);
    check!(f64: theta velocity acceleration position; theta0 = 2, omega = 1e6);
    check!(f64: theta velocity acceleration position; theta0 = 2, omega = 1e-6);
    check!(f64: theta velocity acceleration position; theta0 = 2, tol = 1e-9, t_max = 100);
    check!(f64: theta velocity acceleration position; theta0 = 0.95π, tol = 1e-4, t_max = 1e6);
    check!(f64: theta velocity acceleration position; theta0 = 7π/8, tol = 1e-9, t_max = 2);
    check!(f64: theta velocity acceleration position; velocity0 = -1.9, t_max = 0.5);
    check!(f64: theta velocity acceleration position; theta0 = 1, velocity0 = 1, omega = 1e9, tol = 1e-6, t_max = 1e-9);
    check!(f64: theta velocity; theta0 = 7π/8, n = 4);
    check!(f64: theta velocity; theta0 = 1, omega = 1e6, n = 4);
    check!(f64: theta; theta0 = 1, tol = 1e-2, t_max = 10, method = series);
    check!(f64: theta; theta0 = 1, tol = 0.5, t_max = 10, method = harmonic);
    check!(f64: theta; theta0 = 0.01, tol = 1e-3, t_max = 10, method = small_angle);
    check!(f64: theta; theta0 = 1, tol = 1e-2, method = fourier);
    check!(f32: theta velocity acceleration position; theta0 = 7π/8);
    check!(f32: theta velocity acceleration position; theta0 = 2, tol = 1e-4, t_max = 100);
    check!(f32: theta velocity acceleration position; theta0 = 2, omega = 1000, tol = 1e-3);
    check!(f32: theta velocity acceleration position; theta0 = 2, velocity0 = -0.0001, omega = 1e-3, tol = 1e-3, t_max = 500);
    check!(f32: theta velocity; theta0 = 7π/8, n = 4);
    check!(f32: theta; theta0 = 1, tol = 1e-2, t_max = 10, method = series);
}

/// Constant evaluation, of every output, in both precisions.
#[test]
fn tables_are_constants() {
    const LENGTH: usize = 64;
    const TABLE: [f32; LENGTH] = {
        let (mut table, mut i) = ([0.0; LENGTH], 0);
        while i < LENGTH {
            table[i] = Narrow::theta(i as f32 * (Narrow::PERIOD / LENGTH as f32));
            i += 1;
        }
        table
    };
    const START: (f64, f64) = Wide::state(0.0);
    const CORNER: (f64, f64) = Wide::position(0.0);
    const PULL: f64 = Wide::acceleration(0.0);
    pendulum! {
        struct Narrow;
        theta0 = 7π/8, float = f32
    }
    pendulum! {
        struct Wide;
        theta0 = 1π/2, outputs = [theta, velocity, acceleration, position]
    }
    for (i, &entry) in TABLE.iter().enumerate() {
        assert_eq!(entry.to_bits(), Narrow::theta(i as f32 * (Narrow::PERIOD / LENGTH as f32)).to_bits());
    }
    approx::assert_abs_diff_eq!(TABLE[0], (7.0 * PI / 8.0) as f32, epsilon = 1e-6);
    approx::assert_abs_diff_eq!(TABLE[32], -(7.0 * PI / 8.0) as f32, epsilon = 1e-6);
    approx::assert_abs_diff_eq!(START.0, PI / 2.0, epsilon = Wide::MAX_ERROR);
    approx::assert_abs_diff_eq!(START.1, 0.0, epsilon = Wide::MAX_VELOCITY_ERROR);
    approx::assert_abs_diff_eq!(PULL, -1.0, epsilon = Wide::MAX_ACCELERATION_ERROR);
    approx::assert_abs_diff_eq!(CORNER.0, 1.0, epsilon = Wide::MAX_POSITION_ERROR);
    approx::assert_abs_diff_eq!(CORNER.1, 0.0, epsilon = Wide::MAX_POSITION_ERROR);
}

#[test]
fn the_expression_is_a_function_of_no_size() {
    let theta = pendulum!(theta0 = 7π / 8, n = 4);
    assert_eq!(size_of_val(&theta), 0);
    let pointer: fn(f64) -> f64 = theta;
    assert_eq!(pointer(0.25), theta(0.25));
    let single = pendulum!(theta0 = 7π / 8, float = f32, outputs = [position]);
    assert_eq!(size_of_val(&single), 0);
    let pointer: fn(f32) -> (f32, f32) = single;
    assert_eq!(pointer(0.25), single(0.25));
}

/// As README says.
#[test]
fn the_size_of_a_pendulum() {
    assert_eq!([size_of::<Pendulum<f64>>(), size_of::<Pendulum<f32>>()], [384; 2]);
}

#[test]
fn the_item_and_the_expression_are_the_same_plan() {
    pendulum! {
        #[derive(Clone, Copy)]
        struct Motion;
        theta0 = 2, tol = 1e-9, t_max = 1000
    }
    assert_eq!(size_of::<Motion>(), 0);
    let theta = pendulum!(theta0 = 2, tol = 1e-9, t_max = 1000);
    let mut random = Random::new(9);
    for _ in 0..1000 {
        let t = 1000.0 * random.signed();
        assert_eq!(theta(t).to_bits(), Motion::theta(t).to_bits());
    }
}

/// θ̈ + ω² sin θ = 0, and the energy, from what the functions return.
#[test]
fn the_outputs_are_one_motion() {
    pendulum! {
        struct Motion;
        theta0 = 7π/8, omega = 3, outputs = [theta, velocity, acceleration, position]
    }
    let mut random = Random::new(10);
    // E/ω² = θ̇²/(2ω²) − cos θ. Each term is good to a few units of 2⁻⁵⁰, the velocity's square to 4 k² times as many.
    let energy = -(7.0 * PI / 8.0).cos();
    for _ in 0..5000 {
        let t = 1e9 * random.signed();
        let (theta, velocity) = Motion::state(t);
        let (x, y) = Motion::position(t);
        approx::assert_abs_diff_eq!(Motion::acceleration(t), -9.0 * theta.sin(), epsilon = 9.0 * 2e-14 / 3.0);
        approx::assert_abs_diff_eq!(velocity * velocity / 18.0 + y, energy, epsilon = 2e-14);
        approx::assert_abs_diff_eq!(x, theta.sin(), epsilon = 8e-15);
        approx::assert_abs_diff_eq!(y, -theta.cos(), epsilon = 8e-15);
    }
}

/// Just below a power of two anchors a sum with another phase at t = 0 is rounded in the binade above, where a tie may go
/// either way: the remainder is then a little beyond its range, and isn't cut off. (Exact values: mpmath, 60 digits.)
#[test]
fn remainders_beside_a_tie() {
    pendulum! { struct Below; velocity0 = 2 - 702e-14, t_max = 233109.097, tol = 2.792e-11, outputs = [velocity] }
    pendulum! { struct Above; velocity0 = 2 + 767e-16, t_max = 4221.6134, tol = 5.663e-13, outputs = [velocity] }
    pendulum! { struct Angle; velocity0 = 2 - 491e-12, t_max = 31.895692, tol = 7.5e-15 }
    for (found, exact, bound) in [
        (Below::velocity(-2.331_014_366_020_370_5e5), 1.625_024_782_947_224_7, Below::MAX_VELOCITY_ERROR),
        (Above::velocity(4.219_574_547_649_768e3), 1.522_367_110_575_919_5, Above::MAX_VELOCITY_ERROR),
        (Angle::theta(-24.018_047_231_087_934), -0.376_002_259_025_195_9, Angle::MAX_ERROR),
    ] {
        let error: f64 = found - exact;
        assert!(error.abs() <= bound, "{error:e} exceeds {bound:e}");
    }
}

/// Beyond 2⁵¹ anchors the sum that rounds in one word has no odd numbers: the sign of a swing would be lost.
#[test]
fn signs_after_many_anchors() {
    let theta = pendulum!(theta0 = 0.5, tol = 0.7, float = f32, t_max = 1e16);
    assert!((theta(-7_436_522_735_271_936.0) + 0.499_979_86).abs() < 0.7);
}
