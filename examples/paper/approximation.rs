//! Approximations that the macro generated, as values to iterate over, and their measured distance from the exact
//! motion.

use pendula::{Error, Pendulum};
use std::f64::consts::PI;

/// One generated approximation of one motion with ω = 1.
pub(crate) struct Approximation {
    /// The amplitude as it was written.
    pub(crate) amplitude: &'static str,
    /// Its number of terms.
    pub(crate) terms: usize,
    pub(crate) theta0: f64,
    pub(crate) period: f64,
    /// The bound of its error that the macro proved, rad.
    pub(crate) proven: f64,
    pub(crate) theta: fn(f64) -> f64,
}

/// `approximation!((7π/8), n = 4)`: what `pendulum!` makes of it. The amplitude stands in parentheses so that it
/// arrives as it is written, not as a Rust expression, which knows no `7π`.
macro_rules! approximation {
    (($($theta0:tt)*), $($goal:tt)*) => {{
        pendula::pendulum! { struct Motion; theta0 = $($theta0)*, $($goal)* }
        $crate::approximation::Approximation {
            amplitude: stringify!($($theta0)*),
            terms: Motion::TERMS,
            theta0: Motion::THETA0,
            period: Motion::PERIOD,
            proven: Motion::MAX_ERROR,
            theta: Motion::theta,
        }
    }};
}
pub(crate) use approximation;

/// The largest distance found, and where.
pub(crate) struct Supremum {
    /// Relative to θ0, as the paper measures it.
    pub(crate) relative: f64,
    /// The time, in periods.
    pub(crate) at: f64,
}

impl Approximation {
    /// The exact motion, computed at run time.
    pub(crate) fn exact(&self) -> Result<Pendulum<f64>, Error> {
        Pendulum::new(self.theta0, 1.0)
    }

    /// sup |θ̂ − θ|/θ0 over t from 0 to `periods` T.
    ///
    /// 20,000 points per period: between two of them a maximum of curvature 10² per T² rises by 10⁻⁷ of θ0.
    pub(crate) fn supremum(&self, periods: u32) -> Result<Supremum, Error> {
        let exact = self.exact()?;
        let points = 20_000;
        let mut largest = Supremum { relative: 0.0, at: 0.0 };
        for i in 0..=points * periods {
            let at = f64::from(i) / f64::from(points);
            let t = at * self.period;
            let relative = (((self.theta)(t) - exact.theta(t)) / self.theta0).abs();
            // Of equal maxima the first: rounding alone tells them apart.
            if relative > largest.relative * (1.0 + 1e-9) {
                largest = Supremum { relative, at };
            }
        }
        Ok(largest)
    }

    /// The amplitude as the paper writes it: in units of π.
    pub(crate) fn label(&self) -> String {
        self.amplitude.split_whitespace().collect()
    }
}

/// `x` rad in units of π.
pub(crate) fn in_pi(x: f64) -> f64 {
    x / PI
}
