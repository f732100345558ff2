//! What generated code may call. Not part of the public interface.

/// √x, correctly rounded (NaN for x < 0): the hardware instruction where there is one, the same bits everywhere.
#[inline]
#[must_use]
pub fn sqrt(x: f64) -> f64 {
    libm::sqrt(x)
}

/// √x, correctly rounded (NaN for x < 0): the hardware instruction where there is one, the same bits everywhere.
#[inline]
#[must_use]
pub fn sqrtf(x: f32) -> f32 {
    libm::sqrtf(x)
}
