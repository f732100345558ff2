//! Names in expressions: π and the root, and what else was probably meant.

use super::tree::{Tree, is_pi};
use super::{literal, whole};
use crate::parse::{Parameter, source};
use proc_macro2::{TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Error, Ident, Result, Token, token};

/// Words for what a parameter is if it is left out, in lower case.
const OF_ABSENCE: [&str; 9] = ["inf", "infinity", "max", "none", "auto", "full", "default", "forever", "exact"];

/// Refuses paths, and names that stand for what the parameter `parameter` is if it is left out.
pub(super) fn check(parameter: &Ident, value: &TokenStream) -> Result<()> {
    isnt_absence(parameter, value)?;
    let Some(path) = path(value) else { return Ok(()) };
    let shown = source::value(&path);
    let last = shown.rsplit(':').next().unwrap_or_default();
    let message = format!("`{parameter} = {}`: {}", source::value(value), unknown(&shown, last));
    Err(Error::new_spanned(path, message))
}

/// The first path, at any depth.
fn path(value: &TokenStream) -> Option<TokenStream> {
    let trees: Vec<TokenTree> = value.clone().into_iter().collect();
    let is_colon = |tree: &TokenTree| matches!(tree, TokenTree::Punct(punct) if punct.as_char() == ':');
    let ends = |tree: &TokenTree| !is_colon(tree) && !matches!(tree, TokenTree::Ident(_));
    let outside = trees.split(ends).find(|run| run.iter().any(is_colon));
    let inside = |tree: &TokenTree| if let TokenTree::Group(group) = tree { path(&group.stream()) } else { None };
    outside.map(|run| run.iter().cloned().collect()).or_else(|| trees.iter().find_map(inside))
}

/// What is the same as saying nothing is said by nothing.
fn isnt_absence(parameter: &Ident, value: &TokenStream) -> Result<()> {
    let default = match Parameter::of(parameter) {
        Some(Parameter::TMax) => "the longest horizon",
        Some(Parameter::Tol) => "the full precision of the float",
        _ => return Ok(()),
    };
    match value.clone().into_iter().last() {
        Some(TokenTree::Ident(word)) if OF_ABSENCE.contains(&word.to_string().to_lowercase().as_str()) => {
            let message =
                format!("`{parameter} = {}` is no number: leave `{parameter}` out for {default}", source::value(value));
            Err(Error::new_spanned(value, message))
        }
        _ => Ok(()),
    }
}

/// Whether a name stands there, or one of the keywords that name modules and types.
pub(super) fn begins(input: ParseStream) -> bool {
    let of_path = input.peek(Token![crate]) || input.peek(Token![super]) || input.peek(Token![self]);
    input.peek(Ident) || of_path || input.peek(Token![Self])
}

/// A name, and the argument of a root.
pub(super) fn parse(input: ParseStream) -> Result<Tree> {
    let ident = input.call(Ident::parse_any)?;
    match ident.to_string().as_str() {
        word if is_pi(word) => Ok(Tree::Pi),
        "sqrt" if input.peek(token::Paren) => {
            let inner;
            syn::parenthesized!(inner in input);
            Ok(Tree::Root(Box::new(whole(&inner, "`)`")?), ident.span()))
        }
        "sqrt" => Err(Error::new(ident.span(), "`sqrt` needs its argument in parentheses: `sqrt(2)`")),
        other if literal::means_a_period(other) => {
            Err(Error::new(ident.span(), format!("`{other}` isn't known here: {}", literal::A_PERIOD)))
        }
        other => Err(Error::new(ident.span(), of_a_unit(other).unwrap_or_else(|| unknown(other, other)))),
    }
}

/// What is said of `90*deg` and `deg(90)`.
fn of_a_unit(word: &str) -> Option<String> {
    let unit = literal::meant(word, &["deg", "rad"]).filter(|_| word.len() > 1)?;
    Some(format!("`{word}` is no number: `{unit}` ends literals, as in `90{unit}`, and one is `1{unit}`"))
}

/// What is said of a name, or of a path that ends in one.
fn unknown(shown: &str, last: &str) -> String {
    // The name may be a divisor.
    let of_pi = last.strip_prefix("FRAC_PI_").map(|divisor| format!("(π/{divisor})"));
    let known = match last {
        "PI" => Some("PI".to_owned()),
        "TAU" | "tau" => Some("2π".to_owned()),
        "SQRT_2" => Some("sqrt(2)".to_owned()),
        _ => of_pi,
    };
    let remedy = known.map_or_else(
        || {
            "write the number itself, with `π`, `PI` or `pi` and `sqrt(…)` where needed; of numbers known only at run time \
             `pendula::Pendulum` makes a motion"
                .to_owned()
        },
        |known| format!("write `{known}`"),
    );
    format!("`{shown}` can't be evaluated here: a macro sees names, not values; {remedy}")
}
