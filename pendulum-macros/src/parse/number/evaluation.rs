//! The value of an expression, at a precision at which as many of its bits are known as are asked for.
//!
//! Terms of a sum may cancel, and what is left of them again: 1/(1 + x) − 1 + x is about x², of numbers that have the
//! digits of x. So each value comes with how many of its last bits may be wrong, and where these are too many, all is
//! computed with more.

use super::literal::MOST_DIGITS;
use super::tree::{Operator, Tree, Unit};
use crate::exact::{Context, Real};
use syn::{Error, Result};

/// Last bits of which it doesn't matter whether they are right: half of those below [`Context::resolution`], since squares
/// of values are told from each other.
const NEGLIGIBLE: i64 = 32;

/// The value, in the precision of `context`, of whose bits all but the [`NEGLIGIBLE`] are right. A sum that can't be told
/// from zero with [`MOST_DIGITS`], or with twice the precision that is asked for, is zero: √2·√2 − 2.
pub(super) fn value(tree: &Tree, context: Context) -> Result<Real> {
    let most = Context::for_digits(MOST_DIGITS).bits().max(2 * context.bits());
    let mut precision = context;
    loop {
        let mut evaluation = Evaluation { context: precision, wrong: 0, is_doubtful: false };
        let value = evaluation.of(tree);
        let bits = precision.bits();
        let missing = context.bits() - NEGLIGIBLE - (bits - evaluation.wrong);
        let more = if evaluation.is_doubtful && bits < most { bits.min(most - bits) } else { missing };
        if more <= 0 {
            return value.map(|value| value.real.within(context));
        }
        precision = precision.widened(more.unsigned_abs() as usize);
    }
}

/// A value in so many bits that is wrong by less than 2^(e − bits + wrong) if it is from 2^(e − 1) to 2ᵉ. Zero is zero.
struct Value {
    real: Real,
    wrong: i64,
}

impl Value {
    /// The logarithm of what it is wrong by.
    fn error(&self) -> i64 {
        self.real.exponent_above() - self.real.context().bits() + self.wrong
    }
}

/// The values of all parts of an expression at one precision.
struct Evaluation {
    context: Context,
    /// The most that any of them is wrong by.
    wrong: i64,
    /// Whether there is a sum that may be zero, for all that is known.
    is_doubtful: bool,
}

impl Evaluation {
    fn of(&mut self, tree: &Tree) -> Result<Value> {
        tree.check_unit()?;
        let value = match tree {
            Tree::Literal { digits, unit, span } => {
                let value = self.context.decimal(digits);
                let value = value.ok_or_else(|| Error::new(*span, format!("`{digits}` is not a decimal number")))?;
                self.in_unit(value, *unit)
            }
            Tree::Pi => Value { real: self.context.pi(), wrong: 1 },
            Tree::Negative(inner) => {
                let Value { real, wrong } = self.of(inner)?;
                Value { real: -real, wrong }
            }
            Tree::Root(inner, span) => {
                let Value { real, wrong } = self.of(inner)?;
                if real.is_negative() {
                    let shown = real.to_f64();
                    return Err(Error::new(
                        *span,
                        format!("`sqrt` of a negative number, {shown:?}: its argument has to be 0 or more"),
                    ));
                }
                Value { real: real.sqrt(), wrong: wrong + 2 }
            }
            Tree::Binary { left, operator, right, blame } => {
                let (left, mut right) = both(self.of(left), self.of(right))?;
                match operator {
                    Operator::Add => self.sum(&left, &right),
                    Operator::Subtract => {
                        right.real = -right.real;
                        self.sum(&left, &right)
                    }
                    Operator::Multiply => product(left.real * right.real, left.wrong.max(right.wrong)),
                    Operator::Divide if right.real.is_zero() => {
                        return Err(Error::new_spanned(
                            blame,
                            "division by zero: this divisor is 0, and has to be another number",
                        ));
                    }
                    Operator::Divide => product(left.real / right.real, left.wrong.max(right.wrong)),
                }
            }
        };
        self.wrong = self.wrong.max(value.wrong);
        Ok(value)
    }

    fn in_unit(&self, literal: Real, unit: Unit) -> Value {
        match unit {
            Unit::None | Unit::Radian => Value { real: literal, wrong: 1 },
            Unit::Pi => product(literal * self.context.pi(), 1),
            Unit::Degree => product(literal * self.context.pi() / self.context.integer(180), 3),
        }
    }

    /// Wrong by what both terms are, twice the larger at most, and by half of its last bit.
    fn sum(&mut self, left: &Value, right: &Value) -> Value {
        let real = &left.real + &right.real;
        let error = left.error().max(right.error()) + 1;
        let last = real.exponent_above() - self.context.bits();
        if real.exponent_above() > error {
            return Value { real, wrong: (error - last).max(0) + 1 };
        }
        self.is_doubtful |= !(left.real.is_zero() && right.real.is_zero());
        Value { real: self.context.integer(0), wrong: 0 }
    }
}

/// Both values, or the mistakes of both.
fn both<T>(left: Result<T>, right: Result<T>) -> Result<(T, T)> {
    match (left, right) {
        (Ok(left), Ok(right)) => Ok((left, right)),
        (Err(mut first), Err(second)) => {
            first.combine(second);
            Err(first)
        }
        (Err(error), _) | (_, Err(error)) => Err(error),
    }
}

/// A product or quotient of two values, of whose bits so many may be wrong: relative to them, that is up to two times
/// 2^(1 − bits + wrong), and half of its own last bit.
fn product(real: Real, wrong: i64) -> Value {
    Value { real, wrong: wrong + 3 }
}
