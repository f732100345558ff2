//! A crane's controller without the standard library: let a hanging load swing along its own exact motion, and act only
//! on what differs from it.
//!
//! `cargo run --release --example controller`

#![no_std]

extern crate std; // for the demonstration in `main` only

use pendula::pendulum;

pendulum! {
    /// The load on 4 m of rope, released at 20°: what a controller without libm can afford 1000 times a second.
    struct Load;
    theta0 = 20deg, g = 9.81, length = 4, float = f32, tol = 1e-4, t_max = 600, outputs = [theta, velocity]
}

/// Gains on the angle and on its rate, 1/s² and 1/s.
const GAINS: (f32, f32) = (1.5, 2.0);

/// The angular acceleration to ask of the trolley: nothing, as long as the load swings as it should.
fn correction(t: f32, (measured_angle, measured_rate): (f32, f32)) -> f32 {
    let (angle, rate) = Load::state(t);
    GAINS.0 * (angle - measured_angle) + GAINS.1 * (rate - measured_rate)
}

fn main() {
    // A stand-in for the plant: the load, struck at t = 2 s, stepped at 1 kHz; sin θ is its own, not the controller's.
    let (mut angle, mut rate) = Load::state(0.0);
    let step = 1e-3_f32;
    for tick in 0..12_000_u16 {
        let t = f32::from(tick) * step;
        if tick == 2000 {
            rate += 0.3;
        }
        if tick % 2000 == 0 {
            let (wanted, _) = Load::state(t);
            std::println!("t = {t:>4.1} s  θ = {angle:+.4}  wanted {wanted:+.4}  off by {:+.4}", angle - wanted);
        }
        let acceleration = -Load::OMEGA * Load::OMEGA * angle.sin() + correction(t, (angle, rate));
        rate += step * acceleration;
        angle += step * rate;
    }
    std::println!("{} operations per angle, error ≤ {:.1e} rad", Load::OPERATIONS, Load::MAX_ERROR);
}
