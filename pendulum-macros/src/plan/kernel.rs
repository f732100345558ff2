//! Kernels: what computes one output from the reduced phase; and the functions made of them.

use super::harmonics::Harmonics;
use super::passage::Passage;
use super::phases::rounding_of;
use super::pieces::{Complement, Halves, Pieces};
use super::polynomial::Polynomial;
use super::reduction::{Mirror, Reduction};
use super::turning::Finish;
use super::variables::Variables;
use super::{Function, Part};
use crate::parse::Output;
use crate::program::{Builder, Id, Op, Program, RESULT};
use crate::series::Parity;

/// The computation of one output.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Kernel {
    pub(crate) core: Core,
    pub(crate) finish: Finish,
}

/// What is computed of the phase.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Core {
    /// The output itself, as a polynomial or a quotient.
    Polynomial(Box<Polynomial>),
    /// sin θ and −cos θ from sin(θ/2) and cos(θ/2): the square of a point of the unit circle.
    Circle(Box<[Polynomial; 2]>),
    /// A polynomial for each part of the period.
    Pieces(Box<Pieces>),
    /// As [`Self::Circle`], of such factors.
    Halves(Box<Halves>),
    /// Twice the arcsine of such a curve, by its complement.
    Complement(Box<Complement>),
    /// A sum of harmonics of one cosine.
    Harmonics(Box<Harmonics>),
    /// The passage through the lowest point of a motion that comes near the top.
    Passage(Box<Passage>),
}

impl From<Core> for Kernel {
    fn from(core: Core) -> Self {
        Self { core, finish: Finish::Nothing }
    }
}

impl Kernel {
    /// Whether it is a passage, the errors of whose series count as of evaluation.
    pub(crate) fn is_passage(&self) -> bool {
        matches!(self.core, Core::Passage(_))
    }

    /// The norm of the rounding of its results over the whole range of the phase, taken as exact, without that of turns;
    /// some number above `cap` as soon as it is known to be.
    pub(crate) fn rounding(&self, reduction: &Reduction, cap: f64) -> f64 {
        self.finish.rounding(self.core.rounding(reduction, cap), reduction.float)
    }

    /// The polynomial, if the output is that and nothing is done to it afterwards.
    pub(super) fn polynomial(&self) -> Option<&Polynomial> {
        match self {
            Self { core: Core::Polynomial(polynomial), finish: Finish::Nothing } => Some(polynomial),
            _ => None,
        }
    }
}

impl Core {
    /// Emits it; a position has two results.
    fn lower(&self, b: &mut Builder, variables: &Variables, name: &'static str) -> Vec<Id> {
        match self {
            Self::Polynomial(polynomial) => vec![polynomial.lower(b, variables, name)],
            Self::Circle(factors) => circle(b, variables, factors).to_vec(),
            Self::Pieces(pieces) => vec![pieces.lower(b, name)],
            Self::Halves(halves) => halves.lower(b),
            Self::Complement(complement) => vec![complement.lower(b, name)],
            Self::Harmonics(harmonics) => harmonics.lower(b, variables, name),
            Self::Passage(passage) => passage.lower(b, variables, name),
        }
    }

    /// Whether it needs the sign of the phase.
    fn is_odd(&self) -> bool {
        match self {
            Self::Polynomial(polynomial) => polynomial.parity == Parity::Odd,
            Self::Circle(factors) => factors.iter().any(|factor| factor.parity == Parity::Odd),
            Self::Harmonics(harmonics) => harmonics.is_odd(),
            Self::Passage(_) | Self::Pieces(_) | Self::Halves(_) | Self::Complement(_) => false,
        }
    }

    /// Whether it changes its sign with the time's, of a release from rest.
    fn is_odd_in_time(&self) -> bool {
        match self {
            Self::Passage(passage) => passage.output == Output::Velocity,
            Self::Pieces(pieces) => pieces.parity == Parity::Odd,
            _ => self.is_odd(),
        }
    }

    /// Whether it has a phase of its own, to the nearest piece.
    fn is_in_pieces(&self) -> bool {
        self.rows().is_some()
    }

    /// How many rows the table has whose row its phase tells, if there is one: in one function all have as many.
    pub(crate) fn rows(&self) -> Option<usize> {
        match self {
            Self::Pieces(pieces) => Some(pieces.count()),
            Self::Halves(halves) => Some(halves.sine.count()),
            Self::Complement(complement) => Some(complement.count()),
            _ => None,
        }
    }

    /// The method, in a word.
    pub(crate) fn word(&self) -> &'static str {
        match self {
            Self::Polynomial(_) | Self::Circle(_) => "polynomial",
            Self::Pieces(_) | Self::Halves(_) | Self::Complement(_) => "pieces",
            Self::Harmonics(_) => "harmonics",
            Self::Passage(_) => "passage",
        }
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        match self {
            Self::Polynomial(polynomial) => polynomial.describe(),
            Self::Circle(factors) => {
                let [sine, cosine] = factors.each_ref().map(Polynomial::describe);
                format!("sin(θ/2) by a {sine}, cos(θ/2) by a {cosine}, squared")
            }
            Self::Pieces(pieces) => pieces.describe(),
            Self::Halves(halves) => halves.describe(),
            Self::Complement(complement) => complement.describe(),
            Self::Harmonics(harmonics) => harmonics.describe(),
            Self::Passage(passage) => passage.describe(),
        }
    }

    /// Terms of the (first) polynomial, or harmonics.
    pub(crate) fn terms(&self) -> usize {
        match self {
            Self::Polynomial(polynomial) => polynomial.terms(),
            Self::Circle(factors) => factors[0].terms(),
            Self::Pieces(pieces) => pieces.terms(),
            Self::Halves(halves) => halves.sine.terms(),
            Self::Complement(complement) => complement.terms(),
            Self::Harmonics(harmonics) => harmonics.terms(),
            Self::Passage(passage) => passage.terms(),
        }
    }

    /// Those of each polynomial, if it is made of some.
    pub(super) fn terms_of_each(&self) -> Vec<usize> {
        match self {
            Self::Polynomial(polynomial) => vec![polynomial.terms()],
            Self::Circle(factors) => factors.iter().map(Polynomial::terms).collect(),
            _ => Vec::new(),
        }
    }

    /// As [`Kernel::rounding`].
    pub(super) fn rounding(&self, reduction: &Reduction, cap: f64) -> f64 {
        let whole = || program(reduction, &[(self, &Finish::Nothing)]);
        match self {
            Self::Pieces(pieces) => pieces.rounding(),
            Self::Halves(halves) => halves.rounding(),
            Self::Complement(complement) => complement.rounding(),
            Self::Passage(passage) => passage.rounding(&whole(), cap),
            Self::Harmonics(harmonics) => harmonics.rounding(&whole(), reduction, cap),
            Self::Polynomial(polynomial) => polynomial.rounding(reduction, cap),
            Self::Circle(factors) => {
                rounding_of(reduction, self.is_odd(), cap, |b, variables| circle(b, variables, factors).to_vec())
            }
        }
    }
}

/// The position without the signs of its factors' phase.
fn circle(b: &mut Builder, variables: &Variables, [sine, cosine]: &[Polynomial; 2]) -> [Id; 2] {
    let (half_sine, half_cosine) = (sine.one_of_two(b, variables), cosine.one_of_two(b, variables));
    b.name(half_sine, "half_sine");
    b.name(half_cosine, "half_cosine");
    let [x, y] = squared(b, half_sine, half_cosine);
    // Of factors one of which is odd the product is.
    let parity = if cosine.parity == Parity::Odd { Parity::Odd } else { sine.parity };
    [variables.signed(b, x, sine.alternates, parity), y]
}

/// With S = sin(θ/2) and C = cos(θ/2): sin θ = 2SC and −cos θ = S² − C².
pub(super) fn squared(b: &mut Builder, half_sine: Id, half_cosine: Id) -> [Id; 2] {
    let product = b.mul(half_sine, half_cosine);
    let x = b.add(product, product);
    b.name(x, "x");
    let (sine_squared, cosine_squared) = (b.mul(half_sine, half_sine), b.mul(half_cosine, half_cosine));
    let y = b.sub(sine_squared, cosine_squared);
    [x, b.name(y, "y")]
}

/// One function of the time, the kernels' results its own.
pub(super) fn function(reduction: &Reduction, kernels: &[&Kernel]) -> Program {
    let kernels: Vec<_> = kernels.iter().map(|Kernel { core, finish }| (core, finish)).collect();
    program(reduction, &kernels)
}

/// The same of cores and how they finish.
fn program(reduction: &Reduction, kernels: &[(&Core, &Finish)]) -> Program {
    const NAMES: [&str; 2] = ["first_result", "second_result"];
    let mut b = Builder::new(reduction.float);
    let t = b.input();
    let reduction = &mirroring(reduction, kernels);
    let phase = reduction.lower(&mut b, t);
    let odd = kernels.iter().any(|(core, _)| core.is_odd());
    let alone = kernels.len() == 1;
    let variables = Variables { alone, ..Variables::lower(&mut b, phase, reduction, odd) };
    let names = if alone { [RESULT; 2] } else { NAMES };
    let mut results = Vec::new();
    for (&(core, finish), name) in kernels.iter().zip(names) {
        let values = core.lower(&mut b, &variables, name);
        let finished = finish.lower(&mut b, &variables, values);
        let turned = reduction.mirror == Mirror::Magnitude && core.is_odd_in_time();
        results.extend(finished.into_iter().map(|x| if turned { b.push(Op::Along { x, sign: t }) } else { x }));
    }
    b.finish(results)
}

/// With the signs of phases if any result needs them. Pieces are those of magnitudes, and share their phase with the
/// others.
fn mirroring(reduction: &Reduction, kernels: &[(&Core, &Finish)]) -> Reduction {
    let odd_in_time = kernels.iter().any(|(core, _)| core.is_odd_in_time());
    let in_pieces = kernels.iter().any(|(core, _)| core.is_in_pieces());
    reduction.with_signs(odd_in_time && !in_pieces)
}

/// A function per output, and `state` for θ and velocity together.
pub(super) fn functions(reduction: &Reduction, parts: &[Part]) -> Vec<Function> {
    let single = |part: &Part| Function { output: Some(part.output), program: function(reduction, &[&part.kernel]) };
    let mut functions: Vec<Function> = parts.iter().map(single).collect();
    let of = |output| parts.iter().find(|part| part.output == output);
    if let (Some(theta), Some(velocity)) = (of(Output::Theta), of(Output::Velocity)) {
        let program = function(reduction, &[&theta.kernel, &velocity.kernel]);
        functions.push(Function { output: None, program });
    }
    functions
}
