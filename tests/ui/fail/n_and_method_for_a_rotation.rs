use pendula::pendulum;

fn main() {
    let _ = pendulum!(velocity0 = 3, n = 4, method = fourier);
}
