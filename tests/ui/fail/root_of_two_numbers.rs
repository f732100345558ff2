use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = sqrt(2, 3));
    let _ = pendulum!(theta0 = sqrt());
}
