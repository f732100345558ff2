use pendula::pendulum;

fn main() {
    // What has an unknown name may be what is missing.
    let _ = pendulum!(phi = 1, n = 4);
    let _ = pendulum!(theta0 = 1, gee = 9.81, length = 1);
    let _ = pendulum!(theta0 = 1, g = 9.81, ell = 1);
    let _ = pendulum!(1);
}
