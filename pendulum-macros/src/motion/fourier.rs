//! The Fourier series of k sn(u; k) = sin(θ/2), the paper's Eq. 22.

use super::{Elliptic, Swing};
use crate::exact::Real;
use pendulum_runtime::double::Double;
use std::iter;

/// What is said where no useful number of terms is without overshoot.
pub(crate) const ALWAYS_OVERSHOOTS: &str = "`fourier` can't come near the motion at this amplitude: with as many terms as \
                                            can be used the argument of the arcsine in Eq. 22 still exceeds 1; leave \
                                            `method` out";

impl Swing {
    /// The first `terms` of b₂ₙ₋₁ of Eq. 22, the coefficient of sin((2n−1)πu/2K) in the Fourier series of sn(u; k):
    /// (2π/kK) q^{n−1/2}/(1 − q^{2n−1}), for n ≥ 1.
    pub(crate) fn fourier_coefficients(&self, terms: usize) -> Vec<Real> {
        let Elliptic { modulus, quarter, nome, .. } = &self.elliptic;
        let context = nome.context();
        let factor = context.pi().scale(1) / (modulus * quarter);
        let powers = iter::successors(Some(nome.sqrt()), |power| Some(power * nome));
        powers.take(terms).map(|power| &factor * &power / (context.integer(1) - power.square())).collect()
    }

    /// (−1)ⁿ⁻¹ k b₂ₙ₋₁, of cos((2n−1)πs) in k sn(u + K), given the b₂ₙ₋₁ from n = 1 on.
    pub(crate) fn half_sine_weights(&self, coefficients: &[Real]) -> Vec<Double> {
        let weight = |(index, b): (usize, &Real)| {
            let weight = (b * &self.elliptic.modulus).to_double();
            if index % 2 == 1 { -weight } else { weight }
        };
        coefficients.iter().enumerate().map(weight).collect()
    }

    /// The smallest n after which all other terms together are at most half a unit in the last place of a sum in [½, 1),
    /// `unit` being half the distance from 1 to the next number: adding them can't bring the computed sum nearer than its
    /// own rounding leaves it.
    ///
    /// b₂ₙ₊₁/b₂ₙ₋₁ = q(1 − q^{2n−1})/(1 − q^{2n+1}) < q, so the tail Σ_{m>n} b₂ₘ₋₁ is below b₂ₙ₊₁/(1 − q).
    pub(crate) fn most_useful_terms(&self, unit: f64) -> usize {
        let half_ulp = unit / 2.0;
        let q = self.elliptic.nome.to_f64();
        // b₁ is within [1, 4/π] at every amplitude; from here on the ratio alone, which can't underflow too early.
        let mut term = self.fourier_coefficients(1)[0].to_f64();
        let mut odd_power = q;
        let mut n = 0;
        loop {
            n += 1;
            let next_power = odd_power * q * q;
            term *= q * (1.0 - odd_power) / (1.0 - next_power);
            odd_power = next_power;
            if term <= half_ulp * (1.0 - q) {
                return n;
            }
        }
    }

    /// The smallest number of terms without overshoot, `None` if there is none among those that are useful.
    ///
    /// Those leave a tail that swings by a tenth of half a unit in the last place of 1, at least, and near the turning
    /// point 1 − x² is k′² and twice the tail: where k′² is far less no number needs to be tried (and all would take long).
    pub(crate) fn smallest_working_terms(&self, unit: f64) -> Option<usize> {
        if self.elliptic.complementary.square().to_f64() < unit / 128.0 {
            return None;
        }
        let smallest = self.elliptic.fourier_analysis().smallest_working();
        (smallest <= self.most_useful_terms(unit)).then_some(smallest)
    }
}
