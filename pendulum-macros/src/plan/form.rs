//! The forms of a polynomial: its variable, the scheme of its evaluation, and what that costs.

use super::adapted;
use crate::program::cost::QUOTIENT;
use crate::series::Parity;

/// The variable of the polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Form {
    /// Powers of p: the cheapest, for few terms.
    Plain,
    /// Powers of u = 8p − centre: well conditioned, most so where the centre is near the end where the curve bends.
    Centred { centre: f64 },
    /// Powers of p + c, by [`adapted`] coefficients in blocks of `chunk` terms: the fewest operations, the most
    /// rounding.
    Adapted { chunk: usize },
}

/// What stands for the square of the phase, for the reader.
pub(super) fn square(parity: Parity) -> &'static str {
    if parity == Parity::Neither { "s + ½" } else { "s²" }
}

impl Form {
    /// All that are tried.
    pub(crate) const ALL: [Self; 6] = [
        Self::Adapted { chunk: 16 },
        Self::Adapted { chunk: 8 },
        Self::Adapted { chunk: 4 },
        Self::Plain,
        Self::Centred { centre: 1.0 },
        Self::Centred { centre: 1.25 },
    ];

    /// Whether no smaller blocks hold as many terms.
    pub(crate) fn suits(self, terms: usize) -> bool {
        !matches!(self, Self::Adapted { chunk: chunk @ 5.. } if terms <= chunk / 2)
    }

    /// Operations that make the variables of p: y and w, of which small blocks mostly do without a shift; the centred
    /// one, which poles are divided out in, too.
    pub(crate) fn variables(self, divided: bool) -> f64 {
        let own = match self {
            Self::Plain => 0.0,
            Self::Adapted { chunk: ..=4 } => 1.0,
            Self::Centred { .. } | Self::Adapted { .. } => 2.0,
        };
        let centred = matches!(self, Self::Centred { .. });
        own + if divided && !centred { 2.0 } else { 0.0 }
    }

    /// Estimated cost of a polynomial of that many terms, given the variables: see [`Program::cost`].
    ///
    /// [`Program::cost`]: crate::program::Program::cost
    pub(crate) fn cost(self, terms: usize, divided: bool) -> f64 {
        let levels = terms.next_power_of_two().ilog2() as usize;
        let (operations, chain) = match self {
            Self::Plain | Self::Centred { .. } => (2 * (terms - 1) + levels - 1, adapted::STEP * levels),
            Self::Adapted { chunk } => (adapted::operations(terms, chunk), adapted::chain(terms, chunk)),
        };
        // The division, and the three operations of a pole.
        let (quotient, wait) = if divided { (QUOTIENT + 3.0, DIVISION) } else { (0.0, 0) };
        operations as f64 + quotient + WAITING * (chain + wait).saturating_sub(HIDDEN) as f64
    }

    /// The variable, for the reader; s is the phase in half periods (turns), or in arcs.
    pub(crate) fn variable(self, parity: Parity) -> String {
        let square = square(parity);
        match self {
            Self::Plain => square.to_owned(),
            Self::Centred { centre } if parity == Parity::Neither => format!("2s + {}", 1.0 - centre),
            Self::Centred { centre } => format!("8s² − {centre}"),
            Self::Adapted { chunk } => format!("{square}, adapted in blocks of {chunk}"),
        }
    }

    /// The centre of the centred variable, which the division by a pole needs in any case.
    pub(crate) fn centre(self) -> f64 {
        match self {
            Self::Plain | Self::Adapted { .. } => 1.0,
            Self::Centred { centre } => centre,
        }
    }
}

/// Processors look only so far ahead for something else to do: beyond `HIDDEN` cycles of a polynomial's dependent
/// operations, each costs `WAITING` operations in an array loop. Fitted to the times of plans of 4 to 18 terms in each
/// form, on x86-64.
const WAITING: f64 = 0.5;
const HIDDEN: usize = 20;
/// Cycles that a division takes.
const DIVISION: usize = 13;
