//! The results of F. M. S. Lima, *Simple but accurate periodic solutions for the nonlinear pendulum equation*
//! (Rev. Bras. Ens. Fís., 2019), from code generated at compile time: the constants, the table of errors, what does not
//! hold, what the paper argues against, and its figures.
//!
//! `cargo run --release --example paper` prints them and writes the figures to `target/paper/`; with `-- --bless` they
//! go to `docs/images/`, where the documentation takes them from.

// The angles are written as in the paper, with a Greek letter that a Latin identifier could be mistaken for.
#![allow(mixed_script_confusables)]

mod approximation;
mod constants;
mod figures;
mod refuted;
mod rivals;
mod table;

use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    constants::print();
    table::print()?;
    refuted::print()?;
    rivals::print()?;
    let bless = std::env::args().any(|argument| argument == "--bless");
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join(if bless { "docs/images" } else { "target/paper" });
    figures::write(&directory)
}
