//! The parameters one by one, `name = value`: a mistake in one doesn't hide those in the next.

use super::names::unknown_parameter;
use super::words::{Float, Keyword, Method, Output, Parameter};
use crate::report::Report;
use proc_macro2::{Delimiter, Literal, Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Error, Ident, Result, Token};

/// The tokens up to a comma, and its span, or the mistake that stands in its place.
type Piece = (TokenStream, Result<Span>);

/// Takes what is between commas, one of many, and records the mistakes of the commas themselves.
pub(super) fn for_each(
    tokens: TokenStream,
    [one, many]: [&str; 2],
    report: &mut Report,
    mut take: impl FnMut(TokenStream, &mut Report),
) {
    for (piece, end) in split(tokens, many) {
        if !piece.is_empty() {
            take(piece, report);
        } else if let Ok(comma) = &end {
            report.at(*comma, format!("expected {one} before this comma: remove it"));
        }
        report.take(end);
    }
}

fn split(tokens: TokenStream, many: &str) -> Vec<Piece> {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let (mut pieces, mut piece) = (Vec::new(), Vec::new());
    for (tree, rest) in trees.iter().zip((1..).map(|next| &trees[next..])) {
        let separator = separator(tree, &piece, rest, many);
        let belongs = separator.is_none() || matches!(tree, TokenTree::Ident(_));
        pieces.extend(separator.map(|separator| (piece.drain(..).collect(), separator)));
        piece.extend(belongs.then(|| tree.clone()));
    }
    if !piece.is_empty() {
        pieces.push((piece.into_iter().collect(), Ok(Span::call_site())));
    }
    pieces
}

/// What ends a piece before or at a token. Where another `name = ` follows without a comma, or a semicolon, that is a
/// mistake of its own.
fn separator(tree: &TokenTree, piece: &[TokenTree], rest: &[TokenTree], many: &str) -> Option<Result<Span>> {
    let mistake = |span: Span, remedy: &str| Err(Error::new(span, format!("{many} are separated by commas: {remedy}")));
    match tree {
        TokenTree::Punct(punct) => match punct.as_char() {
            ',' if !lists(piece, rest) => Some(Ok(punct.span())),
            // Of a header where none belongs enough is said.
            ';' if is_header(piece) => Some(Ok(punct.span())),
            ';' if piece.is_empty() || rest.is_empty() => Some(mistake(punct.span(), "remove this `;`")),
            ';' => Some(mistake(punct.span(), "write `,`")),
            _ => None,
        },
        TokenTree::Ident(name) if has_value(piece) && is(rest.first(), '=') => {
            Some(mistake(name.span(), &format!("write one before `{name}`")))
        }
        _ => None,
    }
}

/// Whether this begins `pub struct Name`.
fn is_header(piece: &[TokenTree]) -> bool {
    piece.first().is_some_and(|word| is_of_header(&word.to_string()))
}

fn is_of_header(word: &str) -> bool {
    matches!(word, "pub" | "struct")
}

pub(super) fn is(tree: Option<&TokenTree>, sign: char) -> bool {
    matches!(tree, Some(TokenTree::Punct(punct)) if punct.as_char() == sign)
}

/// Whether there is something behind an equals sign, and no operator that wants more.
fn has_value(piece: &[TokenTree]) -> bool {
    piece.iter().any(|tree| is(Some(tree), '=')) && !matches!(piece.last(), Some(TokenTree::Punct(_)))
}

/// Whether this is `outputs = theta` without brackets, and what follows another output: one mistake, and to be told of
/// as one.
fn lists(piece: &[TokenTree], rest: &[TokenTree]) -> bool {
    let output = |tree: &TokenTree| Output::from_word(&tree.to_string()).is_some();
    let outputs = |name: &TokenTree| Parameter::like(&name.to_string()) == Some(Parameter::Outputs);
    let begins = matches!(piece, [name, _, value, ..] if outputs(name) && output(value));
    begins
        && rest.first().is_some_and(output)
        && matches!(rest.get(1), None | Some(TokenTree::Punct(_)))
        && !is(rest.get(1), '=')
}

/// What comes before a second `struct Name;`, of which one mistake tells. Where no value does, what follows is meant for
/// the first.
pub(super) fn before_another(tokens: TokenStream, report: &mut Report) -> TokenStream {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let is_struct = |tree: &TokenTree| matches!(tree, TokenTree::Ident(word) if word == "struct");
    let Some(another) = trees.iter().position(is_struct) else { return trees.into_iter().collect() };
    let separates = |tree: &TokenTree| is(Some(tree), ';') || is(Some(tree), ',');
    let end = trees[..another].iter().rposition(separates).unwrap_or(another);
    if !has_value(&trees[..end]) {
        return trees.into_iter().collect();
    }
    let name = trees.get(another + 1).map_or_else(|| "Name".to_owned(), ToString::to_string);
    let message =
        format!("one call makes one struct: put `struct {name};` and its parameters into a `pendulum!` of their own");
    report.at(trees[another].span(), message);
    trees.into_iter().take(end).collect()
}

/// `name = value`, the value's tokens untouched.
pub(super) fn named_value(tokens: &TokenStream) -> Result<(Ident, TokenStream)> {
    let parse = |input: ParseStream| {
        let name = input.call(Ident::parse_any).map_err(|_| no_name(input))?;
        let sign = input.span();
        if input.parse::<Option<Token![=]>>()?.is_none() {
            return Err(no_value(&name, input));
        }
        if input.peek(Token![=]) || input.peek(Token![>]) {
            return Err(wrong_sign(&name, sign));
        }
        let value: TokenStream = input.parse()?;
        if value.is_empty() {
            return Err(Error::new(name.span(), format!("`{name} =` lacks its value")));
        }
        Ok((name, without_capture(value)))
    };
    parse.parse2(tokens.clone())
}

/// A value that a user's own macro captured comes in an invisible group, whose span is that of the macro's `$x`: mistakes
/// are shown at what was captured.
fn without_capture(value: TokenStream) -> TokenStream {
    let mut trees = value.clone().into_iter();
    match (trees.next(), trees.next()) {
        (Some(TokenTree::Group(group)), None) if group.delimiter() == Delimiter::None => {
            without_capture(group.stream())
        }
        _ => value,
    }
}

/// The mistake of what has no name before it, as what follows the comma in `t_max = 86,400`.
fn no_name(input: ParseStream) -> Error {
    if let Some(TokenTree::Group(group)) = input.cursor().token_stream().into_iter().next()
        && group.delimiter() != Delimiter::None
    {
        return Error::new(
            group.span_open(),
            "parameters stand by themselves, without brackets: remove this and its end",
        );
    }
    let is_number = |literal: &Literal| literal.to_string().starts_with(|first: char| first.is_ascii_digit());
    let alone = matches!(input.cursor().literal(), Some((literal, rest)) if rest.eof() && is_number(&literal));
    let number = if alone { "; of a number the point is a `.`, and `_` may group the digits" } else { "" };
    input.error(format!("expected `name = value`, such as `theta0 = 7π/8`{number}"))
}

/// The mistake of a word that no `=` follows.
fn no_value(name: &Ident, input: ParseStream) -> Error {
    let word = name.to_string();
    let is_parameter = Parameter::like(&word).is_some();
    match input.cursor().token_stream().into_iter().next() {
        Some(TokenTree::Ident(_)) if is_of_header(&word) => {
            Error::new(name.span(), "one call makes one struct, and `struct Name;` comes before its parameters")
        }
        Some(TokenTree::Ident(next)) if !is_parameter => {
            Error::new(name.span(), format!("`{word}` has no place before `{next}`: parameters are `name = value`"))
        }
        Some(next) => wrong_sign(name, next.span()),
        None => Error::new(name.span(), lone(&word, is_parameter)),
    }
}

/// The mistake of another sign than one `=` after a word, and that of the word.
fn wrong_sign(name: &Ident, sign: Span) -> Error {
    let word = name.to_string();
    let one_sign = |name: &str| Error::new(sign, format!("a value is given by one `=`: write `{name} = …`"));
    if Parameter::named(&word).is_some() {
        return one_sign(&word);
    }
    let mut unknown = Error::new(name.span(), unknown_parameter(&word, |_| false));
    if let Some(meant) = Parameter::like(&word) {
        unknown.combine(one_sign(meant.word()));
    }
    unknown
}

/// What is said of a word alone.
fn lone(word: &str, is_parameter: bool) -> String {
    let value_of = |parameter: &str| format!("`{word}` is a value of `{parameter}`: write `{parameter} = {word}`");
    if Float::from_word(word).is_some() {
        value_of("float")
    } else if Method::from_word(word).is_some() {
        value_of("method")
    } else if is_parameter {
        format!("expected a value: `{word} = …`")
    } else {
        unknown_parameter(word, |_| false)
    }
}
