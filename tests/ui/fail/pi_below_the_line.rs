#![allow(mixed_script_confusables)]

use pendula::pendulum;

fn main() {
    let _theta = pendulum!(theta0 = 7/8 π);
    let _theta = pendulum!(theta0 = 315/2 deg);
}
