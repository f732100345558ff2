//! Libraries of elliptic functions, called in the best way that their interfaces allow.
//!
//! sin(θ/2) = k cn(t)/dn(t) and cos(θ/2) = k′/dn(t), so θ = 2 atan2(k cn(t), k′): one function of the three that they
//! all compute together, and no loss of digits at the turning points, unlike 2 arcsin(k sn(t + K)).

#[cfg(any(gsl, boost))]
mod foreign;

use spec_math::cephes64;

use super::{Missing, Motion, Precision};
use crate::contestant::{Contestant, Family};
use crate::real::Real;

/// θ from cn.
fn angle<R: Real>(motion: &Motion, cn: impl Fn(R) -> R + Clone + 'static) -> impl Fn(R) -> R + Clone + 'static {
    let (modulus, complement) = (R::of(motion.modulus), R::of(motion.complement));
    move |t| R::of(2.0) * (modulus * cn(t)).atan2(complement)
}

fn entry<R: Real>(name: &str, setting: &str, function: impl Fn(R) -> R + Clone + 'static) -> Contestant<R> {
    Contestant::function(Family::Library, name, setting, function)
}

#[expect(private_interfaces, reason = "see the trait")]
impl Precision for f64 {
    fn libraries(motion: &Motion) -> Vec<Contestant<Self>> {
        let parameter = motion.modulus * motion.modulus;
        let all = [entry("spec_math (Cephes)", "", angle(motion, move |u| cephes64::ellpj(u, parameter).1))];
        let all = all.into_iter();
        #[cfg(gsl)]
        let all = all.chain([entry("GSL", "", angle(motion, move |u| foreign::gsl_cn(u, parameter)))]);
        #[cfg(boost)]
        let all = all.chain(boost(motion));
        all.collect()
    }
}

#[expect(private_interfaces, reason = "see the trait")]
impl Precision for f32 {
    fn libraries(motion: &Motion) -> Vec<Contestant<Self>> {
        #[cfg(boost)]
        let all = boost(motion).into();
        #[cfg(not(boost))]
        let (all, _) = (Vec::new(), motion);
        all
    }
}

#[cfg(boost)]
fn boost<R: Real + foreign::Boost>(motion: &Motion) -> [Contestant<R>; 2] {
    let modulus = R::of(motion.modulus);
    [
        entry("Boost.Math", R::WIDER, angle(motion, move |u| R::promoted_cn(modulus, u))),
        entry("Boost.Math", R::NAME, angle(motion, move |u| R::plain_cn(modulus, u))),
    ]
}

/// Which libraries the build did not find.
pub(super) fn missing() -> Vec<Missing> {
    vec![
        #[cfg(not(gsl))]
        Missing { name: "GSL", why: "neither pkg-config nor gsl-config knows it (Debian: libgsl-dev)" },
        #[cfg(not(boost))]
        Missing { name: "Boost.Math", why: "no C++ compiler or no headers (Debian: libboost-math-dev)" },
    ]
}

/// Versions of those that it found.
pub(super) fn versions() -> Vec<(&'static str, String)> {
    vec![
        ("spec_math", env!("PEER_SPEC_MATH").into()),
        #[cfg(gsl)]
        ("GSL", foreign::gsl_version()),
        #[cfg(boost)]
        ("Boost.Math", foreign::boost_version()),
    ]
}
