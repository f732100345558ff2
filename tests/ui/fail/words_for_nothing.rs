use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 1, t_max = f64::INFINITY, tol = full);
    let _ = pendulum!(theta: 1.0);
}
