//! Polynomials for fixed functions on [0, Z]: what a plan uses of exponentials, arctangents and arcsines.

use super::estrin::estrin;
use crate::chebyshev::{
    CosineTable, interpolation_error, lebesgue, points_for, rounding_of_powers, scale, shift, to_powers,
};
use crate::power::two_to;
use crate::program::{Builder, Id};
use pendulum_runtime::double::Double;

/// A polynomial and its distance from the function.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fit {
    /// Powers of z, lowest first.
    coefficients: Vec<Double>,
    truncation: f64,
}

/// A function analytic and bounded by `bound` inside the ellipse with foci 0 and `end` and parameter `rho`.
pub(crate) struct Domain {
    pub(crate) end: f64,
    pub(crate) rho: f64,
    pub(crate) bound: f64,
}

impl Domain {
    /// The ellipse that reaches to `furthest` < 0 on the left, or to end − `furthest` on the right.
    pub(crate) fn reaching(end: f64, furthest: f64, bound: f64) -> Self {
        let x = 1.0 - 2.0 * furthest / end;
        Self { end, rho: x + (x * x - 1.0).sqrt(), bound }
    }
}

impl Fit {
    /// The Chebyshev interpolant, cut where its error is below `limit`. The function's values are to be within 2⁻⁹⁴ of its
    /// bound.
    pub(crate) fn new(domain: &Domain, limit: f64, function: impl Fn(Double) -> Double) -> Self {
        let Domain { end, rho, bound } = *domain;
        // So many that their error doesn't blur the bound where the last term is far below the limit. Of more than 200,
        // which no plan needs, the error says what is left.
        let points = points_for(bound, rho, limit * two_to(-16)).clamp(4.0, 200.0) as usize;
        let (series, rounding) = CosineTable::new(points).interpolant(|u| function((u + Double::ONE) * (0.5 * end)));
        let error = interpolation_error(bound, rho, points) + lebesgue(points) * two_to(-94) * bound + rounding;
        let dropped = |terms: usize| series.iter().skip(terms).map(|c| c.hi.abs()).sum::<f64>() + error;
        let terms = (2..points).find(|&terms| dropped(terms) <= limit).unwrap_or(points);
        let powers = shift(&to_powers(&series[..terms]), Double::new(-1.0));
        let coefficients = scale(powers, Double::new(2.0) / end);
        Self { coefficients, truncation: dropped(terms) + rounding_of_powers(&series[..terms], 3.0) }
    }

    /// So many times the function, a power of two and a sign, by which no digit changes.
    pub(crate) fn times(&self, factor: f64) -> Self {
        let coefficients = self.coefficients.iter().map(|&c| c.scale(factor)).collect();
        Self { coefficients, truncation: self.truncation * factor.abs() }
    }

    /// This one of the same function, or the other, if that is nearer.
    pub(crate) fn nearest<'a>(&'a self, other: &'a Self) -> &'a Self {
        if other.truncation < self.truncation { other } else { self }
    }

    /// Emits the polynomial, its truncation charged to the constant term.
    pub(crate) fn lower(&self, b: &mut Builder, z: Id, names: &[&'static str]) -> Id {
        let constant = |(index, c): (usize, &Double)| {
            let slack = if index == 0 { self.truncation } else { 0.0 };
            b.loose(c.hi, c.lo.abs() + slack)
        };
        let coefficients: Vec<Id> = self.coefficients.iter().enumerate().map(constant).collect();
        // The constant term is the largest: added last, it is rounded with once, and not at every level.
        let (&first, rest) = coefficients.split_first().expect("a term");
        let rest = estrin(b, z, rest, names);
        let rest = b.mul(rest, z);
        b.add(first, rest)
    }

    pub(crate) fn terms(&self) -> usize {
        self.coefficients.len()
    }
}

#[cfg(test)]
mod tests;
