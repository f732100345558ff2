use pendula::pendulum;

pendulum! {
    unsafe struct Clock;
    theta0 = 1
}

fn main() {}
