//! The cheapest polynomials: every reduction with every form, in the order of their estimated cost, until one keeps the
//! promise.

use super::curve::{Curve, SwingCurves};
use super::polynomial::{Approximation, Form, Polynomial};
use super::reduction::{Clock, Origin, Reduction};
use super::variables::Variables;
use super::{Bound, Function, Part, Plan, Refusal};
use crate::exact::Real;
use crate::motion::Swing;
use crate::parse::{Method, Output};
use crate::program::rounding::Known;
use crate::program::{Builder, Program};
use crate::scene::{Goal, Scene};
use crate::series::{Parity, swing_rate};

/// What one output has to keep.
pub(super) struct Aim {
    pub(super) output: Output,
    pub(super) curves: Vec<Curve>,
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
    let (curves, power) = match output {
        Output::Theta | Output::Wrapped => (vec![curves.theta()], 0),
        Output::Velocity => (vec![curves.velocity()], 1),
        Output::Acceleration => (vec![curves.acceleration()], 2),
        Output::Position => (vec![curves.sine(), curves.height()], 2),
    };
    let unit = scene.float.unit();
    let largest = curves.iter().map(|curve| curve.largest).fold(0.0, f64::max);
    let (limit, truncation) = match scene.goal {
        Goal::Tolerance(tol) => (tol * curves[0].unit, tol * curves[0].unit),
        _ => (16.0 * unit * largest, unit * largest),
    };
    Aim { output, curves, power, limit, truncation }
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
        self.curves.iter().map(|curve| curve.phase_error(reduction)).fold(0.0, f64::max)
    }

    /// The truncation allowed to each of the curves, whose errors add like the sides of a right angle.
    fn share(&self, left: f64) -> f64 {
        left.min(self.truncation) / (self.curves.len() as f64).sqrt()
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
            let mut kernels = Vec::new();
            for (curve, approximation) in self.curves.iter().zip(approximations) {
                let Some(terms) = approximation.terms_for(left, reduction.overshoot) else {
                    let least = approximation.truncation(approximation.terms(), reduction.overshoot);
                    return Err(reached.min(phase + evaluation + least));
                };
                let mut kernel = approximation.polynomial(terms, candidate.form, reduction, curve.alternates);
                if mirrored && curve.alternates {
                    kernel.negate();
                }
                kernels.push(kernel);
            }
            evaluation = norm(kernels.iter().map(|kernel| rounding(kernel, reduction)));
            let bound = Bound { truncation: norm(kernels.iter().map(|k| k.truncation)), phase, evaluation };
            reached = reached.min(bound.total());
            if bound.total() <= self.limit {
                let each: Vec<String> = kernels.iter().map(Polynomial::describe).collect();
                let (description, unit) = (each.join(" and "), self.curves[0].unit);
                return Ok(Part { output: self.output, kernels, description, bound, unit });
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
        let functions = functions(self.reduction, &parts);
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

fn norm(parts: impl Iterator<Item = f64>) -> f64 {
    parts.map(|x| x * x).sum::<f64>().sqrt()
}

/// Subintervals of the phase on which the rounding is analysed separately.
const SLICES: usize = 64;

/// The rounding of a kernel over the whole range of the phase, taken as exact.
fn rounding(kernel: &Polynomial, reduction: &Reduction) -> f64 {
    let program = function(reduction, &[kernel]);
    let phase = program.named("s").or_else(|| program.named("z")).unwrap_or(0);
    let half = reduction.half();
    (0..SLICES)
        .map(|slice| {
            let at = |index: usize| half * index as f64 / SLICES as f64;
            let known = [(phase, Known::between(at(slice), at(slice + 1)))];
            program.rounding(&known).iter().map(|k| k.error).fold(0.0, f64::max)
        })
        .fold(0.0, f64::max)
}

fn function(reduction: &Reduction, kernels: &[&Polynomial]) -> Program {
    const NAMES: [&str; 3] = ["y1", "y2", "y3"];
    let mut b = Builder::new(reduction.float);
    let t = b.input();
    let phase = reduction.lower(&mut b, t);
    let odd = kernels.iter().any(|kernel| kernel.parity == Parity::Odd);
    let centre = kernels.first().map_or(1.0, |kernel| kernel.form.centre());
    let variables = Variables::lower(&mut b, phase, reduction, centre, odd);
    let results = kernels.iter().zip(NAMES).map(|(kernel, name)| kernel.lower(&mut b, &variables, name)).collect();
    b.finish(results)
}

/// A function per output, and `state` for θ and velocity together.
fn functions(reduction: &Reduction, parts: &[Part]) -> Vec<Function> {
    let mut functions: Vec<Function> = parts
        .iter()
        .map(|part| {
            let kernels: Vec<&Polynomial> = part.kernels.iter().collect();
            Function { name: part.output.word(), program: function(reduction, &kernels) }
        })
        .collect();
    let of = |output| parts.iter().find(|part| part.output == output);
    if let (Some(theta), Some(velocity)) = (of(Output::Theta), of(Output::Velocity)) {
        let kernels: Vec<&Polynomial> = theta.kernels.iter().chain(&velocity.kernels).collect();
        functions.push(Function { name: "state", program: function(reduction, &kernels) });
    }
    functions
}
