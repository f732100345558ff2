use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(velocity0 = 2, method = series);
}
