//! The values of parameters: numbers, counts, words and lists of words.

use super::number::Number;
use super::words::{Output, list, one_word};
use proc_macro2::{Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Error, Ident, LitInt, Result, Token, bracketed};

/// A parameter that was given: its name's span, its value and the value's tokens for messages.
#[derive(Clone)]
pub(crate) struct Given<T> {
    pub(crate) name: Ident,
    pub(crate) value: T,
    pub(crate) tokens: TokenStream,
}

pub(super) fn number(name: &Ident, tokens: TokenStream) -> Result<Given<Number>> {
    Ok(Given { name: name.clone(), value: Number::parse_all(tokens.clone())?, tokens })
}

pub(super) fn count(name: &Ident, tokens: TokenStream) -> Result<Given<usize>> {
    let wrong =
        |_| Error::new_spanned(&tokens, format!("`{name}` takes a whole number of terms, such as `{name} = 4`"));
    let literal: LitInt = syn::parse2(tokens.clone()).map_err(wrong)?;
    let value =
        if literal.suffix().is_empty() { literal.base10_parse() } else { Err(Error::new(Span::call_site(), "")) };
    Ok(Given { name: name.clone(), value: value.map_err(wrong)?, tokens })
}

pub(super) fn word<T>(
    name: &Ident,
    tokens: TokenStream,
    what: &str,
    words: &[&str],
    from_word: fn(&str) -> Option<T>,
) -> Result<Given<T>> {
    let ident = syn::parse2::<Ident>(tokens.clone())
        .map_err(|_| Error::new_spanned(&tokens, format!("`{name}` is one of {}", list(words))))?;
    Ok(Given { name: name.clone(), value: one_word(&ident, what, words, from_word)?, tokens })
}

pub(super) fn outputs(name: &Ident, tokens: TokenStream) -> Result<Given<Vec<Output>>> {
    let parse = |input: ParseStream| {
        let inner;
        bracketed!(inner in input);
        let words = inner.parse_terminated(Ident::parse_any, Token![,])?;
        let mut outputs = Vec::new();
        for ident in words {
            let output = one_word(&ident, "output", Output::WORDS, Output::from_word)?;
            if outputs.contains(&output) {
                return Err(Error::new(ident.span(), format!("output `{ident}` is listed twice: keep one")));
            }
            outputs.push(output);
        }
        Ok(outputs)
    };
    let looks_like_list = matches!(tokens.clone().into_iter().next(), Some(TokenTree::Group(_)));
    if !looks_like_list {
        return Err(Error::new_spanned(&tokens, "`outputs` is a list, such as `[theta, velocity]`"));
    }
    let value = parse.parse2(tokens.clone())?;
    if value.is_empty() {
        let all = list(Output::WORDS);
        return Err(Error::new_spanned(&tokens, format!("`outputs` is empty: list at least one of {all}")));
    }
    Ok(Given { name: name.clone(), value, tokens })
}
