//! Angle and number expressions: their grammar, and their evaluation from the digits as written.

mod tree;

use crate::exact::{Context, Real};
use proc_macro2::{Delimiter, Group, Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::{Parse, ParseStream};
use syn::{Error, Ident, Lit, Result, Token, token};
use tree::{Operator, Tree, Unit};

/// Literals longer than this, or with larger exponents, are refused: they would only make the compiler wait.
const MOST_DIGITS: usize = 500;
const LARGEST_EXPONENT: u64 = 400;

/// Expressions of more tokens are refused: their trees would be too deep for the compiler's stack.
const MOST_TOKENS: usize = 500;

/// An expression as written: literals keep their text, nothing is rounded.
#[derive(Clone, Debug)]
pub(crate) struct Number {
    tree: Tree,
}

impl Number {
    /// Parses a whole token stream, the value of one parameter.
    pub(crate) fn parse_all(tokens: TokenStream) -> Result<Self> {
        if count(&tokens) > MOST_TOKENS {
            let message = format!("an expression of more than {MOST_TOKENS} tokens: write its value");
            return Err(Error::new_spanned(tokens, message));
        }
        let tree = syn::parse2::<Whole>(parenthesise_captures(tokens))?.0;
        Ok(Self { tree })
    }

    /// The number of decimal digits that may cancel: those of the longest literal, and in a sum those that its exponent
    /// puts between it and the other terms.
    pub(crate) fn digits(&self) -> usize {
        self.tree.digits(false)
    }

    /// The first literal that carries a unit of angle (`deg` or `rad`).
    pub(crate) fn angle_unit(&self) -> Option<(&'static str, Span)> {
        self.tree.angle_unit()
    }

    /// The value, in radians if it is an angle.
    pub(crate) fn evaluate(&self, context: Context) -> Result<Real> {
        self.tree.evaluate(context)
    }
}

/// Tokens at any depth.
fn count(tokens: &TokenStream) -> usize {
    let tree = |tree| if let TokenTree::Group(group) = tree { 1 + count(&group.stream()) } else { 1 };
    tokens.clone().into_iter().map(tree).sum()
}

/// A `$x:expr` captured by a user's own macro arrives in an invisible group: read it as parenthesised.
fn parenthesise_captures(tokens: TokenStream) -> TokenStream {
    tokens
        .into_iter()
        .map(|tree| match tree {
            TokenTree::Group(group) => {
                let delimiter = match group.delimiter() {
                    Delimiter::None => Delimiter::Parenthesis,
                    other => other,
                };
                let mut inner = Group::new(delimiter, parenthesise_captures(group.stream()));
                inner.set_span(group.span());
                TokenTree::Group(inner)
            }
            other => other,
        })
        .collect()
}

struct Whole(Tree);

impl Parse for Whole {
    fn parse(input: ParseStream) -> Result<Self> {
        let tree = sum(input)?;
        if input.is_empty() {
            return Ok(Self(tree));
        }
        Err(input.error("expected `+`, `-`, `*`, `/` or the next parameter after a comma"))
    }
}

fn sum(input: ParseStream) -> Result<Tree> {
    let mut left = product(input)?;
    loop {
        let operator = if input.parse::<Option<Token![+]>>()?.is_some() {
            Operator::Add
        } else if input.parse::<Option<Token![-]>>()?.is_some() {
            Operator::Subtract
        } else {
            return Ok(left);
        };
        left = binary(left, operator, input, product)?;
    }
}

fn product(input: ParseStream) -> Result<Tree> {
    let mut left = factor(input)?;
    loop {
        let operator = if input.parse::<Option<Token![*]>>()?.is_some() {
            Operator::Multiply
        } else if input.parse::<Option<Token![/]>>()?.is_some() {
            Operator::Divide
        } else {
            return Ok(left);
        };
        left = binary(left, operator, input, factor)?;
    }
}

fn binary(
    left: Tree,
    operator: Operator,
    input: ParseStream,
    operand: fn(ParseStream) -> Result<Tree>,
) -> Result<Tree> {
    let before = input.cursor();
    let right = operand(input)?;
    let blame = before.token_stream().into_iter().take(tokens_between(&before, &input.cursor())).collect();
    Ok(Tree::Binary { left: Box::new(left), operator, right: Box::new(right), blame })
}

fn tokens_between(from: &syn::buffer::Cursor, to: &syn::buffer::Cursor) -> usize {
    let (from, to) = (from.token_stream().into_iter().count(), to.token_stream().into_iter().count());
    from - to
}

fn factor(input: ParseStream) -> Result<Tree> {
    if input.parse::<Option<Token![-]>>()?.is_some() {
        return Ok(Tree::Negative(Box::new(factor(input)?)));
    }
    if input.peek(token::Paren) {
        let inner;
        syn::parenthesized!(inner in input);
        return whole_group(&inner);
    }
    if input.peek(Ident) {
        return name(input);
    }
    if input.peek(Lit) {
        return literal(&input.parse()?);
    }
    if input.is_empty() {
        return Err(input.error("expected a number, such as `7π/8`, `157.5deg` or `3*PI/4 - 0.01`"));
    }
    Err(input.error("expected a number: digits, `π`, `sqrt(…)` or parentheses"))
}

fn whole_group(inner: ParseStream) -> Result<Tree> {
    let tree = sum(inner)?;
    if inner.is_empty() { Ok(tree) } else { Err(inner.error("expected `+`, `-`, `*`, `/` or `)`")) }
}

fn name(input: ParseStream) -> Result<Tree> {
    let ident: Ident = input.parse()?;
    match ident.to_string().as_str() {
        "π" | "PI" | "pi" => Ok(Tree::Pi),
        "sqrt" if input.peek(token::Paren) => {
            let inner;
            syn::parenthesized!(inner in input);
            Ok(Tree::Root(Box::new(whole_group(&inner)?), ident.span()))
        }
        "sqrt" => Err(Error::new(ident.span(), "`sqrt` needs its argument in parentheses: `sqrt(2)`")),
        other => Err(Error::new(
            ident.span(),
            format!(
                "`{other}` can't be evaluated here: a macro sees names, not values; write the number itself, \
                 with `π`, `PI` or `pi` and `sqrt(…)` where needed"
            ),
        )),
    }
}

fn literal(literal: &Lit) -> Result<Tree> {
    let (digits, suffix) = match literal {
        Lit::Int(int) => (int.base10_digits().to_owned(), int.suffix()),
        Lit::Float(float) => (float.base10_digits().to_owned(), float.suffix()),
        other => return Err(Error::new(other.span(), "expected a number, such as `7π/8` or `157.5deg`")),
    };
    let span = literal.span();
    let text = literal.to_token_stream().to_string();
    if text.starts_with("0x") || text.starts_with("0o") || text.starts_with("0b") {
        return Err(Error::new(span, format!("`{text}` is not a decimal number: write its value in decimal digits")));
    }
    let unit = match suffix {
        "" => Unit::None,
        "π" => Unit::Pi,
        "deg" => Unit::Degree,
        "rad" => Unit::Radian,
        other => {
            return Err(Error::new(
                span,
                format!("unknown suffix `{other}` on `{digits}`: use `π`, `deg`, `rad` or none"),
            ));
        }
    };
    let exponent = digits.split_once(['e', 'E']).map_or("0", |(_, exponent)| exponent);
    let exponent = exponent.trim_start_matches(['+', '-']).parse::<u64>().unwrap_or(u64::MAX);
    if digits.len() > MOST_DIGITS || exponent > LARGEST_EXPONENT {
        let limit = format!("a literal may have {MOST_DIGITS} digits and an exponent up to ±{LARGEST_EXPONENT}");
        return Err(Error::new(span, limit));
    }
    Ok(Tree::Literal { digits, unit, span })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> f64 {
        let number = Number::parse_all(text.parse().unwrap()).unwrap();
        number.evaluate(Context::for_digits(number.digits())).unwrap().to_f64()
    }

    fn error(text: &str) -> String {
        let number = Number::parse_all(text.parse().unwrap());
        number.and_then(|n| n.evaluate(Context::for_digits(20))).unwrap_err().to_string()
    }

    #[test]
    fn evaluates_the_documented_forms() {
        use std::f64::consts::PI;
        assert_eq!(value("7π/8"), 2.748_893_571_891_069);
        assert_eq!(value("0.95π"), 2.984_513_020_910_303_4);
        assert_eq!(value("157.5deg"), value("7*pi/8"));
        assert_eq!(value("3*PI/4 - 0.01"), 2.346_194_490_192_345);
        assert_eq!(value("-(1 + 2) * -2rad"), 6.0);
        assert_eq!(value("sqrt(2) * sqrt(2)"), 2.0);
        assert_eq!(value("86_400"), 86_400.0);
        assert_eq!(value("1 - 2 - 3 / 2 / 3"), -1.5);
        assert_eq!(value("1e-3π"), 1e-3 * PI);
        assert_eq!(value("sqrt(2) * sqrt(2) - 2"), 0.0);
    }

    #[test]
    fn uses_every_digit() {
        let text = "0.1000000000000000055511151231257827021181583404541015625000000000000000000000001 - \
                    0.1000000000000000055511151231257827021181583404541015625";
        assert_eq!(value(text), 1e-79);
    }

    #[test]
    fn explains_what_it_refuses() {
        assert!(error("1/(2 - 2)").contains("division by zero"));
        assert!(error("THETA").contains("a macro sees names, not values"));
        assert!(error("3f64").contains("unknown suffix `f64`"));
        assert!(error("sqrt(1 - 2)").contains("negative"));
        assert!(error("1e100000").contains("exponent"));
        assert!(error("").contains("expected a number"));
        assert!(error("1 2").contains("expected `+`"));
    }
}
