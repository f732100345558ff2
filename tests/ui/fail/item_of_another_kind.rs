use pendula::pendulum;

pendulum! {
    enum Clock;
    theta0 = 1
}

fn main() {}
