use pendula::pendulum;

fn main() {
    let _theta = pendulum!(theta0 = 1, f32, harmonic, velocity, tol, colour);
}
