//! The exact motions, and errors against them, by the truth of the stress suites.

use std::collections::HashMap;

use pendula_stress::big::Big;
use pendula_stress::motion::{Motion, Start};
use pendula_stress::truth::{Output, Truth};

use crate::amplitude::Amplitude;

/// The release angle that a contestant was given, and is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Given {
    /// The exact fraction of π.
    Exact,
    /// Its `f64`.
    F64,
    /// Its `f32`.
    F32,
}

/// The motion released from `amplitude` as it was given.
pub fn motion(amplitude: Amplitude, given: Given) -> Motion {
    let theta0 = match given {
        Given::Exact => {
            let [numerator, denominator] = [amplitude.numerator, amplitude.denominator].map(|n| f64::from(n).into());
            Big::pi() * numerator / denominator
        }
        Given::F64 => amplitude.theta0().into(),
        Given::F32 => f64::from(amplitude.theta0() as f32).into(),
    };
    Motion::new(Start::at_rest(theta0))
}

/// The motions of one release angle, each prepared when it is first asked for, which takes up to a second.
pub struct Truths {
    amplitude: Amplitude,
    prepared: HashMap<Given, Truth>,
}

impl Truths {
    /// Of `amplitude`.
    pub fn new(amplitude: Amplitude) -> Self {
        Self { amplitude, prepared: HashMap::new() }
    }

    /// For those who were `given` it so.
    pub fn of(&mut self, given: Given) -> &Truth {
        let prepare = || Truth::new(motion(self.amplitude, given), Output::Theta);
        self.prepared.entry(given).or_insert_with(prepare)
    }
}

/// The largest error of pairs of time and angle; NaN if any angle is.
pub fn largest(truth: &Truth, pairs: impl Iterator<Item = (f64, f64)>) -> f64 {
    let errors = pairs.map(|(t, angle)| truth.error(t, [angle, 0.0]));
    errors.fold(0.0, |most: f64, error| if error.is_nan() || most.is_nan() { f64::NAN } else { most.max(error) })
}

#[cfg(test)]
mod tests {
    use super::{Given, Truths};
    use crate::amplitude::Amplitude;
    use pendula_stress::random::Random;

    /// To the drift's 10¹² periods; multiple precision itself is compared with reference data by `pendula-stress`.
    #[test]
    fn errors_are_those_of_multiple_precision() {
        let mut random = Random::new(2019);
        for amplitude in Amplitude::ALL {
            let mut truths = Truths::new(amplitude);
            let truth = truths.of(Given::Exact);
            let motion = truth.motion();
            for decade in 0..=12 {
                let t = 10.0_f64.powi(decade) * motion.period().to_f64() * random.unit();
                let [_, phase] = motion.phase(t);
                let nearest = [motion.at_phase(&phase).theta.to_f64(), 0.0];
                let difference = (truth.error(t, nearest) - truth.direct(t, nearest)).abs();
                assert!(difference < 5e-18, "{} at {t:e}: {difference:e}", amplitude.name);
            }
        }
    }
}
