//! One run: the field of contestants per amplitude and precision, their errors, and their times.

use std::hint::black_box;

use pendula_stress::random::Random;

use crate::amplitude::Amplitude;
use crate::contestant::{AnyTime, Block, COUNT, Contestant, Family, HORIZON, Kind, STEPPED, State, Stepping};
use crate::race::{Effort, Job, Spread, race};
use crate::real::Real;
use crate::truth::{Given, Truths, largest, motion};

/// All contestants of one amplitude in one precision, with the times that they are asked for.
pub struct Field<R> {
    amplitude: Amplitude,
    period: f64,
    contestants: Vec<Contestant<R>>,
    times: Box<Block<R>>,
}

/// What came out for one contestant.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The release angle.
    pub amplitude: Amplitude,
    /// `"f32"` or `"f64"`.
    pub precision: &'static str,
    /// Who made it.
    pub family: Family,
    /// What it is.
    pub name: String,
    /// Its settings.
    pub setting: String,
    /// The largest error in rad: on the times of the array loop, or for a stepper over 10 periods.
    pub error: f64,
    /// ns per value in the array loop; for a stepper per step of one of 4096 independent pendula.
    pub array: Spread,
    /// ns per call of a loop in which none waits for another, nor is combined with it in a vector; for a stepper per
    /// step of one trajectory.
    pub scalar: Spread,
    /// ns per call when each waits for the one before; for a stepper per step of one trajectory.
    pub single: Spread,
    /// `array` when other work has used the caches before each pass.
    pub cold: Spread,
    /// `array` in units of `sin` in the same loop of the same round.
    pub array_ratio: Spread,
    /// `scalar` likewise.
    pub scalar_ratio: Spread,
    /// `single` likewise.
    pub single_ratio: Spread,
    /// For a stepper, ns for the value at a random time within the horizon, reached from the release.
    pub random_access: Option<f64>,
    /// What the spreads are of.
    pub timed: Timed,
}

/// Contestants of both precisions.
pub struct Session {
    /// In double precision.
    pub doubles: Vec<Field<f64>>,
    /// In single precision.
    pub singles: Vec<Field<f32>>,
}

/// The trajectory of one pendulum.
fn follow<R: Real>(method: &dyn Stepping<R>) -> impl FnMut() {
    let mut angles = Box::new(Block([R::zero(); COUNT]));
    move || {
        method.follow(&mut angles.0);
        black_box(&angles);
    }
}

/// What the jobs of a contestant are, in their order.
pub const JOBS: [&str; 4] = ["array", "scalar", "single", "cold"];

impl<R: Real> Field<R> {
    /// Random times over the horizon of the plans; the same in every run.
    pub fn new(amplitude: Amplitude, contestants: Vec<Contestant<R>>) -> Self {
        let period = motion(amplitude, Given::Exact).period().to_f64();
        let mut random = Random::new(0x5EED);
        let mut times = Box::new(Block([R::zero(); COUNT]));
        for time in &mut times.0 {
            *time = R::of(HORIZON * period * random.unit());
        }
        Self { amplitude, period, contestants, times }
    }

    /// In the order of the results.
    pub fn contestants(&self) -> &[Contestant<R>] {
        &self.contestants
    }

    /// The largest error of each contestant.
    pub fn errors(&self) -> Vec<f64> {
        let mut truths = Truths::new(self.amplitude);
        self.contestants.iter().map(|contestant| self.error(contestant, &mut truths)).collect()
    }

    fn error(&self, contestant: &Contestant<R>, truths: &mut Truths) -> f64 {
        if contestant.family == Family::Yardstick {
            return f64::NAN;
        }
        match &contestant.kind {
            Kind::AnyTime(function) => {
                let mut angles = vec![R::zero(); COUNT];
                function.fill(&self.times.0, &mut angles);
                let pairs = self.times.0.iter().zip(&angles).map(|(t, angle)| (t.wide(), angle.wide()));
                largest(truths.of(contestant.given), pairs)
            }
            Kind::Stepping(method) => {
                let interval = method.interval();
                let count = (STEPPED * self.period / interval).round() as usize;
                let mut angles = vec![R::zero(); count];
                method.follow(&mut angles);
                let pairs = (1..=count).zip(&angles).map(|(step, angle)| (step as f64 * interval, angle.wide()));
                largest(truths.of(contestant.given), pairs)
            }
        }
    }

    /// [`JOBS`] per contestant: the array loop, calls by themselves, one after the other, and the array loop with cold
    /// caches.
    pub fn jobs<'a>(&'a self, jobs: &mut Vec<Job<'a>>) {
        for contestant in &self.contestants {
            match &contestant.kind {
                Kind::AnyTime(function) => {
                    jobs.push(Job::new(COUNT, self.fill(function.as_ref())));
                    jobs.push(Job::new(COUNT, move || function.scalar(black_box(&self.times.0))));
                    jobs.push(Job::new(COUNT, move || {
                        black_box(function.chain(black_box(&self.times.0)));
                    }));
                    jobs.push(Job::cold(COUNT, self.fill(function.as_ref())));
                }
                Kind::Stepping(method) => {
                    jobs.push(Job::new(COUNT, self.step(method.as_ref())));
                    jobs.push(Job::new(COUNT, follow(method.as_ref())));
                    jobs.push(Job::new(COUNT, follow(method.as_ref())));
                    jobs.push(Job::cold(COUNT, self.step(method.as_ref())));
                }
            }
        }
    }

    /// The array loop over the times.
    fn fill<'a>(&'a self, function: &'a dyn AnyTime<R>) -> impl FnMut() + 'a {
        let mut angles = Box::new(Block([R::zero(); COUNT]));
        move || {
            function.fill(black_box(&self.times.0), &mut angles.0);
            black_box(&angles);
        }
    }

    /// A step of an ensemble, or where the method has none the trajectory.
    fn step<'a>(&self, method: &'a dyn Stepping<R>) -> Box<dyn FnMut() + 'a> {
        let mut ensemble = self.ensemble();
        if !method.advance(&mut ensemble) {
            return Box::new(follow(method));
        }
        Box::new(move || {
            method.advance(&mut ensemble);
            black_box(&ensemble);
        })
    }

    /// Pendula released from angles spread up to the amplitude.
    fn ensemble(&self) -> Vec<State<R>> {
        let mut random = Random::new(0xE15E);
        let mut state = || State { angle: R::of(self.amplitude.theta0() * random.unit()), velocity: R::zero() };
        (0..COUNT).map(|_| state()).collect()
    }

    /// Takes this field's share of the samples, in the order of `jobs`.
    fn outcomes(&self, errors: &[f64], samples: &mut impl Iterator<Item = Vec<f64>>) -> Vec<Outcome> {
        let mut next = || samples.next().unwrap_or_default();
        let mut timed = |_| Timed { array: next(), scalar: next(), single: next(), cold: next() };
        let timed: Vec<Timed> = self.contestants.iter().map(&mut timed).collect();
        let unit = self.contestants.iter().position(|one| one.family == Family::Yardstick).unwrap_or(0);
        let outcome = |(index, contestant)| self.outcome(contestant, errors[index], &timed[index], &timed[unit]);
        self.contestants.iter().enumerate().map(outcome).collect()
    }

    fn outcome(&self, contestant: &Contestant<R>, error: f64, timed: &Timed, unit: &Timed) -> Outcome {
        let single = Spread::of(timed.single.iter().copied());
        let random_access = match &contestant.kind {
            Kind::AnyTime(_) => None,
            Kind::Stepping(method) => Some(single.median * 0.5 * HORIZON * self.period / method.interval()),
        };
        Outcome {
            amplitude: self.amplitude,
            precision: R::NAME,
            family: contestant.family,
            name: contestant.name.clone(),
            setting: contestant.setting.clone(),
            error,
            array: Spread::of(timed.array.iter().copied()),
            scalar: Spread::of(timed.scalar.iter().copied()),
            single,
            cold: Spread::of(timed.cold.iter().copied()),
            array_ratio: Spread::of_ratios(&timed.array, &unit.array),
            scalar_ratio: Spread::of_ratios(&timed.scalar, &unit.scalar),
            single_ratio: Spread::of_ratios(&timed.single, &unit.single),
            random_access,
            timed: timed.clone(),
        }
    }
}

/// The samples of one contestant, in ns per value, one per round.
#[derive(Clone, Debug)]
pub struct Timed {
    /// In the array loop.
    pub array: Vec<f64>,
    /// In calls by themselves.
    pub scalar: Vec<f64>,
    /// One call after the other.
    pub single: Vec<f64>,
    /// In the array loop with cold caches.
    pub cold: Vec<f64>,
}

impl Session {
    /// Measures everything; `progress` is told what is being done.
    pub fn run(&self, effort: Effort, mut progress: impl FnMut(&str)) -> Vec<Outcome> {
        progress("errors");
        let double_errors: Vec<_> = self.doubles.iter().map(Field::errors).collect();
        let single_errors: Vec<_> = self.singles.iter().map(Field::errors).collect();
        let mut jobs = Vec::new();
        self.doubles.iter().for_each(|field| field.jobs(&mut jobs));
        self.singles.iter().for_each(|field| field.jobs(&mut jobs));
        race(&mut jobs, effort, |round, rounds| progress(&format!("round {round} of {rounds}")));
        let mut samples = jobs.into_iter().map(|job| job.samples);
        let mut outcomes = Vec::new();
        for (field, errors) in self.doubles.iter().zip(&double_errors) {
            outcomes.extend(field.outcomes(errors, &mut samples));
        }
        for (field, errors) in self.singles.iter().zip(&single_errors) {
            outcomes.extend(field.outcomes(errors, &mut samples));
        }
        outcomes
    }
}
