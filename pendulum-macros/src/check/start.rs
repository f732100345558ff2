//! What sets the pendulum going: `theta0`, `velocity0`, `omega` or `g` and `length`, and the motion they make.

use super::turns::Rest;
use super::{Checked, Checker, Reported};
use crate::exact::Real;
use crate::motion::{Motion, NoMotion};
use crate::parse::number::Number;
use crate::parse::{Given, Parameter, Shape};

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
        let theta0 = self.initial("theta0", self.request.theta0.as_ref());
        let velocity0 = self.initial("velocity0", self.request.velocity0.as_ref());
        self.start_is_given()?;
        let (theta0, velocity0) = (theta0?, velocity0?);
        let request = self.request;
        if request.misstates(Parameter::Theta0) {
            return Err(Reported);
        }
        let [zero, one] = [0, 1].map(|n| self.context.integer(n));
        let theta0 = theta0.unwrap_or_else(|| zero.clone());
        let velocity0 = velocity0.unwrap_or(zero);
        // Whether the state moves doesn't depend on the rate: with a mistake in the rate it is judged all the same.
        let rate = omega.as_ref().unwrap_or(&one);
        let motion =
            Motion::solve(&theta0, &velocity0, rate).map_err(|why| self.no_motion(why, &theta0, &velocity0))?;
        omega?;
        if request.misstates(Parameter::Velocity0) {
            return Err(Reported);
        }
        self.representable_motion(&motion)?;
        Ok(motion)
    }

    fn start_is_given(&mut self) -> Checked<()> {
        if self.request.mentions(Parameter::Theta0) || self.request.mentions(Parameter::Velocity0) {
            return Ok(());
        }
        if self.request.mentions_a_stranger() {
            return Err(Reported);
        }
        let message =
            "`theta0` is missing: give the release angle, such as `theta0 = 7π/8`, or `velocity0` to start in motion";
        match &self.request.shape {
            Shape::Item(item) => self.report.on(&item.name, message),
            Shape::Expression => self.report.at(proc_macro2::Span::call_site(), message),
        }
        Err(Reported)
    }

    /// θ or θ̇ at t = 0, `None` if it wasn't given.
    fn initial(&mut self, name: &str, given: Option<&Given<Number>>) -> Checked<Option<Real>> {
        let Some(given) = given else { return Ok(None) };
        let value = self.evaluated(given)?;
        if !value.is_zero() {
            self.representable(&value, name, given)?;
        }
        Ok(Some(value))
    }

    /// ω as given, √(g/ℓ), or 1.
    fn omega(&mut self) -> Checked<Real> {
        let request = self.request;
        let rate = "ω is the rate of small oscillations; to mirror the motion change the sign of `theta0`";
        let need = "ω = √(g/length) needs both above 0";
        let omega = self.positive(request.omega.as_ref(), rate);
        let g = self.positive(request.g.as_ref(), need);
        let length = self.positive(request.length.as_ref(), need);
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
            _ if [Parameter::G, Parameter::Length].into_iter().any(|name| request.misstates(name)) => Err(Reported),
            _ => Ok(self.context.integer(1)),
        }
    }

    /// ω is given once: beside `g` and `length` it is `omega` that is one too many, beside one of them that one.
    fn one_source_of_omega(&mut self) -> Checked<()> {
        let request = self.request;
        if request.misstates(Parameter::Omega) {
            return Err(Reported);
        }
        match (&request.omega, &request.g, &request.length) {
            (Some(omega), Some(_), Some(_)) => {
                let name = &omega.name;
                let message = format!(
                    "`{omega}` is given beside `g` and `length`, which determine it by ω = √(g/length): keep `{name}`, or \
                     `g` and `length`"
                );
                Err(self.refuse(name, message))
            }
            (Some(_), Some(given), _) | (Some(_), _, Some(given)) => {
                let message =
                    format!("`{given}` is given beside `omega`: keep `omega`, or `g` and `length`, which determine it");
                Err(self.refuse(&given.name, message))
            }
            (None, Some(_), None) | (None, None, Some(_)) if request.mentions_a_stranger() => Err(Reported),
            (None, Some(g), None) if !request.mentions(Parameter::Length) => Err(self.lonely(g, "`length`, in m")),
            (None, None, Some(length)) if !request.mentions(Parameter::G) => {
                Err(self.lonely(length, "`g`, in m/s², such as `g = 9.81`"))
            }
            _ => Ok(()),
        }
    }

    fn lonely(&mut self, given: &Given<Number>, partner: &str) -> Reported {
        let message =
            format!("`{given}` alone doesn't determine ω = √(g/length): add {partner}, or give `omega` instead");
        self.refuse(&given.name, message)
    }

    /// Explains why a state isn't the start of a motion.
    fn no_motion(&mut self, why: NoMotion, theta0: &Real, velocity0: &Real) -> Reported {
        let (angle, velocity) = (self.request.theta0.as_ref(), self.request.velocity0.as_ref());
        let Some(blamed) = angle.or(velocity) else { return Reported };
        let radians = theta0.to_f64();
        let degrees = (theta0 * &self.context.ratio(180, 1) / self.context.pi()).to_f64();
        let value = format!("`{blamed}` is {radians:?} rad = {degrees:?}°");
        // A velocity with a mistake was meant as one, and so may be what is no parameter.
        let moving = !velocity0.is_zero() || self.request.may_mean(Parameter::Velocity0);
        let rest = Rest::of(theta0);
        let reduced = rest.shown(angle.is_some_and(|given| given.value.is_in_degrees()));
        let is_plain = angle.is_some_and(|given| given.value.is_plain()) && radians.abs() <= 180.0;
        let name = &blamed.name;
        let in_degrees =
            if is_plain { format!("; if degrees are meant, write `{name} = {radians}deg`") } else { String::new() };
        // Full turns away from where nothing moves, nothing moves either.
        let why = match (why, rest) {
            (NoMotion::BeyondTop, Rest::Lowest) if !moving => NoMotion::Hanging,
            (NoMotion::BeyondTop, Rest::Top) if !moving => NoMotion::Balanced,
            (why, _) => why,
        };
        let message = match why {
            NoMotion::Hanging | NoMotion::Balanced if moving => return Reported,
            NoMotion::Hanging if angle.is_some() => {
                format!("`{blamed}` at rest hangs still: release it at another angle, or push it with `velocity0`")
            }
            NoMotion::Hanging => {
                format!("`{blamed}` at the lowest point hangs still: give `theta0`, or a `velocity0` other than 0")
            }
            NoMotion::Balanced => format!(
                "{value}, balanced on the top, where nothing moves: release it at |θ0| < π, or give it a `velocity0`"
            ),
            NoMotion::BeyondTop if moving => {
                format!("{value}, beyond the top at ±π: {reduced} is the same state{in_degrees}")
            }
            NoMotion::BeyondTop => format!(
                "{value}: released at rest, |θ0| must be less than π (180°); {reduced} is the same position, and motion \
                 over the top starts with a `velocity0`{in_degrees}"
            ),
        };
        self.refuse(&blamed.tokens, message)
    }
}
