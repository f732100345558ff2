//! What a sum of harmonics is rounded by, and what is made of it: the errors of its cosine and sine, and of the recurrence
//! (`recurrence.rs`), passed on with what is known of the sums between two phases.

use super::recurrence::Recurrence;
use super::{ARGUMENT, COSINE, Harmonics, SINE, SLOPE, Sines};
use crate::plan::cosines::{Cosines, Local};
use crate::plan::phases::{SLICES, over_phases};
use crate::plan::polynomial::Polynomial;
use crate::plan::reduction::{Origin, Reduction};
use crate::program::rounding::Known;
use crate::program::{Program, RESULT};
use crate::supremum::by_halves;
use pendulum_runtime::double::Double;

/// How often slices are halved where the rounding peaks.
const MOST_HALVED: usize = 200;

impl Harmonics {
    /// The rounding over the whole range of the phase; some number above `cap` as soon as it is known to be, but where it
    /// peaks.
    pub(in crate::plan) fn rounding(&self, program: &Program, reduction: &Reduction, cap: f64) -> f64 {
        let sums = self.sums(reduction, self.errors(reduction));
        let phase = reduction.origin.phase();
        let names: Vec<&str> = sums.iter().map(|sum| sum.name).chain([phase]).collect();
        let closed = program.after_named(&names);
        // A sum of few terms that is the result itself is analysed better step by step.
        let by_steps = (!self.is_of_paper()).then(|| self.by_steps(program, phase));
        let in_closed_form = |low: f64, high: f64| {
            let known_sums = sums.iter().map(|sum| (sum.name, sum.known(reduction, low, high)));
            let known: Vec<(&str, Known)> = known_sums.chain([(phase, Known::between(low, high))]).collect();
            closed.rounding_given(&known)
        };
        let between = |low: f64, high: f64| {
            let closed = in_closed_form(low, high);
            by_steps.as_ref().map_or(closed, |by_steps| closed.min(by_steps(low, high)))
        };
        if self.peaks() {
            return by_halves(reduction.range(), SLICES, MOST_HALVED, between);
        }
        over_phases(reduction, cap, between)
    }

    /// What a sum that is the result is wrong by between two phases, operation by operation. What the polynomials of the
    /// cosine and the sine differ by from them is no rounding: it is added to their errors and passed on with these.
    fn by_steps(&self, program: &Program, phase: &'static str) -> impl Fn(f64, f64) -> f64 {
        let sine = self.sines().map(|Sines { sine, .. }| (SINE, sine));
        let all = [Some((COSINE, &self.cosine)), sine].into_iter().flatten();
        let waves: Vec<NamedWave> = all.filter_map(|(name, wave)| NamedWave::of(program, name, wave, phase)).collect();
        // The wave that the sum is a multiple of is the result itself, and has no other name, if its weight is 1.
        let (name, factor) = sine.unwrap_or((COSINE, &self.cosine));
        let of_result = if program.named(name).is_some() { 0.0 } else { factor.truncation };
        let rest = program.after_named(&[COSINE, SINE, phase]);
        move |low: f64, high: f64| {
            let phase = (phase, Known::between(low, high));
            let known: Vec<(&str, Known)> =
                waves.iter().map(|wave| (wave.name, wave.known(phase))).chain([phase]).collect();
            rest.rounding_given(&known) + of_result
        }
    }

    /// The errors of the cosine, or of the sum of cosines that is computed in its place, and of the sine.
    fn errors(&self, reduction: &Reduction) -> [f64; 2] {
        let error = |polynomial: &Polynomial| polynomial.rounding(reduction, f64::INFINITY) + polynomial.truncation;
        let cosine = self.folded().unwrap_or(&self.cosine);
        [error(cosine), self.sines().map_or(0.0, |sines| error(&sines.sine))]
    }

    /// The sums that the program computes, given the errors of the cosine and the sine.
    fn sums(&self, reduction: &Reduction, [cosine, sine]: [f64; 2]) -> Vec<AnalysedSum> {
        let sum = |name, curve, order, weights: &[Double], sine: Option<f64>| {
            let name = if self.is_of_paper() { name } else { RESULT };
            let recurrence = || Error::Recurrence(Recurrence::new(weights, cosine, sine, reduction.float));
            let error = if self.folded().is_some() { Error::Everywhere(cosine) } else { recurrence() };
            AnalysedSum { name, curve, order, error }
        };
        let of_cosines = self.cosines().map(|weights| sum(ARGUMENT, Cosines::odd(weights), 0, weights, None));
        let of_sines = self
            .sines()
            .map(|Sines { weights, .. }| sum(SLOPE, Cosines::integral_of_sines(weights), 1, weights, Some(sine)));
        of_cosines.into_iter().chain(of_sines).collect()
    }
}

/// The cosine or the sine of the phase in a program.
struct NamedWave {
    name: &'static str,
    /// What computes it.
    program: Program,
    /// What its polynomial differs by from it.
    truncation: f64,
}

impl NamedWave {
    /// `None` if the program has no node of that name.
    fn of(program: &Program, name: &'static str, polynomial: &Polynomial, phase: &str) -> Option<Self> {
        program.named(name)?;
        let program = program.up_to(name).after_named(&[phase]);
        Some(Self { name, program, truncation: polynomial.truncation })
    }

    /// What is known of it, given what is of the phase.
    fn known(&self, (phase, known): (&str, Known)) -> Known {
        let given = self.program.named(phase).map(|id| (id, known));
        let Known { low, high, error, .. } = self.program.rounding(given.as_slice())[0];
        Known::within(low, high, error + self.truncation)
    }
}

/// A sum that a program computes, as the analysis of its rounding knows it.
struct AnalysedSum {
    name: &'static str,
    /// The sum is the derivative of this curve of the order below.
    curve: Cosines,
    order: usize,
    error: Error,
}

/// How wrong a sum is: the same for all phases, or as its recurrence makes it.
enum Error {
    Everywhere(f64),
    Recurrence(Recurrence),
}

impl Error {
    fn between(&self, low: f64, high: f64, known: &Local) -> f64 {
        match self {
            Self::Everywhere(error) => *error,
            Self::Recurrence(recurrence) => recurrence.error(low, high, known),
        }
    }
}

impl AnalysedSum {
    /// What is known of it where the phase is between `low` and `high`, for [`crate::program::Program::rounding`].
    fn known(&self, reduction: &Reduction, low: f64, high: f64) -> Known {
        let from_anchor = |phase: f64| {
            let phase = phase * reduction.unit.hi;
            if reduction.origin == Origin::Anchor { phase } else { 0.5 - phase }
        };
        let (low, high) = (from_anchor(low), from_anchor(high));
        let known = self.curve.over(low, high);
        let error = self.error.between(low, high, &known);
        let (low, high) = known.range(self.order);
        Known::within(low - error, high + error, error)
    }
}

#[cfg(test)]
mod tests;
