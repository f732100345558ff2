//! The cheapest polynomials: every reduction with every form, in the order of their estimated cost, until one keeps the
//! promise.

use super::curve::{Curve, SwingCurves};
use super::kernel::{self, Kernel, norm};
use super::polynomial::{Approximation, Form, Polynomial};
use super::reduction::{Clock, Origin, Reduction};
use super::variables::Variables;
use super::{Bound, Part, Plan, Refusal};
use crate::exact::Real;
use crate::motion::Swing;
use crate::parse::{Method, Output};
use crate::program::{Builder, Program};
use crate::scene::{Goal, Scene};
use crate::series::{Parity, swing_rate};

/// What one output has to keep.
pub(super) struct Aim {
    pub(super) output: Output,
    pub(super) curves: Vec<Curve>,
    /// The curve whose slope tells what an error of the phase does: a position moves as fast as θ.
    steepest: Curve,
    /// The power of the nearest poles in the curves, 0 if they are logarithms.
    power: i32,
    /// For the total, in the curve's own unit.
    limit: f64,
    /// For the truncation alone.
    truncation: f64,
}

/// The variables tried.
const FORMS: [Form; 3] = [Form::Plain, Form::Centred { centre: 1.0 }, Form::Centred { centre: 1.25 }];

/// One way of computing all outputs.
struct Candidate<'a> {
    reduction: &'a Reduction,
    form: Form,
    /// Whether the poles are divided out.
    divided: bool,
    /// Estimated; no less than a term too low.
    cost: f64,
}

/// An output's approximations, without and with its poles divided out.
struct Approximations {
    plain: Vec<Approximation>,
    divided: Vec<Approximation>,
}

impl Approximations {
    fn new(aim: &Aim) -> Self {
        let negligible = |curve: &Curve| (aim.truncation / 128.0).min(curve.largest / 128.0);
        let all = |power| aim.curves.iter().filter_map(|c| Approximation::new(c, power, negligible(c))).collect();
        Self { plain: all(0), divided: if aim.power > 0 { all(aim.power) } else { Vec::new() } }
    }

    /// Those of a candidate; outputs without poles have no choice.
    fn choose(&self, divided: bool) -> &[Approximation] {
        if divided && !self.divided.is_empty() { &self.divided } else { &self.plain }
    }
}

/// The cheapest plan of a swing.
pub(super) fn plan(scene: &Scene, swing: &Swing) -> Result<Plan, Refusal> {
    let aims = aims(scene, swing);
    let approximations: Vec<Approximations> = aims.iter().map(Approximations::new).collect();
    let rate = swing_rate(swing);
    let clock = Clock {
        rate: &rate,
        launch: swing.launch.to_double(),
        t_max: scene.t_max.as_ref().map(Real::to_f64),
        float: scene.float,
    };
    let reductions = clock.reductions();
    let mut closest = f64::INFINITY;
    for candidate in candidates(&reductions, &aims, &approximations) {
        match candidate.plan(swing.mirrored, &aims, &approximations) {
            Ok(plan) => return Ok(plan),
            Err(reached) => closest = closest.min(reached),
        }
    }
    Err(Refusal::Unreachable { best: closest })
}

pub(super) fn aims(scene: &Scene, swing: &Swing) -> Vec<Aim> {
    let curves = SwingCurves::new(swing, &scene.motion.omega);
    scene.outputs.iter().map(|&output| aim(scene, &curves, output)).collect()
}

fn aim(scene: &Scene, curves: &SwingCurves, output: Output) -> Aim {
    let theta = curves.theta();
    let (curves, power) = match output {
        Output::Theta | Output::Wrapped => (vec![curves.theta()], 0),
        Output::Velocity => (vec![curves.velocity()], 1),
        Output::Acceleration => (vec![curves.acceleration()], 2),
        Output::Position => (vec![curves.half_sine(), curves.half_cosine()], 1),
    };
    let steepest = if output == Output::Position { theta } else { curves[0].clone() };
    let unit = scene.float.unit();
    // Of a position, whose two coordinates are products, rounding takes more.
    let (largest, units) = if output == Output::Position { (1.0, 48.0) } else { (steepest.largest, 16.0) };
    let (limit, truncation) = match scene.goal {
        Goal::Tolerance(tol) => (tol * steepest.unit, tol * steepest.unit),
        _ => (units * unit * largest, unit * largest),
    };
    Aim { output, curves, steepest, power, limit, truncation }
}

/// Every combination that might serve, cheapest first.
fn candidates<'a>(reductions: &'a [Reduction], aims: &[Aim], approximations: &[Approximations]) -> Vec<Candidate<'a>> {
    let mut candidates = Vec::new();
    for reduction in reductions {
        let base = skeleton(reduction, Form::Plain, aims).cost();
        for form in FORMS {
            for divided in [false, true] {
                if divided && aims.iter().all(|aim| aim.power == 0) {
                    continue;
                }
                let extra = if form == Form::Plain && !divided { 0.0 } else { 2.0 };
                let kernels = aims
                    .iter()
                    .zip(approximations)
                    .map(|(aim, approximations)| aim.estimate(approximations.choose(divided), reduction, divided));
                if let Some(cost) = kernels.sum::<Option<f64>>() {
                    candidates.push(Candidate { reduction, form, divided, cost: base + extra + cost });
                }
            }
        }
    }
    candidates.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    candidates
}

/// The reduction and the variables, without any kernel.
fn skeleton(reduction: &Reduction, form: Form, aims: &[Aim]) -> Program {
    let odd = aims.iter().flat_map(|aim| &aim.curves).any(|curve| curve.parity() == Parity::Odd);
    let mut b = Builder::new(reduction.float);
    let t = b.input();
    let phase = reduction.lower(&mut b, t);
    let variables = Variables::lower(&mut b, phase, reduction, form.centre(), odd);
    b.finish(vec![variables.square, variables.magic])
}

impl Aim {
    /// What the reduction's error of the phase costs.
    fn phase_error(&self, reduction: &Reduction) -> f64 {
        self.steepest.phase_error(reduction)
    }

    /// The truncation allowed to each of the curves.
    fn share(&self, left: f64) -> f64 {
        left.min(self.truncation) / self.error((self.curves.len() as f64).sqrt())
    }

    /// The output's error where that of its curves is `error`: a position is the square of a number on the unit circle.
    fn error(&self, error: f64) -> f64 {
        if self.output == Output::Position { error * (2.0 + error) } else { error }
    }

    /// The cost of the kernels with the fewest terms; `None` if no number of them serves.
    fn estimate(&self, approximations: &[Approximation], reduction: &Reduction, divided: bool) -> Option<f64> {
        if approximations.len() < self.curves.len() {
            return None;
        }
        let left = self.share(self.limit - self.phase_error(reduction));
        let one = |(curve, approximation): (&Curve, &Approximation)| {
            let terms = approximation.terms_for(left, reduction.overshoot)? as f64;
            let quotient = if divided && self.power > 0 { 8.0 } else { 0.0 };
            let signs = if curve.alternates && reduction.origin == Origin::Lowest { 2.0 } else { 0.0 };
            Some(2.0 * terms + terms.log2().floor() + quotient + signs)
        };
        self.curves.iter().zip(approximations).map(one).sum()
    }

    /// The fewest terms that keep the promise, or what was reached.
    fn part(&self, approximations: &[Approximation], candidate: &Candidate, mirrored: bool) -> Result<Part, f64> {
        let reduction = candidate.reduction;
        let phase = self.phase_error(reduction);
        let mut evaluation = 0.0;
        let mut reached = f64::INFINITY;
        for _ in 0..3 {
            let left = self.share(self.limit - phase - evaluation);
            let mut polynomials = Vec::new();
            for (curve, approximation) in self.curves.iter().zip(approximations) {
                let Some(terms) = approximation.terms_for(left, reduction.overshoot) else {
                    let least = approximation.truncation(approximation.terms(), reduction.overshoot);
                    return Err(reached.min(phase + evaluation + least));
                };
                let mut polynomial = approximation.polynomial(terms, candidate.form, reduction, curve.alternates);
                if mirrored && curve.alternates {
                    polynomial.negate();
                }
                polynomials.push(polynomial);
            }
            let truncation = self.error(norm(polynomials.iter().map(|polynomial| polynomial.truncation)));
            let kernel = match <[Polynomial; 2]>::try_from(polynomials) {
                Ok([sine, cosine]) => Kernel::Circle { sine, cosine },
                Err(mut single) => Kernel::Polynomial(single.swap_remove(0)),
            };
            evaluation = kernel.rounding(reduction);
            let bound = Bound { truncation, phase, evaluation };
            reached = reached.min(bound.total());
            if bound.total() <= self.limit {
                let (description, unit) = (kernel.describe(), self.curves[0].unit);
                let largest = self.steepest.largest;
                return Ok(Part { output: self.output, kernel, description, bound, unit, largest });
            }
        }
        Err(reached)
    }
}

impl Candidate<'_> {
    fn plan(&self, mirrored: bool, aims: &[Aim], approximations: &[Approximations]) -> Result<Plan, f64> {
        let each = aims.iter().zip(approximations);
        let parts = each.map(|(aim, approximations)| aim.part(approximations.choose(self.divided), self, mirrored));
        let parts = parts.collect::<Result<Vec<Part>, f64>>()?;
        let functions = kernel::functions(self.reduction, &parts);
        Ok(Plan {
            method: Method::Polynomial,
            reduction: self.reduction.clone(),
            parts,
            functions,
            coefficients: Vec::new(),
            rejected: Vec::new(),
        })
    }
}
