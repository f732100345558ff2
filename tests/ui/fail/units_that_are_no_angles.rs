use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 1/90deg, tol = 1e-3);
    let _ = pendulum!(theta0 = sqrt(4deg) + 1/(2 - 2), tol = 1e-3);
}
