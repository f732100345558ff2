//! Collects every mistake of one invocation, so that all of them are reported at once.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::ToTokens;
use std::fmt::Display;

/// The mistakes found so far.
#[derive(Default)]
pub(crate) struct Report {
    error: Option<syn::Error>,
}

impl Report {
    /// Records a mistake at `span`.
    pub(crate) fn at(&mut self, span: Span, message: impl Display) {
        self.add(syn::Error::new(span, message));
    }

    /// Records a mistake that spans `tokens`.
    pub(crate) fn on(&mut self, tokens: impl ToTokens, message: impl Display) {
        self.add(syn::Error::new_spanned(tokens, message));
    }

    pub(crate) fn add(&mut self, error: syn::Error) {
        match &mut self.error {
            Some(all) => all.combine(error),
            none => *none = Some(error),
        }
    }

    /// The value of `result`, its error recorded.
    pub(crate) fn take<T>(&mut self, result: syn::Result<T>) -> Option<T> {
        result.map_err(|error| self.add(error)).ok()
    }

    /// Whether nothing was recorded.
    pub(crate) fn is_clean(&self) -> bool {
        self.error.is_none()
    }

    /// `Ok` if nothing was recorded.
    pub(crate) fn finish(self) -> syn::Result<()> {
        self.error.map_or(Ok(()), Err)
    }
}

/// The mistake as a `compile_error!`, shown at its tokens, without the `::core::` that `syn` puts before it: spans of the
/// user's tokens have the user's edition, and in that of 2015 `::core` is a module of the user's crate. Were it located
/// there but resolved here, the compiler would add to every message that it originates in a macro.
pub(crate) fn compile_error(mistake: &syn::Error) -> TokenStream {
    let path = |tree: &TokenTree| !matches!(tree, TokenTree::Ident(name) if name == "compile_error");
    mistake.to_compile_error().into_iter().skip_while(path).collect()
}

/// `` `a`, `b` or `c` ``
pub(crate) fn list(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        Some((last, _)) => last.clone(),
        None => String::new(),
    }
}

/// The candidate that is closest to `word` by edit distance, if it is close enough to be what was meant.
pub(crate) fn nearest<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    candidates
        .iter()
        .map(|&candidate| (edit_distance(&word.to_lowercase(), candidate), candidate))
        .filter(|&(distance, candidate)| distance <= (1 + candidate.chars().count()) / 3)
        .min()
        .map(|(_, candidate)| candidate)
}

/// Levenshtein's distance, one row at a time.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, from) in a.chars().enumerate() {
        let mut diagonal = i;
        row[0] = i + 1;
        for (j, &to) in b.iter().enumerate() {
            let substituted = diagonal + usize::from(from != to);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn suggests_what_was_probably_meant() {
        let names = ["theta0", "omega", "t_max", "outputs"];
        assert_eq!(nearest("theta", &names), Some("theta0"));
        assert_eq!(nearest("Omega", &names), Some("omega"));
        assert_eq!(nearest("output", &names), Some("outputs"));
        assert_eq!(nearest("colour", &names), None);
    }

    /// In edition 2015 `::core` is not what it is later.
    #[test]
    fn errors_have_no_path() {
        let mistake = syn::Error::new(Span::call_site(), "one");
        assert_eq!(compile_error(&mistake).to_string(), "compile_error ! { \"one\" }");
    }

    #[test]
    fn keeps_every_mistake() {
        let mut report = Report::default();
        report.at(Span::call_site(), "one");
        report.at(Span::call_site(), "two");
        assert_eq!(report.finish().unwrap_err().into_iter().count(), 2);
    }
}
