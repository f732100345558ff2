//! The methods of the paper, and the series of θ: sums of harmonics of one cosine.

mod bias;
mod count;
mod linearised;
mod parts;
mod series_in_pieces;
mod whole;

use super::aim::FULL;
use super::curve::{Curve, Curves, SwingCurves};
use super::met::Met;
use super::observed::{BY_RECURRENCE, observed};
use super::reduction::{Clock, Origin, Reduction};
use super::{Part, Plan, Refusal};
use crate::exact::{Context, Real};
use crate::motion::{Swing, direction};
use crate::parse::{Method, Output};
use crate::scene::{Goal, Scene};
use crate::supremum::worst;
use bias::MOST_HARMONICS;
pub(super) use count::planned;
use count::{MORE, MOST_CHOSEN, fewest, fewest_of_series};
use linearised::Linearised;
use parts::Wanted;
use pendulum_runtime::double::Double;

/// Where nothing was reached, these many terms more are tried nevertheless. Of 2461 random scenes with the methods of the
/// paper and of the series 1, 2 and 4 plan the same; with all of [`MORE`] refusals next to the top take up to three times
/// as long, for offers a tenth finer of three.
const TRIED_BLINDLY: usize = 2;

/// So many times the promise is near it. Were nothing near, one scene more of these would be planned, and of 15 refusals the
/// offers be up to 40 % finer, found in three times the time; were everything, two fewer.
const NEAR: f64 = 4.0;

/// The plan of a forced method, or of the paper's θ̂. Derivatives may need some terms more than θ.
pub(super) fn plan(scene: &Scene, swing: &Swing, method: Method) -> Result<Plan, Refusal> {
    let fewest = match method {
        Method::Fourier => fewest(scene, swing),
        Method::Series => fewest_of_series(scene, swing),
        _ => 1,
    };
    let is_given = matches!(scene.goal, Goal::Terms(_));
    let may_grow = matches!(method, Method::Fourier | Method::Series) && !is_given;
    // In pieces a series may have as many terms as its bias is known for. Next to the top Eq. 22 takes more than are chosen.
    let most = match method {
        Method::Series => MOST_HARMONICS,
        _ if fewest < MOST_CHOSEN => MOST_CHOSEN,
        _ => fewest + TRIED_BLINDLY + 1,
    };
    // What a sum leaves out that lacks terms is less than it would reach. What is reached may get worse before it gets
    // better: the rounding of pieces differs from one number of terms to the next.
    let (mut reached, mut left_out) = (None, f64::INFINITY);
    for more in MORE {
        let sum = Sum::new(scene, swing, method, fewest + more)?;
        if may_grow && sum.weights.len() >= most {
            break;
        }
        let wanted = sum.wanted();
        let planned = sum.plan(&wanted);
        let Err(Refusal::Unreachable { best }) = planned else { return planned };
        if sum.lacks_terms(&wanted) {
            left_out = left_out.min(best);
        } else {
            reached = Some(reached.map_or(best, |reached: f64| reached.min(best)));
        }
        let is_blind = best.is_infinite() && more > TRIED_BLINDLY;
        if !may_grow || is_blind || sum.is_hopeless(&wanted, best) {
            break;
        }
    }
    Err(Refusal::Unreachable { best: reached.unwrap_or(left_out) })
}

/// The weights that a method gives to the harmonics of the phase of a swing.
struct Sum<'a> {
    scene: &'a Scene,
    swing: &'a Swing,
    method: Method,
    /// Anchors per unit of time, and their number at t = 0: of the linearised motion where that is the method.
    rate: Real,
    launch: Real,
    /// Of cos((2n−1)πs).
    weights: Vec<Double>,
    /// b₂ₙ₋₁, where the weights are those of k sn.
    coefficients: Vec<Real>,
}

impl<'a> Sum<'a> {
    /// Of so many terms, where the method has more than one.
    fn new(scene: &'a Scene, swing: &'a Swing, method: Method, terms: usize) -> Result<Self, Refusal> {
        match method {
            Method::Fourier => Self::fourier(scene, swing, terms),
            Method::Series => {
                let theta = SwingCurves::new(swing, &scene.motion.omega).angle();
                Ok(Self::series(scene, swing, &theta, terms))
            }
            _ => Ok(Self::of_one(scene, swing, method)),
        }
    }

    /// The amplitude times a cosine.
    fn of_one(scene: &'a Scene, swing: &'a Swing, method: Method) -> Self {
        if method != Method::SmallAngle {
            return Self::of_weights(scene, swing, method, swing.rate(), vec![swing.amplitude.to_double()]);
        }
        let Linearised { amplitude, launch } = Linearised::new(&scene.motion, swing);
        let rate = scene.motion.omega.clone().settled() / Context::settled().pi();
        Self { launch, ..Self::of_weights(scene, swing, method, rate, vec![amplitude.to_double()]) }
    }

    fn of_weights(scene: &'a Scene, swing: &'a Swing, method: Method, rate: Real, weights: Vec<Double>) -> Self {
        Self { scene, swing, method, rate, launch: swing.launch.clone(), weights, coefficients: Vec::new() }
    }

    /// n terms k b₂ₙ₋₁ with alternating signs: `k sn_N(u + K)` (Eq. 22).
    fn fourier(scene: &'a Scene, swing: &'a Swing, n: usize) -> Result<Self, Refusal> {
        let unit = scene.float.rounding_unit();
        let smallest = || planned(scene, swing, swing.smallest_working_terms(unit)?);
        if scene.goal == Goal::Terms(n) {
            let most = swing.most_useful_terms(unit);
            if n > most {
                return Err(Refusal::Useless { terms: n, most, smallest: smallest() });
            }
        }
        if let Some(overshoot) = swing.elliptic.fourier_analysis().overshoot(n) {
            return Err(Refusal::Overshoot { terms: n, overshoot, smallest: smallest() });
        }
        let coefficients = swing.fourier_coefficients(n);
        let weights = swing.half_sine_weights(&coefficients);
        Ok(Self { coefficients, ..Self::of_weights(scene, swing, Method::Fourier, swing.rate(), weights) })
    }

    /// The first terms of the series of θ.
    fn series(scene: &'a Scene, swing: &'a Swing, theta: &Curve, kept: usize) -> Self {
        let first = theta.terms().iter().take(kept.min(MOST_HARMONICS));
        Self::of_weights(scene, swing, Method::Series, swing.rate(), first.map(|&(_, a)| a).collect())
    }

    /// What of our phase a short horizon meets.
    fn met(&self) -> Option<Met> {
        Met::within(self.scene, &self.rate, &self.launch)
    }

    /// The weights of the sum's derivative, a sum of sines: −wₙ(2n − 1)π·rate.
    fn slopes(&self) -> Vec<Double> {
        let rate = self.rate.to_double() * -Double::PI;
        self.weights.iter().enumerate().map(|(index, &w)| w * rate * (2 * index + 1) as f64).collect()
    }

    /// The weights of its second derivative: −wₙ((2n − 1)π·rate)².
    fn bends(&self) -> Vec<Double> {
        let rate = self.rate.to_double() * Double::PI;
        let bend = |(index, &w): (usize, &Double)| {
            let frequency = rate * (2 * index + 1) as f64;
            -(w * frequency * frequency)
        };
        self.weights.iter().enumerate().map(bend).collect()
    }

    /// −1 for a mirror image.
    fn direction(&self) -> f64 {
        direction(self.swing.mirrored)
    }
}

/// The part of what is allowed that a formula to be reproduced is wrong by counts before what it costs, where it is more than
/// all.
fn rank(share: f64, cost: f64) -> [f64; 2] {
    [share.max(1.0), cost]
}

fn rank_of(plan: &Plan) -> [f64; 2] {
    rank(worst(plan.parts.iter().map(|part| part.share)), plan.cost())
}

/// The largest of the outputs' errors, in units of the tolerance.
fn in_units(wanted: &[Wanted], error: impl Fn(&Wanted) -> f64) -> f64 {
    worst(wanted.iter().map(|wanted| error(wanted) / wanted.curve.size.unit))
}

/// Whether the bound of what was not asked to be small says anything: of a velocity, that it is less than twice the
/// largest.
fn is_useful(part: &Part, scene: &Scene) -> bool {
    let bound = part.bound.total();
    let vague = matches!(scene.goal, Goal::Terms(_)) && part.output == Output::Velocity && bound > 2.0 * part.largest;
    bound.is_finite() && !vague
}

impl Sum<'_> {
    /// Whether the sum itself is too far from the motion.
    fn lacks_terms(&self, wanted: &[Wanted]) -> bool {
        wanted.iter().any(|wanted| self.left(wanted) <= 0.0)
    }

    /// Whether terms of Eq. 22 don't help: where the rest alone is too much, of a sum that comes near.
    fn is_hopeless(&self, wanted: &[Wanted], reached: f64) -> bool {
        let (bias, promise) = (in_units(wanted, |of| of.bias), in_units(wanted, |of| self.promise(of)));
        self.method == Method::Fourier && reached - bias > promise && reached < NEAR * promise
    }

    /// The cheapest reduction with which the promise is kept, or, if nothing is promised, whose error is beside the
    /// rounding of the rest. Where the recurrence doesn't keep it, the series does in pieces.
    fn plan(&self, wanted: &[Wanted]) -> Result<Plan, Refusal> {
        // No reduction helps.
        if self.lacks_terms(wanted) {
            return Err(Refusal::Unreachable { best: in_units(wanted, |wanted| wanted.bias) });
        }
        if self.method != Method::Series {
            return self.cheapest(wanted);
        }
        let long = self.weights.len() >= MOST_CHOSEN;
        let too_long = Err(Refusal::Unreachable { best: f64::INFINITY });
        let summed = if long { too_long } else { self.cheapest(wanted) };
        let Err(Refusal::Unreachable { best }) = summed else { return summed };
        let in_pieces = self.in_pieces(wanted);
        in_pieces.map_err(|reached| Refusal::Unreachable { best: best.min(reached) })
    }

    /// The reductions, cheapest first; over a short horizon those that are as good as is taken for granted there.
    fn reductions(&self) -> Vec<Reduction> {
        let &Self { scene, swing, .. } = self;
        let met = self.met();
        let most = met.map_or(f64::INFINITY, |met| met.wrong(&self.launch, scene));
        let reductions = Clock::new(scene, &self.rate, &self.launch).of_swing(swing).into_iter();
        let fine = reductions.filter(|reduction| reduction.error + 0.5 * reduction.relative_error <= most);
        let mut reductions: Vec<Reduction> =
            fine.map(|reduction| reduction.reaching(met.and_then(Met::reach))).collect();
        reductions.sort_by_key(Reduction::operations);
        reductions
    }

    /// Whether a phase is good enough for all outputs.
    fn serves(&self, wanted: &[Wanted], reduction: &Reduction) -> bool {
        wanted.iter().all(|wanted| self.serves_one(wanted, reduction))
    }

    /// Without a tolerance the phase's error is to be of the order of the rounding. Of a tolerance, one whose error is next to
    /// nothing until the end of a long horizon is to take no more than the terms left out do.
    fn serves_one(&self, wanted: &Wanted, reduction: &Reduction) -> bool {
        let phase = wanted.phase_error(reduction);
        match self.scene.goal {
            Goal::Tolerance(_) => !reduction.is_rounded_late() || phase <= wanted.bias,
            _ => phase <= wanted.left_to_phase(self.scene.float.rounding_unit()),
        }
    }

    /// The cheapest plan that is found; or the least error that was reached, in units of the tolerance. Next to an overshoot
    /// θ̂ is as good as is allowed in pieces alone: where no phase that leads to them is good enough for all outputs, one is
    /// taken that is for θ̂, since of the others nothing is promised.
    fn cheapest(&self, wanted: &[Wanted]) -> Result<Plan, Refusal> {
        let (serving, others): (Vec<_>, Vec<_>) =
            self.reductions().into_iter().partition(|reduction| self.serves(wanted, reduction));
        let found = self.cheapest_by(&serving, wanted)?;
        if rank_of(&found)[0] <= 1.0 {
            return Ok(found);
        }
        let Some(theta) = wanted.iter().find(|wanted| wanted.has_pieces()) else { return Ok(found) };
        let leads = |reduction: &Reduction| reduction.has_pieces() && self.serves_one(theta, reduction);
        let in_pieces: Vec<Reduction> = others.into_iter().filter(leads).collect();
        let other = self.cheapest_by(&in_pieces, wanted).ok();
        Ok(other.filter(|other| rank_of(other) < rank_of(&found)).unwrap_or(found))
    }

    fn cheapest_by(&self, reductions: &[Reduction], wanted: &[Wanted]) -> Result<Plan, Refusal> {
        let mut closest = f64::INFINITY;
        let mut hopeless = Vec::new();
        let mut found: Option<Plan> = None;
        for reduction in reductions {
            // A dearer reduction is worth a look only where it leads to pieces and a cheaper one didn't.
            if found.is_some() && !(reduction.has_pieces() && wanted.iter().any(Wanted::has_pieces)) {
                continue;
            }
            // Nor where the phase alone is too wrong, or where all else was with another phase from the same origin, if need
            // be in the same unit.
            let lost = |wanted: &Wanted| wanted.phase_error(reduction) > self.promise(wanted);
            let alike = |&(origin, unit): &(Origin, Option<Double>)| {
                origin == reduction.origin && unit.is_none_or(|unit| unit == reduction.unit)
            };
            if wanted.iter().any(lost) || hopeless.iter().any(alike) {
                continue;
            }
            let parts = self.parts(wanted, reduction);
            let each = || parts.iter().zip(wanted);
            // A kernel for the whole of θ̂ is made as good as what the phase leaves: with a finer phase it may be better.
            let is_lost = |(part, wanted): (&Part, &Wanted)| {
                part.bound.truncation + part.bound.evaluation > self.promise(wanted) && !wanted.is_whole()
            };
            if each().any(is_lost) {
                // What overflows in units far from 1 doesn't in anchors.
                let overflows = parts.iter().any(|part| part.bound.evaluation.is_infinite());
                hopeless.push((reduction.origin, overflows.then_some(reduction.unit)));
            }
            let is_kept = |(part, wanted): (&Part, &Wanted)| part.bound.total() <= self.promise(wanted);
            if each().all(is_kept) && parts.iter().all(|part| is_useful(part, self.scene)) {
                let plan = self.joined(reduction, parts);
                found = Some(found.filter(|found| rank_of(found) <= rank_of(&plan)).unwrap_or(plan));
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
        let plan = Plan::new(self.method.word(), self.weights.len(), reduction, parts);
        Plan { coefficients: self.coefficients.clone(), ..plan }
    }

    /// The error that an output may have by the recurrence.
    fn promise(&self, wanted: &Wanted) -> f64 {
        self.promise_observed(BY_RECURRENCE, wanted)
    }

    /// What the promise leaves to the phase and pieces.
    fn left(&self, wanted: &Wanted) -> f64 {
        self.promise_observed(observed(self.scene.float), wanted) - wanted.bias
    }

    /// The error that an output may have. Without a tolerance the series, which has as many terms as it takes, is to be
    /// as good as full precision, of which half may be observed: what the terms left out come to is observed in full, of
    /// the proven rest no more than `part`. Of the other methods nothing is promised.
    fn promise_observed(&self, part: f64, Wanted { curve, bias, .. }: &Wanted) -> f64 {
        match self.scene.goal {
            Goal::Tolerance(tol) => curve.size.within(tol),
            Goal::Full if self.method == Method::Series => {
                let half = 0.5 * FULL * self.scene.float.rounding_unit() * curve.size.largest;
                bias + (half - bias) / part
            }
            Goal::Full | Goal::Terms(_) => f64::INFINITY,
        }
    }
}

#[cfg(test)]
mod tests;
