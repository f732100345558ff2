//! The kernel of motions that come near the top: swings, rotations and the separatrix between them.
//!
//! There most of a period is spent near the top, and the rest is the same passage through the lowest point for all of
//! them, θ = 2 gd w with w = (π/2K′)·(u − u of the lowest point). With E = e^(−|w|), G = q′/E, the image of the next
//! passage, and σ = 1 for a swing, −1 for a rotation, 0 on the separatrix (q′ = 0),
//!
//! π − |θ| = 4 arctan A, A = Q/P, Q = (E + σG)(1 + σq′³M − q′⁴), P = 1 + σq′M, M = E² + G²,
//!
//! which is the dual theta quotient (tan(θ/4) = [sinh X − q′ sinh 3X + …]/[cosh X + q′ cosh 3X + …], X = w/2, for a
//! swing) solved for tan((π − θ)/4); left out are q′⁶(E⁴ + G⁴) of P and q′¹⁰(E⁵ + G⁵) of Q. From it, with sin(θ/2) = (P²
//! − Q²)/N and cos(θ/2) = 2QP/N, N = P² + Q², follow position and acceleration. The velocity's numerator is a theta
//! function too:
//!
//! |θ̇| = F·Σ (−σ)ᵐ q′^(m²) E^(2m+1)/N = F·(E − σG)(1 − q′² − q′⁶ − σq′(1 − q′⁴)M + q′⁴M²)/N up to q′⁹,
//!
//! since E³ − σG³ = (E − σG)(M + σq′) and E⁵ − σG⁵ = (E − σG)(M² + σq′M − q′²), EG being q′;
//!
//! F being such that the velocity at the lowest point, E = 1, is the exact one.
//!
//! E = 2^(−j)·2^(−f) with j the integer nearest to |w|/ln 2: 2^(±f) = 1 + (f²·C(f²) ± f·S(f²)), by polynomials, serve E
//! and G.

mod estimate;
mod functions;
mod outputs;
mod quotient;

use super::fit::{Domain, Fit};
use super::variables::{Variables, at_most};
use crate::motion::{Elliptic, Motion};
use crate::parse::{Float, Output};
use crate::power::{power, two_to};
use crate::program::rounding::Known;
use crate::program::{Builder, Id, Program};
use crate::series::Parity;
use crate::supremum::largest;
use functions::{arctangent_ratio, series};
use pendulum_runtime::double::Double;
use quotient::{FRACTION, IMAGE_POWER, POWER};

/// What is the same for all outputs of one motion.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Orbit {
    /// log₂ e·|w| per unit of the phase.
    pub(crate) rate: Double,
    /// σ: 1 of a swing, −1 of a rotation, 0 of the separatrix.
    pub(crate) sigma: f64,
    /// q′ = mantissa·2^exponent; 0 on the separatrix.
    pub(crate) image: Double,
    pub(crate) image_exponent: i32,
    /// −1 for the mirror image.
    pub(crate) direction: f64,
    /// The largest |θ̇| and, of the separatrix, |θ̈|, ω².
    fastest: Double,
    omega_squared: Double,
}

/// Above this complementary nome the terms that are left out of Q, P and the velocity's numerator may matter.
const LARGEST_IMAGE: f64 = 0.05;

/// The kernel of one output.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Passage {
    pub(crate) output: Output,
    orbit: Orbit,
    /// The least and the largest |phase| within the horizon.
    distances: [f64; 2],
    /// The largest that a time beyond the horizon leaves.
    half: f64,
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

impl Images {
    /// Those that matter to an output that is to be right within `limit`, and what leaving out the others changes.
    ///
    /// With A = Q/P, θ changes by at most 4 ΔA and by 4A/(1 + A²) ≤ 2 times ΔA/A; sin θ and e^{iθ} by no more. G is at most
    /// `outermost`, M at most 1 + q′², and q′ at most 0.05. The velocity, exact at E = 1, changes by 2FG, and without P by
    /// q′F·2E(1 − E²)(2 + E²)/(1 + E²)² ≤ 1.094 q′F, up to terms of 25 q′²F; by less without the correction. No level has
    /// the last q′⁶ of P (with M ≤ 1 + q′², E⁴ + G⁴ is), which changes θ by twice as much, and the velocity by as much where
    /// it is and again at E = 1: less than 5q′⁶ with the q′⁹ of its numerator and the q′¹⁰ of Q.
    fn that_matter(output: Output, q: f64, outermost: f64, limit: f64) -> (Self, f64) {
        let [by_sum, by_ratio] = if output == Output::Velocity { [2.5, 1.1 + 25.0 * q] } else { [4.01, 2.3] };
        let levels = [
            (Self::Sum, by_sum * outermost),
            (Self::Denominator, by_ratio * q),
            (Self::Correction, by_ratio * power(q, 3)),
        ];
        let matters = |&&(_, change): &&(Self, f64)| change > limit / 8.0;
        let images = levels.iter().rev().find(matters).map_or(Self::Nothing, |level| level.0);
        let left_out = levels.iter().filter(|level| level.0 > images).map(|level| level.1);
        (images, left_out.sum::<f64>() + 5.0 * power(q, 6))
    }

    /// Whether Q/P is to be formed with as little rounding as can be: a truncation of a few units of rounding is asked for
    /// where full precision is.
    fn ask_for_care(self, output: Output, limit: f64) -> bool {
        self >= Self::Denominator && output != Output::Velocity && limit < 8.0 * Float::F64.rounding_unit()
    }
}

/// What the series of the exponential may be off by, in units of what all may leave out. Of |w| ≤ ½, series that are off by
/// ε change E, which is 0.7 at least, by (¼ + ½)ε < 1.07ε of it; and that changes an angle, which is ±2 gd of ln E, the
/// position and sin θ by at most twice, and the velocity by at most half as much. With [`OF_ARCTANGENT`] all takes 0.8 or
/// less, and images that are left out the rest.
fn of_series(output: Output) -> f64 {
    match output {
        Output::Theta | Output::Wrapped => 1.0 / 16.0,
        Output::Velocity => 1.0,
        Output::Acceleration | Output::Position => 1.0 / 3.0,
    }
}

/// The same of the arctangent's ratio, which counts four times.
const OF_ARCTANGENT: f64 = 1.0 / 6.0;

/// E below 2 to minus this is nothing beside the roundings of 1.
const NEGLIGIBLE_BINADE: i32 = 24;

impl Orbit {
    /// w = (πK/K′)·phase, in units of ln 2; `None` where q′ is too large.
    pub(crate) fn new(motion: &Motion, elliptic: &Elliptic, sigma: f64, direction: f64) -> Option<Self> {
        let rate = elliptic.span().to_double() / Double::LN_2;
        if libm::exp2(-rate.hi) > LARGEST_IMAGE {
            return None;
        }
        let image_exponent = (-rate.hi).floor() as i32;
        let image = elliptic.nome_complementary().scale(-i64::from(image_exponent)).to_double();
        Some(Self { rate, sigma, image, image_exponent, ..Self::separatrix(motion, direction) })
    }

    /// w = ωt, in the same units.
    pub(crate) fn separatrix(motion: &Motion, direction: f64) -> Self {
        let (fastest, omega_squared) = (motion.fastest().to_double(), motion.omega.square().to_double());
        let (rate, image) = (Double::ONE / Double::LN_2, Double::ZERO);
        Self { rate, sigma: 0.0, image, image_exponent: 0, direction, fastest, omega_squared }
    }

    /// The same by phases in units of so many anchors.
    pub(crate) fn in_units(&self, unit: Double) -> Self {
        Self { rate: self.rate * unit, ..self.clone() }
    }

    /// What the rounding of w adds, relative to w: the rate's, and the product's.
    pub(crate) fn rounding_of_exponent(&self) -> f64 {
        (self.rate.lo / self.rate.hi).abs() + 1.001 * Float::F64.rounding_unit()
    }

    /// What an output is a multiple of.
    pub(crate) fn factor(&self, output: Output) -> Double {
        match output {
            Output::Velocity => self.fastest,
            Output::Acceleration => self.omega_squared,
            _ => Double::ONE,
        }
    }

    /// Whether the direction changes from passage to passage.
    fn alternates(&self) -> bool {
        self.sigma > 0.0
    }

    fn q(&self) -> f64 {
        self.image.hi * two_to(self.image_exponent)
    }

    /// G at that phase: √q′ half an anchor from the lowest point.
    fn image_at(&self, phase: f64) -> f64 {
        libm::exp2(libm::log2(self.image.hi) + f64::from(self.image_exponent) + self.rate.hi * phase)
    }
}

impl Passage {
    /// For phases of these magnitudes, and up to `half` whatever the time, with all approximations within `limit`, in
    /// units of the output's factor.
    pub(crate) fn new(output: Output, orbit: Orbit, distances: [f64; 2], half: f64, limit: f64) -> Self {
        let factor = orbit.factor(output);
        let q = orbit.q();
        // The coefficients of both series are positive, so on the ellipse that reaches −2 and 9/4 they are largest at
        // 9/4, and there at most sinh(ln 2 · 3/2)/(3/2) < 0.83: less than the bound that is given.
        let domain = Domain::reaching(0.25, -2.0, libm::cosh(0.5 * Double::LN_2.hi) * 2.0);
        let of_series = limit * of_series(output);
        let even = Fit::new(&domain, of_series, |v| series(v, 2));
        let odd = Fit::new(&domain, of_series, |v| series(v, 1));
        let outermost = orbit.image_at(distances[1]).max(q.sqrt());
        let (images, truncation) = Images::that_matter(output, q, outermost, limit);
        // At the lowest point A = (1 + q′)/(1 + q′M) in a swing, of which the divisor may not matter, and 1 + q′³ in a
        // rotation, of which the correction may not. On the ellipse that reaches −0.9, |1 + vt²| ≥ 1/20 for 0 ≤ t ≤ 1, of
        // whose inverse the arctangent is a mean.
        let lowest = match images {
            Images::Sum => 1.0 + q,
            Images::Denominator if orbit.sigma < 0.0 => (1.0 - q) / (1.0 - q - power(q, 3)),
            _ => 1.0,
        };
        let largest = lowest * lowest;
        let arctangent = output.is_angle().then(|| {
            Fit::new(&Domain::reaching(largest * 1.000_1, -0.9, 20.0), limit * OF_ARCTANGENT, arctangent_ratio)
        });
        let careful = images.ask_for_care(output, limit);
        Self { output, orbit, distances, half, images, careful, even, odd, arctangent, factor, truncation }
    }

    /// The same with the exponential of another output's, where that is nearer: its error is bounded as before.
    pub(crate) fn with_exponential_of(&self, other: &Self) -> Self {
        let (even, odd) = (self.even.nearest(&other.even).clone(), self.odd.nearest(&other.odd).clone());
        Self { even, odd, ..self.clone() }
    }

    /// Whether phases beyond those that are met are kept from it: of what isn't met the rounding isn't known, and the angle
    /// of a swing exceeds its amplitude by no more than what is known, whatever the time.
    fn is_held(&self) -> bool {
        self.output.is_angle() && self.orbit.alternates() && self.distances[1] < self.half
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        let angle =
            self.arctangent.as_ref().map_or(String::new(), |fit| format!(", an arctangent of {} terms", fit.terms()));
        format!("an exponential of {} terms{angle}", self.terms())
    }

    pub(crate) fn terms(&self) -> usize {
        self.even.terms() + self.odd.terms()
    }

    /// Emits the kernel.
    pub(crate) fn lower(&self, b: &mut Builder, variables: &Variables, name: &'static str) -> Vec<Id> {
        let float = b.float();
        let magnitude = b.convert(variables.magnitude, Float::F64);
        let magnitude = if self.is_held() { at_most(b, magnitude, self.distances[1]) } else { magnitude };
        let quotient = self.quotient(b, magnitude);
        // Before the lowest point a swing is on the positive side, of a passage downwards; a rotation still on the
        // negative.
        let direction = self.orbit.direction * if self.orbit.alternates() { 1.0 } else { -1.0 };
        let mut values = match (&self.arctangent, self.output) {
            (Some(arctangent), _) => vec![Self::angle(b, arctangent, &quotient, direction)],
            (None, Output::Velocity) => vec![self.velocity(b, &quotient)],
            (None, Output::Position) => Self::position(b, &quotient, direction).to_vec(),
            (None, _) => vec![self.acceleration(b, &quotient, direction)],
        };
        for value in &mut values {
            *value = b.convert(*value, float);
        }
        if let [value] = values[..] {
            b.name(value, name);
        }
        // The height changes its sign nowhere.
        values[0] = variables.signed(b, values[0], self.orbit.alternates(), self.parity());
        values
    }

    /// About an anchor: an angle, θ̈ and x are even about a turning point and odd about the top, θ̇ the other way round.
    fn parity(&self) -> Parity {
        if self.orbit.alternates() == (self.output == Output::Velocity) { Parity::Odd } else { Parity::Even }
    }

    /// The rounding of the results, the phase taken as exact: w binade by binade, until it exceeds `cap`.
    pub(crate) fn rounding(&self, program: &Program, cap: f64) -> f64 {
        let program = &program.after_named(&[FRACTION, POWER, IMAGE_POWER]);
        let rate = self.orbit.rate.hi;
        let (nearest, furthest) = (rate * self.distances[0] * (1.0 - 1e-6), rate * self.distances[1] * (1.0 + 1e-6));
        let binades = furthest.ceil() as i32;
        let most = binades.min(NEGLIGIBLE_BINADE);
        let slices = |j: i32| {
            let count = match j {
                0 => 64,
                1..4 => 16,
                _ => 2,
            };
            let slice = move |slice: i32| {
                let at = |index: i32| f64::from(index) / f64::from(count) - 0.5;
                (j, at(slice), at(slice + 1))
            };
            (0..count).map(slice)
        };
        let stands_for_all_that_follow = |j: i32| j == most && most < binades;
        let is_met = |&(j, low, high): &(i32, f64, f64)| {
            let from = f64::from(j) + low;
            let to = if stands_for_all_that_follow(j) { f64::INFINITY } else { f64::from(j) + high };
            from <= furthest && to > nearest
        };
        let bound = |(j, low, high): (i32, f64, f64)| {
            let power = |exponent: i32| two_to(exponent.max(-1022));
            let image = |j: i32| power(j + self.orbit.image_exponent);
            let (powers, images) = if stands_for_all_that_follow(j) {
                ((0.0, power(-j)), (0.0, image(binades)))
            } else {
                ((power(-j), power(-j)), (image(j), image(j)))
            };
            let known = [(FRACTION, (low, high)), (POWER, powers), (IMAGE_POWER, images)];
            program.rounding_given(&known.map(|(name, (low, high))| (name, Known::between(low, high))))
        };
        largest((0..=most).flat_map(slices).filter(is_met).map(bound), cap)
    }
}

#[cfg(test)]
mod tests;
