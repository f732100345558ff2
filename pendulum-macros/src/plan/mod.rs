//! [`Scene`] → [`Plan`]: the cheapest program found that provably keeps the promise.

pub(crate) mod curve;
pub(crate) mod polynomial;
pub(crate) mod reduction;

use crate::exact::Real;
use crate::motion::{Regime, Swing};
use crate::parse::{Float, Method, Output};
use crate::program::rounding::Known;
use crate::program::{Builder, Op, Program};
use crate::scene::{Goal, Scene};
use curve::{Curve, SwingCurves};
use polynomial::{Approximation, Form, Kernel, LOW, Variables};
use reduction::{Clock, Reduction};

/// What is emitted, and what it promises.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub(crate) method: Method,
    pub(crate) reduction: Reduction,
    pub(crate) parts: Vec<Part>,
    pub(crate) functions: Vec<Function>,
    /// The b₂ₙ₋₁ of a plan with the paper's formula, else empty.
    pub(crate) coefficients: Vec<Real>,
    /// The alternatives and why each lost.
    pub(crate) rejected: Vec<String>,
}

/// One output's polynomials and its error.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) output: Output,
    pub(crate) kernels: Vec<Kernel>,
    /// What the kernels are, for the reader.
    pub(crate) description: String,
    pub(crate) bound: Bound,
    /// What an error of 1 in the output's own unit is: 1, ω, ω².
    pub(crate) unit: f64,
}

/// A proven bound of the error over the horizon, in the output's unit, and what it is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bound {
    /// The approximation's distance from the curve.
    pub(crate) truncation: f64,
    /// What the error of the phase makes of it.
    pub(crate) phase: f64,
    /// Rounding of coefficients and operations.
    pub(crate) evaluation: f64,
}

impl Bound {
    pub(crate) fn total(self) -> f64 {
        (self.truncation + self.phase + self.evaluation) * (1.0 + 1e-12)
    }
}

/// One emitted function.
#[derive(Clone, Debug)]
pub(crate) struct Function {
    pub(crate) name: &'static str,
    pub(crate) program: Program,
}

/// Why there is no plan.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Refusal {
    /// No plan reaches the tolerance; the best promises this.
    Unreachable { best: f64 },
}

impl Refusal {
    /// The error at the token to blame.
    pub(crate) fn explain(&self, scene: &Scene) -> syn::Error {
        match self {
            Self::Unreachable { best } => syn::Error::new_spanned(
                &scene.blame.goal,
                format!(
                    "this error can't be promised with `{}`: the best is {best:.2e}; ask for that, or leave `tol` out",
                    scene.float.word()
                ),
            ),
        }
    }
}

/// What one output has to keep.
struct Aim {
    output: Output,
    curves: Vec<Curve>,
    /// For the total, in the curve's own unit.
    limit: f64,
    /// For the truncation alone.
    truncation: f64,
}

/// Plans a scene.
pub(crate) fn plan(scene: &Scene) -> Result<Plan, Refusal> {
    let Regime::Swing(swing) = &scene.motion.regime else { todo!("other regimes") };
    swing_plan(scene, swing)
}

fn swing_plan(scene: &Scene, swing: &Swing) -> Result<Plan, Refusal> {
    let curves = SwingCurves::new(swing, &scene.motion.omega);
    let aims: Vec<Aim> = scene.outputs.iter().map(|&output| aim(scene, &curves, output)).collect();
    let rate = crate::series::swing_rate(swing);
    let clock = Clock {
        rate: &rate,
        launch: swing.launch.to_double(),
        t_max: scene.t_max.as_ref().map(Real::to_f64),
        float: scene.float,
    };
    let approximations = approximate(&aims);
    let mut best: Option<(f64, Plan)> = None;
    let mut closest = f64::INFINITY;
    for reduction in clock.reductions() {
        for form in [Form::Plain, Form::Centred] {
            match candidate(scene, swing.mirrored, &aims, &approximations, &reduction, form) {
                Ok(plan) => {
                    let cost = plan.cost();
                    if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                        best = Some((cost, plan));
                    }
                }
                Err(reached) => closest = closest.min(reached),
            }
        }
    }
    best.map(|(_, plan)| plan).ok_or(Refusal::Unreachable { best: closest })
}

fn aim(scene: &Scene, curves: &SwingCurves, output: Output) -> Aim {
    let curves = match output {
        Output::Theta | Output::Wrapped => vec![curves.theta()],
        Output::Velocity => vec![curves.velocity()],
        Output::Acceleration => vec![curves.acceleration()],
        Output::Position => vec![curves.sine(), curves.height()],
    };
    let unit = scene.float.unit();
    let largest = curves.iter().map(|curve| curve.largest).fold(0.0, f64::max);
    let (limit, truncation) = match scene.goal {
        Goal::Tolerance(tol) => (tol * curves[0].unit, tol * curves[0].unit),
        _ => (16.0 * unit * largest, unit * largest),
    };
    Aim { output, curves, limit, truncation }
}

fn approximate(aims: &[Aim]) -> Vec<Vec<Approximation>> {
    let one = |aim: &Aim, curve| Approximation::new(curve, (aim.truncation * 2f64.powi(-7)).min(curve.largest));
    aims.iter().map(|aim| aim.curves.iter().filter_map(|curve| one(aim, curve)).collect()).collect()
}

/// The plan with this reduction and form, or the smallest limit that it would keep.
fn candidate(
    scene: &Scene,
    mirrored: bool,
    aims: &[Aim],
    approximations: &[Vec<Approximation>],
    reduction: &Reduction,
    form: Form,
) -> Result<Plan, f64> {
    let mut parts = Vec::new();
    for (aim, approximations) in aims.iter().zip(approximations) {
        if approximations.len() < aim.curves.len() {
            return Err(f64::INFINITY);
        }
        parts.push(part(aim, approximations, reduction, form, mirrored)?);
    }
    let functions = functions(scene.float, reduction, &parts);
    Ok(Plan {
        method: Method::Polynomial,
        reduction: reduction.clone(),
        parts,
        functions,
        coefficients: Vec::new(),
        rejected: Vec::new(),
    })
}

/// The fewest terms that keep one output's promise.
fn part(
    aim: &Aim,
    approximations: &[Approximation],
    reduction: &Reduction,
    form: Form,
    mirrored: bool,
) -> Result<Part, f64> {
    let phase = aim.curves.iter().map(|curve| curve.slope).fold(0.0, f64::max) * reduction.error;
    let mut evaluation = 0.0;
    let mut reached = f64::INFINITY;
    for _ in 0..4 {
        let share = if aim.curves.len() > 1 { std::f64::consts::FRAC_1_SQRT_2 } else { 1.0 };
        let left = ((aim.limit - phase - evaluation).min(aim.truncation)) * share;
        let mut kernels = Vec::new();
        for (curve, approximation) in aim.curves.iter().zip(approximations) {
            let Some(terms) = approximation.terms_for(left, reduction.overshoot) else {
                return Err(phase + evaluation + approximation.truncation(approximation.terms(), reduction.overshoot));
            };
            let mut kernel = approximation.kernel(terms, form, reduction, curve.alternates);
            if mirrored && curve.alternates {
                kernel.coefficients.iter_mut().for_each(|c| *c = -*c);
            }
            kernels.push(kernel);
        }
        let bounds: Vec<f64> = kernels.iter().map(|kernel| rounding(kernel, reduction)).collect();
        evaluation = norm(bounds.iter().copied());
        let bound = Bound { truncation: norm(kernels.iter().map(|k| k.truncation)), phase, evaluation };
        reached = reached.min(bound.total());
        if bound.total() <= aim.limit {
            let terms: Vec<String> = kernels.iter().map(|kernel| kernel.coefficients.len().to_string()).collect();
            let description = format!("polynomial of {} terms in {}", terms.join(" and "), form.variable());
            return Ok(Part { output: aim.output, kernels, description, bound, unit: aim.curves[0].unit });
        }
    }
    Err(reached)
}

fn norm(parts: impl Iterator<Item = f64>) -> f64 {
    parts.map(|x| x * x).sum::<f64>().sqrt().max(0.0)
}

/// Subintervals of the phase on which the rounding is analysed separately.
const SLICES: usize = 16;

/// The rounding of a kernel over the whole range of the phase, taken as exact.
fn rounding(kernel: &Kernel, reduction: &Reduction) -> f64 {
    let program = function(reduction, &[kernel], false);
    let phase = program.named("s").unwrap_or(0);
    let low = program.named("low").map(|low| (low, Known::between(-LOW / reduction.unit.hi, LOW / reduction.unit.hi)));
    let half = reduction.half();
    (0..SLICES)
        .map(|slice| {
            let at = |index: usize| half * index as f64 / SLICES as f64;
            let known: Vec<_> = [(phase, Known::between(at(slice), at(slice + 1)))].into_iter().chain(low).collect();
            program.rounding(&known).iter().map(|k| k.error).fold(0.0, f64::max)
        })
        .fold(0.0, f64::max)
}

fn function(reduction: &Reduction, kernels: &[&Kernel], keep_sign: bool) -> Program {
    const NAMES: [&str; 3] = ["a", "b", "c"];
    let mut b = Builder::new(reduction.float);
    let t = b.input();
    let phase = reduction.lower(&mut b, t);
    let variables = Variables::lower(&mut b, phase, reduction, keep_sign);
    let results = kernels.iter().zip(NAMES).map(|(kernel, name)| kernel.lower(&mut b, variables, name)).collect();
    b.finish(results)
}

/// A function per output, and `state` for θ and velocity together.
fn functions(_float: Float, reduction: &Reduction, parts: &[Part]) -> Vec<Function> {
    let odd = |kernels: &[&Kernel]| kernels.iter().any(|k| k.parity == crate::series::Parity::Odd);
    let mut functions: Vec<Function> = parts
        .iter()
        .map(|part| {
            let kernels: Vec<&Kernel> = part.kernels.iter().collect();
            Function { name: part.output.word(), program: function(reduction, &kernels, odd(&kernels)) }
        })
        .collect();
    let of = |output| parts.iter().find(|part| part.output == output);
    if let (Some(theta), Some(velocity)) = (of(Output::Theta), of(Output::Velocity)) {
        let kernels: Vec<&Kernel> = theta.kernels.iter().chain(&velocity.kernels).collect();
        functions.push(Function { name: "state", program: function(reduction, &kernels, true) });
    }
    functions
}

impl Plan {
    /// The cost of all functions; `state` stands for the two that it joins.
    pub(crate) fn cost(&self) -> f64 {
        self.functions.iter().map(|function| function.program.cost()).sum()
    }

    /// Operations of the first function.
    pub(crate) fn operations(&self) -> usize {
        self.functions.first().map_or(0, |function| function.program.operations())
    }

    /// Terms of the first output's first kernel.
    pub(crate) fn terms(&self) -> usize {
        let kernel = self.parts.first().and_then(|part| part.kernels.first());
        kernel.map_or(self.coefficients.len(), |kernel| kernel.coefficients.len())
    }

    /// Whether `core` alone can evaluate it at compile time: it can't take roots there.
    pub(crate) fn is_const(&self) -> bool {
        let has_root = |program: &Program| program.nodes.iter().any(|node| matches!(node.op, Op::Sqrt(_)));
        !self.functions.iter().any(|function| has_root(&function.program))
    }
}

#[cfg(test)]
mod tests;
