//! Elliptic integrals and functions in `f64`, by modulus k or (module [`complementary`]) by k′ = √(1 − k²).
//!
//! Packaged libraries take the modulus k or the parameter m = k² and lose what distinguishes k from 1; here k near 1 is
//! best given by its complement, k′ = cos(θ0/2) for a pendulum of amplitude θ0. Either may be 0, or as small as 10⁻²⁹⁰.
//! Outside the domain 0 ≤ k ≤ 1 everything is NaN. u may be any finite number: periods are reduced in two words.
//!
//! | | error at most |
//! |---|---|
//! | K, K′, q, F | 1 ulp (of q below 10⁻³⁰⁷ 1.5) |
//! | sn, dn | 6 · 2⁻⁵³ for \|u\| up to 2⁴⁵ K; sn also 8 · 2⁻⁵³ \|sn\| near u = 0, down to 10⁻²⁹⁰ |
//! | cn | 9 · 2⁻⁵³ for \|u\| up to 2⁴⁵ K, the most where it vanishes |
//! | am | 6 · 2⁻⁵³ max(1, \|am\|); also 8 · 2⁻⁵³ \|am\| near u = 0, down to 10⁻²⁹⁰ |
//!
//! ```
//! # use pendulum_runtime as pendula;
//! use pendula::elliptic::{self, complementary};
//! let k = 0.8;
//! let u = elliptic::quarter_period(k) / 3.0;
//! let (sn, cn) = (elliptic::sn(u, k), elliptic::cn(u, k));
//! assert!((sn * sn + cn * cn - 1.0).abs() < 1e-15);
//! assert!((elliptic::sn(u, k) - complementary::sn(u, 0.6)).abs() < 1e-15);
//! assert!((elliptic::incomplete(elliptic::am(u, k), k) - u).abs() < 1e-15);
//! ```

use crate::agm::{agm_double, complete};
use crate::angle::{nearest_period, reduce};
use crate::carlson::carlson_rf;
use crate::double::{Double, LARGEST};
use crate::double_trig::half_angle;
use crate::kernel::two_to;
use crate::nome::nome_of;
use crate::phase::{Phase, Reduced, is_odd};
use crate::rotation::Rotation;
use core::f64::consts::PI;

/// Scales the quotient of the largest φ so that it isn't split beyond 2⁹⁹⁶.
const SMALL: f64 = two_to(-64);

/// One modulus, prepared for repeated evaluation of the functions of Jacobi: about as much work as
/// [`Pendulum::from_state`](crate::Pendulum::from_state) once, then a few dozen nanoseconds per value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobi {
    k: Double,
    kc: Double,
    rotation: Rotation,
    /// One turn of θ = 2 am per 2K; `None` for k = 1, which has no period.
    phase: Option<Phase>,
}

impl Jacobi {
    /// From k in [0, 1]; `None` outside and for NaN.
    #[must_use]
    pub fn from_modulus(k: f64) -> Option<Self> {
        (0.0..=1.0).contains(&k).then(|| Self::new(Double::new(k), complement(k)))
    }

    /// From k′ in [0, 1]; `None` outside and for NaN.
    #[must_use]
    pub fn from_complementary_modulus(kc: f64) -> Option<Self> {
        (0.0..=1.0).contains(&kc).then(|| Self::new(complement(kc), Double::new(kc)))
    }

    fn new(k: Double, kc: Double) -> Self {
        if kc.hi == 0.0 {
            return Self { k, kc, rotation: Rotation::separatrix(), phase: None };
        }
        let mean = agm_double(kc);
        let phase = Phase::new(mean / Double::PI, 1.0, Double::ZERO);
        Self { k, kc, rotation: Rotation::new(k.hi, kc.hi, mean.hi), phase: Some(phase) }
    }

    fn reduce(&self, u: f64) -> Reduced {
        match &self.phase {
            Some(phase) => phase.reduce(u),
            None if u.is_finite() => Reduced { turns: 0.0, high: u, low: 0.0 },
            None => Reduced { turns: 0.0, high: f64::NAN, low: f64::NAN },
        }
    }

    /// (sn u, cn u, dn u), the first two in [−1, 1], the last in [k′, 1]. NaN for NaN and ±∞.
    #[must_use]
    pub fn sn_cn_dn(&self, u: f64) -> (f64, f64, f64) {
        if u == 0.0 {
            return (u, 1.0, 1.0); // of either sign
        }
        let phase = self.reduce(u);
        let (sine, cosine) = self.rotation.half_angle(phase);
        // Each turn of θ = 2 am changes the sign of sn and cn.
        let sign = if is_odd(phase.turns) { -1.0 } else { 1.0 };
        let [sn, cn] = [sine, cosine].map(|x| (sign * x).clamp(-1.0, 1.0));
        let dn = self.rotation.velocity(phase);
        (sn, cn, if dn < self.kc.hi { self.kc.hi } else { dn }) // keeps NaN
    }

    /// The amplitude am u, rad, continuous in u: the angle whose sine is sn u, within the finite numbers. NaN for NaN and
    /// ±∞.
    #[must_use]
    pub fn am(&self, u: f64) -> f64 {
        if u == 0.0 {
            return u;
        }
        let phase = self.reduce(u);
        if phase.turns.abs() > LARGEST {
            // What is left of a turn is nothing beside so many.
            return (PI * phase.turns).clamp(f64::MIN, f64::MAX);
        }
        (Double::PI * phase.turns + Double::new(0.5 * self.rotation.angle(phase))).to_f64()
    }

    /// K, the quarter period of sn (∞ for k = 1).
    #[must_use]
    pub fn quarter_period(&self) -> f64 {
        complete(self.kc)
    }

    /// K′ = K(k′) (∞ for k = 0).
    #[must_use]
    pub fn complementary_quarter_period(&self) -> f64 {
        complete(self.k)
    }

    /// q = exp(−πK′/K).
    #[must_use]
    pub fn nome(&self) -> f64 {
        nome_of(self.k, self.kc)
    }

    /// F(φ, k) = ∫₀^φ dψ/√(1 − k² sin² ψ), φ in rad, odd and increasing in φ; inverse to [`am`](Self::am). NaN for NaN and
    /// ±∞; ±∞ from |φ| = π/2 on for k = 1.
    #[must_use]
    pub fn incomplete(&self, phi: f64) -> f64 {
        if !phi.is_finite() {
            return f64::NAN;
        }
        if phi == 0.0 {
            return phi;
        }
        let (_, rest) = nearest_period(reduce(phi).angle, Double::PI);
        let partial = if rest.hi < 0.0 { -self.partial(-rest) } else { self.partial(rest) };
        // nπ, during which F grows by 2nK = nπ/AGM(1, k′).
        let halves = Double::new(phi) - rest;
        if halves.hi == 0.0 {
            partial.to_f64()
        } else if self.kc.hi == 0.0 {
            halves.hi * f64::INFINITY
        } else {
            let whole = halves.scale(SMALL) / agm_double(self.kc);
            (partial.scale(SMALL) + whole).to_f64() / SMALL
        }
    }

    /// F for 0 ≤ φ ≤ π/2: sin φ · RF(cos² φ, 1 − k² sin² φ, 1), the second argument as cos² φ + k′² sin² φ.
    fn partial(&self, phi: Double) -> Double {
        let (sine, cosine) = half_angle(phi.scale(2.0));
        let scaled = self.kc * sine;
        sine * carlson_rf(cosine * cosine, cosine * cosine + scaled * scaled, Double::ONE)
    }
}

/// √(1 − x²) for 0 ≤ x ≤ 1, with small relative error.
fn complement(x: f64) -> Double {
    (Double::from_sum(1.0, -x) * Double::from_sum(1.0, x)).sqrt()
}

/// The functions by one constructor, so that both modules say the same.
macro_rules! functions {
    ($constructor:ident, $modulus:ident, $name:literal) => {
        /// K, the complete integral of the first kind (∞ for k = 1).
        #[doc = concat!("`", $name, "` in [0, 1], else NaN.")]
        #[must_use]
        pub fn quarter_period($modulus: f64) -> f64 {
            Jacobi::$constructor($modulus).map_or(f64::NAN, |j| j.quarter_period())
        }

        /// K′, the complete integral of the complementary modulus (∞ for k = 0).
        #[doc = concat!("`", $name, "` in [0, 1], else NaN.")]
        #[must_use]
        pub fn complementary_quarter_period($modulus: f64) -> f64 {
            Jacobi::$constructor($modulus).map_or(f64::NAN, |j| j.complementary_quarter_period())
        }

        /// The nome q = exp(−πK′/K), from 0 (k = 0) to 1 (k = 1).
        #[doc = concat!("`", $name, "` in [0, 1], else NaN.")]
        #[must_use]
        pub fn nome($modulus: f64) -> f64 {
            Jacobi::$constructor($modulus).map_or(f64::NAN, |j| j.nome())
        }

        /// sn(u; k), odd, of period 4K (tanh u for k = 1). NaN unless u is finite.
        #[doc = concat!("`", $name, "` in [0, 1], else NaN.")]
        #[must_use]
        pub fn sn(u: f64, $modulus: f64) -> f64 {
            Jacobi::$constructor($modulus).map_or(f64::NAN, |j| j.sn_cn_dn(u).0)
        }

        /// cn(u; k), even, of period 4K (sech u for k = 1). NaN unless u is finite.
        #[doc = concat!("`", $name, "` in [0, 1], else NaN.")]
        #[must_use]
        pub fn cn(u: f64, $modulus: f64) -> f64 {
            Jacobi::$constructor($modulus).map_or(f64::NAN, |j| j.sn_cn_dn(u).1)
        }

        /// dn(u; k), even, of period 2K, between k′ and 1 (sech u for k = 1). NaN unless u is finite.
        #[doc = concat!("`", $name, "` in [0, 1], else NaN.")]
        #[must_use]
        pub fn dn(u: f64, $modulus: f64) -> f64 {
            Jacobi::$constructor($modulus).map_or(f64::NAN, |j| j.sn_cn_dn(u).2)
        }

        /// The amplitude am(u; k), rad, odd and increasing, with am(u + 2K) = am(u) + π. NaN unless u is finite.
        #[doc = concat!("`", $name, "` in [0, 1], else NaN.")]
        #[must_use]
        pub fn am(u: f64, $modulus: f64) -> f64 {
            Jacobi::$constructor($modulus).map_or(f64::NAN, |j| j.am(u))
        }

        /// F(φ, k), the incomplete integral of the first kind, for any finite φ in rad, else NaN (±∞ from |φ| = π/2 on for k = 1).
        #[doc = concat!("`", $name, "` in [0, 1], else NaN.")]
        #[must_use]
        pub fn incomplete(phi: f64, $modulus: f64) -> f64 {
            Jacobi::$constructor($modulus).map_or(f64::NAN, |j| j.incomplete(phi))
        }
    };
}

functions!(from_modulus, modulus, "modulus");

/// The same functions by the complementary modulus k′ = √(1 − k²): the form to use for k near 1.
pub mod complementary {
    use super::Jacobi;

    functions!(from_complementary_modulus, complementary_modulus, "complementary_modulus");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::power;

    /// The `f64` nearest to an odd multiple of K, and one beside it: there cn is k′ times what they miss, the next term
    /// of its series being less than 10⁻²⁴ for what is less than 10⁻⁸.
    #[test]
    fn cn_where_it_vanishes() {
        let mut worst = 0.0_f64;
        for i in 1..=20_000 {
            let kc = 0.5 * f64::from(i) / 20_000.0;
            let j = Jacobi::from_complementary_modulus(kc).expect("in [0, 1]");
            let quarter = Double::PI.scale(0.5) / agm_double(Double::new(kc));
            for n in 0..24 {
                let odd = power(2.0, n + 1) - 1.0;
                let exact = quarter * odd;
                for u in [exact.to_f64(), exact.to_f64().next_up()] {
                    let missed = (exact - Double::new(u)).to_f64();
                    // cn falls through zero at K, rises at 3K.
                    let falls = (odd - 1.0) % 4.0 == 0.0;
                    let cn = if falls { kc * missed } else { -kc * missed };
                    worst = worst.max((j.sn_cn_dn(u).1 - cn).abs());
                }
            }
        }
        assert!(worst <= 4.5 * f64::EPSILON, "{}", worst / f64::EPSILON);
    }
}
