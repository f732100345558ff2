use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = 1, tol = 1e-3, t_max = 86,400);
}
