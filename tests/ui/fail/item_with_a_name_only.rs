use pendula::pendulum;

pendulum! {
    Clock;
    theta0 = 1, n = 0
}

fn main() {}
