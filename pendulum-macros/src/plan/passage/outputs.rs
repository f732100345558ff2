//! Angle, velocity, acceleration and position from Q and P, emitted.

use super::quotient::{Parts, Quotient, linear, near};
use super::{Images, Passage};
use crate::plan::fit::Fit;
use crate::power::{power, two_to};
use crate::program::{Builder, Id};
use pendulum_runtime::double::Double;

impl Passage {
    /// sign·(π − 4 arctan(Q/P)).
    pub(super) fn angle(b: &mut Builder, arctangent: &Fit, quotient: &Quotient, sign: f64) -> Id {
        let numerator = quotient.numerator;
        let tangent = quotient.denominator.map_or(numerator, |denominator| b.div(numerator, denominator));
        b.name(tangent, "tangent");
        let square = b.mul(tangent, tangent);
        let ratio = arctangent.times(4.0 * sign).lower(b, square, &["r", "r2", "r4", "r8", "r16", "r32"]);
        let angle = b.mul(tangent, ratio);
        let pi = b.rounded(Double::PI.scale(sign));
        b.sub(pi, angle)
    }

    /// F·(E − σG)(1 − q′² − q′⁶ − σq′(1 − q′⁴)M + q′⁴M²)/N.
    pub(super) fn velocity(&self, b: &mut Builder, quotient: &Quotient) -> Id {
        let (sigma, q) = (self.orbit.sigma, self.orbit.q());
        let mut top = quotient.counterpart;
        if let Some(squares) = quotient.squares {
            let correction = if self.images == Images::Correction { power(q, 4) } else { 0.0 };
            let constant = 1.0 - q * q * (1.0 + correction);
            let mut series = linear(b, constant, -sigma * q * (1.0 - correction), squares);
            if self.images == Images::Correction {
                let square = b.mul(squares, squares);
                let last = near(b, power(q, 4));
                let last = b.mul(square, last);
                series = b.add(series, last);
            }
            top = b.mul(top, series);
        }
        let bottom = quotient.parts(b).norm;
        let sign = self.orbit.direction * if self.orbit.alternates() { -1.0 } else { 1.0 };
        let factor = self.factor * self.lowest() * sign;
        let factor = b.rounded(factor);
        let ratio = b.div(top, bottom);
        b.mul(factor, ratio)
    }

    /// N over the velocity's numerator at the lowest point, with the terms that are kept.
    fn lowest(&self) -> Double {
        if self.images == Images::Nothing {
            return Double::new(2.0);
        }
        let (sigma, q) = (Double::new(self.orbit.sigma), self.orbit.image.scale(two_to(self.orbit.image_exponent)));
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
    pub(super) fn acceleration(&self, b: &mut Builder, quotient: &Quotient, sign: f64) -> Id {
        let Parts { norm, difference, product } = quotient.parts(b);
        let factor = self.factor * (-4.0 * sign);
        let factor = b.rounded(factor);
        let top = b.mul(product, difference);
        let bottom = b.mul(norm, norm);
        let ratio = b.div(top, bottom);
        b.mul(ratio, factor)
    }

    /// (sign·sin |θ|, −cos θ) from cos(θ/2) = 2QP/N and sin(θ/2) = (P² − Q²)/N.
    pub(super) fn position(b: &mut Builder, quotient: &Quotient, sign: f64) -> [Id; 2] {
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
}
