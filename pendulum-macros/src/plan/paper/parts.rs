//! What a sum of harmonics becomes: the kernel of each output, and its error.

use super::bias::Approximate;
use super::{Sum, pieces, whole};
use crate::parse::{Method, Output};
use crate::plan::arcsine::Arcsine;
use crate::plan::cosines::Cosines;
use crate::plan::curve::{Curve, Curves, Size, SwingCurves};
use crate::plan::form::{Division, Form};
use crate::plan::harmonics::{Formula, Harmonics, Made, harmonics};
use crate::plan::kernel::{self, Kernel};
use crate::plan::pieces::Piecewise;
use crate::plan::polynomial::{Approximation, Numerator, Polynomial};
use crate::plan::reduction::Reduction;
use crate::plan::{Bound, Part};
use crate::program::rounding::half_ulp;
use crate::scene::Goal;
use pendulum_runtime::double::Double;

/// An output, and what doesn't depend on the reduction.
pub(super) struct Wanted {
    pub(super) output: Output,
    /// The exact one.
    pub(super) curve: Curve,
    /// sup |approximate output − exact output|.
    pub(super) bias: f64,
    /// θ̂ where it is twice an arcsine.
    whole: Option<Whole>,
}

/// θ̂ as one function of the phase, and how far off it may be, phase included: the first that can be kept counts.
struct Whole {
    /// For one polynomial, and for many; `None` where that takes too many terms.
    approximation: Option<Approximation>,
    pieces: Option<Piecewise>,
    allowed: Vec<f64>,
    /// What it may differ from θ̂ by at most.
    truncation: f64,
}

/// A kernel for that function, and how wrong it is.
struct Candidate {
    kernel: Kernel,
    bound: Bound,
}

impl Wanted {
    /// Whether one polynomial or many can stand for the arcsine of the sum.
    pub(super) fn is_whole(&self) -> bool {
        self.whole.as_ref().is_some_and(|whole| whole.approximation.is_some() || whole.pieces.is_some())
    }

    /// The output by that kernel.
    pub(super) fn part(&self, kernel: Kernel, description: String, bound: Bound) -> Part {
        let Self { output, curve: Curve { size, .. }, .. } = self;
        let (unit, largest) = (size.unit, size.largest);
        Part { output: *output, kernel, description, bound, unit, largest, share: 0.0 }
    }

    /// Whether there are pieces for reductions that can count them.
    pub(super) fn has_pieces(&self) -> bool {
        self.whole.as_ref().is_some_and(|whole| whole.pieces.is_some())
    }
}

impl Sum<'_> {
    pub(super) fn wanted(&self) -> Vec<Wanted> {
        let curves = SwingCurves::new(self.swing, &self.scene.motion.omega);
        let theta = curves.angle();
        let approximate = Approximate::new(self, &theta);
        let one = |&output: &Output| {
            let (curve, bias) = match output {
                Output::Velocity => (curves.velocity(), approximate.velocity()),
                Output::Acceleration => (curves.acceleration(), approximate.acceleration()),
                // The chord of an angle is no longer than its arc, and on the circle there is nothing to exceed.
                Output::Position => (theta.clone().into_position(), approximate.at_most()),
                Output::Theta | Output::Wrapped => (theta.clone(), approximate.angle()),
            };
            let whole = if output == Output::Theta { self.whole(bias) } else { None };
            Wanted { output, curve, bias, whole }
        };
        self.scene.outputs.iter().map(one).collect()
    }

    /// `None` where there is no arcsine. It may be off by what a tolerance leaves, or by 8 units in the last place
    /// of θ0; if need be by 11 that are proven, of which two thirds have been observed at most.
    fn whole(&self, bias: f64) -> Option<Whole> {
        if self.method != Method::Fourier {
            return None;
        }
        let &Self { scene, swing, .. } = self;
        let units = |units: f64| 2.0 * units * half_ulp(swing.amplitude.to_f64(), scene.float);
        let allowed = match scene.goal {
            Goal::Tolerance(tol) => vec![tol - bias],
            _ => [8.0, 11.0].map(units).into(),
        };
        // Within a moment its difference from θ̂ may undo that of θ̂ from θ.
        let truncation = self.met().map_or(f64::INFINITY, |_| (bias / 3.0).max(units(1.0)));
        let limit = truncation.min(allowed[0] / 8.0);
        let approximation = whole::approximation(&self.weights, limit);
        let pieces = pieces::approximation(&self.weights, limit);
        Some(Whole { approximation, pieces, allowed, truncation })
    }

    pub(super) fn part(&self, wanted: &Wanted, reduction: &Reduction) -> Part {
        let Wanted { output, curve, bias, whole } = wanted;
        let summed = Kernel::Harmonics(Box::new(self.harmonics(*output, reduction)));
        let whole = whole.iter().flat_map(|whole| whole.kernels(&curve.size, reduction, self.direction()));
        let whole = whole
            .map(|candidate| (cost(reduction, &candidate.kernel), candidate))
            .min_by(|(a, _), (b, _)| a.total_cmp(b))
            .filter(|&(least, _)| least < cost(reduction, &summed));
        let (kernel, description, bound) = if let Some((_, Candidate { kernel, bound })) = whole {
            let (harmonics, word) = (harmonics(self.weights.len()), kernel.describe());
            let one = if let Kernel::Polynomial(_) = kernel { "one " } else { "" };
            let description = format!("{harmonics}, twice the arcsine of their sum as {one}{word}");
            (kernel, description, Bound { truncation: bias + bound.truncation, ..bound })
        } else {
            let (description, evaluation) = (summed.describe(), summed.rounding(reduction, f64::INFINITY));
            let phase = curve.size.phase_error(reduction);
            (summed, description, Bound { truncation: *bias, phase, evaluation })
        };
        wanted.part(kernel, description, bound)
    }

    fn harmonics(&self, output: Output, reduction: &Reduction) -> Harmonics {
        let direction = self.direction();
        let derivative = output == Output::Velocity;
        let precision = self.scene.float.unit() / 2.0;
        let base = |curve: &Curve| {
            let approximation = Approximation::entire(curve, precision / 16.0);
            let terms = approximation.terms_for(precision, reduction.overshoot).unwrap_or(approximation.terms());
            approximation.truncated(terms, reduction, true).in_powers(Form::Powers { shift: 0.0 })
        };
        let one = self.scene.motion.omega.context().integer(1);
        let cosine = base(&Curve::cosine(&one));
        let sine = derivative.then(|| base(&Curve::sine()));
        let made = self.made(output, reduction);
        let mirrored = |weights: Vec<Double>| weights.into_iter().map(|weight| weight * direction).collect();
        let cosines = match (&made, output) {
            (Made::Sum, Output::Velocity) => Vec::new(),
            (Made::Sum, Output::Acceleration) => mirrored(self.bends()),
            (Made::Sum, _) => mirrored(self.weights.clone()),
            _ => self.weights.clone(),
        };
        let sines = if derivative { mirrored(self.slopes()) } else { Vec::new() };
        Harmonics { cosine, sine, cosines, sines, made, direction }
    }

    /// What an output is made of: in the paper's formula the sum is sin(θ̂/2).
    fn made(&self, output: Output, reduction: &Reduction) -> Made {
        if self.method != Method::Fourier {
            return Made::Sum;
        }
        let formula = match output {
            Output::Theta | Output::Wrapped => Formula::Angle(self.arcsine(reduction)),
            Output::Velocity => return Made::Velocity,
            Output::Acceleration => Formula::Acceleration(self.scene.motion.omega.square().to_double()),
            Output::Position => Formula::Position,
        };
        Made::OfSine { formula, folded: self.folded(reduction).map(Box::new) }
    }

    /// The argument of the arcsine as one polynomial, if its error is that of the recurrence or less.
    fn folded(&self, reduction: &Reduction) -> Option<Polynomial> {
        let (size, unit) = (self.size(), self.scene.float.unit());
        let precision = size * unit / 2.0;
        let approximation = Approximation::new(&Curve::harmonics(&self.weights), None, precision / 16.0)?;
        let terms = approximation.terms_for(precision, reduction.overshoot).filter(|&terms| terms <= MOST_FOLDED)?;
        Form::ALL.into_iter().find_map(|form| {
            // Adapting saves less than it may cost of the few units of θ0 that a formula to be reproduced can lose.
            let most = if let Form::Adapted { .. } = form { 6.0 } else { 12.0 };
            let cap = most * size * unit;
            let polynomial = approximation.truncated(terms, reduction, true).polynomial(form, Numerator::One, cap)?;
            (Kernel::Polynomial(polynomial.clone()).rounding(reduction, cap) <= cap).then_some(polynomial)
        })
    }

    /// For arguments up to the largest that occurs, from the lowest point, or a little beyond it, on.
    fn arcsine(&self, reduction: &Reduction) -> Arcsine {
        let steepest = Cosines::odd(&self.weights).magnitude(1);
        Arcsine::new(steepest * reduction.overshoot, self.size(), reduction.float.unit() / 2.0)
    }

    /// Bounds the argument of the arcsine.
    fn size(&self) -> f64 {
        self.weights.iter().map(|w| w.hi.abs()).sum::<f64>().min(1.0)
    }
}

/// Of more terms than this no powers come near the recurrence; of more than 42 none are known to.
const MOST_FOLDED: usize = 64;

fn cost(reduction: &Reduction, kernel: &Kernel) -> f64 {
    kernel::function(reduction, &[kernel]).cost_of_calls_too()
}

/// Parts of what the phase leaves that the truncation may take; the first that leaves enough to the rounding counts.
const SHARES: [f64; 2] = [4.0, 16.0];

impl Whole {
    /// The kernels, of one polynomial in the cheapest form and of many, that are off by no more than is allowed.
    fn kernels(&self, size: &Size, reduction: &Reduction, direction: f64) -> Vec<Candidate> {
        let first = |reduction: &Reduction, kernel: &dyn Fn(f64, f64) -> Option<(Kernel, f64, f64)>| {
            let phase = size.phase_error(reduction);
            let left = self.allowed.iter().map(|allowed| allowed - phase);
            let mut shared = left.flat_map(|left| SHARES.map(|share| (left, self.truncation.min(left / share))));
            let (kernel, truncation, evaluation) = shared.find_map(|(left, truncation)| kernel(left, truncation))?;
            Some(Candidate { kernel, bound: Bound { truncation, phase, evaluation } })
        };
        let single = first(reduction, &|left, truncation| self.single(left, truncation, reduction, direction));
        let counted = self.pieces.as_ref().and_then(|pieces| reduction.in_pieces(pieces.pieces() as f64));
        let pieces = counted.and_then(|reduction| {
            first(&reduction, &|left, truncation| self.pieces(left, truncation, &reduction, direction))
        });
        single.into_iter().chain(pieces).collect()
    }

    /// The kernel with a table, wrong by so much, of which the truncation is that part.
    fn pieces(&self, left: f64, truncation: f64, reduction: &Reduction, direction: f64) -> Option<(Kernel, f64, f64)> {
        let (mut pieces, truncation) = self.pieces.as_ref()?.kernel(reduction, truncation)?;
        let rounding = pieces.rounding();
        if direction < 0.0 {
            pieces.negate();
        }
        (rounding <= left - truncation).then(|| (Kernel::Pieces(Box::new(pieces)), truncation, rounding))
    }

    /// The same as one polynomial.
    fn single(&self, left: f64, truncation: f64, reduction: &Reduction, direction: f64) -> Option<(Kernel, f64, f64)> {
        let approximation = self.approximation.as_ref()?;
        let terms = approximation.terms_for(truncation, reduction.overshoot)?;
        let mut forms: Vec<Form> = Form::ALL.into_iter().filter(|form| form.suits(terms, reduction.float)).collect();
        let cost = |form: &Form| form.cost(terms, Division::None) + form.variables(terms);
        forms.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
        forms.into_iter().find_map(|form| {
            let mut polynomial =
                approximation.truncated(terms, reduction, true).polynomial(form, Numerator::One, left)?;
            let truncation = polynomial.truncation;
            if direction < 0.0 {
                polynomial.negate();
            }
            let kernel = Kernel::Polynomial(polynomial);
            let rounding = kernel.rounding(reduction, left - truncation);
            (rounding <= left - truncation).then_some((kernel, truncation, rounding))
        })
    }
}
