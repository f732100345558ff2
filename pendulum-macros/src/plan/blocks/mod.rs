//! Polynomials in blocks, with adapted coefficients: three operations for two terms instead of four.
//!
//! With y = p + c and w = y², write a polynomial as E(w) + y·O(w). Where all roots α of O are real, dividing it by w −
//! α leaves a number β and no multiple of y, and the quotient is of the same kind. So it equals
//!
//! ((z·(w − α₁) + β₁)·(w − α₂) + β₂)…, with z linear or quadratic in y,
//!
//! a multiplication and two additions for two terms, of which w − α waits for nothing (Knuth, *The Art of Computer
//! Programming* 2, 4.6.4, theorem E). Some c makes the roots real (Eve 1964). What it costs is conditioning: the
//! factors may be large where the value is small. Hence c is chosen among many by estimated rounding, and long
//! polynomials are cut into blocks, Σ Bⱼ(y)·y^(chunk·j), each of which is adapted; or, where that is not enough, only
//! those blocks of four are that are small beside the first. The proof of the rounding is that of any program.

mod roots;
mod shifts;

pub(crate) use shifts::Shifts;

use super::estrin::estrin;
use crate::power::power;
use crate::program::{Builder, Id};
use pendulum_runtime::double::Double;
use roots::{factored, roots};

/// For the reader.
pub(super) const LARGEST_LAST: &str = ", the largest terms added last";

/// For the reader: in blocks of so many terms.
pub(super) fn adapted_in_blocks(chunk: usize) -> String {
    format!(", coefficients adapted in blocks of {chunk}")
}

/// A polynomial in y, in blocks of so many terms.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Blocks {
    chunk: usize,
    /// The first two terms, if they are added last: they are the largest, and are rounded with once, not with every
    /// block. The first block is without them then.
    lead: Vec<Double>,
    rest: Vec<Block>,
    /// Bounds its distance from the polynomial that it was made of.
    pub(crate) mismatch: f64,
}

/// One block: z, and the (α, β) in the order of evaluation.
#[derive(Clone, Debug, PartialEq)]
struct Block<T = Double> {
    /// Powers of y, lowest first: at most three, or all.
    head: Vec<T>,
    factors: Vec<(T, T)>,
}

/// The least number of terms that adapting saves an operation of.
pub(crate) const LEAST: usize = 4;

/// The chain of dependent operations, in cycles, of a polynomial of `terms` in blocks of `chunk`, given y: four
/// operations of a block's head or two of a factor at a time; then the blocks are joined.
pub(crate) fn chain(terms: usize, chunk: usize) -> usize {
    let longest = terms.min(chunk);
    let joined = terms.div_ceil(chunk) - usize::from(is_early(terms, chunk));
    let joints = joined.next_power_of_two().ilog2() as usize;
    STEP * (longest / 2 + longest % 2 + joints)
}

/// Whether the last block is short, and there before the others are, and these are as many as a power of two: then it
/// becomes a part of one of them.
fn is_early(terms: usize, chunk: usize) -> bool {
    let (others, rest) = (terms / chunk, terms % chunk);
    (1..LEAST).contains(&rest) && others > 1 && others.is_power_of_two()
}

/// Cycles of a multiplication and an addition in sequence.
pub(crate) const STEP: usize = 5;

/// Operations of a polynomial of `terms` in blocks of `chunk`; y and w, which other polynomials may share, apart.
pub(crate) fn operations(terms: usize, chunk: usize) -> usize {
    let block = |terms: usize| match terms {
        0..=3 => 2 * terms.saturating_sub(1),
        _ if terms.is_multiple_of(2) => 2 + 3 * (terms / 2 - 1),
        _ => 4 + 3 * ((terms - 3) / 2),
    };
    let (whole, rest) = (terms / chunk, terms % chunk);
    let blocks = terms.div_ceil(chunk);
    let powers = if blocks > 1 { chunk.ilog2() - 1 + (blocks - 1).ilog2() } else { 0 };
    whole * block(chunk) + block(rest) + 2 * (blocks - 1) + powers as usize
}

/// Operations that a leading coefficient of 1 saves: its product, and that with a power of w where it is by itself.
pub(crate) fn saved(terms: usize, chunk: usize) -> usize {
    1 + usize::from(is_early(terms, chunk) && terms % chunk == 1)
}

impl Blocks {
    /// Adapts a polynomial, given in powers of y, for |y| ≤ `reach`.
    pub(crate) fn adapted(powers: &[Double], chunk: usize, reach: f64) -> Option<Self> {
        let rest = powers.chunks(chunk).map(Block::adapted).collect::<Option<Vec<Block>>>()?;
        let mismatch = mismatch(powers, &rest, reach);
        mismatch.is_finite().then_some(Self { chunk, lead: Vec::new(), rest, mismatch })
    }

    /// The same with the largest terms as they are: blocks are adapted only where their rounding is nothing beside that
    /// of the first two terms, which may be added last.
    pub(crate) fn careful(powers: &[Double], largest_last: bool, reach: f64) -> Self {
        let (largest, others) = powers.split_at(powers.len().min(2));
        let size = magnitude(largest, reach);
        let plain = |powers: &[Double]| Block { head: powers.to_vec(), factors: Vec::new() };
        let block = |(powers, index): (&[Double], i32)| {
            let weight = power(reach, LEAST as i32 * index);
            let adapted = Block::adapted(powers).filter(|block| block.magnitude(reach) * weight <= size / 32.0);
            adapted.unwrap_or_else(|| plain(powers))
        };
        let (first, small) = powers.split_at(powers.len().min(LEAST));
        let (lead, first) = if largest_last { (largest, &others[..others.len().min(2)]) } else { (&[][..], first) };
        let rest: Vec<Block> = std::iter::once(plain(first)).chain(small.chunks(LEAST).zip(1..).map(block)).collect();
        let lost = mismatch(&powers[lead.len()..], &rest, reach) * power(reach, lead.len() as i32);
        Self { chunk: LEAST, lead: lead.to_vec(), rest, mismatch: lost }
    }

    pub(crate) fn terms(&self) -> usize {
        let of_rest = self.rest.iter().map(|block| block.head.len() + 2 * block.factors.len());
        self.lead.len() + of_rest.sum::<usize>()
    }

    /// The coefficient of the highest power of y.
    pub(crate) fn leading(&self) -> Double {
        let of_rest = self.rest.last().and_then(|block| block.head.last());
        of_rest.or(self.lead.last()).copied().unwrap_or(Double::ZERO)
    }

    /// Powers of y.
    #[cfg(test)]
    pub(crate) fn powers(&self) -> Vec<Double> {
        self.lead.iter().copied().chain(self.rest.iter().flat_map(Block::expanded)).collect()
    }

    /// For the reader: how it is evaluated.
    pub(crate) fn describe(&self) -> String {
        let last = if self.lead.is_empty() { "" } else { LARGEST_LAST };
        let whole = |block: &Block| block.factors.is_empty();
        let adapted = match self.rest.len() {
            _ if self.rest.iter().all(whole) => String::new(),
            // The first block is the largest.
            2.. if whole(&self.rest[0]) => ", the small coefficients adapted".to_owned(),
            1 => ", coefficients adapted".to_owned(),
            _ => adapted_in_blocks(self.chunk),
        };
        format!("{last}{adapted}")
    }

    pub(crate) fn negate(&mut self) {
        self.lead.iter_mut().for_each(|c| *c = -*c);
        for block in &mut self.rest {
            block.head.iter_mut().for_each(|c| *c = -*c);
            block.factors.iter_mut().for_each(|(_, beta)| *beta = -*beta);
        }
    }

    /// Evaluates it at y.
    pub(crate) fn lower(&self, b: &mut Builder, y: Id) -> Id {
        const POWERS: [&str; 8] = ["y", "w", "w2", "w4", "w8", "w16", "w32", "w64"];
        if let [short] = &self.rest[..]
            && self.lead.len() + short.head.len() < LEAST
            && short.factors.is_empty()
        {
            let coefficients = [&self.lead[..], &short.head].concat();
            return one_by_one(b, y, &coefficients);
        }
        let lead = (!self.lead.is_empty()).then(|| by_pairs(b, y, &self.lead));
        b.name(y, POWERS[0]);
        let w = b.mul(y, y);
        b.name(w, POWERS[1]);
        let level = self.chunk.ilog2() as usize;
        let mut power = w;
        if self.rest.len() > 1 {
            for name in &POWERS[2..=level] {
                power = b.mul(power, power);
                b.name(power, name);
            }
        }
        let values = self.values(b, [y, w, power]);
        let sum = estrin(b, power, &values, &POWERS[level..]);
        lead.map_or(sum, |lead| b.add(lead, sum))
    }

    /// The values of the blocks. Of an early last one a number 1 is added to what the one before it ends with, anything else
    /// to the first, for which nothing waits.
    fn values(&self, b: &mut Builder, [y, w, power]: [Id; 3]) -> Vec<Id> {
        let others = self.rest.len() - 1;
        let early = self.rest.last().filter(|_| is_early(self.terms(), self.chunk));
        let one = early.is_some_and(|last| last.head == [Double::ONE]);
        let blocks = &self.rest[..self.rest.len() - usize::from(early.is_some())];
        let ends = |index: usize| (one && index + 1 == others).then_some(power);
        let lower = |(index, block): (usize, &Block)| block.lower(b, y, w, ends(index));
        let mut values: Vec<Id> = blocks.iter().enumerate().map(lower).collect();
        if !self.lead.is_empty() {
            values[0] = b.mul(values[0], w);
        }
        if let Some(last) = early.filter(|_| !one) {
            let last = last.lower(b, y, w, None);
            let power = (0..others.ilog2()).fold(power, |power, _| b.mul(power, power));
            let last = b.mul(last, power);
            values[0] = b.add(values[0], last);
        }
        values
    }
}

/// What blocks with such factors and heads differ by from a polynomial, for |y| ≤ `reach`.
fn mismatch(powers: &[Double], blocks: &[Block], reach: f64) -> f64 {
    let expanded = blocks.iter().flat_map(Block::expanded);
    let differences: Vec<Double> = powers.iter().zip(expanded).map(|(c, found)| *c - found).collect();
    magnitude(&differences, reach)
}

/// The largest sum of the powers of |y| ≤ `reach`, whatever the signs.
pub(crate) fn magnitude(powers: &[Double], reach: f64) -> f64 {
    powers.iter().rev().fold(0.0, |sum, c| sum * reach + c.hi.abs())
}

/// Few powers, which do without w, by Horner's rule.
pub(crate) fn one_by_one(b: &mut Builder, y: Id, coefficients: &[Double]) -> Id {
    let coefficients: Vec<Id> = coefficients.iter().map(|&c| b.rounded(c)).collect();
    let step = |value, c| {
        let product = b.mul(value, y);
        b.add(product, c)
    };
    let value = coefficients.into_iter().rev().reduce(step);
    value.unwrap_or_else(|| b.constant(0.0))
}

/// Powers up to the third by those of y and w: as many operations, and three cycles less to wait.
fn by_pairs(b: &mut Builder, y: Id, coefficients: &[Double]) -> Id {
    let coefficients: Vec<Id> = coefficients.iter().map(|&c| b.rounded(c)).collect();
    estrin(b, y, &coefficients, &[])
}

impl Block {
    /// Divides by one factor after the other, the smallest root first: it stands last in the evaluation.
    fn adapted(powers: &[Double]) -> Option<Self> {
        let rough: Vec<f64> = powers.iter().map(|c| c.hi).collect();
        let alphas: Vec<Double> = roots(&rough)?.into_iter().map(|root| polished(powers, root)).collect();
        Some(factored(powers, &alphas))
    }

    /// The sum of the magnitudes that it is evaluated by: what it is rounded by, in units of rounding.
    fn magnitude(&self, reach: f64) -> f64 {
        let factor = |alpha: Double| reach * reach + alpha.hi.abs();
        let head = magnitude(&self.head, reach);
        self.factors.iter().fold(head, |size, &(alpha, beta)| size * factor(alpha) + beta.hi.abs())
    }

    /// Its powers of y.
    fn expanded(&self) -> Vec<Double> {
        self.factors.iter().fold(self.head.clone(), |powers, &(alpha, beta)| {
            let lower = powers.iter().map(|c| -(*c * alpha)).chain([Double::ZERO; 2]);
            let higher = [Double::ZERO; 2].into_iter().chain(powers.iter().copied());
            let mut product: Vec<Double> = lower.zip(higher).map(|(low, high)| low + high).collect();
            product[0] = product[0] + beta;
            product
        })
    }

    /// Evaluates it, and adds `more` to what it ends with, which waits for nothing.
    fn lower(&self, b: &mut Builder, y: Id, w: Id, more: Option<Id>) -> Id {
        let z = by_pairs(b, y, &self.head);
        let Some((last, others)) = self.factors.split_last() else { return more.map_or(z, |more| b.add(z, more)) };
        let product = |b: &mut Builder, value: Id, alpha: Double| {
            let minus_alpha = b.rounded(-alpha);
            let factor = b.add(w, minus_alpha);
            b.mul(value, factor)
        };
        let value = others.iter().fold(z, |value, &(alpha, beta)| {
            let product = product(b, value, alpha);
            let beta = b.rounded(beta);
            b.add(product, beta)
        });
        let product = product(b, value, last.0);
        let beta = b.rounded(last.1);
        let end = more.map_or(beta, |more| b.add(beta, more));
        b.add(product, end)
    }
}

/// A root of the odd part of `powers` to the precision of [`Double`], by Newton's method.
fn polished(powers: &[Double], root: f64) -> Double {
    let odd: Vec<Double> = powers.iter().skip(1).step_by(2).copied().collect();
    let mut w = Double::new(root);
    for _ in 0..3 {
        let zero = (Double::ZERO, Double::ZERO);
        let (at, slope) = odd.iter().rev().fold(zero, |(at, slope), c| (at * w + *c, slope * w + at));
        if slope.hi == 0.0 || at.hi == 0.0 {
            break;
        }
        w = w - at / slope;
    }
    w
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::Float;

    /// cos and more: coefficients of either sign, of a polynomial in p on [0, ¼].
    fn sample(terms: usize) -> Vec<Double> {
        let mut term = Double::new(2.7);
        (0..terms)
            .map(|j| {
                let this = term;
                term = -(term * 5.0) / (1.0 + j as f64);
                this
            })
            .collect()
    }

    /// Of w³ − 2w the roots are 0 and ±√2; even powers don't matter.
    #[test]
    fn roots_in_two_words() {
        let odd = [0.0, -2.0, 0.0, 1.0].map(Double::new);
        let powers: Vec<Double> = odd.iter().flat_map(|&c| [Double::new(7.0), c]).collect();
        let root = polished(&powers, std::f64::consts::SQRT_2);
        assert!((root * root - Double::new(2.0)).hi.abs() < 1e-30, "{root:?}");
        assert_eq!(polished(&powers, 0.0), Double::ZERO);
    }

    /// Evaluated in `f64`, it is the polynomial but for the rounding estimated; and it takes as many operations as
    /// said.
    #[test]
    fn it_is_the_polynomial() {
        for terms in 4..=20 {
            for chunk in [4, 8, 16] {
                let powers = sample(terms);
                let Some(Shifts { best: shift, .. }) = Shifts::new(&powers, chunk) else {
                    // Of large blocks with many terms none may be had.
                    assert!(terms > 13 && chunk > LEAST, "{terms} {chunk}");
                    continue;
                };
                let shifted = crate::chebyshev::shift(&powers, Double::new(-shift.by));
                let adapted = Blocks::adapted(&shifted, chunk, 1.0).unwrap();
                assert!(adapted.mismatch < 1e-25, "{terms} {chunk}: {}", adapted.mismatch);
                let mut b = Builder::new(Float::F64);
                let y = b.input();
                let result = adapted.lower(&mut b, y);
                let program = b.finish(vec![result]);
                let shared = usize::from(terms > 3);
                assert_eq!(program.operations(), operations(terms, chunk) + shared, "{terms} {chunk}");
                for p in [0.0, 0.1, 0.25] {
                    let exact = powers.iter().rev().fold(Double::ZERO, |sum, c| sum * p + *c);
                    let error = (Double::new(program.run(p + shift.by)[0]) - exact).hi.abs();
                    assert!(error <= shift.rounding * f64::EPSILON, "{terms} {chunk} {p}: {error:e} {shift:?}");
                }
            }
        }
    }

    /// Evaluated with care, it is wrong by little more than the rounding of its first two terms, in about as many
    /// operations.
    #[test]
    fn with_care() {
        for terms in 2..=24 {
            let powers = crate::chebyshev::shift(&sample(terms), Double::new(0.125));
            let careful = Blocks::careful(&powers, true, 0.125);
            assert!(careful.mismatch < 1e-31, "{terms}: {:e}", careful.mismatch);
            let mut b = Builder::new(Float::F64);
            let y = b.input();
            let result = careful.lower(&mut b, y);
            let program = b.finish(vec![result]);
            let adapted = careful.rest.iter().filter(|block| !block.factors.is_empty()).count();
            let (found, expected) = (program.operations(), operations(terms, LEAST) + usize::from(terms > 3));
            let blocks = terms / LEAST;
            assert_eq!(found + adapted, expected + blocks, "{terms}");
            assert!(terms < 8 || adapted + 1 >= blocks.saturating_sub(1), "{terms}: {adapted}");
            for y in [-0.125, -0.07, 0.0, 0.1, 0.125] {
                let exact = powers.iter().rev().fold(Double::ZERO, |sum, c| sum * y + *c);
                let error = (Double::new(program.run(y)[0]) - exact).hi.abs();
                let most = 1.5 * f64::EPSILON * magnitude(&powers[..2], 0.125);
                assert!(error <= most, "{terms} {y}: {error:e} {most:e}");
            }
        }
    }

    /// Where adapting would cost digits it is let be: a block whose last coefficient is nearly nought.
    #[test]
    fn blocks_that_are_left() {
        let adapted = |last: f64| {
            let small = [1e-3, 2e-3, 1e-3, last];
            let powers: Vec<Double> = [2.0, 1.0, 1.0, 1.0].into_iter().chain(small).map(Double::new).collect();
            let blocks = Blocks::careful(&powers, true, 1.0);
            let factors: Vec<usize> = blocks.rest.iter().map(|block| block.factors.len()).collect();
            assert_eq!(blocks.lead, powers[..2]);
            assert_eq!(factors[0], 0);
            factors[1] == 1
        };
        for (last, expected) in [(2e-3, true), (-1e-3, true), (5e-5, true), (3e-5, false), (1e-9, false), (0.0, false)]
        {
            assert_eq!(adapted(last), expected, "{last:e}");
        }
    }
}
