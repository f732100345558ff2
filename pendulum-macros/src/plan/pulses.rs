//! How large the curves are in the complex plane, between their poles.
//!
//! A Fourier series converges in the strip below the poles, where the sum of its terms' magnitudes bounds the curve: well
//! towards the poles, above the lowest point, but by far too much above the turning point, where the terms cancel and the
//! curve goes on beyond the strip. An interpolation's ellipses are high there, and narrow next to the poles. The same
//! functions are sums over their poles, a pulse for each passage through the lowest point (DLMF 22.12.6 and 22.12.13, with
//! Jacobi's imaginary transformation): with α = πK/K′ and u = 2K(s − ½)
//! dn u = (π/2K′) Σ sech α(s − ½ − m) and k cn u = (π/2K′) Σ (−1)ᵐ sech α(s − ½ − m),
//! and |sech(a + ib)|² = 1/(sinh² a + cos² b). With e for k cn or dn of a swing and for cn or dn/κ of a rotation all of
//! them are bounded by e: θ̇ = 2ωe, cos(θ/2) = e, sin(θ/2)² = 1 − e², θ̈ = −ω² sin θ, and θ is what it is at a real phase
//! and its derivative's integral up from there.

use super::arc::Arc;
use super::reduction::is_half;
use crate::motion::Elliptic;
use crate::supremum::worst;
use std::f64::consts::{FRAC_PI_2, PI};

/// A bound of a curve between its poles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pulses {
    /// α.
    rate: f64,
    /// By powers of Σ |sech α(s − ½ − m)|.
    powers: [f64; 3],
}

/// The longest ellipse's semi-axes.
const LONGEST: f64 = 0.75;
const HIGHEST: f64 = 0.6;

/// Parts of the way from the centre to the lowest point, of which those next to the poles are the smallest, or to the end.
const CELLS: u32 = 24;

impl Pulses {
    /// By powers of e, which is `front` times (π/2K′) Σ |sech|.
    fn by_powers(elliptic: &Elliptic, front: f64, [constant, once, twice]: [f64; 3]) -> Self {
        let complementary = elliptic.quarter_complementary.to_f64();
        let front = front * FRAC_PI_2 / complementary;
        let rate = PI * elliptic.quarter.to_f64() / complementary;
        Self { rate, powers: [constant, once * front, twice * front * front] }
    }

    /// θ, or what it has beside uniform turns: `largest` for real phases, and `turns` of a full angle per anchor. Of both
    /// the derivative is 2α Σ ± sech.
    pub(crate) fn angle(elliptic: &Elliptic, largest: f64, turns: f64) -> Self {
        let pulses = Self::by_powers(elliptic, 1.0, [largest + HIGHEST * 2.0 * PI * turns, 0.0, 0.0]);
        Self { powers: [pulses.powers[0], HIGHEST * 2.0 * pulses.rate, 0.0], ..pulses }
    }

    /// θ̇, the largest |θ̇| of which e = 1 would be 2ω.
    pub(crate) fn velocity(elliptic: &Elliptic, front: f64, omega: f64) -> Self {
        Self::by_powers(elliptic, front, [0.0, 2.0 * omega, 0.0])
    }

    /// ω² sin θ = 2ω²e√(1 − e²).
    pub(crate) fn acceleration(elliptic: &Elliptic, front: f64, square: f64) -> Self {
        Self::by_powers(elliptic, front, [0.0, 2.0 * square, 2.0 * square])
    }

    /// sin(θ/2) = √(1 − e²).
    pub(crate) fn half_sine(elliptic: &Elliptic, front: f64) -> Self {
        Self::by_powers(elliptic, front, [1.0, 1.0, 0.0])
    }

    /// cos(θ/2) = e.
    pub(crate) fn half_cosine(elliptic: &Elliptic, front: f64) -> Self {
        Self::by_powers(elliptic, front, [0.0, 1.0, 0.0])
    }

    /// Of the ellipse whose foci are the ends of an arc and that goes through the nearest poles, or the longest, half the
    /// arc times cosh of this is the semi-axis: the distances of a point on it from the foci are together as long as both.
    pub(crate) fn angle_of_poles(&self, arc: Arc) -> f64 {
        let (centre, stretch) = (arc.centre.hi, arc.stretch.hi);
        let height = FRAC_PI_2 / self.rate / stretch;
        let through = |pole: f64| {
            let x = (pole - centre) / stretch;
            libm::hypot(x - 0.5, height) + libm::hypot(x + 0.5, height)
        };
        let lowest = lowest_from(centre);
        let high = 2.0 * HIGHEST / stretch;
        let longest = (2.0 * LONGEST / stretch).min(libm::sqrt(1.0 + high * high));
        libm::acosh(through(lowest - 1.0).min(through(lowest)).min(longest))
    }

    /// Bounds the curve inside the ellipse whose foci are the ends of an arc and whose semi-axes are half of it times cosh
    /// and sinh of `angle`, by its magnitude on it.
    pub(crate) fn bound(&self, arc: Arc, angle: f64) -> f64 {
        // Both sides are alike about an anchor and about a lowest point.
        let sides: &[f64] = if is_half(arc.centre) { &[1.0] } else { &[1.0, -1.0] };
        let side = |way: &f64| self.nearest(way * arc.centre.hi, arc.stretch.hi, angle);
        // Of the other pulses the centres are farther than ½ and 1, 1½ and 2, …
        let others = 2.0 / libm::sinh(self.rate / 2.0) / (1.0 - libm::exp(-self.rate));
        let sum = worst(sides.iter().map(side)) + others;
        let [constant, once, twice] = self.powers;
        if sum.is_finite() { (constant + sum * (once + sum * twice)) * (1.0 + 1e-9) } else { f64::INFINITY }
    }

    /// Bounds the pulse of the nearest lowest point on the later half of an ellipse: in each cell where it is nearest to that
    /// and farthest from the real axis.
    fn nearest(&self, centre: f64, stretch: f64, angle: f64) -> f64 {
        let (long, high) = (0.5 * stretch * libm::cosh(angle), 0.5 * stretch * libm::sinh(angle));
        let cosine = |x: f64| {
            let b = self.rate * high * libm::sqrt(1.0 - ((x - centre) / long).powi(2));
            if b < FRAC_PI_2 { libm::cos(b) } else { 0.0 }
        };
        let lowest = lowest_from(centre);
        let end = lowest.min(centre + long);
        let place = |cell: u32| end - (end - centre) * (f64::from(cell) / f64::from(CELLS)).powi(2);
        let cell = |cell: u32| {
            let (near, far) = (place(cell + 1), place(cell));
            let distance = (lowest - far).min(near - (lowest - 1.0));
            1.0 / libm::hypot(libm::sinh(self.rate * distance), cosine(near))
        };
        // Beyond the lowest point the ellipse is lower.
        let beyond = if end < lowest { 0.0 } else { 1.0 / cosine(lowest) };
        worst((0..CELLS).map(cell).chain([beyond]))
    }
}

/// The first lowest point from this phase on.
fn lowest_from(phase: f64) -> f64 {
    libm::ceil(phase - 0.5) + 0.5
}

#[cfg(test)]
mod tests;
