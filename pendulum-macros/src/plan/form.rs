//! The forms of a polynomial: its variable, the scheme of its evaluation, and what that costs.

use super::blocks::{self, LARGEST_LAST, adapted_in_blocks};
use crate::parse::Float;
use crate::program::cost::QUOTIENT;
use crate::series::Parity;

/// The variable of the polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Form {
    /// Powers of p + `shift`, of which blocks of four are adapted where that loses nothing ([`blocks`]): well conditioned
    /// about the middle of the interval or nearer to the end where the curve bends; without a shift an operation less.
    /// With the largest terms added last it is rounded less, and slower in calls one by one.
    Powers { shift: f64, largest_last: bool },
    /// Powers of 8p − 1, likewise, as well conditioned: where powers of p, the square of a time, would overflow, or
    /// underflow.
    Normalised,
    /// Powers of p + c, by adapted coefficients in blocks of `chunk` terms: the fewest operations, the most rounding.
    Adapted { chunk: usize },
}

/// How a curve is approximated: in which form, and what becomes of its poles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Variant {
    pub(crate) form: Form,
    pub(crate) poles: Poles,
}

/// What becomes of the poles that are divided out of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Poles {
    /// None are.
    Absent,
    /// A polynomial N is divided by theirs, D.
    Under,
    /// The same of two pairs, D a product.
    UnderTwo,
    /// N/D = Q + R/D with R of two terms: rounded less, since what is divided is only a part of the sum.
    Beside,
}

impl Poles {
    pub(crate) const ALL: [Self; 4] = [Self::Absent, Self::Under, Self::UnderTwo, Self::Beside];
}

impl Variant {
    /// For the reader.
    pub(in crate::plan) fn describe(self, parity: Parity) -> String {
        let poles = match self.poles {
            Poles::Absent => "",
            Poles::Under => " over poles",
            Poles::UnderTwo => " over two pairs of poles",
            Poles::Beside => " and poles",
        };
        format!("a polynomial in {}{poles}{}", self.form.variable(parity), self.form.scheme())
    }

    /// Of so many terms those that aren't over poles beside them.
    fn left(self, terms: usize) -> usize {
        if self.poles == Poles::Beside { terms.saturating_sub(2) } else { terms }
    }

    /// Whether it is one for so many terms.
    pub(crate) fn suits(self, terms: usize, float: Float) -> bool {
        let left = self.left(terms);
        // Adapted coefficients are for few operations, and poles may as well be under them.
        let beside = left > 1 && matches!(self.form, Form::Powers { .. });
        (self.poles != Poles::Beside || beside) && self.form.suits(left, float)
    }

    /// Operations that make the variables of so many terms.
    pub(crate) fn variables(self, terms: usize) -> f64 {
        self.form.variables(self.left(terms))
    }

    /// The part of the cost that is no operation.
    pub(crate) fn waiting(self, terms: usize) -> f64 {
        self.form.waiting(self.left(terms)) + if self.poles == Poles::UnderTwo { LATER } else { 0.0 }
    }

    /// Estimated cost of a polynomial of that many terms, given the variables: see [`Program::cost`].
    ///
    /// [`Program::cost`]: crate::program::Program::cost
    pub(crate) fn cost(self, terms: usize, division: Division, float: Float) -> f64 {
        let apart = if division == Division::OfRemainder && float == Float::F64 { APART } else { 0.0 };
        let second = match (self.poles, division) {
            (Poles::UnderTwo, Division::Shared) => 0.5 * (SECOND_PAIR + LATER),
            (Poles::UnderTwo, _) => SECOND_PAIR + LATER,
            _ => 0.0,
        };
        self.form.cost(self.left(terms), division) + apart + second
    }
}

/// How a polynomial comes to be over its poles. In each case the division is done by the time that it is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Division {
    /// It has none.
    None,
    /// The phase that it is multiplied with is divided.
    OfPhase,
    /// It is multiplied with its leading coefficient over them, and does without that itself ([`blocks::saved`]).
    Inverse,
    /// The same, of one of two polynomials of which each is multiplied with that.
    Shared,
    /// Two terms are divided, and added.
    OfRemainder,
}

impl Division {
    /// Its cost: a pole takes three operations.
    fn cost(self) -> f64 {
        match self {
            Self::None => 0.0,
            Self::OfPhase => QUOTIENT + 3.0,
            Self::Inverse => QUOTIENT + 4.0,
            Self::Shared => 0.5 * (QUOTIENT + 2.0) + 1.0,
            Self::OfRemainder => QUOTIENT + 6.0,
        }
    }
}

/// Operations of a second pair of poles.
const SECOND_PAIR: f64 = 4.0;

/// What it costs that the division is later then, in operations. Fitted to the times of plans in array loops: without it
/// pairs were taken that cost up to a fifth more, with 1.5 some left that would save a twelfth.
const LATER: f64 = 1.25;

/// What poles beside a polynomial had better save in `f64`, in operations: compilers don't compute it in one vector with
/// a velocity over poles. To 1e-6 at 7π/8 scalar calls of both take a seventh more time.
const APART: f64 = 2.0;

/// What stands for the square of the phase, for the reader.
fn square(parity: Parity) -> &'static str {
    if parity == Parity::Neither { "s + ½" } else { "s²" }
}

impl Form {
    /// All that are tried.
    pub(crate) const ALL: [Self; 9] = [
        Self::Adapted { chunk: 16 },
        Self::Adapted { chunk: 8 },
        Self::Adapted { chunk: 4 },
        Self::Powers { shift: 0.0, largest_last: false },
        Self::Powers { shift: -0.125, largest_last: false },
        Self::Powers { shift: -0.15625, largest_last: false },
        Self::Powers { shift: -0.125, largest_last: true },
        Self::Powers { shift: -0.15625, largest_last: true },
        Self::Normalised,
    ];

    /// What is added to p.
    pub(crate) fn shift(self) -> f64 {
        if let Self::Powers { shift, .. } = self { shift } else { 0.0 }
    }

    /// Whether the largest terms are added last.
    pub(crate) fn largest_last(self) -> bool {
        matches!(self, Self::Powers { largest_last: true, .. } | Self::Normalised)
    }

    /// Terms of a block.
    fn chunk(self) -> usize {
        if let Self::Adapted { chunk } = self { chunk } else { blocks::LEAST }
    }

    /// Whether it suits so many terms: where no smaller blocks hold as many, and where powers of numbers up to an
    /// eighth don't underflow often, which is slow. In `f32` the sixteenth does for one time in thirty.
    pub(crate) fn suits(self, terms: usize, float: Float) -> bool {
        match self {
            Self::Adapted { chunk } => chunk <= 4 || terms > chunk / 2,
            Self::Powers { .. } => float == Float::F64 || terms <= 16,
            Self::Normalised => true,
        }
    }

    /// Operations that make the variables of p: y, of which small blocks mostly do without a shift, and its square, which
    /// few terms do without.
    pub(crate) fn variables(self, terms: usize) -> f64 {
        let variable = match self {
            Self::Powers { shift: 0.0, .. } | Self::Adapted { chunk: ..=4 } => 0.0,
            Self::Powers { .. } | Self::Adapted { .. } => 1.0,
            Self::Normalised => 2.0,
        };
        variable + if terms < blocks::LEAST { 0.0 } else { 1.0 }
    }

    /// Estimated cost of a polynomial of that many terms, given the variables.
    pub(crate) fn cost(self, terms: usize, division: Division) -> f64 {
        let chunk = self.chunk();
        // The first block isn't adapted by powers, which of fewer terms wouldn't be, either.
        let plain = !matches!(self, Self::Adapted { .. }) && terms >= blocks::LEAST;
        let saved = if division == Division::Inverse { blocks::saved(terms, chunk) } else { 0 };
        let operations = blocks::operations(terms, chunk) + usize::from(plain) - saved;
        operations as f64 + division.cost() + self.waiting(terms)
    }

    /// The part of this that is no operation.
    fn waiting(self, terms: usize) -> f64 {
        let last = if self.largest_last() { blocks::STEP / 2 } else { 0 };
        let chain = blocks::chain(terms, self.chunk()) + last;
        WAITING * chain.saturating_sub(HIDDEN) as f64
    }

    /// The variable, for the reader; s is the phase in half periods (turns), or in arcs.
    pub(crate) fn variable(self, parity: Parity) -> String {
        let square = square(parity);
        let neither = parity == Parity::Neither;
        match self {
            Self::Powers { shift: 0.0, .. } | Self::Adapted { .. } => square.to_owned(),
            Self::Powers { shift: -0.125, .. } if neither => "s".to_owned(),
            Self::Powers { shift, .. } if neither => format!("s − {}", -4.0 * shift - 0.5),
            Self::Powers { shift, .. } => format!("s² − {}", -shift),
            Self::Normalised if neither => "2s".to_owned(),
            Self::Normalised => "8s² − 1".to_owned(),
        }
    }

    /// How it is evaluated, for the reader.
    pub(crate) fn scheme(self) -> String {
        match self {
            Self::Powers { largest_last: false, .. } => ", by powers".to_owned(),
            Self::Powers { .. } | Self::Normalised => LARGEST_LAST.to_owned(),
            Self::Adapted { chunk } => adapted_in_blocks(chunk),
        }
    }
}

/// Processors look only so far ahead for something else to do: beyond `HIDDEN` cycles of a polynomial's dependent
/// operations, each costs `WAITING` operations in an array loop. Fitted to the times of plans of 4 to 18 terms in each
/// form, on x86-64.
const WAITING: f64 = 0.5;
const HIDDEN: usize = 20;

#[cfg(test)]
mod tests {
    use super::*;

    /// Two terms of the numerator are over the poles, and there is a polynomial beside them; of powers only, of which
    /// `f32` holds sixteen.
    #[test]
    fn poles_beside_enough_terms() {
        for form in Form::ALL {
            let suits = |&terms: &usize| Variant { form, poles: Poles::Beside }.suits(terms, Float::F32);
            let suited: Vec<usize> = (1..30).filter(suits).collect();
            let powers = matches!(form, Form::Powers { .. });
            let expected: Vec<usize> = if powers { (4..=18).collect() } else { Vec::new() };
            assert_eq!(suited, expected, "{form:?}");
        }
    }
}
