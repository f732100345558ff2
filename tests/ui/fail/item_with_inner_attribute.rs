use pendula::pendulum;

pendulum! {
    #![allow(missing_docs)]
    struct Clock;
    theta0 = 1
}

fn main() {}
