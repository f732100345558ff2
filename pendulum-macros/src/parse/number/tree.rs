//! The tree of an expression: how many digits it has, its unit, its value.

use crate::exact::{Context, Real};
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
                let (mantissa, exponent) = digits.split_once(['e', 'E']).unwrap_or((digits, "0"));
                let exponent = if in_sum { exponent.parse::<i64>().unwrap_or(0) } else { 0 };
                mantissa.len() + exponent.unsigned_abs() as usize
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
    fn angles(&self) -> i32 {
        match self {
            Self::Literal { unit, .. } => i32::from(matches!(unit, Unit::Degree | Unit::Radian)),
            Self::Pi => 0,
            Self::Negative(inner) => inner.angles(),
            Self::Root(inner, _) => inner.angles() / 2,
            Self::Binary { left, operator, right, .. } => match operator {
                Operator::Add | Operator::Subtract => left.angles().max(right.angles()),
                Operator::Multiply => left.angles() + right.angles(),
                Operator::Divide => left.angles() - right.angles(),
            },
        }
    }

    pub(super) fn evaluate(&self, context: Context) -> Result<Real> {
        Ok(match self {
            Self::Literal { digits, unit, span } => {
                let value = context
                    .decimal(digits)
                    .ok_or_else(|| Error::new(*span, format!("`{digits}` is not a decimal number")))?;
                match unit {
                    Unit::None | Unit::Radian => value,
                    Unit::Pi => value * context.pi(),
                    Unit::Degree => value * context.pi() / context.integer(180),
                }
            }
            Self::Pi => context.pi(),
            Self::Negative(inner) => -inner.evaluate(context)?,
            Self::Root(inner, span) => {
                let value = inner.evaluate(context)?;
                if value.is_negative() {
                    let shown = value.to_f64();
                    return Err(Error::new(
                        *span,
                        format!("`sqrt` of a negative number, {shown:?}: its argument has to be 0 or more"),
                    ));
                }
                value.sqrt()
            }
            Self::Binary { left, operator, right, blame } => {
                if *operator == Operator::Multiply && left.angles() > 0 && right.angles() > 0 {
                    let message = "an angle times an angle is no angle: leave out one of the units";
                    return Err(Error::new_spanned(blame, message));
                }
                let (left, right) = (left.evaluate(context)?, right.evaluate(context)?);
                match operator {
                    Operator::Add => sum_of(&left, &right),
                    Operator::Subtract => sum_of(&left, &-right),
                    Operator::Multiply => left * right,
                    Operator::Divide if right.is_zero() => {
                        return Err(Error::new_spanned(
                            blame,
                            "division by zero: this divisor is 0, and has to be another number",
                        ));
                    }
                    Operator::Divide => left / right,
                }
            }
        })
    }
}

/// A sum whose terms cancel to below the resolution is zero: `sqrt(2)*sqrt(2) - 2` is not a rounding error.
fn sum_of(left: &Real, right: &Real) -> Real {
    let sum = left + right;
    if sum.abs() <= left.abs() * left.context().resolution() { left.context().integer(0) } else { sum }
}
