use pendula::pendulum;

fn main() {
    pendulum! { struct Clock; theta0 = 1, struct Lamp; tol = 1e-3 }
}
