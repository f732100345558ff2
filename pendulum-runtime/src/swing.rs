//! The shape of a swing: θ and θ̇ as functions of the phase, for amplitudes from 0 up to the last `f64` below π.
//!
//! Theta quotients (DLMF 20, and the half-nome pair S, C of the crate documentation) with everything written in terms
//! of one sine or one exponential. With w = 2πz, z the phase in turns since the angle last passed zero,
//!
//! * direct, √q ≤ ½: tan(θ/4) = sin w · N(η)/D(η), in powers of √q, η = 4 sin² w;
//! * dual, nearer to the top: tan(θ/4) = tanh X · N(η)/D(η), η = −4 sinh² X, X = πKz/K′.
//!
//! N and D have at most four coefficients for 2⁻⁵³, and the velocity's five and six, because the weights fall as
//! q^(n²/2).

use crate::agm::{agm, sqrt_nome};
use crate::double::Double;
use crate::kernel::{double_angle, four_atan, horner, sin_turns};
use crate::phase::Reduced;
use crate::theta_polynomial::Harmonics::{OddCosine, OddSine};
use crate::theta_polynomial::{after_first, theta1_weight, theta2_weight};
use crate::theta_polynomial::{jacobi_theta1, jacobi_theta2, jacobi_theta3, jacobi_theta4};
use crate::theta_quotient::{sech_quotient, sinh_quotient, tanh_quotient};

/// k′ above which the direct series serve: √q = ½ at k′ = 0.1134.
const DIRECT_FROM: f64 = 0.12;

/// 2/ln 2, so that e^{2X} = 2^{(2/ln 2) X}.
const TWO_BY_LN_2: f64 = 2.0 * core::f64::consts::LOG2_E;

/// Where in a swing: all that is evaluated at.
#[derive(Clone, Copy)]
pub(crate) struct SwingPhase {
    /// Turns since (before) the last (next) passage through zero, positive while the angle is; in [−¼, ¼].
    crossing: f64,
    /// Turns to the nearest turning point, in [0, ¼].
    turning: f64,
    /// +1 while the angle grows.
    growing: f64,
}

impl SwingPhase {
    /// From the phase since the positive turning point.
    #[inline]
    pub(crate) fn new(phase: Reduced) -> Self {
        let (turning, crossing) = phase.folded();
        Self {
            crossing,
            turning: if turning < 0.0 { 0.0 } else { turning }, // keeps NaN
            growing: if phase.high < 0.0 { 1.0 } else { -1.0 },
        }
    }

    /// Turns from the zero crossing, signed like the angle.
    #[inline]
    pub(crate) fn crossing(&self) -> f64 {
        self.crossing
    }

    /// `z` turns after the passage through zero, 0 ≤ z ≤ ¼.
    pub(crate) fn at_crossing(z: f64) -> Self {
        Self { crossing: z, turning: 0.25 - z, growing: 1.0 }
    }
}

/// The shape of a swing of one amplitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Swing {
    /// Nothing returned exceeds it.
    amplitude: f64,
    /// Scales the velocity's quotient to 1 at the zero crossing.
    rate: f64,
    series: Series,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Series {
    Direct { angle: ([f64; 4], [f64; 4]), rate: ([f64; 5], [f64; 6]) },
    Dual { growth: f64, angle: ([f64; 4], [f64; 4]), rate: DualRate },
}

/// cn = ϑ₄/ϑ₂ about the zero crossing and ϑ₁/ϑ₃ about the turning point, each used on its half of the quarter swing:
/// the first would cancel at the turning point, the second would turn the rounding of a large exponent into an error
/// where the motion is steep.
#[derive(Clone, Copy, Debug, PartialEq)]
struct DualRate {
    crossing: ([f64; 3], [f64; 3]),
    turning: ([f64; 3], [f64; 3]),
    /// Scales the second to the first where they meet.
    joint: f64,
}

impl Swing {
    /// From k = sin(θ0/2), k′ = cos(θ0/2), AGM(1, k′) and the amplitude θ0.
    pub(crate) fn new(k: Double, kc: Double, mean: f64, amplitude: f64) -> Self {
        let series = if kc.hi >= DIRECT_FROM { direct(k, kc) } else { dual(k.hi, kc.hi, mean) };
        let mut swing = Self { amplitude, rate: 1.0, series };
        swing.rate = 1.0 / swing.series.rate(SwingPhase::at_crossing(0.0));
        swing
    }

    /// θ.
    #[inline]
    pub(crate) fn angle(&self, at: SwingPhase) -> f64 {
        let (n, d) = self.quarter_tangent(at.crossing.abs());
        let angle = four_atan(n, d);
        // Exactly θ0 at the turning point, never more anywhere.
        let turning = at.crossing.abs() == 0.25;
        let angle = if turning || angle > self.amplitude { self.amplitude } else { angle };
        if at.crossing < 0.0 { -angle } else { angle }
    }

    /// (sin(θ/2), cos(θ/2)).
    #[inline]
    pub(crate) fn half_angle(&self, at: SwingPhase) -> (f64, f64) {
        let (n, d) = self.quarter_tangent(at.crossing.abs());
        let (sine, cosine) = double_angle(n, d);
        (if at.crossing < 0.0 { -sine } else { sine }, cosine)
    }

    /// θ̇ in units of its largest value.
    #[inline]
    pub(crate) fn velocity(&self, at: SwingPhase) -> f64 {
        let rate = self.rate * self.series.rate(at);
        at.growing * (if rate > 1.0 { 1.0 } else { rate })
    }

    /// (n, d) with n/d = tan(θ/4) at 0 ≤ z ≤ ¼.
    #[inline]
    fn quarter_tangent(&self, z: f64) -> (f64, f64) {
        match &self.series {
            Series::Direct { angle: (n, d), .. } => {
                let m = sin_turns(z);
                let eta = 4.0 * (m * m);
                (m * horner(n, eta), horner(d, eta))
            }
            Series::Dual { growth, angle, .. } => tanh_quotient(growth * z, angle),
        }
    }
}

impl Series {
    /// A multiple of |θ̇|, by cn(K − u) as a quotient of theta functions that vanishes exactly at the turning point.
    #[inline]
    fn rate(&self, at: SwingPhase) -> f64 {
        match self {
            Self::Direct { rate: (n, d), .. } => {
                // A sine each: sin² w as 1 − cos² w would magnify the rounding of the cosine fivefold.
                let (cosine, sine) = (sin_turns(at.turning), sin_turns(at.crossing.abs()));
                let eta = 4.0 * (sine * sine);
                cosine * horner(n, eta) / horner(d, eta)
            }
            Self::Dual { growth, rate, .. } if at.turning > 0.125 => {
                let (n, d) = sech_quotient(growth * at.crossing.abs(), &rate.crossing);
                n / d
            }
            Self::Dual { growth, rate, .. } => {
                let (n, d) = sinh_quotient(growth * at.turning, &rate.turning);
                rate.joint * n / d
            }
        }
    }
}

/// The direct series, normalised to D(0) = 1 and, in two words, to tan(θ0/4) = k/(1 + k′) at the turning point: the
/// error of the nome touches only the small corrections, and the amplitude carries one rounding.
fn direct(k: Double, kc: Double) -> Series {
    let h = sqrt_nome(k.hi, kc.hi);
    let q = h * h;
    let (mut numerator, mut denominator): ([f64; 4], [f64; 4]) = (jacobi_theta1(q * q), jacobi_theta4(q * q));
    let constant = denominator[0];
    for c in &mut denominator {
        *c /= constant;
    }
    let at_turn = |c: &[f64; 4]| c.iter().rev().fold(Double::ZERO, |sum, &c| sum.scale(4.0) + Double::new(c));
    let scale = k * at_turn(&denominator) / ((Double::ONE + kc) * at_turn(&numerator));
    for c in &mut numerator {
        *c = (scale * *c).to_f64();
    }
    Series::Direct { angle: (numerator, denominator), rate: (jacobi_theta2(q), jacobi_theta4(q)) }
}

/// The dual series, in p = √q′; `angle` lacks the 1 of either ([`tanh_quotient`]).
fn dual(k: f64, kc: f64, mean: f64) -> Series {
    let p = sqrt_nome(kc, k);
    let qc = p * p;
    let growth = core::f64::consts::PI * TWO_BY_LN_2 * (agm(k) / mean);
    let angle = (after_first(OddSine, theta1_weight(p)), after_first(OddCosine, theta2_weight(p)));
    let rate = DualRate {
        crossing: (jacobi_theta4(qc), jacobi_theta2(qc)),
        turning: (jacobi_theta1(qc), jacobi_theta3(qc)),
        joint: 1.0,
    };
    let at_joint = |rate: DualRate, turning: f64| {
        Series::Dual { growth, angle, rate }.rate(SwingPhase { crossing: 0.125, turning, growing: 1.0 })
    };
    let joint = at_joint(rate, 0.125_f64.next_up()) / at_joint(rate, 0.125);
    Series::Dual { growth, angle, rate: DualRate { joint, ..rate } }
}
