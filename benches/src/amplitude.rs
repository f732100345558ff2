//! The release angles of the benchmark.

use std::f64::consts::PI;

/// A release angle as a fraction of π.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Amplitude {
    /// As it is written in figures and tables.
    pub name: &'static str,
    /// As it is written in file names.
    pub slug: &'static str,
    /// θ0/π is `numerator / denominator`.
    pub numerator: u32,
    /// See `numerator`.
    pub denominator: u32,
    /// 100 periods, rounded up: `t_max` of the plans with a horizon, which are written with it.
    pub t_max: u32,
}

impl Amplitude {
    /// π/3, moderate.
    pub const MODERATE: Self = Self { name: "π/3", slug: "pi_3", numerator: 1, denominator: 3, t_max: 675 };
    /// 7π/8, large: the angle that the targets are stated for.
    pub const LARGE: Self = Self { name: "7π/8", slug: "7pi_8", numerator: 7, denominator: 8, t_max: 1217 };
    /// 0.999π, near the top.
    pub const NEAR_TOP: Self =
        Self { name: "0.999π", slug: "0.999pi", numerator: 999, denominator: 1000, t_max: 3137 };
    /// 0.999999π, nearer than polynomials go.
    pub const NEXT_TO_TOP: Self =
        Self { name: "0.999999π", slug: "0.999999pi", numerator: 999_999, denominator: 1_000_000, t_max: 5901 };
    /// All of them.
    pub const ALL: [Self; 4] = [Self::MODERATE, Self::LARGE, Self::NEAR_TOP, Self::NEXT_TO_TOP];

    /// θ0 to about an ulp: what a program with this amplitude in an `f64` works with.
    pub fn theta0(self) -> f64 {
        f64::from(self.numerator) * PI / f64::from(self.denominator)
    }
}
