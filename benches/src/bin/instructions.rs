//! Instructions per value of our plans, counted by callgrind: a regression gate that noise cannot trip.
//!
//! `cargo run --release -p pendula-benches --bin instructions -- --check` fails where a count has risen by more than 3
//! % above the record in `benches/instructions/`, and `-- --bless` writes the record. Each count is the difference of
//! two runs, of 3 passes and of 1 over 4096 values, so that start-up cancels. Without valgrind, and where the record is of
//! another compiler, it says so and succeeds.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::{env, fs};

use pendula_benches::amplitude::Amplitude;
use pendula_benches::contestant::{COUNT, Contestant};
use pendula_benches::machine;
use pendula_benches::ours::ours;
use pendula_benches::real::Real;
use pendula_benches::session::{Field, JOBS};

/// A rise by more than this part fails.
const TOLERATED: f64 = 0.03;
/// Of the jobs of a field those that are counted: the others run the same instructions.
const COUNTED: [&str; 2] = ["array", "single"];

type Failure = Box<dyn Error>;

/// Instructions per value, by what is counted.
type Counts = BTreeMap<String, f64>;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let done = match arguments[..] {
        ["--check"] => check(),
        ["--bless"] => bless(),
        ["--pass", what, passes] => pass(what, passes),
        _ => Err("usage: instructions --check | --bless".into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("instructions: {why}");
            ExitCode::FAILURE
        }
    }
}

/// One record per instruction set that the code may be compiled for.
fn record() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("instructions/{}.csv", machine::target()))
}

fn check() -> Result<(), Failure> {
    let Some(text) = fs::read_to_string(record()).ok().filter(|text| text.contains(machine::rustc())) else {
        println!("nothing is compared: there is no record for {} by {}", machine::target(), machine::rustc());
        return Ok(());
    };
    let Some(counts) = count()? else { return Ok(()) };
    let recorded = parse(&text)?;
    let mut risen = 0;
    for (what, &now) in &counts {
        match recorded.get(what) {
            None => {
                println!("{what}: {now:.2}, not in the record");
                risen += 1;
            }
            Some(&then) if now > then * (1.0 + TOLERATED) => {
                println!("{what}: {then:.2} -> {now:.2}, {:+.1} %", 100.0 * (now / then - 1.0));
                risen += 1;
            }
            Some(&then) if now < then * (1.0 - TOLERATED) => {
                println!("{what}: {then:.2} -> {now:.2}, {:+.1} %: bless to keep it", 100.0 * (now / then - 1.0));
            }
            Some(_) => {}
        }
    }
    for what in recorded.keys().filter(|what| !counts.contains_key(*what)) {
        println!("{what}: in the record, but not counted any more");
        risen += 1;
    }
    if risen > 0 {
        return Err(format!("{risen} of {} counts fail; bless them if that is meant", counts.len()).into());
    }
    println!("{} counts within {} % of the record", counts.len(), 100.0 * TOLERATED);
    Ok(())
}

fn bless() -> Result<(), Failure> {
    let Some(counts) = count()? else { return Ok(()) };
    let mut text = format!("# Instructions per value, by {}\nwhat,instructions\n", machine::rustc());
    for (what, count) in &counts {
        writeln!(text, "{what},{count:.2}")?;
    }
    let path = record();
    fs::create_dir_all(path.parent().ok_or("no directory")?)?;
    fs::write(&path, text)?;
    println!("{} counts written to {}", counts.len(), path.display());
    Ok(())
}

fn parse(text: &str) -> Result<Counts, Failure> {
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    rows.map(|row| {
        let (what, count) = row.rsplit_once(',').ok_or_else(|| format!("no count in `{row}`"))?;
        Ok((what.to_owned(), count.parse()?))
    })
    .collect()
}

/// All counts; `None` without valgrind.
fn count() -> Result<Option<Counts>, Failure> {
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("skipped: valgrind is not installed");
        return Ok(None);
    }
    let mut counts = Counts::new();
    for what in catalogue().into_iter().filter(|what| COUNTED.iter().any(|job| what.ends_with(job))) {
        let [one, three] = ["1", "3"].map(|passes| start(&what, passes)); // both at once
        let [one, three] = [instructions(one?)?, instructions(three?)?];
        counts.insert(what, (three - one) / (2 * COUNT) as f64);
    }
    Ok(Some(counts))
}

/// A run of this program that makes so many passes, under callgrind.
fn start(what: &str, passes: &str) -> Result<Child, Failure> {
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--callgrind-out-file=/dev/null"]);
    command.arg(env::current_exe()?).args(["--pass", what, passes]);
    Ok(command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn()?)
}

/// Instructions of a whole run, once it has ended.
fn instructions(run: Child) -> Result<f64, Failure> {
    let output = run.wait_with_output()?;
    let report = String::from_utf8_lossy(&output.stderr);
    let total = report.lines().find_map(|line| line.split_once("Collected :"));
    match total {
        Some((_, total)) if output.status.success() => Ok(total.trim().parse()?),
        _ => Err(format!("valgrind failed:\n{report}").into()),
    }
}

/// The fields that are counted: everything at 7π/8.
fn fields() -> (Field<f64>, Field<f32>) {
    (
        Field::new(Amplitude::LARGE, ours::<f64>(Amplitude::LARGE)),
        Field::new(Amplitude::LARGE, ours::<f32>(Amplitude::LARGE)),
    )
}

fn names<R: Real>(field: &Field<R>) -> Vec<String> {
    let name = |one: &Contestant<R>| JOBS.map(|mode| format!("{}; {}; {mode}", R::NAME, one.label().replace(',', ";")));
    field.contestants().iter().flat_map(name).collect()
}

fn catalogue() -> Vec<String> {
    let (doubles, singles) = fields();
    [names(&doubles), names(&singles)].concat()
}

/// The work that valgrind watches.
fn pass(what: &str, passes: &str) -> Result<(), Failure> {
    let (doubles, singles) = fields();
    let mut jobs = Vec::new();
    doubles.jobs(&mut jobs);
    singles.jobs(&mut jobs);
    let names = [names(&doubles), names(&singles)].concat();
    let index = names.iter().position(|name| name == what).ok_or("unknown name")?;
    for _ in 0..passes.parse::<u32>()? {
        (jobs[index].work)();
    }
    Ok(())
}
