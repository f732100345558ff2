//! The state at t = 0 and its phase on the orbit: incomplete elliptic integrals of the first kind.
//!
//! Everything is written in s = sin(θ0/2), c = cos(θ0/2) and w = |θ̇0|/2ω, in which energy is s² + w² (= k², or 1/κ² of
//! a rotation) and the distance from the separatrix is w² − c². The phases are Carlson integrals,
//!
//! - swing, back to or on from the turning point: `u = w·R_F(k²c², k²k′², k′²s²)`, since sin(am) of it is w/(kc);
//! - rotation, from the lowest point: `u = s·R_F(1, κ²w², c²)`, with κ′² = κ²(w² − c²),
//!
//! and Gauss' transformation (see [`amplitude_at_infinity`]) takes both to an arctangent in quadratically converging
//! steps without a subtraction, so the phase is accurate relative to itself at the turning point and at the lowest
//! point, and absolutely (to the working precision) everywhere.

use super::{Elliptic, NoMotion};
use crate::exact::Real;

/// θ and θ̇ at t = 0, mirrored if need be so that its conventional sign is positive.
pub(super) struct State {
    /// Whether signs were flipped: swings have θ0 ≥ 0 after it (and θ̇0 > 0 at θ0 = 0), everything else θ̇0 > 0.
    pub(super) mirrored: bool,
    /// |θ0|.
    pub(super) angle: Real,
    /// s = sin(|θ0|/2).
    pub(super) sine: Real,
    /// c = cos(|θ0|/2), ≥ 0.
    pub(super) cosine: Real,
    /// w = |θ̇0|/2ω.
    pub(super) speed: Real,
    /// Whether the pendulum moves away from the lowest point, θ0·θ̇0 ≥ 0.
    rising: bool,
    /// w² − c², `None` if it is zero.
    excess: Option<Real>,
}

impl State {
    pub(super) fn new(theta0: &Real, velocity0: &Real, omega: &Real) -> Result<Self, NoMotion> {
        let context = theta0.context();
        let angle = theta0.abs();
        let below_top = context.pi() - &angle;
        let at_top = below_top.abs() <= context.resolution();
        if below_top.is_negative() && !at_top {
            return Err(NoMotion::BeyondTop);
        }
        match (velocity0.is_zero(), theta0.is_zero()) {
            (true, true) => return Err(NoMotion::Hanging),
            (true, false) if at_top => return Err(NoMotion::Balanced),
            _ => {}
        }
        let zero = context.integer(0);
        let (sine, cosine) = if at_top {
            (context.integer(1), zero)
        } else if velocity0.is_zero() {
            // Nothing else is there to cancel with.
            half_angle(&angle.clone().settled(), &below_top.settled())
        } else {
            half_angle(&angle, &below_top)
        };
        let speed = (velocity0 / omega).abs().scale(-1);
        let rising = theta0.is_negative() == velocity0.is_negative() || theta0.is_zero();
        let (kinetic, needed) = (speed.square(), cosine.square());
        let difference = &kinetic - &needed;
        let resolved = difference.abs() > &kinetic * &context.resolution();
        let excess = resolved.then_some(difference);
        let swings = excess.as_ref().is_some_and(Real::is_negative);
        let mirrored = if swings && !theta0.is_zero() { theta0.is_negative() } else { velocity0.is_negative() };
        // All that cancels has cancelled when the state is known: what follows needs no digits that only told it from
        // others. What is emitted as it was given, an angle or ω, keeps them: rounded here first it would be rounded twice.
        let [sine, cosine, speed] = [sine, cosine, speed].map(Real::settled);
        Ok(Self { mirrored, angle, sine, cosine, speed, rising, excess: excess.map(Real::settled) })
    }

    /// w² − c²: negative for a swing, positive for a rotation, `None` on the separatrix.
    pub(super) fn excess(&self) -> Option<Real> {
        self.excess.clone()
    }

    /// Half periods after the positive turning point, in [−½, ½].
    pub(super) fn swing_phase(&self, elliptic: &Elliptic) -> Real {
        let (k, kc) = (&elliptic.modulus, &elliptic.complementary);
        let phase =
            amplitude_at_infinity([k * &self.cosine, k * kc, kc * &self.sine], [self.speed.clone(), kc * &self.speed])
                / self.sine.context().pi();
        if self.rising { -phase } else { phase }
    }

    /// Turns after the lowest point, in [−½, ½].
    pub(super) fn rotation_phase(&self, elliptic: &Elliptic, lowest: &Real) -> Real {
        let one = self.sine.context().integer(1);
        let phase = amplitude_at_infinity(
            [one, &self.speed / lowest, self.cosine.clone()],
            [self.sine.clone(), &elliptic.complementary * &self.sine],
        ) / self.sine.context().pi();
        if self.rising { phase } else { -phase }
    }

    /// ω × the time since the lowest point on the separatrix: sin(θ/2) = tanh(ωt), so ωt = ½ ln((1 + s)/(1 − s)),
    /// with 1 − s = c²/(1 + s).
    pub(super) fn separatrix_phase(&self) -> Real {
        let ratio = (&self.sine * &(&self.sine + &self.sine.context().integer(1))).scale(1) / self.cosine.square();
        let phase = ratio.ln_1p().scale(-1);
        if self.rising { phase } else { -phase }
    }
}

/// Sine and cosine of half an angle in [0, π), the smaller of the two from its own small argument and the other by
/// Pythagoras: one sine is evaluated, and neither loses digits at its zero.
fn half_angle(angle: &Real, below_top: &Real) -> (Real, Real) {
    let one = angle.context().integer(1);
    let lower = angle < below_top;
    let small = if lower { angle } else { below_top }.scale(-1).sin();
    let large = (one - small.square()).sqrt();
    if lower { (small, large) } else { (large, small) }
}

/// `(π/2K)·A·R_F(x², y², z²)` for z ≤ x, y, where A² = x² − z² and B² = y² − z² have B/A = k′: the phase angle πu/2K.
///
/// Gauss' transformation (DLMF 19.22.18) leaves `R_F` unchanged under
/// x ← (x + y)/2, y ← √((z² + xy + AB)/2), z ← zx/y (of the new x and y),
/// while A and B take one step of the arithmetic-geometric mean; at its limit M = A·AGM(1, k′) = πA/2K, x = y and
/// `R_F = R_C = atan(M/z)/M`, so that the result is atan(M/z). No step subtracts.
fn amplitude_at_infinity([mut x, mut y, mut z]: [Real; 3], [mut a, mut b]: [Real; 2]) -> Real {
    let tolerance = a.context().resolution();
    while (&a - &b).abs() > &a * &tolerance {
        let product = &a * &b;
        let next_x = (&x + &y).scale(-1);
        y = ((z.square() + &x * &y + &product).scale(-1)).sqrt();
        z = z * &next_x / &y;
        x = next_x;
        a = (&a + &b).scale(-1);
        b = product.sqrt();
    }
    a.atan2(&z)
}
