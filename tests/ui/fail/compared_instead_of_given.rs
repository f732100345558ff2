use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 == 1, n = 4);
}
