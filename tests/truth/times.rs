//! Times at which to look: everywhere in the phase, at the ends of the horizon, and where something switches.

use pendula_stress::random::Random;

use super::Swing;

/// About 3·`density` times within ±`horizon`.
pub fn within(swing: &Swing, horizon: f64, density: u32) -> Vec<f64> {
    let period = swing.period();
    let mut random = Random::new(u64::from(density));
    let mut times = vec![0.0, -0.0, f64::MIN_POSITIVE, 5e-324, -1e-20];
    for i in 0..density {
        // A grid of phases in the first periods, where little else than truncation is seen; the whole horizon evenly
        // and by magnitude; its end, where the phase has drifted most.
        times.push(swing.time_of(f64::from(i) / f64::from(density) * 2.0 - 1.0));
        times.push(
            horizon * if i % 2 == 0 { random.signed() } else { random.signed().signum() * random.unit().powi(16) },
        );
        times.push((horizon - period * random.unit()) * random.signed().signum());
    }
    // Turning points, zero crossings and the eighths between, with their neighbours.
    for eighth in -16..=16 {
        let t = swing.time_of(f64::from(eighth) / 8.0);
        times.extend([t, t.next_up(), t.next_down(), t * (1.0 + 1e-9), t * (1.0 - 1e-9)]);
    }
    times.extend([horizon, -horizon, horizon.next_down()]);
    times.retain(|t| t.abs() <= horizon);
    times
}
