use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = 1, tol = 1e-6, t_max = 100T);
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = 1, tol = 1e-6, t_max = 100 periods);
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = 1, tol = 1e-6, t_max = 100 * T);
}
