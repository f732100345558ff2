use pendula::pendulum;

fn main() {
    let (x, y): (f32, f32) = pendulum!(theta0 = 4, float = f32, outputs = [position])(0.0);
    assert!(x > y);
}
