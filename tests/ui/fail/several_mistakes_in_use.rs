use pendula::pendulum;

fn main() {
    // One error for each mistake, and none that follows from it.
    let rack: [fn(f64) -> f64; 2] = [pendulum!(theta0 = 4), pendulum!(theta0 = 1, n = 0)];
    let sum: f64 = rack.iter().map(|theta| theta(0.0)).sum();
    assert!(pendulum!(theta = 1, colour = 2)(0.25) < sum);
}
