//! The phase of a time, in integers.

use crate::big::Big;
use crate::motion::{Motion, Regime};

use super::SPAN;

/// Where a time falls.
pub(super) struct Phase {
    /// The interval whose middle is nearest.
    pub(super) index: usize,
    /// The distance from its middle in intervals, within ±½.
    pub(super) offset: f64,
    /// Whole turns of a rotation before it, with the sign of θ; 0 otherwise.
    pub(super) turns: f64,
}

/// Turns times into phases.
pub(super) enum Clock {
    /// φ = Rt + launch.
    Periodic {
        /// launch·2¹⁹², modulo 2²⁵⁶.
        launch: [u64; 4],
        /// log₂ of the number of intervals.
        bits: u32,
        /// The sign of θ for a rotation, 0 for a swing.
        direction: f64,
        /// R·2^e by e, from −1074 up.
        windows: Vec<[u64; 4]>,
    },
    /// φ = ωt, not periodic.
    Linear { omega: f64, per_unit: f64 },
}

/// Exponents of `f64` seen as integers times 2^e.
const LEAST: i32 = -1074;

impl Clock {
    pub(super) fn new(motion: &Motion, per_unit: u32) -> Self {
        let (series, direction) = match &motion.regime {
            Regime::Swing(series) => (series, 0.0),
            Regime::Rotation(series) => (series, motion.sign),
            Regime::Separatrix => {
                return Self::Linear { omega: motion.start.omega.to_f64(), per_unit: per_unit.into() };
            }
        };
        let rate = &Big::from(1.0) / &series.period;
        let windows = (LEAST..=971).map(|e| rate.fixed(192 + e)).collect();
        let launch = series.launch.fixed(192);
        let launch = if series.launch.is_negative() { negated(launch) } else { launch };
        Self::Periodic { launch, bits: per_unit.trailing_zeros(), direction, windows }
    }

    pub(super) fn at(&self, t: f64) -> Phase {
        match self {
            Self::Linear { omega, per_unit } => {
                let z = (omega * t).clamp(-SPAN, SPAN) * per_unit;
                let nearest = z.round();
                Phase { index: (nearest + SPAN * per_unit) as usize, offset: z - nearest, turns: 0.0 }
            }
            Self::Periodic { launch, bits, direction, windows } => {
                let (integer, exponent) = parts(t.abs());
                let product = times(windows[(exponent - LEAST) as usize], integer);
                let elapsed = if t < 0.0 { negated(product) } else { product };
                split(sum(elapsed, *launch), *bits, *direction)
            }
        }
    }
}

/// The interval of a phase in fixed point.
fn split(phase: [u64; 4], bits: u32, direction: f64) -> Phase {
    // Half an interval on, so that truncation finds the nearest middle.
    let [_, low, high, turns] = sum(phase, [0, 0, 1 << (63 - bits), 0]);
    let fraction = u128::from(high) << 64 | u128::from(low);
    let index = (high >> (64 - bits)) as usize;
    let within = ((fraction << bits) >> 64) as u64;
    // Less the half, as a signed fraction of 2⁶⁴.
    let offset = (within ^ 1 << 63) as i64 as f64 / 18_446_744_073_709_551_616.0;
    // From the anchor before or after: beyond the middle of the period the table is that of the next turn.
    let turns = turns.wrapping_add(high >> 63) as i64;
    Phase { index, offset, turns: turns as f64 * direction }
}

/// t = integer·2^exponent.
fn parts(t: f64) -> (u64, i32) {
    let bits = t.to_bits();
    let (exponent, mantissa) = ((bits >> 52) as i32, bits & ((1 << 52) - 1));
    if exponent == 0 { (mantissa, LEAST) } else { (mantissa | 1 << 52, exponent - 1 + LEAST) }
}

fn times(words: [u64; 4], factor: u64) -> [u64; 4] {
    let mut carry = 0_u128;
    words.map(|word| {
        let product = u128::from(word) * u128::from(factor) + carry;
        carry = product >> 64;
        product as u64
    })
}

fn sum(a: [u64; 4], b: [u64; 4]) -> [u64; 4] {
    let mut carry = false;
    let mut result = a;
    for (x, y) in result.iter_mut().zip(b) {
        let (partial, first) = x.overflowing_add(y);
        let (total, second) = partial.overflowing_add(carry.into());
        (*x, carry) = (total, first | second);
    }
    result
}

fn negated(words: [u64; 4]) -> [u64; 4] {
    sum(words.map(|word| !word), [1, 0, 0, 0])
}
