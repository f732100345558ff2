//! A game's scene: ten thousand lanterns on chains, in `f32`, evaluated at any frame without a state to carry along.
//!
//! `cargo run --release --example lanterns`

use pendula::pendulum;
use std::hint::black_box;
use std::time::Instant;

pendulum! {
    /// A lantern on a chain of 1.5 m, pushed to 50°: good to a tenth of a milliradian for the time that is passed.
    struct Lantern;
    theta0 = 50deg, g = 9.81, length = 1.5, float = f32, tol = 1e-4, t_max = 3600
}

/// One swing in 64 steps, computed by the compiler, for what can't afford even the polynomial.
const SWING: [f32; 64] = {
    let mut swing = [0.0; 64];
    let mut step = 0;
    while step < swing.len() {
        swing[step] = Lantern::theta(step as f32 / 64.0 * Lantern::PERIOD);
        step += 1;
    }
    swing
};

fn main() {
    // Each lantern swings with a phase of its own: a time offset is all it needs to remember.
    let released: Vec<f32> = (0..10_000_u16).map(|i| f32::from(i % 977) * 0.01).collect();
    let mut angles = vec![0.0_f32; released.len()];
    let (frames, start) = (600_u16, Instant::now());
    for frame in 0..frames {
        let now = f32::from(frame) / 60.0;
        for (angle, since) in angles.iter_mut().zip(&released) {
            *angle = Lantern::theta(now - since);
        }
        black_box(&angles);
    }
    let each = start.elapsed().as_secs_f64() / f64::from(frames) / angles.len() as f64;
    let (lanterns, most) = (angles.len(), Lantern::MAX_ERROR);
    println!("{lanterns} lanterns, {frames} frames: {:.2} ns per angle, error ≤ {most:.1e} rad", 1e9 * each);
    // Any frame can be asked directly, forwards or backwards, and every machine gets these bits: replays and lockstep
    // need not send angles.
    let bits = angles.iter().fold(0_u32, |hash, angle| hash.rotate_left(5) ^ angle.to_bits());
    println!("the last frame's fingerprint: {bits:08x}");
    println!("the table's first quarter: {:.3?}", &SWING[..=16]);
}
