//! Tokens → [`Request`]: what was asked for, as written. Nothing is evaluated or judged here beyond its syntax.

mod depth;
mod header;
pub(crate) mod names;
pub(crate) mod number;
mod parameter;
pub(crate) mod source;
mod value;
mod words;

pub(crate) use header::{Item, Shape};
pub(crate) use value::Given;
pub(crate) use words::{Float, Keyword, Method, Output};

use crate::report::Report;
use names::{ascii, canonical, is_a_parameter, unknown_parameter};
use number::Number;
use parameter::{before_another, named_value};
use proc_macro2::TokenStream;
use syn::parse::{ParseStream, Parser};
use syn::{Error, Ident, Result};
use value::{count, number, outputs, word};

/// One invocation of `pendulum!`.
pub(crate) struct Request {
    pub(crate) shape: Shape,
    pub(crate) theta0: Option<Given<Number>>,
    pub(crate) velocity0: Option<Given<Number>>,
    pub(crate) omega: Option<Given<Number>>,
    pub(crate) g: Option<Given<Number>>,
    pub(crate) length: Option<Given<Number>>,
    pub(crate) n: Option<Given<usize>>,
    pub(crate) tol: Option<Given<Number>>,
    pub(crate) t_max: Option<Given<Number>>,
    pub(crate) method: Option<Given<Method>>,
    pub(crate) float: Option<Given<Float>>,
    pub(crate) outputs: Option<Given<Vec<Output>>>,
    /// Every parameter, in order: those with a mistake in them too, so that they don't count as missing.
    written: Vec<Written>,
}

/// A parameter as it was written.
pub(crate) struct Written {
    /// Its name, or the nearest one of a parameter.
    name: String,
    /// Whether it is that name.
    exact: bool,
    /// Whether there was no mistake in it.
    understood: bool,
    value: TokenStream,
}

impl Written {
    fn is_parameter(&self) -> bool {
        is_a_parameter(&self.name)
    }
}

/// Parses one invocation, recording every mistake; `None` where not even the shape could be told.
pub(crate) fn parse(tokens: TokenStream, report: &mut Report) -> Option<Request> {
    if let Some(error) = depth::too_deep(&tokens) {
        report.add(error);
        return None;
    }
    let parsed = (|input: ParseStream| {
        let shape = header::shape(input)?;
        Ok((shape, input.parse::<TokenStream>()?))
    })
    .parse2(tokens);
    let (shape, parameters) = report.take(parsed)?;
    let mut request = Request {
        shape,
        theta0: None,
        velocity0: None,
        omega: None,
        g: None,
        length: None,
        n: None,
        tol: None,
        t_max: None,
        method: None,
        float: None,
        outputs: None,
        written: Vec::new(),
    };
    let parameters = match request.shape {
        Shape::Item(_) => before_another(parameters, report),
        Shape::Expression => parameters,
    };
    parameter::for_each(parameters, ["a parameter", "parameters"], report, |tokens, report| {
        request.take_parameter(tokens, report);
    });
    Some(request)
}

impl Request {
    /// What sets the rate.
    pub(crate) fn rate(&self) -> Option<&Given<Number>> {
        self.omega.as_ref().or(self.length.as_ref())
    }

    /// Whether the parameter was written at all, with or without a mistake.
    pub(crate) fn mentions(&self, name: &str) -> bool {
        self.written.iter().any(|written| written.name == name)
    }

    /// Whether the parameter was written, but with a mistake, which has been reported: what was meant isn't known.
    pub(crate) fn misstates(&self, name: &str) -> bool {
        self.mentions(name) && !self.written.iter().any(|written| written.name == name && written.understood)
    }

    /// Whether that parameter may have been meant by something that was written with a mistake.
    pub(crate) fn may_mean(&self, name: &str) -> bool {
        self.misstates(name) || !self.mentions(name) && self.mentions_a_stranger()
    }

    /// Whether something was written that is no parameter, and like none: it may be meant as the one that is missing.
    pub(crate) fn mentions_a_stranger(&self) -> bool {
        self.written.iter().any(|written| !written.is_parameter())
    }

    /// Whether there was no mistake in the parameters that were written, but for words that are none.
    pub(crate) fn is_understood(&self) -> bool {
        self.written.iter().filter(|written| written.is_parameter()).all(|written| written.understood)
    }

    /// The type of t and of the results.
    pub(crate) fn float(&self) -> Float {
        self.float.as_ref().map_or(Float::F64, |given| given.value)
    }

    /// The type that was probably meant, where what was said of it is a mistake.
    pub(crate) fn float_meant(&self) -> Float {
        let is_single = |Written { name, value, .. }: &Written| {
            let value = value.to_string();
            value.contains("f32") || name == "float" && (value.contains("32") || value.contains("single"))
        };
        if self.float.is_none() && self.written.iter().any(is_single) { Float::F32 } else { self.float() }
    }

    /// The decimal digits of the longest number that the motion depends on.
    pub(crate) fn digits(&self) -> usize {
        let numbers = [&self.theta0, &self.velocity0, &self.omega, &self.g, &self.length];
        numbers.into_iter().flatten().map(|given| given.value.digits()).max().unwrap_or(0)
    }

    fn take_parameter(&mut self, tokens: TokenStream, report: &mut Report) {
        match named_value(&tokens) {
            Ok((name, value)) => self.set(&name, value, report),
            Err(error) => {
                report.add(self.as_an_output(&tokens).unwrap_or(error));
                // `theta0` without a value is a mistake of its own, not a missing `theta0`.
                let name = first_word(&tokens).map(|word| canonical(&word).to_owned());
                self.written.extend(name.map(|name| Written { name, exact: false, understood: false, value: tokens }));
            }
        }
    }

    /// The mistake of an output that stands outside the list, with those that came before it.
    fn as_an_output(&self, tokens: &TokenStream) -> Option<Error> {
        let output = |tokens: &TokenStream| Output::from_word(&tokens.to_string());
        let word = output(tokens)?.word();
        let listed = self.outputs.iter().flat_map(|given| given.value.iter().copied());
        let outside = self.written.iter().filter(|written| !written.exact).filter_map(|written| output(&written.value));
        let before = listed.chain(outside).map(Output::word).filter(|&other| other != word);
        let list: Vec<&str> = before.chain([word]).collect();
        let message = format!("`{word}` is one of the `outputs`: write `outputs = [{}]`", list.join(", "));
        Some(Error::new_spanned(tokens, message))
    }

    fn set(&mut self, name: &Ident, value: TokenStream, report: &mut Report) {
        let word = name.to_string();
        let known = ascii(&word);
        let before = self.written.iter().find(|written| written.exact && written.name == known);
        let is_first = before.is_none();
        if let Some(before) = before {
            let [before, now] = [&before.value, &value].map(source::value);
            let alias = if word == known { String::new() } else { format!(", that is `{known}`,") };
            report.at(name.span(), format!("`{word}`{alias} is given twice, `{before}` and `{now}`: keep one"));
        }
        let filled = report.take(self.fill(name, value.clone())).is_some();
        let (name, exact) = (canonical(&word).to_owned(), is_a_parameter(known));
        self.written.push(Written { name, exact, understood: filled && is_first, value });
    }

    /// Reads the value into its field, whatever was there: the checks to come speak of the last one.
    fn fill(&mut self, name: &Ident, value: TokenStream) -> Result<()> {
        match ascii(&name.to_string()) {
            "theta0" => number(name, value).map(|given| self.theta0 = Some(given)),
            "velocity0" => number(name, value).map(|given| self.velocity0 = Some(given)),
            "omega" => number(name, value).map(|given| self.omega = Some(given)),
            "g" => number(name, value).map(|given| self.g = Some(given)),
            "length" => number(name, value).map(|given| self.length = Some(given)),
            "tol" => number(name, value).map(|given| self.tol = Some(given)),
            "t_max" => number(name, value).map(|given| self.t_max = Some(given)),
            "n" => count(name, value).map(|given| self.n = Some(given)),
            "method" => word(name, value).map(|given| self.method = Some(given)),
            "float" => word(name, value).map(|given| self.float = Some(given)),
            "outputs" => outputs(name, value).map(|given| self.outputs = Some(given)),
            unknown => Err(Error::new(name.span(), unknown_parameter(unknown))),
        }
    }
}

fn first_word(tokens: &TokenStream) -> Option<String> {
    tokens.clone().into_iter().next().map(|tree| tree.to_string())
}

#[cfg(test)]
mod tests;
