//! The kernel of motions that come near the top: swings, rotations and the separatrix between them.
//!
//! There most of a period is spent near the top, and the rest is the same passage through the lowest point for all of
//! them, θ = 2 gd w with w = (π/K′)·(u − u of the lowest point). With E = e^(−|w|), G = q′/E, the image of the next
//! passage, and σ = 1 for a swing, −1 for a rotation, 0 on the separatrix (q′ = 0),
//!
//! π − |θ| = 4 arctan A, A = Q/P, Q = (E + σG)(1 + σq′³M − q′⁴), P = 1 + σq′M, M = E² + G²,
//!
//! which is the dual theta quotient (tan(θ/4) = [sinh X − q′ sinh 3X + …]/[cosh X + q′ cosh 3X + …], X = w/2, for a swing)
//! solved for tan((π − θ)/4); the terms left out are below q′⁶ relative to Q and P. From it, with sin(θ/2) = (P² − Q²)/N
//! and cos(θ/2) = 2QP/N, N = P² + Q², follow position and acceleration. The velocity's numerator is a theta function too:
//!
//! |θ̇| = F·Σ (−σ)ᵐ q′^(m²) E^(2m+1)/N = F·(E − σG)(1 − q′² − q′⁶ − σq′(1 − q′⁴)M + q′⁴M²)/N up to q′⁹,
//!
//! since E³ − σG³ = (E − σG)(M + σq′) and E⁵ − σG⁵ = (E − σG)(M² + σq′M − q′²), EG being q′;
//!
//! F being such that the velocity at the lowest point, E = 1, is the exact one.
//!
//! E = 2^(−j)·2^(−f) with j the integer nearest to |w|/ln 2: 2^(±f) = 1 + (f²·C(f²) ± f·S(f²)), by polynomials, serve E
//! and G.

use super::fit::{Domain, Fit};
use super::kernel::{largest, norm};
use super::variables::Variables;
use crate::parse::{Float, Output};
use crate::program::rounding::Known;
use crate::program::{Builder, Id, Op, Program};
use pendulum_runtime::double::Double;
use std::f64::consts::LN_2;

/// What is the same for all outputs of one motion.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Passage {
    /// log₂ e·|w| per unit of the phase.
    pub(crate) rate: Double,
    /// σ.
    pub(crate) sigma: f64,
    /// q′ = mantissa·2^exponent; 0 on the separatrix.
    pub(crate) image: Double,
    pub(crate) image_exponent: i32,
    /// The largest |phase|.
    pub(crate) half: f64,
    /// Set where the direction changes from passage to passage: a swing.
    pub(crate) alternates: bool,
    /// −1 for the mirror image.
    pub(crate) direction: f64,
}

/// The kernel of one output.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Hyperbolic {
    output: Output,
    passage: Passage,
    images: Images,
    /// Whether Q/P is formed with as little rounding as can be, at the price of a division.
    careful: bool,
    even: Fit,
    odd: Fit,
    /// arctan √v/√v on [0, 1], for θ.
    arctangent: Option<Fit>,
    /// What the output is a multiple of: 1, the largest velocity, ω².
    factor: Double,
    /// What leaving out terms changes.
    pub(crate) truncation: f64,
}

/// What of the passages before and after matters: each more than those before it.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
enum Images {
    Nothing,
    /// G.
    Sum,
    /// P.
    Denominator,
    /// σq′³M − q′⁴.
    Correction,
}

/// E below 2 to minus this is nothing beside the roundings of 1.
const NEGLIGIBLE_BINADE: i32 = 24;

/// The phase beyond which E is nothing beside 1 whatever is asked.
const FURTHEST: f64 = 900.0;

impl Passage {
    fn q(&self) -> f64 {
        self.image.hi * 2f64.powi(self.image_exponent)
    }
}

impl Hyperbolic {
    /// With all approximations within `limit`, in units of `factor`.
    pub(crate) fn new(output: Output, passage: Passage, factor: Double, limit: f64) -> Self {
        let q = passage.q();
        let half_ln = 0.5 * LN_2;
        // |f² ln²2| < 1 on the ellipse that reaches as far left as 4·¼.
        let domain = Domain::reaching(0.25, -2.0, half_ln.cosh() * 2.0);
        let fraction = limit / 128.0;
        let even = Fit::new(&domain, fraction, |v| series(v, 2));
        let odd = Fit::new(&domain, fraction, |v| series(v, 1));
        // On the ellipse that reaches −0.9, |1 + vt²| ≥ 1/20 for 0 ≤ t ≤ 1, of whose inverse the arctangent is a mean.
        let angle = matches!(output, Output::Theta | Output::Wrapped);
        let arctangent =
            angle.then(|| Fit::new(&Domain::reaching(1.000_1, -0.9, 20.0), limit / 16.0, arctangent_ratio));
        // An angle, sin θ and e^{iθ} change by at most 4 times as much as Q or P, the velocity by 2F times.
        let weight = if output == Output::Velocity { 2.5 } else { 4.5 };
        let levels = [(Images::Sum, q.sqrt()), (Images::Denominator, 2.0 * q), (Images::Correction, 2.0 * q.powi(3))];
        let matters = |&&(_, term): &&(Images, f64)| weight * term > limit / 8.0;
        let images = levels.iter().rev().find(matters).map_or(Images::Nothing, |level| level.0);
        let left_out = levels.iter().filter(|level| level.0 > images).map(|level| level.1);
        let truncation = left_out.chain([2.0 * q.powi(6)]).map(|term| weight * term).sum();
        // A truncation of a few units of rounding is asked for where full precision is.
        let careful = images >= Images::Denominator && output != Output::Velocity && limit < 8.0 * Float::F64.unit();
        Self { output, passage, images, careful, even, odd, arctangent, factor, truncation }
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        let angle =
            self.arctangent.as_ref().map_or(String::new(), |fit| format!(", an arctangent of {} terms", fit.terms()));
        format!("2 gd w by an exponential of {} terms{angle}", self.terms())
    }

    pub(crate) fn terms(&self) -> usize {
        self.even.terms() + self.odd.terms()
    }

    /// Emits the kernel.
    pub(crate) fn lower(&self, b: &mut Builder, variables: &Variables, name: &'static str) -> Vec<Id> {
        let float = b.float();
        let magnitude = b.convert(variables.magnitude, Float::F64);
        let quotient = self.quotient(b, magnitude);
        // Before the lowest point a swing is on the positive side, of a passage downwards; a rotation still on the negative.
        let direction = self.passage.direction * if self.passage.alternates { 1.0 } else { -1.0 };
        match self.output {
            Output::Theta | Output::Wrapped => {
                let value = self.angle(b, &quotient, direction);
                let value = b.convert(value, float);
                b.name(value, name);
                vec![self.sign(b, variables, value)]
            }
            Output::Velocity => {
                let value = self.velocity(b, &quotient);
                let value = b.convert(value, float);
                b.name(value, name);
                vec![if self.passage.alternates {
                    b.push(Op::Alternate { x: value, magic: variables.magic })
                } else {
                    value
                }]
            }
            Output::Acceleration => {
                let value = self.acceleration(b, &quotient, direction);
                let value = b.convert(value, float);
                b.name(value, name);
                vec![self.sign(b, variables, value)]
            }
            Output::Position => {
                let [x, y] = Self::position(b, &quotient, direction);
                let [x, y] = [x, y].map(|value| b.convert(value, float));
                vec![self.sign(b, variables, x), y]
            }
        }
    }

    /// The sign of the angle: that of the phase from the lowest point, and of the passage.
    fn sign(&self, b: &mut Builder, variables: &Variables, value: Id) -> Id {
        let value = variables.side.map_or(value, |side| b.push(Op::Against { x: value, sign: side }));
        if self.passage.alternates { b.push(Op::Alternate { x: value, magic: variables.magic }) } else { value }
    }

    /// The parts of the outputs.
    fn quotient(&self, b: &mut Builder, magnitude: Id) -> Quotient {
        let rate = b.exact(self.passage.rate.hi, self.passage.rate.lo);
        let w = b.mul(magnitude, rate);
        let furthest = b.constant(FURTHEST);
        let w = b.push(Op::Min { limit: furthest, x: w });
        b.name(w, "w");
        let constant = b.constant(Float::F64.magic());
        // −j, so that its bits are the exponent.
        let integer = b.sub(constant, w);
        b.name(integer, "exponent");
        let j = b.sub(constant, integer);
        let f = b.sub(w, j);
        b.name(f, "f");
        let square = b.mul(f, f);
        b.name(square, "v");
        // cosh − 1, small beside the 1 that is added last.
        let even = self.even.lower(b, square, &["v", "v2", "v4", "v8"]);
        let even = b.mul(square, even);
        b.name(even, "even");
        let one = b.constant(1.0);
        let odd = self.odd.lower(b, square, &["v", "v2", "v4", "v8"]);
        let odd = b.mul(f, odd);
        b.name(odd, "odd");
        let power = b.push(Op::PowerOfTwo { magic: integer });
        b.name(power, "power");
        let falling = b.sub(even, odd);
        let falling = b.add(one, falling);
        let direct = b.mul(power, falling);
        b.name(direct, "direct");
        if self.images == Images::Nothing {
            return Quotient { numerator: direct, counterpart: direct, squares: None, denominator: None };
        }
        // 2^(j + image_exponent), below which there is nothing to add.
        let shift = b.constant(f64::from(self.passage.image_exponent));
        let exponent = b.add(j, shift);
        let least = b.constant(-1022.0);
        let exponent = b.push(Op::Max { limit: least, x: exponent });
        let exponent = b.add(exponent, constant);
        b.name(exponent, "image_exponent");
        let power = b.push(Op::PowerOfTwo { magic: exponent });
        b.name(power, "image_power");
        let mantissa = b.exact(self.passage.image.hi, self.passage.image.lo);
        let rising = b.add(even, odd);
        let rising = b.add(one, rising);
        let scaled = b.mul(mantissa, rising);
        let image = b.mul(power, scaled);
        b.name(image, "image");
        let (sum, difference) = (b.add(direct, image), b.sub(direct, image));
        let (numerator, counterpart) = if self.passage.sigma > 0.0 { (sum, difference) } else { (difference, sum) };
        if self.images == Images::Sum {
            return Quotient { numerator, counterpart, squares: None, denominator: None };
        }
        let squares = [b.mul(direct, direct), b.mul(image, image)];
        let squares = b.add(squares[0], squares[1]);
        b.name(squares, "squares");
        let (sigma, q) = (self.passage.sigma, self.passage.q());
        let denominator = linear(b, 1.0, sigma * q, squares);
        b.name(denominator, "denominator");
        if self.careful {
            let small = self.excess(b, squares, denominator);
            let small = b.mul(numerator, small);
            let small = if sigma > 0.0 { b.add(small, image) } else { b.sub(small, image) };
            let numerator = b.add(direct, small);
            return Quotient { numerator, counterpart, squares: Some(squares), denominator: None };
        }
        let numerator = if self.images == Images::Correction {
            let correction = linear(b, 1.0 - q.powi(4), sigma * q.powi(3), squares);
            b.mul(numerator, correction)
        } else {
            numerator
        };
        Quotient { numerator, counterpart, squares: Some(squares), denominator: Some(denominator) }
    }

    /// κ in (1 + σq′³M − q′⁴)/P = 1 + κ. With Q/P = E + (σG + κ(E + σG)) only the last sum is rounded with a unit of E.
    fn excess(&self, b: &mut Builder, squares: Id, denominator: Id) -> Id {
        let (sigma, q) = (self.passage.sigma, self.passage.q());
        let top = if self.images == Images::Correction {
            linear(b, -q.powi(4), -sigma * q * (1.0 - q * q), squares)
        } else {
            let slope = near(b, -sigma * q);
            b.mul(slope, squares)
        };
        b.div(top, denominator)
    }

    /// sign·(π − 4 arctan(Q/P)).
    fn angle(&self, b: &mut Builder, quotient: &Quotient, sign: f64) -> Id {
        let numerator = quotient.numerator;
        let tangent = quotient.denominator.map_or(numerator, |denominator| b.div(numerator, denominator));
        b.name(tangent, "tangent");
        let square = b.mul(tangent, tangent);
        let ratio = match &self.arctangent {
            Some(fit) => fit.lower(b, square, &["r", "r2", "r4", "r8", "r16", "r32"]),
            None => square,
        };
        let angle = b.mul(tangent, ratio);
        let factor = b.constant(4.0 * sign);
        let angle = b.mul(angle, factor);
        let pi = b.exact(sign * Double::PI.hi, sign * Double::PI.lo);
        b.sub(pi, angle)
    }

    /// F·(E − σG)(1 − q′² − q′⁶ − σq′(1 − q′⁴)M + q′⁴M²)/N.
    fn velocity(&self, b: &mut Builder, quotient: &Quotient) -> Id {
        let (sigma, q) = (self.passage.sigma, self.passage.q());
        let mut top = quotient.counterpart;
        if let Some(squares) = quotient.squares {
            let correction = if self.images == Images::Correction { q.powi(4) } else { 0.0 };
            let constant = 1.0 - q * q * (1.0 + correction);
            let mut series = linear(b, constant, -sigma * q * (1.0 - correction), squares);
            if self.images == Images::Correction {
                let square = b.mul(squares, squares);
                let last = near(b, q.powi(4));
                let last = b.mul(square, last);
                series = b.add(series, last);
            }
            top = b.mul(top, series);
        }
        let bottom = quotient.parts(b).norm;
        let sign = self.passage.direction * if self.passage.alternates { -1.0 } else { 1.0 };
        let factor = self.factor * self.lowest() * sign;
        let factor = b.exact(factor.hi, factor.lo);
        let ratio = b.div(top, bottom);
        b.mul(factor, ratio)
    }

    /// N over the velocity's numerator at the lowest point, with the terms that are kept.
    fn lowest(&self) -> Double {
        if self.images == Images::Nothing {
            return Double::new(2.0);
        }
        let (sigma, q) =
            (Double::new(self.passage.sigma), self.passage.image.scale(2f64.powi(self.passage.image_exponent)));
        let m = Double::ONE + q * q;
        let part = |keep: bool, value: Double| if keep { value } else { Double::ZERO };
        let p = Double::ONE + part(self.images >= Images::Denominator, sigma * q * m);
        let numerator = (Double::ONE + sigma * q)
            * (Double::ONE + part(self.images == Images::Correction, sigma * q * q * q * m - q * q * q * q));
        let series = Double::ONE
            + part(self.images >= Images::Denominator, -(q * q) - sigma * q * m)
            + part(self.images == Images::Correction, q * q * q * q * (m * m + sigma * q * m - q * q));
        (p * p + numerator * numerator) / ((Double::ONE - sigma * q) * series)
    }

    /// −sign·ω² sin |θ| = −4ω²·QP(P² − Q²)/N².
    fn acceleration(&self, b: &mut Builder, quotient: &Quotient, sign: f64) -> Id {
        let Parts { norm, difference, product } = quotient.parts(b);
        let factor = self.factor * (-4.0 * sign);
        let factor = b.exact(factor.hi, factor.lo);
        let top = b.mul(product, difference);
        let bottom = b.mul(norm, norm);
        let ratio = b.div(top, bottom);
        b.mul(ratio, factor)
    }

    /// (sign·sin |θ|, −cos θ) from cos(θ/2) = 2QP/N and sin(θ/2) = (P² − Q²)/N.
    fn position(b: &mut Builder, quotient: &Quotient, sign: f64) -> [Id; 2] {
        let Parts { norm, difference, product } = quotient.parts(b);
        let one = b.constant(1.0);
        let inverse = b.div(one, norm);
        b.name(inverse, "inverse");
        let sine = b.mul(difference, inverse);
        b.name(sine, "half_sine");
        let double = b.add(product, product);
        let cosine = b.mul(double, inverse);
        b.name(cosine, "half_cosine");
        let factor = b.constant(2.0 * sign);
        let x = b.mul(sine, cosine);
        let x = b.mul(x, factor);
        let squares = [b.mul(sine, sine), b.mul(cosine, cosine)];
        [x, b.sub(squares[0], squares[1])]
    }

    /// The rounding of the results, the phase taken as exact: w binade by binade, until it exceeds `cap`.
    pub(crate) fn rounding(&self, program: &Program, cap: f64) -> f64 {
        let binades = (self.passage.rate.hi * self.passage.half).ceil() as i32;
        let most = binades.min(NEGLIGIBLE_BINADE);
        let slices = |j: i32| {
            let count = match j {
                0 => 64,
                1..4 => 16,
                _ => 2,
            };
            // w ≥ 0: the first binade has no left half.
            let first = if j == 0 { count / 2 } else { 0 };
            (first..count).map(move |slice| {
                let at = |index: i32| f64::from(index) / f64::from(count) - 0.5;
                (j, at(slice), at(slice + 1))
            })
        };
        let bound = |(j, low, high): (i32, f64, f64)| {
            let power = |exponent: i32| 2f64.powi(exponent.max(-1022));
            let image = |j: i32| power(j + self.passage.image_exponent);
            // The last one stands for all that follow.
            let (powers, images) = if j == most && most < binades {
                ((0.0, power(-j)), (0.0, image(binades)))
            } else {
                ((power(-j), power(-j)), (image(j), image(j)))
            };
            let known = [("f", (low, high)), ("power", powers), ("image_power", images)];
            let given: Vec<(Id, Known)> = known
                .into_iter()
                .filter_map(|(name, (low, high))| Some((program.named(name)?, Known::between(low, high))))
                .collect();
            norm(program.rounding(&given).iter().map(|known| known.error))
        };
        largest((0..=most).flat_map(slices).map(bound), cap)
    }

    /// What the rounding of w adds, relative to w: the rate's, and the product's.
    pub(crate) fn relative_error() -> f64 {
        2.001 * Float::F64.unit()
    }
}

/// What the outputs are made of.
struct Quotient {
    /// Q, or Q/P.
    numerator: Id,
    /// E − σG.
    counterpart: Id,
    /// M, and P where it matters and Q isn't divided by it yet.
    squares: Option<Id>,
    denominator: Option<Id>,
}

/// N = P² + Q², P² − Q² and QP.
struct Parts {
    norm: Id,
    difference: Id,
    product: Id,
}

impl Quotient {
    fn parts(&self, b: &mut Builder) -> Parts {
        let one = b.constant(1.0);
        let square = b.mul(self.numerator, self.numerator);
        let base = self.denominator.map_or(one, |denominator| b.mul(denominator, denominator));
        let (norm, difference) = (b.add(base, square), b.sub(base, square));
        b.name(norm, "norm");
        let product = self.denominator.map_or(self.numerator, |denominator| b.mul(self.numerator, denominator));
        Parts { norm, difference, product }
    }
}

/// constant + slope·x.
fn linear(b: &mut Builder, constant: f64, slope: f64, x: Id) -> Id {
    let constant = if constant == 1.0 { b.constant(constant) } else { near(b, constant) };
    let slope = near(b, slope);
    let product = b.mul(slope, x);
    b.add(constant, product)
}

/// A number that was computed from the nome by a few operations.
fn near(b: &mut Builder, value: f64) -> Id {
    b.loose(value, 8.0 * Float::F64.unit() * value.abs())
}

/// Σ (ln 2)^(2i + k) vⁱ/(2i + k)!, v = f²: sinh(f ln 2)/f for k = 1, (cosh(f ln 2) − 1)/v for k = 2.
fn series(v: Double, k: u32) -> Double {
    // ln 2 in two words.
    let ln = Double { hi: LN_2, lo: 2.319_046_813_846_299_6e-17 };
    let square = ln * ln * v;
    let mut term = if k == 2 { ln * ln * 0.5 } else { ln };
    let (mut sum, mut n) = (term, f64::from(k));
    while term.hi > 1e-34 {
        term = term * square / Double::new((n + 1.0) * (n + 2.0));
        sum = sum + term;
        n += 2.0;
    }
    sum
}

/// arctan √v/√v, by one Newton step from the `f64` value.
fn arctangent_ratio(v: Double) -> Double {
    if v.hi < 1e-12 {
        return Double::ONE - v / Double::new(3.0);
    }
    let x = v.sqrt();
    let start = x.hi.atan();
    let angle = Double::new(start) / Double::PI;
    let (sine, cosine) = (crate::chebyshev::sin_pi(angle), crate::chebyshev::cos_pi(angle));
    let step = (x * cosine - sine) / (cosine + x * sine);
    (Double::new(start) + step - step * step * step / Double::new(3.0)) / x
}

#[cfg(test)]
mod tests;
