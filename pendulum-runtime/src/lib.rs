//! The run-time half of `pendula`: the exact motion of a pendulum whose amplitude is known only at run time, and the
//! elliptic functions behind it. `no_std`, no allocation, no panics; only + − × ÷, √, comparisons and integer
//! operations in a fixed order, so the same bits on every IEEE target.
//!
//! * [`Pendulum`]: θ, θ̇, θ̈, position at any time, from any state; period, energy, time of an angle;
//! * [`Fourier`]: the approximation of F. M. S. Lima (Rev. Bras. Ens. Fís., 2019), with its true supremum of error;
//! * [`elliptic`]: K, K′, q, sn, cn, dn, am and F by modulus or by complementary modulus.
//!
//! # How
//! With k = sin(θ0/2), k′ = cos(θ0/2) taken from π − θ0, K = π/(2 AGM(1, k′)), q = exp(−πK′/K) and x = 2πt/T, T = 4K/ω,
//! the half-nome pair S = Σ 2q^(n²/2) cos nx over odd n and C = 1 + Σ 2q^(n²/2) cos nx over even n gives
//! θ = 4 atan(S/C). The weights fall so fast that a sine, two polynomials of degree three and an arctangent are all
//! (module `swing`); near the top their duals, in which an exponential takes the place of the sine, converge faster
//! still. Rotations (module `rotation`) are θ = 2 am. 1/T is carried in two words (`double`), and t/T is reduced
//! exactly (`phase`).
#![forbid(unsafe_code)]
#![no_std]
#![warn(clippy::must_use_candidate)]

mod agm;
mod angle;
mod carlson;
#[doc(hidden)]
pub mod double;
#[doc(hidden)]
pub mod double_trig;
pub mod elliptic;
mod error;
mod fourier;
#[doc(hidden)]
pub mod fourier_analysis;
mod inverse;
mod kernel;
mod launch;
mod motion;
mod nome;
mod pendulum;
mod phase;
mod regime;
mod rotation;
mod scalar;
#[doc(hidden)]
pub mod support;
mod swing;
mod theta_polynomial;
mod theta_quotient;

pub use error::Error;
pub use fourier::Fourier;
#[doc(hidden)]
pub use kernel::{power, two_to};
pub use pendulum::Pendulum;
pub use regime::Regime;
pub use scalar::Scalar;
