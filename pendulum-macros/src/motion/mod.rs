//! The exact motion: regime, modulus, quarter periods, nome, period and launch phase, in more than double precision.

mod elliptic;
mod fourier;
mod launch;

use crate::exact::Real;
pub(crate) use elliptic::Elliptic;
pub(crate) use fourier::ALWAYS_OVERSHOOTS;
use launch::State;

/// One solution of θ̈ + ω² sin θ = 0.
#[derive(Clone, Debug)]
pub(crate) struct Motion {
    pub(crate) regime: Regime,
    /// θ and θ̇ at t = 0, as given.
    pub(crate) theta0: Real,
    pub(crate) velocity0: Real,
    /// The rate ω of small oscillations.
    pub(crate) omega: Real,
}

/// What kind of motion it is.
#[derive(Clone, Debug)]
pub(crate) enum Regime {
    Swing(Swing),
    Separatrix(Separatrix),
    Rotation(Rotation),
}

/// Libration between ±amplitude.
#[derive(Clone, Debug)]
pub(crate) struct Swing {
    /// The turning angle, 0 < amplitude < π.
    pub(crate) amplitude: Real,
    /// Set where θ(t) is the mirror image of the motion described: the result's sign is flipped.
    pub(crate) mirrored: bool,
    /// Phase at t = 0 in half periods after the positive turning point (of the motion before mirroring), in [−½, ½];
    /// exactly zero when released from rest, otherwise θ(0) of the unmirrored motion is ≥ 0.
    pub(crate) launch: Real,
    pub(crate) elliptic: Elliptic,
    /// T = 4K/ω.
    pub(crate) period: Real,
}

/// Over the top, again and again.
#[derive(Clone, Debug)]
pub(crate) struct Rotation {
    /// Set where θ decreases: the result's sign is flipped.
    pub(crate) mirrored: bool,
    /// Phase at t = 0 in turns after the lowest point, in [−½, ½], of the unmirrored motion.
    pub(crate) launch: Real,
    /// κ = 2ω/|velocity at the lowest point| and what follows from it.
    pub(crate) elliptic: Elliptic,
    /// |θ̇| at the lowest point.
    pub(crate) fastest: Real,
    /// |θ̇| at the top.
    pub(crate) slowest: Real,
    /// The time of one turn, 4K(κ)/fastest.
    pub(crate) period: Real,
}

/// Towards the top for ever, never reaching it: θ = 4 atan tanh(ω(t − t₀)/2).
#[derive(Clone, Debug)]
pub(crate) struct Separatrix {
    /// Set where θ decreases: the result's sign is flipped.
    pub(crate) mirrored: bool,
    /// ω·(time since the lowest point) at t = 0, of the unmirrored motion.
    pub(crate) launch: Real,
}

/// Why a state is not the start of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoMotion {
    /// Hanging straight down, at rest.
    Hanging,
    /// Standing on the top, at rest.
    Balanced,
    /// The angle is π or more at rest, or more than π in motion.
    BeyondTop,
}

impl Motion {
    /// The motion through θ = `theta0`, θ̇ = `velocity0` at t = 0, for `omega` > 0.
    ///
    /// Released from rest |θ0| < π; in motion |θ0| = π, a passage over the top, is a state like any other.
    /// The regime is decided by k² = sin²(θ0/2) + (v0/2ω)² against 1, up to the resolution of the working precision.
    pub(crate) fn solve(theta0: &Real, velocity0: &Real, omega: &Real) -> Result<Self, NoMotion> {
        let state = State::new(theta0, velocity0, omega)?;
        let rate = omega.clone().settled();
        let regime = match state.excess() {
            Some(excess) if excess.is_negative() => Regime::Swing(Swing::through(&state, &-excess, &rate)),
            Some(excess) => Regime::Rotation(Rotation::through(&state, &excess, &rate)),
            None => Regime::Separatrix(Separatrix { mirrored: state.mirrored, launch: state.separatrix_phase() }),
        };
        Ok(Self { regime, theta0: theta0.clone(), velocity0: velocity0.clone(), omega: omega.clone() })
    }

    /// |θ̇| at the lowest point, the largest there is: 2kω of a swing, of which the separatrix is the limit.
    pub(crate) fn fastest(&self) -> Real {
        match &self.regime {
            Regime::Swing(swing) => (&swing.elliptic.modulus * &self.omega).scale(1),
            Regime::Rotation(rotation) => rotation.fastest.clone(),
            Regime::Separatrix(_) => self.omega.scale(1),
        }
    }

    /// 2⁵³ periods, the longest horizon: beyond it neighbouring `f64` times are periods apart. The separatrix has none.
    pub(crate) fn longest_horizon(&self) -> Option<Real> {
        self.period().map(|period| period.scale(53))
    }

    /// The time of one swing to and fro, or of one turn; the separatrix has none.
    pub(crate) const fn period(&self) -> Option<&Real> {
        match &self.regime {
            Regime::Swing(swing) => Some(&swing.period),
            Regime::Rotation(rotation) => Some(&rotation.period),
            Regime::Separatrix(_) => None,
        }
    }

    /// How many leading bits cancel in k′², or in k² − 1: the working precision has to exceed what is wanted of the
    /// results by as much. Everything that separates the regimes has cancelled on the separatrix.
    pub(crate) fn cancelled_bits(&self) -> usize {
        let gap = match &self.regime {
            // Released from rest, k′ itself comes from π − θ0; otherwise its square from a difference of squares.
            Regime::Swing(swing) if self.velocity0.is_zero() => -swing.elliptic.complementary.exponent_above(),
            Regime::Swing(swing) => -2 * swing.elliptic.complementary.exponent_above(),
            Regime::Rotation(rotation) => -2 * rotation.elliptic.complementary.exponent_above(),
            Regime::Separatrix(_) => return usize::MAX,
        };
        usize::try_from(gap).unwrap_or(0)
    }
}

/// −1 for a mirror image.
pub(crate) fn direction(mirrored: bool) -> f64 {
    if mirrored { -1.0 } else { 1.0 }
}

impl Swing {
    /// Half periods a unit of time, 2/T.
    pub(crate) fn rate(&self) -> Real {
        self.period.context().integer(2) / &self.period
    }

    /// The swing through `state`, k′² being cos²(θ0/2) − (v0/2ω)².
    fn through(state: &State, complementary_squared: &Real, omega: &Real) -> Self {
        let context = omega.context();
        let released = state.speed.is_zero();
        let (modulus, complementary) = if released {
            (state.sine.clone(), state.cosine.clone())
        } else {
            ((state.sine.square() + state.speed.square()).sqrt(), complementary_squared.sqrt())
        };
        let amplitude = if released { state.angle.clone() } else { modulus.atan2(&complementary).scale(1) };
        let elliptic = Elliptic::new(modulus, complementary);
        let launch = if released { context.integer(0) } else { state.swing_phase(&elliptic) };
        let period = elliptic.quarter.scale(2) / omega;
        Self { amplitude, mirrored: state.mirrored, launch, elliptic, period }
    }
}

impl Rotation {
    /// Turns a unit of time, 1/T.
    pub(crate) fn rate(&self) -> Real {
        self.period.context().integer(1) / &self.period
    }

    /// The rotation through `state`, `excess` being (v0/2ω)² − cos²(θ0/2) > 0.
    fn through(state: &State, excess: &Real, omega: &Real) -> Self {
        // (|θ̇| at the bottom / 2ω)², and κ = 2ω/|θ̇|, κ′² = 1 − κ² = excess/that.
        let lowest = (state.speed.square() + state.sine.square()).sqrt();
        let context = omega.context();
        let top = excess.sqrt();
        let elliptic = Elliptic::new(context.integer(1) / &lowest, &top / &lowest);
        let fastest = (omega * &lowest).scale(1);
        let slowest = (omega * &top).scale(1);
        let launch = state.rotation_phase(&elliptic, &lowest);
        let period = elliptic.quarter.scale(2) / &fastest;
        Self { mirrored: state.mirrored, launch, elliptic, fastest, slowest, period }
    }
}

#[cfg(test)]
mod tests;
