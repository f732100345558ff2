use pendula::pendulum;

pendulum! {
    /// The clock on the wall.
    pub struct Clock;
    thta0 = 1, g = 9.81, tol = 0,
    outputs = [theta, veloctiy]
}

fn main() {
    let _ = Clock;
}
