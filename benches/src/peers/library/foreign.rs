//! The C and C++ libraries.
#![expect(unsafe_code, reason = "calls into C")]

#[cfg(gsl)]
mod gsl {
    use std::ffi::{CStr, c_char, c_double, c_int};

    unsafe extern "C" {
        fn gsl_sf_elljac_e(u: c_double, m: c_double, sn: *mut c_double, cn: *mut c_double, dn: *mut c_double) -> c_int;
        static gsl_version: *const c_char;
    }

    /// cn(u | m).
    pub(crate) fn gsl_cn(u: f64, m: f64) -> f64 {
        let (mut sn, mut cn, mut dn) = (0.0, 0.0, 0.0);
        // SAFETY: the three pointers are to live variables; |m| ≤ 1, so the error handler is not called.
        let status = unsafe { gsl_sf_elljac_e(u, m, &raw mut sn, &raw mut cn, &raw mut dn) };
        if status == 0 { cn } else { f64::NAN }
    }

    /// The version of the library that is linked.
    pub(crate) fn gsl_version_text() -> String {
        // SAFETY: the library defines it as a constant C string.
        unsafe { CStr::from_ptr(gsl_version) }.to_string_lossy().into_owned()
    }
}

#[cfg(boost)]
mod boost {
    unsafe extern "C" {
        safe fn pendula_boost_cn(k: f64, u: f64) -> f64;
        safe fn pendula_boost_plain_cn(k: f64, u: f64) -> f64;
        safe fn pendula_boost_cnf(k: f32, u: f32) -> f32;
        safe fn pendula_boost_plain_cnf(k: f32, u: f32) -> f32;
        safe fn pendula_boost_version() -> u32;
    }

    /// A precision of Boost's functions.
    pub(crate) trait Boost: Sized {
        /// The type that the library computes in unasked.
        const WIDER: &'static str;
        /// cn(u; k) computed in the wider type.
        fn promoted_cn(modulus: Self, u: Self) -> Self;
        /// cn(u; k) computed in the type itself.
        fn plain_cn(modulus: Self, u: Self) -> Self;
    }

    impl Boost for f64 {
        const WIDER: &'static str = "long double";

        fn promoted_cn(modulus: Self, u: Self) -> Self {
            pendula_boost_cn(modulus, u)
        }

        fn plain_cn(modulus: Self, u: Self) -> Self {
            pendula_boost_plain_cn(modulus, u)
        }
    }

    impl Boost for f32 {
        const WIDER: &'static str = "double";

        fn promoted_cn(modulus: Self, u: Self) -> Self {
            pendula_boost_cnf(modulus, u)
        }

        fn plain_cn(modulus: Self, u: Self) -> Self {
            pendula_boost_plain_cnf(modulus, u)
        }
    }

    /// The version of the headers.
    pub(crate) fn boost_version() -> String {
        let version = pendula_boost_version();
        format!("{}.{}.{}", version / 100_000, version / 100 % 1000, version % 100)
    }
}

#[cfg(boost)]
pub(super) use boost::{Boost, boost_version};
#[cfg(gsl)]
pub(super) use gsl::{gsl_cn, gsl_version_text as gsl_version};
