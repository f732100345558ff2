use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = 1e-99999, tol = 1e-3);
}
