use pendula::pendulum;

fn main() {
    let _theta: fn(f32) -> f32 = pendulum!(theta0 = 1, tol = 1e-9, float = f32);
}
