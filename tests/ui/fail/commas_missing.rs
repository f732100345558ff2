use pendula::pendulum;

fn main() {
    let _theta: fn(f32) -> f32 = pendulum!(theta0 = 1 float = f32);
    let _theta = pendulum!(theta0 = 1, outputs = [theta] tol = 1e-3);
    let _theta = pendulum!(theta0 = 1, method = series tol = 1e-3);
    let _theta = pendulum!(theta0 = 1, n = 4 t_max = 10);
    let _theta = pendulum!(theta0 = 1, tol = 1e-3;);
}
