use pendula::pendulum;

pendulum! {
    pub struct Clock<T>;
    theta0 = 1
}

fn main() {}
