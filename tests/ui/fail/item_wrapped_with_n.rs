use pendula::pendulum;

pendulum! {
    struct Clock;
    theta0 = 1, n = 4, outputs = [theta, wrapped]
}

fn main() {
    let _ = Clock;
}
