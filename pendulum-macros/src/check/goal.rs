//! How good the result has to be, by which method and for how long: `n`, `tol`, `method`, `t_max`.

use super::{Checked, Checker, Reported};
use crate::exact::Real;
use crate::motion::{ALWAYS_OVERSHOOTS, Motion, Regime};
use crate::parse::{Given, Method, Output, Parameter};
use crate::scene::Goal;

/// Terms that are proposed where they serve: with so many the paper reaches 7π/8 within 0.4 %.
const USUAL_TERMS: usize = 4;

impl Checker<'_> {
    pub(super) fn goal(&mut self, motion: Option<&Motion>) -> Checked<Goal> {
        let tolerance = self.tolerance();
        let terms = self.terms(motion);
        let may_count = motion.is_none_or(|motion| serves(Method::Fourier, &motion.regime));
        if let (Some(n), true) = (&self.request.n, self.request.mentions(Parameter::Tol) && may_count) {
            // A `tol` with a mistake of its own has no value.
            let tol = self.request.tol.as_ref().map_or_else(|| "tol".to_owned(), ToString::to_string);
            let message = format!("`{n}` fixes the number of terms where `{tol}` would choose it: keep one");
            return Err(self.refuse(&n.name, message));
        }
        Ok(match (terms?, tolerance?) {
            (Some(terms), _) => Goal::Terms(terms),
            (None, Some(tolerance)) => Goal::Tolerance(tolerance),
            (None, None) => Goal::Full,
        })
    }

    /// `tol`, rounded down to a number of the float: the promise is the smaller, and kept by its bound rounded up.
    fn tolerance(&mut self) -> Checked<Option<f64>> {
        let given = self.request.tol.as_ref();
        let why = "a result can't be closer than that; leave `tol` out for the full precision of the float";
        let (Some(given), Some(value)) = (given, self.positive(given, why)?) else { return Ok(None) };
        let below = value.to_f64_below();
        let single = self.request.float().round_down(below);
        // What is below all numbers of the float no result comes near to: that is said where the best is known.
        if below > 0.0 {
            return Ok(Some(if single > 0.0 { single } else { below }));
        }
        let message = format!(
            "`{given}` is smaller than every `f64`: no result comes so close; leave `tol` out for full precision"
        );
        Err(self.refuse(&given.tokens, message))
    }

    fn terms(&mut self, motion: Option<&Motion>) -> Checked<Option<usize>> {
        let Some(given) = &self.request.n else { return Ok(None) };
        let n = given.value;
        if n == 0 {
            let message = "`n = 0` is a series without terms: θ̂ needs `n = 1` or more";
            return Err(self.refuse(&given.tokens, message));
        }
        match motion.map(|motion| &motion.regime) {
            None | Some(Regime::Swing(_)) => Ok(Some(n)),
            Some(other) => {
                let remedy = if self.request.mentions(Parameter::Method) {
                    "leave `n` and `method` out, or give `tol` instead of both"
                } else {
                    "leave `n` out, or give `tol` instead"
                };
                let message = format!(
                    "`n = {n}` asks for the paper's θ̂, which is periodic, but this is {}: {remedy}",
                    kind(other)
                );
                Err(self.refuse(&given.name, message))
            }
        }
    }

    pub(super) fn method(&mut self, motion: Option<&Motion>) -> Checked<Option<Method>> {
        let Some(given) = &self.request.method else { return Ok(None) };
        let method = given.value;
        // `n` asks for `fourier`: where that can't serve, it was refused for the same reason.
        let regime = motion.map(|motion| &motion.regime);
        if self.request.n.is_some() && regime.is_some_and(|regime| !serves(Method::Fourier, regime)) {
            return Err(Reported);
        }
        if let Some(n) = &self.request.n
            && method != Method::Fourier
        {
            return Err(self.refuse(&given.tokens, takes_no_terms(given, n.value)));
        }
        match regime {
            Some(regime) if !serves(method, regime) => Err(self.refuse(&given.tokens, cannot_serve(given, regime))),
            _ if method == Method::Fourier
                && !self.request.mentions(Parameter::N)
                && !self.request.mentions(Parameter::Tol) =>
            {
                if self.request.mentions_a_stranger() {
                    return Err(Reported);
                }
                let message = self.needed_by_fourier(regime);
                Err(self.refuse(&given.tokens, message))
            }
            _ => Ok(Some(method)),
        }
    }

    /// What Eq. 22 leaves open, with examples that can be had at the amplitude, if it is known. With how many terms its
    /// velocity has a useful bound only plans tell.
    fn needed_by_fourier(&self, regime: Option<&Regime>) -> String {
        let needed = |terms: String, error: &str| {
            format!("`method = fourier` needs a number of terms, {terms}, or an error, {error}")
        };
        let example = |n: usize| format!("such as `n = {n}`");
        let unit = self.request.float().rounding_unit();
        let Some(Regime::Swing(swing)) = regime else { return needed(example(USUAL_TERMS), "`tol`") };
        match swing.smallest_working_terms(unit) {
            None => ALWAYS_OVERSHOOTS.to_owned(),
            Some(least) if least > USUAL_TERMS && self.request.asks_for(Output::Velocity) => {
                needed(format!("`n`, here at least {least}"), "`tol`; or leave `method` out")
            }
            Some(least) if least > USUAL_TERMS => needed(example(least), "`tol`"),
            Some(_) => needed(example(USUAL_TERMS.min(swing.most_useful_terms(unit))), "such as `tol = 1e-3`"),
        }
    }

    /// The horizon, at most the longest there is.
    pub(super) fn t_max(&mut self, motion: Option<&Motion>) -> Checked<Option<Real>> {
        let given = self.request.t_max.as_ref();
        let why = "the promise holds for all |t| ≤ `t_max`; leave it out for the longest horizon";
        let (Some(given), Some(value)) = (given, self.positive(given, why)?) else {
            return Ok(None);
        };
        let Some(longest) = motion.and_then(Motion::longest_horizon).filter(|longest| value > *longest) else {
            return Ok(Some(value));
        };
        let message = format!(
            "`{given}` is more than 2⁵³ periods ({:e}), the longest horizon: leave `t_max` out for all of it",
            longest.to_f64_below()
        );
        Err(self.refuse(&given.tokens, message))
    }

    /// Refuses outputs that a sum of harmonics, asked for by `method` or `n`, doesn't give.
    pub(super) fn served_by_method(&mut self, motion: Option<&Motion>, outputs: &Given<Vec<Output>>) -> Checked<()> {
        const BY_ITSELF: &str = "θ of a swing, which stays within [−π, π) by itself";
        const DERIVATIVES: &str = "θ and its derivatives only";
        let by_terms = self.request.n.as_ref().map(|_| Method::Fourier);
        let method = self.request.method.as_ref().map(|given| given.value).or(by_terms);
        let Some(method) = method else { return Ok(()) };
        if motion.is_some_and(|motion| !serves(method, &motion.regime)) {
            return Ok(());
        }
        let mut verdict = Ok(());
        for &output in outputs.value.iter().filter(|&&output| !gives(method, output)) {
            let (word, method) = (output.word(), method.word());
            let (given, remedy) = match output {
                Output::Wrapped if outputs.value.contains(&Output::Theta) => (BY_ITSELF, "leave `wrapped` out"),
                Output::Wrapped => (BY_ITSELF, "use `theta`"),
                _ if self.request.mentions(Parameter::Tol) => {
                    (DERIVATIVES, "use `method = fourier` or `polynomial`, or leave `method` out")
                }
                _ => (DERIVATIVES, "use `method = polynomial`, or leave `method` out"),
            };
            let message = format!("output `{word}`: `{method}` gives {given}: {remedy}");
            verdict = Err(self.refuse(outputs.tokens_of(output), message));
        }
        verdict
    }
}

/// Whether a method has an output: from the sine that the paper's formula is made of a position follows, from θ as a sum
/// of harmonics by another sine only.
fn gives(method: Method, output: Output) -> bool {
    match (method, output) {
        (Method::Polynomial, _) | (_, Output::Theta | Output::Velocity | Output::Acceleration) => true,
        (_, Output::Position) => method == Method::Fourier,
        (_, Output::Wrapped) => false,
    }
}

fn takes_no_terms(method: &Given<Method>, terms: usize) -> String {
    let or =
        if matches!(method.value, Method::Series | Method::Polynomial) { ", or state the error as `tol`" } else { "" };
    format!("`{method}` takes no `n` (`n = {terms}`), which counts the terms of `fourier`: drop one of them{or}")
}

fn cannot_serve(method: &Given<Method>, regime: &Regime) -> String {
    let polynomials = if serves(Method::Polynomial, regime) { "use `polynomial`, or " } else { "" };
    format!("`{method}` can't serve {}: {polynomials}leave `method` out", kind(regime))
}

/// Which motions a method describes. Eqs. 17 and 22 are written for release from rest; a swing launched in mid-motion
/// is the same swing, shifted in phase. Eq. 3 then is the linearised motion from the same state. The separatrix has no
/// period: one way of computing it is left.
fn serves(method: Method, regime: &Regime) -> bool {
    match regime {
        Regime::Swing(_) => true,
        Regime::Rotation(_) => method == Method::Polynomial,
        Regime::Separatrix(_) => false,
    }
}

fn kind(regime: &Regime) -> &'static str {
    match regime {
        Regime::Swing(_) => "a swing",
        Regime::Rotation(_) => "a rotation over the top",
        Regime::Separatrix(_) => "the separatrix, the motion that takes for ever to reach the top",
    }
}
