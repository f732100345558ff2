use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 3 PI / 4);
    let _ = pendulum!(theta0 = 2(1 + 1));
    let _ = pendulum!(theta0 = sqrt(2)π, tol = 1e-3);
    let _ = pendulum!(theta0 = (1/2)deg);
}
