use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 90.0.to_radians());
    let _ = pendulum!(theta0 = 1 as f64);
}
