use pendula::pendulum;

fn main() {
    pendulum! { struct Clock; theta0 = 1, outputs = [theta velocity] }
    pendulum! { struct Lamp; theta0 = 1, outputs = [theta; velocity] }
    pendulum! { struct Bell; theta0 = 1, outputs = [theta, velocity tol = 1e-3] }
}
