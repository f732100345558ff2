//! Links no std: the panic handler would clash with the one there. Every kind of plan, under the strictest lints.

#![no_std]
#![deny(warnings, missing_docs, unreachable_pub, unused_qualifications)]
#![deny(clippy::all, clippy::pedantic, clippy::nursery, clippy::cargo)]
#![forbid(unsafe_code)]
#![allow(clippy::cargo_common_metadata, clippy::multiple_crate_versions, reason = "of the manifest, not of the code")]

motion::pendulum! {
    /// Single precision, a bounded horizon.
    #[derive(Clone, Copy, Debug)]
    pub struct Narrow;
    theta0 = 100deg, g = 9.81, length = 0.25, float = f32, tol = 1e-4, t_max = 1000, outputs = [theta, velocity]
}

motion::pendulum! {
    /// Full precision, at any time.
    #[derive(Clone, Copy, Debug)]
    pub struct Wide;
    theta0 = 7π/8, outputs = [theta, velocity]
}

motion::pendulum! {
    /// Everything there is.
    #[derive(Clone, Copy, Debug)]
    pub struct Everything;
    theta0 = 1, velocity0 = -1, tol = 1e-9, outputs = [theta, velocity, acceleration, position]
}

motion::pendulum! {
    /// The paper's approximation.
    #[derive(Clone, Copy, Debug)]
    pub struct Paper;
    theta0 = 7π/8, n = 4, outputs = [theta, velocity]
}

motion::pendulum! {
    /// A table of polynomials, next to the top.
    #[derive(Clone, Copy, Debug)]
    pub struct Pieces;
    theta0 = PI - 1e-7, tol = 1e-6, outputs = [theta, velocity]
}

motion::pendulum! {
    /// The series.
    #[derive(Clone, Copy, Debug)]
    pub struct Series;
    theta0 = 1, tol = 1e-4, method = series
}

/// A table in flash.
pub static TABLE: [f32; 64] = {
    let (mut table, mut i) = ([0.0; 64], 0_u8);
    while i < 64 {
        table[i as usize] = Narrow::theta(i as f32 * (Narrow::PERIOD / 64.0));
        i += 1;
    }
    table
};

/// Called from a timer's interrupt.
#[must_use]
pub fn sum(t: f32) -> f64 {
    let harmonic = motion::pendulum!(theta0 = 0.1, tol = 1e-2, method = harmonic);
    let (x, y) = Everything::position(f64::from(t));
    let wide = f64::from(t);
    let coarse = f64::from(Narrow::theta(t)) + Paper::theta(wide) + Paper::velocity(wide) + Series::theta(wide) + Pieces::state(wide).0;
    coarse + Wide::state(wide).1 + harmonic(wide) + x + y
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
