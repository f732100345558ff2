//! The interval [0, ¼] of the variable p, mapped to u = 8p − 1 = cos φ.

use pendulum_runtime::double::Double;
use std::f64::consts::PI;

/// p where 8p − 1 = u.
pub(in crate::plan) fn p_in_two_words(u: Double) -> Double {
    (u + Double::ONE) * 0.125
}

/// The same in one word, but for rounding never below 0.
pub(super) fn p(u: f64) -> f64 {
    ((1.0 + u) / 8.0).max(0.0)
}

/// Parts of the half circle in which suprema are sought.
pub(super) const CELLS: u32 = 192;

/// The angle φ where a cell begins.
pub(super) fn angle(cell: u32) -> f64 {
    PI / f64::from(CELLS) * f64::from(cell)
}
