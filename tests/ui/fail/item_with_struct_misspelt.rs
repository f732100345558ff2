use pendula::pendulum;

pendulum! {
    Struct Clock;
    theta0 = 1
}

fn main() {}
