//! Literals: what they may end in, and how long they may be.

use super::tree::{Tree, Unit, is_pi};
use crate::exact::{digits_of_mantissa, mantissa_and_exponent};
use crate::parse::{Parameter, source};
use proc_macro2::{Literal, Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Error, Ident, Lit, Result};

/// Literals longer than this, or with larger exponents, are refused: they would only make the compiler wait.
pub(super) const MOST_DIGITS: usize = 10_000;
const LARGEST_EXPONENT: u64 = 400;

/// The remedy for a horizon of so many periods: what a period is depends on all of the scene.
pub(super) const A_PERIOD: &str =
    "write the time itself, in the unit of t; an item's documentation, and its `PERIOD`, say how long a period is";

/// Whether `word` is one for the period.
pub(super) fn means_a_period(word: &str) -> bool {
    matches!(word, "T" | "PERIOD" | "period" | "periods")
}

/// The units that a parameter's literals may end in, and what it is.
fn meaning(name: &Ident) -> (&'static [&'static str], &'static str) {
    match Parameter::of(name) {
        Some(Parameter::Omega) => (&[], "in radians per unit of t, a number without suffix"),
        Some(Parameter::G) => (&[], "in m/s², a number without suffix"),
        Some(Parameter::Length) => (&[], "in m, a number without suffix"),
        Some(Parameter::Tol) => (
            &[],
            "an error in radians (velocity: times ω, acceleration: times ω², position: in lengths), without suffix",
        ),
        Some(Parameter::TMax) => (&[], "in the unit of t, a number without suffix"),
        Some(Parameter::Velocity0) => {
            (&["deg", "rad"], "an angle per unit of t, whose literals may end in `π`, `deg` or `rad`")
        }
        _ => (&["deg", "rad"], "an angle, whose literals may end in `π`, `deg` or `rad`"),
    }
}

/// Refuses literals that have no meaning in the parameter `name`: before anything else is said of the expression, since
/// the `m` of `9.81m/s` is the mistake, not the `s`.
pub(super) fn check(name: &Ident, tokens: &TokenStream) -> Result<()> {
    in_any_depth(tokens).try_for_each(|(literal, next)| {
        // Of a call, as in `30f64.to_radians()`, more has to go than the suffix.
        if matches!(&next, Some(TokenTree::Punct(point)) if point.as_char() == '.') {
            return Ok(());
        }
        let span = literal.span();
        let mistake = match Lit::new(literal) {
            Lit::Int(int) => suffix(name, tokens, int.suffix()).or_else(|| length(name, int.base10_digits())),
            Lit::Float(float) => suffix(name, tokens, float.suffix()).or_else(|| length(name, float.base10_digits())),
            _ => return Ok(()),
        };
        let mistake = mistake.map(|message| (span, message));
        mistake.or_else(|| unit(name, tokens, next?)).map_or(Ok(()), |(span, message)| Err(Error::new(span, message)))
    })
}

/// Literals, and what follows each.
fn in_any_depth(tokens: &TokenStream) -> Box<dyn Iterator<Item = (Literal, Option<TokenTree>)>> {
    let following = tokens.clone().into_iter().skip(1).map(Some).chain([None]);
    Box::new(tokens.clone().into_iter().zip(following).flat_map(|(tree, next)| match tree {
        TokenTree::Group(group) => in_any_depth(&group.stream()),
        TokenTree::Literal(literal) => Box::new(std::iter::once((literal, next))),
        _ => Box::new(std::iter::empty()),
    }))
}

fn suffix(name: &Ident, value: &TokenStream, suffix: &str) -> Option<String> {
    let (units, _) = meaning(name);
    if suffix.is_empty() || suffix == "π" || units.contains(&suffix) {
        return None;
    }
    let remedy = match suffix {
        "pi" | "PI" | "Pi" => "write it `π`, as in `2π`, or as a factor, `2*PI`".to_owned(),
        "f32" | "f64" | "i32" | "i64" | "u32" | "u64" | "usize" | "isize" => {
            "numbers have no type here: leave it out, and say what the results are by `float`".to_owned()
        }
        _ => meant(suffix, units).map_or_else(|| unknown(name, suffix), |unit| format!("write it `{unit}`")),
    };
    Some(format!("`{name} = {}` has the suffix `{suffix}`: {remedy}", source::value(value)))
}

/// Of the units that there are, the one that was written otherwise.
pub(super) fn meant(suffix: &str, units: &[&'static str]) -> Option<&'static str> {
    let unit = match suffix.to_lowercase().as_str() {
        "deg" | "degs" | "degree" | "degrees" | "d" => "deg",
        "rad" | "rads" | "radian" | "radians" | "r" => "rad",
        _ => return None,
    };
    units.contains(&unit).then_some(unit)
}

/// The remedy for a unit that the parameter `name` doesn't have.
fn unknown(name: &Ident, unit: &str) -> String {
    if Parameter::of(name) == Some(Parameter::TMax) && means_a_period(unit) {
        return A_PERIOD.to_owned();
    }
    let (_, what) = meaning(name);
    let of_radians = matches!(Parameter::of(name), Some(Parameter::Omega | Parameter::Tol));
    let in_radians = of_radians && meant(unit, &["deg"]).is_some();
    let remedy = if in_radians { "; multiply degrees by `π/180`" } else { "" };
    format!("`{name}` is {what}{remedy}")
}

/// The mistake of a unit after the number, as in `99.4 cm`, where it is none that is a suffix with a space before it.
fn unit(name: &Ident, value: &TokenStream, next: TokenTree) -> Option<(Span, String)> {
    let TokenTree::Ident(word) = next else { return None };
    let (units, _) = meaning(name);
    let text = word.to_string();
    let known = is_pi(&text) || matches!(text.as_str(), "sqrt" | "as") || units.contains(&text.as_str());
    let message = || format!("`{name} = {}` has `{text}` in it: {}", source::value(value), unknown(name, &text));
    (!known).then(|| (word.span(), message()))
}

fn length(name: &Ident, digits: &str) -> Option<String> {
    let (_, exponent) = mantissa_and_exponent(digits);
    let exponent = exponent.trim_start_matches(['+', '-']).parse::<u64>().unwrap_or(u64::MAX);
    if digits_of_mantissa(digits) > MOST_DIGITS {
        return Some(format!(
            "`{name}` has a literal of more than {MOST_DIGITS} digits: no float needs so many, write fewer"
        ));
    }
    (exponent > LARGEST_EXPONENT)
        .then(|| format!("`{name}` has `{digits}` in it, beyond every float: exponents may go to ±{LARGEST_EXPONENT}"))
}

/// A literal that passed [`check`].
pub(super) fn parse(literal: &Lit) -> Result<Tree> {
    let (digits, suffix) = match literal {
        Lit::Int(int) => (int.base10_digits().to_owned(), int.suffix()),
        Lit::Float(float) => (float.base10_digits().to_owned(), float.suffix()),
        other => {
            let shown = other.to_token_stream();
            return Err(Error::new(
                other.span(),
                format!("expected a number, such as `7π/8` or `157.5deg`, without quotes, not `{shown}`"),
            ));
        }
    };
    let span = literal.span();
    let text = literal.to_token_stream().to_string();
    if text.starts_with("0x") || text.starts_with("0o") || text.starts_with("0b") {
        return Err(Error::new(span, format!("`{text}` is not a decimal number: write its value in decimal digits")));
    }
    // Any other suffix is followed by a call, which is what is refused.
    let unit = Unit::of_suffix(suffix).unwrap_or(Unit::None);
    Ok(Tree::Literal { digits, unit, span })
}
