//! What plans are to cost at most, beside what was reached.

use std::fmt::Write as _;

use crate::amplitude::Amplitude;
use crate::contestant::label;
use crate::machine;
use crate::ours::{ANY_TIME, FULL, PAPER, PLANNED, RUNTIME, STATE};
use crate::peers::AS_WRITTEN;
use crate::race::Spread;
use crate::session::{Outcome, Timed};

/// How an entry is called.
#[derive(Clone, Copy)]
enum Call {
    Array,
    Scalar,
    Single,
}

/// The most that the cost of an entry may be, as a multiple of another's, at 7π/8 in the same run.
struct Target {
    precision: &'static str,
    entry: (&'static str, &'static str),
    unit: (&'static str, &'static str),
    call: Call,
    /// On the baseline of x86-64, and with AVX2.
    limits: [f64; 2],
}

const fn target(
    entry: (&'static str, &'static str),
    unit: (&'static str, &'static str),
    call: Call,
    limits: [f64; 2],
) -> Target {
    Target { precision: "f64", entry, unit, call, limits }
}

const SINE: (&str, &str) = ("f64::sin", "");
/// A plan with a horizon of 100 periods, and θ with θ̇ to the same tolerance.
const MICRO: &str = "tol 1e-6";
const NANO: &str = "tol 1e-9";
const PICO: &str = "tol 1e-12";
/// θ and θ̇ together, in units of θ alone, are to cost at most this.
const BOTH: [f64; 2] = [1.5; 2];
/// The paper's θ̂ with four terms, in units of the formula as written.
const GENERATED: [f64; 2] = [0.35; 2];

const TARGETS: [Target; 23] = [
    target((PLANNED, MICRO), SINE, Call::Array, [0.30, 0.17]),
    target((PLANNED, NANO), SINE, Call::Array, [0.42, 0.22]),
    target((PLANNED, PICO), SINE, Call::Array, [0.55, 0.30]),
    target((ANY_TIME, FULL), SINE, Call::Array, [1.1, 0.56]),
    Target {
        precision: "f32",
        entry: (PLANNED, "tol 1e-4"),
        unit: ("f32::sin", ""),
        call: Call::Array,
        limits: [0.20, 0.08],
    },
    target((PLANNED, MICRO), SINE, Call::Single, [0.8; 2]),
    target((PAPER, "n = 4"), (AS_WRITTEN, "N = 4"), Call::Array, GENERATED),
    target((PAPER, "n = 4"), (AS_WRITTEN, "N = 4"), Call::Scalar, GENERATED),
    target((PAPER, "n = 4"), (AS_WRITTEN, "N = 4"), Call::Single, GENERATED),
    target((STATE, MICRO), (PLANNED, MICRO), Call::Array, BOTH),
    target((STATE, MICRO), (PLANNED, MICRO), Call::Scalar, BOTH),
    target((STATE, MICRO), (PLANNED, MICRO), Call::Single, BOTH),
    target((STATE, NANO), (PLANNED, NANO), Call::Array, BOTH),
    target((STATE, NANO), (PLANNED, NANO), Call::Scalar, BOTH),
    target((STATE, NANO), (PLANNED, NANO), Call::Single, BOTH),
    target((STATE, PICO), (PLANNED, PICO), Call::Array, BOTH),
    target((STATE, PICO), (PLANNED, PICO), Call::Scalar, BOTH),
    target((STATE, PICO), (PLANNED, PICO), Call::Single, BOTH),
    target((STATE, FULL), (ANY_TIME, FULL), Call::Array, BOTH),
    target((STATE, FULL), (ANY_TIME, FULL), Call::Scalar, BOTH),
    target((STATE, FULL), (ANY_TIME, FULL), Call::Single, BOTH),
    // 60 ns where GSL takes 131.
    target((RUNTIME, ""), ("GSL", ""), Call::Scalar, [0.46; 2]),
    target((RUNTIME, ""), ("GSL", ""), Call::Single, [0.7; 2]),
];

impl Target {
    /// `None` where there is no target.
    fn limit(&self, machine: &str) -> Option<f64> {
        let [baseline, avx2] = self.limits;
        match machine {
            "x86-64" => Some(baseline),
            "x86-64-v3" | "x86-64-v4" => Some(avx2),
            _ => None,
        }
    }

    /// `None` where one of the two was not measured.
    fn reached(&self, outcomes: &[Outcome]) -> Option<Spread> {
        let timed = |(name, setting)| {
            let at = |one: &&Outcome| one.amplitude == Amplitude::LARGE && one.precision == self.precision;
            let one = outcomes.iter().filter(at).find(|one| one.name == name && one.setting == setting)?;
            Some(self.samples(&one.timed))
        };
        Some(Spread::of_ratios(timed(self.entry)?, timed(self.unit)?))
    }

    fn samples<'a>(&self, timed: &'a Timed) -> &'a [f64] {
        match self.call {
            Call::Array => &timed.array,
            Call::Scalar => &timed.scalar,
            Call::Single => &timed.single,
        }
    }
}

/// A line per target of this machine: its limit, and the median and the quartiles over the rounds of what was reached.
pub fn table(outcomes: &[Outcome]) -> String {
    let mut text = String::from("| | in units of | called | at most | reached | |\n|---|---|---|--:|--:|---|\n");
    for target in &TARGETS {
        let Some(limit) = target.limit(machine::target()) else { continue };
        let Some(reached) = target.reached(outcomes) else { continue };
        let [entry, unit] = [target.entry, target.unit].map(|(name, setting)| label(name, setting));
        let call = match target.call {
            Call::Array => "array",
            Call::Scalar => "scalar",
            Call::Single => "single",
        };
        let _ = writeln!(
            text,
            "| {}{} | {} | {call} | {} | {:.3} ({:.3} to {:.3}) | {} |",
            entry,
            if target.precision == "f32" { ", f32" } else { "" },
            unit,
            limit,
            reached.median,
            reached.lower,
            reached.upper,
            if reached.median <= limit { "kept" } else { "**missed**" },
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::TARGETS;
    use crate::amplitude::Amplitude;
    use crate::contestant::Contestant;
    use crate::ours::ours;
    use crate::peers::{missing, peers};

    #[test]
    fn other_machines_have_no_targets() {
        let [target, ..] = &TARGETS;
        let [baseline, avx2] = target.limits.map(Some);
        let limits = ["x86-64", "x86-64-v3", "x86-64-v4", "aarch64"].map(|machine| target.limit(machine));
        assert_eq!(limits, [baseline, avx2, avx2, None]);
    }

    /// Whatever a target names is an entry, so that no line is left out of the table unnoticed.
    #[test]
    fn targets_are_about_entries() {
        let pair = |one: &Contestant<f64>| (one.name.clone(), one.setting.clone());
        let single = |one: &Contestant<f32>| (one.name.clone(), one.setting.clone());
        let mut doubles: Vec<_> = ours::<f64>(Amplitude::LARGE).iter().map(pair).collect();
        doubles.extend(peers::<f64>(Amplitude::LARGE).iter().map(pair));
        let mut singles: Vec<_> = ours::<f32>(Amplitude::LARGE).iter().map(single).collect();
        singles.extend(peers::<f32>(Amplitude::LARGE).iter().map(single));
        for target in &TARGETS {
            let entries = if target.precision == "f32" { &singles } else { &doubles };
            for (name, setting) in [target.entry, target.unit] {
                let there = entries.iter().filter(|entry| (entry.0.as_str(), entry.1.as_str()) == (name, setting));
                let absent = missing().iter().any(|peer| peer.name == name);
                assert_eq!(there.count(), usize::from(!absent), "{name}, {setting}");
            }
        }
    }
}
