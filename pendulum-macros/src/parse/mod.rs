//! Tokens → [`Request`]: what was asked for, as written. Nothing is evaluated or judged here beyond its syntax.

mod depth;
mod header;
mod names;
pub(crate) mod number;
mod parameter;
mod request;
pub(crate) mod source;
mod value;
mod words;

pub(crate) use header::{Item, Shape};
pub(crate) use request::Request;
pub(crate) use value::Given;
pub(crate) use words::{Float, Keyword, Method, Output, Parameter};

use crate::report::Report;
use parameter::{before_another, named_value};
use proc_macro2::TokenStream;
use request::Written;
use syn::parse::{ParseStream, Parser};
use syn::{Error, Ident};

/// Parses one invocation, recording every mistake; `None` where not even the shape could be told.
pub(crate) fn parse(tokens: TokenStream, report: &mut Report) -> Option<Request> {
    if let Some(error) = depth::too_deep(&tokens) {
        report.add(error);
        return None;
    }
    let parsed = (|input: ParseStream| {
        let shape = header::shape(input, report)?;
        Ok((shape, input.parse::<TokenStream>()?))
    })
    .parse2(tokens);
    let (shape, parameters) = report.take(parsed)?;
    let mut request = Request::new(shape);
    if parameters.is_empty() && !report.is_clean() {
        request.skipped();
    }
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
    fn take_parameter(&mut self, tokens: TokenStream, report: &mut Report) {
        match named_value(&tokens) {
            Ok((name, value)) => self.set(&name, value, report),
            Err(error) => {
                report.add(self.as_an_output(&tokens).unwrap_or(error));
                // `theta0` without a value is a mistake of its own, not a missing `theta0`.
                if let Some(word) = first_word(&tokens) {
                    let parameter = Parameter::like(&word);
                    self.written.push(Written { parameter, exact: false, understood: false, value: tokens });
                }
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
        let known = Parameter::named(&word);
        let before = known.and_then(|known| Some((known, self.written_as(known).find(|written| written.exact)?)));
        let is_first = before.is_none();
        if let Some((known, before)) = before {
            let [before, now] = [&before.value, &value].map(source::value);
            let known = known.word();
            let alias = if word == known { String::new() } else { format!(", that is `{known}`,") };
            report.at(name.span(), format!("`{word}`{alias} is given twice, `{before}` and `{now}`: keep one"));
        }
        let filled = report.take(self.fill(name, value.clone())).is_some();
        let (parameter, exact) = (Parameter::like(&word), known.is_some());
        self.written.push(Written { parameter, exact, understood: filled && is_first, value });
    }
}

fn first_word(tokens: &TokenStream) -> Option<String> {
    tokens.clone().into_iter().next().map(|tree| tree.to_string())
}

#[cfg(test)]
mod tests;
