use pendula::pendulum;

pendulum! {
    pub struct Clock
    theta0 = 1
}

fn main() {}
