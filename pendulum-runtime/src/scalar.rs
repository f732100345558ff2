//! The number types of the interface.

use core::fmt::{Debug, Display};
use core::ops::{Add, Div, Mul, Neg, Sub};
use sealed::Sealed;

/// What only this crate calls.
mod sealed {
    pub trait Sealed: Copy {
        /// One unit in the last place of 1.
        const ULP: f64;
        /// Exactly.
        fn widen(self) -> f64;
        /// What `function` of the motion is at this time.
        fn evaluate<M, T>(self, motion: &M, function: impl FnOnce(&M, f64) -> T) -> T;
        /// To nearest; finite stays finite.
        fn narrow(x: f64) -> Self;
        /// To nearest, infinity included.
        fn narrow_or_infinite(x: f64) -> Self;
        /// Upward.
        fn narrow_up(x: f64) -> Self;
        /// To nearest, but never beyond the last number below π in magnitude.
        fn narrow_angle(x: f64) -> Self;
    }
}

/// `f32` or `f64`: the type of t and of the results. `f32` computes in `f64` and rounds once.
///
/// Code for either has what both have of arithmetic, and may send motions to threads:
///
/// ```
/// # use pendulum_runtime::{Pendulum, Scalar};
/// /// Means of θ over a quarter of a period.
/// fn mean<F: Scalar>(motion: &Pendulum<F>) -> F {
///     let step = motion.period() / F::from(400);
///     let angle = |i: u16| motion.theta(F::from(i) * step + step / F::from(2));
///     (0..100).map(angle).fold(F::default(), |sum, theta| sum + theta) / F::from(100)
/// }
/// let motion = Pendulum::<f32>::new(0.1, 1.0)?;
/// assert!((mean(&motion) / motion.amplitude() - core::f32::consts::FRAC_2_PI).abs() < 1e-3);
/// # Ok::<(), pendulum_runtime::Error>(())
/// ```
pub trait Scalar:
    Sealed
    + Copy
    + Debug
    + Default
    + Display
    + PartialOrd
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + From<u16>
    + Into<f64>
    + 'static
{
}

impl Scalar for f64 {}
impl Scalar for f32 {}

impl Sealed for f64 {
    const ULP: f64 = f64::EPSILON;

    #[inline]
    fn widen(self) -> f64 {
        self
    }
    #[inline]
    fn evaluate<M, T>(self, motion: &M, function: impl FnOnce(&M, f64) -> T) -> T {
        function(motion, self)
    }
    #[inline]
    fn narrow(x: f64) -> Self {
        x
    }
    #[inline]
    fn narrow_or_infinite(x: f64) -> Self {
        x
    }
    #[inline]
    fn narrow_up(x: f64) -> Self {
        x
    }
    #[inline]
    fn narrow_angle(x: f64) -> Self {
        x // `f64`'s π is below π
    }
}

/// Keeps the function from being inlined behind a conversion from `f32`: that of SSE writes half of a register, of which
/// compilers choose one that the call before may still be busy with. Evaluations that could overlap then wait for each
/// other, which takes twice the time.
#[inline(never)]
fn apart<M, T>(motion: &M, x: f64, function: impl FnOnce(&M, f64) -> T) -> T {
    function(motion, x)
}

impl Sealed for f32 {
    const ULP: f64 = f32::EPSILON as f64;

    #[inline]
    fn widen(self) -> f64 {
        f64::from(self)
    }
    #[inline]
    fn evaluate<M, T>(self, motion: &M, function: impl FnOnce(&M, f64) -> T) -> T {
        apart(motion, self.into(), function)
    }
    #[inline]
    fn narrow(x: f64) -> Self {
        (x as f32).clamp(f32::MIN, f32::MAX)
    }
    #[inline]
    fn narrow_or_infinite(x: f64) -> Self {
        x as f32
    }
    #[inline]
    fn narrow_up(x: f64) -> Self {
        let nearest = x as Self;
        if nearest.widen() < x { nearest.next_up() } else { nearest }
    }
    #[inline]
    fn narrow_angle(x: f64) -> Self {
        const BELOW_PI: f32 = core::f32::consts::PI.next_down();
        (x as f32).clamp(-BELOW_PI, BELOW_PI)
    }
}
