use pendula::pendulum;

pendulum! {
    pub struct Clock { hand: f64 }
    theta0 = 1
}

fn main() {}
