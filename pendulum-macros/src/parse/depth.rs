//! How deeply groups may be nested: parsing them is recursive, and a compiler whose stack overflows says nothing.

use proc_macro2::{TokenStream, TokenTree};
use syn::Error;

const DEEPEST: usize = 64;

/// The mistake of groups nested too deeply, found without recursion.
pub(super) fn too_deep(tokens: &TokenStream) -> Option<Error> {
    let mut open = vec![tokens.clone().into_iter()];
    while let Some(innermost) = open.last_mut() {
        match innermost.next() {
            Some(TokenTree::Group(group)) if open.len() > DEEPEST => {
                let message = format!("nested more than {DEEPEST} deep: write it with fewer parentheses");
                return Some(Error::new(group.span_open(), message));
            }
            Some(TokenTree::Group(group)) => open.push(group.stream().into_iter()),
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
}
