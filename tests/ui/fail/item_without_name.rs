use pendula::pendulum;

pendulum! {
    pub struct;
    theta0 = 1
}

fn main() {}
