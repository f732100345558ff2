//! The long runs: `cargo run --release -p pendula-stress -- SUITE`.

use std::process::ExitCode;
use std::time::Instant;

use pendula_stress::options::{Options, Suite, USAGE};
use pendula_stress::report::{Row, count, table};
use pendula_stress::section;
use pendula_stress::session::Session;
use pendula_stress::{amplitudes, coefficients, exhaustive, times};

fn main() -> ExitCode {
    let options = match Options::parse(std::env::args().skip(1)) {
        Ok(options) => options,
        Err(message) => {
            eprintln!("{message}\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    match run(&options) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

/// Whether every promise was kept.
fn run(options: &Options) -> Result<bool, Box<dyn std::error::Error>> {
    let session = Session::interactive(options.threads)?;
    let begin = Instant::now();
    let rows = match options.suite {
        Suite::Exhaustive => exhaustive::run(&session, 1),
        Suite::Times => times::run(&session, options.inputs, options.only.as_deref()),
        Suite::Amplitudes => amplitudes::run(&session, options.inputs),
        Suite::Coefficients => coefficients::run(&session, options.inputs),
    };
    let text = summary(options, &session, &rows, begin.elapsed().as_secs());
    println!("{text}");
    for objection in rows.iter().flat_map(Row::objections) {
        eprintln!("BROKEN: {objection}");
    }
    if let Some((date, path)) = &options.record {
        let command = format!("{date}, `{}`:\n\n", options.command());
        section::renew(path, options.suite.name(), &format!("{command}{text}"))?;
    }
    Ok(rows.iter().all(Row::kept))
}

fn summary(options: &Options, session: &Session, rows: &[Row], seconds: u64) -> String {
    let tried = count(rows.iter().map(|row| row.found.tried).sum());
    let stopped = if session.stopped() { ", stopped before the end" } else { "" };
    let threads = options.threads;
    format!("{}\n{tried} inputs in {seconds} s on {threads} threads{stopped}.\n", table(rows))
}
