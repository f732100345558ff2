//! The shape of a rotation, and of the separatrix as its limit: θ = 2 am(u; κ) with κ = 2ω/v0 < 1.
//!
//! With s the phase in turns since the last passage through the bottom, z = πs,
//!
//! * direct, q ≤ 1/10: θ = 2z + 4 atan(sin 2z · A(η)/B(η)), η = 4 sin² z;
//! * dual, nearer to the separatrix: tan(θ/4) = tanh X · N(η)/D(η), η = −4 sinh² X, X = πKs/(2K′); on the separatrix
//!   itself the series stop at their first terms and 2X = ωt.

use crate::agm::{agm_double, sqrt_nome};
use crate::double::Double;
use crate::kernel::{double_angle, four_atan, horner, power, sin_turns};
use crate::phase::Reduced;
use crate::theta_polynomial::Harmonics::{EvenCosine, EvenSine, OddCosine, OddSine};
use crate::theta_polynomial::{after_first, alternate, jacobi_theta2, jacobi_theta3, jacobi_theta4, polynomial};
use crate::theta_quotient::{sech_quotient, tanh_quotient};
use core::f64::consts::{LOG2_E, PI, TAU};

/// κ′ above which the direct series serve: q = 0.1 at κ′ = 0.4445.
const DIRECT_FROM: f64 = 0.45;

/// π/ln 2, in two words since the exponent that it is part of is rounded besides.
const PI_LOG2_E: Double = Double { hi: 4.532_360_141_827_194, lo: -3.458_117_459_229_868_6e-16 };

/// The shape of a rotation of one modulus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rotation {
    /// Scales the velocity's quotient to 1 at the bottom.
    rate: f64,
    series: Series,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Series {
    Direct { angle: ([f64; 3], [f64; 4]), rate: ([f64; 4], [f64; 4]) },
    Dual { growth: f64, angle: ([f64; 5], [f64; 5]), rate: ([f64; 5], [f64; 4]) },
}

impl Rotation {
    /// From κ, κ′ and AGM(1, κ′).
    pub(crate) fn new(k: f64, kc: f64, mean: f64) -> Self {
        if kc >= DIRECT_FROM {
            Self::normalised(direct(power(sqrt_nome(k, kc), 2)))
        } else {
            Self::normalised(dual(
                sqrt_nome(kc, k),
                (PI_LOG2_E * (agm_double(Double::new(k)) / Double::new(mean))).to_f64(),
            ))
        }
    }

    /// The separatrix; its "phase" is ωt itself, unreduced.
    pub(crate) fn separatrix() -> Self {
        Self::normalised(dual(0.0, LOG2_E))
    }

    fn normalised(series: Series) -> Self {
        let mut rotation = Self { rate: 1.0, series };
        rotation.rate = 1.0 / rotation.series.rate(0.0);
        rotation
    }

    /// θ less whole turns, in [−π, π].
    #[inline]
    pub(crate) fn angle(&self, phase: Reduced) -> f64 {
        let s = phase.high.abs();
        let angle = match &self.series {
            Series::Direct { angle, .. } => {
                let (n, d) = excess_tangent(half_turn_sines(phase), angle);
                TAU * s + four_atan(n, d)
            }
            Series::Dual { growth, angle, .. } => {
                let (n, d) = tanh_quotient(growth * s, angle);
                four_atan(n, d)
            }
        };
        let angle = if angle > PI { PI } else { angle };
        if phase.high < 0.0 { -angle } else { angle }
    }

    /// (sin(θ/2), cos(θ/2)) with θ in [−π, π].
    #[inline]
    pub(crate) fn half_angle(&self, phase: Reduced) -> (f64, f64) {
        let (sine, cosine) = match &self.series {
            Series::Direct { angle, .. } => {
                let (sine, cosine) = half_turn_sines(phase);
                let (n, d) = excess_tangent((sine, cosine), angle);
                let (s, c) = double_angle(n, d);
                (sine * c + cosine * s, cosine * c - sine * s)
            }
            Series::Dual { growth, angle, .. } => {
                let (n, d) = tanh_quotient(growth * phase.high.abs(), angle);
                double_angle(n, d)
            }
        };
        (if phase.high < 0.0 { -sine } else { sine }, cosine)
    }

    /// θ̇ in units of its largest value: dn(u; κ), a quotient of ϑ₃ and ϑ₄ (dual: ϑ₃ and ϑ₂), even and positive.
    #[inline]
    pub(crate) fn velocity(&self, phase: Reduced) -> f64 {
        let rate = self.rate * self.series.rate(phase.high.abs());
        if rate > 1.0 { 1.0 } else { rate }
    }
}

impl Series {
    /// A multiple of θ̇.
    #[inline]
    fn rate(&self, s: f64) -> f64 {
        match self {
            Self::Direct { rate: (n, d), .. } => {
                let sine = sin_turns(0.5 * s);
                let eta = 4.0 * (sine * sine);
                horner(n, eta) / horner(d, eta)
            }
            Self::Dual { growth, rate, .. } => {
                let (n, d) = sech_quotient(growth * s, rate);
                2.0 * n / d
            }
        }
    }
}

/// (sin πs, cos πs) for the magnitude of s.
#[inline]
fn half_turn_sines(phase: Reduced) -> (f64, f64) {
    let (s, low) = phase.magnitude();
    (sin_turns(0.5 * s), sin_turns((0.25 - 0.5 * s) - 0.5 * low))
}

/// (n, d) with n/d = tan(θ/4 − z/2), θ − 2z being what the rotation is ahead of a uniform one, from (sin z, cos z).
#[inline]
fn excess_tangent((sine, cosine): (f64, f64), (a, b): &([f64; 3], [f64; 4])) -> (f64, f64) {
    let eta = 4.0 * (sine * sine);
    (2.0 * (sine * cosine) * horner(a, eta), horner(b, eta))
}

/// The direct series of am (DLMF 22.16.9 summed) and dn.
fn direct(q: f64) -> Series {
    Series::Direct {
        angle: (
            polynomial(EvenSine, |j| {
                alternate(j) * (power(q, (j + 1) * (2 * j + 1)) - power(q, (j + 1) * (2 * j + 3)))
            }),
            polynomial(EvenCosine, |j| {
                if j == 0 { 1.0 } else { alternate(j) * (power(q, j * (2 * j - 1)) + power(q, j * (2 * j + 1))) }
            }),
        ),
        rate: (jacobi_theta3(q), jacobi_theta4(q)),
    }
}

/// The dual series, in p = √q′; `growth` is 2X/ln 2 per turn, and `angle` lacks the 1 of either ([`tanh_quotient`]).
fn dual(p: f64, growth: f64) -> Series {
    let qc = p * p;
    Series::Dual {
        growth,
        angle: (
            after_first(OddSine, |j| [1.0, 1.0, -1.0, -1.0][j as usize % 4] * power(p, j * (j + 1))),
            after_first(OddCosine, |j| [1.0, -1.0, -1.0, 1.0][j as usize % 4] * power(p, j * (j + 1))),
        ),
        rate: (jacobi_theta3(qc), jacobi_theta2(qc)),
    }
}
