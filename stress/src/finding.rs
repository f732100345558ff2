//! What was found about one promise.

use crate::session::Merge;

/// So many faults are described; the others are counted.
const DESCRIBED: usize = 8;

/// The largest error among many inputs, and everything that must not be.
#[derive(Clone, Debug, Default)]
pub struct Finding {
    /// Inputs tried.
    pub tried: u64,
    /// The largest error, where the promise holds.
    pub worst: f64,
    /// The input that has it.
    pub at: f64,
    /// How many inputs broke a promise.
    pub broken: u64,
    /// The first of them.
    pub faults: Vec<String>,
}

impl Finding {
    /// Takes note of an error, of which none is larger than one that is no number.
    pub fn observe(&mut self, error: f64, at: f64) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        if error > self.worst {
            (self.worst, self.at) = (error, at);
        }
    }

    /// Takes note of an error that must not exceed `limit`, nor be NaN.
    pub fn require(&mut self, error: f64, limit: f64, at: f64, describe: impl FnOnce() -> String) {
        self.observe(error, at);
        if error > limit || error.is_nan() {
            self.fault(describe);
        }
    }

    /// Takes note of a broken promise.
    pub fn fault(&mut self, describe: impl FnOnce() -> String) {
        self.broken += 1;
        if self.faults.len() < DESCRIBED {
            self.faults.push(describe());
        }
    }
}

impl Merge for Finding {
    fn merge(&mut self, other: Self) {
        self.tried += other.tried;
        self.observe(other.worst, other.at);
        self.broken += other.broken;
        self.faults.extend(other.faults);
        self.faults.truncate(DESCRIBED);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_the_worst() {
        let mut found = Finding::default();
        for (error, at) in [(0.5, 1.0), (f64::NAN, 2.0), (3.0, 3.0)] {
            found.observe(error, at);
        }
        assert_eq!((found.worst, found.at), (f64::INFINITY, 2.0));
        found.require(f64::NAN, 1.0, 4.0, || "no number".to_owned());
        assert_eq!(found.broken, 1);
    }
}
