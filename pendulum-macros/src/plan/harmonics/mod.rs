//! Sums of harmonics of one cosine, evaluated by Clenshaw's recurrence: the paper's θ̂ (Eq. 22) and what follows from
//! it, and the series of θ and of its derivatives (Eq. 17 being its shape with one term).
//!
//! With X = 2 cos 2φ and uₙ = wₙ + X·uₙ₊₁ − uₙ₊₂, Σ wₙ cos((2n−1)φ) = cos φ·(u₁ − u₂) and
//! Σ wₙ sin((2n−1)φ) = sin φ·(u₁ + u₂). What these are rounded by is in `rounding.rs`.

mod recurrence;
mod rounding;

use super::arcsine::Arcsine;
use super::polynomial::Polynomial;
use super::variables::Variables;
use crate::program::{Builder, Id, Op};
use crate::series::Parity;
use pendulum_runtime::double::Double;

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

    /// Whether it is a quotient, infinite where the root that it is over vanishes.
    pub(super) fn is_quotient(&self) -> bool {
        matches!(self.made, Made::Slope { .. })
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
            Made::Cosines(weights) => {
                let cosine = self.cosine(b, variables);
                (sum_of_cosines(b, cosine, weights), None)
            }
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
                let y = self.argument(b, variables, of_sine);
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

    /// y, the argument of the arcsine.
    fn argument(&self, b: &mut Builder, variables: &Variables, OfSine { cosines, folded, .. }: &OfSine) -> Id {
        if let Some(folded) = folded {
            let sum = folded.magnitude(b, variables);
            return b.name(sum, ARGUMENT);
        }
        let cosine = self.cosine(b, variables);
        sum_of_cosines(b, cosine, cosines)
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
