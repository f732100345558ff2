use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = 1, g = 9.81m/s, length = 0.994m);
}
