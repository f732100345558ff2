//! Plans in double precision, and the run-time pendulum, at random, structured and adversarial times.

mod classes;
mod moments;

use std::ops::RangeInclusive;

pub use classes::{Class, classes};
pub use moments::HARDEST;

use crate::big::Big;
use crate::finding::Finding;
use crate::motion::{Motion, Regime, Series};
use crate::random::Random;
use crate::report::Row;
use crate::session::{Merge, Session};
use crate::truth::{Output, Truth};
use moments::{BATCH, Moments};

/// One batch in so many is followed by one of times beyond the horizon.
const BEYOND: u64 = 16;
/// One batch in so many has a time that is compared with multiple precision.
const DIRECT: u64 = 8;
/// What fast truth and multiple precision may differ by, relative to the largest value: twice what its rounding is; see
/// [`truth`](crate::truth).
const AGREEMENT: f64 = 1.0 / (1_u64 << 57) as f64;

/// All classes, or those with `only` in their name or output, each at `inputs` times within its horizon.
pub fn run(session: &Session, inputs: u64, only: Option<&str>) -> Vec<Row> {
    let chosen = |class: &Class| only.is_none_or(|only| class.name.contains(only) || class.output.name() == only);
    let judge = |class: &Class| {
        let looker = Looker::new(class, true);
        let batches = inputs.div_ceil(BATCH as u64);
        let found = session.share(&looker.class.name, batches, |number, found| looker.examine(number, found));
        looker.class.row(found)
    };
    classes().iter().filter(|class| chosen(class)).take_while(|_| !session.stopped()).map(judge).collect()
}

/// A sample for tests: every class at `each` times of every kind among `kinds`, against multiple precision.
pub fn sample(session: &Session, each: usize, kinds: RangeInclusive<u64>) -> Vec<Row> {
    let classes = classes();
    let found = session.share("sample", classes.len() as u64, |i, found: &mut Sample| {
        let looker = Looker::new(&classes[i as usize], false);
        let mut one = Finding::default();
        for kind in kinds.clone() {
            looker.look_directly(kind, each, &mut one);
        }
        looker.examine_beyond(0, &mut one);
        found.0.push(looker.class.row(one));
    });
    found.0
}

/// Rows in the order in which they were finished.
#[derive(Default)]
struct Sample(Vec<Row>);

impl Merge for Sample {
    fn merge(&mut self, other: Self) {
        self.0.extend(other.0);
    }
}

/// A class, its times, and its truth.
struct Looker<'a> {
    class: &'a Class,
    truth: Truth,
    moments: Moments,
    /// For the paper's θ̂, which is not the motion.
    paper: Option<(Series, Vec<Big>)>,
}

impl<'a> Looker<'a> {
    /// With tables for fast truth, or without.
    fn new(class: &'a Class, tables: bool) -> Self {
        let motion = Motion::new(class.start.clone());
        let launch = match &motion.regime {
            Regime::Swing(series) | Regime::Rotation(series) => series.launch.to_f64(),
            Regime::Separatrix => 0.0,
        };
        let period = motion.period().to_pair();
        let horizon = class.horizon.min(class.periods * period[0]);
        let hardest = moments::hardest(&motion.period(), horizon);
        let paper = match (&motion.regime, class.terms) {
            (Regime::Swing(series), Some(terms)) => Some((series.clone(), series.paper_coefficients(terms))),
            _ => None,
        };
        let truth = if tables && paper.is_none() {
            Truth::new(motion, class.output)
        } else {
            Truth::without_tables(motion, class.output)
        };
        Self { moments: Moments { horizon, period, launch, hardest }, class, truth, paper }
    }

    fn examine(&self, number: u64, found: &mut Finding) {
        let mut times = vec![0.0; BATCH];
        self.moments.batch(number, &mut times);
        if let Some((series, coefficients)) = &self.paper {
            // Each takes a hundred thousand times as long: a few of every batch do.
            self.examine_paper(series, coefficients, &times[..8], found);
            return;
        }
        let mut values = vec![[0.0; 2]; BATCH];
        (self.class.evaluate)(&times, &mut values);
        found.tried += BATCH as u64;
        for (&t, &value) in times.iter().zip(&values) {
            let error = self.truth.error(t, value);
            self.judge(t, value, error, found);
        }
        if number.is_multiple_of(DIRECT) {
            let i = Random::new(number).bits() as usize % BATCH;
            self.compare(times[i], values[i], found);
        }
        if number.is_multiple_of(BEYOND) {
            self.examine_beyond(number, found);
        }
    }

    /// The first `count` times of a batch against multiple precision alone.
    fn look_directly(&self, number: u64, count: usize, found: &mut Finding) {
        let mut times = vec![0.0; BATCH];
        self.moments.batch(number, &mut times);
        let times = &times[..count];
        if let Some((series, coefficients)) = &self.paper {
            self.examine_paper(series, coefficients, times, found);
            return;
        }
        let mut values = vec![[0.0; 2]; count];
        (self.class.evaluate)(times, &mut values);
        for (&t, &value) in times.iter().zip(&values) {
            found.tried += 1;
            let error = self.truth.direct(t, value);
            self.judge(t, value, error, found);
        }
    }

    fn judge(&self, t: f64, value: [f64; 2], error: f64, found: &mut Finding) {
        if !self.is_within_range(value) {
            found.fault(|| format!("{} at {t:e}: {value:?}", self.class.name));
        }
        found.require(error, self.class.limit(), t, || {
            format!("{} at {t:e}: {value:?}, off by {error:e}", self.class.name)
        });
    }

    /// Whether it is no more than the motion's largest and the error that it may have; a wrapped angle is within ±π
    /// whatever its error.
    fn is_within_range(&self, value: [f64; 2]) -> bool {
        let excess = if self.class.output == Output::Wrapped { 0.0 } else { self.class.limit() };
        let most = (self.class.ceiling + excess) * self.unit();
        value.iter().all(|value| value.abs() <= most)
    }

    /// What one power of ω is in the output.
    fn unit(&self) -> f64 {
        self.class.output.unit(self.class.start.omega.to_f64())
    }

    /// Fast truth with multiple precision.
    fn compare(&self, t: f64, value: [f64; 2], found: &mut Finding) {
        let (fast, direct) = (self.truth.error(t, value), self.truth.direct(t, value));
        // What is promised is relative to this too.
        let scale = self.class.ceiling.min(value[0].abs().max(std::f64::consts::PI));
        if (fast - direct).abs() > AGREEMENT * scale || direct.is_nan() {
            found.fault(|| format!("truth at {t:e} is off: {fast:e}, {direct:e}"));
        }
    }

    /// Beyond the horizon results are finite and within the motion's range.
    fn examine_beyond(&self, number: u64, found: &mut Finding) {
        let mut random = Random::new(!number);
        let mut times = vec![0.0; BATCH];
        let (near, far) = (self.moments.horizon.to_bits(), f64::MAX.to_bits());
        for t in &mut times {
            let magnitude = f64::from_bits(near + random.bits() % (far - near + 1));
            *t = if random.bits() & 1 == 0 { magnitude } else { -magnitude };
        }
        times[0] = f64::MAX;
        let mut values = vec![[0.0; 2]; BATCH];
        (self.class.evaluate)(&times, &mut values);
        for (&t, &value) in times.iter().zip(&values) {
            if !self.is_within_range(value) {
                found.fault(|| format!("{} at {t:e}, beyond the horizon: {value:?}", self.class.name));
            }
        }
        times[..3].copy_from_slice(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY]);
        (self.class.evaluate)(&times, &mut values);
        for (&t, value) in times[..3].iter().zip(&values) {
            if !value[0].is_nan() {
                found.fault(|| format!("{} at {t:e}: {value:?}", self.class.name));
            }
        }
    }

    fn examine_paper(&self, series: &Series, coefficients: &[Big], times: &[f64], found: &mut Finding) {
        for &t in times {
            let mut values = [[0.0; 2]];
            (self.class.evaluate)(&[t], &mut values);
            let [_, phase] = self.truth.motion().phase(t);
            let Some(exact) = series.paper(coefficients, &phase) else { continue };
            found.tried += 1;
            found.observe((&values[0][0].into() - &exact).to_f64().abs(), t);
        }
    }
}
