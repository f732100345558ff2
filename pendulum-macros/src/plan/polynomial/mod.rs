//! Polynomials in the square of the phase about an anchor.
//!
//! About a turning point θ is an even function of the phase s, and analytic in p = s² farther than in any variable
//! centred at the lowest point: its nearest singularities lie above the lowest point, s = ½ ± iK′/(2K), at the end of
//! the interval and not over its middle. At 7π/8 each coefficient gains a factor 4.48, against 2.72 for an odd
//! polynomial about the lowest point.

mod approximation;
pub(super) mod interval;
mod leeway;
mod nearest;
pub(crate) mod pade;
mod pole;
mod tail;
mod truncated;
mod weight;

pub(crate) use approximation::Approximation;
pub(in crate::plan) use approximation::Growth;
pub(crate) use leeway::Leeway;

use super::blocks::{Blocks, one_by_one};
use super::form::{Form, Poles, Variant};
use super::moebius::Moebius;
use super::phases::rounding_of;
use super::reduction::Reduction;
use super::variables::{Unlimited, Variables};
use crate::program::{Builder, Id, RESULT};
use crate::series::Parity;
use pendulum_runtime::double::Double;
pub(crate) use pole::Pole;

/// A polynomial, or a quotient, to be evaluated.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polynomial {
    pub(crate) form: Form,
    /// What the form's variable is more than p.
    shift: Double,
    divided: Divided,
    pub(crate) parity: Parity,
    map: Option<Moebius>,
    pub(crate) alternates: bool,
    /// The coefficients of the form's variable, as they are evaluated.
    blocks: Blocks,
    /// sup |approximation − curve|, less what a leeway spares.
    pub(crate) truncation: f64,
}

/// What is divided by poles.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Divided {
    Nothing,
    /// The polynomial, times a number; of a single odd curve that is 1.
    Whole {
        numerator: Double,
        pole: Pole,
    },
    /// What is added to it.
    Rest(Pole, Remainder),
}

/// What is over poles beside a polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Remainder {
    /// In powers of the form's variable.
    powers: [Double; 2],
    /// Whether the polynomial without it is within the range of values where the interval ends.
    dispensable: bool,
}

/// What is over the poles that a polynomial is multiplied with.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Numerator {
    /// 1, or the phase of an odd curve.
    One,
    /// The leading coefficient, which the polynomial then does without: one multiplication less.
    Leading,
    /// That of another polynomial over the same poles.
    Same(Double),
}

impl Polynomial {
    /// Evaluates it, with its sign. That is known long before the polynomial is: what the polynomial is multiplied with
    /// takes it, if anything, and nothing waits for it.
    pub(crate) fn lower(&self, b: &mut Builder, variables: &Variables, name: &'static str) -> Id {
        let (value, signed) = self.product(b, variables);
        b.name(value, name);
        if signed { value } else { self.signed(b, variables, value) }
    }

    /// The rounding over the whole range of the phase, taken as exact; some number above `cap` as soon as it is known to
    /// be.
    pub(in crate::plan) fn rounding(&self, reduction: &Reduction, cap: f64) -> f64 {
        let odd = self.parity == Parity::Odd;
        rounding_of(reduction, odd, cap, |b, variables| vec![self.lower(b, variables, RESULT)])
    }

    /// Evaluates it, but for the sign that the anchor and the side of the lowest point give.
    pub(crate) fn magnitude(&self, b: &mut Builder, variables: &Variables) -> Id {
        self.product(b, &variables.unsigned()).0
    }

    /// The same, one of two with the same poles and the same number over them: one division serves both.
    pub(crate) fn one_of_two(&self, b: &mut Builder, variables: &Variables) -> Id {
        let inverse = self.over().map(|(numerator, pole)| {
            let numerator = b.rounded(numerator);
            pole.divide(b, numerator, variables)
        });
        let phase = (self.parity == Parity::Odd).then_some(variables.distance);
        let both = phase.zip(inverse).map(|(phase, inverse)| b.mul(phase, inverse));
        self.times(b, variables, both.or(phase).or(inverse), None)
    }

    /// The polynomial times its factor, if it has one, and whether that has taken the sign.
    fn product(&self, b: &mut Builder, variables: &Variables) -> (Id, bool) {
        let unlimited = self.unlimited(variables);
        let factor = self.factor(b, variables, unlimited);
        (self.times(b, variables, factor, unlimited), factor.is_some())
    }

    /// The poles that the polynomial is over, and the number that is over them, too.
    fn over(&self) -> Option<(Double, Pole)> {
        if let Divided::Whole { numerator, pole } = self.divided { Some((numerator, pole)) } else { None }
    }

    /// What the polynomial is multiplied with, if anything: an odd curve's phase, or a number, with the sign and over poles.
    /// It is divided while the polynomial is evaluated.
    fn factor(&self, b: &mut Builder, variables: &Variables, unlimited: Option<Unlimited>) -> Option<Id> {
        let odd = self.parity == Parity::Odd;
        let Some((numerator, pole)) = self.over() else {
            return odd.then(|| self.signed(b, variables, variables.distance));
        };
        let variables = unlimited.map_or(*variables, |unlimited| variables.without(unlimited));
        let magnitude = if odd { variables.distance } else { b.rounded(numerator) };
        let signed = self.signed(b, &variables, magnitude);
        if signed != magnitude {
            b.name(signed, "signed");
        }
        Some(pole.divide(b, signed, &variables))
    }

    fn signed(&self, b: &mut Builder, variables: &Variables, value: Id) -> Id {
        variables.signed(b, value, self.alternates, self.parity)
    }

    /// The phase without limits, if what is divided may be of that. The polynomial's variable is kept within limits beyond
    /// the horizon; but of a curve on both sides of 0 there may be less, where the divisor grows, or a phase leaps to where
    /// it is less over that. What is beside poles goes from the whole to what it is without them.
    fn unlimited(&self, variables: &Variables) -> Option<Unlimited> {
        let (pole, dispensable) = match self.divided {
            Divided::Nothing => return None,
            Divided::Whole { pole, .. } => (pole, true),
            Divided::Rest(pole, Remainder { dispensable, .. }) => (pole, dispensable),
        };
        variables.unlimited.filter(|&Unlimited { half, leaps, .. }| {
            let less = if self.parity == Parity::Odd {
                leaps && pole.falls(half)
            } else {
                self.alternates && pole.grows(half) && !self.is_of_one_use()
            };
            less && dispensable
        })
    }

    /// Whether it uses its variable once. LLVM makes a choice of results of a limit that is used once, if what is limited
    /// has other uses: four operations in place of one. Results are limited instead, where that saves the limits of what is
    /// divided; of an even curve these are the variable's own.
    fn is_of_one_use(&self) -> bool {
        self.terms() < 3 || self.form == Form::Normalised
    }

    /// The polynomial times a factor, if any; `unlimited` is what that is of.
    fn times(&self, b: &mut Builder, variables: &Variables, factor: Option<Id>, unlimited: Option<Unlimited>) -> Id {
        let value = self.value(b, variables, unlimited);
        factor.map_or(value, |factor| b.mul(factor, value))
    }

    fn value(&self, b: &mut Builder, variables: &Variables, unlimited: Option<Unlimited>) -> Id {
        let variables = &self.map.map_or(*variables, |map| variables.mapped(b, map));
        // Where another kernel uses p, too, p is there.
        let late = unlimited.filter(|_| variables.alone && (self.shift != Double::ZERO || self.is_of_one_use()));
        let argument = |b: &mut Builder, variables: &Variables| match self.form {
            Form::Normalised => variables.normalised(b),
            _ => variables.shifted(b, self.shift),
        };
        let of = |b: &mut Builder, p: Id| argument(b, &Variables { p, ..*variables });
        let y = match late {
            Some(unlimited) if self.terms() < 3 => {
                debug_assert!(!matches!(self.divided, Divided::Rest(..)) && self.map.is_none(), "a fraction, or a map");
                return unlimited.limited(b, |b, p| {
                    let y = of(b, p);
                    self.blocks.lower(b, y)
                });
            }
            Some(unlimited) => unlimited.limited(b, of),
            None => argument(b, variables),
        };
        let fraction = self.fraction(b, unlimited.map_or(*variables, |unlimited| variables.without(unlimited)), y);
        let value = self.blocks.lower(b, y);
        fraction.map_or(value, |fraction| b.add(value, fraction))
    }

    /// What of it is over the poles. It is divided while the rest is evaluated.
    fn fraction(&self, b: &mut Builder, variables: Variables, y: Id) -> Option<Id> {
        let Divided::Rest(pole, Remainder { powers, .. }) = self.divided else { return None };
        let remainder = one_by_one(b, y, &powers);
        let fraction = pole.divide(b, remainder, &variables);
        b.name(fraction, "fraction");
        Some(fraction)
    }

    /// How it approximates its curve.
    pub(crate) fn variant(&self) -> Variant {
        let poles = match self.divided {
            Divided::Nothing => Poles::Absent,
            Divided::Whole { pole, .. } if pole.is_of_two() => Poles::UnderTwo,
            Divided::Whole { .. } => Poles::Under,
            Divided::Rest(..) => Poles::Beside,
        };
        Variant { form: self.form, poles }
    }

    /// Terms, of a quotient those of the numerator.
    pub(crate) fn terms(&self) -> usize {
        let rest = if let Divided::Rest(_, rest) = &self.divided { rest.powers.len() } else { 0 };
        self.blocks.terms() + rest
    }

    /// What waiting for its dependent operations costs.
    pub(crate) fn waiting(&self) -> f64 {
        self.variant().waiting(self.terms())
    }

    /// Its negative. A leading coefficient that was divided out stays 1.
    pub(crate) fn negate(&mut self) {
        match &mut self.divided {
            Divided::Whole { numerator, .. } if self.parity != Parity::Odd && self.blocks.leading() == Double::ONE => {
                *numerator = -*numerator;
            }
            divided => {
                self.blocks.negate();
                if let Divided::Rest(_, Remainder { powers, .. }) = divided {
                    *powers = powers.map(|c| -c);
                }
            }
        }
    }

    /// For another polynomial over the same poles, of which one division serves both.
    pub(crate) fn numerator(&self) -> Numerator {
        self.over().map_or(Numerator::One, |(numerator, _)| Numerator::Same(numerator))
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        let terms = self.blocks.terms();
        let over = match self.divided {
            Divided::Nothing => String::new(),
            Divided::Whole { pole, .. } => format!(" over one of {}", pole.terms()),
            Divided::Rest(pole, rest) => format!(" plus one of {} over one of {}", rest.powers.len(), pole.terms()),
        };
        let adapted = matches!(self.form, Form::Adapted { .. });
        let shift = if adapted && self.shift != Double::ZERO { " (shifted)" } else { "" };
        let (variable, how) = (self.form.variable(self.parity), self.blocks.describe());
        let image = self.map.map_or(String::new(), |map| format!(", s² replaced by {}", map.describe()));
        format!("polynomial of {terms} terms in {variable}{shift}{over}{image}{how}")
    }
}
