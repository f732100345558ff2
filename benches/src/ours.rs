//! Our own entries: what the macro makes of every decade of tolerance, compiled in.

use pendula::{Pendulum, Scalar, pendulum};

use crate::amplitude::Amplitude;
use crate::contestant::{Contestant, Family};
use crate::real::Real;
use crate::truth::Given;

/// Name of the plans with a horizon of 100 periods.
pub const PLANNED: &str = "pendula, 100 periods";
/// Name of the plans for any time.
pub const ANY_TIME: &str = "pendula, any time";

/// A precision that the macro serves.
pub trait Planned: Real + Scalar {
    /// The planner's choices for one amplitude.
    fn planned(amplitude: Amplitude) -> Vec<Contestant<Self>>;
}

/// All of ours. The macro gets the exact amplitude, the run-time crate its nearest number.
pub fn ours<R: Planned>(amplitude: Amplitude) -> Vec<Contestant<R>> {
    let mut all = R::planned(amplitude);
    // The amplitudes of the benchmark are well within the range of both precisions.
    let pendulum = Pendulum::new(R::of(amplitude.theta0()), R::one());
    all.extend(pendulum.map(|pendulum| {
        Contestant::function(Family::Runtime, "pendula, Pendulum::theta", "", move |t| pendulum.theta(t))
    }));
    all
}

fn plan<R: Real>(name: &str, setting: &str, theta: impl Fn(R) -> R + 'static) -> Contestant<R> {
    Contestant::function(Family::Planned, name, setting, theta).given(Given::Exact)
}

/// One entry per tolerance with a horizon of `$t_max`, 100 periods rounded up; then, for any time, one per tolerance and
/// the one in full precision.
macro_rules! plans {
    ($float:ident, $theta0:tt, $t_max:literal, [$($tol:literal)*], [$($ever:literal)*] $(, $full:ident)?) => {
        vec![
            $(plan(PLANNED, concat!("tol ", stringify!($tol)), pendulum!(
                theta0 = $theta0, tol = $tol, t_max = $t_max, float = $float
            )),)*
            $(plan(ANY_TIME, concat!("tol ", stringify!($ever)), pendulum!(
                theta0 = $theta0, tol = $ever, float = $float
            )),)*
            $(plan::<$float>(ANY_TIME, plans!(@ $full), pendulum!(theta0 = $theta0, float = $float)),)?
        ]
    };
    (@ full) => { "full precision" };
}

impl Planned for f64 {
    fn planned(amplitude: Amplitude) -> Vec<Contestant<Self>> {
        match amplitude.slug {
            "pi_3" => plans!(
                f64, (PI/3), 675,
                [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10 1e-11 1e-12 1e-13 1e-14 1e-15],
                [1e-3 1e-6 1e-9 1e-12], full
            ),
            "7pi_8" => plans!(
                f64, (7π/8), 1217,
                [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10 1e-11 1e-12 1e-13 1e-14],
                [1e-3 1e-6 1e-9 1e-12], full
            ),
            "0.999pi" => plans!(
                f64, (0.999π), 3137,
                [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10 1e-11 1e-12 1e-13 1e-14],
                [1e-3 1e-6 1e-9 1e-12]
            ),
            _ => Vec::new(),
        }
    }
}

impl Planned for f32 {
    fn planned(amplitude: Amplitude) -> Vec<Contestant<Self>> {
        match amplitude.slug {
            "pi_3" => plans!(f32, (PI/3), 675, [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6], [1e-2 1e-4], full),
            "7pi_8" => plans!(f32, (7π/8), 1217, [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6], [1e-2 1e-4], full),
            "0.999pi" => plans!(f32, (0.999π), 3137, [1e-1 1e-2 1e-3 1e-4 1e-5], [1e-2 1e-4]),
            _ => Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::ours;
    use crate::amplitude::Amplitude;
    use crate::contestant::HORIZON;
    use crate::session::Field;
    use crate::truth::{Given, Truth};

    /// The values of `t_max` above: at least the horizon, at most 1 % more.
    #[test]
    fn the_horizons_are_a_hundred_periods() {
        for (amplitude, t_max) in Amplitude::ALL.into_iter().zip([675.0, 1217.0, 3137.0]) {
            let horizon = HORIZON * Truth::new(amplitude, Given::Exact).period();
            assert!((horizon..=1.01 * horizon).contains(&t_max), "{}: {horizon}", amplitude.name);
        }
    }

    /// Each plan keeps the tolerance that its setting states, at the times of the benchmark.
    #[test]
    fn plans_keep_their_tolerances() {
        let mut count = 0;
        for amplitude in Amplitude::ALL {
            let contestants = ours::<f64>(amplitude);
            let tolerances: Vec<Option<f64>> = contestants
                .iter()
                .map(|one| one.setting.strip_prefix("tol ").and_then(|tol| tol.parse().ok()))
                .collect();
            let field = Field::new(amplitude, contestants);
            for (error, tolerance) in field.errors().into_iter().zip(tolerances) {
                let Some(tolerance) = tolerance else { continue };
                assert!(error <= tolerance, "{}: {error:e} > {tolerance:e}", amplitude.name);
                count += 1;
            }
        }
        assert!(count >= 39, "only {count} plans");
    }
}
