use super::*;
use crate::motion::Regime;
use crate::parse::{Float, Method};
use crate::scene::Goal;
use crate::testing;

fn checked(text: &str) -> Result<Scene, Vec<String>> {
    let (scene, errors) = testing::checked(text.parse().unwrap());
    if errors.is_empty() { Ok(scene.unwrap()) } else { Err(errors.iter().map(syn::Error::to_string).collect()) }
}

fn scene(text: &str) -> Scene {
    checked(text).unwrap_or_else(|errors| panic!("{text}: {errors:#?}"))
}

/// Exactly one message, which contains every one of `parts`.
#[track_caller]
fn refused(text: &str, parts: &[&str]) {
    let errors = checked(text).err().unwrap_or_else(|| panic!("{text} is accepted"));
    assert_eq!(errors.len(), 1, "{text}: {errors:#?}");
    for part in parts {
        assert!(errors[0].contains(part), "{text}: {}\nlacks: {part}", errors[0]);
    }
}

#[test]
fn the_scene_holds_what_was_asked() {
    let scene = scene(
        "pub struct Clock; θ0 = 157.5deg, g = 9.81, length = 0.994, tol = 0.125, t_max = 86_400, outputs = [velocity, theta]",
    );
    assert_eq!(scene.goal, Goal::Tolerance(0.125));
    assert_eq!(scene.outputs, [Output::Theta, Output::Velocity]);
    assert_eq!(scene.t_max.unwrap().to_f64(), 86_400.0);
    assert_eq!(scene.motion.omega.to_f64(), 3.141_530_724_304_714_3);
    assert_eq!(
        scene.source,
        "theta0 = 157.5deg, g = 9.81, length = 0.994, tol = 0.125, t_max = 86_400, outputs = [velocity, theta]"
    );
}

#[test]
fn defaults_are_full_precision_and_theta() {
    let scene = scene("theta0 = 7π/8");
    assert_eq!((scene.goal, scene.float, scene.method), (Goal::Full, Float::F64, None));
    assert_eq!(scene.outputs, [Output::Theta]);
    assert!(scene.t_max.is_none());
    assert_eq!(scene.motion.omega.to_f64(), 1.0);
}

#[test]
fn the_source_is_evenly_spaced() {
    let scene = scene("theta0=3*PI /4-0.01,omega = - ( 1-3 ) +sqrt( 2 )");
    assert_eq!(scene.source, "theta0 = 3*PI/4 - 0.01, omega = -(1 - 3) + sqrt(2)");
}

#[test]
fn the_tolerance_is_never_rounded_up() {
    let Goal::Tolerance(tolerance) = scene("theta0 = 1, tol = 0.1").goal else { panic!("a tolerance") };
    // 0.1 in binary is above a tenth.
    assert_eq!(tolerance, 0.1_f64.next_down());
    let Goal::Tolerance(tolerance) = scene("theta0 = 1, tol = 0.3").goal else { panic!("a tolerance") };
    assert_eq!(tolerance, 0.3);
}

/// Of `f32` to one of its numbers: a bound, rounded up to the next, is no larger than the tolerance as stated.
#[test]
fn tolerances_of_single_precision() {
    for tol in [1e-2, 1e-4, 3e-4, 1e-5, 0.25] {
        let scene = scene(&format!("theta0 = 1, tol = {tol:e}, float = f32"));
        let Goal::Tolerance(tolerance) = scene.goal else { panic!("a tolerance") };
        assert_eq!(f64::from(tolerance as f32), tolerance, "{tol}");
        assert!(tolerance <= tol && f64::from((tolerance as f32).next_up()) > tol, "{tol}: {tolerance}");
    }
    // What no `f32` holds is said to be out of reach, not to be 0.
    assert_eq!(scene("theta0 = 1, tol = 1e-60, float = f32").goal, Goal::Tolerance(1e-60));
}

#[test]
fn refuses_states_that_do_not_move() {
    refused("n = 4", &["`theta0` is missing", "velocity0"]);
    refused("struct A; omega = 1", &["`theta0` is missing"]);
    refused("theta0 = 0", &["`theta0 = 0`", "hangs still", "velocity0"]);
    refused("velocity0 = 0", &["`velocity0 = 0`", "hangs still"]);
    refused("theta0 = sqrt(2)*sqrt(2) - 2", &["hangs still"]);
    refused("theta0 = π", &["3.141592653589793 rad = 180.0°", "balanced", "velocity0"]);
    refused("theta0 = -180deg", &["balanced"]);
    // Of angles that took more digits to evaluate as well.
    for top in ["(1+1e-20-1)*1e20*π", "(1+1e-25-1)*1e25*π", "(1/3 + 1e-40 - 1/3)*1e40*π", "π + 1e-30 - 1e-30"] {
        refused(&format!("theta0 = {top}"), &["balanced"]);
    }
    refused(
        "theta0 = 200deg",
        &["`theta0 = 200deg`", "3.490658503988659 rad = 200.0°", "velocity0", "`theta0 = -160deg`"],
    );
    refused("theta0 = 3.5", &["`theta0 = -2.7831853071795867` is the same position"]);
    for (text, remedy) in [
        ("45", "`theta0 = 45deg`"),
        ("-60", "`theta0 = -60deg`"),
        ("90, velocity0 = 1", "`theta0 = 90deg`"),
        ("-(45.)", "`theta0 = -45deg`"),
        ("4_5.50e0", "`theta0 = 45.5deg`"),
    ] {
        refused(&format!("theta0 = {text}"), &["if degrees are meant", remedy]);
    }
    for text in ["200", "90rad", "45/1", "2*PI + 1"] {
        let errors = checked(&format!("theta0 = {text}")).err().unwrap();
        assert!(!errors[0].contains("degrees are meant"), "{text}: {}", errors[0]);
    }
    refused("theta0 = 5π, velocity0 = 1", &["beyond the top", "`theta0 = 1π` is the same state"]);
    refused("theta0 = -900deg, velocity0 = 1", &["`theta0 = 180deg` is the same state"]);
    refused("theta0 = 4π, velocity0 = 1", &["`theta0 = 0` is the same state"]);
    refused("theta0 = 7π", &["21.991148575128552 rad = 1260.0°", "balanced on the top"]);
    refused("theta0 = -540deg", &["balanced on the top"]);
    refused("theta0 = -540deg, velocity0 = 0", &["balanced on the top"]);
    refused("theta0 = 2π", &["`theta0 = 2π` at rest hangs still"]);
    refused("theta0 = 1e300", &["`theta0` less its full turns"]);
    refused("theta0 = 1e-400", &["`theta0 = 1e-400` is below the smallest normal `f64`"]);
    refused("θ0 = 1e-400", &["`θ0 = 1e-400` is below the smallest normal `f64`"]);
    refused("theta0 = 1e-39, float = f32", &["below the smallest normal `f32`", "f64"]);
    refused("theta0 = 1, velocity0 = 1e400", &["`velocity0 = 1e400` is above the largest `f64`"]);
}

#[test]
fn refuses_rates_that_are_none() {
    refused("theta0 = 1, omega = 0", &["`omega = 0` is not positive"]);
    refused("theta0 = 1, ω = -2", &["`ω = -2` is not positive"]);
    refused("theta0 = 1, g = 9.81, length = 0", &["`length = 0` is not positive"]);
    refused("theta0 = 1, g = -9.81, length = 1", &["`g = -9.81` is not positive"]);
    refused("theta0 = 1, g = 9.81", &["`g = 9.81` alone", "`length`"]);
    refused("theta0 = 1, length = 2", &["`length = 2` alone", "`g`"]);
    refused("theta0 = 1, omega = 1, g = 9.81", &["`g`", "`omega`", "keep"]);
    refused("theta0 = 1, omega = 1e-308", &["`omega = 1e-308` is below the smallest normal"]);
    refused("theta0 = 1, ω = 1e-308", &["`ω = 1e-308` is below the smallest normal"]);
    refused("theta0 = 1, omega = 1e-285", &["`omega = 1e-285` makes a period of 6.69", "above 1e280", "a larger unit"]);
    refused("velocity0 = 3e-300, omega = 1e-300", &["`omega = 1e-300` makes a period of", "a larger unit"]);
    refused("struct A; theta0 = 1, omega = 1e200, outputs = [acceleration]", &["the largest acceleration above"]);
    refused("theta0 = 1, omega = 2deg", &["`omega = 2deg` has the suffix `deg`"]);
    // One mistake, one message, where removing one token's parameter mends it.
    let both = &["`omega = 1`", "beside `g` and `length`", "keep `omega`"];
    refused("theta0 = 1, omega = 1, g = 9.81, length = 1", both);
    refused("theta0 = 1, g = 9.81, length = 1, ω = 1", &["`ω = 1` is given beside `g` and `length`", "keep `ω`"]);
    refused("theta0 = 1, omega = 1, length = 1", &["`length = 1` is given beside `omega`"]);
    let also_zero = checked("theta0 = 1, omega = 0, g = 9.81, length = 1").err().unwrap();
    assert_eq!(also_zero.len(), 2, "{also_zero:#?}");
}

#[test]
fn refuses_goals_that_cannot_be_kept() {
    refused("theta0 = 1, n = 0", &["`n = 0`", "`n = 1`"]);
    refused("theta0 = 1, n = 3, tol = 1e-3", &["`n = 3`", "`tol = 1e-3`", "keep one"]);
    refused("theta0 = 1, tol = 0", &["`tol = 0` is not positive", "full precision"]);
    refused("theta0 = 1, tol = -1e-3", &["`tol = -1e-3` is not positive"]);
    refused("theta0 = 1, tol = 1e-400", &["`tol = 1e-400`", "smaller than every `f64`"]);
    refused("theta0 = 1, tol = 1deg", &["`tol = 1deg` has the suffix `deg`", "radians"]);
    refused("theta0 = 1, tol = 1/(1 - 1)", &["`tol = 1/(1 - 1)`: division by zero"]);
    refused("theta0 = 1, t_max = 0", &["`t_max = 0` is not positive"]);
    refused("theta0 = 1, t_max = 1e300", &["`t_max = 1e300`", "2⁵³ periods"]);
    refused("velocity0 = 3, n = 4", &["`n = 4`", "rotation", "`tol`"]);
    refused("velocity0 = 3, n = 4, tol = 1e-3", &["`n = 4`", "rotation", "leave `n` out"]);
    refused("struct A; theta0 = 1, n = 4, outputs = [theta, wrapped]", &["`fourier`", "leave `wrapped` out"]);
    refused("struct A; theta0 = 1, n = 4, outputs = [wrapped]", &["`wrapped`", "`fourier`", "use `theta`"]);
    refused("struct A; theta0 = 1, method = series, outputs = [position]", &["`series`", "use `method = polynomial`"]);
    let with_tolerance = "struct A; theta0 = 1, method = series, tol = 1e-3, outputs = [position]";
    refused(with_tolerance, &["`series`", "use `method = fourier` or `polynomial`"]);
    refused("theta0 = 1, outputs = [theta, velocity]", &["item form", "`velocity`"]);
}

#[test]
fn refuses_methods_that_cannot_serve() {
    refused("theta0 = 1, method = fourier", &["`n = 4`", "`tol = 1e-3`"]);
    refused("theta0 = 1, method = series, n = 4", &["`method = series` takes no `n`", "`n = 4`", "`tol`"]);
    refused("theta0 = 1, method = harmonic, n = 4", &["`method = harmonic` takes no `n`"]);
    refused("velocity0 = 3, method = harmonic", &["`method = harmonic`", "rotation", "`polynomial`"]);
    refused("velocity0 = 3, n = 4", &["`n = 4`", "rotation", "leave `n` out"]);
    refused("velocity0 = 3, n = 4, method = series", &["`n = 4`", "rotation", "leave `n` and `method` out"]);
    refused("velocity0 = 3, method = fourier", &["`method = fourier` can't serve a rotation", "use `polynomial`"]);
    refused("velocity0 = 3, n = 4, method = fourier", &["`n = 4`", "rotation", "leave `n` and `method` out"]);
    refused("velocity0 = 2, method = series", &["`method = series`", "separatrix"]);
    assert_eq!(scene("velocity0 = 3, method = polynomial").method, Some(Method::Polynomial));
    assert_eq!(scene("theta0 = 1, velocity0 = 1, method = fourier, tol = 1e-3").method, Some(Method::Fourier));
    assert_eq!(scene("theta0 = 1, velocity0 = 1, n = 4").goal, Goal::Terms(4));
}

#[test]
fn reports_mistakes_of_every_parameter_together() {
    let errors = checked("theta0 = 4, omega = 0, n = 0, tol = -1, t_max = -2, method = series").err().unwrap();
    let about = |word: &str| errors.iter().any(|error| error.contains(word));
    for word in ["`omega = 0`", "`n = 0`", "`tol = -1`", "`t_max = -2`", "`method = series`"] {
        assert!(about(word), "{word}: {errors:#?}");
    }
    // Whatever follows from a mistake is not another: the angle needs no ω, `theta` was meant as `theta0`.
    assert!(about("`theta0 = 4`"), "{errors:#?}");
    refused("theta = 1, n = 4", &["did you mean `theta0`"]);
    refused("amplitude = 1, n = 4", &["did you mean `theta0`"]);
    refused("theta0 = 1, l = 2, g = 3", &["did you mean `length`"]);
    refused("theta0 = 1, period = 2", &["did you mean `omega = 2π/period`"]);
    refused("theta0 = x, n = 4", &["`x` can't be evaluated"]);
    refused("theta0 =, n = 4", &["lacks its value"]);
    refused("θ_0 = 1", &["did you mean `theta0`"]);
    refused("phi = 1, n = 4", &["unknown parameter `phi`"]);
    refused("1, n = 4", &["expected `name = value`"]);
    refused("theta0 = 1, g = 9.81, ell = 1", &["did you mean `length`"]);
    refused("theta0 = 1, gee = 9.81, length = 1", &["unknown parameter `gee`"]);
    refused("type A; theta0 = 1", &["expected `struct A;`"]);
    refused("theta0 = 1, g = 9.81, length = l", &["`l` can't be evaluated"]);
}

/// What was meant isn't known, and isn't taken for 0 or 1: nothing is said of the motion that would be made by those.
#[test]
fn what_depends_on_a_mistake_is_no_other() {
    for (text, part) in [
        ("theta0 = 0, velocity = 1", "did you mean `velocity0`"),
        ("theta0 = 180deg, velocity0 = 1.5rads", "suffix `rads`"),
        ("theta0 = 180deg, velocity0 = V0", "`V0` can't be evaluated"),
        ("velocity0 = 0, theta0 = x", "`x` can't be evaluated"),
        ("velocity0 = 3, theta0 = x, method = harmonic", "`x` can't be evaluated"),
        ("velocity0 = 3, Omega = 2, method = harmonic", "did you mean `omega`"),
        ("velocity0 = 3, omega = 2Hz, method = series", "suffix `Hz`"),
        ("velocity0 = 3, omega = W, n = 4", "`W` can't be evaluated"),
        ("velocity0 = 3, g = 9.81, len = 0.5, n = 4", "did you mean `length`"),
        ("theta0 = 1, omga = 1e-3, t_max = 1e18", "did you mean `omega`"),
        ("theta0 = 0.95π, n = 3, velocity0 = -0.1x", "suffix `x`"),
        ("theta0 = π, theta_dot = 1", "did you mean `velocity0`"),
        ("theta0 = 0, dtheta0 = 1", "did you mean `velocity0`"),
        ("theta0 = 0, push = 1", "unknown parameter `push`"),
        ("velocity0 = 3, rate = 2, n = 4", "did you mean `omega`"),
        ("velocity0 = 3, freq = 2, n = 4", "did you mean `omega = 2π*freq`"),
        ("theta0 = 1, method = fourier, order = 4", "did you mean `n`"),
        ("theta0 = 1, method = fourier, max_error = 1e-4", "did you mean `tol`"),
        ("theta0 = 1, method = fourier, digits = 4", "unknown parameter `digits`"),
        ("theta0 = 1, g = 9.81, length = 1, period = 2", "did you mean `omega = 2π/period`"),
    ] {
        refused(&format!("struct A; {text}"), &[part]);
    }
    // Beyond the top it is with any velocity, at any rate.
    let errors = checked("theta0 = 4, velocity0 = x, omega = y").err().unwrap();
    assert!(errors.len() == 3 && errors.iter().any(|error| error.contains("beyond the top")), "{errors:#?}");
}

#[test]
fn the_regime_is_decided_exactly() {
    let regime = |text: &str| scene(text).motion.regime;
    for separatrix in [
        "velocity0 = 2",
        "velocity0 = -2*sqrt(9.81/0.994), g = 9.81, length = 0.994",
        "theta0 = 2π/3, velocity0 = 1",
        "theta0 = 120deg, velocity0 = 1",
        "velocity0 = 360deg/π",
    ] {
        assert!(matches!(regime(separatrix), Regime::Separatrix(_)), "{separatrix}");
    }
    assert!(matches!(regime("velocity0 = 1.9999999999999999999999999999999999"), Regime::Swing(_)));
    assert!(matches!(regime("velocity0 = 2.0000000000000000000000000000000001"), Regime::Rotation(_)));
    assert!(matches!(regime("theta0 = π, velocity0 = 1e-300"), Regime::Rotation(_)));
}

#[test]
fn suffixes_belong_to_angles() {
    refused("theta0 = 1, t_max = 1h", &["`t_max = 1h` has the suffix `h`: `t_max` is in the unit of t"]);
    refused("theta0 = 1, omega = 60rpm", &["`omega = 60rpm` has the suffix `rpm`", "in radians per unit of t"]);
    refused("theta0 = 1, g = 9.81m/s, length = 1", &["`g = 9.81m/s` has the suffix `m`", "in m/s²"]);
    refused("theta0 = 90grad", &["`theta0 = 90grad` has the suffix `grad`", "`π`, `deg` or `rad`"]);
}

#[test]
fn counts_of_terms_are_whole_numbers() {
    refused("theta0 = 1, n = 2.5", &["`n = 2.5` counts no terms", "write a whole number in digits"]);
    refused("theta0 = 1, n = 4usize", &["`n = 4usize` has a suffix: write `n = 4`"]);
    refused("theta0 = 1, n = -4", &["`n = -4` is negative"]);
    refused("theta0 = 1, n = 99999999999999999999999", &["`n = 99999999999999999999999` is more terms"]);
    refused("theta0 = 1, tol = 1e-500", &["`tol` has `1e-500` in it", "±400"]);
}
