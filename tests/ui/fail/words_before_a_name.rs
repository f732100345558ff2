use pendula::pendulum;

fn main() {
    let _theta = pendulum!(let theta0 = 1);
    let _theta = pendulum!(theta0 = 1, const N = 3);
}
