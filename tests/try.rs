use pendula::pendulum;
pendulum! {
    /// The clock.
    #[derive(Debug)]
    pub struct Clock;
    theta0 = 157.5deg, g = 9.81, length = 0.994, tol = 1e-9, t_max = 86_400,
    outputs = [theta, velocity]
}
#[test]
fn it() {
    let theta = pendulum!(theta0 = 7π / 8, tol = 1e-6);
    println!("{:?} {:?} {:?}", theta(0.25), Clock::state(3.0), Clock::MAX_ERROR);
    let f: fn(f64) -> f64 = theta;
    assert_eq!(core::mem::size_of_val(&theta), 0);
    const X: f64 = Clock::theta(1.0);
    println!("{X} {}", f(1.0));
}
