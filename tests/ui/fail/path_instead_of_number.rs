use pendula::pendulum;

const ANGLE: f64 = 1.0;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = crate::ANGLE);
    let _ = ANGLE;
}
