//! Angle and number expressions: their grammar, and their evaluation from the digits as written.

mod evaluation;
mod literal;
mod name;
mod tree;

use crate::exact::{Context, Real};
use crate::parse::source;
use proc_macro2::{Delimiter, Group, Literal, Span, TokenStream, TokenTree};
use syn::buffer::Cursor;
use syn::parse::{Parse, ParseStream};
use syn::{Error, Ident, Lit, Result, Token, token};
use tree::{Operator, Tree, Unit, is_pi};

/// Expressions of more tokens are refused: their trees would be too deep for the compiler's stack.
const MOST_TOKENS: usize = 500;

/// An expression as written: literals keep their text, nothing is rounded.
#[derive(Clone, Debug)]
pub(crate) struct Number {
    tree: Tree,
}

impl Number {
    /// Parses a whole token stream, the value of the parameter `name`.
    pub(crate) fn parse_all(name: &Ident, tokens: TokenStream) -> Result<Self> {
        if count(&tokens) > MOST_TOKENS {
            let message = format!("`{name}` is an expression of more than {MOST_TOKENS} tokens: write its value");
            return Err(Error::new_spanned(tokens, message));
        }
        literal::check(name, &tokens)?;
        name::check(name, &tokens)?;
        match syn::parse2::<Whole>(parenthesise_captures(tokens.clone())) {
            Ok(Whole(tree)) if tree.digits(false) > literal::MOST_DIGITS => {
                let most = literal::MOST_DIGITS;
                let message =
                    format!("`{name}` is an expression of which more than {most} digits may cancel: write its value");
                Err(Error::new_spanned(tokens, message))
            }
            Ok(Whole(tree)) => Ok(Self { tree }),
            Err(error) => {
                let message = format!("`{name} = {}`: {error}", source::value(&tokens));
                Err(Error::new(error.span(), message))
            }
        }
    }

    /// The number of decimal digits that may cancel: those of the longest literal, and in a sum those that its exponent
    /// puts between it and the other terms.
    pub(crate) fn digits(&self) -> usize {
        self.tree.digits(false)
    }

    /// Whether the first literal that is an angle is one in degrees.
    pub(crate) fn is_in_degrees(&self) -> bool {
        self.tree.angle_unit() == Some(Unit::Degree)
    }

    /// Whether it is one literal without a unit, with a minus before it or not.
    pub(crate) fn is_plain(&self) -> bool {
        let inner = if let Tree::Negative(inner) = &self.tree { inner } else { &self.tree };
        matches!(inner, Tree::Literal { unit: Unit::None, .. })
    }

    /// The value, in radians if it is an angle, to the precision of `context`.
    pub(crate) fn evaluate(&self, context: Context) -> Result<Real> {
        evaluation::value(&self.tree, context)
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
        whole(input, "the next parameter after a comma").map(Self)
    }
}

/// All of `input`; `end` ends the message of what follows instead of an operator.
fn whole(input: ParseStream, end: &str) -> Result<Tree> {
    let start = input.cursor();
    let tree = sum(input)?;
    if input.is_empty() { Ok(tree) } else { Err(no_operator(&start, input, end)) }
}

fn sum(input: ParseStream) -> Result<Tree> {
    let mut left = product(input)?;
    loop {
        let sign = input.span();
        let operator = if input.parse::<Option<Token![+]>>()?.is_some() {
            Operator::Add
        } else if input.parse::<Option<Token![-]>>()?.is_some() {
            Operator::Subtract
        } else {
            return Ok(left);
        };
        left = binary(left, (operator, sign), input, product)?;
    }
}

fn product(input: ParseStream) -> Result<Tree> {
    let mut left = factor(input)?;
    loop {
        let sign = input.span();
        let operator = if input.parse::<Option<Token![*]>>()?.is_some() {
            if input.peek(Token![*]) {
                return Err(input.error(NO_POWERS));
            }
            Operator::Multiply
        } else if input.parse::<Option<Token![/]>>()?.is_some() {
            Operator::Divide
        } else {
            return Ok(left);
        };
        left = binary(left, (operator, sign), input, factor)?;
    }
}

fn binary(
    left: Tree,
    (operator, sign): (Operator, Span),
    input: ParseStream,
    operand: fn(ParseStream) -> Result<Tree>,
) -> Result<Tree> {
    follows(sign, input)?;
    let before = input.cursor();
    let right = operand(input)?;
    let blame = before.token_stream().into_iter().take(tokens_between(&before, &input.cursor())).collect();
    Ok(Tree::Binary { left: Box::new(left), operator, right: Box::new(right), blame })
}

/// Refuses an operator at the end.
fn follows(sign: Span, input: ParseStream) -> Result<()> {
    if input.is_empty() { Err(Error::new(sign, "expected a number after this sign")) } else { Ok(()) }
}

fn tokens_between(from: &Cursor, to: &Cursor) -> usize {
    let (from, to) = (from.token_stream().into_iter().count(), to.token_stream().into_iter().count());
    from - to
}

fn factor(input: ParseStream) -> Result<Tree> {
    let sign = input.span();
    if input.parse::<Option<Token![-]>>()?.is_some() {
        follows(sign, input)?;
        return Ok(Tree::Negative(Box::new(factor(input)?)));
    }
    if input.peek(token::Paren) {
        let inner;
        syn::parenthesized!(inner in input);
        return whole(&inner, "`)`");
    }
    if name::begins(input) {
        return name::parse(input);
    }
    if input.peek(Lit) {
        return literal::parse(&input.parse()?);
    }
    if input.peek(Token![+]) {
        return Err(input.error("a number has no `+` before it: leave it out"));
    }
    if let Some((_, after)) = input.cursor().punct().filter(|(punct, _)| punct.as_char() == '.') {
        let digits = after.literal().map_or_else(|| "5".to_owned(), |(digits, _)| digits.to_string());
        return Err(input.error(format!("a number begins with a digit: write `0.{digits}`")));
    }
    if input.is_empty() {
        return Err(Error::new(input.span(), "expected a number, such as `7π/8`, `157.5deg` or `3*PI/4 - 0.01`"));
    }
    Err(input.error("expected a number: digits, `π`, `sqrt(…)` or parentheses"))
}

const NO_POWERS: &str =
    "there are no powers: write a product, `2*2`, or the value itself, such as `1e-3` or `9.007e15`";

/// The mistake of what follows a number and isn't an operator; `end` could have followed, too.
fn no_operator(start: &Cursor, input: ParseStream, end: &str) -> Error {
    match input.cursor().token_stream().into_iter().next() {
        Some(TokenTree::Ident(word)) => no_operator_but_word(&word.to_string(), &read(start, input), input, end),
        Some(TokenTree::Punct(punct)) => match punct.as_char() {
            '^' => input.error(NO_POWERS),
            '.' => input.error(after_point(input)),
            ',' => input.error("parentheses hold one number: remove this comma and what follows it"),
            _ => no_sign(input, end),
        },
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis => {
            Error::new(group.span_open(), "a product needs its sign: write `*` before `(`")
        }
        _ => no_sign(input, end),
    }
}

fn no_sign(input: ParseStream, end: &str) -> Error {
    input.error(format!("expected `+`, `-`, `*`, `/` or {end}"))
}

/// What is said of a point after a number: before a unit or an exponent, of a call, a range, or no more than a point.
fn after_point(input: ParseStream) -> &'static str {
    let mut rest = input.cursor().token_stream().into_iter().skip(1);
    match rest.next() {
        Some(TokenTree::Ident(unit)) if Unit::of_suffix(&unit.to_string()).is_some() => {
            "a unit follows a digit: leave this point out"
        }
        Some(TokenTree::Ident(word)) if is_exponent(&word.to_string()) => {
            "an exponent follows a digit: leave this point out, as in `1e-3`"
        }
        Some(TokenTree::Ident(_)) => "nothing can be called here: write the value itself, such as `30deg` or `sqrt(2)`",
        Some(TokenTree::Punct(next)) if next.as_char() == '.' => "a range is no number: write one number",
        _ => "a number has one point, without spaces around it, and ends in a digit",
    }
}

/// Whether it begins an exponent, as in `1.e-3` and `1.e5`.
fn is_exponent(word: &str) -> bool {
    word.strip_prefix(['e', 'E']).is_some_and(|digits| digits.bytes().all(|digit| digit.is_ascii_digit()))
}

/// The same of a word; `read` stands before it.
fn no_operator_but_word(word: &str, read: &[TokenTree], input: ParseStream, end: &str) -> Error {
    // One that has a suffix takes no other.
    let plain = |literal: &Literal| literal.to_string().ends_with(|last: char| last.is_ascii_digit() || last == '.');
    let divides = |trees: &[TokenTree]| matches!(trees.last(), Some(TokenTree::Punct(sign)) if sign.as_char() == '/');
    match (word, read) {
        // In `7/8 π` it would be below the line.
        (_, [before @ .., TokenTree::Literal(literal)])
            if Unit::of_suffix(word).is_some() && plain(literal) && !divides(before) =>
        {
            input.error(format!(
                "`{word}` belongs to the number before it: leave out the space, as in `{literal}{word}`"
            ))
        }
        ("deg" | "rad", _) => input.error(format!("`{word}` ends literals only: write `*1{word}`")),
        _ if is_pi(word) || word == "sqrt" => {
            input.error(format!("a product needs its sign: write `*` before `{word}`"))
        }
        ("as", _) => input.error("numbers have no type here, all their digits count: leave out the `as` and its type"),
        _ => no_sign(input, end),
    }
}

/// The tokens that have been read since `start`.
fn read(start: &Cursor, input: ParseStream) -> Vec<TokenTree> {
    start.token_stream().into_iter().take(tokens_between(start, &input.cursor())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Number> {
        Number::parse_all(&quote::format_ident!("theta0"), text.parse().unwrap())
    }

    fn value(text: &str) -> f64 {
        let number = parse(text).unwrap();
        number.evaluate(Context::for_digits(number.digits())).unwrap().to_f64()
    }

    fn error(text: &str) -> String {
        let number = parse(text);
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
        assert_eq!(value("90deg/45deg*2rad"), 4.0);
        assert_eq!(value("sqrt(90deg/45deg)*2rad"), 2.0 * std::f64::consts::SQRT_2);
    }

    #[test]
    fn uses_every_digit() {
        let text = "0.1000000000000000055511151231257827021181583404541015625000000000000000000000001 - \
                    0.1000000000000000055511151231257827021181583404541015625";
        assert_eq!(value(text), 1e-79);
    }

    /// What is left of terms that cancelled cancels with others, more of its digits than were written.
    #[test]
    fn terms_cancel_again() {
        for (text, exact) in [
            ("(1/(1+1e-90) - 1 + 1e-90)*1e90*1e90", 1.0),
            ("(1/(1+1e-97) - 1 + 1e-97)*1e97*1e97", 1.0),
            ("(sqrt(1+1e-95) - 1 - 0.5e-95)*1e95*1e95*(-8)", 1.0),
            ("(1/(1+1e-30) - 1 + 1e-30 - 1e-60 + 1e-90)*1e60*1e60", 1.0),
            ("1/(1 - 1/(1+1e-90) - 1e-90)*1e-90*1e-90", -1.0),
            ("π*π/π - π", 0.0),
            ("1e-90 + π - 1e-90 - π", 0.0),
        ] {
            assert_eq!(value(text), exact, "{text}");
        }
        // x ↦ 1/(1 + x) − 1 + x, about x², four times: of 6400 digits nothing is left but the square.
        let again = |x: String| format!("(1/(1+{x})-1+{x})");
        let text = again(again(again(again("1e-400".to_owned())))) + &"*1e400".repeat(16);
        assert_eq!(value(&text), 1.0);
        // All the bits that were asked for, of what is 3e-91 from 1.
        let number = parse("(1/(1+1e-90) - 1 + 1e-90)*1e90*1e90 - 1").unwrap();
        let context = Context::for_digits(number.digits());
        let value = number.evaluate(context).unwrap();
        let exact = number.evaluate(context.widened(4000)).unwrap();
        assert!((&value - &exact).abs() <= exact.abs() * context.resolution());
        assert!((exact.to_f64() + 1e-90).abs() < 1e-104);
    }

    /// In a sum as many as the exponents of its terms are apart, also where these are products.
    #[test]
    fn digits_of_sums() {
        for (text, least) in [("π - 1e-400", 401), ("π - 1e-200*1e-200", 402), ("1 + 2e-100/3e200", 302), ("1e-300", 1)]
        {
            let digits = parse(text).unwrap().digits();
            assert!((least..least + 4).contains(&digits), "{text}: {digits}");
        }
    }

    /// The point is no digit.
    #[test]
    fn literals_have_10_000_digits_at_most() {
        let literal = |digits: usize| format!("0.{}", "3".repeat(digits - 1));
        assert_eq!(value(&literal(10_000)), 1.0 / 3.0);
        for digits in [10_001, 10_002, 20_000] {
            assert!(error(&literal(digits)).contains("more than 10000 digits"), "{digits}");
        }
    }

    #[test]
    fn at_most_10_000_digits_cancel() {
        let product = |factors: usize| format!("π - {}", vec!["1e-399"; factors].join("*"));
        assert_eq!(value(&product(24)), std::f64::consts::PI);
        assert!(error(&product(26)).contains("more than 10000 digits may cancel"));
    }

    #[test]
    fn explains_what_it_refuses() {
        assert!(error("1/(2 - 2)").contains("division by zero"));
        for path in ["THETA", "consts::ANGLE", "crate::ANGLE", "super::ANGLE", "self::ANGLE", "Self::ANGLE"] {
            assert!(error(path).contains("a macro sees names, not values"), "{path}");
        }
        assert!(error("3f64").contains("`theta0 = 3f64` has the suffix `f64`"));
        assert!(error("3 deg").contains("leave out the space, as in `3deg`"));
        assert!(error("7/8 π").contains("write `*` before `π`"));
        assert!(error("30/2 deg").contains("write `*1deg`"));
        assert!(error("30 degrees").contains("has `degrees` in it: `theta0` is an angle"));
        assert!(error("2*(3/4)deg").contains("write `*1deg`"));
        assert!(error("1π π").contains("write `*` before `π`"));
        assert!(error("sqrt(3)π").contains("write `*` before `π`"));
        assert!(error("2π(1 + 1)").contains("write `*` before `(`"));
        assert!(error("7PI/8").contains("write it `π`"));
        assert!(error("2^0.5").contains("there are no powers"));
        assert!(error("1 + 2**3").contains("there are no powers"));
        assert!(error("2*").contains("a number after this sign"));
        assert!(error("(1, 2)").contains("one number"));
        assert!(error("1 as f64").contains("`theta0 = 1 as f64`: numbers have no type here"));
        assert!(error("(3 PI)").contains("write `*` before `PI`"));
        assert!(error(".25").contains("write `0.25`"));
        assert!(error("+1").contains("leave it out"));
        assert!(error("30degrees").contains("write it `deg`"));
        assert!(error("90*deg").contains("`deg` ends literals, as in `90deg`, and one is `1deg`"));
        assert!(error("Degrees(90)").contains("`Degrees` is no number: `deg` ends literals"));
        assert!(error("d*90").contains("`d` can't be evaluated"));
        assert!(error("2.0_f64.sqrt()").contains("nothing can be called here"));
        assert!(error("157.deg").contains("leave this point out"));
        assert!(error("1.e-3").contains("leave this point out, as in `1e-3`"));
        assert!(error("2.E5").contains("leave this point out, as in `1e-3`"));
        assert!(error("0..100").contains("a range is no number"));
        assert!(error("-π..π").contains("a range is no number"));
        for several in ["1.2.3", "1 .0", "1e-6."] {
            assert!(error(several).contains("a number has one point"), "{several}");
        }
        assert!(error("std::f64::consts::PI / 2").contains("`std::f64::consts::PI` can't be evaluated here"));
        assert!(error("::core::f64::consts::PI").contains("write `PI`"));
        assert!(error("1/FRAC_PI_2").contains("write `(π/2)`"));
        assert!(error("TAU").contains("write `2π`"));
        assert!(error("90deg*2deg").contains("an angle times an angle"));
        assert!(error("2*(90deg*(1 + 2rad))").contains("an angle times an angle"));
        assert!(error("1/90deg").contains("a number over an angle"));
        assert!(error("sqrt(4deg)*2").contains("the root of an angle"));
        assert!(error("sqrt(1 - 2)").contains("negative"));
        assert!(error("1e100000").contains("exponent"));
        assert!(error("").contains("expected a number"));
        assert!(error("1 2").contains("expected `+`"));
    }

    /// All that an expression can't be evaluated for is reported, of both sides of every operator.
    #[test]
    fn several_mistakes_in_one_expression() {
        let number = parse("(1/0) + (2deg*3deg)*sqrt(-1) + 4").unwrap();
        let error = number.evaluate(Context::for_digits(20)).unwrap_err();
        assert_eq!(error.into_iter().count(), 3);
    }
}
