//! Formatted expansions of a few invocations, committed, so that a change of the generated code is seen and reviewed.
//!
//! `PENDULA_BLESS=1 cargo test -p pendulum-macros snapshots` writes them anew; read the difference before you commit it.

use crate::expand;
use proc_macro2::TokenStream;
use quote::quote;

/// The expansion as rustfmt would have it. An expression becomes the body of a function.
fn formatted(invocation: &str) -> String {
    let tokens = expand(&quote!(::pendula), invocation.parse::<TokenStream>().unwrap());
    let is_item = invocation.contains("struct");
    let tokens = if is_item { tokens } else { quote!(fn expression() -> impl Copy #tokens) };
    let code = prettyplease::unparse(&syn::parse2(tokens).unwrap());
    let invocation: Vec<String> = invocation.lines().map(|line| format!("//     {}", line.trim())).collect();
    format!("// What this expands to; written by src/snapshots.rs.\n//\n{}\n\n{code}", invocation.join("\n"))
}

fn compare(name: &str, invocation: &str) {
    let path = format!("{}/tests/expansions/{name}.rs", env!("CARGO_MANIFEST_DIR"));
    let expansion = formatted(invocation);
    if std::env::var_os("PENDULA_BLESS").is_some() {
        std::fs::write(&path, &expansion).unwrap();
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    let differs = expansion.lines().zip(committed.lines()).find(|(new, old)| new != old);
    assert!(
        expansion == committed,
        "{path} differs, first here (new, committed): {differs:#?}\nif that was meant, bless it: see src/snapshots.rs"
    );
}

macro_rules! snapshots {
    ($($name:ident: $invocation:literal)*) => {$(
        #[test]
        fn $name() {
            compare(stringify!($name), $invocation);
        }
    )*};
}

snapshots! {
    paper_expression: "theta0 = 7π/8, n = 4"
    clock: "/// The clock on the wall.
            pub struct Clock;
            theta0 = 157.5deg, g = 9.81, length = 0.994, tol = 1e-9, t_max = 86_400, outputs = [theta, velocity]"
    game: "pub(crate) struct Lamp;
           theta0 = 2, float = f32, tol = 1e-4, t_max = 1000, outputs = [theta, position]"
    any_time: "pub struct Forever;
               theta0 = 1π/2"
    launched: "struct Pushed;
               theta0 = 1, velocity0 = -1/2, omega = 3, tol = 1e-6, outputs = [theta, acceleration]"
    mistake: "pub struct Wrong;
              theta0 = 4, n = 0"
}
