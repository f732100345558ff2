//! The values of parameters: numbers, counts, words and lists of words.

use super::number::Number;
use super::words::{Keyword, Output, one_of, one_word};
use super::{parameter, source};
use crate::report::Report;
use crate::report::list;
use proc_macro2::{TokenStream, TokenTree};
use std::fmt::{self, Display, Formatter};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Error, Ident, LitInt, LitStr, Result, bracketed};

/// A parameter that was given: its name, its value and the value's tokens for messages.
#[derive(Clone)]
pub(crate) struct Given<T> {
    pub(crate) name: Ident,
    pub(crate) value: T,
    pub(crate) tokens: TokenStream,
}

/// As it was written, evenly spaced: `theta0 = 7π/8`.
impl<T> Display for Given<T> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{} = {}", self.name, source::value(&self.tokens))
    }
}

impl Given<Vec<Output>> {
    /// The token of one of them, for its span.
    pub(crate) fn tokens_of(&self, output: Output) -> TokenStream {
        let inside = self.tokens.clone().into_iter().find_map(|tree| match tree {
            TokenTree::Group(group) => group.stream().into_iter().find(|tree| tree.to_string() == output.word()),
            _ => None,
        });
        inside.map_or_else(|| self.tokens.clone(), TokenStream::from)
    }
}

pub(super) fn number(name: &Ident, tokens: TokenStream) -> Result<Given<Number>> {
    Ok(Given { name: name.clone(), value: Number::parse_all(name, tokens.clone())?, tokens })
}

pub(super) fn count(name: &Ident, tokens: TokenStream) -> Result<Given<usize>> {
    let wrong = |why: String| Error::new_spanned(&tokens, why);
    let literal: LitInt = syn::parse2(tokens.clone()).map_err(|_| {
        wrong(format!(
            "`{name} = {}` counts no terms: write a whole number in digits, such as `{name} = 4`",
            source::value(&tokens)
        ))
    })?;
    let (digits, suffix) = (literal.base10_digits(), literal.suffix());
    if !suffix.is_empty() {
        return Err(wrong(format!("`{name} = {literal}` has a suffix: write `{name} = {digits}`")));
    }
    let value = literal.base10_parse().map_err(|_| {
        wrong(if digits.starts_with('-') {
            format!("`{name} = {digits}` is negative: θ̂ needs `{name} = 1` or more")
        } else {
            format!("`{name} = {digits}` is more terms than any float can use: choose fewer, such as `{name} = 4`")
        })
    })?;
    Ok(Given { name: name.clone(), value, tokens })
}

pub(super) fn word<T: Keyword>(name: &Ident, tokens: TokenStream) -> Result<Given<T>> {
    let ident = syn::parse2::<Ident>(tokens.clone()).map_err(|_| not_a_word::<T>(name, &tokens))?;
    Ok(Given { name: name.clone(), value: one_word(&ident)?, tokens })
}

fn not_a_word<T: Keyword>(name: &Ident, tokens: &TokenStream) -> Error {
    let message = match quoted(tokens).filter(|word| T::from_word(word).is_some()) {
        Some(word) => format!("`{name}` is written without quotes: `{name} = {word}`"),
        None => format!("`{name} = {}` is no word: {}", source::value(tokens), one_of::<T>()),
    };
    Error::new_spanned(tokens, message)
}

/// The text of a string literal.
fn quoted(tokens: &TokenStream) -> Option<String> {
    syn::parse2::<LitStr>(tokens.clone()).ok().map(|text| text.value())
}

pub(super) fn outputs(name: &Ident, tokens: TokenStream) -> Result<Given<Vec<Output>>> {
    let list_of = |input: ParseStream| {
        let inner;
        bracketed!(inner in input);
        inner.parse::<TokenStream>()
    };
    let entries = list_of.parse2(tokens.clone()).map_err(|_| no_list(&tokens))?;
    let mut value = Vec::new();
    let mut report = Report::default();
    parameter::for_each(entries, ["an output", "outputs"], &mut report, |entry, report| {
        value.extend(report.take(output(&entry, &value)));
    });
    report.finish()?;
    if value.is_empty() {
        let all = list(Output::WORDS);
        return Err(Error::new_spanned(&tokens, format!("`outputs` is empty: list at least one of {all}")));
    }
    Ok(Given { name: name.clone(), value, tokens })
}

fn no_list(tokens: &TokenStream) -> Error {
    let words = quoted(tokens).unwrap_or_else(|| source::value(tokens));
    let known = words.split(", ").all(|word| Output::from_word(word).is_some());
    let example = if known { &words } else { "theta, velocity" };
    Error::new_spanned(tokens, format!("`outputs` is a list, in brackets: write `outputs = [{example}]`"))
}

/// One entry of the list.
fn output(entry: &TokenStream, before: &[Output]) -> Result<Output> {
    let read = |input: ParseStream| {
        let ident = input.call(Ident::parse_any).map_err(|_| no_word(entry))?;
        if ident == "state" {
            let message = "output `state` is the function that comes with two outputs: list `theta` and `velocity`";
            return Err(Error::new(ident.span(), message));
        }
        let output = one_word(&ident)?;
        let next = input.parse::<TokenStream>()?.into_iter().next();
        match next {
            Some(next) => Err(Error::new(next.span(), format!("expected `,` or `]` before `{next}`"))),
            None if before.contains(&output) => {
                Err(Error::new(ident.span(), format!("output `{ident}` is listed twice: keep one")))
            }
            None => Ok(output),
        }
    };
    read.parse2(entry.clone())
}

fn no_word(entry: &TokenStream) -> Error {
    let remedy = match quoted(entry) {
        Some(text) => format!("outputs are written without quotes: `{text}`"),
        None => format!("expected an output: one of {}, with commas between them", list(Output::WORDS)),
    };
    Error::new_spanned(entry, remedy)
}
