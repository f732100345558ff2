use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(theta = 7π/8, n = 4);
}
