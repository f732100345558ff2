use pendula::pendulum;

pendulum! {
    theta0 = 4, tol = -1
}

fn main() {}
