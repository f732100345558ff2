//! A generated plan as a value, and how wrong it is seen to be.

use pendula::{Error, Pendulum};

/// The promise of every plan here holds for |t| up to this, 10 to 160 periods.
pub(crate) const HORIZON: f64 = 1000.0;

/// What the macro says of one plan, and its θ.
pub(crate) struct Plan {
    /// The tolerance as written, or `full`.
    pub(crate) tolerance: &'static str,
    pub(crate) method: &'static str,
    pub(crate) terms: usize,
    pub(crate) operations: usize,
    pub(crate) proven: f64,
    theta0: f64,
    period: f64,
    theta: fn(f64) -> f64,
}

/// `plan!((2.75), "1e-6", tol = 1e-6)`: the plan of `pendulum!` with the horizon above, which a macro takes in digits only.
macro_rules! plan {
    (($($theta0:tt)*), $tolerance:expr $(, $name:ident = $value:tt)*) => {{
        pendula::pendulum! { struct Motion; theta0 = $($theta0)*, t_max = 1000 $(, $name = $value)* }
        const { assert!(Motion::T_MAX == $crate::plan::HORIZON) };
        $crate::plan::Plan::new(
            $tolerance,
            (Motion::METHOD, Motion::TERMS, Motion::OPERATIONS, Motion::MAX_ERROR),
            (Motion::THETA0, Motion::PERIOD),
            Motion::theta,
        )
    }};
}
pub(crate) use plan;

impl Plan {
    pub(crate) fn new(
        tolerance: &'static str,
        (method, terms, operations, proven): (&'static str, usize, usize, f64),
        (theta0, period): (f64, f64),
        theta: fn(f64) -> f64,
    ) -> Self {
        Self { tolerance, method, terms, operations, proven, theta0, period, theta }
    }

    /// The largest distance from the exact motion over the first period and the last before the horizon.
    pub(crate) fn observed(&self) -> Result<f64, Error> {
        let exact = Pendulum::new(self.theta0, 1.0)?;
        let points = 20_000;
        let steps = (0..=points).map(|i| f64::from(i) / f64::from(points) * self.period);
        let times = steps.flat_map(|t| [t, HORIZON - t]);
        Ok(times.map(|t| ((self.theta)(t) - exact.theta(t)).abs()).fold(0.0, f64::max))
    }
}
