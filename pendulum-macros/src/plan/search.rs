//! The cheapest polynomials: every reduction with every form, in the order of their estimated cost, until one keeps the
//! promise.

use super::aim::{Aim, Task};
use super::curve::Curve;
use super::hyperbolic::{Hyperbolic, Passage};
use super::kernel::{self, Kernel, norm};
use super::polynomial::{Approximation, Form, Polynomial};
use super::reduction::{Origin, Reduction};
use super::turning::Turning;
use super::variables::Variables;
use super::{Bound, Part, Plan, Refusal, alternatives, verify};
use crate::parse::Output;
use crate::program::cost::QUOTIENT;
use crate::program::{Builder, Program};
use crate::scene::{Goal, Scene};
use crate::series::Parity;
use pendulum_runtime::double::Double;

/// The variables tried.
const FORMS: [Form; 3] = [Form::Plain, Form::Centred { centre: 1.0 }, Form::Centred { centre: 1.25 }];

/// One way of computing all outputs.
struct Candidate<'a> {
    reduction: &'a Reduction,
    way: Way,
    /// Estimated; no less than a term too low.
    cost: f64,
}

/// How the outputs follow from the phase.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// Polynomials; `divided` tells whether poles are divided out.
    Polynomial { form: Form, divided: bool },
    /// The passage through the lowest point.
    Passage,
}

/// An output's approximations, without and with its poles divided out.
struct Approximations {
    plain: Vec<Approximation>,
    divided: Vec<Approximation>,
}

impl Approximations {
    fn new(aim: &Aim) -> Self {
        // So far below the aim that it doesn't blur the bound of a plan that, for want of half terms, is much better.
        let negligible = |curve: &Curve| (aim.truncation.min(curve.largest) * 2f64.powi(-30)).max(aim.floor() / 128.0);
        let all = |power| aim.curves.iter().filter_map(|c| Approximation::new(c, power, negligible(c))).collect();
        Self { plain: all(0), divided: if aim.power > 0 { all(aim.power) } else { Vec::new() } }
    }

    /// Those of a candidate; outputs without poles have no choice.
    fn choose(&self, divided: bool) -> &[Approximation] {
        if divided && !self.divided.is_empty() { &self.divided } else { &self.plain }
    }
}

/// The cheapest plan. Full precision is 2⁻⁴⁹ of the largest value; where rounding takes more, as it does of some
/// accelerations near the top, the best is what is less than twice that.
pub(super) fn plan(scene: &Scene) -> Result<Plan, Refusal> {
    let mut task = Task::new(scene);
    match (cheapest(scene, &task), scene.goal) {
        (Err(Refusal::Unreachable { .. }), Goal::Full) => {
            task.aims.iter_mut().for_each(|aim| aim.limit *= 2.0);
            cheapest(scene, &task)
        }
        // The best that can be promised is what full precision promises.
        (Err(Refusal::Unreachable { best }), Goal::Tolerance(_)) => {
            task.aims.iter_mut().for_each(|aim| aim.at_full_precision(scene.float));
            let best = cheapest(scene, &task).map_or(best, |plan| plan.worst());
            Err(Refusal::Unreachable { best })
        }
        (result, _) => result,
    }
}

fn cheapest(scene: &Scene, task: &Task) -> Result<Plan, Refusal> {
    let approximations: Vec<Approximations> = task.aims.iter().map(Approximations::new).collect();
    let reductions = task.reductions(scene);
    let mut closest = f64::INFINITY;
    let mut rejected = Vec::new();
    let candidates = candidates(scene, &reductions, task, &approximations);
    for (index, candidate) in candidates.iter().enumerate() {
        match candidate.plan(scene, task, &approximations) {
            Ok(plan) => {
                if let Some(output) = verify::broken(scene, task, &plan) {
                    return Err(Refusal::Broken { output });
                }
                let next =
                    candidates.get(index + 1..).and_then(|rest| rest.iter().find(|next| next.way != candidate.way));
                rejected.extend(
                    next.map(|next| format!("{}: it costs about {:.0} operations", next.describe(), next.cost)),
                );
                rejected.extend(alternatives::costs(scene, candidate.reduction));
                return Ok(Plan { rejected, ..plan });
            }
            Err(reached) => {
                closest = closest.min(reached);
                rejected.push(format!("{}: it can promise only {reached:.1e}", candidate.describe()));
            }
        }
    }
    Err(Refusal::Unreachable { best: closest })
}

/// All plans that keep the promise, whatever they cost.
#[cfg(test)]
pub(super) fn every(scene: &Scene) -> Vec<Plan> {
    let task = Task::new(scene);
    let approximations: Vec<Approximations> = task.aims.iter().map(Approximations::new).collect();
    let reductions = task.reductions(scene);
    let candidates = candidates(scene, &reductions, &task, &approximations);
    candidates.iter().filter_map(|candidate| candidate.plan(scene, &task, &approximations).ok()).collect()
}

/// Every combination that might serve, cheapest first.
fn candidates<'a>(
    scene: &Scene,
    reductions: &'a [Reduction],
    task: &Task,
    approximations: &[Approximations],
) -> Vec<Candidate<'a>> {
    let mut candidates = Vec::new();
    // At full precision the angle of a rotation is to be as good as it can be where it is small.
    let angle = |aim: &Aim| matches!(aim.output, Output::Theta | Output::Wrapped);
    let from_lowest = task.turning && scene.goal == Goal::Full && task.aims.iter().any(angle);
    for reduction in reductions.iter().filter(|reduction| !from_lowest || reduction.origin == Origin::Lowest) {
        let base = skeleton(reduction, Form::Plain, &task.aims).cost();
        for way in polynomial_ways(&task.aims) {
            let Way::Polynomial { form, divided } = way else { continue };
            let extra = if form == Form::Plain && !divided { 0.0 } else { 2.0 };
            let kernels = task.aims.iter().zip(approximations);
            let kernels = kernels.map(|(aim, all)| aim.estimate(all.choose(divided), reduction, divided));
            if let Some(cost) = kernels.sum::<Option<f64>>() {
                candidates.push(Candidate { reduction, way, cost: base + extra + cost });
            }
        }
    }
    if task.passage.is_some() && scene.method.is_none() {
        for reduction in reductions.iter().filter(|reduction| reduction.origin == Origin::Lowest) {
            let base = skeleton(reduction, Form::Plain, &task.aims).cost();
            let kernels: f64 = task.aims.iter().map(Aim::passage_estimate).sum();
            candidates.push(Candidate { reduction, way: Way::Passage, cost: base + kernels });
        }
    }
    candidates.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    candidates
}

/// The polynomials tried; none where there are no curves.
fn polynomial_ways(aims: &[Aim]) -> Vec<Way> {
    if aims.iter().any(|aim| aim.curves.is_empty()) {
        return Vec::new();
    }
    let poles = aims.iter().any(|aim| aim.power > 0);
    let divisions: &[bool] = if poles { &[false, true] } else { &[false] };
    FORMS.iter().flat_map(|&form| divisions.iter().map(move |&divided| Way::Polynomial { form, divided })).collect()
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
            // The division, and the three operations of a pole.
            let quotient = if divided && self.power > 0 { QUOTIENT + 3.0 } else { 0.0 };
            let signs = if curve.alternates && reduction.origin == Origin::Lowest { 1.3 } else { 0.0 };
            Some(2.0 * terms + terms.log2().floor() + quotient + signs)
        };
        self.curves.iter().zip(approximations).map(one).sum()
    }

    /// The cost of the passage's kernel: an exponential, an arctangent for an angle, and what joins them.
    fn passage_estimate(&self) -> f64 {
        let bits = -(self.limit / self.unit.max(self.largest)).log2().min(-4.0);
        let angle = matches!(self.output, Output::Theta | Output::Wrapped);
        30.0 + 2.0 * (3.0 + bits / 5.0) + if angle { bits / 1.3 } else { 16.0 }
    }

    /// The fewest terms that keep the promise, or what was reached.
    fn part(
        &self,
        scene: &Scene,
        task: &Task,
        approximations: &[Approximation],
        reduction: &Reduction,
        form: Form,
    ) -> Result<Part, f64> {
        let phase = self.phase_error(reduction);
        let mut evaluation = 0.0;
        let mut reached = f64::INFINITY;
        for _ in 0..3 {
            let left = self.share(self.limit - phase - evaluation);
            let mut polynomials = Vec::new();
            for (curve, approximation) in self.curves.iter().zip(approximations) {
                let Some(terms) = approximation.terms_for(left, reduction.overshoot) else {
                    let least = approximation.truncation(approximation.terms(), reduction.overshoot);
                    return Err(reached.min((phase + evaluation + least) / self.unit));
                };
                polynomials.push(approximation.polynomial(terms, form, reduction, curve.alternates));
            }
            let truncation = self.error(norm(polynomials.iter().map(|polynomial| polynomial.truncation)));
            let kernel = self.kernel(scene, task, reduction, polynomials);
            let bound = Bound { truncation, phase, evaluation: kernel.rounding(reduction, self.limit) };
            let grows = scene.goal == Goal::Full && self.output == Output::Theta;
            let turns = if grows { 0.0 } else { kernel.rounding_of_turns(reduction) };
            evaluation = bound.evaluation + turns;
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

    /// The angle of a rotation, wrapped or with its turns; anything else as it is.
    fn turned(&self, scene: &Scene, task: &Task, kernel: Kernel, from_top: Option<&Reduction>) -> Kernel {
        let wrapped = self.output == Output::Wrapped;
        if !task.turning || !matches!(self.output, Output::Theta | Output::Wrapped) {
            return kernel;
        }
        let (direction, turns) = (task.direction, task.turns(scene));
        let unit = from_top.map_or(Double::ONE, |reduction| reduction.unit);
        let (angle, from_top) = (Box::new(kernel), from_top.is_some());
        Kernel::Turning(Turning { angle, from_top, unit, wrapped, direction, turns })
    }

    /// The kernel of the passage through the lowest point, or what it reaches.
    fn passage_part(&self, scene: &Scene, task: &Task, reduction: &Reduction, passage: &Passage) -> Result<Part, f64> {
        let phase = self.passage_error(reduction, passage);
        let factor = match self.output {
            Output::Velocity => Task::fastest(scene),
            Output::Acceleration => scene.motion.omega.square().to_double(),
            _ => Double::ONE,
        };
        let scaled = Passage { rate: passage.rate * reduction.unit, half: reduction.half(), ..passage.clone() };
        let mut limit = self.limit.min(self.truncation) / factor.hi;
        let mut reached = f64::INFINITY;
        for _ in 0..3 {
            let kernel = Hyperbolic::new(self.output, scaled.clone(), factor, limit);
            let truncation = kernel.truncation * factor.hi;
            let kernel = self.turned(scene, task, Kernel::Hyperbolic(Box::new(kernel)), None);
            let bound = Bound { truncation, phase, evaluation: kernel.rounding(reduction, self.limit) };
            match self.accept(scene, kernel, bound, reduction) {
                Ok(part) => return Ok(part),
                Err(total) => reached = reached.min(total),
            }
            limit *= 0.125;
        }
        Err(reached)
    }

    /// The part if it keeps the promise, else the bound reached, in units of the tolerance. At full precision the turns of
    /// an angle that grows without bound cost what they cost: the promise is about the rest.
    fn accept(&self, scene: &Scene, kernel: Kernel, bound: Bound, reduction: &Reduction) -> Result<Part, f64> {
        let turns = kernel.rounding_of_turns(reduction);
        let whole = Bound { evaluation: bound.evaluation + turns, ..bound };
        let grows = scene.goal == Goal::Full && self.output == Output::Theta;
        let judged = if grows { bound } else { whole };
        if judged.total() > self.limit {
            return Err(judged.total() / self.unit);
        }
        let (output, unit, largest) = (self.output, self.unit, self.largest);
        Ok(Part { output, description: kernel.describe(), kernel, bound: whole, unit, largest })
    }
}

impl Way {
    fn word(self) -> &'static str {
        match self {
            Self::Polynomial { .. } => "polynomial",
            Self::Passage => "passage",
        }
    }
}

impl Candidate<'_> {
    /// For the reader of the docs.
    fn describe(&self) -> String {
        match self.way {
            Way::Polynomial { form, divided } => {
                let poles = if divided { " over the nearest poles" } else { "" };
                format!("a polynomial in {}{poles}, phase by {}", form.variable(), self.reduction.describe())
            }
            Way::Passage => format!("the passage through the lowest point, phase by {}", self.reduction.describe()),
        }
    }

    fn plan(&self, scene: &Scene, task: &Task, approximations: &[Approximations]) -> Result<Plan, f64> {
        let part = |(aim, all): (&Aim, &Approximations)| match (self.way, &task.passage) {
            (Way::Polynomial { form, divided }, _) => aim.part(scene, task, all.choose(divided), self.reduction, form),
            (Way::Passage, Some(passage)) => aim.passage_part(scene, task, self.reduction, passage),
            (Way::Passage, None) => Err(f64::INFINITY),
        };
        let parts = task.aims.iter().zip(approximations).map(part).collect::<Result<Vec<Part>, f64>>()?;
        let functions = kernel::functions(self.reduction, &parts);
        Ok(Plan {
            method: self.way.word(),
            reduction: self.reduction.clone(),
            parts,
            functions,
            coefficients: Vec::new(),
            rejected: Vec::new(),
        })
    }
}
