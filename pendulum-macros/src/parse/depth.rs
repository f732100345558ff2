//! How deeply groups may be nested: parsing them is recursive, and a compiler whose stack overflows says nothing.

use proc_macro2::{Ident, TokenStream, TokenTree};
use syn::Error;

const DEEPEST: usize = 64;

/// The mistake of groups nested too deeply, found without recursion.
pub(super) fn too_deep(tokens: &TokenStream) -> Option<Error> {
    let mut open = vec![tokens.clone().into_iter()];
    let (mut word, mut parameter) = (None, None);
    while let Some(innermost) = open.last_mut() {
        match innermost.next() {
            Some(TokenTree::Group(group)) if open.len() > DEEPEST => {
                let what = parameter.map_or_else(String::new, |name: Ident| format!("`{name}` is "));
                let message = format!("{what}nested more than {DEEPEST} deep: write it with fewer parentheses");
                return Some(Error::new(group.span_open(), message));
            }
            Some(TokenTree::Group(group)) => open.push(group.stream().into_iter()),
            Some(TokenTree::Ident(ident)) if open.len() == 1 => word = Some(ident),
            Some(TokenTree::Punct(sign)) if open.len() == 1 && sign.as_char() == '=' => parameter = word.take(),
            Some(_) => {}
            None => drop(open.pop()),
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_the_deepest() {
        let nested = |depth| format!("1 + ({}1{})", "(".repeat(depth), ")".repeat(depth)).parse().unwrap();
        assert!(too_deep(&nested(DEEPEST - 1)).is_none());
        assert!(too_deep(&nested(DEEPEST)).is_some());
        assert!(too_deep(&nested(100_000)).is_some());
    }

    #[test]
    fn names_the_parameter() {
        let nested = format!("{}1{}", "(".repeat(DEEPEST + 1), ")".repeat(DEEPEST + 1));
        let message = |text: &str| too_deep(&text.parse().unwrap()).unwrap().to_string();
        assert!(message(&format!("theta0 = 1 + sqrt{nested}")).starts_with("`theta0` is nested"));
        assert!(message(&format!("theta0 = 1, tol = {nested}")).starts_with("`tol` is nested"));
        assert!(message(&nested).starts_with("nested"));
    }
}
