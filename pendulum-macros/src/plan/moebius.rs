//! A change of variable that moves a singularity away: P = p(¼ + b)/(p + b), which maps [0, ¼] to itself.
//!
//! The point −b goes to infinity, what is next to it goes far away, and a polynomial in P needs fewer terms for it than
//! one in p (a conformal map, Trefethen, *Approximation Theory and Approximation Practice*, chapter 22, in its simplest
//! form). It costs a division, an addition and a subtraction: P = (¼ + b) − b(¼ + b)/(p + b).

use crate::power::power;
use crate::program::rounding::INFLATION;
use crate::supremum::worst;
use pendulum_runtime::double::Double;

/// Given by b from 2⁻⁷ on, of 24 bits, so that ¼ + b and b(¼ + b) are exact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moebius {
    pub(crate) place: f64,
}

impl Moebius {
    pub(crate) fn new(place: f64) -> Self {
        Self { place: f64::from(place as f32) }
    }

    /// ¼ + b.
    pub(crate) fn end(self) -> f64 {
        0.25 + self.place
    }

    /// b(¼ + b).
    pub(crate) fn scale(self) -> f64 {
        self.place * self.end()
    }

    /// Bounds P up to p.
    pub(crate) fn farthest(self, p: f64) -> f64 {
        p * self.end() / (p + self.place) * INFLATION
    }

    /// p, given P.
    pub(crate) fn inverse(self, image: Double) -> Double {
        image * self.place / (Double::new(self.end()) - image)
    }

    /// Bounds |Im √p| where P lies on the ellipse with foci 0 and ¼ and parameter ρ; `None` where that reaches ∞.
    ///
    /// Without a map √p = ½ cos φ with |Im φ| = ½ ln ρ. With one, p + b = b(¼ + b)/d and d = ¼ + b − P. In a slice of
    /// the ellipse the real part of d is between two numbers and the imaginary one at most `widest`: hence bounds of
    /// −Re p and |Im p|, and 2(Im √p)² = |p| − Re p.
    pub(crate) fn height(map: Option<Self>, rho: f64) -> Option<f64> {
        const SLICES: u32 = 24;
        let Some(map) = map else { return Some(0.5 * libm::sinh(0.5 * libm::log(rho))) };
        let (along, across) = ((rho + 1.0 / rho) / 16.0, (rho - 1.0 / rho) / 16.0);
        let cosine = |slice: u32| 2.0 * f64::from(slice) / f64::from(SLICES) - 1.0;
        let square = |slice: u32| {
            let ends = [cosine(slice), cosine(slice + 1)];
            let [least, most] = ends.map(|cosine| map.end() - 0.125 + along * cosine);
            let widest = across * (1.0 - power(ends[0].abs().min(ends[1].abs()), 2)).sqrt();
            let left = map.place - map.scale() * most / (most * most + widest * widest);
            let aside = map.scale() * widest / (least * least);
            (least > widest).then(|| 0.5 * (libm::hypot(left, aside) + left))
        };
        let squares: Option<Vec<f64>> = (0..SLICES).map(square).collect();
        Some(worst(squares?).sqrt() * INFLATION)
    }

    /// For the reader; s is the phase in half periods.
    pub(crate) fn describe(self) -> String {
        format!("s²·{:.4}/(s² + {:.4})", self.end(), self.place)
    }
}
