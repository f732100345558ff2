//! Tries to break each promise of `pendula`.
//!
//! `cargo run --release -p pendula-stress -- exhaustive` (or `times`, `amplitudes`, `coefficients`) runs one of the
//! suites and prints what it found; `docs/ACCURACY.md` has the latest results. The tests `tests/stress_*.rs` of the
//! workspace run the same code on fewer inputs.
#![forbid(unsafe_code)]

pub mod amplitudes;
pub mod big;
pub mod coefficients;
pub mod exhaustive;
pub mod finding;
pub mod generated;
pub mod motion;
pub mod options;
pub mod pair;
pub mod promised;
pub mod random;
pub mod reference;
pub mod report;
pub mod section;
pub mod session;
pub mod times;
pub mod truth;
