use pendula::pendulum;

pendulum! {
    /// The clock on the wall.
    #[derive(Debug)]
    pub struct Clock;
    theta0 = 4, outputs = [theta, velocity, position]
}

fn main() {
    // Nothing of this is an error beside the one above.
    const START: f64 = Clock::theta(0.0);
    let (x, v) = Clock::state(1.0);
    let (right, up) = Clock::position(1.0);
    println!("{Clock:?} {START} {x} {v} {right} {up} {} {}", Clock::PERIOD, Clock::MAX_ERROR);
}
