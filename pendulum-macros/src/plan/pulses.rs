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
use crate::power::power;
use crate::program::rounding::INFLATION_OF_SUMS;
use crate::supremum::worst;
use std::f64::consts::{FRAC_PI_2, PI};

/// A bound of a curve between its poles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pulses {
    /// α.
    rate: f64,
    curve: Of,
}

/// How a curve follows from Σ |sech α(s − ½ − m)|.
#[derive(Clone, Copy, Debug)]
enum Of {
    /// By its powers.
    Powers([f64; 3]),
    /// θ, or what it has beside uniform turns: `largest` for real phases, and from there on its derivative's integral, of
    /// 2α Σ ± sech less `turns` full angles per anchor.
    Integral { largest: f64, turns: f64 },
}

/// The semi-axes of the longest ellipse that is tried, where the poles are farther: of that few points serve.
const LONGEST: f64 = 0.75;
const HIGHEST: f64 = 0.6;

/// Parts of the way from the centre to the lowest point, of which those next to the poles are the smallest, or to the end.
/// In each the pulse counts where it is largest; and of the bound it is the logarithm that counts.
const CELLS: u32 = 24;

impl Pulses {
    /// By powers of e, which is `front` times (π/2K′) Σ |sech|.
    fn by_powers(elliptic: &Elliptic, front: f64, [constant, once, twice]: [f64; 3]) -> Self {
        let front = front * FRAC_PI_2 / elliptic.quarter_complementary.to_f64();
        Self::with(elliptic, Of::Powers([constant, once * front, twice * front * front]))
    }

    fn with(elliptic: &Elliptic, curve: Of) -> Self {
        Self { rate: elliptic.span().to_f64(), curve }
    }

    /// θ, or what it has beside uniform turns: `largest` for real phases, and `turns` of a full angle per anchor.
    pub(crate) fn angle(elliptic: &Elliptic, largest: f64, turns: f64) -> Self {
        Self::with(elliptic, Of::Integral { largest, turns })
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

    /// The parameter, as in [`bound`](Self::bound), of the ellipse with its foci at the ends of an arc that goes through the
    /// nearest pole, or of the longest: on an ellipse the distances from the foci add up to the major axis.
    pub(crate) fn parameter_of_poles(&self, arc: Arc) -> f64 {
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
    /// and sinh of `parameter`, by its magnitude on it.
    pub(crate) fn bound(&self, arc: Arc, parameter: f64) -> f64 {
        // Both sides are alike about an anchor and about a lowest point.
        let sides: &[f64] = if is_half(arc.centre) { &[1.0] } else { &[1.0, -1.0] };
        let (long, high) = (0.5 * arc.stretch.hi * libm::cosh(parameter), 0.5 * arc.stretch.hi * libm::sinh(parameter));
        let side = |way: &f64| self.nearest(way * arc.centre.hi, long, high);
        // Of the other pulses the centres are farther than ½ and 1, 1½ and 2, …
        let others = 2.0 / libm::sinh(self.rate / 2.0) / (1.0 - libm::exp(-self.rate));
        let sum = worst(sides.iter().map(side)) + others;
        let bound = match self.curve {
            Of::Powers([constant, once, twice]) => constant + sum * (once + sum * twice),
            Of::Integral { largest, turns } => largest + high * 2.0 * (PI * turns + self.rate * sum),
        };
        if sum.is_finite() { bound * INFLATION_OF_SUMS } else { f64::INFINITY }
    }

    /// Bounds the pulse of the nearest lowest point on the later half of an ellipse of these semi-axes: in each cell where
    /// it is nearest to that and farthest from the real axis.
    fn nearest(&self, centre: f64, long: f64, high: f64) -> f64 {
        let cosine = |x: f64| {
            let b = self.rate * high * libm::sqrt(1.0 - power((x - centre) / long, 2));
            if b < FRAC_PI_2 { libm::cos(b) } else { 0.0 }
        };
        let lowest = lowest_from(centre);
        let end = lowest.min(centre + long);
        let place = |cell: u32| end - (end - centre) * power(f64::from(cell) / f64::from(CELLS), 2);
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
