//! `#[…] vis struct Name;`, which comes before the parameters of an item.

use super::parameter::is;
use super::words::Parameter;
use crate::report::Report;
use proc_macro2::{Delimiter, TokenTree};
use quote::ToTokens as _;
use syn::buffer::Cursor;
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

/// The header of an item, or nothing. A mistake after which the name is known is recorded, and what is no parameter skipped.
pub(super) fn shape(input: ParseStream, report: &mut Report) -> Result<Shape> {
    let start = input.cursor();
    let attributes = attributes(input)?;
    let visibility: Visibility = input.parse()?;
    let bare = attributes.is_empty() && matches!(visibility, Visibility::Inherited);
    let (name, mistake) = if bare && !input.peek(Token![struct]) {
        let Some((mistake, name)) = header_without_struct(input) else { return Ok(Shape::Expression) };
        (name.ok_or_else(|| mistake.clone())?, Some(mistake))
    } else {
        header_with_struct(input, start)?
    };
    if let Some(mistake) = mistake {
        report.add(mistake);
        skip_to_parameters(input)?;
    }
    Ok(Shape::Item(Item { attributes, visibility, name }))
}

/// The name in `struct Name;`, and the mistake if no semicolon follows. What lacks at the end is told of where something is.
fn header_with_struct(input: ParseStream, start: Cursor) -> Result<(Ident, Option<Error>)> {
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
    let lacks_semicolon = input.parse::<Option<Token![;]>>()?.is_none();
    let message = "`;`: the struct is a unit struct, its parameters follow after the semicolon";
    Ok((name, lacks_semicolon.then(|| expected(message))))
}

/// `#[…]`, any number of them.
fn attributes(input: ParseStream) -> Result<Vec<Attribute>> {
    input.call(Attribute::parse_outer).map_err(|error| {
        let inner = input.peek(Token![!]);
        if inner { input.error("an attribute of the struct is written without `!`: `#[…]`") } else { error }
    })
}

/// What comes before the first `name =`, or in a generic header before what follows its semicolon.
fn skip_to_parameters(input: ParseStream) -> Result<()> {
    let trees: Vec<TokenTree> = input.cursor().token_stream().into_iter().collect();
    let first = |sign: char| trees.iter().position(|tree| is(Some(tree), sign));
    let behind_generics = first(';').filter(|_| first('<') == Some(0)).map(|semicolon| semicolon + 1);
    let skipped = behind_generics.or_else(|| Some(first('=')?.saturating_sub(1)));
    for _ in 0..skipped.unwrap_or(trees.len()) {
        input.parse::<TokenTree>()?;
    }
    Ok(())
}

/// The mistake of `Clock;`, `enum Clock;` or `Clock { … }` where `struct Clock;` was meant, or of `unsafe struct Clock;`, and
/// the name.
fn header_without_struct(input: ParseStream) -> Option<(Error, Option<Ident>)> {
    let (first, rest) = input.cursor().ident()?;
    let is_parameter = |name: &Ident| Parameter::like(&name.to_string()).is_some();
    // What `float` and `n` may be taken for, and the beginning of an item.
    let begins_item = |name: &Ident| name == "type" || name == "fn";
    if is_parameter(&first) && !begins_item(&first) {
        return None;
    }
    let mut following = rest.token_stream().into_iter();
    let next = following.next()?;
    let name = match &next {
        TokenTree::Ident(keyword) if keyword == "struct" => return Some(word_before_struct(&first, following.next())),
        // `let theta0 = 1` is no header.
        TokenTree::Ident(second) if is_parameter(second) && !begins_item(second) => return None,
        TokenTree::Ident(second) => second,
        TokenTree::Punct(punct) if matches!(punct.as_char(), ';' | '<') => &first,
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => &first,
        _ => return None,
    };
    let message =
        format!("expected `struct {name};` and then the parameters, or nothing but parameters, `name = value`");
    Some((Error::new(first.span(), message), as_name(name)))
}

fn word_before_struct(word: &Ident, name: Option<TokenTree>) -> (Error, Option<Ident>) {
    let name = name.and_then(|tree| if let TokenTree::Ident(name) = tree { as_name(&name) } else { None });
    let shown = name.as_ref().map_or_else(|| "Name".to_owned(), Ident::to_string);
    (Error::new(word.span(), format!("`{word}` has no place before `struct {shown};`: leave it out")), name)
}

/// The word, if it is no keyword.
fn as_name(word: &Ident) -> Option<Ident> {
    syn::parse2(word.to_token_stream()).ok()
}
