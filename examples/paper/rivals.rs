//! What the paper argues against, at late times: a truncated Taylor polynomial and a solver with a fixed step.

use pendula::{Error, Pendulum};

/// 157.6°, close to 7π/8, and a binary fraction: the macro, the run-time motion and the rivals mean the same number.
const THETA0: f64 = 2.75;

pendula::pendulum! { struct Paper; theta0 = 2.75, n = 4 }
pendula::pendulum! { struct Planned; theta0 = 2.75 }

/// Elapsed times at which errors are shown, in periods.
const ELAPSED: [u32; 3] = [10, 1_000, 100_000];

/// The error of `theta` in the last period before each of the elapsed times.
fn errors(exact: &Pendulum<f64>, theta: impl Fn(f64) -> f64) -> [f64; 3] {
    let points = 1000;
    ELAPSED.map(|elapsed| {
        let times = (0..=points).map(|i| (f64::from(elapsed) - f64::from(i) / f64::from(points)) * Paper::PERIOD);
        times.map(|t| (theta(t) - exact.theta(t)).abs()).fold(0.0, f64::max)
    })
}

pub(crate) fn print() -> Result<(), Error> {
    let exact = Pendulum::new(THETA0, 1.0)?;
    let exact = &exact;
    println!("Largest error in rad over the last of so many periods, θ0 = {THETA0} rad:\n");
    print!("  {:<34}", "");
    for elapsed in ELAPSED {
        print!("{elapsed:>12} T");
    }
    println!();
    let coefficients = taylor(20);
    // The finest stepping takes seconds: the two run beside each other.
    let [coarse, fine] = std::thread::scope(|scope| {
        [100, 1000]
            .map(|steps| scope.spawn(move || stepping(exact, steps)))
            .map(|run| run.join().unwrap_or([f64::NAN; 3]))
    });
    for (name, errors) in [
        ("Taylor polynomial of degree 20", errors(exact, |t| horner(&coefficients, t))),
        ("RK4, 100 steps per period", coarse),
        ("RK4, 1000 steps per period", fine),
        ("Eq. 22 with N = 4, generated", errors(exact, Paper::theta)),
        ("full precision, generated", errors(exact, Planned::theta)),
    ] {
        print!("  {name:<34}");
        for error in errors {
            print!("{error:>14.1e}");
        }
        println!();
    }
    println!(
        "\n  The Taylor series about the release converges for ωt < √(K² + K′²), here {:.2} T, whatever the degree:",
        { Paper::K.hypot(Paper::K_PRIME) / Paper::PERIOD }
    );
    println!("  the complex singularity nearest to the release is there.\n");
    Ok(())
}

/// Coefficients of θ(t) about the release, from θ̈ = −sin θ term by term: with s = sin θ and c = cos θ,
/// n sₙ = Σ j θⱼ cₙ₋ⱼ and n cₙ = −Σ j θⱼ sₙ₋ⱼ over j from 1 to n.
fn taylor(degree: usize) -> Vec<f64> {
    let mut theta = vec![THETA0, 0.0];
    let (mut sine, mut cosine) = (vec![THETA0.sin()], vec![THETA0.cos()]);
    for n in 0..degree.saturating_sub(1) {
        theta.push(-sine[n] / ((n + 1) * (n + 2)) as f64);
        let next = n + 1;
        let fold = |other: &[f64]| (1..=next).map(|j| j as f64 * theta[j] * other[next - j]).sum::<f64>() / next as f64;
        let (s, c) = (fold(&cosine), -fold(&sine));
        sine.push(s);
        cosine.push(c);
    }
    theta
}

fn horner(coefficients: &[f64], t: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * t + coefficient)
}

/// The classical Runge-Kutta method of fourth order, from the release on.
fn stepping(exact: &Pendulum<f64>, steps: u32) -> [f64; 3] {
    let step = Paper::PERIOD / f64::from(steps);
    let (mut state, mut done) = ((THETA0, 0.0), 0);
    ELAPSED.map(|elapsed| {
        let mut largest = 0.0_f64;
        while done < elapsed * steps {
            state = rk4(state, step);
            done += 1;
            if done > (elapsed - 1) * steps {
                largest = largest.max((state.0 - exact.theta(f64::from(done) * step)).abs());
            }
        }
        largest
    })
}

fn rk4((theta, velocity): (f64, f64), h: f64) -> (f64, f64) {
    let rate = |by: f64, (angle, speed): (f64, f64)| (velocity + by * speed, -(theta + by * angle).sin());
    let first = (velocity, -theta.sin());
    let second = rate(h / 2.0, first);
    let third = rate(h / 2.0, second);
    let fourth = rate(h, third);
    (
        theta + h / 6.0 * (first.0 + 2.0 * (second.0 + third.0) + fourth.0),
        velocity + h / 6.0 * (first.1 + 2.0 * (second.1 + third.1) + fourth.1),
    )
}
