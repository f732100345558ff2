//! Timing: all jobs in interleaved rounds, so that whatever disturbs the machine disturbs all alike.

use std::time::{Duration, Instant};

use pendula_stress::random::Random;

/// How long to measure.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Every job is timed once per round.
    pub rounds: usize,
    /// About this long each time.
    pub batch: Duration,
}

impl Effort {
    /// For the record.
    pub const FULL: Self = Self { rounds: 41, batch: Duration::from_micros(1500) };
    /// For a look, and for CI.
    pub const QUICK: Self = Self { rounds: 9, batch: Duration::from_micros(600) };
}

/// Something to time.
pub struct Job<'a> {
    /// What is timed; one call gives `values`.
    pub work: Box<dyn FnMut() + 'a>,
    /// Values per call.
    pub values: usize,
    /// Whether each call comes after other work has used the caches.
    cold: bool,
    repeats: u32,
    /// Nanoseconds per value, one sample per round.
    pub samples: Vec<f64>,
}

impl<'a> Job<'a> {
    /// A job of which one call gives `values`.
    pub fn new(values: usize, work: impl FnMut() + 'a) -> Self {
        Self { work: Box::new(work), values, cold: false, repeats: 1, samples: Vec::new() }
    }

    /// One whose calls are timed singly, each with nothing of it left in the nearer caches.
    pub fn cold(values: usize, work: impl FnMut() + 'a) -> Self {
        Self { cold: true, ..Self::new(values, work) }
    }

    fn time(&mut self, repeats: u32) -> Duration {
        let start = Instant::now();
        for _ in 0..repeats {
            (self.work)();
        }
        start.elapsed()
    }

    /// Finds how many calls fill a batch.
    fn calibrate(&mut self, batch: Duration) {
        (self.work)();
        while !self.cold && self.time(self.repeats) < batch && self.repeats < 1 << 20 {
            self.repeats *= 2;
        }
    }

    /// One sample, after a call that is not timed and warms predictors up, and the caches or with `litter` not.
    fn sample(&mut self, litter: &mut [u64]) {
        (self.work)();
        if self.cold {
            sweep(litter);
        }
        let elapsed = self.time(self.repeats);
        let values = self.values as f64 * f64::from(self.repeats);
        self.samples.push(elapsed.as_secs_f64() * 1e9 / values);
    }
}

/// Bytes that the caches are swept with: several times those of a core's own, a part of what cores share.
const LITTER: usize = 8 << 20;

/// Writes to all of it.
fn sweep(litter: &mut [u64]) {
    for word in &mut *litter {
        *word = word.wrapping_add(1);
    }
    std::hint::black_box(litter);
}

/// Times all jobs, in a new random order each round; `progress` is told how many rounds of how many are done.
pub fn race<'a, 'b: 'a>(
    jobs: impl IntoIterator<Item = &'a mut Job<'b>>,
    effort: Effort,
    mut progress: impl FnMut(usize, usize),
) {
    let mut jobs: Vec<_> = jobs.into_iter().collect();
    for job in &mut jobs {
        job.calibrate(effort.batch);
    }
    let mut litter = vec![1; LITTER / size_of::<u64>()];
    let mut random = Random::new(5);
    for round in 0..effort.rounds {
        jobs.sort_by_cached_key(|_| random.bits());
        for job in &mut jobs {
            job.sample(&mut litter);
        }
        progress(round + 1, effort.rounds);
    }
}

/// Median and quartiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Half of the samples are below.
    pub median: f64,
    /// A quarter is below.
    pub lower: f64,
    /// A quarter is above.
    pub upper: f64,
}

impl Spread {
    /// Of at least one sample, by linear interpolation between them.
    pub fn of(samples: impl IntoIterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = samples.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        let at = |part: f64| {
            let place = part * (sorted.len() - 1) as f64;
            let (below, rest) = (place as usize, place.fract());
            sorted[below] + rest * (sorted[(below + 1).min(sorted.len() - 1)] - sorted[below])
        };
        Self { median: at(0.5), lower: at(0.25), upper: at(0.75) }
    }

    /// Of the quotients, round by round: a disturbance that lasts longer than a round cancels.
    pub fn of_ratios(numerators: &[f64], denominators: &[f64]) -> Self {
        Self::of(numerators.iter().zip(denominators).map(|(a, b)| a / b))
    }
}

#[cfg(test)]
mod tests {
    use super::Spread;

    #[test]
    fn quartiles_of_five() {
        let spread = Spread::of([5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!(spread, Spread { median: 3.0, lower: 2.0, upper: 4.0 });
    }
}
