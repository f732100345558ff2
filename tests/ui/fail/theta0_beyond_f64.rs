use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 1e390);
}
