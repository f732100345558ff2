use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 1, tol = 1e-18/3 - 0);
}
