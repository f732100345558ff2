//! Kernels: what computes one output from the reduced phase; and the functions made of them.

use super::harmonics::{Harmonics, Sum};
use super::hyperbolic::Hyperbolic;
use super::met::Met;
use super::pieces::Pieces;
use super::polynomial::Polynomial;
use super::reduction::{Origin, Reduction};
use super::turning::{Turning, modulo_turn, within_half_turn};
use super::variables::Variables;
use super::{Function, Part};
use crate::parse::Output;
use crate::program::rounding::{Known, half_ulp};
use crate::program::{Builder, Id, Op, Program};
use crate::series::Parity;
use crate::supremum::{by_halves, by_slices, norm, worst};
use std::f64::consts::PI;

/// The computation of one output.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Kernel {
    /// The output itself, as a polynomial or a quotient.
    Polynomial(Polynomial),
    /// sin θ and −cos θ from sin(θ/2) and cos(θ/2): the square of a point of the unit circle.
    Circle { sine: Polynomial, cosine: Polynomial },
    /// A polynomial for each part of the period.
    Pieces(Box<Pieces>),
    /// A sum of harmonics of one cosine.
    Harmonics(Box<Harmonics>),
    /// The passage through the lowest point of a motion that comes near the top.
    Hyperbolic(Box<Hyperbolic>),
    /// The angle of a rotation.
    Turning(Turning),
    /// An angle kept within [−π, π), near the top.
    Within(Box<Self>),
    /// One that may be up to a turn beyond that, wrapped.
    Wrapped(Box<Self>),
}

impl Kernel {
    /// Emits the kernel; a position has two results.
    pub(crate) fn lower(&self, b: &mut Builder, variables: &Variables, name: &'static str) -> Vec<Id> {
        match self {
            Self::Polynomial(polynomial) => vec![polynomial.lower(b, variables, name)],
            Self::Circle { sine, cosine } => circle(b, variables, sine, cosine),
            Self::Pieces(pieces) => vec![pieces.lower(b, name)],
            Self::Harmonics(harmonics) => vec![harmonics.lower(b, variables, name)],
            Self::Hyperbolic(hyperbolic) => hyperbolic.lower(b, variables, name),
            Self::Turning(turning) => vec![turning.lower(b, variables, name)],
            Self::Within(angle) => {
                let value = angle.lower(b, variables, name)[0];
                vec![within_half_turn(b, value)]
            }
            Self::Wrapped(angle) => {
                let value = angle.lower(b, variables, name)[0];
                vec![modulo_turn(b, value)]
            }
        }
    }

    /// Whether it needs the sign of the phase.
    fn is_odd(&self) -> bool {
        match self {
            Self::Polynomial(polynomial) => polynomial.parity == Parity::Odd,
            Self::Circle { sine, cosine } => [sine, cosine].iter().any(|factor| factor.parity == Parity::Odd),
            Self::Harmonics(harmonics) => harmonics.is_odd(),
            Self::Hyperbolic(_) | Self::Pieces(_) => false,
            Self::Turning(Turning { angle, .. }) | Self::Within(angle) | Self::Wrapped(angle) => angle.is_odd(),
        }
    }

    /// Whether it changes its sign with the time's, of a release from rest.
    fn is_odd_in_time(&self) -> bool {
        match self {
            Self::Hyperbolic(hyperbolic) => hyperbolic.output == Output::Velocity,
            _ => self.is_odd(),
        }
    }

    /// The method, in a word.
    pub(crate) fn word(&self) -> &'static str {
        match self {
            Self::Polynomial(_) | Self::Circle { .. } => "polynomial",
            Self::Pieces(_) => "pieces",
            Self::Harmonics(_) => "harmonics",
            Self::Hyperbolic(_) => "passage",
            Self::Turning(Turning { angle, .. }) | Self::Within(angle) | Self::Wrapped(angle) => angle.word(),
        }
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        match self {
            Self::Polynomial(polynomial) => polynomial.describe(),
            Self::Circle { sine, cosine } => {
                format!("sin(θ/2) by a {}, cos(θ/2) by a {}, squared", sine.describe(), cosine.describe())
            }
            Self::Pieces(pieces) => pieces.describe(),
            Self::Harmonics(harmonics) => harmonics.describe(),
            Self::Hyperbolic(hyperbolic) => hyperbolic.describe(),
            Self::Turning(Turning { angle, .. }) | Self::Within(angle) | Self::Wrapped(angle) => angle.describe(),
        }
    }

    /// Terms of the (first) polynomial, or harmonics.
    pub(crate) fn terms(&self) -> usize {
        match self {
            Self::Polynomial(polynomial) | Self::Circle { sine: polynomial, .. } => polynomial.terms(),
            Self::Pieces(pieces) => pieces.terms(),
            Self::Harmonics(harmonics) => harmonics.terms(),
            Self::Hyperbolic(hyperbolic) => hyperbolic.terms(),
            Self::Turning(Turning { angle, .. }) | Self::Within(angle) | Self::Wrapped(angle) => angle.terms(),
        }
    }

    /// What [`Self::rounding`] leaves out: the turns of a rotation's angle.
    pub(crate) fn rounding_of_turns(&self, reduction: &Reduction) -> f64 {
        if let Self::Turning(turning) = self { turning.own_rounding(reduction) } else { 0.0 }
    }

    /// The norm of the rounding of its results over the whole range of the phase, taken as exact; some number above
    /// `cap` as soon as it is known to be.
    pub(crate) fn rounding(&self, reduction: &Reduction, cap: f64) -> f64 {
        self.rounding_where(None, reduction, cap)
    }

    /// The same where a polynomial's phases are met, if elsewhere it is no more than there is room for.
    pub(crate) fn rounding_where(&self, met: Option<Met>, reduction: &Reduction, cap: f64) -> f64 {
        if let Self::Turning(Turning { angle, .. }) = self {
            return angle.rounding_where(met, reduction, cap);
        }
        if let Self::Within(angle) = self {
            // From the largest number that it may be to π itself it is 0.63 units of π in `f32`, 1.27 in `f64`: less than
            // this and the rounding of the angle's own last sum, half a unit.
            return angle.rounding_where(met, reduction, cap) + 2.0 * half_ulp(PI, reduction.float);
        }
        if let Self::Wrapped(angle) = self {
            // The sum with a turn, the turn's own rounding, and the distance from π of the largest number below it.
            return angle.rounding_where(met, reduction, cap) + 3.0 * half_ulp(2.0 * PI, reduction.float);
        }
        if let Self::Pieces(pieces) = self {
            return pieces.rounding();
        }
        let program = function(reduction, &[self]);
        if let Self::Hyperbolic(hyperbolic) = self {
            return hyperbolic.rounding(&program, cap);
        }
        let Some(phase) = program.named(reduction.origin.phase()) else { return f64::INFINITY };
        let [least, most] = reduction.range();
        let of_polynomial =
            |polynomial: &Polynomial| Self::Polynomial(polynomial.clone()).rounding(reduction, f64::INFINITY);
        let harmonics = if let Self::Harmonics(harmonics) = self { Some(harmonics.as_ref()) } else { None };
        let sums =
            harmonics.map_or_else(Vec::new, |harmonics| harmonics.sums(reduction, harmonics.errors(of_polynomial)));
        let given = |sums: &[Sum], low: f64, high: f64| {
            let mut known = vec![(phase, Known::between(low, high))];
            known.extend(
                sums.iter().filter_map(|sum| Some((program.named(sum.name)?, sum.known(reduction, low, high)))),
            );
            norm(program.rounding(&known).iter().map(|known| known.error))
        };
        // A sum of few terms that is the result itself is analysed better step by step.
        let is_sum = harmonics.is_some_and(|harmonics| harmonics.arcsine.is_none());
        let between = |low: f64, high: f64| {
            let closed = given(&sums, low, high);
            if is_sum { closed.min(given(&[], low, high)) } else { closed }
        };
        if harmonics.is_some_and(Harmonics::peaks) {
            return by_halves([least, most], CELLS * CELLS, MOST_HALVED, between);
        }
        // The motion is fastest, and the rounding mostly worst, at the lowest point.
        let from_lowest = |[low, high]: [f64; 2], cap: f64| {
            let slice = (high - low) / f64::from(CELLS * CELLS);
            let ends = if reduction.origin == Origin::Anchor { [high - slice, high] } else { [low, low + slice] };
            let there = between(ends[0], ends[1]);
            if there > cap { there } else { by_slices([low, high], CELLS, cap, between) }
        };
        let all = [least, most];
        let Some(met) = met.filter(|_| harmonics.is_none()) else { return from_lowest(all, cap) };
        let [low, high] = reduction.phases([met.least, met.farthest]).map(|phase| phase.clamp(least, most));
        let elsewhere = [[least, low], [high, most]].map(|[low, high]| {
            if low < high && met.spare < f64::INFINITY { from_lowest([low, high], met.spare) } else { 0.0 }
        });
        from_lowest(if worst(elsewhere) > met.spare { all } else { [low, high] }, cap)
    }
}

/// The square of this is the number of subintervals of the phase on which the rounding is analysed separately.
const CELLS: u32 = 8;

/// How often slices are halved where the rounding peaks.
const MOST_HALVED: usize = 200;

/// With S = sin(θ/2) and C = cos(θ/2): sin θ = 2SC and −cos θ = S² − C².
fn circle(b: &mut Builder, variables: &Variables, sine: &Polynomial, cosine: &Polynomial) -> Vec<Id> {
    let (half_sine, half_cosine) = (sine.one_of_two(b, variables), cosine.one_of_two(b, variables));
    b.name(half_sine, "half_sine");
    b.name(half_cosine, "half_cosine");
    let product = b.mul(half_sine, half_cosine);
    let x = b.add(product, product);
    b.name(x, "x");
    // Of factors one of which is odd the product is.
    let parity = if cosine.parity == Parity::Odd { Parity::Odd } else { sine.parity };
    let x = variables.signed(b, x, sine.alternates, parity);
    let (sine_squared, cosine_squared) = (b.mul(half_sine, half_sine), b.mul(half_cosine, half_cosine));
    let y = b.sub(sine_squared, cosine_squared);
    vec![x, b.name(y, "y")]
}

/// The name of a single result, before it takes the sign of the phase.
pub(super) const RESULT: &str = "result";

/// One function of the time, the kernels' results its own.
pub(super) fn function(reduction: &Reduction, kernels: &[&Kernel]) -> Program {
    const NAMES: [&str; 2] = ["first_result", "second_result"];
    let mut b = Builder::new(reduction.float);
    let t = b.input();
    let phase = reduction.lower(&mut b, t);
    let odd = kernels.iter().any(|kernel| kernel.is_odd());
    let variables = Variables::lower(&mut b, phase, reduction, odd);
    let names = if kernels.len() == 1 { [RESULT; 2] } else { NAMES };
    let mut results = Vec::new();
    for (kernel, name) in kernels.iter().zip(names) {
        let of_magnitude = kernel.lower(&mut b, &variables, name);
        let turned = reduction.folded && kernel.is_odd_in_time();
        results
            .extend(of_magnitude.into_iter().map(|value| if turned { with_sign_of(&mut b, t, value) } else { value }));
    }
    b.finish(results)
}

/// `value`, or its negative where `t` is negative.
fn with_sign_of(b: &mut Builder, t: Id, value: Id) -> Id {
    let minus = b.constant(-1.0);
    let opposite = b.mul(t, minus);
    b.push(Op::Against { x: value, sign: opposite })
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
