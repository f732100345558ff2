use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 2^3);
    let _ = pendulum!(theta0 = 2**0.5, t_max = 2^53);
}
