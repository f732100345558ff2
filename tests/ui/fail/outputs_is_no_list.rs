use pendula::pendulum;

fn main() {
    let _ = pendulum!(theta0 = 1, outputs = velocity);
    let _ = pendulum!(theta0 = 1, outputs = (theta));
    // One mistake, however many words.
    let _ = pendulum!(theta0 = 1, outputs = theta, velocity, position);
}
