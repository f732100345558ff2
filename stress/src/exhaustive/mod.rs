//! Every one of the 2³² values of an `f32` time, for plans in single precision, against a plan of the same scene in
//! double precision.
//!
//! The double-precision plan is proven to 2⁻⁴⁹ of the amplitude and measured against multiple precision by
//! [`times`](crate::times), so that a millionth of what is looked for is its share in the errors found.

mod plans;

pub use plans::{Plan, plans};

use crate::finding::Finding;
use crate::report::Row;
use crate::session::Session;

/// Values that share their upper 16 bits, hence sign and exponent.
const PIECE: u32 = 1 << 16;
/// Values that are evaluated together.
const BLOCK: usize = 1024;

/// All values of every plan. `stride` is 1 for all, n for every n-th block of 1024 values.
pub fn run(session: &Session, stride: u32) -> Vec<Row> {
    let judge = |plan: &Plan| {
        let pieces = u64::from(u32::MAX / PIECE) + 1;
        let found = session.share(plan.name, pieces, |piece, found| plan.examine(piece as u32 * PIECE, stride, found));
        plan.row(found)
    };
    plans().iter().take_while(|_| !session.stopped()).map(judge).collect()
}

/// The times, what the plan gives, and what is true.
struct Block {
    t: [f32; BLOCK],
    given: [f32; BLOCK],
    truth: [f64; BLOCK],
}

impl Plan {
    fn examine(&self, first: u32, stride: u32, found: &mut Finding) {
        let mut block = Block { t: [0.0; BLOCK], given: [0.0; BLOCK], truth: [0.0; BLOCK] };
        for start in (first..=first + (PIECE - 1)).step_by(BLOCK) {
            if !(start / BLOCK as u32).is_multiple_of(stride) {
                continue;
            }
            for (t, bits) in block.t.iter_mut().zip(start..) {
                *t = f32::from_bits(bits);
            }
            (self.single)(&block.t, &mut block.given);
            found.tried += BLOCK as u64;
            if block.t[0].is_finite() {
                self.examine_finite(&mut block, found);
            } else {
                self.examine_not_finite(&block, found);
            }
        }
    }

    /// A block is of one exponent, so that all of it is finite if the first is.
    fn examine_finite(&self, block: &mut Block, found: &mut Finding) {
        let mut largest = 0.0_f32;
        let mut nans = 0_u32;
        for &value in &block.given {
            largest = if value.abs() > largest { value.abs() } else { largest };
            nans += u32::from(value.is_nan());
        }
        // A wrapped angle is within ±π whatever its error.
        let most = if self.wrapped { self.ceiling } else { self.ceiling + self.proven };
        if nans > 0 || f64::from(largest) > most {
            for (&t, &value) in block.t.iter().zip(&block.given) {
                if value.is_nan() || f64::from(value.abs()) > most {
                    found.fault(|| format!("{}: {value:e} at t = {t:e}", self.name));
                }
            }
        }
        (self.double)(&block.t, &mut block.truth);
        let worst = block.given.iter().zip(&block.truth).fold(0.0_f64, |worst, (&given, &truth)| {
            let error = self.error(given, truth);
            if error > worst { error } else { worst }
        });
        if worst > found.worst || worst > self.proven {
            self.look_closer(block, found);
        }
    }

    fn look_closer(&self, block: &Block, found: &mut Finding) {
        for ((&t, &given), &truth) in block.t.iter().zip(&block.given).zip(&block.truth) {
            if f64::from(t.abs()) > self.horizon {
                continue;
            }
            let error = self.error(given, truth);
            found.observe(error, t.into());
            if error > self.proven {
                found.fault(|| format!("{}: {given:e} for {truth:e} at t = {t:e}, off by {error:e}", self.name));
            }
        }
    }

    /// Modulo a turn for a wrapped angle: just above −π and just below π are neighbours.
    fn error(&self, given: f32, truth: f64) -> f64 {
        let error = (f64::from(given) - truth).abs();
        let around = (error - std::f64::consts::TAU).abs();
        if self.wrapped && around < error { around } else { error }
    }

    fn examine_not_finite(&self, block: &Block, found: &mut Finding) {
        for (&t, &value) in block.t.iter().zip(&block.given) {
            if !value.is_nan() {
                found.fault(|| format!("{}: {value:e} at t = {t:e}", self.name));
            }
        }
    }

    fn row(&self, found: Finding) -> Row {
        Row {
            subject: self.name.into(),
            output: self.output.into(),
            promise: self.promise,
            proven: Some(self.proven),
            observable: self.observable,
            found,
        }
    }
}
