//! How long an expansion takes where it takes longest, in an unoptimised build. `.ci/expansion-time` runs
//! `expansion_time`, on request with another name as its argument.

use crate::expand;
use proc_macro2::TokenStream;
use std::time::{Duration, Instant};

const INVOCATIONS: &str = include_str!("../tests/data/invocations.txt");

/// Of three expansions the fastest: other work on the machine only adds.
fn time(invocation: &str) -> Duration {
    let root = quote::quote!(::pendula);
    let once = || {
        let parameters: TokenStream = invocation.parse().unwrap();
        let start = Instant::now();
        let expansion = expand(&root, parameters);
        let elapsed = start.elapsed();
        assert!(!expansion.to_string().contains("compile_error"), "{invocation}");
        elapsed
    };
    (0..3).map(|_| once()).min().unwrap()
}

/// Prints the median, nine tenths and the longest, and gives the median.
fn summary<'a>(invocations: impl Iterator<Item = &'a str>) -> Duration {
    let mut times: Vec<(Duration, &str)> = invocations.map(|invocation| (time(invocation), invocation)).collect();
    times.sort();
    let [median, most, (longest, which)] =
        [times.len() / 2, times.len() * 9 / 10, times.len() - 1].map(|index| times[index]);
    let (median, most, count) = (median.0, most.0, times.len());
    println!(
        "expansion time: of {count} invocations median {median:.1?}, 90 % within {most:.1?}, longest {longest:.1?}"
    );
    println!("longest: {which}");
    median
}

#[test]
#[ignore = "times are for an idle machine"]
fn expansion_time() {
    assert!(summary(INVOCATIONS.lines()) <= Duration::from_millis(30));
}

/// Many outputs at once, near the top, and tolerances that are hardly reached take longest.
#[test]
#[ignore = "takes a minute"]
fn over_a_grid() {
    const OUTPUTS: [&str; 6] =
        ["theta", "velocity", "acceleration", "position", "theta, velocity", "theta, velocity, acceleration, position"];
    const GOALS: [&str; 8] = [
        "float = f64",
        "float = f32",
        "tol = 1e-3, float = f64",
        "tol = 1e-3, float = f32",
        "tol = 1e-6, float = f64",
        "tol = 1e-6, float = f32",
        "tol = 1e-9, float = f64",
        "tol = 1e-12, float = f64",
    ];
    let mut invocations = Vec::new();
    for amplitude in ["1e-9", "0.001", "1", "7π/8", "0.95π", "0.999π", "π - 1e-6", "π - 1e-9", "π - 1e-20"] {
        for goal in GOALS {
            for (horizon, outputs) in ["", "t_max = 600,"].iter().flat_map(|horizon| OUTPUTS.map(|o| (horizon, o))) {
                invocations
                    .push(format!("struct Motion; theta0 = {amplitude}, {goal}, {horizon} outputs = [{outputs}]"));
            }
        }
    }
    summary(invocations.iter().map(String::as_str));
}
