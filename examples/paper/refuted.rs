//! Three general statements of the paper that do not hold, each with the number that refutes it.

use crate::approximation::{approximation, in_pi};
use pendula::{Error, Pendulum};
use std::f64::consts::PI;

pub(crate) fn print() -> Result<(), Error> {
    println!("Three statements that do not hold:\n");
    largest_error_at_release()?;
    any_number_of_terms()?;
    small_angle()
}

/// The argument of the arcsine comes close to 1 away from the turning points, where its slope is large.
fn largest_error_at_release() -> Result<(), Error> {
    let motion = approximation!((0.89π), n = 2);
    let at_release = ((motion.theta)(0.0) - motion.theta0).abs() / motion.theta0;
    let largest = motion.supremum(1)?;
    println!("  1. “The maximum error is always at t = 0.” With N = 2 at θ0 = {}:", motion.label());
    println!(
        "     at t = 0 {:.3} %, but {:.2} % at t = {:.4} T. `MAX_ERROR` bounds the supremum, not the error at t = 0.\n",
        100.0 * at_release,
        100.0 * largest.relative,
        largest.at,
    );
    Ok(())
}

/// For every N there is an amplitude from which k snᴺ exceeds 1, so that the arcsine is NaN near a turning point.
fn any_number_of_terms() -> Result<(), Error> {
    println!("  2. “For any N ≥ 1 and 0 < θ0 < π.” The argument of the arcsine exceeds 1, and θ̂ is NaN, from");
    print!("    ");
    for (terms, limit) in [limit::<1>()?, limit::<2>()?, limit::<3>()?, limit::<4>()?].iter().enumerate() {
        print!(" {:.4}π (N = {}),", in_pi(*limit), terms + 1);
    }
    println!(" … on.");
    let refusal = Pendulum::new(0.75 * PI, 1.0)?.fourier::<1>();
    if let Err(refusal) = refusal {
        println!("     At 0.75π: {refusal}.");
    }
    println!("     `pendulum!(theta0 = 0.75π, n = 1)` says the same as a compile error.\n");
    Ok(())
}

/// The amplitude from which N terms overshoot, by bisection.
fn limit<const N: usize>() -> Result<f64, Error> {
    let (mut works, mut fails) = (0.5 * PI, 0.9999 * PI);
    while fails - works > 1e-9 {
        let middle = f64::midpoint(works, fails);
        match Pendulum::new(middle, 1.0)?.fourier::<N>() {
            Ok(_) => works = middle,
            Err(Error::Overshoot { .. }) => fails = middle,
            Err(other) => return Err(other),
        }
    }
    Ok(fails)
}

/// The period is off by θ0²/16; the angle by that, times the phase that has passed.
fn small_angle() -> Result<(), Error> {
    // The horizon: a little more than the ten periods below.
    let motion = approximation!((10deg), method = small_angle, t_max = 64);
    let period = motion.period / (2.0 * PI) - 1.0;
    println!(
        "  3. “Small angle, better than 0.5 % below 10°.” True of the period ({:.3} %), not of θ(t):",
        100.0 * period
    );
    println!(
        "     at 10° off by {:.3} % of θ0 within one period, by {:.1} % within ten.\n",
        100.0 * motion.supremum(1)?.relative,
        100.0 * motion.supremum(10)?.relative,
    );
    Ok(())
}
