//! How long an expansion takes where it takes longest, in an unoptimised build. `.ci/expansion-time` runs it.

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

#[test]
#[ignore = "times are for an idle machine"]
fn expansion_time() {
    let mut times: Vec<Duration> = INVOCATIONS.lines().map(time).collect();
    times.sort();
    let (median, longest) = (times[times.len() / 2], times[times.len() - 1]);
    println!("expansion time: median of {} invocations {median:.1?}, longest {longest:.1?}", times.len());
    assert!(median <= Duration::from_millis(30));
}
