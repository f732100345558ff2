//! The paper's θ̂ as one polynomial in each piece of half a period.
//!
//! θ̂ is analytic but where y = ±1, which at 7π/8 with N = 4 it is nowhere within 0.125i of the real axis: as far as
//! eight times half a 64th of a period. So a dozen terms about the middle of such a piece leave less than rounding does,
//! where one polynomial for all phases needs 34 ([`super::single`]).
//!
//! **Error.** As in [`super::single`], each interpolant Q is tested afterwards. With x = c + hu the residual R = y(x) −
//! sin(Q(u)/2) is an entire function of u. On an ellipse of parameter ρ |y| is bounded by its coefficients, Im x being
//! at most h(ρ − 1/ρ)/2; and |sin(Q/2)| by the hyperbolic cosine of |Im Q/2|, to which the constant adds nothing. What
//! follows from sup |R| is in [`super::residual`].

use super::Allowance;
use super::residual::{OF_RESIDUAL, largest_residual, of_residual, twice_arcsine};
use crate::chebyshev::{CosineTable, Interpolation, OF_INTERPOLATION};
use crate::plan::Bound;
use crate::plan::cosines::Cosines;
use crate::plan::kernel::{Core, Kernel};
use crate::plan::pieces::{Piecewise, half, phase};
use crate::plan::reduction::Reduction;
use crate::series::{Parity, Wave};
use crate::supremum::larger;
use pendulum_runtime::double::Double;

/// The numbers of pieces of half a period that are tried.
const COUNTS: [usize; 2] = [32, 64];

/// Points of interpolation in each.
const POINTS: usize = 16;

/// More points than this for a residual take too long.
const MOST_POINTS: usize = 40;

/// θ̂ for these weights in so many pieces at least, their series wrong by much less than `limit`; `None` if it bends too
/// much.
pub(super) fn approximation(weights: &[Double], limit: f64, least: usize) -> Option<Piecewise> {
    let size = Cosines::odd(weights).magnitude(0);
    let sum = Wave::harmonics(weights);
    let negligible = limit.min(size) * OF_INTERPOLATION;
    first_that_serves(&sum, size, least, |pieces| in_pieces(&sum, pieces, negligible))
}

/// With the first number of pieces from the least on that serves, if a sum of that size is worth the interpolation.
pub(super) fn first_that_serves(
    sum: &Wave,
    size: f64,
    least: usize,
    in_pieces: impl Fn(usize) -> Option<Piecewise>,
) -> Option<Piecewise> {
    // One that may reach 1 isn't.
    of_residual(sum, 0.0)?;
    // Second words of small coefficients underflow.
    COUNTS.into_iter().filter(|&pieces| pieces >= least && size > 1e-150).find_map(in_pieces)
}

fn in_pieces(sum: &Wave, pieces: usize, negligible: f64) -> Option<Piecewise> {
    let residual = |piece: &Piece<'_>, own: &[Double]| {
        let interpolation = piece.interpolation(own, negligible * OF_RESIDUAL, 2, MOST_POINTS)?;
        Some(piece.residual(own, interpolation))
    };
    let (series, residual) = interpolants(sum, pieces, POINTS, residual)?;
    let error = of_residual(sum, residual)?;
    (error <= negligible).then(|| Piecewise::known(series, error, Parity::Even))
}

/// θ̂ through so many points in each of so many pieces, and the largest of what is known of the residuals.
pub(super) fn interpolants(
    sum: &Wave,
    pieces: usize,
    points: usize,
    of_residual: impl Fn(&Piece<'_>, &[Double]) -> Option<f64>,
) -> Option<(Vec<Vec<Double>>, f64)> {
    let table = CosineTable::new(points);
    let (mut series, mut largest) = (Vec::new(), 0.0_f64);
    for index in 0..=pieces / 2 {
        let piece = Piece { sum, pieces, index };
        let values: Option<Vec<Double>> = table.points().map(|u| twice_arcsine(sum.at(piece.phase(u)))).collect();
        let own = table.coefficients(&values?);
        largest = larger(largest, of_residual(&piece, &own)?);
        series.push(own);
    }
    Some((series, largest))
}

/// The kernel with a table that keeps within the allowance.
pub(super) fn kernel(
    piecewise: &Piecewise,
    allowance: Allowance,
    reduction: &Reduction,
    direction: f64,
) -> Option<(Kernel, Bound)> {
    let (mut pieces, truncation) = piecewise.kernel(reduction, allowance.truncation)?;
    let bound = allowance.kept(truncation, pieces.rounding())?;
    if direction < 0.0 {
        pieces.negate();
    }
    Some((Core::Pieces(Box::new(pieces)).into(), bound))
}

/// One of so many pieces, and the sum y, of which θ̂ is twice the arcsine.
pub(super) struct Piece<'a> {
    sum: &'a Wave,
    pieces: usize,
    index: usize,
}

impl Piece<'_> {
    fn phase(&self, u: Double) -> Double {
        phase(self.pieces, self.index, u)
    }

    /// One of the residual of the interpolant Q, wrong by at most `limit`.
    pub(super) fn interpolation(
        &self,
        series: &[Double],
        limit: f64,
        least: usize,
        most: usize,
    ) -> Option<Interpolation> {
        let ellipse = |rho: f64| (self.bound(series, rho), rho);
        let ellipses = [3.0, 5.0, 8.0, 12.0, 20.0, 32.0].into_iter().map(ellipse);
        Interpolation::fewest(ellipses, limit, least, most)
    }

    /// Bounds |y − sin(Q/2)| by it.
    pub(super) fn residual(&self, series: &[Double], interpolation: Interpolation) -> f64 {
        largest_residual(self.sum, series, |u| self.phase(u), interpolation)
    }

    /// The same on the ellipse with parameter ρ.
    fn bound(&self, series: &[Double], rho: f64) -> f64 {
        let height = 0.5 * half(self.pieces) * (rho - 1.0 / rho);
        let term = |(j, c): (usize, &Double)| c.hi.abs() * libm::sinh(j as f64 * libm::log(rho));
        let angle: f64 = series.iter().enumerate().map(term).sum();
        self.sum.bound(height) + libm::cosh(0.5 * angle)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::weights_from;
    use super::*;
    use crate::parse::Float;
    use crate::plan::reduction::Reduction;

    /// The numbers of pieces and of terms for an error of 2⁻⁵²; nearer to an overshoot there are no pieces.
    #[test]
    fn pieces_and_terms() {
        let time = Reduction::time(1.0, false, Float::F64).unwrap();
        let found = |theta0: &str, terms: usize| {
            let piecewise = approximation(&weights_from(theta0, terms), 1e-16, 0)?;
            Some((piecewise.pieces(), piecewise.terms_for(2e-16, &time)?))
        };
        assert_eq!(found("1", 1), Some((32, 9)));
        assert_eq!(found("7π/8", 4), Some((32, 12)));
        assert_eq!(found("7π/8", 2), Some((64, 12)));
        assert_eq!(found("0.93π", 4), Some((64, 12)));
        assert_eq!(found("0.95π", 4), None);
    }

    /// A series that is wrong by ε anywhere is seen to be: by ε/2·cos(θ̂/2), times Lebesgue's constant.
    #[test]
    fn errors_are_seen() {
        let sum = Wave::harmonics(&weights_from("7π/8", 4));
        let table = CosineTable::new(POINTS);
        for index in [0, 5, 16] {
            let piece = Piece { sum: &sum, pieces: 32, index };
            let angle = |u: Double| twice_arcsine(sum.at(piece.phase(u))).unwrap();
            let mut series = table.coefficients(&table.points().map(angle).collect::<Vec<_>>());
            let residual =
                |series: &[Double]| piece.residual(series, piece.interpolation(series, 1e-24, 2, MOST_POINTS).unwrap());
            let exact = residual(&series);
            assert!(exact < 1e-19, "{index}: {exact:e}");
            let epsilon = 1e-9;
            series[2] = series[2] + Double::new(epsilon);
            // T₂ is largest at the ends, cos(θ̂/2) where θ̂ is smaller.
            let ends = [-1.0, 1.0].map(|u| libm::cos(0.5 * angle(Double::new(u)).hi));
            let expected = 0.5 * epsilon * ends[0].max(ends[1]);
            let times = residual(&series) / expected;
            assert!((1.0..4.0).contains(&times), "{index}: {times}");
        }
    }

    /// Where Im s is as large as on the ellipse, and |sin(Q/2)| with Q = 3 + T₁.
    #[test]
    fn bounds_on_ellipses() {
        let sum = Wave::harmonics(&[Double::ONE]);
        let piece = Piece { sum: &sum, pieces: 32, index: 5 };
        let series = [Double::new(3.0), Double::ONE];
        let expected = (half(32) * 0.75 * std::f64::consts::PI).cosh() + (0.5 * 0.75_f64).cosh();
        let found = piece.bound(&series, 2.0);
        assert!((found / expected - 1.0).abs() < 1e-8, "{found} {expected}");
    }
}
