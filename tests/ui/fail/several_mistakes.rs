use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = 4, omega = 0, n = 0, t_max = -2, method = series);
}
