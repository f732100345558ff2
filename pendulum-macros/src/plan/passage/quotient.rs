//! Q/P and what it is made of, emitted.

use super::{Images, Passage};
use crate::parse::Float;
use crate::plan::variables::at_most;
use crate::power::power;
use crate::program::{Builder, Id, Op};

/// The exponent w beyond which E = 2⁻ʷ is nothing beside 1 whatever is asked, and near which powers of two come to their
/// end.
const FURTHEST: f64 = 900.0;

/// f, 2⁻ʲ and q′·2ʲ but for its mantissa, of which the analysis of the rounding knows the ranges.
pub(super) const FRACTION: &str = "f";
pub(super) const POWER: &str = "power";
pub(super) const IMAGE_POWER: &str = "image_power";

/// The square of the argument, and its powers.
const POWERS: [&str; 4] = ["v", "v2", "v4", "v8"];

/// What the outputs are made of.
pub(super) struct Quotient {
    /// Q, or Q/P.
    pub(super) numerator: Id,
    /// E − σG.
    pub(super) counterpart: Id,
    /// M, and P where it matters and Q isn't divided by it yet.
    pub(super) squares: Option<Id>,
    pub(super) denominator: Option<Id>,
}

/// N = P² + Q², P² − Q² and QP.
pub(super) struct Parts {
    pub(super) norm: Id,
    pub(super) difference: Id,
    pub(super) product: Id,
}

impl Quotient {
    pub(super) fn parts(&self, b: &mut Builder) -> Parts {
        let one = b.constant(1.0);
        let square = b.mul(self.numerator, self.numerator);
        let base = self.denominator.map_or(one, |denominator| b.mul(denominator, denominator));
        let (norm, difference) = (b.add(base, square), b.sub(base, square));
        b.name(norm, "norm");
        let product = self.denominator.map_or(self.numerator, |denominator| b.mul(self.numerator, denominator));
        Parts { norm, difference, product }
    }
}

/// E = 2⁻ʷ, and what it is made of.
#[derive(Clone, Copy)]
struct Exponential {
    direct: Id,
    j: Id,
    even: Id,
    odd: Id,
}

impl Passage {
    /// The exponential by powers of 2, 2⁻ʷ = 2⁻ʲ(1 + even − odd).
    fn exponential(&self, b: &mut Builder, magnitude: Id) -> Exponential {
        let rate = b.rounded(self.orbit.rate);
        let w = b.mul(magnitude, rate);
        let w = if self.orbit.rate.hi * self.half < FURTHEST { w } else { at_most(b, w, FURTHEST) };
        b.name(w, "w");
        let constant = b.constant(Float::F64.magic());
        // −j, so that its bits are the exponent.
        let integer = b.sub(constant, w);
        b.name(integer, "exponent");
        let j = b.sub(constant, integer);
        let f = b.sub(w, j);
        b.name(f, FRACTION);
        let square = b.mul(f, f);
        b.name(square, "v");
        // cosh − 1, small beside the 1 that is added last.
        let even = self.even.lower(b, square, &POWERS);
        let even = b.mul(square, even);
        b.name(even, "even");
        let one = b.constant(1.0);
        let odd = self.odd.lower(b, square, &POWERS);
        let odd = b.mul(f, odd);
        b.name(odd, "odd");
        let power = b.push(Op::PowerOfTwo { magic: integer });
        b.name(power, POWER);
        let falling = b.sub(even, odd);
        let falling = b.add(one, falling);
        let direct = b.mul(power, falling);
        Exponential { direct: b.name(direct, "direct"), j, even, odd }
    }

    /// G = q′·2ʷ, of the same parts.
    fn image(&self, b: &mut Builder, Exponential { j, even, odd, .. }: Exponential) -> Id {
        // 2^(j + image_exponent), below which there is nothing to add.
        let shift = b.constant(f64::from(self.orbit.image_exponent));
        let exponent = b.add(j, shift);
        let least = b.constant(-1022.0);
        let exponent = b.push(Op::Max { limit: least, x: exponent });
        let constant = b.constant(Float::F64.magic());
        let exponent = b.add(exponent, constant);
        b.name(exponent, "image_exponent");
        let power = b.push(Op::PowerOfTwo { magic: exponent });
        b.name(power, IMAGE_POWER);
        let mantissa = b.rounded(self.orbit.image);
        let rising = b.add(even, odd);
        let one = b.constant(1.0);
        let rising = b.add(one, rising);
        let scaled = b.mul(mantissa, rising);
        let image = b.mul(power, scaled);
        b.name(image, "image")
    }

    /// The parts of the outputs.
    pub(super) fn quotient(&self, b: &mut Builder, magnitude: Id) -> Quotient {
        let exponential = self.exponential(b, magnitude);
        let direct = exponential.direct;
        if self.images == Images::Nothing {
            return Quotient { numerator: direct, counterpart: direct, squares: None, denominator: None };
        }
        let image = self.image(b, exponential);
        let (sum, difference) = (b.add(direct, image), b.sub(direct, image));
        let (numerator, counterpart) = if self.orbit.sigma > 0.0 { (sum, difference) } else { (difference, sum) };
        if self.images == Images::Sum {
            return Quotient { numerator, counterpart, squares: None, denominator: None };
        }
        let squares = [b.mul(direct, direct), b.mul(image, image)];
        let squares = b.add(squares[0], squares[1]);
        b.name(squares, "squares");
        let (sigma, q) = (self.orbit.sigma, self.orbit.q());
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
            let correction = linear(b, 1.0 - power(q, 4), sigma * power(q, 3), squares);
            b.mul(numerator, correction)
        } else {
            numerator
        };
        Quotient { numerator, counterpart, squares: Some(squares), denominator: Some(denominator) }
    }

    /// κ in (1 + σq′³M − q′⁴)/P = 1 + κ. With Q/P = E + (σG + κ(E + σG)) only the last sum is rounded with a unit of E.
    fn excess(&self, b: &mut Builder, squares: Id, denominator: Id) -> Id {
        let (sigma, q) = (self.orbit.sigma, self.orbit.q());
        let top = if self.images == Images::Correction {
            linear(b, -power(q, 4), -sigma * q * (1.0 - q * q), squares)
        } else {
            let slope = near(b, -sigma * q);
            b.mul(slope, squares)
        };
        b.div(top, denominator)
    }
}

/// constant + slope·x.
pub(super) fn linear(b: &mut Builder, constant: f64, slope: f64, x: Id) -> Id {
    let constant = if constant == 1.0 { b.constant(constant) } else { near(b, constant) };
    let slope = near(b, slope);
    let product = b.mul(slope, x);
    b.add(constant, product)
}

/// A number that was computed from the nome by a few operations.
pub(super) fn near(b: &mut Builder, value: f64) -> Id {
    b.loose(value, 8.0 * Float::F64.rounding_unit() * value.abs())
}
