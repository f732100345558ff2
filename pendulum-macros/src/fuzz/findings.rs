//! What fuzzing found, each once: invocations that panicked, hung, promised what they didn't keep or explained it
//! wrongly.

use super::verdict::{Verdict, judge, mistakes};

fn planned(text: &str) {
    assert_eq!(judge(text).map(|(verdict, _)| verdict), Ok(Verdict::Planned), "{text}");
}

fn refused(text: &str, reason: &str) {
    assert_eq!(judge(text).map(|(verdict, _)| verdict), Ok(Verdict::Refused), "{text}");
    let messages = mistakes(text.parse().unwrap());
    assert!(messages.iter().any(|message| message.contains(reason)), "{text}: {messages:#?}");
}

#[test]
fn nesting_and_length_are_limited() {
    let nested = |depth| format!("theta0 = {}1{}", "(".repeat(depth), ")".repeat(depth));
    planned(&nested(60));
    refused(&nested(100), "nested more than 64 deep");
    refused(&nested(20_000), "nested more than 64 deep");
    planned(&format!("theta0 = {}1, tol = 1e-3", "-".repeat(400)));
    refused(&format!("theta0 = {}1", "-".repeat(3000)), "more than 500 tokens");
    refused(&format!("theta0 = {}0.1", "0.1 + ".repeat(3000)), "more than 500 tokens");
}

/// Kernels were built for any tolerance, however small, with more levels than names.
#[test]
fn tolerances_far_out_of_reach() {
    refused("theta0 = 7π/9, tol = 1e-40", "the best found is");
    refused("struct A; theta0 = 1.77, tol = 1e-36, outputs = [wrapped]", "the best found is");
    refused("velocity0 = -(2 - 1e-207), tol = 1e-39, float = f32", "the best found is");
}

/// Where all terms of a rotation's series are negligible, those of the odd multiples, which it hasn't, counted.
#[test]
fn rotations_that_hardly_know_of_the_weight() {
    for omega in ["1e-10", "1e-13", "1e-14", "1e-16", "1e-20"] {
        planned(&format!("velocity0 = 3.3754, omega = {omega}"));
    }
    planned("struct A; theta0 = 1.03, velocity0 = 1e12, outputs = [velocity, acceleration, wrapped, theta]");
}

/// A phase too coarse for pieces was taken as a proof that no finer one would do.
#[test]
fn pieces_of_a_finer_phase() {
    for tol in ["3.8186716e-14", "3e-14", "1.9e-14", "1e-14", "7e-15"] {
        planned(&format!("θ0 = 170.66deg, tol = {tol}, method = fourier"));
    }
}

/// What was named as an example, `n = 4` and `tol = 1e-3`, was refused next to the top, and `n = 4` at the smallest angles.
#[test]
fn examples_of_what_fourier_needs_can_be_had() {
    for (theta0, float, examples) in [
        ("1e-9", "f64", ["n = 1", "tol = 1e-3"].as_slice()),
        ("2.99", "f64", &["n = 4", "tol = 1e-3"]),
        ("3.14159", "f64", &["n = 80"]),
        ("π - 5e-8", "f64", &["n = 130"]),
        ("3.14", "f32", &["n = 24"]),
    ] {
        let start = format!("theta0 = {theta0}, float = {float}, method = fourier");
        for example in examples {
            refused(&start, &format!("`{example}`"));
            planned(&format!("{start}, {example}"));
        }
    }
    for (theta0, float) in [("π - 1e-9", "f64"), ("3.1415", "f32")] {
        refused(&format!("theta0 = {theta0}, float = {float}, method = fourier"), "leave `method` out");
    }
    refused("theta0 = 4, method = fourier", "needs a number of terms");
}

/// `judge` asks for the tolerance that the message offers.
#[test]
fn the_best_tolerance_can_be_had() {
    refused("velocity0 = 2*sqrt(0.555), tol = 3.6e-12, t_max = 68.3, float = f32", "the best found is");
    refused("velocity0 = 3.2732, tol = 5.6e-8, t_max = 3.2e5, float = f32", "the best found is");
    refused("theta0 = 1.5633898237141728, velocity0 = 2, tol = 1e-15", "the best found is");
    refused("θ0 = π - 1e-228, ω = 7.27389676, tol = 6.97e-9, float = f32", "the best found is");
}

/// `f32` times were multiplied with rates above 1 until they overflowed; a negative word made ∞ − ∞.
#[test]
fn the_largest_times_are_finite() {
    planned("theta0 = 1, omega = 4, t_max = 10, float = f32, tol = 1e-3");
    planned("theta0 = 7.69deg, g = 5.6358715, length = 0.474820684422141, t_max = 1e-297, float = f32");
    planned("struct A; theta0 = 0.9006, velocity0 = 2, ω = 2.253e3, t_max = 1e-161");
}

/// The squares of small errors underflowed, and the bound was 0; those of large ones overflowed.
#[test]
fn errors_of_all_sizes_have_bounds() {
    planned("struct A; θ0 = -(1e-259), omega = 8.1777e-3, t_max = 1e-115, outputs = [acceleration, position, theta]");
    planned("theta0 = 1e-300");
    planned("struct A; theta0 = π - 1e-18, omega = 1e-152, t_max = 2.1e3, outputs = [acceleration, wrapped, position]");
    planned("struct A; theta0 = 6π/14, omega = 1e80, tol = 0.3, outputs = [position, velocity, acceleration, theta]");
    refused("theta0 = 1e-301", "below 1e-300");
    refused("theta0 = 0, velocity0 = 1e-301", "`velocity0 = 1e-301` makes an amplitude below 1e-300");
    refused("theta0 = 0, velocity0 = 1e-301", "so small a motion is (velocity0/ω)·sin ωt");
    refused("theta0 = 1e-302, velocity0 = 1e-301", "θ0·cos ωt + (velocity0/ω)·sin ωt");
    refused("velocity0 = 1e-36, float = f32", "below 1e-35");
}

/// Series whose amplitudes overflow or vanish had no end.
#[test]
fn the_fastest_rotations() {
    planned("struct A; θ0 = 85.34deg, velocity0 = 1e119, tol = 1e-6, outputs = [position]");
    refused("velocity0 = -(1e211), tol = 1e-11", "so fast, beside ω");
    refused("struct A; velocity0 = 1e160, omega = 1e140, outputs = [acceleration]", "largest velocity");
}

/// ω³ overflowed in the planner, and a bound that was no number passed for one within the tolerance.
#[test]
fn accelerations_of_the_fastest_rates() {
    let jerk = "puts the steepest change of the acceleration above the largest `f64`";
    refused("struct A; velocity0 = 6e127, omega = 1e128, tol = 1e-10, outputs = [acceleration]", jerk);
    refused("struct A; theta0 = -(π - 1e-273), velocity0 = 6e102, omega = 1e103, outputs = [acceleration]", jerk);
    planned("struct A; theta0 = -(π - 1e-273), velocity0 = 6e101, omega = 1e102, outputs = [acceleration]");
    planned("struct A; theta0 = -(π - 1e-273), velocity0 = 6e-111, omega = 1e-110, outputs = [acceleration]");
    planned("struct A; velocity0 = 6e37, omega = 1e18, float = f32, outputs = [acceleration]");
}

/// Products in two words overflow before their values do: a series of NaN had no end and took all memory.
#[test]
fn series_of_almost_infinite_amplitudes_end() {
    refused(
        "theta0 = 1.36, velocity0 = -(2*sqrt(0.454)), ω = 1e153, tol = 8.73e-13, outputs = [acceleration]",
        "the steepest change",
    );
    for omega in ["1e299", "1e301", "1e303", "1e305", "1e307"] {
        let text = format!("theta0 = 1, ω = {omega}, outputs = [velocity], tol = 1e-9");
        let verdict = judge(&text);
        assert!(verdict.is_ok(), "{text}: {verdict:?}");
    }
}

/// n was searched where none works, and offered where the next message refused it.
#[test]
fn the_paper_near_the_top() {
    refused("theta0 = π - 1e-15, n = 3", "no number of terms that `f64` can use works");
    refused("θ0 = -(π - 1e-146), n = 3, float = f32", "no number of terms that `f32` can use works");
    refused("theta0 = π - 1e-298, tol = 1e-12, method = fourier", "leave `method` out");
    refused("θ0 = π - 1e-284, tol = 2.4e-4, method = series", "leave `method` out");
    refused("struct A; θ0 = π - 1e-188, tol = 4e-6, method = small_angle, outputs = [velocity]", "the best found is");
}

/// Of a passage over a short horizon what lies beyond it was rounded by more than was promised, and the amplitude
/// exceeded.
#[test]
fn swings_beyond_short_horizons() {
    planned("velocity0 = 2*sqrt(0.731), tol = 9.36882e-8, t_max = 1e-299, float = f32");
    planned("struct A; velocity0 = 2*sqrt(0.731), tol = 9.36882e-8, t_max = 1e-3, float = f32");
    planned("struct A; velocity0 = 2*sqrt(0.999), tol = 5e-7, t_max = 0.5, float = f32, outputs = [theta, velocity]");
}

/// A refusal offers what can be had: these offered tolerances that were refused in turn, or spoke of a precision that
/// nobody had asked for. `judge` takes them at their word.
#[test]
fn refusals_offer_what_can_be_had() {
    refused("velocity0 = 3, tol = 1e-3", "give a `t_max`, since");
    planned("velocity0 = 3, tol = 1e-3, t_max = 1e6");
    planned("velocity0 = 3, tol = 1e-3, outputs = [wrapped]");
    refused(
        "theta0 = 1, method = harmonic, tol = 1e-4",
        "finer than `method = harmonic` can promise here: the best found is",
    );
}

/// Near the arcsine's edge no finite bound was found for the derivative of θ̂: `MAX_VELOCITY_ERROR` was infinite, or
/// the call was refused.
#[test]
fn the_velocity_of_the_paper_near_the_top() {
    planned("struct A; θ0 = π - 5.52933e-2, n = 9, outputs = [theta, velocity]");
    planned("struct A; theta0 = π - 8.4e-4, n = 66, outputs = [velocity, theta]");
    // One term's argument is 1 − 10⁻¹³ at the turning point, 1 − 10⁻¹⁵, of which the rounding leaves nothing, 1 − 10⁻⁷.
    planned("struct A; theta0 = 0.730828103425899196π, n = 1, outputs = [theta, velocity]");
    let edge = "struct A; theta0 = 0.7308281034259988096π";
    refused(&format!("{edge}, n = 1, outputs = [theta, velocity]"), "ask for `theta` alone");
    planned(&format!("{edge}, n = 1, outputs = [theta]"));
    planned(&format!("{edge}, n = 2, outputs = [theta, velocity]"));
    // The fewest terms without overshoot were offered where no bound of the velocity's error is found for them.
    let near = "struct A; theta0 = π - 1e-7, n = 1";
    refused(&format!("{near}, outputs = [theta, velocity]"), "no number of terms was found that works for `velocity`");
    for (outputs, smallest) in [("theta", 91), ("theta, velocity", 92)] {
        let with = |n: usize| format!("struct A; theta0 = π - 0.0000010061, n = {n}, outputs = [{outputs}]");
        refused(&with(1), &format!("the smallest number of terms that works is `n = {smallest}`"));
        planned(&with(smallest));
    }
    refused("struct A; theta0 = 0.7308280027970127π, n = 1, outputs = [velocity], float = f32", "choose `n = ");
}

/// 2⁻²⁰ of the largest value was out of reach of `f32` next to the separatrix.
#[test]
fn full_precision_of_f32_near_the_top() {
    planned("theta0 = π - 1e-142, ω = 521.656512706, float = f32");
    planned("velocity0 = 2 + 1e-212, float = f32");
    planned("struct A; velocity0 = 2 + 1e-78, float = f32, outputs = [acceleration, theta, velocity]");
}

/// The coefficients of a polynomial in the time itself, squared, underflow or overflow: the planner saw its bound
/// broken and refused where another reduction serves, or, with a forced method, emitted an infinite coefficient.
#[test]
fn coefficients_beyond_the_range_of_floats() {
    planned("struct A; theta0 = -(1e-268), ω = 3.3137e-3, t_max = 5.44920e5");
    planned("theta0 = 1e-257, ω = 1.697545016e-3, t_max = 8.0185027920e5, outputs = [velocity]");
    planned("theta0 = 1e-59, omega = 1e87, method = harmonic, t_max = 1e-84");
}

/// Terms of a second derivative that underflow before those of the angle do: as many as of the angle were taken for granted.
/// And full precision was advised where it can't be had.
#[test]
fn derivatives_that_underflow() {
    let series = |start: &str| format!("struct A; {start}, method = series, outputs = [acceleration]");
    refused(
        "struct A; velocity0 = 5e-153, omega = 1e-153, outputs = [acceleration], tol = 1e-13",
        "choose a unit of time in which ω, here 1e-153, is nearer to 1",
    );
    refused(&series("theta0 = 7π/8, omega = 1e-153"), "state `tol = ");
    refused(&series("theta0 = 1e-3, omega = 1e-152"), "state `tol = ");
}

/// Next to the top Eq. 22 works from more terms on than were chosen, and no tolerance was promised; of `n` another was advised
/// where none serves; and where nothing was reached of a forced method, no tolerance was named.
#[test]
fn forced_methods_next_to_the_top() {
    planned("theta0 = 3.1415926, method = fourier, tol = 1e-3");
    planned("theta0 = π - 1e-8, method = fourier, tol = 1e-6");
    refused("struct A; theta0 = 3.1415921, n = 100, outputs = [velocity]", "near 1: ask for `theta` alone");
    refused("theta0 = π - 1e-40, method = series, tol = 1e-12", "the best found is ");
    refused("theta0 = π - 1e-80, method = polynomial", "the best found is ");
}

/// A bound that underflows in units of ω was stated as 0.
#[test]
fn bounds_that_underflow() {
    planned("struct A; theta0 = -(1e-300), omega = 1e53, t_max = 1e-63, outputs = [velocity]");
}

/// Sums whose amplitudes overflow, or the steps of whose recurrence do, were planned: as nothing, and as NaN. The passage
/// through the lowest point serves, though there is no sum to compare it with.
#[test]
fn sums_that_overflow() {
    planned("struct A; theta0 = π - 1e-33, omega = 8.9e298, outputs = [velocity]");
    refused(
        "struct A; theta0 = 0.1, omega = 1.697e308, tol = 1e-12, t_max = 1.956e11 / 1.697e308, method = series, outputs = [velocity]",
        "choose a unit of time in which ω, here 1.697e308, is nearer to 1",
    );
    let single = "float = f32, outputs = [acceleration]";
    let rate = "velocity0 = (2 - 1e-11) * 6.924e18, omega = 6.924e18, t_max = 1.46e7 / 6.924e18";
    refused(&format!("struct A; {rate}, tol = 1e-2, method = series, {single}"), "leave `method` out");
}

/// Each of the tolerances that a refusal might offer was tried with a hundred harmonics and more: 1.2 s, optimised.
#[test]
fn refusals_of_forced_methods_near_the_top_take_less_than_a_second() {
    let far = |tol: &str| format!("theta0 = -(π - 1e-5), tol = {tol}, method = fourier, t_max = 8.42609616222453e6");
    planned(&far("7.106886299e-10"));
    refused(&far("7.1e-16"), "leave `method` and `tol` out");
    let both = |tol: &str| {
        format!("struct A; theta0 = 179.9999deg, tol = {tol}, method = fourier, outputs = [theta, velocity]")
    };
    planned(&both("1e-3"));
    refused(&both("1e-12"), "leave `method` out");
    // What the terms left out come to was taken for what is reached, and nothing was found that is twice as much.
    let near = |tol: &str| format!("struct A; theta0 = π - 1e-5, tol = {tol}, t_max = 66, method = fourier");
    refused(&format!("{}, outputs = [theta, velocity]", near("1e-11")), "the best found is 1.7");
    // Nor where more terms than are chosen would be needed.
    refused(&near("1e-16"), "e-15; ask for that");
    // With as many terms as it takes its velocities overflow; that with fewer they are too far off had ten more asked.
    refused(
        "struct A; theta0 = π - 1e-6, omega = 6.6e300, tol = 1e-6, outputs = [theta, velocity], method = fourier",
        "choose a unit of time in which ω, here 6.6e300, is nearer to 1",
    );
    refused("velocity0 = 2 - 1e-254, tol = 9.6e-4, method = series, t_max = 5.27, float = f32", "leave `method` out");
}

/// Each limit of an expression was harmless by itself: 240 literals of 490 digits took eleven seconds together.
#[test]
fn limits_of_length_do_not_multiply() {
    let digits = "1234567890".repeat(49);
    let sum = |term: &str, count: usize| vec![term; count].join(" + ");
    planned(&format!("theta0 = {}", sum(&format!("0.01{digits}deg"), 240)));
    let root = sum(&format!("sqrt(0.0001{digits})"), 120);
    planned(&format!("theta0 = {root}, velocity0 = {root}, omega = {root}, tol = {root}, t_max = {root}"));
    let tiny = sum(&format!("0.0001{digits}e-390"), 240);
    refused(&format!("theta0 = π - 1e-100, g = {tiny}, length = {tiny}, t_max = 1/({tiny})"), "2⁵³ periods");
}

/// Beyond a horizon of no more than a moment θ̂ goes on past the amplitude by its error over all phases, which has to be
/// part of what is stated.
#[test]
fn sums_beyond_a_moment() {
    planned("velocity0 = -(1.2695), n = 3, t_max = 1e-191");
    planned("theta0 = 1, method = harmonic, tol = 0.1, t_max = 1e-3");
    planned("theta0 = 1, method = series, tol = 1e-3, t_max = 1e-3");
}

/// The largest velocity, which a horizon next to the top is far from, is rounded up.
#[test]
fn velocities_beyond_a_horizon() {
    planned("struct A; theta0 = π - 1e-64, omega = 2.4e35, float = f32, outputs = [velocity], t_max = 5.96 / 2.4e35");
}

/// A row is counted from the anchor numbered 0, which may not be the first.
#[test]
fn rows_counted_from_other_anchors() {
    planned("struct A; θ0 = 4π/15, velocity0 = 3.7797, t_max = 6.87418743809171e5, outputs = [acceleration]");
}

/// Half as many pieces as serve a finer tolerance took too many points for a coarser one, which was refused.
#[test]
fn what_a_finer_promise_keeps_is_not_refused() {
    for tol in ["1e-11", "7.1e-9", "1e-7", "1e-3"] {
        planned(&format!("velocity0 = -(2 - 1e-60), tol = {tol}, method = polynomial"));
    }
}

/// Beyond a moment the acceleration of an approximation was compared with the largest of the exact motion.
#[test]
fn accelerations_of_approximations_beyond_their_horizon() {
    planned("struct A; velocity0 = 0.7279, n = 1, t_max = 1e-219, outputs = [acceleration, theta]");
    planned(
        "struct A; theta0 = 24.95deg, velocity0 = 1.0428, omega = 2.5248, method = small_angle, t_max = 1e-22, \
         outputs = [theta, acceleration]",
    );
}

/// A moment at the top in which the angle goes less far beyond π than `f64` tells it from π: it was kept below π, and
/// what that takes was counted up to π.
#[test]
fn moments_just_over_the_top() {
    for far in ["1e-21", "1e-20", "1e-19", "1e-17", "1.5e-16"] {
        for motion in
            ["theta0 = π, velocity0 = 2", "theta0 = π - 1e-234, velocity0 = -0.1", "theta0 = 1e-19 - π, velocity0 = 20"]
        {
            planned(&format!("struct A; {motion}, tol = 1e-3, t_max = {far}, outputs = [theta, wrapped]"));
        }
    }
}

/// Advice that didn't help: the rounding of a rotation's turns, or of the float, is the same without a method, and `tol`
/// in place of `n` was out of reach of the method.
#[test]
fn remedies_that_help() {
    let turns = "struct A; theta0 = 0.906, velocity0 = 2.13934, tol = 0.0002, float = f32, method = polynomial";
    refused(&format!("{turns}, t_max = 713893.2252"), "use `float = f64`");
    planned(&format!("{}, t_max = 713893.2252", turns.replace("float = f32", "float = f64")));
    refused(turns, "give a `t_max`");
    let fourier = "struct A; float = f32, n = 9, theta0 = -(180*PI/180 - 6e-7)";
    refused(&format!("{fourier}, method = fourier"), "state the error as `tol` instead, and leave `method` out");
    planned(&fourier.replace("n = 9", "tol = 1e-3"));
    let close = "struct A; velocity0 = 2 + 1e-242, tol = 9.6671062657e-6, method = polynomial";
    refused(close, "leave `method` out, and give a short `t_max`");
    planned(&close.replace("method = polynomial", "t_max = 100"));
    let many = "struct A; θ0 = π - 1e-267, velocity0 = 0.7008, omega = 7.592148012041e3, tol = 6.871942498e-8, \
                method = polynomial, outputs = [velocity, acceleration, theta, position, wrapped]";
    refused(many, "or give a `t_max`, since the error of an angle grows with its turns");
    planned(&many.replace("method = polynomial", "method = polynomial, t_max = 100"));
    let fine = "struct A; theta0 = -(π), velocity0 = 4.2076145251552e-6, tol = 1e-18, method = polynomial, \
                outputs = [velocity, theta, wrapped, position, acceleration]";
    refused(fine, "leave `method` and `tol` out for full precision");
    planned(&fine.replace("tol = 1e-18, method = polynomial, ", ""));
    refused("velocity0 = 2 + 1e-194, tol = 1e-25, method = polynomial", "leave `method` and `tol` out");
    // ω² is beyond every float, with a method as without.
    let far = "struct A; theta0 = π - 1e-7, omega = 1e307, outputs = [velocity], tol = 1e-2, t_max = 5.5e-302";
    refused(&format!("{far}, method = series"), "choose a unit of time in which ω, here 1e307, is nearer to 1");
    let single = "struct A; theta0 = 1, tol = 1e-12, float = f32, method = ";
    refused(&format!("{single}polynomial"), "use `float = f64`");
    refused(&format!("{single}harmonic"), "leave `method` out, and use `float = f64`");
    // Of terms too many for the float, with the method that none serve.
    refused("theta0 = π - 1e-9, method = fourier, n = 200", "state the error as `tol` instead, and leave `method` out");
    // A velocity may take more terms than θ̂ does, and have no bound with any.
    let velocity = "struct A; theta0 = 0.9995π, method = fourier, float = f32, outputs = [velocity]";
    refused(velocity, "a number of terms, `n`, here at least 24, or an error, `tol`; or leave `method` out");
    planned(&velocity.replace("method = fourier, ", ""));
    // The longest horizon as it is printed is one.
    refused("theta0 = 1, t_max = 6.034801581090033e16", "2⁵³ periods (6.034801581090032e16)");
    planned("struct A; theta0 = 1, t_max = 6.034801581090032e16");
}
