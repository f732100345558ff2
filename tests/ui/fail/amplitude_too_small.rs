use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 1e-305);
    let _ = pendulum!(theta0 = 1e-36, float = f32);
}
