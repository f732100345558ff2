//! The two precisions.

use num_traits::Float;

use crate::truth::Given;

/// 1.5 · 2⁵², and 1.5 · 2²³ for `f32`: adding it rounds to the nearest integer, which the low bits of the sum are.
pub const ROUNDER: f64 = 6_755_399_441_055_744.0;
const ROUNDER_F32: f32 = 12_582_912.0;

/// `f32` or `f64`.
pub trait Real: Float + 'static {
    /// `"f32"` or `"f64"`.
    const NAME: &'static str;
    /// What is given as the amplitude: its nearest value.
    const GIVEN: Given;

    /// The nearest value.
    fn of(value: f64) -> Self;

    /// Exactly.
    fn wide(self) -> f64;

    /// The nearest integer, and its low bits, for values of less than 2⁵¹ (`f64`) or 2²² (`f32`). Adding 1.5·2⁵²
    /// (1.5·2²³) and subtracting it again rounds without the library call that `round` is on the oldest x86-64, and
    /// vectorises.
    fn nearest(self) -> (Self, usize);

    /// `self`, but not before `last` is known: its bits enter masked by `nothing`, which is 0 and must be hidden from
    /// the compiler. This makes a chain of calls of which each waits for the one before, at the price of two
    /// single-cycle operations.
    #[must_use]
    fn after(self, last: Self, nothing: u64) -> Self;
}

impl Real for f64 {
    const NAME: &'static str = "f64";
    const GIVEN: Given = Given::F64;

    fn of(value: f64) -> Self {
        value
    }

    fn wide(self) -> f64 {
        self
    }

    #[inline]
    fn nearest(self) -> (Self, usize) {
        let shifted = self + ROUNDER;
        (shifted - ROUNDER, shifted.to_bits() as usize)
    }

    #[inline]
    fn after(self, last: Self, nothing: u64) -> Self {
        Self::from_bits(self.to_bits() ^ (last.to_bits() & nothing))
    }
}

impl Real for f32 {
    const NAME: &'static str = "f32";
    const GIVEN: Given = Given::F32;

    fn of(value: f64) -> Self {
        value as Self
    }

    fn wide(self) -> f64 {
        self.into()
    }

    #[inline]
    fn nearest(self) -> (Self, usize) {
        let shifted = self + ROUNDER_F32;
        (shifted - ROUNDER_F32, shifted.to_bits() as usize)
    }

    #[inline]
    fn after(self, last: Self, nothing: u64) -> Self {
        Self::from_bits(self.to_bits() ^ (last.to_bits() & nothing as u32))
    }
}
