//! Results of any type and output as two numbers.

/// A number, or the two coordinates of a position.
pub trait Pair {
    /// Both; the second of a number is 0.
    fn pair(self) -> [f64; 2];
}

impl Pair for f64 {
    fn pair(self) -> [f64; 2] {
        [self, 0.0]
    }
}

impl Pair for f32 {
    fn pair(self) -> [f64; 2] {
        [self.into(), 0.0]
    }
}

impl<T: Into<f64>> Pair for (T, T) {
    fn pair(self) -> [f64; 2] {
        [self.0.into(), self.1.into()]
    }
}
