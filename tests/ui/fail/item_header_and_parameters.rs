use pendula::pendulum;

pendulum! {
    struct Comma,
    theta0 = 4, tol = 0
}

pendulum! {
    struct Generic<T = f64>;
    theta0 = 1, n = 0
}

pendulum! {
    struct Twice;;
    theta0 = 4
}

pendulum! {
    fn Function() -> f64;
    theta0 = 1
}

fn main() {
    let _angles = [Comma::theta(0.0), Generic::theta(0.0), Twice::theta(0.0), Function::theta(0.0)];
}
