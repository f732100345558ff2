//! A pendulum clock simulated over a day: where its bob is at any moment, without stepping there.
//!
//! `cargo run --release --example clock`

use pendula::pendulum;

pendulum! {
    /// 99.4 cm long, started at 6°: metres, seconds, and an angle good to a nanoradian for a day.
    struct Clock;
    theta0 = 6deg, g = 9.81, length = 0.994, tol = 1e-9, t_max = 86_400, outputs = [theta, velocity, position]
}

/// Metres.
const LENGTH: f64 = 0.994;

fn main() {
    println!("{} terms, {} operations, error ≤ {:.1e} rad", Clock::TERMS, Clock::OPERATIONS, Clock::MAX_ERROR);
    println!("one swing to and fro: {:.9} s\n", Clock::PERIOD);
    for (what, t) in [("started", 0.0), ("after a minute", 60.0), ("after an hour", 3600.0), ("after a day", 86_400.0)]
    {
        let (theta, velocity) = Clock::state(t);
        let velocity = velocity + 0.0; // −0 becomes 0
        let (x, y) = Clock::position(t);
        println!(
            "{what:<15} θ = {:+.6}°  θ̇ = {velocity:+.6} rad/s  bob at ({:+.6} m, {:+.6} m)",
            theta.to_degrees(),
            LENGTH * x,
            LENGTH * y
        );
    }
    // Isochrony is what a clockmaker wants and a circular pendulum doesn't have.
    let isochronous = std::f64::consts::TAU / Clock::OMEGA;
    let lost = 86_400.0 * (1.0 - isochronous / Clock::PERIOD);
    println!("\nits swings take longer than those of vanishing amplitude: {lost:.1} s lost a day");
}
