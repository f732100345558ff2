use pendula::pendulum;

pendulum! {
    pub struct Clock;
    omega = 3, n = 4
}

fn main() {
    let _ = Clock;
}
