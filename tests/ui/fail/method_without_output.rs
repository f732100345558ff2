use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = 1, method = harmonic, tol = 0.5, outputs = [position]);
}
