use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = 1, omega = 60rpm, t_max = 1h);
}
