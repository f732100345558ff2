//! The reference data beside the tests of the workspace: lines of cells between commas, and comments. The programs
//! that wrote them say where the numbers come from.

/// A real number to about 106 bits.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    /// The nearest number.
    pub nearest: f64,
    /// What is left of it.
    pub rest: f64,
}

impl Exact {
    /// From the first two of `cells`: bits, and a decimal.
    ///
    /// # Panics
    /// If they hold something else.
    pub fn read(cells: &[&str]) -> Self {
        Self { nearest: bits(cells[0]), rest: cells[1].parse().expect("a decimal") }
    }

    /// |x − this|.
    pub fn distance(self, x: f64) -> f64 {
        ((x - self.nearest) - self.rest).abs()
    }
}

/// The cells of each line that isn't a comment.
pub fn rows(text: &str) -> impl Iterator<Item = Vec<&str>> {
    text.lines().filter(|line| !line.starts_with('#')).map(|line| line.split(',').collect())
}

/// The number whose bits are written in hexadecimal.
///
/// # Panics
/// If they aren't.
pub fn bits(cell: &str) -> f64 {
    f64::from_bits(u64::from_str_radix(cell, 16).expect("the bits of an f64"))
}
