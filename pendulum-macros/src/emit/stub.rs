//! What a refused request still expands to, so that one mistake is one error.

use super::constants::OF_MOTION;
use super::outputs::Wording;
use super::{allowed, conditions};
use crate::parse::{Float, Item, Keyword, Output, Shape};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The errors, and an item of the shape that was asked for.
pub(crate) fn stub(shape: Option<(Shape, Float)>, errors: &[TokenStream]) -> TokenStream {
    match shape {
        Some((Shape::Item(item), float)) => structure(&item, float, errors),
        Some((Shape::Expression, _)) | None => anywhere(errors),
    }
}

/// All errors as one macro call, which is an item as well as an expression: a request without `struct` may stand in
/// either position. `concat!` expands its arguments first, and then is as silent as they are in error, of any type.
fn anywhere(errors: &[TokenStream]) -> TokenStream {
    match errors {
        [error] => error.clone(),
        errors => quote!(::core::concat! { #(#errors),* }),
    }
}

fn structure(item: &Item, float: Float, errors: &[TokenStream]) -> TokenStream {
    let Item { attributes, visibility, name } = item;
    let of_outputs = Output::ALL.iter().map(|&output| Wording::of(output).max_error);
    let constants = OF_MOTION.into_iter().chain(of_outputs).map(|name| format_ident!("{name}"));
    let scalars = Output::ALL.iter().filter(|&&output| output != Output::Position);
    let functions = scalars.map(|output| format_ident!("{}", output.word()));
    let allowed = allowed();
    let conditions = conditions(attributes);
    quote! {
        #(#errors)*
        #(#attributes)*
        #[doc = ""]
        #visibility struct #name;

        #(#conditions)*
        #allowed
        #[allow(missing_docs)]
        impl #name {
            #(pub const #constants: #float = 0.0;)*
            pub const METHOD: &'static str = "";
            pub const TERMS: usize = 0;
            pub const OPERATIONS: usize = 0;
            pub const COEFFICIENTS: [#float; 0] = [];
            #(pub const fn #functions(_t: #float) -> #float { 0.0 })*
            pub const fn position(_t: #float) -> (#float, #float) { (0.0, 0.0) }
            pub const fn state(_t: #float) -> (#float, #float) { (0.0, 0.0) }
        }
    }
}
