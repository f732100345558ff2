#![allow(mixed_script_confusables)]

use pendula::pendulum;

fn main() {
    let _theta: fn(f64) -> f64 = pendulum!(θ_0 = 1);
}
