use pendula::pendulum;

fn main() {
    pendulum! { pub struct Clock }
    pendulum! { pub struct }
    pendulum! { pub }
}
