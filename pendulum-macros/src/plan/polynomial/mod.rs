//! Polynomials in the square of the phase about an anchor.
//!
//! About a turning point θ is an even function of the phase s, and analytic in p = s² farther than in any variable
//! centred at the lowest point: its nearest singularities lie above the lowest point, s = ½ ± iK′/(2K), at the end of
//! the interval and not over its middle. At 7π/8 each coefficient gains a factor 4.47, against 2.71 for an odd
//! polynomial about the lowest point.

mod approximation;
pub(crate) mod pade;
mod pole;
mod tail;

pub(crate) use approximation::Approximation;

use super::blocks::Blocks;
use super::form::Form;
use super::moebius::Moebius;
use super::part::Variant;
use super::variables::Variables;
use crate::program::{Builder, Id};
use crate::series::Parity;
use pendulum_runtime::double::Double;
pub(crate) use pole::Pole;

/// A polynomial, or a quotient, to be evaluated.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polynomial {
    pub(crate) form: Form,
    /// What the form's variable is more than p.
    shift: Double,
    pole: Option<Pole>,
    pub(crate) parity: Parity,
    map: Option<Moebius>,
    pub(crate) alternates: bool,
    /// The coefficients of the form's variable, as they are evaluated.
    blocks: Blocks,
    /// sup |approximation − curve|.
    pub(crate) truncation: f64,
}

impl Polynomial {
    /// Evaluates it, with its sign.
    pub(crate) fn lower(&self, b: &mut Builder, variables: &Variables, name: &'static str) -> Id {
        let value = self.magnitude(b, variables);
        b.name(value, name);
        variables.signed(b, value, self.alternates, self.parity)
    }

    /// Evaluates it, but for the sign that the anchor and the side of the lowest point give.
    pub(crate) fn magnitude(&self, b: &mut Builder, variables: &Variables) -> Id {
        self.times(b, variables, false)
    }

    /// The same, one of two with the same poles: one division serves both.
    pub(crate) fn one_of_two(&self, b: &mut Builder, variables: &Variables) -> Id {
        self.times(b, variables, true)
    }

    /// The polynomial times an odd curve's phase, over its poles. What is divided is the phase, or 1, while the
    /// polynomial is evaluated: nothing waits for it.
    fn times(&self, b: &mut Builder, variables: &Variables, one_of_two: bool) -> Id {
        let phase = (self.parity == Parity::Odd).then_some(variables.distance);
        let factor = match (self.pole, phase) {
            (None, phase) => phase,
            (Some(pole), Some(_)) if !one_of_two => Some(pole.divide_phase(b, variables)),
            (Some(pole), phase) => {
                let one = b.constant(1.0);
                let inverse = pole.divide(b, one, variables);
                Some(phase.map_or(inverse, |phase| b.mul(phase, inverse)))
            }
        };
        let value = self.value(b, variables);
        factor.map_or(value, |factor| b.mul(factor, value))
    }

    /// Of the variable alone.
    fn value(&self, b: &mut Builder, variables: &Variables) -> Id {
        let variables = &self.map.map_or(*variables, |map| variables.mapped(b, map));
        let y = if self.form == Form::Normalised { variables.normalised(b) } else { variables.shifted(b, self.shift) };
        self.blocks.lower(b, y)
    }

    /// Whether, of the two factors of sin θ, this is the one that changes its sign in a mirror.
    pub(crate) fn mirrors(&self, from_top: bool) -> bool {
        if from_top { self.parity == Parity::Odd } else { self.alternates }
    }

    /// How it approximates its curve.
    pub(crate) fn variant(&self) -> Variant {
        Variant { form: self.form, divided: self.pole.is_some() }
    }

    pub(crate) fn terms(&self) -> usize {
        self.blocks.terms()
    }

    pub(crate) fn negate(&mut self) {
        self.blocks.negate();
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        let terms = self.terms();
        let over = self.pole.map_or(String::new(), |pole| format!(" over one of {}", pole.terms()));
        let adapted = matches!(self.form, Form::Adapted { .. });
        let shift = if adapted && self.shift != Double::ZERO { " + c" } else { "" };
        let (variable, how) = (self.form.variable(self.parity), self.blocks.describe());
        let image = self.map.map_or(String::new(), |map| format!(", s² replaced by {}", map.describe()));
        format!("polynomial of {terms} terms in {variable}{shift}{over}{image}{how}")
    }
}
