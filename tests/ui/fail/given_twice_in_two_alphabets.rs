#![allow(mixed_script_confusables)]

use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(theta0 = 1, θ0 = 1);
}
