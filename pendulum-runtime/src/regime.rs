//! The kinds of motion.

/// What a pendulum does for all time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Regime {
    /// Hangs at the bottom.
    Rest,
    /// Oscillates between two turning points.
    Swing,
    /// Has exactly the energy to reach the top, and takes for ever to do so.
    Separatrix,
    /// Goes over the top, always in the same direction.
    Rotation,
}
