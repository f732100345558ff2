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

/// A state of a motion.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// What it starts from.
    pub theta0: f64,
    /// Likewise.
    pub velocity0: f64,
    /// ω.
    pub omega: f64,
    /// When it is there.
    pub t: f64,
    /// Where it is.
    pub theta: Exact,
    /// How fast.
    pub velocity: Exact,
}

/// `reference.csv`: releases from rest and launches from the bottom, ω = 1.
pub fn releases_and_launches() -> impl Iterator<Item = Row> {
    rows(include_str!("../../tests/data/reference.csv")).map(|cells| {
        let parameter = bits(cells[1]);
        let (theta0, velocity0) = if cells[0] == "rest" { (parameter, 0.0) } else { (0.0, parameter) };
        Row {
            theta0,
            velocity0,
            omega: 1.0,
            t: bits(cells[2]),
            theta: Exact::read(&cells[3..]),
            velocity: Exact::read(&cells[5..]),
        }
    })
}

/// `states.csv`: arbitrary states.
pub fn states() -> impl Iterator<Item = Row> {
    rows(include_str!("../../tests/data/states.csv")).map(|cells| Row {
        theta0: bits(cells[0]),
        velocity0: bits(cells[1]),
        omega: bits(cells[2]),
        t: bits(cells[3]),
        theta: Exact::read(&cells[4..]),
        velocity: Exact::read(&cells[6..]),
    })
}

/// `elliptic.csv`: whether the modulus is the complementary one, it, u, φ, and K, K′, q, sn, cn, dn, am, F(φ).
pub fn elliptic() -> impl Iterator<Item = (bool, [f64; 3], [f64; 8])> {
    rows(include_str!("../../tests/data/elliptic.csv")).map(|cells| {
        let at = |i: usize| bits(cells[i]);
        (cells[0] == "kc", core::array::from_fn(|i| at(1 + i)), core::array::from_fn(|i| at(4 + i)))
    })
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
