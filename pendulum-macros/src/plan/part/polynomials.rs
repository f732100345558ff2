//! An output by polynomials: its variants by cost, and the fewest terms of each that keep the promise.

use super::draft::{Brief, Draft, Drafts};
use crate::parse::{Float, Output};
use crate::plan::Part;
use crate::plan::aim::Aim;
use crate::plan::curve::Curve;
use crate::plan::form::{Division, Form, Poles, Variant};
use crate::plan::kernel::{Core, Kernel};
use crate::plan::memo::Memo;
use crate::plan::polynomial::{Approximation, Leeway, Numerator, Pole, Polynomial, pade};
use crate::plan::reduction::{Origin, Reduction};
use crate::plan::task::Task;
use crate::plan::turning::Start;
use crate::power::two_to;
use crate::program::cost::{AGAINST, CLAMP};
use crate::series::Parity;
use crate::supremum::norm;
use std::rc::Rc;

/// An output's approximations, without and with its poles divided out.
pub(in crate::plan) struct Approximations {
    pub(in crate::plan) aim: Aim,
    plain: Rc<[Approximation]>,
    /// For each of [`Aim::reductions_for_poles`].
    divided: [OverPoles; 2],
    lenient: Memo<Lenient, Rc<[Approximation]>>,
    pub(in crate::plan) drafts: Drafts,
}

/// An output's approximations with poles divided out that suit what some reduction leaves of the limit.
#[derive(Default)]
struct OverPoles {
    one: Rc<[Approximation]>,
    /// By two pairs, if that is worth it.
    two: Rc<[Approximation]>,
}

/// What tells approximations with a leeway from others: the errors of the phase, their share, and by what they are
/// divided, of which poles.
type Lenient = ([f64; 2], f64, Poles, usize);

impl Approximations {
    pub(in crate::plan) fn new(aim: &Aim, reductions: &[Reduction]) -> Self {
        // So far below the aim that it doesn't blur the bound of a plan that, for want of half terms, is much better.
        // Over an arc, that may be any number of digits; but there it costs nothing.
        let negligible = |curve: &Curve| match curve.largest_met() {
            Some(largest) => aim.floor() * two_to(-20) * (largest.hi / curve.size.largest).clamp(two_to(-30), 1.0),
            None => (aim.truncation.min(curve.size.largest) * two_to(-30)).max(aim.floor() / 128.0),
        };
        let over = |pole| -> Rc<[Approximation]> {
            let all = aim.curves.iter().map(|curve| Approximation::new(curve, pole, negligible(curve)));
            all.collect::<Option<_>>().unwrap_or_default()
        };
        let (divided, lenient, drafts) = (Default::default(), Memo::default(), Memo::default());
        let without_poles = Self { aim: aim.clone(), plain: over(None), divided, lenient, drafts };
        let over_poles = |reduction: &Reduction| {
            let (plain, left) = (without_poles.choose(Poles::Absent, reduction), aim.left(reduction));
            let first = aim.poles(&plain, left, reduction.float)?;
            let two = aim.two_pairs(&plain, first, left);
            Some(OverPoles { one: over(Some(first)), two: two.map(|two| over(Some(two))).unwrap_or_default() })
        };
        let suited = aim.reductions_for_poles(reductions);
        let divided = suited.map(|reduction| reduction.and_then(over_poles).unwrap_or_default());
        Self { divided, ..without_poles }
    }

    /// Those of a variant, with the leeway that the reduction leaves; none over poles where none are worth it.
    pub(in crate::plan) fn choose(&self, poles: Poles, reduction: &Reduction) -> Rc<[Approximation]> {
        let ((which, strict), poles) = match poles {
            Poles::Absent => ((0, &self.plain), poles),
            Poles::UnderTwo => (self.divided_for(reduction, |over| &over.two), poles),
            Poles::Under | Poles::Beside => (self.divided_for(reduction, |over| &over.one), Poles::Under),
        };
        let Some((curve, ratio)) = self.aim.leeway(reduction) else { return strict.clone() };
        let errors = [reduction.error, reduction.relative_error];
        let lenient = || {
            let leeway = Leeway::new(curve, errors, ratio);
            strict.iter().map(|approximation| approximation.with(leeway.clone())).collect()
        };
        self.lenient.get((errors, ratio, poles, which), lenient)
    }

    /// Those over poles with the fewest terms for what the reduction leaves, and which they are.
    fn divided_for(
        &self,
        reduction: &Reduction,
        of: impl Fn(&OverPoles) -> &Rc<[Approximation]>,
    ) -> (usize, &Rc<[Approximation]>) {
        let [first, roomy] = self.divided.each_ref().map(of);
        let left = self.aim.truncation_of_each(self.aim.left(reduction));
        let terms = |all: &[Approximation]| -> Option<usize> {
            all.iter().map(|approximation| approximation.terms_for(left, reduction.overshoot)).sum()
        };
        let saves = || terms(roomy).is_some_and(|fewer| terms(first).is_none_or(|terms| fewer < terms));
        if !roomy.is_empty() && (first.is_empty() || saves()) { (1, roomy) } else { (0, first) }
    }

    /// The variants that might serve, and their cost in this reduction, cheapest first.
    pub(in crate::plan) fn variants(&self, reduction: &Reduction) -> Vec<(Variant, f64)> {
        // Double poles would leave four terms over them, and of two curves one division serves both.
        let beside = self.aim.power < 2 && self.aim.curves.len() == 1;
        let poles = Poles::ALL.into_iter().filter(|&poles| beside || poles != Poles::Beside);
        let variants = poles.flat_map(|poles| Form::ALL.map(|form| Variant { form, poles }));
        let cost = |variant: Variant| Some((variant, self.estimate(reduction, variant)?));
        let mut costs: Vec<(Variant, f64)> = variants.filter_map(cost).collect();
        costs.sort_by(|a, b| a.1.total_cmp(&b.1));
        costs
    }

    /// The cost of the kernels with the fewest terms; `None` if no number of them serves.
    fn estimate(&self, reduction: &Reduction, variant: Variant) -> Option<f64> {
        let approximations = self.choose(variant.poles, reduction);
        if approximations.is_empty() {
            return None;
        }
        let left = self.aim.truncation_of_each(self.aim.left(reduction));
        let fewest = |approximation: &Approximation| {
            let terms = approximation.terms_for(left, reduction.overshoot);
            terms.filter(|&terms| variant.suits(terms, reduction.float))
        };
        let terms = approximations.iter().map(fewest).collect::<Option<Vec<usize>>>()?;
        Some(self.cost(&terms, &approximations, reduction, variant))
    }

    /// The cost of the kernels with so many terms each.
    fn cost(&self, terms: &[usize], approximations: &[Approximation], reduction: &Reduction, variant: Variant) -> f64 {
        let one = |(curve, (approximation, &terms)): (&Curve, (&Approximation, &usize))| {
            let signs = if curve.alternates && reduction.origin == Origin::Lowest { AGAINST } else { 0.0 };
            let (odd, of_two) = (curve.parity() == Parity::Odd, self.aim.curves.len() > 1);
            let division = match (variant.poles, of_two, odd) {
                (Poles::Absent, ..) => Division::None,
                (Poles::Under | Poles::UnderTwo, true, _) => Division::Shared,
                (Poles::Under | Poles::UnderTwo, false, true) => Division::OfPhase,
                (Poles::Under | Poles::UnderTwo, false, false) => Division::Inverse,
                (Poles::Beside, ..) => Division::OfRemainder,
            };
            let unlimited = division == Division::OfPhase && approximation.falls();
            let clamp = if reduction.leaps() && !unlimited { CLAMP } else { 0.0 };
            let phase = if odd { 1.0 + clamp } else { 0.0 };
            (variant.cost(terms, division, reduction.float) + phase + signs, variant.variables(terms))
        };
        let kernels = self.aim.curves.iter().zip(approximations.iter().zip(terms)).map(one);
        let (kernels, variables): (Vec<f64>, Vec<f64>) = kernels.unzip();
        let squaring = if self.aim.curves.len() > 1 { SQUARING } else { 0.0 };
        kernels.iter().sum::<f64>() + variables.into_iter().fold(0.0, f64::max) + squaring
    }

    /// What a part costs that was made of a variant: rounding may have left less for truncation than was estimated.
    pub(in crate::plan) fn cost_of(&self, part: &Part, reduction: &Reduction, variant: Variant) -> f64 {
        let approximations = self.choose(variant.poles, reduction);
        self.cost(&part.kernel.core.terms_of_each(), &approximations, reduction, variant)
    }

    /// The fewest terms that keep the promise, taking at most a part of the limit of it, or what was reached.
    pub(in crate::plan) fn part(
        &self,
        task: &Task,
        reduction: &Reduction,
        variant: Variant,
        most: f64,
    ) -> Result<Part, f64> {
        let aim = &self.aim;
        aim.first_kept(reduction, aim.size.phase_error(reduction), most, |left| {
            let brief = Brief { variant: Some(variant), reduction: reduction.clone(), left };
            self.drafts.get(brief, || {
                let polynomials = self.polynomials(task, reduction, variant, left)?;
                let truncation = aim.error(norm(polynomials.iter().map(|polynomial| polynomial.truncation)));
                Ok(Rc::new(Draft::new(aim.kernel(task, reduction, polynomials, truncation), truncation)))
            })
        })
    }

    /// Those with the fewest terms whose truncation is within what is left, or what would be reached.
    fn polynomials(
        &self,
        task: &Task,
        reduction: &Reduction,
        Variant { form, poles }: Variant,
        left: f64,
    ) -> Result<Vec<Polynomial>, f64> {
        let each = self.aim.truncation_of_each(left);
        let polynomial = |(curve, approximation): (&Curve, &Approximation), numerator: Numerator| {
            let Some(terms) = approximation.terms_for(each, reduction.overshoot) else {
                let least = approximation.truncation(approximation.terms(), reduction.overshoot);
                return Err((self.aim.limit - left + least) / self.aim.size.unit);
            };
            let truncated = approximation.truncated(terms, reduction, curve.alternates);
            let polynomial = match poles {
                Poles::Beside => truncated.beside_poles(form),
                _ => truncated.polynomial(form, numerator, self.aim.limit),
            };
            polynomial.ok_or(f64::INFINITY)
        };
        let all = self.choose(poles, reduction);
        let curves: Vec<(&Curve, &Approximation)> = self.aim.curves.iter().zip(&*all).collect();
        if let [sine, cosine] = curves[..] {
            let mirrored = sine.0.mirrors(task.turns_over());
            let [first, second] = if mirrored { [cosine, sine] } else { [sine, cosine] };
            let first = polynomial(first, Numerator::Leading)?;
            let second = polynomial(second, first.numerator())?;
            return Ok(if mirrored { vec![second, first] } else { vec![first, second] });
        }
        let single = |curve: (&Curve, &Approximation)| {
            let odd = curve.0.parity() == Parity::Odd;
            polynomial(curve, if odd { Numerator::One } else { Numerator::Leading })
        };
        curves.into_iter().map(single).collect()
    }
}

/// Operations that make a position of sin(θ/2) and cos(θ/2).
pub(super) const SQUARING: f64 = 5.0;

/// Terms that poles have to save a curve that has none: each takes an operation and a half.
const WORTH: usize = 3;

impl Aim {
    /// The poles to be divided out, if any: the nearest, or near them those that save more terms. θ has logarithms
    /// there, but poles serve it as they serve other curves.
    fn poles(&self, plain: &[Approximation], left: f64, float: Float) -> Option<Pole> {
        let curve = self.curves.first().filter(|curve| !curve.is_arc())?;
        // Poles are to be met exactly, or what is left of them remains; logarithms can't be.
        let float = if self.power == 0 { Float::F32 } else { float };
        let nearest = Pole::new(curve.strip(), self.power.max(1), float);
        let limit = self.truncation_of_each(left);
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

    /// The reductions that poles are to suit: the cheapest, though one that is rounded late hardly serves where it takes much;
    /// and the cheapest that leaves much, if that doesn't: what it leaves may do with fewer terms, over poles of their own.
    fn reductions_for_poles<'a>(&self, reductions: &'a [Reduction]) -> [Option<&'a Reduction>; 2] {
        let leaves = |reduction: &Reduction, part: f64| self.left(reduction) > part * self.limit;
        let serves = |reduction: &&Reduction| leaves(reduction, if reduction.is_rounded_late() { 0.9 } else { 0.0 });
        let first = reductions.iter().find(serves);
        let roomy = reductions.iter().find(|reduction| leaves(reduction, 0.5));
        [first, roomy.filter(|_| first.is_some_and(|first| !leaves(first, 0.5)))]
    }

    /// Two pairs in their place, if those save enough. Double poles are two already.
    fn two_pairs(&self, plain: &[Approximation], first: Pole, left: f64) -> Option<Pole> {
        if self.power > 1 { None } else { pade::two(plain, first, self.truncation_of_each(left)) }
    }

    /// What a reduction leaves of the limit.
    pub(super) fn left(&self, reduction: &Reduction) -> f64 {
        self.limit - self.size.phase_error(reduction)
    }

    /// A single curve that rises, and what the phase's error takes where it is steepest over what is left, if it takes so
    /// much that it matters where.
    fn leeway(&self, reduction: &Reduction) -> Option<(&Curve, f64)> {
        const LEAST: f64 = 0.5;
        let [curve] = &self.curves[..] else { return None };
        let ratio = curve.size.slope * reduction.error / self.left(reduction);
        // The power of two below is as good, and the same for most of a scene's reductions and roundings.
        let power = libm::exp2(libm::log2(ratio).floor());
        (curve.rises && (LEAST..1e3).contains(&ratio)).then_some((curve, power))
    }

    /// The truncation allowed to each of the curves.
    pub(super) fn truncation_of_each(&self, left: f64) -> f64 {
        left.min(self.truncation) / self.error((self.curves.len() as f64).sqrt())
    }

    /// The output's error where that of its curves is `error`: a position is the square of a number on the unit circle.
    pub(super) fn error(&self, error: f64) -> f64 {
        if self.output == Output::Position { error * (2.0 + error) } else { error }
    }

    /// Puts the polynomials together.
    fn kernel(&self, task: &Task, reduction: &Reduction, mut polynomials: Vec<Polynomial>, truncation: f64) -> Kernel {
        self.mirror(task, &mut polynomials, Polynomial::negate);
        match <[Polynomial; 2]>::try_from(polynomials) {
            Ok(factors) => Core::Circle(Box::new(factors)).into(),
            Err(mut single) => {
                let start = Start::Top(self.curves[0].periodic());
                let errors = [truncation, self.size.phase_error(reduction)];
                let turning = self.turning(task, reduction, start, errors);
                Kernel { core: Core::Polynomial(Box::new(single.swap_remove(0))), finish: self.finish(turning) }
            }
        }
    }
}
