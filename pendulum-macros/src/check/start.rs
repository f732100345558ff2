//! What sets the pendulum going: `theta0`, `velocity0`, `omega` or `g` and `length`, and the motion they make.

use super::{Checked, Checker, Reported, source};
use crate::exact::Real;
use crate::motion::{Motion, NoMotion, Regime};
use crate::parse::number::Number;
use crate::parse::{Float, Form, Given, Output};
use proc_macro2::TokenStream;
use quote::ToTokens;

/// Below these the products of a plan lose digits to underflow.
const SMALLEST_AMPLITUDE: f64 = 1e-300;
const SMALLEST_AMPLITUDE_F32: f64 = 1e-35;

impl Checker<'_> {
    /// The motion, at a working precision that outlasts every cancellation in it.
    ///
    /// The first precision follows from the digits of the input. If the state turns out to be nearer to the separatrix
    /// than numbers of so many digits come without contrivance (products of tiny differences do), once more at a
    /// precision that has its guard bits left, or that resolves twice the distance: what isn't told from the separatrix
    /// then, is on it.
    pub(super) fn motion(&mut self) -> Checked<Motion> {
        let motion = self.motion_at_working_precision()?;
        let lost = motion.cancelled_bits();
        if lost <= self.context.spare_bits() {
            return Ok(motion);
        }
        self.context = self.context.widened(lost.min(self.context.spare_bits() + 256));
        self.motion_at_working_precision()
    }

    fn motion_at_working_precision(&mut self) -> Checked<Motion> {
        let omega = self.omega();
        let theta0 = self.angle();
        let velocity0 = self.velocity();
        self.start_is_given()?;
        let (theta0, velocity0) = (theta0?, velocity0?);
        let [zero, one] = [0, 1].map(|n| self.context.integer(n));
        let theta0 = theta0.unwrap_or_else(|| zero.clone());
        let velocity0 = velocity0.unwrap_or(zero);
        // Whether the state moves doesn't depend on the rate: with a mistake in the rate it is judged all the same.
        let rate = omega.as_ref().unwrap_or(&one);
        let motion = Motion::solve(&theta0, &velocity0, rate).map_err(|why| self.no_motion(why, &theta0))?;
        omega?;
        self.representable_period(&motion)?;
        Ok(motion)
    }

    fn start_is_given(&mut self) -> Checked<()> {
        if self.request.mentions("theta0") || self.request.mentions("velocity0") {
            return Ok(());
        }
        let message =
            "`theta0` is missing: give the release angle, such as `theta0 = 7π/8`, or `velocity0` to start in motion";
        match &self.request.form {
            Form::Item(item) => self.report.on(&item.name, message),
            Form::Expression => self.report.at(proc_macro2::Span::call_site(), message),
        }
        Err(Reported)
    }

    fn angle(&mut self) -> Checked<Option<Real>> {
        let Some(given) = &self.request.theta0 else { return Ok(None) };
        let value = self.evaluated(given)?;
        if !value.is_zero() {
            self.representable(&value, "theta0", given)?;
        }
        Ok(Some(value))
    }

    fn velocity(&mut self) -> Checked<Option<Real>> {
        let Some(given) = &self.request.velocity0 else { return Ok(None) };
        let value = self.evaluated(given)?;
        if !value.is_zero() {
            self.representable(&value, "velocity0", given)?;
        }
        Ok(Some(value))
    }

    /// ω as given, √(g/ℓ), or 1.
    fn omega(&mut self) -> Checked<Real> {
        let request = self.request;
        let rate = "ω is the rate of small oscillations; to mirror the motion change the sign of `theta0`";
        let need = "ω = √(g/length) needs both above 0";
        let omega = self.positive(request.omega.as_ref(), "in radians per unit of t", rate);
        let g = self.positive(request.g.as_ref(), "in m/s²", need);
        let length = self.positive(request.length.as_ref(), "in m", need);
        self.one_source_of_omega()?;
        match (omega?, g?, length?) {
            (Some(omega), ..) => {
                if let Some(given) = &request.omega {
                    self.representable(&omega, "omega", given)?;
                }
                Ok(omega)
            }
            (None, Some(g), Some(length)) => {
                let omega = (g / length).sqrt();
                if let Some(given) = &request.length {
                    self.representable(&omega, "ω = √(g/length)", given)?;
                }
                Ok(omega)
            }
            _ => Ok(self.context.integer(1)),
        }
    }

    fn one_source_of_omega(&mut self) -> Checked<()> {
        let request = self.request;
        let twice = "is given beside `omega`, which it determines: keep `omega`, or `g` and `length`";
        let mut verdict = Ok(());
        for given in [&request.g, &request.length].into_iter().flatten() {
            if request.mentions("omega") {
                verdict = Err(self.refuse(&given.name, format!("`{}` {twice}", given.name)));
            }
        }
        match (&request.g, &request.length) {
            _ if request.mentions("omega") => verdict,
            (Some(g), None) if !request.mentions("length") => Err(self.lonely(g, "`length`, in m")),
            (None, Some(length)) if !request.mentions("g") => {
                Err(self.lonely(length, "`g`, in m/s², such as `g = 9.81`"))
            }
            _ => verdict,
        }
    }

    fn lonely(&mut self, given: &Given<Number>, partner: &str) -> Reported {
        let Given { name, tokens, .. } = given;
        let shown = source::value(tokens);
        let message = format!(
            "`{name} = {shown}` alone doesn't determine ω = √(g/length): add {partner}, or give `omega` instead"
        );
        self.refuse(name, message)
    }

    /// Explains why a state isn't the start of a motion.
    fn no_motion(&mut self, why: NoMotion, theta0: &Real) -> Reported {
        let (angle, velocity) = (self.request.theta0.as_ref(), self.request.velocity0.as_ref());
        let Some(blamed) = angle.or(velocity) else { return Reported };
        let shown = format!("`{} = {}`", blamed.name, source::value(&blamed.tokens));
        let radians = theta0.to_f64();
        let degrees = (theta0 * &self.context.ratio(180, 1) / self.context.pi()).to_f64();
        let value = format!("{shown} is {radians:?} rad = {degrees:?}°");
        let moving = self.request.mentions("velocity0");
        let message = match why {
            NoMotion::Hanging if angle.is_some() => {
                format!("{shown} at rest hangs still: release it at another angle, or push it with `velocity0`")
            }
            NoMotion::Hanging => {
                format!("{shown} at the lowest point hangs still: give `theta0`, or a `velocity0` other than 0")
            }
            NoMotion::Balanced => format!(
                "{value}, balanced on the top, where nothing moves: release it at |θ0| < π, or give it a `velocity0`"
            ),
            NoMotion::BeyondTop if moving => {
                format!("{value}, beyond the top at ±π: {} is the same state", self.less_full_turns(theta0))
            }
            NoMotion::BeyondTop => format!(
                "{value}: released at rest, |θ0| must be less than π (180°); {} is the same position, and motion over \
                 the top starts with a `velocity0`",
                self.less_full_turns(theta0)
            ),
        };
        self.refuse(&blamed.tokens, message)
    }

    /// The parameter with an angle beyond ±π brought within, in the unit it was given in.
    fn less_full_turns(&self, theta0: &Real) -> String {
        let turn = self.context.pi().scale(1);
        let turns = (theta0 / &turn).to_f64().round();
        let Some(turns) = self.context.float(turns) else { return "`theta0` less full turns".to_owned() };
        let reduced = theta0 - &(turns * &turn);
        let in_degrees = self.request.theta0.as_ref().and_then(|given| given.value.angle_unit());
        match in_degrees {
            Some(("deg", _)) => {
                format!("`theta0 = {}deg`", (reduced * self.context.integer(360) / turn).to_f64())
            }
            _ => format!("`theta0 = {}`", reduced.to_f64()),
        }
    }

    fn representable_period(&mut self, motion: &Motion) -> Checked<()> {
        let (period, name) = match &motion.regime {
            Regime::Swing(swing) => (&swing.period, "the period"),
            Regime::Rotation(rotation) => (&rotation.period, "the time of one turn"),
            Regime::Separatrix(_) => return Ok(()),
        };
        self.representable_result(period, name)?;
        self.swings_visibly(motion)?;
        self.turns_unevenly(motion)
    }

    /// Refuses amplitudes whose products with coefficients would be subnormal.
    fn swings_visibly(&mut self, motion: &Motion) -> Checked<()> {
        let Regime::Swing(swing) = &motion.regime else { return Ok(()) };
        let (least, shown) = match self.float() {
            Float::F64 => (SMALLEST_AMPLITUDE, "1e-300"),
            Float::F32 => (SMALLEST_AMPLITUDE_F32, "1e-35"),
        };
        let request = self.request;
        match request.theta0.as_ref().or(request.velocity0.as_ref()) {
            Some(given) if swing.amplitude.to_f64() < least => {
                let message = format!(
                    "`{} = {}` makes an amplitude below {shown}, where `{}` loses digits: choose a larger one, or a unit in \
                     which it is larger, since so small a motion is θ0·cos ωt",
                    given.name,
                    source::value(&given.tokens),
                    self.float().word()
                );
                Err(self.refuse(&given.tokens, message))
            }
            _ => Ok(()),
        }
    }

    /// Refuses a rotation whose κ² underflows: its angle is linear in time beyond any precision.
    fn turns_unevenly(&mut self, motion: &Motion) -> Checked<()> {
        let Regime::Rotation(rotation) = &motion.regime else { return Ok(()) };
        let request = self.request;
        match &request.velocity0 {
            Some(given) if rotation.elliptic.modulus.exponent() < -450 => {
                let message = format!(
                    "`velocity0 = {}` is so fast, beside ω, that the angle is θ0 + velocity0·t to the last digit: compute that",
                    source::value(&given.tokens)
                );
                Err(self.refuse(&given.tokens, message))
            }
            _ => Ok(()),
        }
    }

    /// Largest |θ̇| and |θ̈|, where they are asked for, have to be normal floats.
    pub(super) fn representable_outputs(&mut self, motion: &Motion, outputs: &[Output]) -> Checked<()> {
        if outputs.contains(&Output::Velocity) {
            let fastest = match &motion.regime {
                Regime::Swing(swing) => (&swing.elliptic.modulus * &motion.omega).scale(1),
                Regime::Rotation(rotation) => rotation.fastest.clone(),
                Regime::Separatrix(_) => motion.omega.scale(1),
            };
            self.representable_result(&fastest, "the largest velocity")?;
        }
        if outputs.contains(&Output::Acceleration) {
            // sin θ of a swing is at most 2kk′ or 1, whichever its amplitude allows; 2kk′ ≥ k while k′ ≥ ½.
            let steepest = match &motion.regime {
                Regime::Swing(swing) if swing.elliptic.modulus < self.context.ratio(1, 2) => &swing.elliptic.modulus,
                _ => &self.context.integer(1),
            };
            self.representable_result(&(motion.omega.square() * steepest), "the largest acceleration")?;
            if let (Regime::Rotation(rotation), Float::F64) = (&motion.regime, self.float()) {
                // The acceleration is computed with it.
                self.representable_result(&rotation.fastest.square(), "the square of the largest velocity")?;
            }
        }
        Ok(())
    }

    /// A value that follows from the rate: blame what sets it.
    fn representable_result(&mut self, value: &Real, what: &str) -> Checked<()> {
        let request = self.request;
        let givens = [&request.omega, &request.length, &request.velocity0, &request.theta0];
        match givens.into_iter().flatten().next() {
            Some(given) => self.representable(value, what, given),
            None => Ok(()),
        }
    }

    /// Refuses what rounds to zero, a subnormal or infinity: generated constants would lose the digits they promise.
    fn representable(&mut self, value: &Real, what: &str, given: &Given<Number>) -> Checked<()> {
        let (least, most, limits) = match self.float() {
            Float::F64 => (f64::MIN_POSITIVE, f64::MAX, [f64::MIN_POSITIVE, f64::MAX].map(|x| format!("{x:e}"))),
            Float::F32 => {
                let shown = [f32::MIN_POSITIVE, f32::MAX].map(|x| format!("{x:e}"));
                (f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX), shown)
            }
        };
        let magnitude = value.abs();
        let bound = |bound: f64| self.context.float(bound).is_some_and(|bound| magnitude < bound);
        let (small, large) = (bound(least), !bound(most));
        if !small && !large {
            return Ok(());
        }
        let float = self.float().word();
        let blame: TokenStream = given.tokens.to_token_stream();
        let shown = source::value(&blame);
        let limit = if small {
            format!("smallest normal `{float}`, {}", limits[0])
        } else {
            format!("largest `{float}`, {}", limits[1])
        };
        let side = if small { "below" } else { "above" };
        let subject = if given.name == what {
            format!("`{what} = {shown}` is")
        } else {
            format!("`{} = {shown}` puts {what}", given.name)
        };
        let wider = if self.float() == Float::F32 { "use `float = f64`, or " } else { "" };
        let remedy =
            if what == "theta0" { "choose a larger angle" } else { "choose a unit of time that brings it nearer to 1" };
        Err(self.refuse(blame, format!("{subject} {side} the {limit}: {wider}{remedy}")))
    }
}
