use pendula::pendulum;

fn main() {
    let _theta: fn(f32) -> f32 = pendulum!(theta0 = 1π/3, n = 12, float = f32);
}
