use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = 1π/2, method = small_angle, tol = 1e-3);
}
