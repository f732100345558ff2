//! The curves that outputs are made of: each a function of the phase alone, with what planning needs to know of it.

mod rotation;
mod swing;

use super::arc::Arc;
use super::pulses::Pulses;
use crate::plan::reduction::{Origin, Reduction};
use crate::program::rounding::INFLATION;
use crate::series::{Parity, Wave};
use pendulum_runtime::double::Double;
pub(crate) use rotation::RotationCurves;
pub(crate) use swing::SwingCurves;

/// A function of the phase s (in anchors) between two anchors, or over an [`Arc`].
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    wave: Wave,
    /// Of those with poles.
    pulses: Option<Pulses>,
    arc: Arc,
    /// Set where the sign changes from anchor to anchor.
    pub(crate) alternates: bool,
    /// Whether it is known to be the steeper the farther the phase is from an anchor.
    pub(crate) rises: bool,
    pub(crate) size: Size,
}

/// How large a function of the phase s is, for real s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Size {
    /// The largest magnitude.
    pub(crate) largest: f64,
    /// The largest |derivative| with respect to s.
    pub(crate) slope: f64,
    /// The largest |phase from the lowest point × derivative|.
    pub(crate) conditioning: f64,
    /// What a tolerance of 1 means: 1, ω, ω².
    pub(crate) unit: f64,
}

impl Size {
    /// What the reduction's error of the phase does to the function: at most the integral of |f′| over the way from the true
    /// phase to the computed one. That is at most e + r|z| long for both its ends, so for every z on it, and the integral is
    /// at most e sup |f′| + r sup |z f′|. The r of a reduction serves for the true phase with a thousandth to spare, which is
    /// enough for the computed one, too, but for what e adds to it: the factor 1 + r.
    pub(crate) fn phase_error(&self, reduction: &Reduction) -> f64 {
        let relative = match reduction.relative_error {
            0.0 => 0.0,
            error => self.conditioning(reduction) * error,
        };
        self.slope * reduction.error * (1.0 + reduction.relative_error) + relative
    }

    /// The largest |z f′(z)| up to where phases z from the lowest point go. Beyond half an anchor f′ is as large as it is
    /// as far before it, where the conditioning holds for a smaller z.
    pub(crate) fn conditioning(&self, reduction: &Reduction) -> f64 {
        let beyond = reduction.overshoot.max(0.0);
        match reduction.origin {
            Origin::Lowest if beyond < 0.5 => self.conditioning * ((0.5 + beyond) / (0.5 - beyond)),
            _ => f64::INFINITY,
        }
    }

    /// The largest error in the function's own unit that is at most `tol` in units of the tolerance.
    pub(crate) fn within(&self, tol: f64) -> f64 {
        let mut error = tol * self.unit;
        while error / self.unit > tol {
            error = error.next_down();
        }
        error
    }
}

/// Parts of the way to the poles: towards them ellipses grow, and so does what bounds a curve inside, without limit.
const TOWARDS_POLES: [f64; 6] = [0.5, 0.6, 0.7, 0.8, 0.88, 0.94];

impl Curve {
    /// A whole one with poles, of that size and those largest slopes.
    fn new(wave: Wave, pulses: Pulses, largest: f64, [slope, conditioning]: [f64; 2], unit: f64) -> Self {
        let size = Size { largest, slope: slope * INFLATION, conditioning, unit };
        Self { wave, pulses: Some(pulses), arc: Arc::WHOLE, alternates: false, rises: false, size }
    }

    pub(crate) fn parity(&self) -> Parity {
        self.wave.parity_about(self.arc.halves())
    }

    /// Whether its sign is another one from an anchor to the next. Of two factors of which both change theirs,
    /// [`Self::alternates`] is set for neither.
    pub(crate) fn is_antiperiodic(&self) -> bool {
        self.wave.is_antiperiodic()
    }

    /// Whether, of the two factors of sin θ, this is the one that changes its sign in a mirror.
    pub(crate) fn mirrors(&self, from_top: bool) -> bool {
        if from_top { self.parity() == Parity::Odd } else { self.alternates }
    }

    pub(crate) fn at(&self, s: Double) -> Double {
        self.wave.at(self.arc.phase(s))
    }

    /// For each i from 0 to pieces/2 the values of a whole one at the phases i/pieces + offset.
    pub(crate) fn at_pieces(&self, pieces: usize, offsets: impl Iterator<Item = Double>) -> Vec<Vec<Double>> {
        self.wave.at_pieces(pieces, offsets)
    }

    /// Bounds |curve| for |Im s| ≤ `height`.
    pub(crate) fn bound(&self, height: f64) -> f64 {
        self.wave.bound(height * self.arc.stretch.hi)
    }

    /// [`Self::bound`] is finite for |Im s| below this.
    pub(crate) fn strip(&self) -> f64 {
        self.wave.strip() / self.arc.stretch.hi
    }

    /// Whether it has no poles, or none that matter.
    pub(crate) fn is_entire(&self) -> bool {
        const FAR: f64 = 100.0;
        self.strip() > FAR
    }

    /// Heights of the ellipses in the strip that may serve an interpolation's error. Up to 1.5 they are within |s| ≤ 4, for
    /// which the bound holds.
    pub(crate) fn heights(&self) -> [f64; 6] {
        TOWARDS_POLES.map(|part| (part * self.strip()).min(1.5))
    }

    /// Ellipses with foci s = ±½ that may serve an interpolation's error, by the number of which the semi-axes are half the
    /// hyperbolic sine and cosine, and bounds of the curve inside.
    pub(crate) fn ellipses(&self) -> impl Iterator<Item = (f64, f64)> + Clone {
        let in_strip = self.heights().map(|height| (libm::asinh(2.0 * height), self.bound(height)));
        let arc = self.arc;
        let between_poles = self.pulses.into_iter().flat_map(move |pulses| {
            let parameters = TOWARDS_POLES.map(|part| part * pulses.parameter_of_poles(arc));
            parameters.map(|parameter| (parameter, pulses.bound(arc, parameter)))
        });
        in_strip.into_iter().chain(between_poles)
    }

    /// What of it is met in the arc, for a phase that is never reduced.
    pub(crate) fn over(self, arc: Arc) -> Self {
        Self { arc, alternates: false, rises: false, ..self }
    }

    /// Bounds |derivative| at the phase s, in one word.
    pub(crate) fn steepness(&self, s: f64) -> f64 {
        self.wave.slope_roughly(s).abs() + 1e-9 * self.size.slope + self.omitted_slope()
    }

    /// The size of what is periodic, of an angle that a mean rotation completes: |s| ≤ ½ bounds the conditioning.
    pub(crate) fn periodic(&self) -> Size {
        let slope = self.wave.steepest();
        Size { largest: self.bound(0.0), slope, conditioning: 0.5 * slope, unit: self.size.unit }
    }

    /// Whether it is met in part.
    pub(crate) fn is_arc(&self) -> bool {
        self.arc != Arc::WHOLE
    }

    /// How much of the phase a unit of its variable is.
    pub(crate) fn stretch(&self) -> f64 {
        self.arc.stretch.hi
    }

    /// About the largest magnitude in an arc: an angle's is that at one of its ends, or at a turning point between them.
    pub(crate) fn largest_met(&self) -> Option<Double> {
        let at = |sigma: f64| self.at(Double::new(sigma)).abs();
        let of_anchor = self.arc.anchor().map_or(Double::ZERO, at);
        let larger = |a: Double, b: Double| if (a - b).hi < 0.0 { b } else { a };
        self.is_arc().then(|| [at(-0.5), at(0.5), of_anchor].into_iter().fold(at(0.0), larger))
    }

    /// The mirror image.
    pub(crate) fn negated(self) -> Self {
        Self { wave: self.wave.negated(), ..self }
    }

    /// As large as a position, which an error of the phase changes by as much as this, the angle.
    pub(crate) fn into_position(mut self) -> Self {
        self.size.largest = 1.0;
        self
    }

    /// The sum of the first terms of its series.
    pub(crate) fn first(self, terms: usize) -> Self {
        Self { wave: self.wave.first(terms), pulses: None, rises: false, ..self }
    }

    /// What the series' omitted terms can change, and what it strays by.
    pub(crate) fn omitted(&self) -> f64 {
        self.wave.omitted()
    }

    /// What they can change of the derivative with respect to the phase.
    pub(crate) fn omitted_slope(&self) -> f64 {
        self.wave.omitted_slope()
    }

    /// What a value is rounded by.
    pub(crate) fn sampling_error(&self) -> f64 {
        self.wave.sampling_error()
    }

    /// Stands for another curve, from which it strays by at most that.
    pub(crate) fn stray(&mut self, by: f64) {
        self.wave.stray(by);
    }

    #[cfg(test)]
    pub(crate) fn pulses(&self) -> Option<Pulses> {
        self.pulses
    }

    /// As if that had been omitted.
    #[cfg(test)]
    pub(crate) fn omitting(mut self, omitted: f64) -> Self {
        self.stray(omitted - self.omitted());
        self
    }

    /// (m, aₘ) of the terms of its series.
    pub(crate) fn terms(&self) -> &[(u32, Double)] {
        self.wave.terms()
    }

    /// Σ wₙ cos((2n−1)πs).
    pub(crate) fn harmonics(weights: &[Double]) -> Self {
        Self { wave: Wave::harmonics(weights), ..Self::sine() }
    }

    /// sin πs.
    pub(crate) fn sine() -> Self {
        let steepest = std::f64::consts::PI;
        let size = Size { largest: 1.0, slope: steepest, conditioning: steepest, unit: 1.0 };
        Self { wave: Wave::sine(), pulses: None, arc: Arc::WHOLE, alternates: true, rises: false, size }
    }
}

/// The functions of the phase that outputs are made of.
pub(crate) trait Curves {
    /// θ, or what it has beside uniform turns.
    fn angle(&self) -> Curve;
    fn velocity(&self) -> Curve;
    fn acceleration(&self) -> Curve;
    /// sin(θ/2) and cos(θ/2), or, of the angle from the top, cos and −sin of its half. What an error of the phase does
    /// to a position is known from the angle.
    fn half_sine(&self) -> Curve;
    fn half_cosine(&self) -> Curve;
}

#[cfg(test)]
mod tests;
