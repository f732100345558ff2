//! The methods of the paper, and the series of θ: sums of harmonics of one cosine.

mod parts;
mod pieces;
mod whole;

use super::aim::FULL;
use super::curve::{Curve, Curves, SwingCurves};
use super::kernel;
use super::reduction::{Clock, Reduction, UNLIMITED};
use super::{Bound, Part, Plan, Refusal, bias};
use crate::exact::Real;
use crate::motion::Swing;
use crate::parse::{Method, Output};
use crate::scene::{Goal, Scene};
use crate::supremum::worst;
use parts::Wanted;
use pendulum_runtime::double::Double;
use pendulum_runtime::fourier_analysis::FourierAnalysis;

/// More terms than this aren't chosen for a tolerance: the analysis of longer sums takes the compiler longer than a
/// second.
const MOST_CHOSEN: usize = 128;

/// How far certified suprema may exceed the true ones.
const SLACK: f64 = 1e-3;

/// The plan of a forced method, or of the paper's θ̂.
pub(super) fn plan(scene: &Scene, swing: &Swing, method: Method) -> Result<Plan, Refusal> {
    let mut reached = f64::INFINITY;
    let mut terms = None;
    // The terms are chosen for θ; its derivative may need some more, as long as these help.
    for more in MORE {
        let sum = Sum::choose(scene, swing, method, more, &mut terms)?;
        if sum.weights.len() >= MOST_CHOSEN && !matches!(scene.goal, Goal::Terms(_)) {
            return Err(Refusal::Unreachable { best: f64::INFINITY });
        }
        match sum.plan(scene, swing) {
            Err(Refusal::Unreachable { best }) if matches!(method, Method::Fourier | Method::Series) => {
                if best > reached * 0.9 || best.is_infinite() && more > 2 {
                    break;
                }
                reached = best;
            }
            other => return other,
        }
        if matches!(scene.goal, Goal::Terms(_)) {
            break;
        }
    }
    Err(Refusal::Unreachable { best: reached })
}

/// How many terms more than θ needs are tried.
const MORE: [usize; 8] = [0, 1, 2, 3, 5, 8, 13, 21];

/// The weights that a method gives to the harmonics of the phase.
struct Sum {
    method: Method,
    /// Anchors per unit of time: of the small-angle motion where that is the method.
    rate: Real,
    /// Of cos((2n−1)πs).
    weights: Vec<Double>,
    /// b₂ₙ₋₁, where the weights are those of k sn.
    coefficients: Vec<Real>,
    /// sup |approximation − exact| for θ.
    bias: f64,
}

impl Sum {
    fn choose(
        scene: &Scene,
        swing: &Swing,
        method: Method,
        more: usize,
        terms: &mut Option<usize>,
    ) -> Result<Self, Refusal> {
        let rate = swing.rate();
        let amplitude = || vec![swing.amplitude.to_double()];
        match method {
            Method::Fourier => Self::fourier(scene, swing, rate, more, terms),
            Method::Series => Ok(Self::series(scene, swing, rate, more)),
            Method::SmallAngle => {
                let small = &scene.motion.omega / scene.motion.omega.context().pi();
                // Any time: the phase goes as far as it makes a difference.
                let apart = swing.amplitude.to_f64() * bias::of_moved_cosine(0.5, drift(&small, scene, swing));
                let bias = harmonic_bias(scene, swing) + apart;
                Ok(Self { method, rate: small, weights: amplitude(), coefficients: Vec::new(), bias })
            }
            _ => Ok(Self {
                method,
                rate,
                weights: amplitude(),
                coefficients: Vec::new(),
                bias: harmonic_bias(scene, swing),
            }),
        }
    }

    /// k b₂ₙ₋₁ with alternating signs: `k sn_N(u + K)` (Eq. 22). `terms` keeps how many θ needs.
    fn fourier(
        scene: &Scene,
        swing: &Swing,
        rate: Real,
        more: usize,
        terms: &mut Option<usize>,
    ) -> Result<Self, Refusal> {
        let elliptic = &swing.elliptic;
        let analysis = elliptic.fourier_analysis();
        let n = match scene.goal {
            Goal::Terms(n) => n,
            Goal::Tolerance(tol) => more + *terms.get_or_insert_with(|| fewest(&analysis, scene, swing, tol * 0.99)),
            Goal::Full => fewest(&analysis, scene, swing, scene.float.unit() * swing.amplitude.to_f64()),
        };
        if let Some(overshoot) = analysis.overshoot(n) {
            let smallest = swing.smallest_working_terms(scene.float.unit());
            let smallest = smallest.and_then(|smallest| planned(scene, swing, smallest));
            return Err(Refusal::Overshoot { terms: n, overshoot, smallest });
        }
        let coefficients = swing.fourier_coefficients(n);
        let weights = swing.half_sine_weights(&coefficients);
        Ok(Self { method: Method::Fourier, rate, weights, coefficients, bias: analysis.certified_bound(n, SLACK) })
    }

    /// The series of θ; its tail's supremum is bounded by samples finer than its fastest harmonic.
    fn series(scene: &Scene, swing: &Swing, rate: Real, more: usize) -> Self {
        let theta = SwingCurves::new(swing, &scene.motion.omega).angle();
        let terms = theta.terms();
        let aim = match scene.goal {
            Goal::Tolerance(tol) => tol * 0.98,
            _ => scene.float.unit() * swing.amplitude.to_f64(),
        };
        let fewest = (1..terms.len()).find(|&kept| terms[kept].1.hi.abs() / 2.0 <= aim).unwrap_or(terms.len());
        if fewest >= MOST_CHOSEN {
            let weights = terms[..MOST_CHOSEN].iter().map(|&(_, a)| a).collect();
            let bias = left_out(&theta, MOST_CHOSEN);
            return Self { method: Method::Series, rate, weights, coefficients: Vec::new(), bias };
        }
        let kept = (fewest..=terms.len()).find(|&kept| left_out(&theta, kept) <= aim).unwrap_or(terms.len());
        let kept = (kept + more).min(MOST_CHOSEN).min(terms.len());
        let weights = terms[..kept].iter().map(|&(_, a)| a).collect();
        Self { method: Method::Series, rate, weights, coefficients: Vec::new(), bias: left_out(&theta, kept) }
    }
}

/// More terms than this are bounded by the sum of their magnitudes.
const MOST_SAMPLED: usize = 40;

/// sup |Σ aₘ cos mφ| over the terms of θ but the first `kept`.
fn left_out(theta: &Curve, kept: usize) -> f64 {
    match &theta.terms()[kept..] {
        many if many.len() > MOST_SAMPLED => many.iter().map(|(_, a)| a.hi.abs()).sum::<f64>() + theta.omitted(),
        few => tail(few, theta.omitted()),
    }
}

/// sup |Σ aₘ cos mφ| from 16 samples a wave of the highest harmonic M: at most a factor 1/cos(π/16) above the largest
/// sample (Ehlich and Zeller 1964); and `omitted`, which bounds terms besides.
fn tail(terms: &[(u32, Double)], omitted: f64) -> f64 {
    let Some(&(highest, _)) = terms.last() else { return omitted };
    let points = 8 * highest;
    let at = |i: u32| {
        let phi = std::f64::consts::PI * f64::from(i) / f64::from(points);
        terms.iter().map(|&(m, a)| a.hi * libm::cos(f64::from(m) * phi)).sum::<f64>().abs()
    };
    worst((0..=points / 2).map(at)) / libm::cos(std::f64::consts::PI / 16.0) * (1.0 + 1e-9) + omitted
}

/// sup |θ0 cos πs − θ(s)|, of which both are sums of harmonics. So near the top that these are many, θ stays at ±θ0
/// while the cosine passes zero: they have the same sign, so θ0 is a bound, and they come to be that far apart.
fn harmonic_bias(scene: &Scene, swing: &Swing) -> f64 {
    let theta = SwingCurves::new(swing, &scene.motion.omega).angle();
    if theta.terms().len() > bias::MOST_TERMS {
        return swing.amplitude.to_f64() * (1.0 + f64::EPSILON);
    }
    let mut terms = theta.terms().to_vec();
    if let Some(first) = terms.first_mut() {
        first.1 = first.1 - swing.amplitude.to_double();
    }
    tail(&terms, theta.omitted())
}

/// The first number of terms from `smallest` on, of a few, that is planned: without overshoot an error may still be too
/// near to it to be bounded.
fn planned(scene: &Scene, swing: &Swing, smallest: usize) -> Option<usize> {
    let ask = |n: usize| plan(&Scene { goal: Goal::Terms(n), ..scene.clone() }, swing, Method::Fourier);
    (smallest..=swing.most_useful_terms(scene.float.unit())).take(3).find(|&n| ask(n).is_ok())
}

/// The fewest terms that don't overshoot and come within `tol`, by bisection: more terms are better. Where none are,
/// one.
fn fewest(analysis: &FourierAnalysis, scene: &Scene, swing: &Swing, tol: f64) -> usize {
    let Some(mut fails) = swing.smallest_working_terms(scene.float.unit()) else { return 1 };
    let mut serves = fails;
    while serves < MOST_CHOSEN && analysis.supremum(serves) >= tol {
        (fails, serves) = (serves, (serves * 2).min(MOST_CHOSEN));
    }
    while serves > fails + 1 {
        let middle = usize::midpoint(fails, serves);
        *(if analysis.supremum(middle) < tol { &mut serves } else { &mut fails }) = middle;
    }
    serves
}

/// By how many anchors a phase of another rate comes to differ from the exact one within the horizon.
fn drift(rate: &Real, scene: &Scene, swing: &Swing) -> f64 {
    let exact = swing.rate();
    let horizon = scene.t_max.as_ref().map_or_else(|| UNLIMITED / exact.to_f64(), Real::to_f64);
    (rate - &exact).abs().to_f64() * horizon
}

/// Whether the bound of what was not asked to be small says anything: of a velocity, that it is less than twice the
/// largest.
fn is_useful(part: &Part, scene: &Scene) -> bool {
    let bound = part.bound.total();
    let vague = matches!(scene.goal, Goal::Terms(_)) && part.output == Output::Velocity && bound > 2.0 * part.largest;
    bound.is_finite() && !vague
}

impl Sum {
    /// The cheapest reduction with which the promise is kept, or, if nothing is promised, whose error is beside the
    /// rounding of the rest.
    fn plan(&self, scene: &Scene, swing: &Swing) -> Result<Plan, Refusal> {
        if let Some(&output) = scene.outputs.iter().find(|output| !matches!(output, Output::Theta | Output::Velocity)) {
            return Err(Refusal::Output { method: self.method, output });
        }
        let wanted = self.wanted(scene, swing);
        // Where the sum itself is too far from the motion no reduction helps.
        if wanted.iter().any(|wanted| wanted.bias > self.promise(scene, &wanted.curve)) {
            let best = worst(wanted.iter().map(|wanted| wanted.bias / wanted.curve.size.unit));
            return Err(Refusal::Unreachable { best });
        }
        self.cheapest(scene, swing, &wanted)
    }

    /// The reductions, cheapest first.
    fn reductions(&self, scene: &Scene, swing: &Swing, wanted: &[Wanted]) -> Vec<Reduction> {
        let mut reductions = Clock::new(scene, &self.rate, &swing.launch).of_swing(swing);
        reductions.sort_by_key(Reduction::operations);
        // If nothing is promised, the phase's error is to be beside the rounding.
        let fine = |wanted: &Wanted, reduction: &Reduction| {
            wanted.curve.size.phase_error(reduction) <= 8.0 * scene.float.unit() * wanted.curve.size.largest
        };
        if !matches!(scene.goal, Goal::Tolerance(_)) {
            reductions.retain(|reduction| wanted.iter().all(|wanted| fine(wanted, reduction)));
        }
        reductions
    }

    fn cheapest(&self, scene: &Scene, swing: &Swing, wanted: &[Wanted]) -> Result<Plan, Refusal> {
        let mut closest = f64::INFINITY;
        let mut hopeless = Vec::new();
        let mut found: Option<Plan> = None;
        for reduction in &self.reductions(scene, swing, wanted) {
            // A dearer reduction is worth a look only where it leads to pieces and a cheaper one didn't.
            if found.is_some() && !(reduction.has_pieces() && wanted.iter().any(Wanted::has_pieces)) {
                continue;
            }
            // Where the phase alone is too wrong, or everything else is, with a phase from the same origin.
            let lost = |wanted: &Wanted| wanted.curve.size.phase_error(reduction) > self.promise(scene, &wanted.curve);
            if wanted.iter().any(lost) || hopeless.contains(&reduction.origin) {
                continue;
            }
            let parts: Vec<Part> = wanted.iter().map(|wanted| self.part(scene, swing, wanted, reduction)).collect();
            let kept = |error: fn(Bound) -> f64| {
                let promises = wanted.iter().map(|wanted| self.promise(scene, &wanted.curve));
                parts.iter().zip(promises).all(|(part, promise)| error(part.bound) <= promise)
            };
            // What computes the arcsine as well is made for what the phase leaves: of a finer one it may be better.
            if !kept(|bound| bound.truncation + bound.evaluation) && !wanted.iter().any(Wanted::is_whole) {
                hopeless.push(reduction.origin);
            }
            if kept(Bound::total) && parts.iter().all(|part| is_useful(part, scene)) {
                let plan = self.joined(reduction, parts);
                found = Some(found.filter(|found| found.cost() <= plan.cost()).unwrap_or(plan));
                if reduction.has_pieces() {
                    break;
                }
            } else {
                closest = closest.min(worst(parts.iter().map(Part::error)));
            }
        }
        found.ok_or(Refusal::Unreachable { best: closest })
    }

    fn joined(&self, reduction: &Reduction, parts: Vec<Part>) -> Plan {
        Plan {
            method: self.method.word(),
            reduction: reduction.clone(),
            functions: kernel::functions(reduction, &parts),
            parts,
            coefficients: self.coefficients.clone(),
            rejected: Vec::new(),
        }
    }

    /// The error that an output may have: without a tolerance the series, which has as many terms as it takes, is to
    /// be as good as full precision, of which half may be observed, and two thirds of what is proven are; the others are
    /// what they are.
    fn promise(&self, scene: &Scene, curve: &Curve) -> f64 {
        match scene.goal {
            Goal::Tolerance(tol) => curve.size.within(tol),
            Goal::Full if self.method == Method::Series => 0.75 * FULL * scene.float.unit() * curve.size.largest,
            Goal::Full | Goal::Terms(_) => f64::INFINITY,
        }
    }
}

#[cfg(test)]
mod tests;
