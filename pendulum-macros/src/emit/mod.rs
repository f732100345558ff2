//! [`Plan`] → tokens. Nothing here can fail.

pub(crate) mod constants;
mod docs;
mod literal;
mod outputs;
mod program;
mod stub;

pub(crate) use stub::Stub;

use crate::parse::{Item, Shape};
use crate::plan::{Function, Plan};
use crate::scene::Scene;
use proc_macro2::{TokenStream, TokenTree};
use quote::{ToTokens as _, format_ident, quote};
use syn::parse::ParseStream;
use syn::punctuated::Punctuated;
use syn::{Attribute, Meta, Token};

/// The expansion: an expression that is a fn item, or a unit struct with its constants and functions. `root` is the
/// path of the crate `pendula`, as its user knows it.
pub(crate) fn emit(scene: &Scene, plan: &Plan, root: &TokenStream) -> TokenStream {
    match &scene.shape {
        Shape::Expression => expression(scene, plan, root),
        Shape::Item(item) => structure(scene, plan, item, root),
    }
}

/// Clippy's lints that look into what macros generate and that arithmetic can't heed; and that a deprecated struct is used
/// here. No more: a crate that forbids a lint takes no code that allows it.
fn allowed(attributes: &[Attribute]) -> TokenStream {
    let is_deprecated = attributes.iter().any(|attribute| named(&attribute.meta, "deprecated").is_some());
    let deprecated = is_deprecated.then(|| quote!(deprecated,));
    quote!(#[allow(#deprecated clippy::approx_constant, clippy::float_arithmetic, clippy::neg_multiply)])
}

fn expression(scene: &Scene, plan: &Plan, root: &TokenStream) -> TokenStream {
    let functions = plan.functions.iter().take(1).map(|function| self::function(scene, function, root));
    let name = plan.functions.first().map(|function| format_ident!("{}", function.name()));
    let docs = docs::motion(scene, plan);
    let allowed = allowed(&[]);
    quote!({
        #(#[doc = #docs])*
        #allowed
        #[inline(always)]
        #(#functions)*
        #name
    })
}

fn structure(scene: &Scene, plan: &Plan, item: &Item, root: &TokenStream) -> TokenStream {
    let Item { attributes, visibility, name } = item;
    let docs = docs::motion(scene, plan);
    let constants = constants::all(scene, plan);
    let functions = plan.functions.iter().map(|function| {
        let function = self::function(scene, function, root);
        quote!(pub #function)
    });
    let doc_lines = plan.functions.iter().map(docs::function);
    let allowed = allowed(attributes);
    let conditions = conditions(attributes);
    quote! {
        #(#attributes)*
        #(#[doc = #docs])*
        #visibility struct #name;

        #(#conditions)*
        #allowed
        impl #name {
            #constants
            #(
                #[doc = #doc_lines]
                #[inline(always)]
                #[must_use]
                #functions
            )*
        }
    }
}

/// The conditions of the struct, which its `impl` has to share.
fn conditions(attributes: &[Attribute]) -> impl Iterator<Item = TokenStream> {
    attributes.iter().filter_map(|attribute| named(&attribute.meta, "cfg")).map(|condition| quote!(#[#condition]))
}

/// An attribute of that name, such as `cfg(…)`, or what remains of `cfg_attr(…, cfg(…), …)`.
fn named(meta: &Meta, name: &str) -> Option<TokenStream> {
    if meta.path().is_ident(name) {
        return Some(meta.to_token_stream());
    }
    let list = meta.require_list().ok().filter(|list| list.path.is_ident("cfg_attr"))?;
    list.parse_args_with(|input: ParseStream| named_in_cfg_attr(input, name)).ok().flatten()
}

fn named_in_cfg_attr(input: ParseStream, name: &str) -> syn::Result<Option<TokenStream>> {
    let mut predicate = TokenStream::new();
    while !input.peek(Token![,]) {
        predicate.extend([input.parse::<TokenTree>()?]);
    }
    input.parse::<Token![,]>()?;
    let all = Punctuated::<Meta, Token![,]>::parse_terminated(input)?;
    let of_name: Vec<_> = all.iter().filter_map(|meta| named(meta, name)).collect();
    Ok((!of_name.is_empty()).then(|| quote!(cfg_attr(#predicate, #(#of_name),*))))
}

/// `const fn name(t: f64) -> f64 { … }`, to be inlined wherever it is called: only then do loops over it vectorise, and
/// the compiler by itself doesn't inline so long a function into more than one of them.
fn function(scene: &Scene, function: &Function, root: &TokenStream) -> TokenStream {
    let float = scene.float;
    let name = format_ident!("{}", function.name());
    let result = match function.program.results.len() {
        1 => quote!(#float),
        results => {
            let floats = vec![float; results];
            quote!((#(#floats),*))
        }
    };
    let body = program::body(&function.program, &quote!(#root::__private::support));
    quote!(const fn #name(t: #float) -> #result { #body })
}
