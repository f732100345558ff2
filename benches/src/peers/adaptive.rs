//! Dormand and Prince's method of order 5(4) with adaptive steps and dense output, by the crate `ode_solvers`.

use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dopri5, SVector, System};

use super::Motion;
use crate::contestant::{Contestant, State, Stepping};
use crate::real::Real;

/// A precision that the crate serves.
pub trait Adaptive: Real {
    /// The angles at `interval`, `2·interval`, … from rest at `theta0`, with this tolerance, relative and absolute.
    fn integrate(theta0: Self, interval: Self, tolerance: Self, angles: &mut [Self]);
}

/// Sampled at T/100 and T/1000; the tolerance, not the sampling, sets its error.
pub(super) fn contestants<R: Adaptive>(motion: &Motion) -> Vec<Contestant<R>> {
    let tolerances: &[(f64, &str)] =
        if R::NAME == "f32" { &[(1e-5, "1e-5")] } else { &[(1e-6, "1e-6"), (1e-9, "1e-9"), (1e-12, "1e-12")] };
    let mut all = Vec::new();
    for samples in [100, 1000] {
        for &(tolerance, text) in tolerances {
            let interval = R::of(motion.period / f64::from(samples)).wide();
            let method = DormandPrince { theta0: R::of(motion.theta0), interval, tolerance: R::of(tolerance) };
            let name = format!("Dormand–Prince at T/{samples}");
            all.push(Contestant::stepping(&name, &format!("tol {text}"), method));
        }
    }
    all
}

struct DormandPrince<R> {
    theta0: R,
    interval: f64,
    tolerance: R,
}

impl<R: Adaptive> Stepping<R> for DormandPrince<R> {
    fn interval(&self) -> f64 {
        self.interval
    }

    fn follow(&self, angles: &mut [R]) {
        R::integrate(self.theta0, R::of(self.interval), self.tolerance, angles);
    }

    fn advance(&self, _: &mut [State<R>]) -> bool {
        false
    }
}

/// θ̈ = −sin θ.
struct Pendulum;

/// One implementation per precision: the crate's own bounds for a generic one would have to be repeated everywhere.
macro_rules! adaptive {
    ($real:ty) => {
        impl System<$real, SVector<$real, 2>> for Pendulum {
            fn system(&self, _: $real, y: &SVector<$real, 2>, dy: &mut SVector<$real, 2>) {
                dy[0] = y[1];
                dy[1] = -y[0].sin();
            }
        }

        impl Adaptive for $real {
            fn integrate(theta0: Self, interval: Self, tolerance: Self, angles: &mut [Self]) {
                // A little beyond the last sample: the solver adds up the times of its samples, with rounding.
                let end = interval * (1.001 * angles.len() as Self + 1.0);
                let start = SVector::<Self, 2>::new(theta0, 0.0);
                // Its own defaults, but for the limit on the number of steps.
                let mut solver = Dopri5::from_param(
                    Pendulum,
                    0.0,
                    end,
                    interval,
                    start,
                    tolerance,
                    tolerance,
                    0.9,
                    0.04,
                    0.2,
                    10.0,
                    end,
                    0.0,
                    u32::MAX,
                    1000,
                    OutputType::Dense,
                );
                // Where the integration breaks off the samples end, and what is missing is not a number.
                let _ = solver.integrate();
                // The first output is the release itself.
                let mut samples = solver.y_out().iter().skip(1).map(|state| state[0]);
                for angle in angles {
                    *angle = samples.next().unwrap_or(Self::NAN);
                }
            }
        }
    };
}

adaptive!(f32);
adaptive!(f64);
