//! Whether what follows from a motion fits the float: its period, its amplitude, its largest results.

use super::{Checked, Checker};
use crate::exact::Real;
use crate::motion::{Motion, Regime, Rotation, Swing};
use crate::parse::number::Number;
use crate::parse::{Float, Given, Output, Parameter};

/// Below these the products of a plan lose digits to underflow.
const SMALLEST_AMPLITUDE: f64 = 1e-300;
const SMALLEST_AMPLITUDE_F32: f64 = 1e-35;

/// A rotation of κ below 2⁻⁴⁵¹ is faster than 10¹³⁶·ω. Its angle departs from a linear one by κ²/4 or less, of which 2⁻⁹⁰⁴
/// leaves second words (2⁻⁹⁵⁷) and what they are multiplied with room above the least normal number, 2⁻¹⁰²².
const LEAST_MODULUS: i64 = -450;

impl Checker<'_> {
    pub(super) fn representable_motion(&mut self, motion: &Motion) -> Checked<()> {
        match &motion.regime {
            Regime::Swing(swing) => {
                self.representable_result(&swing.period, "the period")?;
                self.has_words(&swing.period)?;
                self.swings_visibly(motion, swing)
            }
            Regime::Rotation(rotation) => {
                self.representable_result(&rotation.period, "the time of one turn")?;
                self.has_words(&rotation.period)?;
                self.turns_unevenly(rotation)
            }
            Regime::Separatrix(_) => Ok(()),
        }
    }

    /// Refuses periods whose inverse isn't the sum of a few normal numbers.
    fn has_words(&mut self, period: &Real) -> Checked<()> {
        let request = self.request;
        let longest = *Float::F64.moderate().end();
        match request.rate().or(request.velocity0.as_ref()) {
            Some(given) if period.to_f64() > longest => {
                let message = format!(
                    "`{given}` makes a period of {:e}, above {longest:e}, where rates lose digits to underflow: count time in a \
                     larger unit",
                    period.to_f64()
                );
                Err(self.refuse(&given.tokens, message))
            }
            _ => Ok(()),
        }
    }

    /// Refuses amplitudes whose products with coefficients would be subnormal.
    fn swings_visibly(&mut self, motion: &Motion, swing: &Swing) -> Checked<()> {
        let least = match self.request.float() {
            Float::F64 => SMALLEST_AMPLITUDE,
            Float::F32 => SMALLEST_AMPLITUDE_F32,
        };
        let (request, wider) = (self.request, self.wider());
        let (given, formula) = match (motion.theta0.is_zero(), motion.velocity0.is_zero()) {
            (true, _) => (&request.velocity0, "(velocity0/ω)·sin ωt"),
            (false, true) => (&request.theta0, "θ0·cos ωt"),
            (false, false) => (&request.theta0, "θ0·cos ωt + (velocity0/ω)·sin ωt"),
        };
        match given {
            Some(given) if swing.amplitude.to_f64() < least => {
                let message = format!(
                    "`{given}` makes an amplitude below {least:e}, where `{}` loses digits: {wider}choose a larger one; \
                     so small a motion is {formula} to the last digit",
                    self.request.float().word()
                );
                Err(self.refuse(&given.tokens, message))
            }
            _ => Ok(()),
        }
    }

    /// Refuses a rotation that hardly knows of the weight: its angle is linear in time beyond any precision.
    fn turns_unevenly(&mut self, rotation: &Rotation) -> Checked<()> {
        let request = self.request;
        match &request.velocity0 {
            Some(given) if rotation.elliptic.modulus.exponent_above() < LEAST_MODULUS => {
                let message = format!(
                    "`{given}` is so fast, beside ω, that the angle is θ0 + velocity0·t to the last digit: compute that"
                );
                Err(self.refuse(&given.tokens, message))
            }
            _ => Ok(()),
        }
    }

    /// Largest |θ̇| and |θ̈|, where they are asked for, have to be normal floats.
    pub(super) fn representable_outputs(&mut self, motion: &Motion, outputs: &[Output]) -> Checked<()> {
        let fastest = motion.fastest();
        if outputs.contains(&Output::Velocity) {
            self.representable_result(&fastest, "the largest velocity")?;
        }
        if outputs.contains(&Output::Acceleration) {
            // sin θ of a swing is at most 2kk′ or 1, whichever its amplitude allows; 2kk′ ≥ k while k′ ≥ ½.
            let steepest = match &motion.regime {
                Regime::Swing(swing) if swing.elliptic.modulus < self.context.ratio(1, 2) => &swing.elliptic.modulus,
                _ => &self.context.integer(1),
            };
            self.representable_result(&(motion.omega.square() * steepest), "the largest acceleration")?;
            if self.request.float() == Float::F64 {
                self.acceleration_is_tame(motion, &fastest)?;
            }
        }
        Ok(())
    }

    /// What an acceleration and its error are computed with has to be within `f64`, even where its values are.
    fn acceleration_is_tame(&mut self, motion: &Motion, fastest: &Real) -> Checked<()> {
        if let Regime::Rotation(_) = &motion.regime {
            self.representable_result(&fastest.square(), "the square of the largest velocity")?;
        }
        // θ⃛ = −ω²θ̇ cos θ, by which an error of the phase counts; too small it doesn't.
        let jerk = motion.omega.square() * fastest;
        if jerk > self.context.integer(1) {
            self.representable_result(&jerk, "the steepest change of the acceleration")?;
        }
        Ok(())
    }

    /// A value that follows from the rate: blame what sets it.
    fn representable_result(&mut self, value: &Real, what: &str) -> Checked<()> {
        let request = self.request;
        let given = request.rate().or(request.velocity0.as_ref()).or(request.theta0.as_ref());
        match given {
            Some(given) => self.representable(value, what, given),
            None => Ok(()),
        }
    }

    /// Refuses what rounds to zero, a subnormal or infinity: generated constants would lose the digits they promise.
    pub(super) fn representable(&mut self, value: &Real, what: &str, given: &Given<Number>) -> Checked<()> {
        let [(least, shown_least), (most, shown_most)] = match self.request.float() {
            Float::F64 => [f64::MIN_POSITIVE, f64::MAX].map(|x| (x, format!("{x:e}"))),
            Float::F32 => [f32::MIN_POSITIVE, f32::MAX].map(|x| (f64::from(x), format!("{x:e}"))),
        };
        let magnitude = value.abs();
        let below = |bound: f64| self.context.float(bound).is_some_and(|bound| magnitude < bound);
        let (small, large) = (below(least), !below(most));
        if !small && !large {
            return Ok(());
        }
        let float = self.request.float().word();
        let limit = if small {
            format!("below the smallest normal `{float}`, {shown_least}")
        } else {
            format!("above the largest `{float}`, {shown_most}")
        };
        let own = Parameter::of(&given.name).is_some_and(|parameter| parameter.word() == what);
        let subject = if own { format!("`{given}` is") } else { format!("`{given}` puts {what}") };
        let remedy = match (what, small) {
            ("theta0", true) => "choose a larger angle",
            ("theta0", false) => "choose an angle within ±π",
            _ => "choose a unit of time that brings it nearer to 1",
        };
        Err(self.refuse(&given.tokens, format!("{subject} {limit}: {}{remedy}", self.wider())))
    }

    /// The other remedy, if there is one.
    fn wider(&self) -> &'static str {
        if self.request.float() == Float::F32 { "use `float = f64`, or " } else { "" }
    }
}
