//! What a sum of harmonics becomes: the kernel of each output, and its error.

use super::bias::Approximate;
use super::whole::{Rated, Whole, cost};
use super::{Sum, rank};
use crate::parse::{Method, Output};
use crate::plan::arcsine::Arcsine;
use crate::plan::cosines::Cosines;
use crate::plan::curve::{Curve, Curves, SwingCurves};
use crate::plan::form::Form;
use crate::plan::harmonics::{Formula, Harmonics, Made, OfSine, Sines, harmonics};
use crate::plan::kernel::{Core, Kernel};
use crate::plan::polynomial::{Approximation, Numerator, Polynomial};
use crate::plan::reduction::Reduction;
use crate::plan::turning::Finish;
use crate::plan::{Bound, MOSTLY_ROUNDING, Part};
use crate::program::rounding::INFLATION;
use crate::scene::Goal;
use pendulum_runtime::double::Double;
use std::f64::consts::{FRAC_PI_2, PI};

/// An output, and what doesn't depend on the reduction.
pub(super) struct Wanted {
    pub(super) output: Output,
    /// The exact one, at least as steep as what stands for it.
    pub(super) curve: Curve,
    /// sup |approximate output − exact output|.
    pub(super) bias: f64,
    /// What an angle is held to beyond a short horizon, if it would exceed that there.
    held: Option<f64>,
    /// The distances from an anchor at which its rounding counts, if not all do: within a short horizon, beyond which
    /// nothing is promised but of angles, nor of those that are held more than that.
    pub(super) met: Option<[f64; 2]>,
    /// θ̂, or its derivative, where it is twice an arcsine.
    whole: Option<Whole>,
}

impl Wanted {
    /// Whether one polynomial or many can stand for the arcsine of the sum.
    pub(super) fn is_whole(&self) -> bool {
        self.whole.as_ref().is_some_and(Whole::is_possible)
    }

    /// The output by that kernel.
    pub(super) fn part(&self, mut kernel: Kernel, mut description: String, bound: Bound) -> Part {
        let Self { output, curve: Curve { size, .. }, .. } = self;
        let (unit, largest) = (size.unit, size.largest);
        if let Some(most) = self.held {
            kernel.finish = Finish::Held { most };
            description += ", held to the amplitude beyond the horizon";
        }
        Part { output: *output, kernel, description, bound, unit, largest, share: 0.0 }
    }

    /// What the phase makes of it, in pieces if it may be.
    pub(super) fn phase_error(&self, reduction: &Reduction) -> f64 {
        let in_pieces = self.whole.as_ref().and_then(|whole| whole.in_pieces(reduction));
        self.curve.size.phase_error(in_pieces.as_ref().unwrap_or(reduction))
    }

    /// What a sum is rounded by over what is met. A quotient's root may be 0 next to an overshoot, which a moment needn't meet:
    /// beyond it that is no number, either, and then there is no bound.
    fn rounding(&self, summed: &Kernel, reduction: &Reduction, is_quotient: bool) -> f64 {
        let by = |reduction: &Reduction| summed.rounding(reduction, f64::INFINITY);
        match self.met {
            Some(_) if is_quotient && !by(reduction).is_finite() => f64::INFINITY,
            Some(met) => by(&reduction.meeting(met)),
            None => by(reduction),
        }
    }

    /// What the phase may be wrong by without a tolerance.
    pub(super) fn left_to_phase(&self, unit: f64) -> f64 {
        self.whole.as_ref().map_or(8.0 * unit * self.curve.size.largest, Whole::left_to_phase)
    }

    /// Whether there are pieces for reductions that can count them.
    pub(super) fn has_pieces(&self) -> bool {
        self.whole.as_ref().is_some_and(Whole::has_pieces)
    }
}

/// The same with as many pieces for θ̂ as for its derivative, if there are both.
fn sharing_a_table(wanted: Vec<Wanted>) -> Vec<Wanted> {
    let wholes = || wanted.iter().filter_map(|wanted| wanted.whole.as_ref());
    if wholes().count() < 2 {
        return wanted;
    }
    let most = wholes().filter_map(Whole::count).max().unwrap_or(0);
    let sharing = |wanted: Wanted| Wanted { whole: wanted.whole.map(|whole| whole.of_at_least(most)), ..wanted };
    wanted.into_iter().map(sharing).collect()
}

impl Sum<'_> {
    pub(super) fn wanted(&self) -> Vec<Wanted> {
        let curves = SwingCurves::new(self.swing, &self.scene.motion.omega);
        let theta = curves.angle();
        let approximate = Approximate::new(self, &theta);
        let one = |&output: &Output| {
            let (curve, (bias, held)) = match output {
                Output::Velocity => (curves.velocity(), (approximate.velocity(), None)),
                Output::Acceleration => (curves.acceleration(), (approximate.acceleration(), None)),
                // The chord of an angle is no longer than its arc, and on the circle there is nothing to exceed.
                Output::Position => (theta.clone().into_position(), (approximate.at_most(), None)),
                Output::Theta | Output::Wrapped => (theta.clone(), approximate.angle()),
            };
            let whole = Whole::new(self, output, curve.size, bias);
            let counts = held.is_some() || !output.is_angle();
            let met = self.met().filter(|_| counts).map(|met| met.distances_as_reduced(&self.launch, self.scene));
            Wanted { output, curve: self.as_steep(curve, output), bias, held, met, whole }
        };
        let wanted: Vec<Wanted> = self.scene.outputs.iter().map(one).collect();
        sharing_a_table(wanted)
    }

    /// A curve at least as steep, and as much conditioned by the phase, as what stands for it where both are compared at one
    /// time ([`Departure`](super::linearised::Departure)), not at one phase: A cos πs of small angles and its derivatives,
    /// with sup |πz cos πz| = 0.5611 and sup |πz sin πz| = π/2.
    fn as_steep(&self, mut curve: Curve, output: Output) -> Curve {
        if self.method == Method::SmallAngle {
            let largest = self.weights[0].hi.abs() * curve.size.unit * INFLATION;
            let conditioning = if output == Output::Velocity { FRAC_PI_2 } else { 0.5611 };
            curve.size.slope = curve.size.slope.max(PI * largest);
            curve.size.conditioning = curve.size.conditioning.max(conditioning * largest);
        }
        curve
    }

    /// The outputs, of which those in pieces have as many.
    pub(super) fn parts(&self, wanted: &[Wanted], reduction: &Reduction) -> Vec<Part> {
        let mut parts: Vec<Part> = Vec::new();
        for wanted in wanted {
            let rows = parts.iter().find_map(|part| part.kernel.core.rows());
            parts.push(self.part(wanted, reduction, rows));
        }
        parts
    }

    /// An output by the recurrence or, where it is kept and ranks before that, one function for the whole of θ̂; if in pieces,
    /// in as many as there are `rows`.
    fn part(&self, wanted: &Wanted, reduction: &Reduction, rows: Option<usize>) -> Part {
        let Wanted { output, curve, bias, whole, .. } = wanted;
        let harmonics = self.harmonics(*output, reduction);
        let is_quotient = harmonics.is_quotient();
        let summed = Kernel::from(Core::Harmonics(Box::new(harmonics)));
        let cost = cost(reduction, &summed);
        let candidate = whole.as_ref().and_then(|whole| whole.cheapest(reduction));
        let as_many = |own: Option<usize>| own.is_none() || rows.is_none() || own == rows;
        let mut candidate = candidate.filter(|candidate| as_many(candidate.kernel.core.rows()));
        let is_vague = |Rated { bound, .. }: &Rated| {
            self.is_vague(Bound { truncation: bias + bound.truncation, ..*bound }, curve.size.largest)
        };
        // What the recurrence is rounded by takes long to know, and is at best within what is allowed.
        if let Some(better) = candidate.take_if(|candidate| candidate.rank() < rank(0.0, cost) && !is_vague(candidate))
        {
            return self.whole(wanted, better);
        }
        let evaluation = wanted.rounding(&summed, reduction, is_quotient);
        let phase = curve.size.phase_error(reduction);
        // Only of θ̂ itself something is promised.
        let promised = whole.as_ref().filter(|_| *output == Output::Theta);
        let share = promised.map_or(0.0, |whole| {
            whole.share(Bound { truncation: 0.0, phase: whole.phase_error(reduction), evaluation })
        });
        let serves = |candidate: &Rated| {
            let ranks = candidate.rank() < rank(share, cost);
            ranks && !(is_vague(candidate) && evaluation < candidate.bound.evaluation)
        };
        if let Some(better) = candidate.filter(serves) {
            return self.whole(wanted, better);
        }
        let (description, bound) = (summed.core.describe(), Bound { truncation: *bias, phase, evaluation });
        Part { share, ..wanted.part(summed, description, bound) }
    }

    /// Whether a bound for a tolerance is mostly rounding, of more than a few units of the largest value: next to an
    /// overshoot, where the arcsine is steep, which pieces count that a short horizon doesn't meet.
    fn is_vague(&self, bound: Bound, largest: f64) -> bool {
        let few = FEW * self.scene.float.rounding_unit() * largest;
        let is_mostly_rounding = bound.evaluation > few.max(MOSTLY_ROUNDING * (bound.truncation + bound.phase));
        matches!(self.scene.goal, Goal::Tolerance(_)) && is_mostly_rounding
    }

    /// θ̂ or its derivative by that kernel.
    fn whole(&self, wanted: &Wanted, Rated { kernel, bound, share, .. }: Rated) -> Part {
        let (harmonics, word) = (harmonics(self.weights.len()), kernel.core.describe());
        let one = if let Core::Polynomial(_) = kernel.core { "one " } else { "" };
        let slope = if wanted.output == Output::Velocity { "the slope of " } else { "" };
        let description = format!("{harmonics}, {slope}twice the arcsine of their sum as {one}{word}");
        let bound = Bound { truncation: wanted.bias + bound.truncation, ..bound };
        Part { share, ..wanted.part(kernel, description, bound) }
    }

    fn harmonics(&self, output: Output, reduction: &Reduction) -> Harmonics {
        let cosine = self.wave(&Curve::harmonics(&[Double::ONE]), reduction);
        let made = if self.method == Method::Fourier {
            self.made_of_sine(output, reduction)
        } else {
            self.made_of_sum(output, reduction)
        };
        Harmonics { cosine, made }
    }

    /// The sum itself, or a derivative of it.
    fn made_of_sum(&self, output: Output, reduction: &Reduction) -> Made {
        let direction = self.direction();
        match output {
            Output::Velocity => Made::Sines(self.sines(self.slopes(), direction, reduction)),
            Output::Acceleration => Made::Cosines(times(self.bends(), direction)),
            Output::Theta | Output::Wrapped | Output::Position => Made::Cosines(times(self.weights.clone(), direction)),
        }
    }

    /// In the paper's formula the sum is sin(θ̂/2).
    fn made_of_sine(&self, output: Output, reduction: &Reduction) -> Made {
        let direction = self.direction();
        let cosines = self.weights.clone();
        let formula = match output {
            Output::Theta | Output::Wrapped => Formula::Angle(self.arcsine(reduction)),
            Output::Velocity => {
                let sines = self.sines(self.slopes(), 2.0 * direction, reduction);
                return Made::Slope { cosines, sines };
            }
            Output::Acceleration => Formula::Acceleration(self.scene.motion.omega.square().to_double()),
            Output::Position => Formula::Position,
        };
        Made::OfSine(OfSine { cosines, folded: self.folded(reduction), direction, formula })
    }

    /// The sum of sines with so many times those weights.
    fn sines(&self, weights: Vec<Double>, factor: f64, reduction: &Reduction) -> Sines {
        Sines { sine: self.wave(&Curve::sine(), reduction), weights: times(weights, factor) }
    }

    /// A cosine or a sine of the phase, as good as rounding.
    fn wave(&self, curve: &Curve, reduction: &Reduction) -> Polynomial {
        let precision = self.scene.float.rounding_unit() / 2.0;
        let approximation = Approximation::entire(curve, precision / 16.0);
        let terms = approximation.terms_for(precision, reduction.overshoot).unwrap_or(approximation.terms());
        approximation.truncated(terms, reduction, true).in_powers(Form::Powers { shift: 0.0, largest_last: false })
    }

    /// The argument of the arcsine as one polynomial, if its error is that of the recurrence or less.
    fn folded(&self, reduction: &Reduction) -> Option<Polynomial> {
        let (size, unit) = (self.size(), self.scene.float.rounding_unit());
        let precision = size * unit / 2.0;
        let approximation = Approximation::new(&Curve::harmonics(&self.weights), None, precision / 16.0)?;
        let terms = approximation.terms_for(precision, reduction.overshoot).filter(|&terms| terms <= MOST_FOLDED)?;
        Form::ALL.into_iter().find_map(|form| {
            // Adapting saves less than it may cost of the few units of θ0 that a formula to be reproduced can lose.
            let most = if let Form::Adapted { .. } = form { 6.0 } else { 12.0 };
            let cap = most * size * unit;
            let polynomial = approximation.truncated(terms, reduction, true).polynomial(form, Numerator::One, cap)?;
            (polynomial.rounding(reduction, cap) <= cap).then_some(polynomial)
        })
    }

    /// For arguments up to the largest that occurs, from the lowest point, or a little beyond it, on.
    fn arcsine(&self, reduction: &Reduction) -> Arcsine {
        let steepest = Cosines::odd(&self.weights).magnitude(1);
        Arcsine::new(steepest * reduction.overshoot, self.size(), reduction.float.rounding_unit() / 2.0)
    }

    /// Bounds the argument of the arcsine.
    fn size(&self) -> f64 {
        Cosines::odd(&self.weights).magnitude(0).min(1.0)
    }
}

fn times(weights: Vec<Double>, factor: f64) -> Vec<Double> {
    weights.into_iter().map(|weight| weight * factor).collect()
}

/// Rounding of so many units in the last place is what evaluations come to.
const FEW: f64 = 16.0;

/// Of more terms than this no powers come near the recurrence; of more than 42 none are known to.
const MOST_FOLDED: usize = 64;
