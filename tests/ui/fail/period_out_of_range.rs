use pendula::pendulum;

fn main() {
    let _theta: fn(f32) -> f32 = pendulum!(theta0 = 1, omega = 1.5e-38, float = f32);
}
