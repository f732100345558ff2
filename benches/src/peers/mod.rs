//! What people use today.

mod adaptive;
mod library;
mod paper;
mod stepper;
mod table;

use crate::amplitude::Amplitude;
use crate::contestant::{Contestant, Family};
use crate::real::Real;
use crate::truth;

pub use paper::AS_WRITTEN;

/// A peer that this build does not have, and why.
#[derive(Clone, Debug)]
pub struct Missing {
    /// Which.
    pub name: &'static str,
    /// What to install.
    pub why: &'static str,
}

/// What the peers need to know about a motion.
struct Motion {
    /// θ0 as an `f64`.
    theta0: f64,
    /// k = sin(θ0/2)
    modulus: f64,
    /// k′ = cos(θ0/2)
    complement: f64,
    /// T
    period: f64,
    exact: pendula_stress::motion::Motion,
}

/// The number that is compared with, and all peers in one precision. The peers get the amplitude as an `f64`, or in
/// single precision as an `f32`, take it as exact, and are compared with the motion of that amplitude.
pub fn peers<R: Precision>(amplitude: Amplitude) -> Vec<Contestant<R>> {
    let exact = truth::motion(amplitude, R::GIVEN);
    let theta0 = R::of(amplitude.theta0()).wide();
    let (modulus, complement) = (theta0 / 2.0).sin_cos();
    let motion = Motion { theta0, modulus, complement, period: exact.period().to_f64(), exact };
    let mut all = vec![Contestant::function(Family::Yardstick, &format!("{}::sin", R::NAME), "", |t: R| t.sin())];
    all.extend(paper::contestants(&motion));
    all.extend(R::libraries(&motion));
    all.extend(table::contestants(&motion));
    all.extend(stepper::contestants(&motion));
    all.extend(adaptive::contestants(&motion));
    all
}

/// What was looked for in vain.
pub fn missing() -> Vec<Missing> {
    library::missing()
}

/// Versions of the peers that are other people's code.
pub fn versions() -> Vec<(&'static str, String)> {
    let mut list = library::versions();
    list.push(("ode_solvers", env!("PEER_ODE_SOLVERS").into()));
    list
}

/// A precision with the libraries that serve it.
#[expect(private_interfaces, reason = "the trait is implemented here only")]
pub trait Precision: Real + adaptive::Adaptive {
    /// The libraries of special functions.
    fn libraries(motion: &Motion) -> Vec<Contestant<Self>>;
}
