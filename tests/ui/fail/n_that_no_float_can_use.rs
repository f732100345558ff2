use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 0.99999π, n = 50, float = f32);
}
