//! Sums of harmonics of one cosine, evaluated by Clenshaw's recurrence: the paper's θ̂ (Eq. 22) and what follows from
//! it, and the series of θ and of its derivatives (Eq. 17 being its shape with one term).
//!
//! With X = 2 cos 2φ and uₙ = wₙ + X·uₙ₊₁ − uₙ₊₂, Σ wₙ cos((2n−1)φ) = cos φ·(u₁ − u₂) and
//! Σ wₙ sin((2n−1)φ) = sin φ·(u₁ + u₂). Errors of the recurrence add, they don't multiply (`recurrence.rs`).

mod recurrence;

use super::arcsine::Arcsine;
use super::cosines::{Cosines, Local};
use super::phases::{CELLS, over_phases};
use super::polynomial::Polynomial;
use super::reduction::{Origin, Reduction};
use super::variables::Variables;
use crate::program::rounding::Known;
use crate::program::{Builder, Id, Op, Program, RESULT};
use crate::series::Parity;
use crate::supremum::by_halves;
use pendulum_runtime::double::Double;
use recurrence::Recurrence;

/// How one output is made of sums of harmonics.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Harmonics {
    /// cos πs, without sign.
    pub(crate) cosine: Polynomial,
    pub(crate) made: Made,
}

/// Of which sums, and what of them. The sum of cosines of the paper's formula is y = sin(θ̂/2).
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Made {
    /// Σ wₙ cos((2n−1)πs) with these weights.
    Cosines(Vec<Double>),
    /// Σ wₙ sin((2n−1)πs).
    Sines(Sines),
    /// θ̂′ = 2y′/√(1 − y²), of the weights of y and the sum 2y′.
    Slope { cosines: Vec<Double>, sines: Sines },
    /// What follows from y alone.
    OfSine(OfSine),
}

/// A sum of sines.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sines {
    /// sin πs, without sign.
    pub(crate) sine: Polynomial,
    pub(crate) weights: Vec<Double>,
}

/// What follows from y = sin(θ̂/2) alone.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct OfSine {
    /// Weights of the cosines.
    pub(crate) cosines: Vec<Double>,
    /// Their sum as one polynomial, where that is as accurate as the recurrence: its chain of operations is the shorter.
    pub(crate) folded: Option<Polynomial>,
    /// −1 for a mirror image, whose sum is not mirrored.
    pub(crate) direction: f64,
    pub(crate) formula: Formula,
}

/// The output, of y = sin(θ̂/2).
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Formula {
    /// θ̂ = 2 arcsin y.
    Angle(Arcsine),
    /// −ω² sin θ̂ = −2ω²y√(1 − y²), given ω².
    Acceleration(Double),
    /// sin θ̂ = 2y√(1 − y²) and −cos θ̂ = 2y² − 1.
    Position,
}

/// How often slices are halved where the rounding peaks.
const MOST_HALVED: usize = 200;

/// The cosine and the sine of the phase, and the sums, whose ranges the analysis of the rounding knows.
const COSINE: &str = "cosine";
const SINE: &str = "sine";
const ARGUMENT: &str = "argument";
const SLOPE: &str = "slope";

impl Harmonics {
    pub(super) fn is_odd(&self) -> bool {
        self.sines().is_some()
    }

    /// Weights of the cosines, where they are summed up.
    fn cosines(&self) -> Option<&[Double]> {
        match &self.made {
            Made::Cosines(cosines) | Made::Slope { cosines, .. } | Made::OfSine(OfSine { cosines, .. }) => {
                Some(cosines)
            }
            Made::Sines(_) => None,
        }
    }

    fn sines(&self) -> Option<&Sines> {
        match &self.made {
            Made::Sines(sines) | Made::Slope { sines, .. } => Some(sines),
            Made::Cosines(_) | Made::OfSine(_) => None,
        }
    }

    /// The sum of cosines as one polynomial, where it is one.
    fn folded(&self) -> Option<&Polynomial> {
        if let Made::OfSine(OfSine { folded, .. }) = &self.made { folded.as_ref() } else { None }
    }

    /// Whether the rounding has a narrow peak: where y comes near 1, of what a root of 1 − y² makes of it.
    fn peaks(&self) -> bool {
        match &self.made {
            Made::Cosines(_) | Made::Sines(_) => false,
            Made::Slope { .. } => true,
            Made::OfSine(OfSine { formula, .. }) => !matches!(formula, Formula::Angle(_)),
        }
    }

    /// Whether the sum of cosines is that of the paper's formula.
    fn is_of_paper(&self) -> bool {
        matches!(self.made, Made::Slope { .. } | Made::OfSine(_))
    }

    pub(super) fn terms(&self) -> usize {
        self.cosines().or(self.sines().map(|sines| sines.weights.as_slice())).map_or(0, <[Double]>::len)
    }

    pub(super) fn describe(&self) -> String {
        let harmonics = harmonics(self.terms());
        let sum = match self.folded() {
            Some(folded) => format!("{harmonics} folded into a {}", folded.describe()),
            None => format!("{harmonics} by recurrence from one cosine of {} terms", self.cosine.terms()),
        };
        let made = match &self.made {
            Made::Cosines(_) | Made::Sines(_) => String::new(),
            Made::OfSine(OfSine { formula: Formula::Angle(arcsine), .. }) => {
                format!(", an arcsine by a polynomial of {} terms", arcsine.terms())
            }
            Made::Slope { .. } | Made::OfSine(_) => ", a square root".to_owned(),
        };
        sum + &made
    }

    /// Emits the output; a position has two results.
    pub(super) fn lower(&self, b: &mut Builder, variables: &Variables, name: &'static str) -> Vec<Id> {
        let (unsigned, height) = match &self.made {
            Made::Cosines(_) => (self.argument(b, variables), None),
            Made::Sines(sines) => {
                let cosine = self.cosine(b, variables);
                (sines.lower(b, variables, cosine), None)
            }
            Made::Slope { cosines, sines } => {
                let cosine = self.cosine(b, variables);
                let slope = sines.lower(b, variables, cosine);
                let y = sum_of_cosines(b, cosine, cosines);
                let root = root_of_rest(b, y);
                (b.div(slope, root), None)
            }
            Made::OfSine(of_sine) => {
                let y = self.argument(b, variables);
                of_sine.lower(b, y)
            }
        };
        b.name(unsigned, if height.is_some() { "x" } else { name });
        let parity = if self.is_odd() { Parity::Odd } else { Parity::Even };
        let signed = variables.signed(b, unsigned, true, parity);
        [signed].into_iter().chain(height).collect()
    }

    fn cosine(&self, b: &mut Builder, variables: &Variables) -> Id {
        let cosine = self.cosine.magnitude(b, variables);
        b.name(cosine, COSINE)
    }

    /// The sum of cosines, of which there is nothing else.
    fn argument(&self, b: &mut Builder, variables: &Variables) -> Id {
        if let Some(folded) = self.folded() {
            let sum = folded.magnitude(b, variables);
            return b.name(sum, ARGUMENT);
        }
        let cosine = self.cosine(b, variables);
        sum_of_cosines(b, cosine, self.cosines().unwrap_or_default())
    }

    /// The rounding over the whole range of the phase; some number above `cap` as soon as it is known to be, but where it
    /// peaks.
    pub(super) fn rounding(&self, program: &Program, reduction: &Reduction, cap: f64) -> f64 {
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
            return by_halves(reduction.range(), CELLS * CELLS, MOST_HALVED, between);
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

impl Sines {
    /// The sum, without the sign of the phase.
    fn lower(&self, b: &mut Builder, variables: &Variables, cosine: Id) -> Id {
        let sine = self.sine.magnitude(b, variables);
        b.name(sine, SINE);
        let (first, second) = clenshaw(b, cosine, &self.weights);
        let sum = second.map_or(first, |second| b.add(first, second));
        let slope = b.mul(sine, sum);
        b.name(slope, SLOPE)
    }
}

impl OfSine {
    /// The result that takes the sign of the phase, and the height of a position.
    fn lower(&self, b: &mut Builder, y: Id) -> (Id, Option<Id>) {
        match &self.formula {
            Formula::Angle(arcsine) => (arcsine.lower(b, y, self.direction), None),
            Formula::Acceleration(square) => (self.sine_of_angle(b, y, -*square), None),
            Formula::Position => {
                let x = self.sine_of_angle(b, y, Double::ONE);
                let (square, one) = (b.mul(y, y), b.constant(1.0));
                let twice = b.add(square, square);
                let height = b.sub(twice, one);
                (x, Some(b.name(height, "y")))
            }
        }
    }

    /// factor·sin θ̂, mirrored or not.
    fn sine_of_angle(&self, b: &mut Builder, y: Id, factor: Double) -> Id {
        let twice = b.rounded(factor * (2.0 * self.direction));
        let (root, twice) = (root_of_rest(b, y), b.mul(y, twice));
        b.mul(twice, root)
    }
}

fn sum_of_cosines(b: &mut Builder, cosine: Id, weights: &[Double]) -> Id {
    let (first, second) = clenshaw(b, cosine, weights);
    let difference = second.map_or(first, |second| b.sub(first, second));
    let sum = b.mul(cosine, difference);
    b.name(sum, ARGUMENT)
}

/// So many, for the reader.
pub(super) fn harmonics(count: usize) -> String {
    if count == 1 { "one harmonic".to_owned() } else { format!("{count} harmonics") }
}

/// √((1 − y)(1 + y)), cos(θ̂/2).
fn root_of_rest(b: &mut Builder, y: Id) -> Id {
    let one = b.constant(1.0);
    let (below, above) = (b.sub(one, y), b.add(one, y));
    let product = b.mul(below, above);
    b.push(Op::Root(product))
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

/// u₁ and u₂ of the recurrence; of a single weight there is no u₂, which is 0.
fn clenshaw(b: &mut Builder, cosine: Id, weights: &[Double]) -> (Id, Option<Id>) {
    let constants: Vec<Id> = weights.iter().map(|&weight| b.rounded(weight)).collect();
    let Some((&last, rest)) = constants.split_last() else { return (b.constant(0.0), None) };
    let square = b.mul(cosine, cosine);
    let (four, two) = (b.constant(4.0), b.constant(2.0));
    let fourfold = b.mul(square, four);
    let x = b.sub(fourfold, two);
    b.name(x, "twice_cosine_of_double");
    let (mut here, mut before) = (last, None);
    for &weight in rest.iter().rev() {
        let product = b.mul(x, here);
        let sum = b.add(weight, product);
        let next = before.map_or(sum, |before| b.sub(sum, before));
        (before, here) = (Some(here), next);
    }
    (here, before)
}

#[cfg(test)]
mod tests;
