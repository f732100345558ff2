use pendula::pendulum;

pendulum! {
    /// The clock on the wall.
    theta0 = 1
}

fn main() {}
