//! Formatted expansions of a few invocations, committed, so that a change of the generated code is seen and reviewed.
//!
//! `PENDULA_BLESS=1 cargo test -p pendulum-macros snapshots` writes them anew; read the difference before you commit
//! it.

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
    let expansion = formatted(invocation);
    assert_eq!(expansion.contains("compile_error!"), name == "mistake", "{name}: {expansion}");
    compare_with(&format!("expansions/{name}.rs"), &expansion);
}

fn compare_with(file: &str, expansion: &str) {
    let path = format!("{}/tests/{file}", env!("CARGO_MANIFEST_DIR"));
    if std::env::var_os("PENDULA_BLESS").is_some() {
        std::fs::write(&path, expansion).unwrap();
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
    separatrix: "pub struct Over;
                 velocity0 = 2, tol = 1e-3, float = f32"
    rotation: "#[cfg_attr(all(), doc = \"Over the top.\")]
               pub struct Loop;
               velocity0 = 2.5, tol = 1e-6, t_max = 1000, outputs = [theta, wrapped]"
    arc: "struct Instant;
          theta0 = 1, tol = 1e-9, t_max = 1, outputs = [theta, velocity]"
    mistake: "pub struct Wrong;
              theta0 = 4, n = 0"
}

/// Scenes of every regime, method and kernel, and of nearly every form and reduction: what is chosen, and what the
/// others would have cost.
const SCENES: [&str; 37] = [
    "theta0 = 1e-3",
    "theta0 = 1, tol = 1e-3, t_max = 10",
    "theta0 = 1, tol = 1e-6, t_max = 1e3",
    "theta0 = 7π/8, tol = 1e-9, t_max = 1e6",
    "theta0 = 7π/8, tol = 1e-9, t_max = 1e6, outputs = [velocity]",
    "theta0 = 7π/8, tol = 1e-9, t_max = 1e6, outputs = [acceleration]",
    "theta0 = 7π/8, tol = 1e-9, t_max = 1e6, outputs = [position]",
    "theta0 = 7π/8, t_max = 1e6, outputs = [theta, velocity]",
    "theta0 = 0.99π, tol = 1e-6, float = f32",
    "theta0 = 0.999π, tol = 1e-12",
    "theta0 = π - 1e-6, tol = 1e-5, outputs = [position, velocity]",
    "theta0 = 1, velocity0 = -1, tol = 1e-14, t_max = 1e3",
    "velocity0 = 2, tol = 1e-9, outputs = [theta, acceleration]",
    "velocity0 = 2.001, tol = 1e-9, t_max = 1e4",
    "velocity0 = 3, tol = 1e-5, t_max = 1e3, float = f32, outputs = [wrapped]",
    "velocity0 = -5, tol = 1e-10, t_max = 1e4, outputs = [theta, velocity]",
    "velocity0 = 3, outputs = [position]",
    "theta0 = 2, n = 2",
    "theta0 = 0.9π, n = 4, outputs = [theta, velocity]",
    "theta0 = 2, method = fourier, tol = 1e-6",
    "theta0 = 2, method = series, tol = 1e-6, outputs = [theta, velocity]",
    "theta0 = 0.1, method = harmonic, tol = 1e-3",
    "theta0 = 0.1, method = small_angle, t_max = 10",
    "theta0 = 2, method = polynomial, tol = 1e-4, t_max = 1e3",
    "theta0 = 1, t_max = 1",
    "theta0 = 7π/8, tol = 1e-9, t_max = 1, outputs = [theta, velocity, position]",
    "velocity0 = 2, t_max = 1",
    "theta0 = π - 1e-9",
    "theta0 = π - 1e-9, method = polynomial",
    "theta0 = π - 1e-9, method = polynomial, outputs = [position]",
    "theta0 = 0.954π, n = 4",
    "theta0 = 7π/8, float = f32, t_max = 1e5",
    "theta0 = 7π/8, float = f32, tol = 1e-6",
    "theta0 = 1, velocity0 = 0.5",
    "theta0 = 1, velocity0 = 0.5, outputs = [velocity]",
    "theta0 = 7π/8, t_max = 1e4",
    "velocity0 = 2.1, t_max = 1e9",
];

/// The plan of a scene, but for its constants.
fn outline(text: &str) -> String {
    let scene = crate::testing::scene(&format!("struct Motion; {text}"));
    let plan = crate::plan::plan(&scene).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
    let (operations, reduction) = (plan.operations(), plan.reduction.describe());
    let mut lines = vec![format!("{text}\n  {}: {operations} operations, phase by {reduction}", plan.method)];
    for part in &plan.parts {
        let (word, bound) = (part.output.word(), part.bound);
        let [truncation, phase, evaluation] = [bound.truncation, bound.phase, bound.evaluation];
        lines.push(format!("  {word}: {}", part.description));
        lines.push(format!("    wrong by {truncation:.1e} + {phase:.1e} + {evaluation:.1e}"));
    }
    lines.extend(plan.rejected.iter().map(|reason| format!("  not {reason}")));
    lines.join("\n")
}

#[test]
fn plans() {
    let outlines: Vec<String> = SCENES.iter().map(|text| outline(text)).collect();
    compare_with("plans.txt", &(outlines.join("\n\n") + "\n"));
}
