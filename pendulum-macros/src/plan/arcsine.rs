//! 2·arcsin y for 0 ≤ y < 1 by a polynomial fitted to the range that occurs.
//!
//! arcsin √c/√c is analytic in c but for the cut [1, ∞), and bounded by π/2 for |c| ≤ 1. On c ∈ [0, C] its Chebyshev
//! interpolant converges with (ρ + 1/ρ)/2 = 2/C − 1. Up to a largest y of √0.4 it serves directly, with c = y². Beyond,
//! 2 arcsin y = π − 4 arcsin x, x² = (1 − y)/2 ≤ ½, serves for all y: the choice between two formulas would be a branch
//! that data can mispredict, and costs more than the terms that it saves.

use super::fit::{Domain, Fit};
use crate::program::{Builder, Id, Op};
use pendulum_runtime::double::Double;
use std::f64::consts::FRAC_PI_2;

/// The polynomial, and whether the arcsine is that of the complement.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Arcsine {
    /// arcsin √c/√c.
    ratio: Fit,
    complement: bool,
}

/// The largest c for which one polynomial is the cheaper way.
const DIRECT: f64 = 0.4;

impl Arcsine {
    /// For arguments from −`beyond`, which is little, to `most`, with an error of the ratio of at most `limit`.
    pub(crate) fn new(beyond: f64, most: f64, limit: f64) -> Self {
        if most * most >= DIRECT {
            return Self::of_complement(beyond, limit);
        }
        Self { ratio: ratio_to((most * most).max(1e-6) * 1.0001, limit), complement: false }
    }

    /// For arguments from −`beyond` to 1, by the complement.
    pub(crate) fn of_complement(beyond: f64, limit: f64) -> Self {
        Self { ratio: ratio_to(0.5 + beyond.max(5e-5), limit), complement: true }
    }

    /// Emits 2·sign·arcsin y.
    pub(crate) fn lower(&self, b: &mut Builder, y: Id, sign: f64) -> Id {
        if !self.complement {
            let square = b.mul(y, y);
            let ratio = self.ratio(b, square, 2.0 * sign);
            return b.mul(y, ratio);
        }
        let (one, half) = (b.constant(1.0), b.constant(0.5));
        let rest = b.sub(one, y);
        let c = b.mul(rest, half);
        b.name(c, "c");
        let pi = b.rounded(Double::PI.scale(sign));
        let fourfold = self.of_root(b, c, 4.0 * sign);
        b.sub(pi, fourfold)
    }

    /// Emits sign·(π − 4 arcsin √c), given π and 4 with that sign.
    pub(crate) fn lower_of_complement(&self, b: &mut Builder, c: Id, [pi, four]: [Id; 2]) -> Id {
        let single = self.of_root(b, c, 1.0);
        let fourfold = b.mul(single, four);
        b.sub(pi, fourfold)
    }

    /// factor·arcsin √c.
    fn of_root(&self, b: &mut Builder, c: Id, factor: f64) -> Id {
        let root = b.push(Op::Root(c));
        b.name(root, "root");
        let ratio = self.ratio(b, c, factor);
        b.mul(root, ratio)
    }

    /// factor·arcsin √c/√c.
    fn ratio(&self, b: &mut Builder, c: Id, factor: f64) -> Id {
        self.ratio.times(factor).lower(b, c, &["c", "c2", "c4", "c8", "c16", "c32", "c64", "c128"])
    }

    pub(crate) fn terms(&self) -> usize {
        self.ratio.terms()
    }
}

/// The polynomial for 0 ≤ c ≤ `end`.
fn ratio_to(end: f64, limit: f64) -> Fit {
    // To few bits, so that the change of variable is exact.
    let end = f64::from(end as f32);
    Fit::new(&Domain::reaching(end, end - 1.0, FRAC_PI_2), limit, ratio)
}

/// arcsin √c/√c = Σ (2j)!/(4ʲ j!² (2j + 1)) cʲ, for 0 ≤ c < 1.
fn ratio(c: Double) -> Double {
    let (mut weight, mut sum, mut j) = (Double::ONE, Double::ONE, 0.0);
    while weight.hi > 1e-34 {
        weight = weight * c * (2.0 * j + 1.0) / (2.0 * j + 2.0);
        j += 1.0;
        sum = sum + weight / (2.0 * j + 1.0);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::Float;
    use crate::program::rounding::Known;

    #[test]
    fn keeps_its_bound_directly_and_by_the_complement() {
        for most in [0.1, 0.6, 0.95, 0.999_999] {
            let arcsine = Arcsine::new(0.0, most, 1e-17);
            let mut b = Builder::new(Float::F64);
            let y = b.input();
            let result = arcsine.lower(&mut b, y, 1.0);
            let program = b.finish(vec![result]);
            for i in 0..=1000 {
                let y = most * f64::from(i) / 1000.0;
                let error = (program.run(y)[0] - 2.0 * y.asin()).abs();
                // Two roundings of numbers between 2 and 4, and the root's 3.5 units of a number below 3.
                assert!(error <= 7.0 * f64::EPSILON, "{y} of {most}: {error:e}");
            }
        }
    }

    /// Of arguments below 0, too, by the complement.
    #[test]
    fn beyond_the_lowest_point() {
        for (beyond, limit) in [(1e-3, 1e-9), (0.05, 1e-7), (0.3, 1e-5)] {
            let mut b = Builder::new(Float::F64);
            let y = b.input();
            let result = Arcsine::new(beyond, 0.9, limit).lower(&mut b, y, 1.0);
            let program = b.finish(vec![result]);
            for y in [-beyond, -0.5 * beyond, 0.0] {
                let bound = program.rounding(&[(0, Known::between(y, y))])[0].error;
                let error = (program.run(y)[0] - 2.0 * y.asin()).abs();
                assert!(error <= bound && bound <= 3.0 * limit, "{y} of {beyond}: {error:e} of {bound:e}");
            }
        }
    }

    /// Coarse fits are wrong by what their bound says, most so at the end of their range: the largest y, or 0 of the
    /// complement.
    #[test]
    fn coarse_fits_keep_their_bound_to_the_end() {
        for (most, worst) in [(0.1, 0.1), (0.3, 0.3), (0.62, 0.62), (0.9, 0.0)] {
            for limit in [1e-3, 1e-5, 1e-7] {
                let mut b = Builder::new(Float::F64);
                let y = b.input();
                let result = Arcsine::new(0.0, most, limit).lower(&mut b, y, 1.0);
                let program = b.finish(vec![result]);
                let bound = program.rounding(&[(0, Known::between(worst, worst))])[0].error;
                let error = (program.run(worst)[0] - 2.0 * worst.asin()).abs();
                assert!(error <= bound && bound < 1.5 * error, "{worst}, {limit:e}: {error:e} of {bound:e}");
                assert!(bound <= 3.0 * limit, "{worst}, {limit:e}: {bound:e}");
            }
        }
    }
}
