use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 1, float = "f32", method = "fourier", n = 4);
    let _ = pendulum!(theta0 = 1, float = 32);
}
