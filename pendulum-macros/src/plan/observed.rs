//! Which part of a proven bound is observed: full precision promises half of what it proves to be the most that is seen.

use crate::parse::Float;

/// The largest part where the bound is most of 2⁻⁴⁹ or 2⁻²⁰, but for errors that are met in full: of 4000 swings 0.79 in
/// `f64` (which had 0.65 of it proven), and 0.835 in `f32`, in which a plan has fewer roundings and more of all times can
/// be tried (`tests::full_precision::margins`).
pub(super) fn observed(float: Float) -> f64 {
    match float {
        Float::F64 => 0.79,
        Float::F32 => 0.84,
    }
}

/// That where the phase is the time itself, whose error is no part of the bound: of 700 swings in `f32`
/// (`tests::full_precision::margins`).
pub(super) const FOR_A_MOMENT: f64 = 0.94;

/// That of what a recurrence is rounded by.
pub(super) const BY_RECURRENCE: f64 = 2.0 / 3.0;
