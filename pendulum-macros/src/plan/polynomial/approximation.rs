//! A curve as a Chebyshev series in the square p of the phase, with a bound of its error. Over an arc without symmetry
//! p = (s + ½)/4 takes the place of the square.
//!
//! The curve is interpolated at the fewest Chebyshev points of p ∈ [0, ¼] of which the error is negligible
//! ([`Interpolation::fewest`]). On the ellipse with parameter ρ, s stays within the strip |Im s| ≤ sinh(½ ln ρ)/2; each of
//! [`Curve::ellipses`] comes with a bound of the curve, by its Fourier series or, between the poles, by its pulses.
//! Dropping the interpolant's coefficients beyond the degree d adds at most the sum of their magnitudes, and less where
//! they cancel, or where the others make up for it (`nearest.rs`): the supremum of what is left out, explicitly known, is
//! bounded in `tail.rs`. That is the truncation error.

use super::interval;
use super::leeway::Leeway;
use super::nearest::Corrections;
use super::pole::Pole;
use super::tail::{self, at_most_cosh};
use super::weight::Weight;
use crate::chebyshev::{CosineTable, Interpolation, lebesgue, scale, shift, to_powers};
use crate::plan::blocks::Shifts;
use crate::plan::curve::Curve;
use crate::plan::memo::Memo;
use crate::plan::moebius::Moebius;
use crate::program::rounding::INFLATION;
use crate::series::Parity;
use pendulum_runtime::double::Double;
use std::cell::OnceCell;
use std::rc::Rc;

/// More points than this take too long.
const MOST_POINTS: usize = 160;

/// Of fewer the bound of the error says little where a polynomial of two terms is as good as exact.
const FEWEST_POINTS: usize = 12;

/// A curve's Chebyshev coefficients on p ∈ [0, ¼], in 8p − 1; of curve/s if it is odd, times a power of the pole's
/// polynomial if that is divided out.
#[derive(Clone, Debug)]
pub(crate) struct Approximation {
    parity: Parity,
    pole: Option<Pole>,
    /// Applied to p, if any: the series is of its image.
    map: Option<Moebius>,
    series: Vec<Double>,
    /// Error of the whole series on the interval, and what is known of it outside.
    remainder: f64,
    growth: Growth,
    /// Where the phase is so wrong that this matters.
    leeway: Option<Leeway>,
    /// The series of so many terms, and whether they make up for the others.
    shortened: Memo<(usize, bool), Rc<Shortened>>,
    /// The terms for a limit and an overshoot.
    enough: Memo<[f64; 2], Option<usize>>,
    /// Shared by all leeways.
    corrections: Rc<Corrected>,
}

/// What so many terms are corrected by, with a leeway of such a ratio: whatever else that is, it would hardly be by
/// anything else.
type Corrected = Memo<(usize, f64), Rc<[f64]>>;

/// A series of so many terms that stands for a longer one.
#[derive(Debug)]
pub(super) struct Shortened {
    pub(super) series: Vec<Double>,
    /// What the longer one is more, from this order on.
    left: Vec<f64>,
    first: usize,
    /// What that changes of phases up to so far.
    suprema: Memo<f64, f64>,
    /// The shifts found, by chunk.
    shifts: Memo<usize, Option<Shifts>>,
    /// Its coefficients in powers of 8p − 1.
    powers: OnceCell<Vec<Double>>,
}

impl Shortened {
    fn new(series: Vec<Double>, left: Vec<f64>, first: usize) -> Self {
        let (suprema, shifts) = (Memo::default(), Memo::default());
        Self { series, left, first, suprema, shifts, powers: OnceCell::new() }
    }

    /// Its coefficients in powers of p/`area` + `c`.
    pub(super) fn powers_of(&self, c: Double, area: Double) -> Vec<Double> {
        let eighth = area * 8.0;
        let powers = self.powers.get_or_init(|| to_powers(&self.series));
        scale(shift(powers, -Double::ONE - eighth * c), eighth)
    }

    /// The shifts, looked for once.
    pub(super) fn shifts(&self, chunk: usize) -> Option<Shifts> {
        let look = || Shifts::new(&self.powers_of(Double::ZERO, Double::ONE), chunk);
        self.shifts.get(chunk, look)
    }
}

/// How the error of a whole series grows on ellipses about its interval.
#[derive(Clone, Debug)]
pub(in crate::plan) enum Growth {
    /// It is due to so many points of interpolation, ln ρ being that of the ellipse where the curve is bounded: a sum of
    /// Tⱼ for j from their number on, in which the weights fall like ρ⁻ʲ.
    Points { points: usize, log_rho: f64 },
    /// By this power of their parameter at most, up to the ellipse with ln ρ.
    Power { power: f64, log_rho: f64 },
}

impl Growth {
    /// Where the ellipse has this logarithm of its parameter.
    fn at(&self, log: f64) -> f64 {
        match *self {
            Self::Points { log_rho, .. } if log >= 0.9 * log_rho => f64::INFINITY,
            // Outside of the interval Tⱼ grows by a factor from one to the next.
            Self::Points { points, log_rho } => {
                let tail = (1.0 - libm::exp(-log_rho)) / (1.0 - libm::exp(log - log_rho));
                tail * libm::cosh(points as f64 * log)
            }
            Self::Power { log_rho, .. } if log > log_rho => f64::INFINITY,
            Self::Power { power, .. } => libm::exp(power * log),
        }
    }
}

impl Approximation {
    /// Interpolates `curve`, over `pole` if any, so well that the error left is below `negligible`; `None` if that takes
    /// too many points.
    pub(crate) fn new(curve: &Curve, pole: Option<Pole>, negligible: f64) -> Option<Self> {
        let negligible = negligible * pole.map_or(1.0, |pole| pole.least(0.5));
        let interpolation = enough_points(curve, pole, negligible)?;
        Some(Self::with_points(curve, pole, negligible, &interpolation))
    }

    /// As [`Self::new`], for a curve without singularities.
    pub(crate) fn entire(curve: &Curve, negligible: f64) -> Self {
        let useless = Interpolation { points: MOST_POINTS, rho: 1.0, error: f64::INFINITY };
        Self::with_points(curve, None, negligible, &enough_points(curve, None, negligible).unwrap_or(useless))
    }

    fn with_points(curve: &Curve, pole: Option<Pole>, negligible: f64, interpolation: &Interpolation) -> Self {
        let Interpolation { points, rho, error } = *interpolation;
        let sample = |u: Double| {
            let s = if curve.parity() == Parity::Neither { u * 0.5 } else { interval::p_in_two_words(u).sqrt() };
            let value = pole.map_or(Double::ONE, |pole| pole.at(u)) * curve.at(s);
            if curve.parity() == Parity::Odd { value / s } else { value }
        };
        let (mut series, rounding) = CosineTable::new(points).interpolant(sample);
        // Terms that the sum omits change the value itself, which an error of the series does by half as much at most where
        // the curve is odd.
        let mut remainder = error
            + rounding
            + (2.0 * curve.omitted() + missed(curve, points)) * pole.map_or(1.0, |pole| pole.most(0.5));
        // What is far below the aim isn't worth carrying.
        while series.len() > 2 && series.last().is_some_and(|last| last.hi.abs() < negligible * 1e-3) {
            remainder += series.pop().map_or(0.0, |last| last.hi.abs());
        }
        let growth = Growth::Points { points, log_rho: libm::log(rho) };
        Self { parity: curve.parity(), pole, ..Self::known(None, series, remainder, growth) }
    }

    /// The same of a phase that leaves a leeway.
    pub(crate) fn with(&self, leeway: Leeway) -> Self {
        Self { leeway: Some(leeway), shortened: Memo::default(), enough: Memo::default(), ..self.clone() }
    }

    /// An even function of which the series and its error are known, and how that grows.
    pub(in crate::plan) fn known(map: Option<Moebius>, series: Vec<Double>, remainder: f64, growth: Growth) -> Self {
        Self {
            parity: Parity::Even,
            pole: None,
            map,
            series,
            remainder,
            growth,
            leeway: None,
            shortened: Memo::default(),
            enough: Memo::default(),
            corrections: Rc::default(),
        }
    }

    /// The error of the polynomial with `terms` coefficients, on the interval widened by `overshoot` (in s); of a phase
    /// that leaves a leeway, beyond what its error takes.
    ///
    /// Beyond the end the curve is steepest, and nothing is spared.
    pub(crate) fn truncation(&self, terms: usize, overshoot: f64) -> f64 {
        let Shortened { left, first, suprema, .. } = &*self.shortened(terms, overshoot);
        let ellipse = ellipse_of(overshoot);
        let whole: f64 = left.iter().zip(*first..).map(|(c, j)| c.abs() * at_most_cosh(j as f64 * ellipse)).sum();
        let reach = 0.5 + overshoot.min(0.0);
        let farthest = self.map.map_or(reach * reach, |map| map.farthest(reach * reach));
        let within = suprema.get(farthest, || tail::supremum(left, *first, self.weights(), farthest));
        let beyond = if overshoot > 0.0 {
            tail::supremum_beyond(left, *first, ellipse) * self.weight_beyond(overshoot)
        } else {
            0.0
        };
        (whole * self.weight(overshoot)).min(within.max(beyond)) + self.least_truncation(overshoot)
    }

    /// What an error counts within an anchor.
    fn weights(&self) -> Weight<'_> {
        Weight { pole: self.pole, parity: self.parity, leeway: self.leeway.as_ref() }
    }

    /// The series of so many terms. Where it is met as a whole, they make up for the others as well as they can; without
    /// poles those of an even curve hardly can unless the phase leaves more at one end.
    pub(super) fn shortened(&self, terms: usize, overshoot: f64) -> Rc<Shortened> {
        let terms = terms.min(self.series.len());
        let weighted = self.pole.is_some() || self.parity == Parity::Odd || self.leeway.is_some();
        let makes_up = overshoot >= 0.0 && weighted;
        let shorten = || Rc::new(self.without_last(terms, makes_up));
        self.shortened.get((terms, makes_up), shorten)
    }

    fn without_last(&self, terms: usize, makes_up: bool) -> Shortened {
        let (kept, dropped) = self.series.split_at(terms);
        let dropped: Vec<f64> = dropped.iter().map(|c| c.hi).collect();
        if !makes_up || dropped.is_empty() {
            return Shortened::new(kept.to_vec(), dropped, terms);
        }
        let ratio = self.leeway.as_ref().map_or(0.0, Leeway::ratio);
        let correct = || Corrections::new(&dropped, terms, self.weights()).of_terms.into();
        let corrections = self.corrections.get((terms, ratio), correct);
        // What the sums are rounded by counts with the conversion to powers.
        let series = kept.iter().zip(&*corrections).map(|(c, correction)| *c + Double::new(*correction)).collect();
        let left = corrections.iter().map(|correction| -correction).chain(dropped).collect();
        Shortened::new(series, left, 0)
    }

    /// What dropping a term changes at most.
    fn without(&self, j: usize, overshoot: f64) -> f64 {
        self.series[j].hi.abs() * at_most_cosh(j as f64 * ellipse_of(overshoot)) * self.weight(overshoot)
    }

    /// The error of the whole series.
    fn least_truncation(&self, overshoot: f64) -> f64 {
        self.remainder * self.growth.at(ellipse_of(overshoot)) * self.weight(overshoot)
    }

    /// What an error of the polynomial is multiplied with in the value, at most.
    pub(super) fn weight(&self, overshoot: f64) -> f64 {
        self.weight_from(0.0, overshoot)
    }

    /// The same where phases overshoot the interval.
    fn weight_beyond(&self, overshoot: f64) -> f64 {
        self.weight_from(0.25, overshoot)
    }

    /// The same of phases whose square is at least `low`.
    fn weight_from(&self, low: f64, overshoot: f64) -> f64 {
        let phase = 0.5 + overshoot;
        self.weights().between(low, phase * phase) * INFLATION
    }

    /// The fewest terms, at least two, whose truncation error is at most `limit`.
    pub(crate) fn terms_for(&self, limit: f64, overshoot: f64) -> Option<usize> {
        self.enough.get([limit, overshoot], || self.fewest_for(limit, overshoot))
    }

    fn fewest_for(&self, limit: f64, overshoot: f64) -> Option<usize> {
        let mut truncation = self.least_truncation(overshoot);
        let mut enough = None;
        for terms in (2..=self.series.len()).rev() {
            if truncation > limit {
                break;
            }
            enough = Some(terms);
            truncation += self.without(terms - 1, overshoot);
        }
        // The magnitudes add up to more than what is left out, by little unless a part of the interval is, or others
        // make up for them.
        let fewer = |&terms: &usize| (terms > 2 && self.truncation(terms - 1, overshoot) <= limit).then(|| terms - 1);
        std::iter::successors(enough, fewer).last()
    }

    pub(crate) fn terms(&self) -> usize {
        self.series.len()
    }

    /// Its coefficients, of what is left over its poles and divided by an odd curve's phase.
    pub(super) fn series(&self) -> &[Double] {
        &self.series
    }

    pub(super) fn leeway(&self) -> Option<&Leeway> {
        self.leeway.as_ref()
    }

    /// Whether a phase that leaps to a whole anchor may be divided by its poles as it comes.
    pub(in crate::plan) fn falls(&self) -> bool {
        self.pole.is_some_and(|pole| pole.falls(0.5))
    }

    pub(super) fn parity(&self) -> Parity {
        self.parity
    }

    pub(super) fn pole(&self) -> Option<Pole> {
        self.pole
    }

    pub(super) fn map(&self) -> Option<Moebius> {
        self.map
    }
}

/// ln of an ellipse's parameter: 8p − 1 exceeds 1 by ε = 8·overshoot·(1 + overshoot), and there |Tⱼ| ≤ cosh(j·arcosh(1 +
/// ε)) ≤ cosh(j·√(2ε)).
fn ellipse_of(overshoot: f64) -> f64 {
    (16.0 * overshoot.max(0.0) * (1.0 + overshoot)).sqrt()
}

/// What an interpolation is off by where samples are: by what they are rounded by, over the least phase if the curve is
/// odd, which is above 1/(8·points); and by terms that its sum omits, since it is the whole curve that is interpolated: of
/// samples by their slope at most, since the first of them oscillates, and over s if the curve is odd, in an arc by that
/// part of their slope.
fn missed(curve: &Curve, points: usize) -> f64 {
    let (divisor, stretch) = match curve.parity() {
        Parity::Odd => (8.0 * points as f64, curve.stretch()),
        _ => (1.0, 1.0),
    };
    lebesgue(points) * (curve.omitted_slope() * stretch + curve.sampling_error() * divisor)
}

/// As many points as make the interpolation error negligible.
fn enough_points(curve: &Curve, pole: Option<Pole>, negligible: f64) -> Option<Interpolation> {
    let ellipse = |(angle, bound): (f64, f64)| {
        // s = ½ cos φ with |Im φ| = ½ ln ρ, or ln ρ where the polynomial is one in s itself.
        let log_rho = if curve.parity() == Parity::Neither { angle } else { 2.0 * angle };
        let (height, radius) = (0.5 * libm::sinh(angle), 0.5 * libm::cosh(angle));
        let mut bound = bound * pole.map_or(1.0, |pole| pole.most(radius));
        if curve.parity() == Parity::Odd {
            // |s| ≥ height on the ellipse's image.
            bound /= height;
        }
        (bound, libm::exp(log_rho))
    };
    Interpolation::fewest(curve.ellipses().map(ellipse), negligible, FEWEST_POINTS, MOST_POINTS)
}

#[cfg(test)]
pub(super) mod tests;
