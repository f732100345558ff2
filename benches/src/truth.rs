//! The exact motion, in 256-bit arithmetic.
//!
//! Released at rest from θ0 with ω = 1, and with k = sin(θ0/2), K = π/(2·AGM(1, k′)), q = exp(−πK′/K), x = πt/(2K):
//!
//! θ = 8 Σ (−1)ⁿ⁻¹ qⁿ⁻¹ᐟ²/((2n−1)(1 + q²ⁿ⁻¹)) cos((2n−1)x).
//!
//! The test compares with values of `mpmath`'s elliptic functions, which come from other formulas.

use astro_float::{BigFloat, Consts, RoundingMode, Sign};

use crate::amplitude::Amplitude;

/// Working precision in bits. At 10¹² periods 40 go to the phase and a few more to cancellation.
const BITS: usize = 256;
/// Terms smaller than this, relative to the first, are left out.
const NEGLIGIBLE: f64 = 1e-45;
const ROUND: RoundingMode = RoundingMode::None;

/// A number of twice the precision of an `f64`, as an unevaluated sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exact {
    /// The value rounded.
    pub high: f64,
    /// What rounding left over.
    pub low: f64,
}

impl Exact {
    /// |`approximation` − truth|; NaN if the approximation is.
    pub fn distance(self, approximation: f64) -> f64 {
        // The first difference is exact wherever the approximation is any good (Sterbenz 1974).
        ((approximation - self.high) - self.low).abs()
    }
}

/// The release angle that a contestant was given, and is compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// The exact fraction of π.
    Exact,
    /// Its `f64`.
    F64,
    /// Its `f32`.
    F32,
}

/// The motion for one release angle.
pub struct Truth {
    /// 2π
    turn: BigFloat,
    /// T = 4K
    period: BigFloat,
    /// The coefficients of cos((2n−1)x), from n = 1.
    coefficients: Vec<BigFloat>,
    constants: Consts,
}

fn big(value: f64) -> BigFloat {
    BigFloat::from_f64(value, BITS)
}

fn mul(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.mul(b, BITS, ROUND)
}

fn div(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.div(b, BITS, ROUND)
}

fn add(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.add(b, BITS, ROUND)
}

fn sub(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.sub(b, BITS, ROUND)
}

/// The value to within an ulp of `f64` (0 where it underflows).
fn narrow(value: &BigFloat) -> f64 {
    let Some((words, _, sign, exponent, _)) = value.as_raw_parts() else { return f64::NAN };
    // The value is 0.words · 2^exponent, with the most significant word last and its highest bit set.
    let top = words.last().copied().unwrap_or(0) as f64;
    let magnitude = top * 2.0_f64.powi(exponent - 64);
    if sign == Sign::Neg { -magnitude } else { magnitude }
}

fn exact(value: &BigFloat) -> Exact {
    let high = narrow(value);
    Exact { high, low: narrow(&sub(value, &big(high))) }
}

/// The limit of the arithmetic and the geometric mean (Gauss); each step doubles the number of digits.
fn agm(mut a: BigFloat, mut b: BigFloat) -> BigFloat {
    let half = big(0.5);
    while narrow(&sub(&a, &b)).abs() > 1e-40 * narrow(&a) {
        let mean = mul(&add(&a, &b), &half);
        b = mul(&a, &b).sqrt(BITS, ROUND);
        a = mean;
    }
    // One more mean squares what is left.
    mul(&add(&a, &b), &half)
}

impl Truth {
    /// The motion released from `amplitude` as it was given.
    ///
    /// # Panics
    /// If the tables of constants cannot be allocated.
    pub fn new(amplitude: Amplitude, given: Given) -> Self {
        let mut constants = Consts::new().expect("memory for the constants");
        let pi = constants.pi(BITS, ROUND);
        let theta0 = match given {
            Given::Exact => div(&mul(&pi, &big(amplitude.numerator.into())), &big(amplitude.denominator.into())),
            Given::F64 => big(amplitude.theta0()),
            Given::F32 => big(f64::from(amplitude.theta0() as f32)),
        };
        let half = mul(&theta0, &big(0.5));
        let modulus = half.sin(BITS, ROUND, &mut constants);
        let complement = half.cos(BITS, ROUND, &mut constants);
        let (one, two) = (big(1.0), big(2.0));
        let quarter_period = div(&pi, &mul(&two, &agm(one.clone(), complement.clone())));
        // K'/K is AGM(1, k')/AGM(1, k).
        let ratio = div(&agm(one.clone(), complement), &agm(one.clone(), modulus));
        let root = mul(&mul(&pi, &ratio), &big(-0.5)).exp(BITS, ROUND, &mut constants);
        Self {
            turn: mul(&pi, &two),
            period: mul(&quarter_period, &big(4.0)),
            coefficients: coefficients(&root),
            constants,
        }
    }

    /// T, with ω = 1.
    pub fn period(&self) -> f64 {
        narrow(&self.period)
    }

    /// θ at time `t`.
    pub fn theta(&mut self, t: f64) -> Exact {
        let phase = self.phase(t);
        let cosine = phase.cos(BITS, ROUND, &mut self.constants);
        let (first, second) = self.clenshaw(&cosine);
        exact(&mul(&cosine, &sub(&first, &second)))
    }

    /// θ̇ at time `t`: the derivative of the series, term by term.
    pub fn velocity(&mut self, t: f64) -> Exact {
        let phase = self.phase(t);
        let (sine, cosine) = (phase.sin(BITS, ROUND, &mut self.constants), phase.cos(BITS, ROUND, &mut self.constants));
        let weighted = |(n, c): (usize, &BigFloat)| mul(c, &big((2 * n + 1) as f64));
        let slopes: Vec<_> = self.coefficients.iter().enumerate().map(weighted).collect();
        let (first, second) = clenshaw(&slopes, &cosine);
        exact(&mul(&mul(&sine, &add(&first, &second)), &div(&self.turn, &self.period)).neg())
    }

    /// x = 2πt/T without whole turns.
    fn phase(&self, t: f64) -> BigFloat {
        let turns = div(&big(t), &self.period);
        let whole = add(&turns, &big(0.5)).floor();
        mul(&sub(&turns, &whole), &self.turn)
    }

    fn clenshaw(&self, cosine: &BigFloat) -> (BigFloat, BigFloat) {
        clenshaw(&self.coefficients, cosine)
    }
}

/// The coefficients of the cosines, from h = q^½, until they are negligible.
fn coefficients(root: &BigFloat) -> Vec<BigFloat> {
    let nome = mul(root, root);
    let mut power = root.clone();
    let mut list: Vec<BigFloat> = Vec::new();
    loop {
        let n = list.len();
        let sign = if n.is_multiple_of(2) { 8.0 } else { -8.0 };
        let odd = big((2 * n + 1) as f64);
        // power = q^{n+½}, so q^{2n+1} is its square.
        let below = mul(&odd, &add(&big(1.0), &mul(&power, &power)));
        let term = div(&mul(&power, &big(sign)), &below);
        let done = n > 0 && narrow(&term).abs() < NEGLIGIBLE * narrow(&list[0]).abs();
        list.push(term);
        if done {
            return list;
        }
        power = mul(&power, &nome);
    }
}

/// b₁ and b₂ of Clenshaw's recurrence with 2cos 2x: Σ cₙ cos((2n−1)x) = (b₁ − b₂) cos x, and
/// Σ cₙ sin((2n−1)x) = (b₁ + b₂) sin x.
fn clenshaw(coefficients: &[BigFloat], cosine: &BigFloat) -> (BigFloat, BigFloat) {
    let double = sub(&mul(&mul(cosine, cosine), &big(4.0)), &big(2.0));
    let (mut first, mut second) = (big(0.0), big(0.0));
    for coefficient in coefficients.iter().rev() {
        let next = sub(&add(coefficient, &mul(&double, &first)), &second);
        second = std::mem::replace(&mut first, next);
    }
    (first, second)
}

#[cfg(test)]
mod tests {
    use super::{Given, Truth};
    use crate::amplitude::Amplitude;

    /// 1e-29 of the amplitude: the two words hold 106 bits, 1.2e-32, and at 10¹² periods the phase, of which the file
    /// has the `f64` time exactly, costs `mpmath` and this none. What is promised elsewhere is 1e-17.
    const TOLERANCE: f64 = 1e-29;

    #[test]
    fn agrees_with_mpmath() {
        let rows = include_str!("../data/truth.csv").lines().filter(|line| !line.starts_with('#')).skip(1);
        let mut count = 0;
        for row in rows {
            let fields: Vec<_> = row.split(',').collect();
            let amplitude = Amplitude::ALL.into_iter().find(|one| one.slug == fields[0]).expect("a known amplitude");
            let given = if fields[1] == "exact" { Given::Exact } else { Given::F64 };
            let number = |index: usize| fields[index].parse::<f64>().expect("a number");
            let mut truth = Truth::new(amplitude, given);
            for (value, index) in [(truth.theta(number(2)), 3), (truth.velocity(number(2)), 5)] {
                let (high, low) = (number(index), number(index + 1));
                let error = ((value.high - high) + (value.low - low)).abs();
                assert!(error < TOLERANCE * amplitude.theta0(), "{row}: {value:?}, off by {error:e}");
            }
            count += 1;
        }
        assert!(count >= 60, "only {count} rows");
    }
}
