//! One output's kernel: its variants by cost, and the fewest terms of each that keep the promise.

use super::aim::{Aim, Task};
use super::curve::Curve;
use super::form::{Division, Form};
use super::kernel::Kernel;
use super::passage::{Orbit, Passage};
use super::pieces::Piecewise;
use super::polynomial::{Approximation, Pole, Polynomial, pade};
use super::reduction::{Origin, Reduction};
use super::turning::Turning;
use super::{Bound, Part};
use crate::motion::Regime;
use crate::parse::Output;
use crate::scene::{Goal, Scene};
use crate::series::Parity;
use crate::supremum::norm;
use pendulum_runtime::double::Double;
use std::f64::consts::PI;

/// How a curve is approximated: in which form, and whether poles are divided out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Variant {
    pub(super) form: Form,
    pub(super) divided: bool,
}

impl Variant {
    /// For the reader.
    pub(super) fn describe(self, parity: Parity) -> String {
        let poles = if self.divided { " over poles" } else { "" };
        format!("a polynomial in {}{poles}{}", self.form.variable(parity), self.form.scheme())
    }
}

/// An output's approximations, without and with its poles divided out.
pub(super) struct Approximations {
    plain: Vec<Approximation>,
    divided: Vec<Approximation>,
}

impl Approximations {
    pub(super) fn new(aim: &Aim) -> Self {
        // So far below the aim that it doesn't blur the bound of a plan that, for want of half terms, is much better.
        // Over an arc, that may be any number of digits; but there it costs nothing.
        let negligible = |curve: &Curve| match curve.largest_met() {
            Some(largest) => aim.floor() / 128.0 * (largest / curve.size.largest).clamp(2f64.powi(-30), 1.0),
            None => (aim.truncation.min(curve.size.largest) * 2f64.powi(-30)).max(aim.floor() / 128.0),
        };
        let over = |pole| {
            let approximations = aim.curves.iter().filter_map(|c| Approximation::new(c, pole, negligible(c)));
            approximations.map(|approximation| approximation.meeting(aim.met)).collect()
        };
        let plain: Vec<Approximation> = over(None);
        let divided = aim.poles(&plain).map_or_else(Vec::new, |pole| over(Some(pole)));
        Self { plain, divided }
    }

    /// Those of a candidate; where no poles are worth it there is no choice.
    pub(super) fn choose(&self, divided: bool) -> &[Approximation] {
        if divided && !self.divided.is_empty() { &self.divided } else { &self.plain }
    }
}

/// Operations that make a position of sin(θ/2) and cos(θ/2).
const SQUARING: f64 = 5.0;

/// Terms that poles have to save a curve that has none: each takes an operation and a half.
const WORTH: usize = 3;

impl Aim {
    /// The poles to be divided out, if any: the nearest, or near them those that save more terms. θ has logarithms
    /// there, but poles serve it as they serve other curves.
    fn poles(&self, plain: &[Approximation]) -> Option<Pole> {
        let curve = self.curves.first().filter(|curve| !curve.is_arc())?;
        let nearest = Pole::new(curve.strip(), self.power.max(1));
        let limit = self.share(self.limit);
        let best = || pade::best(plain, nearest, limit);
        match self.power {
            0 => {
                let (pole, terms) = best()?;
                let most = plain.first()?.terms_for(limit, 0.0);
                most.is_none_or(|most| terms + WORTH <= most).then_some(pole)
            }
            1 => Some(best().map_or(nearest, |(pole, _)| pole)),
            _ => Some(nearest),
        }
    }

    /// The truncation allowed to each of the curves.
    fn share(&self, left: f64) -> f64 {
        left.min(self.truncation) / self.error((self.curves.len() as f64).sqrt())
    }

    /// The output's error where that of its curves is `error`: a position is the square of a number on the unit circle.
    fn error(&self, error: f64) -> f64 {
        if self.output == Output::Position { error * (2.0 + error) } else { error }
    }

    /// The variants that might serve, and their cost in this reduction, cheapest first.
    pub(super) fn variants(&self, all: &Approximations, reduction: &Reduction) -> Vec<(Variant, f64)> {
        let divisions: &[bool] = if all.divided.is_empty() { &[false] } else { &[false, true] };
        let variants =
            Form::ALL.iter().flat_map(|&form| divisions.iter().map(move |&divided| Variant { form, divided }));
        let cost = |variant: Variant| Some((variant, self.estimate(all.choose(variant.divided), reduction, variant)?));
        let mut costs: Vec<(Variant, f64)> = variants.filter_map(cost).collect();
        costs.sort_by(|a, b| a.1.total_cmp(&b.1));
        costs
    }

    /// The cost of the kernels with the fewest terms; `None` if no number of them serves.
    fn estimate(&self, approximations: &[Approximation], reduction: &Reduction, variant: Variant) -> Option<f64> {
        if self.curves.is_empty() || approximations.len() < self.curves.len() {
            return None;
        }
        let left = self.share(self.limit - self.size.phase_error(reduction));
        let one = |(curve, approximation): (&Curve, &Approximation)| {
            let terms = approximation
                .terms_for(left, reduction.overshoot)
                .filter(|&terms| variant.form.suits(terms, reduction.float))?;
            let signs = if curve.alternates && reduction.origin == Origin::Lowest { 1.3 } else { 0.0 };
            let (odd, of_two) = (curve.parity() == Parity::Odd, self.curves.len() > 1);
            let division = match (variant.divided, of_two, odd) {
                (false, ..) => Division::None,
                (true, true, _) => Division::Shared,
                (true, false, true) => Division::OfPhase,
                (true, false, false) => Division::Inverse,
            };
            let phase = if odd { 1.0 } else { 0.0 };
            Some(variant.form.cost(terms, division) + phase + signs)
        };
        let kernels: Option<f64> = self.curves.iter().zip(approximations).map(one).sum();
        Some(kernels? + variant.form.variables() + if self.curves.len() > 1 { SQUARING } else { 0.0 })
    }

    /// The cost of the passage's kernel: an exponential, an arctangent for an angle, and what joins them, one waiting for
    /// the other. Roughly: near the top others cost several times as much.
    pub(super) fn passage_estimate(&self) -> f64 {
        const POWERS_AND_IMAGES: f64 = 30.0;
        const BITS_PER_TERM_OF_POWER: f64 = 5.0;
        const BITS_PER_OPERATION_OF_ARCTANGENT: f64 = 1.3;
        const QUOTIENT: f64 = 16.0;
        let bits = -libm::log2(self.limit / self.size.unit.max(self.size.largest)).min(-4.0);
        let power = 3.0 + bits / BITS_PER_TERM_OF_POWER;
        let rest = if self.output.is_angle() { bits / BITS_PER_OPERATION_OF_ARCTANGENT } else { QUOTIENT };
        POWERS_AND_IMAGES + 2.0 * power + rest
    }

    /// The fewest terms that keep the promise, or what was reached.
    pub(super) fn part(
        &self,
        scene: &Scene,
        task: &Task,
        approximations: &[Approximation],
        reduction: &Reduction,
        form: Form,
    ) -> Result<Part, f64> {
        let phase = self.size.phase_error(reduction);
        self.first_kept(scene, reduction, phase, |rounding| {
            let left = self.share(self.limit - phase - rounding);
            let mut polynomials = Vec::new();
            for (curve, approximation) in self.curves.iter().zip(approximations) {
                let Some(terms) = approximation.terms_for(left, reduction.overshoot) else {
                    let least = approximation.truncation(approximation.terms(), reduction.overshoot);
                    return Err((phase + rounding + least) / self.size.unit);
                };
                let polynomial = approximation.polynomial(terms, form, reduction, curve.alternates, self.limit);
                polynomials.push(polynomial.ok_or(f64::INFINITY)?);
            }
            let truncation = self.error(norm(polynomials.iter().map(|polynomial| polynomial.truncation)));
            Ok((self.kernel(scene, task, reduction, polynomials), truncation))
        })
    }

    /// The kernel of the first of three rounds that keeps the promise, or the least bound reached, in units of the
    /// tolerance. A round is told by how much the kernel of the one before is rounded, and gives a kernel and its
    /// truncation; or what can be reached at best, which ends the search.
    fn first_kept(
        &self,
        scene: &Scene,
        reduction: &Reduction,
        phase: f64,
        mut round: impl FnMut(f64) -> Result<(Kernel, f64), f64>,
    ) -> Result<Part, f64> {
        let (mut rounding, mut reached) = (0.0, f64::INFINITY);
        for _ in 0..3 {
            let (kernel, truncation) = round(rounding).map_err(|best| best.min(reached))?;
            let evaluation = kernel.rounding_where(self.met, reduction, self.limit - phase - truncation);
            let bound = Bound { truncation, phase, evaluation };
            let turns = if self.grows(scene) { 0.0 } else { kernel.rounding_of_turns(reduction) };
            rounding = bound.evaluation + turns;
            match self.accept(scene, kernel, bound, reduction) {
                Ok(part) => return Ok(part),
                Err(total) => reached = reached.min(total),
            }
        }
        Err(reached)
    }

    /// Puts the polynomials together.
    fn kernel(&self, scene: &Scene, task: &Task, reduction: &Reduction, mut polynomials: Vec<Polynomial>) -> Kernel {
        if task.direction < 0.0 {
            // A mirror image leaves the height as it is, and cos(θ/2) with it, or sin where the angle is from the top.
            let mirrored =
                |polynomial: &Polynomial| self.output != Output::Position || polynomial.mirrors(task.turning);
            polynomials.iter_mut().filter(|polynomial| mirrored(polynomial)).for_each(Polynomial::negate);
        }
        match <[Polynomial; 2]>::try_from(polynomials) {
            Ok([sine, cosine]) => Kernel::Circle { sine, cosine },
            Err(mut single) => self.turned(scene, task, Kernel::Polynomial(single.swap_remove(0)), Some(reduction)),
        }
    }

    /// Whether an arc leads over the top.
    fn passes_top(&self) -> bool {
        let beyond = |end: f64| self.curves.iter().any(|curve| curve.at(Double::new(end)).hi.abs() > PI);
        self.curves.iter().all(Curve::is_arc) && [-0.5, 0.5].into_iter().any(beyond)
    }

    /// The largest magnitude that is met: of a rotation's arc that at one of its ends.
    fn reach(&self, scene: &Scene) -> f64 {
        let rotates = matches!(scene.motion.regime, Regime::Rotation(_));
        let of_arc = self.curves.first().filter(|_| rotates).and_then(Curve::largest_met);
        of_arc.unwrap_or(self.size.largest)
    }

    /// The angle of a rotation, wrapped or with its turns, or that of another motion that might pass π; anything else
    /// as it is.
    fn turned(&self, scene: &Scene, task: &Task, kernel: Kernel, from_top: Option<&Reduction>) -> Kernel {
        let wrapped = self.output == Output::Wrapped;
        if !task.turning || !self.output.is_angle() {
            let near = wrapped && self.reach(scene) + self.limit >= PI.next_down();
            if !near {
                return kernel;
            }
            let kernel = Box::new(kernel);
            return if self.passes_top() { Kernel::Wrapped(kernel) } else { Kernel::Within(kernel) };
        }
        let (direction, turns) = (task.direction, task.turns(scene));
        let unit = from_top.map_or(Double::ONE, |reduction| reduction.unit);
        let (angle, from_top) = (Box::new(kernel), from_top.is_some());
        Kernel::Turning(Turning { angle, from_top, unit, wrapped, direction, turns })
    }

    /// The kernel of the passage through the lowest point, or what it reaches.
    pub(super) fn passage_part(
        &self,
        scene: &Scene,
        task: &Task,
        reduction: &Reduction,
        passage: &Orbit,
    ) -> Result<Part, f64> {
        let phase = self.passage_error(reduction);
        let factor = match self.output {
            Output::Velocity => Task::fastest(scene),
            Output::Acceleration => scene.motion.omega.square().to_double(),
            _ => Double::ONE,
        };
        let scaled = Orbit { rate: passage.rate * reduction.unit, ..passage.clone() };
        let mut limit = self.limit.min(self.truncation) / factor.hi;
        let met = task.met_from_lowest(scene, reduction);
        self.first_kept(scene, reduction, phase, |_| {
            let kernel = Passage::new(self.output, scaled.clone(), met, factor, limit);
            limit *= 0.125;
            let truncation = kernel.truncation * factor.hi;
            Ok((self.turned(scene, task, Kernel::Passage(Box::new(kernel)), None), truncation))
        })
    }

    /// Whether it can be had in pieces: one curve, all of which is met.
    pub(super) fn has_pieces(&self, task: &Task) -> bool {
        let whole = self.curves.len() == 1 && !self.curves.iter().any(Curve::is_arc);
        whole && !(task.turning && self.output.is_angle())
    }

    /// About how many terms each of so many pieces takes; `None` where the phase leaves nothing.
    pub(super) fn terms_of_pieces(&self, parts: usize, reduction: &Reduction) -> Option<usize> {
        let curve = self.curves.first()?;
        let left = Some(self.share(self.limit - self.size.phase_error(reduction))).filter(|&left| left > 0.0)?;
        let terms = |left: f64| Piecewise::estimate(curve, parts, left);
        // Of logarithms the coefficients fall off with their number besides.
        Some(if self.power == 0 { terms(left * terms(left) as f64) } else { terms(left) })
    }

    /// Its curve in so many pieces.
    pub(super) fn piecewise(&self, parts: usize) -> Option<Piecewise> {
        let curve = self.curves.first()?;
        Piecewise::new(curve, parts, (self.truncation.min(curve.size.largest) / 512.0).max(self.floor() / 512.0))
    }

    /// The kernel in pieces, or what it reaches.
    pub(super) fn pieces_part(
        &self,
        scene: &Scene,
        task: &Task,
        reduction: &Reduction,
        approximation: &Piecewise,
    ) -> Result<Part, f64> {
        let phase = self.size.phase_error(reduction);
        self.first_kept(scene, reduction, phase, |rounding| {
            let left = self.truncation.min(self.limit - phase - rounding);
            let (mut pieces, truncation) = approximation.kernel(reduction, left).ok_or(f64::INFINITY)?;
            if task.direction < 0.0 {
                pieces.negate();
            }
            Ok((self.turned(scene, task, Kernel::Pieces(Box::new(pieces)), None), truncation))
        })
    }

    /// Whether what its turns are rounded by doesn't count.
    fn grows(&self, scene: &Scene) -> bool {
        scene.goal == Goal::Full && self.output == Output::Theta
    }

    /// The part if it keeps the promise, else the bound reached, in units of the tolerance. At full precision the turns
    /// of an angle that grows without bound cost what they cost: the promise is about the rest.
    pub(super) fn accept(
        &self,
        scene: &Scene,
        kernel: Kernel,
        bound: Bound,
        reduction: &Reduction,
    ) -> Result<Part, f64> {
        let turns = kernel.rounding_of_turns(reduction);
        let whole = Bound { evaluation: bound.evaluation + turns, ..bound };
        let judged = if self.grows(scene) { bound } else { whole };
        if judged.total().is_nan() || judged.total() > self.limit {
            return Err(judged.total() / self.size.unit);
        }
        let (output, unit, largest) = (self.output, self.size.unit, self.size.largest);
        let usual = judged.total() - self.size.slope * reduction.seldom;
        let (description, taken) = (kernel.describe(), usual / self.limit);
        Ok(Part { output, description, kernel, bound: whole, unit, largest, taken })
    }
}
