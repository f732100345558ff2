//! Times at which plans are looked at: at random, structured, and chosen to hurt.

use crate::big::Big;
use crate::random::Random;

/// So many times are of one kind.
pub(super) const BATCH: usize = 4096;

/// The times of one motion within one horizon.
pub(super) struct Moments {
    /// The promise holds for |t| up to this.
    pub(super) horizon: f64,
    /// T, in two words; on the separatrix 1/ω.
    pub(super) period: [f64; 2],
    /// Phase at t = 0, in periods.
    pub(super) launch: f64,
    /// Numbers that are nearer to a multiple of T/8 than any smaller one of their exponent; see [`hardest`].
    pub(super) hardest: Vec<f64>,
}

/// Kinds that batches take in turn.
const KINDS: u64 = HARDEST + 1;
/// The kind of the hardest times, the last.
pub const HARDEST: u64 = 8;

/// The denominators q of the convergents of the continued fraction of 8·2^e/T: q·2^e is nearer to a multiple of T/8
/// than m·2^e for any m < q. There the phase is as near to a tie of its rounding as it gets, and what its computation
/// neglects is not hidden by the distance.
pub(super) fn hardest(period: &Big, horizon: f64) -> Vec<f64> {
    let mut list = Vec::new();
    let top = horizon.log2().ceil() as i32;
    for exponent in top - 64..=top - 30 {
        let unit = 2.0_f64.powi(exponent);
        let mut rest = &Big::from(8.0 * unit) / period;
        let (mut last, mut this) = (0.0_f64, 1.0_f64);
        // 2⁵³, from where integers aren't numbers.
        while this < 9_007_199_254_740_992.0 {
            list.extend([1.0, 2.0, 3.0, 5.0].map(|multiple| multiple * this * unit).iter().filter(|t| **t <= horizon));
            rest = &rest - &rest.floor();
            if rest.is_zero() {
                break;
            }
            rest = &Big::from(1.0) / &rest;
            (last, this) = (this, rest.floor().to_f64().mul_add(this, last));
        }
    }
    list
}

impl Moments {
    /// The `number`-th batch; all within the horizon.
    pub(super) fn batch(&self, number: u64, times: &mut [f64]) {
        let mut random = Random::new(number);
        for t in times.iter_mut() {
            *t = self.one(number % KINDS, &mut random).clamp(-self.horizon, self.horizon);
        }
    }

    fn one(&self, kind: u64, random: &mut Random) -> f64 {
        let [period, _] = self.period;
        match kind {
            0 => self.horizon * random.signed(),
            1 => random.scaled(period * 1e-3, self.horizon),
            2 => (4.0 * period).min(self.horizon) * random.signed(),
            3 | 4 => self.eighth(random),
            // The end of the horizon, where the phase has drifted most, to its last ulps.
            5 => {
                let back = if random.bits() & 1 == 0 { period * random.unit() } else { 0.0 };
                shifted(self.horizon - back, -((random.bits() & 7) as i64)) * sign(random)
            }
            // Every exponent, subnormals too, with any mantissa or with few bits.
            6 => {
                let bits = random.bits() % (self.horizon.to_bits() + 1);
                let kept = if random.bits() & 1 == 0 { u64::MAX } else { u64::MAX << 44 };
                f64::from_bits(bits & kept) * sign(random)
            }
            // Powers of two and their neighbours.
            7 => {
                let bits = (random.bits() % (self.horizon.to_bits() + 1)) & (0x7FF << 52);
                shifted(f64::from_bits(bits), (random.bits() % 9) as i64 - 4) * sign(random)
            }
            _ if self.hardest.is_empty() => 0.0,
            _ => self.hardest[random.bits() as usize % self.hardest.len()] * sign(random),
        }
    }

    /// Near a multiple of T/8 from a turning point: those and lowest points, where curves are worst conditioned, and
    /// the ties of rounding to whole anchors, whichever way the phase is centred. To the ulp, or less near.
    fn eighth(&self, random: &mut Random) -> f64 {
        let [period, rest] = self.period;
        let most = (self.horizon / period * 8.0).max(16.0);
        let count = random.scaled(0.5, most).round();
        let phase = count / 8.0 - self.launch;
        // The second word matters, since there may be 2⁵³ periods.
        let high = phase * period;
        let t = high + (phase.mul_add(period, -high) + phase * rest);
        match random.bits() & 3 {
            0 => t,
            1 | 2 => shifted(t, (random.bits() % 17) as i64 - 8),
            _ => t + random.scaled(period * 1e-12, period * 0.1),
        }
    }
}

fn sign(random: &mut Random) -> f64 {
    if random.bits() & 1 == 0 { 1.0 } else { -1.0 }
}

/// `ulps` numbers on, away from zero; not past zero.
fn shifted(t: f64, ulps: i64) -> f64 {
    let magnitude = t.abs().to_bits().saturating_add_signed(ulps).min(f64::MAX.to_bits());
    f64::from_bits(magnitude).copysign(t)
}

#[cfg(test)]
mod tests {
    use super::{BATCH, KINDS, Moments, hardest};

    #[test]
    fn all_times_are_within_the_horizon_and_differ() {
        let moments =
            Moments { horizon: 1217.5, period: [12.1, 1e-16], launch: 0.1, hardest: hardest(&12.1.into(), 1217.5) };
        assert!(moments.hardest.len() > 100);
        let mut times = vec![0.0; BATCH];
        for number in 0..KINDS {
            moments.batch(number, &mut times);
            assert!(times.iter().all(|t| t.abs() <= moments.horizon), "{number}");
            let mut bits: Vec<u64> = times.iter().map(|t| t.to_bits()).collect();
            bits.sort_unstable();
            let distinct = 1 + bits.windows(2).filter(|pair| pair[0] != pair[1]).count();
            assert!(distinct > 16, "{number}: {distinct}");
        }
    }
}
