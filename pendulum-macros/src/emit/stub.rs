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
    /// The number of coefficients, if it is known.
    terms: Option<usize>,
}

/// More coefficients than anyone asks for but by mistake.
const MOST_TERMS: usize = 1000;

impl Stub {
    pub(crate) fn new(request: &Request) -> Self {
        let terms = request.n.as_ref().map(|given| given.value).filter(|&n| n <= MOST_TERMS);
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

/// What the stub doesn't know is of one constant, which has the errors in it: of what depends on that the compiler says
/// nothing more, whether it is a condition, an index or the end of a loop.
fn structure(
    item: &Item,
    float: Float,
    terms: Option<usize>,
    scene: Option<&Scene>,
    errors: &[TokenStream],
) -> TokenStream {
    let Item { attributes, visibility, name } = item;
    let known: Vec<(&str, TokenStream)> = scene.map_or(Vec::new(), constants::of_motion);
    let of_outputs = Output::ALL.iter().map(|&output| Wording::of(output).max_error);
    let others = constants::OF_MOTION.into_iter().filter(|name| !known.iter().any(|(known, _)| known == name));
    let unknown = others.chain(of_outputs).map(|name| format_ident!("{name}"));
    let known = known.iter().map(|(_, constant)| constant);
    let scalars = Output::ALL.iter().filter(|&&output| output != Output::Position);
    let functions = scalars.map(|output| format_ident!("{}", output.word()));
    let terms = terms.map_or_else(|| quote!({ Self::REFUSED as usize }), |terms| quote!(#terms));
    let allowed = allowed(attributes);
    let conditions = conditions(attributes);
    quote! {
        #(#attributes)*
        #[doc = ""]
        #visibility struct #name;

        #(#conditions)*
        #allowed
        impl #name {
            const REFUSED: #float = { #(#errors)* 1.0 };
            #(#known)*
            #(pub const #unknown: #float = Self::REFUSED;)*
            pub const METHOD: &'static str = { let _ = Self::REFUSED; "" };
            pub const TERMS: usize = Self::REFUSED as usize;
            pub const OPERATIONS: usize = Self::REFUSED as usize;
            pub const COEFFICIENTS: [#float; #terms] = [Self::REFUSED; #terms];
            #(pub const fn #functions(_t: #float) -> #float { Self::REFUSED })*
            pub const fn position(_t: #float) -> (#float, #float) { (Self::REFUSED, Self::REFUSED) }
            pub const fn state(_t: #float) -> (#float, #float) { (Self::REFUSED, Self::REFUSED) }
        }
    }
}
