//! Bounds of chosen scenes, close to the largest errors that are found.

use super::random::tightness;
use crate::testing::Random;

/// Scenes of every kernel, from either origin, in either type, and how many times the error their bounds may be.
const TIGHT: &[(&str, f64)] = &[
    ("theta0 = 7π/8, tol = 1e-9, t_max = 1e4", 1.2),
    ("theta0 = 7π/8, tol = 1e-12, t_max = 1e4", 1.5),
    ("theta0 = 7π/8, tol = 1e-9", 1.2),
    ("theta0 = 7π/8, tol = 1e-9, t_max = 1e4, outputs = [velocity]", 1.3),
    ("theta0 = 7π/8, tol = 1e-9, t_max = 1e4, outputs = [acceleration]", 1.3),
    ("theta0 = 7π/8, tol = 1e-9, t_max = 1e4, outputs = [position]", 1.5),
    ("theta0 = 7π/8, tol = 1e-4, t_max = 1e3, float = f32", 2.0),
    ("theta0 = 7π/8, tol = 1e-4, float = f32, outputs = [velocity]", 3.0),
    ("theta0 = π - 1e-9, tol = 1e-6, t_max = 1e4", 2.0),
    ("theta0 = π - 1e-9, tol = 1e-6, t_max = 1e4, outputs = [velocity]", 2.0),
    ("velocity0 = 2, tol = 1e-6, outputs = [position]", 2.0),
    ("velocity0 = 2, tol = 2e-8, t_max = 1, outputs = [acceleration]", 3.0),
    ("velocity0 = 2 + 1e-11, tol = 1.5e-10, t_max = 1e5, outputs = [velocity]", 3.0),
    // Steep pieces, far binades and what is less than the rounding of 1 aren't met by all scenes.
    ("theta0 = π - 1e-9, tol = 1e-9, t_max = 20", 2.0),
    ("theta0 = π - 1e-9, tol = 1e-4, t_max = 20, outputs = [velocity]", 2.0),
    ("theta0 = π - 1e-9, tol = 1e-6, t_max = 15, outputs = [position]", 3.0),
    ("theta0 = π - 1e-7, velocity0 = 1e-7, tol = 1e-1, t_max = 15, outputs = [wrapped]", 2.0),
    ("theta0 = 3.141592653589, omega = 3, tol = 5.37e-6, t_max = 1.1e-7, outputs = [wrapped]", 1.5),
    ("theta0 = π - π*5e-8, omega = 3, tol = 1e-3, t_max = 2.2345e-5, float = f32, outputs = [wrapped]", 1.5),
    ("velocity0 = 2, tol = 1e-2, t_max = 0.01, outputs = [position]", 1.3),
    ("velocity0 = 2, tol = 1e-9, t_max = 0.1, outputs = [acceleration]", 1.2),
    ("velocity0 = -2, tol = 1e-4, t_max = 0.01, outputs = [acceleration]", 1.2),
    ("velocity0 = 2, tol = 1e-4, t_max = 0.01", 1.2),
    ("theta0 = -π/2, velocity0 = sqrt(2), tol = 1e-8, t_max = 0.5, outputs = [velocity]", 1.2),
    ("theta0 = π/2, velocity0 = -sqrt(2), tol = 1e-12, t_max = 0.5, outputs = [wrapped]", 1.5),
    ("velocity0 = 2, tol = 1e-4, t_max = 1", 1.2),
    ("theta0 = 1e-9, tol = 1e-3, t_max = 1, float = f32, outputs = [position]", 1.2),
    ("theta0 = π - 1e-6, tol = 1e-2, t_max = 0.01, float = f32, outputs = [acceleration]", 1.2),
    ("velocity0 = 3, tol = 1e-9, t_max = 1e4", 1.3),
    ("velocity0 = 3, tol = 1e-9, t_max = 1e4, outputs = [wrapped]", 1.3),
    ("velocity0 = 3, tol = 1e-9, t_max = 1e4, outputs = [velocity]", 1.2),
    ("theta0 = 7π/8, tol = 1e-6, t_max = 2", 1.2),
    ("theta0 = 7π/8, tol = 1e-11, t_max = 6, outputs = [velocity]", 1.2),
    ("theta0 = -7π/8, tol = 1e-6, t_max = 0.1, outputs = [acceleration]", 1.2),
    ("theta0 = -7π/8, tol = 1e-3, t_max = 0.1, outputs = [position]", 1.2),
    ("velocity0 = 1.9, tol = 1e-9, t_max = 1", 1.2),
    ("velocity0 = -1.9, tol = 1e-9, t_max = 1, outputs = [velocity]", 1.2),
    ("velocity0 = -1.9, tol = 1e-4, t_max = 1, float = f32, outputs = [acceleration]", 1.3),
    ("velocity0 = -1.9, tol = 1e-9, t_max = 1, outputs = [position]", 1.2),
    ("theta0 = 1, velocity0 = -0.8, tol = 1e-7, t_max = 0.9, outputs = [position]", 1.4),
    ("theta0 = 3, velocity0 = -2.5, tol = 1e-7, t_max = 0.3", 1.2),
    ("velocity0 = 3, tol = 1e-7, t_max = 0.3, outputs = [wrapped]", 1.2),
    // Turns, a binade below a power of two and exact products aren't met by all scenes either.
    ("velocity0 = 5.096e4, tol = 4.02e-2, t_max = 9.962e-2, float = f32, outputs = [wrapped]", 3.0),
    ("velocity0 = 2.002608, tol = 2.84e-4, t_max = 4.383e-3, float = f32, outputs = [position]", 3.0),
    ("velocity0 = -2, tol = 1.31e-5, float = f32, outputs = [position]", 3.0),
    ("velocity0 = 2, tol = 1.7e-3, t_max = 178.6, float = f32, outputs = [velocity]", 3.0),
    ("theta0 = 2, omega = 1e9, tol = 1e-9, t_max = 1e-9", 1.2),
    ("theta0 = 2, velocity0 = 1e-20, omega = 1e-20, tol = 1e-9, t_max = 6e19, outputs = [velocity]", 1.2),
    ("velocity0 = -1e9, omega = 1e9, tol = 1e-3, t_max = 1e-9, float = f32, outputs = [acceleration]", 1.2),
    ("theta0 = 2, tol = 1e-6, t_max = 1e4, method = series", 1.2),
    ("theta0 = 2, tol = 1e-6, t_max = 1e4, method = fourier", 1.5),
    ("theta0 = 0.1, tol = 1e-3, t_max = 1e4, method = harmonic", 1.2),
    ("theta0 = 0.1, tol = 1e-3, t_max = 10, method = small_angle", 1.6),
    ("theta0 = 2, tol = 1e-5, t_max = 1e4, method = series, outputs = [velocity]", 1.2),
    // Remainders beyond half an anchor are few of the many that long horizons of few digits allow for.
    ("theta0 = 3.1208, tol = 1e-2, t_max = 3e5, float = f32", 3.0),
    ("theta0 = π - 2.079e-2, omega = 1e-2, tol = 1.518e-2, t_max = 3.8854e7, float = f32", 3.0),
    ("theta0 = π - 2.227e-3, tol = 2.661e-4, t_max = 1.162e5, float = f32, outputs = [velocity]", 4.0),
    ("theta0 = π - 5.817e-3, tol = 2.115e-4, t_max = 1.3777e5, float = f32, outputs = [velocity]", 4.0),
    ("theta0 = π - 1.108e-3, tol = 1.839e-2, t_max = 2.3818e5, float = f32", 3.0),
    ("theta0 = 3.0007, tol = 3.682e-3, t_max = 1.6141e5, float = f32, outputs = [position]", 3.0),
    ("theta0 = 2.9516, tol = 2.243e-3, t_max = 1.5874e5, float = f32, outputs = [acceleration]", 4.0),
    // Nor does their error grow beyond that as fast as the terms that are left out.
    ("theta0 = π - 3.0906e-8, tol = 1e-4, t_max = 3.6352e5, float = f32, outputs = [acceleration]", 3.5),
    ("theta0 = π - 4.0736e-9, tol = 1e-4, t_max = 7.2062e5, float = f32", 2.0),
    ("velocity0 = -2.0000003, tol = 5.6e-5, t_max = 1.16e5, float = f32, outputs = [acceleration]", 3.0),
    // Near the top the lowest point is passed within a small part of the phases.
    ("theta0 = π - 1.289e-8, tol = 2.3e-5, t_max = 342.9, float = f32, outputs = [position]", 4.0),
    ("theta0 = π - 5.264e-5, tol = 2e-12, t_max = 4.1e4, outputs = [velocity]", 1.5),
    ("theta0 = π - 2.755e-7, tol = 5.7e-5, t_max = 38, float = f32, outputs = [acceleration]", 3.0),
    // Over poles next to the lowest point sums are small there and large elsewhere, and coefficients may be larger still.
    ("theta0 = π - 1.667e-10, tol = 6.3e-12, t_max = 53.018, outputs = [acceleration]", 2.0),
    ("theta0 = π - 7.987e-08, tol = 3.3e-07, t_max = 197.701, outputs = [position]", 2.0),
    // A cosine's error counts by the slope of the sum, of which there is next to none about a turning point there.
    ("theta0 = π - 1e-3, tol = 1e-2, method = fourier, float = f32", 3.0),
    ("theta0 = 3.1, tol = 1e-4, method = fourier, float = f32, outputs = [velocity]", 2.5),
    // So are the phases that a short horizon meets.
    ("theta0 = π - 1e-5, velocity0 = -1e-7, t_max = 8, tol = 1e-6", 1.7),
    ("theta0 = π - 1e-5, velocity0 = -1e-7, t_max = 8, tol = 1e-6, outputs = [velocity]", 1.7),
    ("theta0 = π - 1e-5, velocity0 = -1e-7, t_max = 8, tol = 1e-6, outputs = [acceleration]", 1.7),
    ("theta0 = π - 1e-5, velocity0 = -1e-7, t_max = 8, tol = 1e-6, outputs = [position]", 2.5),
    ("theta0 = π - 1.342e-05, velocity0 = -1.663e-08, t_max = 7.677, tol = 4.8e-3, outputs = [acceleration]", 1.7),
    ("theta0 = π - 1.253e-05, velocity0 = -3.576e-06, t_max = 9.565, tol = 5.1e-7", 1.7),
    ("theta0 = π - 1.138e-02, velocity0 = -1.661e-06, t_max = 4.445, tol = 4.12e-7", 1.7),
    (
        "theta0 = π - 4.541e-05, velocity0 = 4.122e-08, t_max = 9.218, tol = 8.64e-5, float = f32, outputs = [position]",
        3.0,
    ),
    ("theta0 = 2.372, omega = 7.88, tol = 7.54e-11, t_max = 2.94e-7, outputs = [velocity]", 3.0),
    ("theta0 = π - 1.795e-9, tol = 7.49e-3, t_max = 1.046, float = f32, outputs = [velocity]", 2.0),
    ("velocity0 = 95.9358, omega = 6.389, tol = 6.45e-2, t_max = 1.13e-3, float = f32, outputs = [wrapped]", 2.0),
    ("theta0 = 1, tol = 1e-1, t_max = 0.1, outputs = [velocity], method = harmonic", 1.2),
    ("theta0 = 2.6e-3, tol = 2.5e-6, t_max = 0.015, outputs = [velocity], method = small_angle", 1.2),
    ("theta0 = 0.5, velocity0 = 0.3, tol = 0.25, t_max = 0.25, outputs = [velocity], method = small_angle", 1.4),
    ("theta0 = 0.5, velocity0 = 0.3, tol = 0.9, t_max = 4, outputs = [acceleration], method = small_angle", 2.2),
    ("velocity0 = 0.2, tol = 0.3, t_max = 0.03, method = small_angle", 1.2),
    ("velocity0 = 0.2, tol = 0.3, t_max = 20, outputs = [velocity], method = small_angle", 1.4),
    ("theta0 = 0.2, velocity0 = -0.01, omega = 2, tol = 0.3, t_max = 3, method = small_angle", 1.4),
    ("theta0 = π - 1.402e-4, tol = 1e-3, t_max = 1.4e-3, outputs = [velocity], method = series", 1.2),
    ("theta0 = 2.9, tol = 1e-3, t_max = 0.02, outputs = [velocity], method = fourier", 1.5),
    ("theta0 = 0.5, velocity0 = 0.5, tol = 1e-3, t_max = 0.1, outputs = [velocity], method = fourier", 1.2),
    ("theta0 = 0.001, tol = 1e-4, t_max = 0.043, float = f32, outputs = [velocity], method = small_angle", 3.5),
    ("theta0 = 0.001, tol = 1e-4, t_max = 0.15, float = f32, outputs = [velocity], method = small_angle", 3.0),
    ("theta0 = π - 1.593e-3, tol = 1.6e-5, t_max = 2.53, float = f32, method = series", 1.3),
    ("theta0 = π - 6.794e-5, tol = 9.1e-6, t_max = 0.64, method = series", 1.2),
    ("theta0 = 1.3415, velocity0 = 0.1888, tol = 1.4e-2, t_max = 0.29, method = harmonic", 1.2),
    ("theta0 = 2.7571, tol = 1.4e-5, t_max = 2.3536, method = fourier", 2.0),
    // What stands for θ̂ may undo its error there.
    ("theta0 = 0.9384, tol = 3.4e-3, t_max = 0.4, method = fourier", 1.5),
    ("theta0 = 1.0064, tol = 8.1e-5, t_max = 0.10841, method = fourier", 1.5),
    // Roundings of a few turns, and of the mean.
    ("velocity0 = 1e9, tol = 1e-10, t_max = 4e-9", 1.2),
    ("velocity0 = 1e9, tol = 1e-10, t_max = 1e-8", 1.2),
    ("velocity0 = 1e9, tol = 1e-10, t_max = 4e-9, outputs = [wrapped]", 2.6),
    ("velocity0 = 1e12, tol = 1e-6, t_max = 1e-11", 1.2),
    ("velocity0 = 6407.99, tol = 1e-4, t_max = 5.802e-4, float = f32", 1.4),
    // A launch hardly moves what words leave of half a turn.
    ("theta0 = 0.135, velocity0 = 28472.7542, tol = 4e-3, t_max = 1.105e-4, float = f32, outputs = [wrapped]", 3.5),
];

/// A bound that is too large is as wrong as one that is too small.
#[test]
fn bounds_are_close_to_errors() {
    for &(text, most) in TIGHT {
        // Passages are short, and roundings rarely at their worst.
        let density = if most < 2.0 { 5 } else { 12 };
        let ratio = tightness(&format!("struct Motion; {text}"), &mut Random::new(4), density).unwrap_or(f64::INFINITY);
        assert!(ratio <= most, "{text}: the bound is {ratio:.2} times what was found");
    }
}
