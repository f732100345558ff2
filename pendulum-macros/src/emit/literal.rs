//! Numbers as literals that read back to the same bits, and their types.

use crate::parse::Float;
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

impl ToTokens for Float {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        format_ident!("{}", self.word()).to_tokens(tokens);
    }
}

/// The shortest decimal that is this number of type `float`, without suffix; what isn't finite as ∞.
pub(super) fn float(x: f64, float: Float) -> TokenStream {
    if !x.is_finite() {
        return quote!(#float::INFINITY);
    }
    let text = digits(x.abs(), float);
    let literal = text.parse::<Literal>().unwrap_or_else(|_| Literal::f64_unsuffixed(x.abs()));
    if x.is_sign_negative() { quote!(-#literal) } else { quote!(#literal) }
}

/// As [`float`], with its type as a suffix, to be the receiver of a method call.
pub(super) fn typed(x: f64, float: Float) -> TokenStream {
    let text = format!("{}_{}", digits(x.abs(), float), float.word());
    let literal = text.parse::<Literal>().unwrap_or_else(|_| Literal::f64_suffixed(x.abs()));
    if x.is_sign_negative() { quote!((-#literal)) } else { quote!(#literal) }
}

/// The shortest decimal, with an exponent where that is shorter.
pub(super) fn digits(x: f64, float: Float) -> String {
    match float {
        Float::F64 => format!("{x:?}"),
        Float::F32 => format!("{:?}", x as f32),
    }
}
