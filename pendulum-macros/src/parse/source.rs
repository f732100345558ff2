//! Values as the user wrote them, evenly spaced.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// One value: spaces around `+` and binary `-` and after commas, and where an operator is missing, nowhere else.
pub(crate) fn value(tokens: &TokenStream) -> String {
    let mut text = String::new();
    let mut after_operand = false;
    for tree in tokens.clone() {
        match &tree {
            TokenTree::Punct(punct) => {
                match (punct.as_char(), after_operand) {
                    (sign @ ('+' | '-'), true) => text.extend([' ', sign, ' ']),
                    (end @ (',' | ';'), _) => text.extend([end, ' ']),
                    (other, _) => text.push(other),
                }
                after_operand = false;
            }
            TokenTree::Group(group) => {
                let inner = value(&group.stream());
                let single = group.stream().into_iter().count() == 1;
                match group.delimiter() {
                    Delimiter::Bracket => text.extend(["[", &inner, "]"]),
                    Delimiter::Brace => text.extend(["{", &inner, "}"]),
                    // A captured `$x:expr` had no parentheses of its own, but needs them to read the same.
                    Delimiter::None if single => text.push_str(&inner),
                    _ => text.extend(["(", &inner, ")"]),
                }
                after_operand = true;
            }
            operand => {
                text.extend(after_operand.then_some(' '));
                text.push_str(&shortened(operand.to_string()));
                after_operand = true;
            }
        }
    }
    text.truncate(text.trim_end().len());
    text
}

/// A literal of so many characters that nobody reads them, by its first and last: the sign and the exponent are there.
fn shortened(word: String) -> String {
    const MOST: usize = 100;
    const FIRST: usize = 60;
    const LAST: usize = 10;
    if word.len() <= MOST {
        return word;
    }
    let first: String = word.chars().take(FIRST).collect();
    let last = word.char_indices().rev().nth(LAST - 1).map_or("", |(start, _)| &word[start..]);
    format!("{first}…{last}")
}
