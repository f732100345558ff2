//! Error against time elapsed: from one period to 10¹².

use std::fmt::Write as _;

use pendula_stress::random::Random;
use pendula_stress::truth::Truth;

use crate::amplitude::Amplitude;
use crate::contestant::{Contestant, Family, Kind};
use crate::real::Real;
use crate::report::fields;
use crate::truth::{Truths, largest};

/// Points per decade of elapsed time.
const PER_DECADE: i32 = 2;
/// Decades of elapsed time, in periods.
const DECADES: i32 = 12;
/// Times per point, all within one period.
const SAMPLES: usize = 200;

/// The errors of one contestant.
#[derive(Clone, Debug)]
pub struct Drift {
    /// Who made it.
    pub family: Family,
    /// What it is.
    pub name: String,
    /// Its settings.
    pub setting: String,
    /// Elapsed periods, and the largest error in rad in the period that follows.
    pub points: Vec<(f64, f64)>,
}

/// The errors of all but the yardstick; steppers stop after `steps` steps.
pub fn measure<R: Real>(amplitude: Amplitude, contestants: &[Contestant<R>], steps: usize) -> Vec<Drift> {
    let competing = contestants.iter().filter(|one| one.family != Family::Yardstick);
    let mut truths = Truths::new(amplitude);
    let drift = |one: &Contestant<R>| {
        let truth = truths.of(one.given);
        let period = truth.motion().period().to_f64();
        let points = match &one.kind {
            Kind::AnyTime(function) => elapsed()
                .map(|periods| {
                    let times = times_after(periods, period);
                    let mut angles = vec![R::zero(); SAMPLES];
                    function.fill(&times, &mut angles);
                    let pairs = times.iter().map(|t| t.wide()).zip(angles.iter().map(|angle| angle.wide()));
                    (periods, largest(truth, pairs))
                })
                .collect(),
            Kind::Stepping(method) => {
                let interval = method.interval();
                let mut angles = vec![R::zero(); steps];
                method.follow(&mut angles);
                stepped(&angles, interval, period, truth)
            }
        };
        Drift { family: one.family, name: one.name.clone(), setting: one.setting.clone(), points }
    };
    competing.map(drift).collect()
}

/// The elapsed times in periods.
fn elapsed() -> impl Iterator<Item = f64> {
    (0..=DECADES * PER_DECADE).map(|index| 10.0_f64.powf(f64::from(index) / f64::from(PER_DECADE)))
}

/// Random times within one period after so many.
fn times_after<R: Real>(periods: f64, period: f64) -> Vec<R> {
    let mut random = Random::new(periods.to_bits());
    (0..SAMPLES).map(|_| R::of((periods + random.unit()) * period)).collect()
}

/// The points of a trajectory, as far as it goes.
fn stepped<R: Real>(angles: &[R], interval: f64, period: f64, truth: &Truth) -> Vec<(f64, f64)> {
    let mut points = Vec::new();
    for periods in elapsed() {
        let (first, last) = ((periods * period / interval) as usize, ((periods + 1.0) * period / interval) as usize);
        let Some(window) = angles.get(first..last) else { break };
        // Angle number i belongs to the time (i + 1)·interval.
        let pairs = window.iter().enumerate().map(|(i, angle)| ((first + i + 1) as f64 * interval, angle.wide()));
        let stride = (window.len() / SAMPLES).max(1);
        points.push((periods, largest(truth, pairs.step_by(stride))));
    }
    points
}

/// One line per point.
pub fn csv(drifts: &[Drift]) -> String {
    let mut text = String::from("family,name,setting,periods,error\n");
    for drift in drifts {
        let entry = fields(drift.family, &drift.name, &drift.setting);
        for (periods, error) in &drift.points {
            let _ = writeln!(text, "{entry},{periods:.4e},{error:.3e}");
        }
    }
    text
}
