//! The two types as the analysis of programs sees them: units, ranges, rounding.

use crate::parse::Float;
use pendulum_runtime::double::Double;
use std::ops::RangeInclusive;

impl Float {
    /// Adding this number rounds to an integer, held in the low bits of the sum: 1.5·2⁵² or 1.5·2²³, for magnitudes
    /// below a third of it.
    pub(crate) const fn magic(self) -> f64 {
        match self {
            Self::F64 => (3_u64 << 51) as f64,
            Self::F32 => (3_u64 << 22) as f64,
        }
    }

    /// Half the distance from 1 to the next number.
    pub(crate) const fn rounding_unit(self) -> f64 {
        match self {
            Self::F64 => f64::EPSILON / 2.0,
            Self::F32 => f32::EPSILON as f64 / 2.0,
        }
    }

    /// The least normal number.
    pub(crate) const fn least_normal(self) -> f64 {
        match self {
            Self::F64 => f64::MIN_POSITIVE,
            Self::F32 => f32::MIN_POSITIVE as f64,
        }
    }

    /// The largest finite number.
    pub(crate) const fn largest(self) -> f64 {
        match self {
            Self::F64 => f64::MAX,
            Self::F32 => f32::MAX as f64,
        }
    }

    /// Numbers whose products with others of a plan, in two words or squared in part, neither over- nor underflow.
    pub(crate) fn moderate(self) -> RangeInclusive<f64> {
        let most = match self {
            Self::F64 => 1e280,
            Self::F32 => 1e30,
        };
        1.0 / most..=most
    }

    /// Significant bits.
    pub(crate) const fn bits(self) -> i32 {
        match self {
            Self::F64 => 53,
            Self::F32 => 24,
        }
    }

    /// x rounded to this type.
    pub(crate) fn round(self, x: f64) -> f64 {
        match self {
            Self::F64 => x,
            Self::F32 => f64::from(x as f32),
        }
    }

    /// What rounding to this type leaves of x.
    pub(crate) fn rest(self, x: Double) -> f64 {
        (x.hi - self.round(x.hi)) + x.lo
    }

    /// A number of the type that is not below `x`.
    pub(crate) fn round_up(self, x: f64) -> f64 {
        match self {
            Self::F64 => x,
            Self::F32 => {
                let rounded = x as f32;
                f64::from(if f64::from(rounded) < x { rounded.next_up() } else { rounded })
            }
        }
    }

    /// A number of the type that is not above `x`.
    pub(crate) fn round_down(self, x: f64) -> f64 {
        -self.round_up(-x)
    }
}
