//! The paper's θ̂ = 2 arcsin y, y = Σ wₙ cos((2n−1)πs), as a whole: one function of the phase instead of a sum, a root and
//! an arcsine.

mod angle_in_pieces;
mod residual;
mod single;
mod slope_in_pieces;
mod sum_in_pieces;

use super::bias::supremum;
use super::{Sum, rank};
use crate::parse::{Method, Output};
use crate::plan::Bound;
use crate::plan::cosines::Cosines;
use crate::plan::curve::Size;
use crate::plan::kernel::{self, Kernel};
use crate::plan::pieces::Piecewise;
use crate::plan::polynomial::Approximation;
use crate::plan::reduction::Reduction;
use crate::program::rounding::half_ulp;
use crate::scene::Goal;
use pendulum_runtime::double::Double;
use slope_in_pieces::MOST_OF_SLOPE;
use std::cell::OnceCell;
use sum_in_pieces::SumInPieces;

/// θ̂ or its derivative as one function of the phase, and how far off it may be. Approximations are made when they are wanted
/// first.
pub(super) struct Whole {
    /// Anchors per unit of time, of the derivative, which is in pieces only.
    rate: Option<Double>,
    weights: Vec<Double>,
    /// That of θ, and −1 for its mirror image.
    size: Size,
    direction: f64,
    limits: Limits,
    /// For one polynomial; `None` where that takes too many terms.
    single: OnceCell<Option<Approximation>>,
    /// For one in each piece; `None` where that takes too many pieces.
    pieces: OnceCell<Option<Piecewise>>,
    /// The fewest pieces that are tried.
    least: usize,
    /// For where neither serves.
    sum_in_pieces: OnceCell<Option<SumInPieces>>,
    /// sup |z·θ̂′|, z from the lowest point, which next to an overshoot is more than that of θ. 0 where it is no formula that
    /// is to be reproduced.
    conditioning: OnceCell<f64>,
}

/// What it may be wrong by.
struct Limits {
    /// The series of its approximations, of which kernels drop terms.
    series: f64,
    /// What it may differ from θ̂ by at most, phase and rounding included.
    allowed: f64,
    /// What it may differ from θ̂ by at most before these.
    truncation: f64,
    /// What is little beside what θ̂ itself is wrong by: next to an overshoot a sum that is off by as much as a coarse
    /// tolerance allows is bounded to be many times as far off as it is.
    beside_bias: f64,
}

/// A kernel for it, how wrong it is, and what it costs.
pub(super) struct Rated {
    pub(super) kernel: Kernel,
    pub(super) bound: Bound,
    pub(super) cost: f64,
    /// The part of what is allowed that it is wrong by.
    pub(super) share: f64,
}

/// What a kernel may be wrong by, given what the phase is.
#[derive(Clone, Copy)]
struct Allowance {
    phase: f64,
    /// Truncation and rounding together.
    rest: f64,
    /// The truncation alone.
    truncation: f64,
}

/// Parts of what the phase leaves that the truncation may take; the first that leaves enough to the rounding counts.
const SHARES: [f64; 2] = [4.0, 16.0];

impl Whole {
    /// `None` where there is no arcsine, of other outputs, and of derivatives of long sums or within a moment. It may be off
    /// by what a tolerance leaves beside the sum's own `bias`, or by 8 units in the last place of θ0; the derivative by 16 of
    /// its largest value.
    pub(super) fn new(sum: &Sum, output: Output, size: Size, bias: f64) -> Option<Self> {
        let (rate, largest, most) = match output {
            _ if sum.method != Method::Fourier => return None,
            Output::Theta => (None, sum.swing.amplitude.to_f64(), 8.0),
            // Within a moment a velocity may be far less than what rows with all of it are rounded by.
            Output::Velocity if sum.weights.len() <= MOST_OF_SLOPE && sum.met().is_none() => {
                (Some(sum.rate.to_double()), size.largest, 16.0)
            }
            _ => return None,
        };
        let units = |units: f64| 2.0 * units * half_ulp(largest, sum.scene.float);
        let allowed = match sum.scene.goal {
            Goal::Tolerance(tol) => size.within(tol) - bias,
            _ => units(most),
        };
        // Within a moment its difference from θ̂ may undo that of θ̂ from θ.
        let beside_bias = (bias / 3.0).max(units(1.0));
        let truncation = sum.met().map_or(f64::INFINITY, |_| beside_bias);
        let limits = Limits { series: truncation.min(allowed / 8.0), allowed, truncation, beside_bias };
        let is_given = output == Output::Theta && matches!(sum.scene.goal, Goal::Terms(_));
        let conditioning = if is_given { OnceCell::new() } else { OnceCell::from(0.0) };
        Some(Self {
            rate,
            weights: sum.weights.clone(),
            size,
            direction: sum.direction(),
            limits,
            single: OnceCell::new(),
            pieces: OnceCell::new(),
            least: 0,
            sum_in_pieces: OnceCell::new(),
            conditioning,
        })
    }

    /// How many polynomials can stand for the arcsine.
    pub(super) fn count(&self) -> Option<usize> {
        self.piecewise().map(Piecewise::pieces)
    }

    /// In so many pieces at least.
    pub(super) fn of_at_least(self, least: usize) -> Self {
        if self.count() >= Some(least) { self } else { Self { least, pieces: OnceCell::new(), ..self } }
    }

    /// Whether one polynomial or many can stand for the arcsine, or for the sum.
    pub(super) fn is_possible(&self) -> bool {
        self.one_polynomial().is_some() || self.has_pieces()
    }

    /// Whether many can, for reductions that count pieces.
    pub(super) fn has_pieces(&self) -> bool {
        self.piecewise().is_some() || self.sum_in_pieces().is_some()
    }

    /// A reduction to its pieces, the most that may be tried, if both can be had.
    pub(super) fn in_pieces(&self, reduction: &Reduction) -> Option<Reduction> {
        let of_sum = || self.sum_in_pieces().map(|_| SumInPieces::most_pieces());
        reduction.in_pieces(self.count().or_else(of_sum)?)
    }

    fn one_polynomial(&self) -> Option<&Approximation> {
        let approximation = || self.rate.is_none().then(|| single::approximation(&self.weights, self.limits.series))?;
        self.single.get_or_init(approximation).as_ref()
    }

    fn piecewise(&self) -> Option<&Piecewise> {
        let approximation = || match self.rate {
            None => angle_in_pieces::approximation(&self.weights, self.limits.series, self.least),
            Some(rate) => slope_in_pieces::approximation(&self.weights, rate, self.limits.series, self.least),
        };
        self.pieces.get_or_init(approximation).as_ref()
    }

    fn sum_in_pieces(&self) -> Option<&SumInPieces> {
        let approximation = || self.rate.is_none().then(|| SumInPieces::new(&self.weights, self.limits.series))?;
        self.sum_in_pieces.get_or_init(approximation).as_ref()
    }

    /// What the phase makes of θ, or of θ̂ if that is more.
    pub(super) fn phase_error(&self, reduction: &Reduction) -> f64 {
        let mut size = self.size;
        if reduction.relative_error > 0.0 {
            let own = self.conditioning.get_or_init(|| conditioning(&self.weights));
            size.conditioning = size.conditioning.max(*own);
        }
        size.phase_error(reduction)
    }

    /// What the phase may take of what is allowed, without a tolerance: the rest is enough for pieces.
    pub(super) fn left_to_phase(&self) -> f64 {
        0.25 * self.limits.allowed
    }

    /// What part of what is allowed, phase and rounding included, an error is.
    pub(super) fn share(&self, bound: Bound) -> f64 {
        bound.total() / self.limits.allowed
    }

    /// The cheaper of one polynomial in its cheapest form and of many, each off by no more than is allowed; or many for the
    /// sum.
    pub(super) fn cheapest(&self, reduction: &Reduction) -> Option<Rated> {
        let kernels = [self.single(reduction), self.pieces(reduction)];
        let rated = kernels.into_iter().flatten().map(|made| self.rated(made, reduction));
        let cheapest = rated.min_by(|a, b| a.cost.total_cmp(&b.cost));
        cheapest.or_else(|| Some(self.rated(self.complement(reduction)?, reduction)))
    }

    fn rated(&self, (kernel, bound): (Kernel, Bound), reduction: &Reduction) -> Rated {
        let (cost, share) = (cost(reduction, &kernel), self.share(bound));
        Rated { kernel, bound, cost, share }
    }

    fn single(&self, reduction: &Reduction) -> Option<(Kernel, Bound)> {
        let approximation = self.one_polynomial()?;
        let mut allowances = self.allowances(self.phase_error(reduction));
        allowances.find_map(|allowance| single::kernel(approximation, allowance, reduction, self.direction))
    }

    fn pieces(&self, reduction: &Reduction) -> Option<(Kernel, Bound)> {
        let (piecewise, reduction) = (self.piecewise()?, self.in_pieces(reduction)?);
        let mut allowances = self.allowances(self.phase_error(&reduction));
        allowances.find_map(|allowance| angle_in_pieces::kernel(piecewise, allowance, &reduction, self.direction))
    }

    /// The same by the complement, or as little off as can be.
    fn complement(&self, reduction: &Reduction) -> Option<(Kernel, Bound)> {
        let most = self.limits.allowed;
        let allowance = |reduction: &Reduction| {
            let phase = self.phase_error(reduction);
            // So little of the truncation that it doesn't matter for what else there is.
            Allowance { phase, rest: most - phase, truncation: self.limits.beside_bias.min(most / SHARES[1]) }
        };
        self.sum_in_pieces()?.kernel(allowance, reduction, self.direction)
    }

    /// What may be tried with a phase so wrong, in that order.
    fn allowances(&self, phase: f64) -> impl Iterator<Item = Allowance> {
        let rest = self.limits.allowed - phase;
        SHARES.into_iter().map(move |share| Allowance {
            phase,
            rest,
            truncation: self.limits.truncation.min(rest / share),
        })
    }
}

impl Rated {
    pub(super) fn rank(&self) -> [f64; 2] {
        rank(self.share, self.cost)
    }
}

impl Allowance {
    /// What a kernel is wrong by, if it is within these.
    fn kept(self, truncation: f64, evaluation: f64) -> Option<Bound> {
        (evaluation <= self.rest - truncation).then_some(Bound { truncation, phase: self.phase, evaluation })
    }
}

/// sup |z·θ̂′| = sup |2zy′/√(1 − y²)|, z = ½ − s.
fn conditioning(weights: &[Double]) -> f64 {
    let sum = Cosines::odd(weights);
    supremum([0.0, 0.5], |low, high| {
        let cell = sum.over(low, high);
        let y = cell.largest(0).min(1.0);
        2.0 * (0.5 - low) * cell.largest(1) / ((1.0 - y) * (1.0 + y)).sqrt()
    })
}

pub(super) fn cost(reduction: &Reduction, kernel: &Kernel) -> f64 {
    kernel::function(reduction, &[kernel]).cost_of_calls_too()
}

#[cfg(test)]
mod tests;
