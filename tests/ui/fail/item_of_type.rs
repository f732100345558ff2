use pendula::pendulum;

pendulum! {
    type Clock;
    theta0 = 1
}

fn main() {}
