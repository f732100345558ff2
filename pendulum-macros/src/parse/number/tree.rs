//! The tree of an expression: how many digits it has, and its unit.

use crate::exact::{digits_of_mantissa, mantissa_and_exponent};
use proc_macro2::{Span, TokenStream};
use syn::{Error, Result};

/// An expression; `blame` are the tokens of the right operand.
#[derive(Clone, Debug)]
pub(super) enum Tree {
    Literal { digits: String, unit: Unit, span: Span },
    Pi,
    Negative(Box<Tree>),
    Root(Box<Tree>, Span),
    Binary { left: Box<Tree>, operator: Operator, right: Box<Tree>, blame: TokenStream },
}

/// What a literal carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Unit {
    None,
    Pi,
    Degree,
    Radian,
}

impl Unit {
    /// What a literal with that suffix carries, if there is such a one.
    pub(super) fn of_suffix(suffix: &str) -> Option<Self> {
        match suffix {
            "" => Some(Self::None),
            "π" => Some(Self::Pi),
            "deg" => Some(Self::Degree),
            "rad" => Some(Self::Radian),
            _ => None,
        }
    }
}

/// Whether it is a name of π.
pub(super) fn is_pi(word: &str) -> bool {
    matches!(word, "π" | "PI" | "pi")
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
}

impl Tree {
    pub(super) fn digits(&self, in_sum: bool) -> usize {
        match self {
            Self::Literal { digits, .. } => {
                let exponent = if in_sum { mantissa_and_exponent(digits).1.parse::<i64>().unwrap_or(0) } else { 0 };
                digits_of_mantissa(digits) + exponent.unsigned_abs() as usize
            }
            Self::Pi => 0,
            Self::Negative(inner) | Self::Root(inner, _) => inner.digits(in_sum),
            Self::Binary { left, operator, right, .. } => {
                let is_sum = matches!(operator, Operator::Add | Operator::Subtract);
                let [left, right] = [left, right].map(|side| side.digits(in_sum || is_sum));
                // Exponents of factors add up.
                if in_sum && !is_sum { left + right } else { left.max(right) }
            }
        }
    }

    /// The unit of the first literal that is an angle.
    pub(super) fn angle_unit(&self) -> Option<Unit> {
        match self {
            Self::Literal { unit: unit @ (Unit::Degree | Unit::Radian), .. } => Some(*unit),
            Self::Literal { .. } | Self::Pi => None,
            Self::Negative(inner) | Self::Root(inner, _) => inner.angle_unit(),
            Self::Binary { left, right, .. } => left.angle_unit().or_else(|| right.angle_unit()),
        }
    }

    /// The power of an angle that it is, by the units of its literals: 1 for `90deg`, 0 for `90deg/45deg`.
    pub(super) fn angles(&self) -> i32 {
        match self {
            Self::Literal { unit, .. } => i32::from(matches!(unit, Unit::Degree | Unit::Radian)),
            // What has a root has no unit.
            Self::Pi | Self::Root(..) => 0,
            Self::Negative(inner) => inner.angles(),
            Self::Binary { left, operator, right, .. } => match operator {
                Operator::Add | Operator::Subtract => left.angles().max(right.angles()),
                Operator::Multiply => left.angles() + right.angles(),
                Operator::Divide => left.angles() - right.angles(),
            },
        }
    }

    /// Refuses a power of an angle that is neither an angle nor a number, where its operands are one or the other.
    pub(super) fn check_unit(&self) -> Result<()> {
        match self {
            Self::Root(inner, span) if inner.angles() != 0 => {
                Err(Error::new(*span, "the root of an angle is no angle: leave out its unit"))
            }
            Self::Binary { left, operator, right, blame } => match (operator, left.angles(), right.angles()) {
                (Operator::Multiply, 1.., 1..) => {
                    Err(Error::new_spanned(blame, "an angle times an angle is no angle: leave out one of the units"))
                }
                (Operator::Divide, left, right) if right > left => Err(Error::new_spanned(
                    blame,
                    "a number over an angle is no angle: leave out the unit of this divisor",
                )),
                _ => Ok(()),
            },
            _ => Ok(()),
        }
    }
}
