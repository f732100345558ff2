use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(angle = 1, l = 2, g = 3, T = 4, tolerance = 1e-3);
}
