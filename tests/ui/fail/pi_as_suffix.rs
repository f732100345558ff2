use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 7pi/8, omega = 2PI);
}
