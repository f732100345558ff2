//! Our own entries: what the macro makes of every decade of tolerance, and of methods that are forced; compiled in.

use pendula::{Pendulum, Scalar, pendulum};

use crate::amplitude::Amplitude;
use crate::contestant::{Contestant, Family, Kind, Pair};
use crate::real::Real;
use crate::truth::Given;

/// Name of the plans with a horizon of 100 periods.
pub const PLANNED: &str = "pendula, 100 periods";
/// Name of the plans for any time.
pub const ANY_TIME: &str = "pendula, any time";
/// Name of the exact motion by the run-time crate.
pub const RUNTIME: &str = "pendula, Pendulum::theta";
/// Name of the paper's θ̂ by the macro.
pub const PAPER: &str = "pendula, Eq. 22";
/// Name of the plans that give θ and θ̇ with one reduction of the phase.
pub const STATE: &str = "pendula, θ and θ̇";
/// Setting of the plans in full precision, which serve any time.
pub const FULL: &str = "full precision";

/// A precision that the macro serves.
pub trait Planned: Real + Scalar {
    /// The planner's choices for one amplitude.
    fn planned(amplitude: Amplitude) -> Vec<Contestant<Self>>;

    /// Other methods than those it chooses, and θ together with θ̇.
    fn forced(amplitude: Amplitude) -> Vec<Contestant<Self>>;
}

/// All of ours. The macro gets the exact amplitude, the run-time crate its nearest number.
pub fn ours<R: Planned>(amplitude: Amplitude) -> Vec<Contestant<R>> {
    let mut all = R::planned(amplitude);
    all.extend(R::forced(amplitude));
    // The amplitudes of the benchmark are well within the range of both precisions.
    if let Ok(pendulum) = Pendulum::new(R::of(amplitude.theta0()), R::one()) {
        all.push(Contestant::function(Family::Runtime, RUNTIME, "", move |t| pendulum.theta(t)));
        all.extend(fourier::<R, 4>(&pendulum));
        all.extend(fourier::<R, 24>(&pendulum));
    }
    all
}

/// Eq. 22 by the run-time crate, where it can be had: too few terms are an error, and so are more than can be used.
fn fourier<R: Planned, const N: usize>(pendulum: &Pendulum<R>) -> Option<Contestant<R>> {
    let fourier = pendulum.fourier::<N>().ok()?;
    let setting = format!("N = {N}");
    Some(Contestant::function(Family::Forced, "pendula, Pendulum::fourier", &setting, move |t| fourier.theta(t)))
}

fn plan<R: Real>(
    family: Family,
    name: &str,
    setting: &str,
    copies: (impl Fn(R) -> R + 'static, impl Fn(R) -> R + 'static),
) -> Contestant<R> {
    Contestant::copies(family, name, setting, copies).given(Given::Exact)
}

fn state<R: Real>(
    setting: &str,
    copies: (impl Fn(R) -> (R, R) + 'static, impl Fn(R) -> (R, R) + 'static),
) -> Contestant<R> {
    Contestant::new(Family::Forced, STATE, setting, Kind::AnyTime(Box::new(Pair::new(copies)))).given(Given::Exact)
}

/// Two copies of one function, for [`Function`](crate::contestant::Function).
macro_rules! twice {
    ($theta:ident: $($request:tt)*) => {{
        pendulum! { struct Array; $($request)* }
        pendulum! { struct Single; $($request)* }
        (Array::$theta, Single::$theta)
    }};
}

/// One entry per tolerance with a horizon of `$t_max`, 100 periods rounded up; then, for any time, one per tolerance
/// and the one in full precision.
macro_rules! plans {
    ($amplitude:ident, $float:ident, $theta0:tt, $t_max:literal, [$($tol:literal)*], [$($ever:literal)*]) => {{
        assert_eq!($amplitude.t_max, $t_max);
        vec![
            $(plan(Family::Planned, PLANNED, concat!("tol ", stringify!($tol)), twice!(theta:
                theta0 = $theta0, tol = $tol, t_max = $t_max, float = $float
            )),)*
            $(plan(Family::Planned, ANY_TIME, concat!("tol ", stringify!($ever)), twice!(theta:
                theta0 = $theta0, tol = $ever, float = $float
            )),)*
            plan::<$float>(Family::Planned, ANY_TIME, FULL, twice!(theta: theta0 = $theta0, float = $float)),
        ]
    }};
}

/// The paper's θ̂ for each number of terms, and one entry per method and tolerance with a horizon of `$t_max`.
macro_rules! methods {
    ($amplitude:ident, $float:ident, $theta0:tt, $t_max:literal, [$($n:literal)*] $(, $method:ident [$($tol:literal)*])*) => {{
        assert_eq!($amplitude.t_max, $t_max);
        vec![
            $(plan::<$float>(Family::Forced, PAPER, concat!("n = ", stringify!($n)), twice!(theta:
                theta0 = $theta0, n = $n, float = $float
            )),)*
            $($(plan::<$float>(
                Family::Forced,
                concat!("pendula, ", stringify!($method), ", 100 periods"),
                concat!("tol ", stringify!($tol)),
                twice!(theta: theta0 = $theta0, tol = $tol, t_max = $t_max, method = $method, float = $float)
            ),)*)*
        ]
    }};
}

/// θ and θ̇ with one reduction of the phase: with a horizon of `$t_max` to each tolerance, and at any time in full
/// precision.
macro_rules! states {
    ($amplitude:ident, $float:ident, $theta0:tt, $t_max:literal, [$($tol:literal)*]) => {{
        assert_eq!($amplitude.t_max, $t_max);
        [
            $(state::<$float>(concat!("tol ", stringify!($tol)), twice!(state:
                theta0 = $theta0, tol = $tol, t_max = $t_max, float = $float, outputs = [theta, velocity]
            )),)*
            state::<$float>(FULL, twice!(state: theta0 = $theta0, float = $float, outputs = [theta, velocity])),
        ]
    }};
}

impl Planned for f64 {
    fn planned(amplitude: Amplitude) -> Vec<Contestant<Self>> {
        match amplitude.slug {
            "pi_3" => plans!(
                amplitude, f64, (PI/3), 675,
                [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10 1e-11 1e-12 1e-13 1e-14 1e-15],
                [1e-3 1e-6 1e-9 1e-12]
            ),
            "7pi_8" => plans!(
                amplitude, f64, (7π/8), 1217,
                [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10 1e-11 1e-12 1e-13 1e-14],
                [1e-3 1e-6 1e-9 1e-12]
            ),
            "0.999pi" => plans!(
                amplitude, f64, (0.999π), 3137,
                [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10 1e-11 1e-12 1e-13 1e-14],
                [1e-3 1e-6 1e-9 1e-12]
            ),
            "0.999999pi" => plans!(
                amplitude, f64, (0.999999π), 5901,
                [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10 1e-11 1e-12 1e-13 1e-14],
                [1e-3 1e-6 1e-9 1e-12]
            ),
            _ => Vec::new(),
        }
    }

    fn forced(amplitude: Amplitude) -> Vec<Contestant<Self>> {
        match amplitude.slug {
            "pi_3" => methods!(
                amplitude, f64, (PI/3), 675, [1 2 4 6 8],
                harmonic [1e-1], series [1e-3 1e-6 1e-9 1e-12], fourier [1e-3 1e-6 1e-9 1e-12]
            ),
            "7pi_8" => {
                let mut all = methods!(
                    amplitude, f64, (7π/8), 1217, [2 3 4 6 8 12 16],
                    harmonic [5e-1], series [1e-3 1e-6 1e-9 1e-12], fourier [1e-3 1e-6 1e-9 1e-12]
                );
                all.extend(states!(amplitude, f64, (7π/8), 1217, [1e-6 1e-9 1e-12]));
                all
            }
            // Eq. 22 needs 20 terms here before its arcsine has a value everywhere.
            "0.999pi" => {
                methods!(amplitude, f64, (0.999π), 3137, [20 24 32], series [1e-3 1e-6 1e-9 1e-12], fourier [1e-3 1e-6])
            }
            _ => Vec::new(),
        }
    }
}

impl Planned for f32 {
    fn planned(amplitude: Amplitude) -> Vec<Contestant<Self>> {
        match amplitude.slug {
            "pi_3" => plans!(amplitude, f32, (PI/3), 675, [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6], [1e-2 1e-4]),
            "7pi_8" => plans!(amplitude, f32, (7π/8), 1217, [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6], [1e-2 1e-4]),
            "0.999pi" => plans!(amplitude, f32, (0.999π), 3137, [1e-1 1e-2 1e-3 1e-4 1e-5], [1e-2 1e-4]),
            "0.999999pi" => plans!(amplitude, f32, (0.999999π), 5901, [1e-1 1e-2 1e-3 1e-4], [1e-2 1e-4]),
            _ => Vec::new(),
        }
    }

    fn forced(amplitude: Amplitude) -> Vec<Contestant<Self>> {
        match amplitude.slug {
            "pi_3" => methods!(amplitude, f32, (PI/3), 675, [2 4], series [1e-3], fourier [1e-3]),
            "7pi_8" => {
                // Four times the tolerance of the target, where one product with the rate is exact enough.
                let mut all =
                    methods!(amplitude, f32, (7π/8), 1217, [4 8], series [1e-3], fourier [1e-3], polynomial [4e-4]);
                all.extend(states!(amplitude, f32, (7π / 8), 1217, [1e-4]));
                all
            }
            "0.999pi" => methods!(amplitude, f32, (0.999π), 3137, [20], series[1e-3], fourier[1e-1]),
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
    use crate::truth::{Given, motion};

    /// `t_max`, which the plans above assert to be theirs: at least the horizon, at most 1 % more.
    #[test]
    fn the_horizons_are_a_hundred_periods() {
        for amplitude in Amplitude::ALL {
            let horizon = HORIZON * motion(amplitude, Given::Exact).period().to_f64();
            assert!((horizon..=1.01 * horizon).contains(&f64::from(amplitude.t_max)), "{}: {horizon}", amplitude.name);
            assert!(!ours::<f64>(amplitude).is_empty());
        }
    }

    /// Each plan keeps the tolerance that its setting states, at the times of the benchmark.
    #[test]
    fn plans_keep_their_tolerances() {
        let mut count = 0;
        for amplitude in Amplitude::ALL {
            let mut plans = ours::<f64>(amplitude);
            plans.retain(|one| one.setting.starts_with("tol "));
            let tolerances: Vec<f64> =
                plans.iter().map(|one| one.setting["tol ".len()..].parse().expect("a number")).collect();
            for (error, tolerance) in Field::new(amplitude, plans).errors().into_iter().zip(tolerances) {
                assert!(error <= tolerance, "{}: {error:e} > {tolerance:e}", amplitude.name);
                count += 1;
            }
        }
        assert!(count >= 100, "only {count} plans");
    }
}
