use pendula::pendulum;

fn main() {
    let _theta: fn(f32) -> f32 = pendulum!(theta0 = 1e-40, float = f32);
}
