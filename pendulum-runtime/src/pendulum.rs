//! The public face of a motion.

use crate::error::Error;
use crate::launch;
use crate::motion::Motion;
use crate::regime::Regime;
use crate::scalar::Scalar;
use core::marker::PhantomData;

/// The exact motion of one pendulum, θ̈ + ω² sin θ = 0, from any initial state.
#[derive(Clone, Copy, Debug)]
pub struct Pendulum<F: Scalar> {
    pub(crate) motion: Motion,
    scalar: PhantomData<F>,
}

impl<F: Scalar> Pendulum<F> {
    /// Released at rest.
    ///
    /// # Errors
    /// as documented
    pub fn new(theta0: F, omega: F) -> Result<Self, Error> {
        Ok(Self { motion: launch::at_rest(theta0.widen(), omega.widen())?, scalar: PhantomData })
    }

    /// From any state.
    ///
    /// # Errors
    /// as documented
    pub fn from_state(theta: F, velocity: F, omega: F) -> Result<Self, Error> {
        let motion = launch::from_state(theta.widen(), velocity.widen(), omega.widen())?;
        Ok(Self { motion, scalar: PhantomData })
    }

    /// θ(t), rad.
    #[inline]
    pub fn theta(&self, t: F) -> F {
        F::narrow(self.motion.angle(&self.motion.at(t.widen())))
    }

    /// θ̇(t).
    #[inline]
    pub fn velocity(&self, t: F) -> F {
        F::narrow(self.motion.speed(&self.motion.at(t.widen())))
    }

    /// (θ(t), θ̇(t)).
    #[inline]
    pub fn state(&self, t: F) -> (F, F) {
        let point = self.motion.at(t.widen());
        (F::narrow(self.motion.angle(&point)), F::narrow(self.motion.speed(&point)))
    }

    /// θ̈.
    #[inline]
    pub fn acceleration(&self, t: F) -> F {
        F::narrow(self.motion.acceleration(&self.motion.at(t.widen())))
    }

    /// (sin θ, −cos θ).
    #[inline]
    pub fn position(&self, t: F) -> (F, F) {
        let (x, y) = self.motion.position(&self.motion.at(t.widen()));
        (F::narrow(x), F::narrow(y))
    }

    /// wrapped
    #[inline]
    pub fn wrapped(&self, t: F) -> F {
        F::narrow_angle(self.motion.wrapped(&self.motion.at(t.widen())))
    }

    /// time_at
    ///
    /// # Errors
    /// as documented
    pub fn time_at(&self, theta: F) -> Result<F, Error> {
        self.motion.time_at(theta.widen()).map(F::narrow)
    }

    /// Period
    pub fn period(&self) -> F {
        F::narrow_or_infinite(self.motion.period())
    }

    /// regime
    pub fn regime(&self) -> Regime {
        self.motion.regime
    }
}
