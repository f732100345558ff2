use pendula::pendulum;

fn main() {
    // Turns are in the way of θ alone.
    pendulum! { struct Rotor; velocity0 = 3, tol = 1e-14, outputs = [theta, velocity, wrapped] }
}
