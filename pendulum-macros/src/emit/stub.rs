//! What a refused request still expands to, so that one mistake is one error.

use super::outputs::Wording;
use super::{allowed, conditions, constants};
use crate::parse::{Float, Item, Keyword, Output, Request, Shape};
use crate::scene::Scene;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// What is known of the item that was asked for, whatever is wrong with the rest.
pub(crate) struct Stub {
    shape: Shape,
    float: Float,
    /// The number of coefficients.
    terms: usize,
}

/// So many coefficients as others index where `n` isn't known, or more than anyone asks for but by mistake.
const UNKNOWN_TERMS: usize = 64;
const MOST_TERMS: usize = 1000;

impl Stub {
    pub(crate) fn new(request: &Request) -> Self {
        let terms = request.n.as_ref().map_or(UNKNOWN_TERMS, |given| given.value).clamp(1, MOST_TERMS);
        Self { shape: request.shape.clone(), float: request.float_meant(), terms }
    }

    /// The errors, and an item of the shape that was asked for, of whose motion the constants may be known.
    pub(crate) fn emit(stub: Option<Self>, scene: Option<&Scene>, errors: &[TokenStream]) -> TokenStream {
        match stub {
            Some(Self { shape: Shape::Item(item), float, terms }) => structure(&item, float, terms, scene, errors),
            Some(Self { shape: Shape::Expression, .. }) | None => anywhere(errors),
        }
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

fn structure(item: &Item, float: Float, terms: usize, scene: Option<&Scene>, errors: &[TokenStream]) -> TokenStream {
    let Item { attributes, visibility, name } = item;
    let known: Vec<(&str, TokenStream)> = scene.map_or(Vec::new(), constants::of_motion);
    let of_outputs = Output::ALL.iter().map(|&output| Wording::of(output).max_error);
    let others = constants::OF_MOTION.into_iter().filter(|name| !known.iter().any(|(known, _)| known == name));
    let ident = |name| format_ident!("{name}");
    // Other constants' conditions on these, at compile time, mostly want the motion's above 0 and the bounds small.
    let (positive, zero) = (others.map(ident), of_outputs.map(ident));
    let known = known.iter().map(|(_, constant)| constant);
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
            #(#known)*
            #(pub const #positive: #float = 1.0;)*
            #(pub const #zero: #float = 0.0;)*
            pub const METHOD: &'static str = "";
            pub const TERMS: usize = 1;
            pub const OPERATIONS: usize = 1;
            pub const COEFFICIENTS: [#float; #terms] = [0.0; #terms];
            #(pub const fn #functions(_t: #float) -> #float { 0.0 })*
            pub const fn position(_t: #float) -> (#float, #float) { (0.0, 0.0) }
            pub const fn state(_t: #float) -> (#float, #float) { (0.0, 0.0) }
        }
    }
}
