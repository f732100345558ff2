//! Run time against error, and error against time elapsed; see `docs/BENCHMARKS.md`.
//!
//! `cargo bench --bench pareto` measures for some minutes and writes to `target/benchmarks/`; `-- --quick` takes less
//! than one; `-- --bless` writes to `docs/benchmarks/` and renews the tables of the frontier and of the targets in
//! `docs/BENCHMARKS.md`.

use std::error::Error;
use std::fs;
use std::io::{IsTerminal, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use pendula_benches::amplitude::Amplitude;
use pendula_benches::contestant::Contestant;
use pendula_benches::drift::{self, Drift};
use pendula_benches::ours::{Planned, ours};
use pendula_benches::peers::{self, Precision, peers};
use pendula_benches::race::Effort;
use pendula_benches::session::{Field, Outcome, Session};
use pendula_benches::{figures, machine, report, targets};
use pendula_plot::Figure;
use pendula_stress::section;

/// Steps of the time stepping in the picture of the drift: 10⁵ periods at T/100.
const STEPS: usize = 10_100_000;
/// Under `--quick`.
const QUICK_STEPS: usize = 102_000;

struct Options {
    effort: Effort,
    steps: usize,
    directory: PathBuf,
    /// The document whose table of the frontier is renewed.
    document: Option<PathBuf>,
}

fn options() -> Result<Options, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut options =
        Options { effort: Effort::FULL, steps: STEPS, directory: root.join("target/benchmarks"), document: None };
    let (mut quick, mut bless) = (false, false);
    for argument in std::env::args().skip(1) {
        match argument.as_str() {
            "--quick" => quick = true,
            "--bless" => bless = true,
            // What cargo says to every bench.
            "--bench" => {}
            other => return Err(format!("unknown argument `{other}`; there are --quick and --bless")),
        }
    }
    if quick && bless {
        return Err("--bless records results, which takes a full run: leave --quick out".into());
    }
    if bless {
        options.directory = root.join("docs/benchmarks");
        options.document = Some(root.join("docs/BENCHMARKS.md"));
    }
    if quick {
        (options.effort, options.steps) = (Effort::QUICK, QUICK_STEPS);
    }
    Ok(options)
}

fn main() -> ExitCode {
    if !std::env::args().any(|argument| argument == "--bench") {
        // `cargo test` with all targets: that it builds is what can be tested in a build without optimisation.
        println!("measures under `cargo bench --bench pareto` only");
        return ExitCode::SUCCESS;
    }
    let run = || -> Result<(), Box<dyn Error>> { measure(&options()?) };
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("pareto: {why}");
            ExitCode::FAILURE
        }
    }
}

fn measure(options: &Options) -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    for peer in peers::missing() {
        println!("missing: {}: {}", peer.name, peer.why);
    }
    let session = Session {
        doubles: Amplitude::ALL.map(|amplitude| Field::new(amplitude, everyone(amplitude))).into(),
        singles: Amplitude::ALL.map(|amplitude| Field::new(amplitude, everyone(amplitude))).into(),
    };
    let outcomes = session.run(options.effort, |what| progress(start, what));
    progress(start, "drift");
    let drifts = drift::measure(Amplitude::LARGE, &everyone::<f64>(Amplitude::LARGE), options.steps);
    progress(start, "done");
    eprintln!();
    write(&options.directory, &outcomes, &drifts)?;
    if let Some(document) = &options.document {
        let target = machine::target();
        section::renew(document, &format!("frontier {target}"), &report::summary(&outcomes))?;
        section::renew(document, &format!("targets {target}"), &targets::table(&outcomes))?;
    }
    print!("{}", report::markdown(&outcomes, &peers::missing(), &peers::versions()));
    println!("## Targets of cost, at 7π/8\n\n{}", targets::table(&outcomes));
    println!("written to {} after {:.0} s", options.directory.display(), start.elapsed().as_secs_f64());
    Ok(())
}

/// Ours and theirs.
fn everyone<R: Precision + Planned>(amplitude: Amplitude) -> Vec<Contestant<R>> {
    let mut all = ours(amplitude);
    all.extend(peers(amplitude));
    all
}

/// Rewrites one line on a terminal, and keeps quiet elsewhere.
fn progress(start: Instant, what: &str) {
    if std::io::stderr().is_terminal() {
        eprint!("\r{:4.0} s  {what:<30}", start.elapsed().as_secs_f64());
        let _ = std::io::stderr().flush();
    }
}

fn write(directory: &Path, outcomes: &[Outcome], drifts: &[Drift]) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(directory)?;
    let target = machine::target();
    let markdown = report::markdown(outcomes, &peers::missing(), &peers::versions());
    fs::write(directory.join(format!("pareto-{target}.md")), markdown)?;
    fs::write(directory.join(format!("pareto-{target}.csv")), report::csv(outcomes))?;
    fs::write(directory.join("drift.csv"), drift::csv(drifts))?;
    for amplitude in Amplitude::ALL {
        for precision in ["f64", "f32"] {
            let figure = figures::pareto(outcomes, amplitude, precision);
            let stem = directory.join(format!("pareto-{target}-{}-{precision}", amplitude.slug));
            if (amplitude, precision) == (Amplitude::LARGE, "f64") {
                figure.save(&stem)?;
            } else {
                figure.save_svg(&stem)?;
            }
        }
    }
    figures::drift(drifts, Amplitude::LARGE).save(&directory.join("drift"))?;
    Ok(())
}
