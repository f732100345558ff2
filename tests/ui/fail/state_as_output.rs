use pendula::pendulum;

fn main() {
    pendulum! { struct Clock; theta0 = 1, outputs = [state] }
}
