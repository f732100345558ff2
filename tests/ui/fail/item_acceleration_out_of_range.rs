use pendula::pendulum;

pendulum! {
    struct Clock;
    theta0 = 1, omega = 1e200, outputs = [acceleration]
}

fn main() {
    let _ = Clock;
}
