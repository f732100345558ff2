//! The procedural macro behind `pendula::pendulum!`: *parse → check and solve → plan → emit*.
//!
//! Depend on `pendula`, not on this crate: the macro is documented there, and its expansion names items through the
//! path that `pendula` hands in.
#![forbid(unsafe_code)]
#![cfg_attr(test, allow(clippy::disallowed_methods))] // what a test compares with may depend on the host

mod chebyshev;
mod check;
mod decimals;
mod emit;
mod exact;
#[cfg(test)]
mod expansion_time;
#[cfg(test)]
mod fuzz;
mod motion;
mod parse;
mod plan;
mod power;
mod program;
mod report;
mod scene;
mod series;
#[cfg(test)]
mod snapshots;
mod supremum;
#[cfg(test)]
mod testing;

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use report::Report;

/// `[path of pendula] parameters…`; see `pendula::pendulum!`.
#[proc_macro]
pub fn pendulum(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let (root, parameters) = split_root(input.into());
    expand(&root, parameters).into()
}

/// The crate's path, in brackets, and what follows it.
fn split_root(input: TokenStream) -> (TokenStream, TokenStream) {
    let mut trees = input.into_iter();
    match trees.next() {
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Bracket => (group.stream(), trees.collect()),
        first => (quote::quote!(::pendula), first.into_iter().chain(trees).collect()),
    }
}

fn expand(root: &TokenStream, parameters: TokenStream) -> TokenStream {
    let mut report = Report::default();
    let request = parse::parse(parameters, &mut report);
    let stub = request.as_ref().map(emit::Stub::new);
    let scene = request.and_then(|request| check::check(request, &mut report));
    let plan =
        scene.as_ref().and_then(|scene| report.take(plan::plan(scene).map_err(|refusal| refusal.explain(scene))));
    match (scene, plan) {
        (Some(scene), Some(plan)) if report.is_clean() => emit::emit(&scene, &plan, root),
        (scene, _) => emit::Stub::emit(stub, scene.as_ref(), &errors(report)),
    }
}

/// Every mistake as a `compile_error!`.
fn errors(report: Report) -> Vec<TokenStream> {
    let mistakes = report.finish().err().into_iter().flatten();
    mistakes.map(|mistake| report::compile_error(&mistake)).collect()
}
