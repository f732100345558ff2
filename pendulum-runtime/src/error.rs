//! What can be wrong with a request.

use crate::double::LARGEST;
use crate::inverse::MOST_TURNS;
use core::fmt;

/// Why a motion, or something asked of it, does not exist. Values are given as `f64`, whatever the type of float.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A parameter is NaN or infinite.
    NotFinite {
        /// Which parameter.
        parameter: &'static str,
        /// Its value.
        value: f64,
    },
    /// |θ0| exceeds the last `f64` below π: a release angle beyond the top.
    Amplitude {
        /// The release angle, rad.
        value: f64,
    },
    /// ω ≤ 0.
    Frequency {
        /// The small-angle rate, rad per unit of t.
        value: f64,
    },
    /// |θ̇|/ω is beyond 10²⁹⁰.
    Velocity {
        /// The angular velocity, rad per unit of t.
        value: f64,
    },
    /// The motion never has this angle at t ≥ 0, or more than 10¹⁵ turns ahead, or at a t beyond the largest number.
    NeverReached {
        /// The angle asked for, rad.
        angle: f64,
    },
    /// Eq. 22 with N terms: the argument of the arcsine exceeds 1, so θ̂ would be NaN near the turning points.
    Overshoot {
        /// N.
        terms: usize,
        /// By how much the largest argument exceeds 1.
        overshoot: f64,
        /// The smallest N for which it does not.
        smallest: usize,
    },
    /// Eq. 22 with N = 0 terms.
    NoTerms,
    /// Eq. 22 describes swings only.
    NotASwing,
}

/// Refuses NaN and ±∞.
pub(crate) fn finite(parameter: &'static str, value: f64) -> Result<(), Error> {
    if value.is_finite() { Ok(()) } else { Err(Error::NotFinite { parameter, value }) }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { parameter, value } => {
                write!(f, "{parameter} = {value:?} is not finite; give a finite number")
            }
            Self::Amplitude { value } => write!(
                f,
                "theta0 = {value:?} rad ({:?} deg) is beyond the top, |theta0| must be below pi; \
                 for a pendulum that goes over the top use `from_state` with a velocity",
                value.to_degrees()
            ),
            Self::Frequency { value } => {
                write!(f, "omega = {value:?} must be positive; give omega = sqrt(g/length) in rad per unit of t")
            }
            Self::Velocity { value } => {
                write!(
                    f,
                    "velocity = {value:?} is beyond {LARGEST:e} omega; gravity is nothing to it, use theta + velocity * t"
                )
            }
            Self::NeverReached { angle } => write!(
                f,
                "theta = {angle:?} rad is never reached at t >= 0; \
                 a swing reaches at most its `amplitude`, a rotation only what lies ahead, within {MOST_TURNS:e} turns, and \
                 t is at most the largest number"
            ),
            Self::Overshoot { terms, overshoot, smallest } => write!(
                f,
                "with N = {terms} the argument of the arcsine exceeds 1 by {overshoot:.2e} at this amplitude; \
                 the smallest N that works is {smallest}"
            ),
            Self::NoTerms => write!(f, "N = 0 leaves no term of the Fourier series; use N of at least 1"),
            Self::NotASwing => {
                write!(
                    f,
                    "the Fourier approximation (Eq. 22) describes swings; use `theta` for rotation and separatrix"
                )
            }
        }
    }
}

impl core::error::Error for Error {}
