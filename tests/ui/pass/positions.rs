//! Places where an expression may stand: constants, statics, arrays of functions, arguments, closures, blocks.

#![deny(warnings)]

use pendula::pendulum;

const RIGHT: fn(f64) -> f64 = pendulum!(theta0 = 1π/2, tol = 1e-6);
static RACK: [fn(f32) -> f32; 3] = [
    pendulum!(theta0 = 0.1, float = f32, tol = 1e-4),
    pendulum!(theta0 = 0.2, float = f32, tol = 1e-4),
    pendulum!(theta0 = 0.3, float = f32, method = harmonic, tol = 1e-2),
];
const START: f64 = pendulum!(theta0 = 2, tol = 1e-3)(0.0);
const CORNER: (f64, f64) = pendulum!(theta0 = 1π/2, tol = 1e-9, outputs = [position])(0.0);

fn apply(f: impl Fn(f64) -> f64 + Copy + Send + Sync + 'static, t: f64) -> f64 {
    f(t)
}

fn main() {
    assert!((RIGHT(0.0) - 1.5707963).abs() < 2e-6);
    for (i, theta) in RACK.iter().enumerate() {
        assert!((theta(0.0) - 0.1 * (i + 1) as f32).abs() < 0.02);
    }
    assert!((START - 2.0).abs() <= 1e-3);
    assert!((CORNER.0 - 1.0).abs() + CORNER.1.abs() < 1e-8);
    assert!(apply(pendulum!(theta0 = 1, n = 2), 0.0) > 0.9);
    let nested = |t| pendulum!(theta0 = 1, tol = 1e-3, outputs = [velocity])(t) + pendulum!(theta0 = 1, n = 3)(t);
    assert!(nested(0.0_f64) > 0.9);
}
