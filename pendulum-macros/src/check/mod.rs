//! Semantic checks: [`Request`] → [`Scene`]. Whatever can be told to be wrong with a well-formed request without planning
//! is told here, at the smallest token to blame, with the parameter, its value and a remedy. What only the planner can tell
//! is a [`Refusal`](crate::plan::Refusal).

mod goal;
mod range;
mod start;
#[cfg(test)]
mod tests;
mod turns;

use crate::exact::{Context, Real};
use crate::motion::Motion;
use crate::parse::number::Number;
use crate::parse::{Given, Keyword, Output, Parameter, Request, Shape};
use crate::report::Report;
use crate::scene::{Blame, Goal, Scene};
use quote::ToTokens;
use std::fmt::Display;

/// A mistake that has been reported already: nothing that follows from it needs to be.
struct Reported;

/// The value, or the fact that its mistake has been reported.
type Checked<T> = Result<T, Reported>;

/// The scene that `request` asks for. All mistakes, those of its syntax too, are in `report`; where there are any, a
/// scene is for the planner to say what it refuses besides: `None` if that might follow from a mistake.
pub(crate) fn check(request: Request, report: &mut Report) -> Option<Scene> {
    let mut checker = Checker { context: Context::for_digits(request.digits()), request: &request, report };
    let motion = checker.motion();
    let solved = motion.as_ref().ok();
    let goal = checker.goal(solved);
    let method = checker.method(solved);
    let t_max = checker.t_max(solved);
    let outputs = checker.outputs(solved);
    let (motion, goal) = (motion.ok()?, goal.ok()?);
    let (method, t_max, outputs) = match (method, t_max, outputs) {
        (Ok(method), Ok(t_max), Ok(outputs)) if report.is_clean() || request.is_understood() => {
            (method, t_max, outputs)
        }
        // Whether the argument of the arcsine in Eq. 22 exceeds 1 depends on none of these.
        _ if matches!(goal, Goal::Terms(_)) && !request.misstates(Parameter::Float) => {
            (None, None, vec![Output::Theta])
        }
        _ => return None,
    };
    let (source, blame, float) = (request.source(), blame(&request), request.float());
    Some(Scene { source, motion, float, goal, method, t_max, outputs, blame, shape: request.shape })
}

fn blame(request: &Request) -> Blame {
    let tokens = |given: &Option<Given<Number>>| given.as_ref().map(|given| given.tokens.clone());
    let start = tokens(&request.theta0).or_else(|| tokens(&request.velocity0)).unwrap_or_default();
    let terms = request.n.as_ref().map(|given| given.tokens.clone());
    let forced = request.method.as_ref().map(|given| given.tokens.clone());
    let goal = terms.or_else(|| tokens(&request.tol)).or_else(|| forced.clone()).unwrap_or_else(|| start.clone());
    let method = forced.unwrap_or_else(|| goal.clone());
    let rate = request.rate().map_or_else(|| start.clone(), |given| given.tokens.clone());
    Blame { goal, start, rate, method }
}

struct Checker<'a> {
    request: &'a Request,
    report: &'a mut Report,
    context: Context,
}

impl Checker<'_> {
    fn refuse(&mut self, blame: impl ToTokens, message: impl Display) -> Reported {
        self.report.on(blame, message);
        Reported
    }

    fn evaluated(&mut self, given: &Given<Number>) -> Checked<Real> {
        // What the motion doesn't depend on (`tol`, `t_max`) may be longer than what it does.
        let context = self.context.at_least(Context::for_digits(given.value.digits()));
        given.value.evaluate(context).map_err(|mistakes| {
            for error in mistakes {
                self.report.at(error.span(), format!("`{given}`: {error}"));
            }
            Reported
        })
    }

    /// A value that has to be positive, `None` if it wasn't given; `why` ends the message.
    fn positive(&mut self, given: Option<&Given<Number>>, why: &str) -> Checked<Option<Real>> {
        let value = given.map(|given| self.evaluated(given)).transpose()?;
        if let (Some(given), Some(value)) = (given, &value)
            && (value.is_zero() || value.is_negative())
        {
            return Err(self.refuse(&given.tokens, format!("`{given}` is not positive: {why}")));
        }
        Ok(value)
    }

    /// The outputs in their order of declaration.
    fn outputs(&mut self, motion: Option<&Motion>) -> Checked<Vec<Output>> {
        let Some(given) = &self.request.outputs else { return Ok(vec![Output::Theta]) };
        let outputs: Vec<Output> = Output::ALL.iter().copied().filter(|output| given.value.contains(output)).collect();
        self.served_by_method(motion, given)?;
        if let (Shape::Expression, [first, second, ..]) = (&self.request.shape, given.value.as_slice()) {
            let message = format!(
                "the expression form is one function, of one output: use the item form, `struct Name; …`, for `{}` beside \
                 `{}`",
                second.word(),
                first.word()
            );
            return Err(self.refuse(given.tokens_of(*second), message));
        }
        if let Some(motion) = motion {
            self.representable_outputs(motion, &outputs)?;
        }
        Ok(outputs)
    }
}
