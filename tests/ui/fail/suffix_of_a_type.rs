use pendula::pendulum;

fn main() {
    let _theta = pendulum!(theta0 = 1f64, tol = 1e-6_f32);
}
