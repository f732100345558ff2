use pendula::pendulum;

fn main() {
    let _theta = pendulum!(theta0 => 1, n == 4);
    let _theta = pendulum!(theta0 += 1, tol <= 1e-3, outputs[theta]);
}
