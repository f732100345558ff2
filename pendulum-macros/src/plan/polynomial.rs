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

use super::adapted::{Adapted, Choices};
use super::form::Form;
use crate::chebyshev::{CosineTable, scale, shift, to_powers};
use crate::parse::Float;
use crate::plan::curve::Curve;
use crate::plan::moebius::Moebius;
use crate::plan::reduction::Reduction;
use crate::plan::variables::Variables;
use crate::program::rounding::UNDERFLOW;
use crate::program::{Builder, Id};
use crate::series::Parity;
use pendulum_runtime::double::Double;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// A curve's Chebyshev coefficients on p ∈ [0, ¼], in 8p − 1; of curve/s if it is odd, times a power of the pole's
/// polynomial if that is divided out.
#[derive(Clone, Debug)]
pub(crate) struct Approximation {
    parity: Parity,
    pole: Option<Pole>,
    /// Applied to p, if any: the series is of its image.
    map: Option<Moebius>,
    series: Vec<Double>,
    /// Error of the whole series.
    remainder: f64,
    /// The shifts found, by terms and chunk.
    choices: RefCell<BTreeMap<(usize, usize), Option<Choices>>>,
}

/// ((8p − place)² + height²)^power, which vanishes at the nearest pair of singularities. θ̇ has simple poles there, θ̈ and
/// the position double ones, θ itself logarithms, which dividing doesn't remove.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pole {
    place: f64,
    height_squared: f64,
    power: i32,
}

impl Pole {
    /// Of a curve whose singularities are s = ½ ± i·strip. Numbers near the true ones serve as well: these are exact.
    pub(crate) fn new(strip: f64, power: i32) -> Self {
        let round = |x: f64| f64::from(x as f32);
        Self { place: round(2.0 - 8.0 * strip * strip), height_squared: round(64.0 * strip * strip), power }
    }

    /// At 8p − 1 = u.
    fn at(self, u: Double) -> Double {
        let distance = u + Double::new(1.0 - self.place);
        let single = distance * distance + Double::new(self.height_squared);
        (1..self.power).fold(single, |product, _| product * single)
    }

    /// The least value for 0 ≤ 8p ≤ 2.
    fn least(self) -> f64 {
        let distance = (-self.place).max(self.place - 2.0).max(0.0);
        (distance * distance + self.height_squared).powi(self.power) * (1.0 - 1e-3)
    }

    /// Bounds the magnitude for |s| ≤ `radius`.
    fn most(self, radius: f64) -> f64 {
        let distance = 8.0 * radius * radius + self.place.abs();
        (distance * distance + self.height_squared).powi(self.power)
    }

    /// Divides `value`; `centred` is 8p − centre.
    fn divide(self, b: &mut Builder, value: Id, centred: Id, centre: f64) -> Id {
        let place = b.constant(self.place - centre);
        let distance = b.sub(centred, place);
        let square = b.mul(distance, distance);
        let height = b.constant(self.height_squared);
        let mut divisor = b.add(square, height);
        let single = b.name(divisor, "d");
        for _ in 1..self.power {
            divisor = b.mul(divisor, single);
        }
        b.div(value, divisor)
    }
}

/// A polynomial, or a quotient, to be evaluated.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polynomial {
    pub(crate) form: Form,
    pub(crate) pole: Option<Pole>,
    pub(crate) parity: Parity,
    map: Option<Moebius>,
    pub(crate) alternates: bool,
    /// Powers of the form's variable, lowest first.
    pub(crate) coefficients: Vec<Double>,
    /// How it is evaluated if not by its powers.
    adapted: Option<Adapted>,
    /// sup |approximation − curve|.
    pub(crate) truncation: f64,
}

/// More points than this take too long.
const MOST_POINTS: usize = 240;

impl Approximation {
    /// Interpolates `curve` so well that the error left is below `negligible`; `None` if that takes too many points.
    pub(crate) fn new(curve: &Curve, power: i32, negligible: f64) -> Option<Self> {
        let pole = (power > 0).then(|| Pole::new(curve.strip(), power));
        let negligible = negligible * pole.map_or(1.0, Pole::least);
        let (points, error) = enough_points(curve, pole, negligible)?;
        Some(Self::with_points(curve, pole, negligible, points, error))
    }

    /// As [`Self::new`], for a curve without singularities.
    pub(crate) fn entire(curve: &Curve, negligible: f64) -> Self {
        let (points, error) = enough_points(curve, None, negligible).unwrap_or((MOST_POINTS, f64::INFINITY));
        Self::with_points(curve, None, negligible, points, error)
    }

    fn with_points(curve: &Curve, pole: Option<Pole>, negligible: f64, points: usize, error: f64) -> Self {
        let table = CosineTable::new(points);
        let sample = |u: Double| {
            let s = ((u + Double::ONE) * 0.125).sqrt();
            let value = pole.map_or(Double::ONE, |pole| pole.at(u)) * curve.at(s);
            if curve.parity() == Parity::Odd { value / s } else { value }
        };
        let values: Vec<Double> = table.points().map(sample).collect();
        let mut series = table.coefficients(&values, points);
        // Near an anchor an odd curve's omitted terms are divided by s, of which the smallest sample is above 1/(3·points).
        let omitted = curve.omitted() * if curve.parity() == Parity::Odd { 3.0 * points as f64 } else { 1.0 };
        let mut remainder = error + 2.0 * omitted * pole.map_or(1.0, |pole| pole.most(0.5));
        // What is far below the aim isn't worth carrying.
        while series.len() > 2 && series.last().is_some_and(|last| last.hi.abs() < negligible * 1e-3) {
            remainder += series.pop().map_or(0.0, |last| last.hi.abs());
        }
        Self { parity: curve.parity(), pole, map: None, series, remainder, choices: RefCell::default() }
    }

    /// An even function of which the series and its error are known.
    pub(crate) fn known(map: Option<Moebius>, series: Vec<Double>, remainder: f64) -> Self {
        Self { parity: Parity::Even, pole: None, map, series, remainder, choices: RefCell::default() }
    }

    /// The error of the polynomial with the first `terms` coefficients, on the interval widened by `overshoot` (in s).
    pub(crate) fn truncation(&self, terms: usize, overshoot: f64) -> f64 {
        let dropped: f64 = self.series.iter().skip(terms).map(|c| c.hi.abs()).sum();
        // 8p − 1 exceeds 1 by ε = 8·overshoot·(1 + overshoot); there |Tⱼ| ≤ cosh(j·arcosh(1 + ε)) ≤ cosh(j·√(2ε)).
        let stretch = (self.series.len() as f64 * (16.0 * overshoot * (1.0 + overshoot)).sqrt()).cosh();
        let weight = if self.parity == Parity::Odd { 0.5 + overshoot } else { 1.0 };
        (dropped + self.remainder) * stretch * weight / self.pole.map_or(1.0, Pole::least) * (1.0 + 1e-12)
    }

    /// The fewest terms, at least two, whose truncation error is at most `limit`.
    pub(crate) fn terms_for(&self, limit: f64, overshoot: f64) -> Option<usize> {
        (2..=self.series.len()).find(|&terms| self.truncation(terms, overshoot) <= limit)
    }

    pub(crate) fn terms(&self) -> usize {
        self.series.len()
    }

    /// Anchors per unit of the phase that the polynomial's variable is made of.
    fn unit(&self, reduction: &Reduction) -> Double {
        if self.map.is_some() { Double::ONE } else { reduction.unit }
    }

    /// The polynomial with that many terms, in the variable of `form` (p + `shift` if adapted) scaled to the reduction's
    /// unit.
    fn shifted_powers(
        &self,
        terms: usize,
        form: Form,
        shifted: f64,
        reduction: &Reduction,
        alternates: bool,
    ) -> Polynomial {
        let powers = self.powers(terms);
        let unit = self.unit(reduction);
        let mut coefficients = match form {
            Form::Centred { centre } => shift(&powers, Double::new(centre - 1.0)),
            Form::Plain | Form::Adapted { .. } => {
                let eighth = unit * unit * 8.0;
                scale(shift(&powers, -Double::ONE - eighth * shifted), eighth)
            }
        };
        if self.parity == Parity::Odd {
            for coefficient in &mut coefficients {
                *coefficient = *coefficient * unit;
            }
        }
        let lost = self.lost_to_underflow(terms, form, unit);
        let truncation = self.truncation(terms, reduction.overshoot) + lost;
        let (pole, parity, map) = (self.pole, self.parity, self.map);
        Polynomial { form, pole, parity, map, alternates, coefficients, adapted: None, truncation }
    }

    /// What coefficients that are too small for two words change: infinite where the powers of the unit are. Powers of a phase
    /// in units of time are of any size, and an amplitude may be 1e-300.
    fn lost_to_underflow(&self, terms: usize, form: Form, unit: Double) -> f64 {
        let eighth = if let Form::Centred { .. } = form { 1.0 } else { (unit * unit * 8.0).hi };
        let (highest, widest) = (eighth.powi(terms as i32), 1e280);
        if !(1.0 / widest..widest).contains(&highest) {
            return f64::INFINITY;
        }
        // Of 8p ≤ 2.
        let weight = self.weight() * if self.parity == Parity::Odd { 1.0 / unit.hi } else { 1.0 };
        weight * UNDERFLOW * (0..terms).map(|power| (2.5 / eighth).powi(power as i32)).sum::<f64>()
    }

    /// As [`Self::polynomial`], evaluated by its powers.
    pub(crate) fn in_powers(&self, terms: usize, form: Form, reduction: &Reduction, alternates: bool) -> Polynomial {
        self.shifted_powers(terms, form, 0.0, reduction, alternates)
    }

    /// In powers of 8p − 1.
    fn powers(&self, terms: usize) -> Vec<Double> {
        to_powers(&self.series[..terms.min(self.series.len())])
    }

    /// The polynomial with that many terms, evaluated as `form` says; `None` if its coefficients can't be adapted without
    /// rounding by more than about `limit`.
    pub(crate) fn polynomial(
        &self,
        terms: usize,
        form: Form,
        reduction: &Reduction,
        alternates: bool,
        limit: f64,
    ) -> Option<Polynomial> {
        let Form::Adapted { chunk } = form else {
            return Some(self.in_powers(terms, form, reduction, alternates));
        };
        let choice = self.choices(terms, chunk)?.within(limit / (reduction.float.unit() * self.weight()))?;
        let unit = self.unit(reduction);
        let quarter = (Double::new(0.25) / (unit * unit)).hi;
        let shift = reduction.float.round(choice.shift * 4.0 * quarter);
        let mut polynomial = self.shifted_powers(terms, form, shift, reduction, alternates);
        let reach = shift.abs().max((shift + quarter).abs()) * 1.01;
        if !polynomial.is_moderate(quarter, reduction.float) {
            return None;
        }
        let adapted = Adapted::new(&polynomial.coefficients, shift, chunk, reach)?;
        let unit = if self.parity == Parity::Odd { reduction.unit.hi } else { 1.0 };
        polynomial.truncation += adapted.mismatch * self.weight() / unit;
        polynomial.adapted = Some(adapted);
        Some(polynomial)
    }

    /// The shifts, looked for once.
    fn choices(&self, terms: usize, chunk: usize) -> Option<Choices> {
        let look = || Choices::new(&scale(shift(&self.powers(terms), -Double::ONE), Double::new(8.0)), chunk);
        *self.choices.borrow_mut().entry((terms, chunk)).or_insert_with(look)
    }

    /// What an error of the polynomial is multiplied with in the value, at most.
    fn weight(&self) -> f64 {
        let odd = if self.parity == Parity::Odd { 0.5 } else { 1.0 };
        odd / self.pole.map_or(1.0, Pole::least)
    }
}

/// The number of points that makes the interpolation error negligible, and that error.
fn enough_points(curve: &Curve, pole: Option<Pole>, negligible: f64) -> Option<(usize, f64)> {
    let strip = curve.strip();
    let heights = [0.5, 0.6, 0.7, 0.8, 0.88, 0.94].map(|part| (part * strip).min(1.5));
    let choice = |height: f64| {
        let log_rho = 2.0 * (2.0 * height).asinh();
        // s = ½ cos φ with |Im φ| = ½ ln ρ.
        let radius = 0.5 * (0.5 * log_rho).cosh();
        let mut bound = curve.bound(height) * pole.map_or(1.0, |pole| pole.most(radius));
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

/// Names of the powers that the evaluation of a polynomial squares its variable to.
const PLAIN_POWERS: [&str; 8] = ["p", "p2", "p4", "p8", "p16", "p32", "p64", "p128"];
const CENTRED_POWERS: [&str; 8] = ["u", "u2", "u4", "u8", "u16", "u32", "u64", "u128"];

impl Polynomial {
    /// Whether no power of the variable, and no second word of a coefficient, comes near overflow or underflow: amplitudes of
    /// 1e-268 and periods of 1e150 have plans, but not by adapted coefficients.
    fn is_moderate(&self, quarter: f64, float: Float) -> bool {
        let widest = if float == Float::F64 { 1e12 } else { 1e3 };
        let largest = self
            .coefficients
            .iter()
            .fold((0.0, 1.0), |(most, power): (f64, f64), c| (most.max((c.hi * power).abs()), power * quarter));
        (1.0 / widest..widest).contains(&quarter) && (1e-150..1e150).contains(&largest.0)
    }

    /// Evaluates it, with its sign.
    pub(crate) fn lower(&self, b: &mut Builder, variables: &Variables, name: &'static str) -> Id {
        let value = self.magnitude(b, variables);
        b.name(value, name);
        match (self.alternates, self.parity) {
            (true, parity) => variables.sign(b, value, parity),
            (false, Parity::Odd) => variables.sign_of_odd(b, value),
            (false, Parity::Even) => value,
        }
    }

    /// Evaluates it, but for the sign that the anchor and the side of the lowest point give.
    pub(crate) fn magnitude(&self, b: &mut Builder, variables: &Variables) -> Id {
        let variables = &self.map.map_or(*variables, |map| variables.mapped(b, map));
        let mut value = match &self.adapted {
            Some(adapted) => {
                let y = variables.shifted(b, adapted.shift);
                adapted.lower(b, y)
            }
            None => self.by_powers(b, variables),
        };
        if let Some(pole) = self.pole {
            let centre = self.form.centre();
            let centred = variables.centred(b, centre);
            value = pole.divide(b, value, centred, centre);
        }
        if self.parity == Parity::Odd {
            value = b.mul(variables.distance, value);
        }
        value
    }

    fn by_powers(&self, b: &mut Builder, variables: &Variables) -> Id {
        let (x, powers) = match self.form {
            Form::Centred { centre } => (variables.centred(b, centre), &CENTRED_POWERS),
            Form::Plain | Form::Adapted { .. } => (variables.shifted(b, 0.0), &PLAIN_POWERS),
        };
        let coefficients: Vec<Id> = self.coefficients.iter().map(|c| b.exact(c.hi, c.lo)).collect();
        estrin(b, x, &coefficients, powers)
    }

    /// Whether, of the two factors of sin θ, this is the one that changes its sign in a mirror.
    pub(crate) fn mirrors(&self, from_top: bool) -> bool {
        if from_top { self.parity == Parity::Odd } else { self.alternates }
    }

    pub(crate) fn negate(&mut self) {
        self.coefficients.iter_mut().for_each(|c| *c = -*c);
        if let Some(adapted) = &mut self.adapted {
            adapted.negate();
        }
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        let terms = self.coefficients.len();
        let over = self.pole.map_or(String::new(), |pole| format!(" over one of {}", 2 * pole.power + 1));
        let (variable, how) = match &self.adapted {
            Some(adapted) => (adapted.variable(), adapted.describe()),
            None => (self.form.variable(), String::new()),
        };
        let image = self.map.map_or(String::new(), |map| format!(", s² replaced by {}", map.describe()));
        format!("polynomial of {terms} terms in {variable}{over}{image}{how}")
    }
}

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
            // Higher powers than have names occur in kernels that no promise needs; the search tries and drops them.
            if let Some(name) = names.get(level) {
                b.name(power, name);
            }
        }
    }
    sums[0]
}

#[cfg(test)]
mod tests;
