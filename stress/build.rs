//! Writes a few hundred invocations of `pendulum!`: a logarithmic grid of amplitudes, down to 3e-300 and up to
//! π − 1e-9, and at each of them plans of several tolerances, horizons, types and outputs.

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// Type, output and the rest of the invocation, for every amplitude that the type can hold.
const SCENES: [(&str, &str, &str); 10] = [
    ("f64", "theta", ""),
    ("f64", "velocity", ""),
    ("f64", "theta", "tol = 1e-3, t_max = 100"),
    ("f64", "theta", "tol = 1e-6, t_max = 1000"),
    ("f64", "theta", "tol = 1e-9"),
    ("f64", "theta", "tol = 1e-12, t_max = 100"),
    ("f64", "position", "tol = 1e-6, t_max = 100"),
    ("f64", "acceleration", "tol = 1e-6"),
    ("f32", "theta", ""),
    ("f32", "theta", "tol = 1e-4, t_max = 100"),
];

/// Release angles as they are written, from the bottom to the top, and numbers of terms that the paper's formula can
/// use.
fn amplitudes() -> Vec<(String, u32)> {
    let small = [300, 200, 100, 50, 20, 15, 12, 9, 7, 6, 5, 4, 3, 2].map(|power| (format!("3e-{power}"), 1));
    let fractions = [5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70, 75, 80, 85, 88, 90, 92, 94, 96, 97, 98, 99];
    let terms = |hundredths| match hundredths {
        0..30 => 2,
        30..92 => 4,
        92..97 => 6,
        _ => 10,
    };
    let large = fractions.map(|hundredths| (format!("0.{hundredths:02}π"), terms(hundredths)));
    let near = ["3e-2", "1e-2", "3e-3", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9"];
    let near = near.map(|rest| (format!("1π-{rest}"), if rest == "3e-2" { 12 } else { 0 }));
    small.into_iter().chain(large).chain(near).collect()
}

/// Up to 3e-7: of squares that a tolerance in single precision needn't bother with.
fn is_tiny(amplitude: &str) -> bool {
    amplitude.parse::<f64>().is_ok_and(|amplitude| amplitude <= 3e-7)
}

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let mut text = String::new();
    for (i, (amplitude, terms)) in amplitudes().into_iter().enumerate() {
        let mut invoke = |name: String, float: &str, output: &str, asked: &str| {
            let comma = if asked.is_empty() { "" } else { "," };
            let _ = writeln!(
                text,
                "generated!(all, {name}, {amplitude:?}, ({amplitude}), {float}, {output}, {{{asked}{comma}}});"
            );
        };
        for (j, (float, output, asked)) in SCENES.into_iter().enumerate() {
            if float == "f64" || !is_tiny(&amplitude) {
                invoke(format!("Plan{i}x{j}"), float, output, asked);
            }
        }
        if terms > 0 {
            invoke(format!("Paper{i}"), "f64", "theta", &format!("n = {terms}"));
        }
    }
    let directory = env::var("OUT_DIR").expect("Cargo sets it");
    let body = format!("{{\nlet mut all = Vec::new();\n{text}all\n}}\n");
    fs::write(Path::new(&directory).join("plans.rs"), body).expect("the output directory can be written");
}
