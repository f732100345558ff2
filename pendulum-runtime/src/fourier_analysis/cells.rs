//! A proven bound of |θ̂ − θ|, by branch and bound.
//!
//! What cancels is counted as it is rounded, with u = 2⁻⁵³: the tail ([`OF_TAIL`]), and next to an overshoot the margin
//! dn² + ρ(2y − ρ), which then is under a root ([`OF_MARGIN`]). All else is relative, and the 10⁻⁹ of `certified_bound` cover
//! it.

use super::{FourierAnalysis, distance};
use crate::kernel::two_to;
use libm::sqrt;

/// The quarter period, to be cut into cells until each is bounded by the goal.
pub(super) struct Cells<'a> {
    analysis: &'a FourierAnalysis,
    terms: usize,
    goal: f64,
    /// sup |ρ|, |ρ″| and |ρ‴|, from the sums of the tail's moduli.
    total: f64,
    curvature: f64,
    third: f64,
}

/// What a tail is wrong by, in units of the bound of its second derivative, Σ k b₂ₙ₋₁ (2n − 1)²; its slope by as much of the
/// third. Of its term of sin((2n − 1)w) the argument is wrong by (2n − 1)πu at most; it is j < n steps of the recurrence after
/// the first, each rounded by 4u, which adds j²·4u. Both together are below (2n − 1)²·2⁻⁵⁰.
const OF_TAIL: f64 = two_to(-50);

/// Above what dn² and ρ(2y − ρ) are wrong by, each of itself. Where it is computed dn is ½ √k′ at least, by an exponential of
/// which the exponent is wrong by 2u of itself: dn by 2u ln(4/√k′), and by some 20u at most of all else. That is 43u at
/// k′ = 9·10⁻¹⁰, beyond which the macro has no use for Eq. 22 (`smallest_working_terms`). Found are up to 7u.
const OF_MARGIN: f64 = two_to(7 - 53);

impl<'a> Cells<'a> {
    pub(super) fn new(analysis: &'a FourierAnalysis, terms: usize, goal: f64) -> Self {
        let [total, curvature, third] = [0, 2, 3].map(|order| analysis.tail_moment(terms, order));
        Self { analysis, terms, goal, total, curvature, third }
    }

    /// A bound of the error for low ≤ z ≤ high, after at most `depth` halvings.
    pub(super) fn bound(&self, low: f64, high: f64, depth: u32) -> f64 {
        let here = self.cell_bound(low, high);
        if here <= self.goal || depth == 0 {
            return here;
        }
        let middle = 0.5 * (low + high);
        let left = self.bound(low, middle, depth - 1);
        left.max(self.bound(middle, high, depth - 1))
    }

    /// Taylor's theorem bounds ρ on the cell; given ρ, |asin(y − ρ) − asin y| is largest at the cell's end, where y is,
    /// with two exceptions.
    fn cell_bound(&self, low: f64, high: f64) -> f64 {
        let radius = core::f64::consts::PI * (high - low); // half the cell, in w = 2πz
        let tail = self.analysis.tail(self.terms, 0.5 * (low + high));
        let rounding = OF_TAIL * (self.curvature + radius * self.third);
        let spread = radius * tail.slope.abs() + 0.5 * radius * radius * self.curvature + rounding;
        let end = self.analysis.sample(self.terms, high);
        let bound = |tail: f64| {
            let (square, rest) = (end.dn * end.dn, tail * (2.0 * end.y - tail));
            let margin = square + rest;
            if end.y < tail {
                // asin y − asin(y − ρ) grows with y from y = ρ/2 on, and is the same at y = 0 and y = ρ.
                let y = tail.min(1.0);
                distance(y, sqrt((1.0 - y) * (1.0 + y)), y, 1.0)
            } else if margin >= 0.0 {
                // The less it is, the farther they are apart.
                let rounding = OF_MARGIN * (square + rest.abs());
                distance(end.y, end.dn, tail, (margin - rounding).max(0.0))
            } else {
                // asin(y − ρ) − asin y grows with y only until y − ρ = 1.
                distance(1.0 + tail, sqrt(-tail * (2.0 + tail)), tail, 0.0)
            }
        };
        let most = (tail.value + spread).min(self.total);
        let least = (tail.value - spread).max(-self.total);
        bound(most).max(bound(least))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::double::Double;
    use crate::double_trig::half_angle;

    /// Also just below the limits of overshoot, where the largest argument cuts a cell.
    #[test]
    #[cfg_attr(miri, ignore = "a million samples")]
    fn the_bound_is_above_the_supremum_and_as_close_as_asked() {
        for (amplitude, terms) in [
            (0.5, 1),
            (0.7, 1),
            (0.73, 1),
            (0.88, 2),
            (0.89, 2),
            (0.904, 2),
            (0.90456, 2),
            (0.875, 4),
            (0.954, 4),
            (0.95, 6),
        ] {
            let (k, kc) = half_angle(Double::PI * amplitude);
            let analysis = FourierAnalysis::new(k, kc);
            let (bound, supremum) = (analysis.certified_bound(terms, 1e-3), analysis.supremum(terms));
            // 1e-9 more is allowed for rounding.
            assert!(bound >= supremum && bound <= 1.001_001 * supremum, "{amplitude}π, {terms}: {bound} {supremum}");
        }
    }

    /// Every cell's bound holds by itself, not only that of the cells that decide: wide ones, where the tail may exceed
    /// y at the end or the largest argument cuts them, and narrow ones.
    #[test]
    #[cfg_attr(miri, ignore = "many samples")]
    fn no_cell_is_exceeded() {
        for (amplitude, terms) in [(0.3, 1), (0.73, 1), (0.904, 2), (0.95, 5), (0.999, 20)] {
            let (k, kc) = half_angle(Double::PI * amplitude);
            let analysis = FourierAnalysis::new(k, kc);
            let cells = Cells::new(&analysis, terms, 0.0);
            for level in 0..9 {
                let width = 0.25 / f64::from(1 << level);
                for i in 0..1 << level {
                    let low = width * f64::from(i);
                    let bound = cells.cell_bound(low, low + width);
                    let error = |j: i32| analysis.sample(terms, low + width * f64::from(j) / 16.0).error();
                    let largest = (0..=16).map(error).fold(0.0, f64::max);
                    // Rounding, of errors down to 10⁻¹⁶.
                    assert!(
                        largest <= bound * (1.0 + 1e-9) + 1e-15,
                        "{amplitude}π, {terms}, {low} {width}: {largest} {bound}"
                    );
                    // A difference of arcsines is at most π, of positive arguments half of that; both are doubled.
                    assert!(bound <= 2.0 * core::f64::consts::PI);
                }
            }
        }
    }
}
