//! Polynomials in the square of the phase about an anchor.
//!
//! About a turning point θ is an even function of the phase s, and analytic in p = s² farther than in any variable
//! centred at the lowest point: its nearest singularities lie above the lowest point, s = ½ ± iK′/(2K), at the end of
//! the interval and not over its middle. At 7π/8 each coefficient gains a factor 4.47, against 2.71 for an odd polynomial
//! about the lowest point.
//!
//! **Error.** The curve is interpolated at M Chebyshev points of p ∈ [0, ¼]. On the ellipse with parameter ρ, s stays
//! within the strip |Im s| ≤ sinh(½ ln ρ)/2, where the Fourier series bounds the curve by B; the interpolant's error is at
//! most 4Bρ^(1−M)/(ρ − 1) (Trefethen, *Approximation Theory and Approximation Practice*, theorem 8.2). Dropping its
//! coefficients beyond the degree d adds at most the sum of their magnitudes. M is chosen so that the former is negligible;
//! the latter, explicitly known, is the truncation error.

use crate::chebyshev::{CosineTable, shift_by_one, to_powers};
use crate::plan::curve::Curve;
use crate::plan::reduction::{Phase, Reduction};
use crate::program::{Builder, Id, Op};
use crate::series::Parity;
use pendulum_runtime::double::Double;

/// A curve's Chebyshev coefficients on p ∈ [0, ¼], in u = 8p − 1; of curve/s if it is odd.
#[derive(Clone, Debug)]
pub(crate) struct Approximation {
    parity: Parity,
    series: Vec<Double>,
    /// Error of the whole series.
    remainder: f64,
}

/// The variable of the polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Form {
    /// Powers of p: the cheapest, for few terms.
    Plain,
    /// Powers of u = 8p − 1: well conditioned.
    Centred,
}

impl Form {
    /// The variable, for the reader; s is the phase in half periods (turns).
    pub(crate) fn variable(self) -> &'static str {
        match self {
            Self::Plain => "s²",
            Self::Centred => "8s² − 1",
        }
    }
}

/// A polynomial to be evaluated.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Kernel {
    pub(crate) form: Form,
    pub(crate) parity: Parity,
    pub(crate) alternates: bool,
    /// Powers of the form's variable, lowest first.
    pub(crate) coefficients: Vec<Double>,
    /// sup |polynomial − curve|.
    pub(crate) truncation: f64,
}

/// The greatest degree that is ever tried.
const MOST_POINTS: usize = 400;

impl Approximation {
    /// Interpolates `curve` so well that the error left is below `negligible`; `None` if that takes too many points.
    pub(crate) fn new(curve: &Curve, negligible: f64) -> Option<Self> {
        let (points, error) = enough_points(curve, negligible)?;
        let table = CosineTable::new(points);
        let sample = |u: Double| {
            let s = ((u + Double::ONE) * 0.125).sqrt();
            let value = curve.at(s);
            if curve.parity() == Parity::Odd { value / s } else { value }
        };
        let values: Vec<Double> = table.points().map(sample).collect();
        let mut series = table.coefficients(&values, points);
        let mut remainder = error + curve.omitted() * if curve.parity() == Parity::Odd { 1e3 } else { 2.0 };
        // What is far below the aim isn't worth carrying.
        while series.len() > 2 && series.last().is_some_and(|last| last.hi.abs() < negligible * 1e-3) {
            remainder += series.pop().map_or(0.0, |last| last.hi.abs());
        }
        Some(Self { parity: curve.parity(), series, remainder })
    }

    /// The error of the polynomial with the first `terms` coefficients, on the interval widened by `overshoot` (in s).
    pub(crate) fn truncation(&self, terms: usize, overshoot: f64) -> f64 {
        let dropped: f64 = self.series.iter().skip(terms).map(|c| c.hi.abs()).sum();
        // u exceeds 1 by ε = 8·overshoot·(1 + overshoot); there |Tⱼ| ≤ cosh(j·arcosh(1 + ε)) ≤ cosh(j·√(2ε)).
        let stretch = (self.series.len() as f64 * (16.0 * overshoot * (1.0 + overshoot)).sqrt()).cosh();
        let weight = if self.parity == Parity::Odd { 0.5 + overshoot } else { 1.0 };
        (dropped + self.remainder) * stretch * weight * (1.0 + 1e-12)
    }

    /// The fewest terms, at least two, whose truncation error is at most `limit`.
    pub(crate) fn terms_for(&self, limit: f64, overshoot: f64) -> Option<usize> {
        (2..=self.series.len()).find(|&terms| self.truncation(terms, overshoot) <= limit)
    }

    pub(crate) fn terms(&self) -> usize {
        self.series.len()
    }

    /// The polynomial with that many terms, in the variable of `form` scaled to the reduction's unit.
    pub(crate) fn kernel(&self, terms: usize, form: Form, reduction: &Reduction, alternates: bool) -> Kernel {
        let powers = to_powers(&self.series[..terms.min(self.series.len())]);
        let unit = reduction.unit;
        let mut coefficients = match form {
            Form::Centred => powers,
            Form::Plain => shift_by_one(&powers, unit * unit * 8.0),
        };
        if self.parity == Parity::Odd {
            coefficients.iter_mut().for_each(|c| *c = *c * unit);
        }
        let truncation = self.truncation(terms, reduction.overshoot);
        Kernel { form, parity: self.parity, alternates, coefficients, truncation }
    }
}

/// The number of points that makes the interpolation error negligible, and that error.
fn enough_points(curve: &Curve, negligible: f64) -> Option<(usize, f64)> {
    let strip = curve.strip();
    let heights = [0.5, 0.6, 0.7, 0.8, 0.88, 0.94].map(|part| (part * strip).min(1.5));
    let choice = |height: f64| {
        let log_rho = 2.0 * (2.0 * height).asinh();
        let mut bound = curve.bound(height);
        if curve.parity() == Parity::Odd {
            // |s| ≥ height on the ellipse's image.
            bound /= height;
        }
        let factor = 4.0 * bound / log_rho.exp_m1();
        let points = ((factor / negligible).ln() / log_rho).ceil().max(3.0) + 1.0;
        (points.is_finite() && points <= MOST_POINTS as f64)
            .then(|| (points as usize, factor * (-log_rho * (points - 1.0)).exp()))
    };
    heights.into_iter().filter_map(choice).min_by_key(|&(points, _)| points)
}

/// The variables that all kernels of a function share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Variables {
    /// The phase, and its second word if it has one.
    s: Id,
    low: Option<Id>,
    /// Its square.
    square: Id,
    /// 8·square − 1.
    centred: Id,
    magic: Id,
}

/// The second word of a phase within half an anchor, in anchors, is below this.
pub(crate) const LOW: f64 = 2.220_446_049_250_313e-16;

impl Variables {
    /// Squares the phase, kept within half an anchor: beyond the horizon the phase is arbitrary, the result is not.
    pub(crate) fn lower(b: &mut Builder, phase: Phase, reduction: &Reduction, keep_sign: bool) -> Self {
        let half = reduction.half();
        let (s, low) = if keep_sign || phase.low.is_some() {
            let s = clamp(b, phase.s, half);
            (b.name(s, "clamped"), phase.low.map(|low| clamp(b, low, LOW / reduction.unit.hi)))
        } else {
            (phase.s, None)
        };
        let square = b.mul(s, s);
        let square = if s == phase.s { at_most(b, square, half * half) } else { square };
        let scale = reduction.unit * reduction.unit * 8.0;
        let scale = b.exact(scale.hi, scale.lo);
        let one = b.constant(1.0);
        let scaled = b.mul(square, scale);
        let centred = b.sub(scaled, one);
        let [square, centred] = Self::refined(b, (s, low), [square, centred], scale);
        let (square, centred) = (b.name(square, "p"), b.name(centred, "u"));
        let [s, square, centred] = [s, square, centred].map(|x| b.convert(x, reduction.float));
        Self { s, low, square, centred, magic: phase.magic }
    }

    /// (s + low)² = s² + 2s·low, but for a term below 2⁻¹⁰⁴.
    fn refined(b: &mut Builder, (s, low): (Id, Option<Id>), [square, centred]: [Id; 2], scale: Id) -> [Id; 2] {
        let Some(low) = low else { return [square, centred] };
        let product = b.mul(s, low);
        let twice = b.add(product, product);
        let scaled = b.mul(twice, scale);
        [b.add(square, twice), b.add(centred, scaled)]
    }
}

fn at_most(b: &mut Builder, x: Id, limit: f64) -> Id {
    let limit = b.constant(limit);
    b.push(Op::Min { limit, x })
}

/// x within ±limit.
fn clamp(b: &mut Builder, x: Id, limit: f64) -> Id {
    let x = at_most(b, x, limit);
    let limit = b.constant(-limit);
    b.push(Op::Max { limit, x })
}

impl Kernel {
    /// Evaluates the polynomial, with the sign of the anchor.
    pub(crate) fn lower(&self, b: &mut Builder, variables: Variables, name: &'static str) -> Id {
        let (x, powers) = match self.form {
            Form::Plain => (variables.square, &PLAIN_POWERS),
            Form::Centred => (variables.centred, &CENTRED_POWERS),
        };
        let coefficients: Vec<Id> = self.coefficients.iter().map(|c| b.exact(c.hi, c.lo)).collect();
        let mut value = estrin(b, x, &coefficients, powers);
        if self.parity == Parity::Odd {
            let product = b.mul(variables.s, value);
            value = match variables.low {
                Some(low) => {
                    let rest = b.mul(low, value);
                    b.add(product, rest)
                }
                None => product,
            };
        }
        b.name(value, name);
        if self.alternates { b.push(Op::Alternate { x: value, magic: variables.magic }) } else { value }
    }
}

/// Names of the powers that the evaluation of a polynomial squares its variable to.
const PLAIN_POWERS: [&str; 7] = ["p", "p2", "p4", "p8", "p16", "p32", "p64"];
const CENTRED_POWERS: [&str; 7] = ["u", "u2", "u4", "u8", "u16", "u32", "u64"];

/// Σ cⱼxʲ by pairs, pairs of pairs and so on (Estrin 1960): the chain of dependent operations grows with the logarithm of
/// the number of terms.
pub(crate) fn estrin(b: &mut Builder, x: Id, coefficients: &[Id], names: &[&'static str]) -> Id {
    let mut sums = coefficients.to_vec();
    let mut power = x;
    let mut level = 0;
    while sums.len() > 1 {
        sums = sums
            .chunks(2)
            .map(|pair| match *pair {
                [low, high] => {
                    let high = b.mul(high, power);
                    b.add(low, high)
                }
                [low] => low,
                _ => unreachable!("chunks of two"),
            })
            .collect();
        if sums.len() > 1 {
            power = b.mul(power, power);
            level += 1;
            b.name(power, names[level]);
        }
    }
    sums[0]
}
