//! An approximation cut to so many terms, as a polynomial in powers of the phase that a reduction leaves.

use super::approximation::Approximation;
use super::pole::{Pole, Quotient};
use super::{Divided, Numerator, Polynomial, Remainder};
use crate::chebyshev::rounding_of_powers;
use crate::parse::Float;
use crate::plan::blocks::{Blocks, magnitude};
use crate::plan::form::Form;
use crate::plan::reduction::{ROUNDED, Reduction};
use crate::program::rounding::lost_to_underflow;
use crate::series::Parity;
use pendulum_runtime::double::Double;

/// So many terms of an approximation, for the phase of a reduction.
#[derive(Clone, Copy)]
pub(crate) struct Truncated<'a> {
    approximation: &'a Approximation,
    terms: usize,
    reduction: &'a Reduction,
    /// Whether the sign changes from one origin to the next.
    alternates: bool,
}

impl Approximation {
    /// Its first terms, or numbers in their place that make up for the others.
    pub(crate) fn truncated<'a>(&'a self, terms: usize, reduction: &'a Reduction, alternates: bool) -> Truncated<'a> {
        Truncated { approximation: self, terms: terms.min(self.terms()), reduction, alternates }
    }
}

impl Truncated<'_> {
    /// The polynomial, evaluated as `form` says, over its poles with that numerator; `None` if its coefficients can't be
    /// adapted without rounding by more than about `limit`.
    pub(crate) fn polynomial(&self, form: Form, numerator: Numerator, limit: f64) -> Option<Polynomial> {
        let Form::Adapted { chunk } = form else { return Some(self.over_poles(form, numerator)) };
        let Self { approximation, terms, reduction, .. } = *self;
        let unit = reduction.float.rounding_unit();
        let shortened = approximation.shortened(terms, reduction.overshoot);
        let shift = shortened.shifts(chunk)?.within(limit / (unit * approximation.weight(0.0)))?;
        let variable = self.variable(form, shift.by);
        let mut coefficients = self.powers(variable);
        if !can_be_adapted(&coefficients, self.quarter(), reduction.float) {
            return None;
        }
        let numerator = self.numerator(numerator, &mut coefficients);
        let blocks = Blocks::adapted(&coefficients, chunk, variable.reach)?;
        Some(self.evaluated(form, variable, blocks, numerator))
    }

    /// The same by powers of p, with the poles beside them: N/D = Q + R/D. `None` if there are none.
    pub(crate) fn beside_poles(&self, form: Form) -> Option<Polynomial> {
        let pole = self.pole()?;
        let variable = self.variable(form, form.shift());
        let powers = self.powers(variable);
        let Quotient { polynomial, remainder, lost } = pole.division(&powers, variable.shift);
        let at =
            |powers: &[Double], p: f64| powers.iter().rev().fold(0.0, |sum, c| sum * (p + variable.shift.hi) + c.hi);
        // The first value is the largest of an even curve that alternates, the only one that this is for.
        let largest = at(&powers, 0.0) / pole.least_between(0.0, 0.0);
        let dispensable = at(&polynomial, self.quarter()).abs() < 0.99 * largest.abs();
        let mut blocks = Blocks::careful(&polynomial, form.largest_last(), variable.reach);
        // Of the polynomial that was divided.
        blocks.mismatch = blocks.mismatch * pole.most(self.reduction.half()) + magnitude(&lost, variable.reach);
        let whole = self.evaluated(form, variable, blocks, Double::ONE);
        Some(Polynomial { divided: Divided::Rest(pole, Remainder { powers: remainder, dispensable }), ..whole })
    }

    /// The same by powers, without a numerator taken out of them.
    pub(crate) fn in_powers(&self, form: Form) -> Polynomial {
        self.over_poles(form, Numerator::One)
    }

    /// The same, over its poles, if any, with that numerator.
    fn over_poles(&self, form: Form, numerator: Numerator) -> Polynomial {
        let variable = self.variable(form, form.shift());
        let mut coefficients = self.powers(variable);
        let numerator = self.numerator(numerator, &mut coefficients);
        let blocks = Blocks::careful(&coefficients, form.largest_last(), variable.reach);
        self.evaluated(form, variable, blocks, numerator)
    }

    /// The numerator of the poles, if any, by which it divides the coefficients: by the leading one only where the others
    /// stay numbers of a moderate size.
    fn numerator(&self, numerator: Numerator, coefficients: &mut [Double]) -> Double {
        // Far from what overflows, or underflows, in either type.
        let widest = if self.reduction.float == Float::F64 { 1e100 } else { 1e12 };
        let leading = || {
            let last = coefficients.last()?;
            let moderate = |c: &Double| c.hi.abs() <= widest * last.hi.abs();
            (last.hi != 0.0 && coefficients.iter().all(moderate)).then_some(*last)
        };
        let divisor = match numerator {
            _ if self.approximation.pole().is_none() => None,
            Numerator::One => None,
            Numerator::Leading => leading(),
            Numerator::Same(numerator) => Some(numerator),
        };
        let divisor = divisor.unwrap_or(Double::ONE);
        if divisor != Double::ONE {
            for c in coefficients {
                *c = *c / divisor;
            }
        }
        divisor
    }

    /// The polynomial that blocks make, which may lack some terms, with the numerator of its poles.
    fn evaluated(&self, form: Form, variable: Variable, blocks: Blocks, numerator: Double) -> Polynomial {
        let Self { approximation, terms, reduction, alternates } = *self;
        let (parity, map, shift) = (approximation.parity(), approximation.map(), variable.shift);
        let truncation = approximation.truncation(terms, reduction.overshoot)
            + approximation.weight(reduction.overshoot) * self.converted(variable)
            + self.lost(variable, &blocks, numerator);
        let whole = |pole: Pole| Divided::Whole { numerator, pole };
        let divided = self.pole().map_or(Divided::Nothing, whole);
        Polynomial { form, shift, divided, parity, map, alternates, blocks, truncation }
    }

    /// What the conversion from Chebyshev polynomials to powers is rounded by.
    fn converted(&self, Variable { shift, area, reach }: Variable) -> f64 {
        let shortened = self.approximation.shortened(self.terms, self.reduction.overshoot);
        let eighth = 8.0 * area.hi;
        rounding_of_powers(&shortened.series, eighth * reach + (1.0 + eighth * shift.hi).abs())
    }

    /// What the blocks differ by from the polynomial, and what underflow takes.
    fn lost(&self, Variable { area, .. }: Variable, blocks: &Blocks, numerator: Double) -> f64 {
        let unit = if self.approximation.parity() == Parity::Odd { self.reduction.unit.hi } else { 1.0 };
        let poles = self.unit_of_poles().hi;
        // Coefficients that were divided may underflow where those that they are of don't.
        let size = numerator.hi.abs();
        // 8p ≤ 2.
        let reach = 2.5 / (8.0 * area.hi);
        let lost = size * blocks.mismatch + (1.0 + size) * lost_to_underflow(self.terms, reach);
        // Farther from 1 the second word of a pole's unit would lose bits.
        let bounded = lost.is_finite() && (1e-250..1e250).contains(&poles);
        if bounded { lost * self.approximation.weight(self.reduction.overshoot) * poles / unit } else { f64::INFINITY }
    }

    /// The variable of a form, which shifts p by so much.
    fn variable(&self, form: Form, shift: f64) -> Variable {
        let beyond = self.beyond();
        if form == Form::Normalised {
            // 8p − 1.
            return Variable { shift: -Double::ONE, area: Double::new(0.125), reach: 1.0 + 8.0 * beyond };
        }
        let area = self.area();
        let farthest = (0.25 + beyond) / area.hi;
        if shift == 0.0 {
            return Variable { shift: Double::ZERO, area, reach: farthest };
        }
        // A number of the type of the results, so that it is exact: over an arc its sum with half the arc is.
        let half = if self.is_arc() { Double::new(0.5) / self.reduction.unit } else { Double::ZERO };
        let shift = Double::new(self.reduction.float.round((half + Double::new(shift) / area).hi)) - half;
        let nearest = if self.is_arc() { beyond / area.hi } else { 0.0 };
        Variable { shift, area, reach: (shift.hi - nearest).abs().max((shift.hi + farthest).abs()) }
    }

    /// By how much p, or its image, exceeds ¼ at most: and, over an arc, is below 0.
    fn beyond(&self) -> f64 {
        let overshoot = self.reduction.overshoot.max(0.0);
        let beyond = if self.is_arc() { 0.25 * overshoot } else { overshoot * (1.0 + overshoot) };
        // A map's slope is largest at 0 and decreases; at ¼ it is below 1.
        beyond + ROUNDED
    }

    fn is_arc(&self) -> bool {
        self.approximation.parity() == Parity::Neither
    }

    /// p per unit of the polynomial's variable.
    fn area(&self) -> Double {
        let unit = self.reduction.unit;
        match self.approximation.parity() {
            _ if self.approximation.map().is_some() => Double::ONE,
            Parity::Neither => unit * 0.25,
            Parity::Even | Parity::Odd => unit * unit,
        }
    }

    /// What p = ¼ is in units of the reduction.
    fn quarter(&self) -> f64 {
        (Double::new(0.25) / self.area()).hi
    }

    /// The poles in units of the reduction.
    fn pole(&self) -> Option<Pole> {
        self.approximation.pole().map(|pole| pole.scaled(self.area()))
    }

    /// What these are multiplied with then.
    fn unit_of_poles(&self) -> Double {
        self.approximation.pole().map_or(Double::ONE, |pole| pole.unit(self.area()))
    }

    /// Coefficients of the powers of the variable, of what is divided by poles and multiplied by odd phases in units of
    /// the reduction.
    fn powers(&self, Variable { shift, area, .. }: Variable) -> Vec<Double> {
        let odd = if self.approximation.parity() == Parity::Odd { self.reduction.unit } else { Double::ONE };
        let factor = odd / self.unit_of_poles();
        let powers = self.approximation.shortened(self.terms, self.reduction.overshoot).powers_of(shift, area);
        powers.into_iter().map(|c| c * factor).collect()
    }
}

/// The variable of a polynomial: p/`area` + `shift`, and its largest magnitude.
#[derive(Clone, Copy, Debug)]
struct Variable {
    shift: Double,
    area: Double,
    reach: f64,
}

/// Whether no power of the variable, and no second word of a coefficient, comes near overflow or underflow: amplitudes
/// of 1e-268 and periods of 1e150 have plans, but not by adapted coefficients.
fn can_be_adapted(coefficients: &[Double], quarter: f64, float: Float) -> bool {
    let widest = if float == Float::F64 { 1e12 } else { 1e3 };
    let largest = coefficients
        .iter()
        .fold((0.0, 1.0), |(most, power): (f64, f64), c| (most.max((c.hi * power).abs()), power * quarter));
    (1.0 / widest..widest).contains(&quarter) && (1e-150..1e150).contains(&largest.0)
}

#[cfg(test)]
mod tests;
