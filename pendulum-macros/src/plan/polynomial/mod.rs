//! Polynomials in the square of the phase about an anchor.
//!
//! About a turning point θ is an even function of the phase s, and analytic in p = s² farther than in any variable
//! centred at the lowest point: its nearest singularities lie above the lowest point, s = ½ ± iK′/(2K), at the end of
//! the interval and not over its middle. At 7π/8 each coefficient gains a factor 4.47, against 2.71 for an odd
//! polynomial about the lowest point.

mod approximation;
mod pole;

pub(crate) use approximation::Approximation;

use super::adapted::Adapted;
use super::estrin::estrin;
use super::form::Form;
use super::moebius::Moebius;
use super::variables::Variables;
use crate::parse::Float;
use crate::program::{Builder, Id};
use crate::series::Parity;
use pendulum_runtime::double::Double;
use pole::Pole;

/// A polynomial, or a quotient, to be evaluated.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polynomial {
    pub(crate) form: Form,
    pole: Option<Pole>,
    pub(crate) parity: Parity,
    map: Option<Moebius>,
    pub(crate) alternates: bool,
    /// Powers of the form's variable, lowest first.
    pub(crate) coefficients: Vec<Double>,
    /// How it is evaluated if not by its powers.
    adapted: Option<Adapted>,
    /// sup |approximation − curve|.
    pub(crate) truncation: f64,
}

/// Names of the powers that the evaluation of a polynomial squares its variable to.
const PLAIN_POWERS: [&str; 8] = ["p", "p2", "p4", "p8", "p16", "p32", "p64", "p128"];
const CENTRED_POWERS: [&str; 8] = ["u", "u2", "u4", "u8", "u16", "u32", "u64", "u128"];

impl Polynomial {
    /// Whether no power of the variable, and no second word of a coefficient, comes near overflow or underflow:
    /// amplitudes of 1e-268 and periods of 1e150 have plans, but not by adapted coefficients.
    fn is_moderate(&self, quarter: f64, float: Float) -> bool {
        let widest = if float == Float::F64 { 1e12 } else { 1e3 };
        let largest = self
            .coefficients
            .iter()
            .fold((0.0, 1.0), |(most, power): (f64, f64), c| (most.max((c.hi * power).abs()), power * quarter));
        (1.0 / widest..widest).contains(&quarter) && (1e-150..1e150).contains(&largest.0)
    }

    /// Evaluates it, with its sign.
    pub(crate) fn lower(&self, b: &mut Builder, variables: &Variables, name: &'static str) -> Id {
        let value = self.magnitude(b, variables);
        b.name(value, name);
        match (self.alternates, self.parity) {
            (true, parity) => variables.sign(b, value, parity),
            (false, Parity::Odd) => variables.sign_of_odd(b, value),
            (false, Parity::Even | Parity::Neither) => value,
        }
    }

    /// Evaluates it, but for the sign that the anchor and the side of the lowest point give.
    pub(crate) fn magnitude(&self, b: &mut Builder, variables: &Variables) -> Id {
        let variables = &self.map.map_or(*variables, |map| variables.mapped(b, map));
        let mut value = match &self.adapted {
            Some(adapted) => {
                let y = variables.shifted(b, adapted.shift);
                adapted.lower(b, y)
            }
            None => self.by_powers(b, variables),
        };
        if let Some(pole) = self.pole {
            let centre = self.form.centre();
            let centred = variables.centred(b, centre);
            value = pole.divide(b, value, centred, centre);
        }
        if self.parity == Parity::Odd {
            value = b.mul(variables.distance, value);
        }
        value
    }

    fn by_powers(&self, b: &mut Builder, variables: &Variables) -> Id {
        let (x, powers) = match self.form {
            Form::Centred { centre } => (variables.centred(b, centre), &CENTRED_POWERS),
            Form::Plain | Form::Adapted { .. } => (variables.shifted(b, 0.0), &PLAIN_POWERS),
        };
        let coefficients: Vec<Id> = self.coefficients.iter().map(|c| b.exact(c.hi, c.lo)).collect();
        estrin(b, x, &coefficients, powers)
    }

    /// Whether, of the two factors of sin θ, this is the one that changes its sign in a mirror.
    pub(crate) fn mirrors(&self, from_top: bool) -> bool {
        if from_top { self.parity == Parity::Odd } else { self.alternates }
    }

    pub(crate) fn negate(&mut self) {
        self.coefficients.iter_mut().for_each(|c| *c = -*c);
        if let Some(adapted) = &mut self.adapted {
            adapted.negate();
        }
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        let terms = self.coefficients.len();
        let over = self.pole.map_or(String::new(), |pole| format!(" over one of {}", pole.terms()));
        let (variable, how) = match &self.adapted {
            Some(adapted) => (adapted.variable(self.parity), adapted.describe()),
            None => (self.form.variable(self.parity), String::new()),
        };
        let image = self.map.map_or(String::new(), |map| format!(", s² replaced by {}", map.describe()));
        format!("polynomial of {terms} terms in {variable}{over}{image}{how}")
    }
}
