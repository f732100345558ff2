//! `#[…] vis struct Name;`, which comes before the parameters of an item.

use super::words::Parameter;
use proc_macro2::{Delimiter, TokenTree};
use syn::parse::ParseStream;
use syn::{Attribute, Error, Ident, Result, Token, Visibility};

/// What the invocation expands to.
#[derive(Clone)]
pub(crate) enum Shape {
    /// A zero-sized fn item.
    Expression,
    /// `#[…] vis struct Name;`
    Item(Item),
}

/// The header of the item form.
#[derive(Clone)]
pub(crate) struct Item {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) name: Ident,
}

/// The header of an item, or nothing.
pub(super) fn shape(input: ParseStream) -> Result<Shape> {
    let start = input.cursor();
    let attributes = attributes(input)?;
    let visibility: Visibility = input.parse()?;
    let bare = attributes.is_empty() && matches!(visibility, Visibility::Inherited);
    if bare && !input.peek(Token![struct]) {
        return header_without_struct(input).map_or(Ok(Shape::Expression), Err);
    }
    // What lacks at the end is told of where something is.
    let expected = |what: &str| {
        let last = start.token_stream().into_iter().last().filter(|_| input.is_empty());
        Error::new(last.map_or_else(|| input.span(), |last| last.span()), format!("expected {what}"))
    };
    if input.parse::<Option<Token![struct]>>()?.is_none() {
        return Err(expected("`struct Name;` after attributes or a visibility"));
    }
    if input.cursor().ident().is_none() {
        return Err(expected("the name of the struct: `struct Name;`"));
    }
    let name = input.parse()?;
    if input.parse::<Option<Token![;]>>()?.is_none() {
        return Err(expected("`;`: the struct is a unit struct, its parameters follow after the semicolon"));
    }
    Ok(Shape::Item(Item { attributes, visibility, name }))
}

/// `#[…]`, any number of them.
fn attributes(input: ParseStream) -> Result<Vec<Attribute>> {
    input.call(Attribute::parse_outer).map_err(|error| {
        let inner = input.peek(Token![!]);
        if inner { input.error("an attribute of the struct is written without `!`: `#[…]`") } else { error }
    })
}

/// The mistake of `Clock;`, `enum Clock;` or `Clock { … }` where `struct Clock;` was meant.
fn header_without_struct(input: ParseStream) -> Option<Error> {
    let (first, rest) = input.cursor().ident()?;
    let is_parameter = |name: &Ident| Parameter::like(&name.to_string()).is_some();
    // `type` is what `float` may be taken for, and the beginning of an item.
    if is_parameter(&first) && first != "type" {
        return None;
    }
    let mut following = rest.token_stream().into_iter();
    let next = following.next()?;
    let name = match &next {
        TokenTree::Ident(keyword) if keyword == "struct" => return Some(word_before_struct(&first, following.next())),
        // `let theta0 = 1` is no header.
        TokenTree::Ident(second) if is_parameter(second) && second != "type" => return None,
        TokenTree::Ident(second) => second,
        TokenTree::Punct(punct) if matches!(punct.as_char(), ';' | '<') => &first,
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => &first,
        _ => return None,
    };
    let message =
        format!("expected `struct {name};` and then the parameters, or nothing but parameters, `name = value`");
    Some(Error::new(first.span(), message))
}

/// The mistake of `unsafe struct Clock;`.
fn word_before_struct(word: &Ident, name: Option<TokenTree>) -> Error {
    let name = name.map_or_else(|| "Name".to_owned(), |name| name.to_string());
    Error::new(word.span(), format!("`{word}` has no place before `struct {name};`: leave it out"))
}
