//! Tables of the outcomes: CSV for programs, Markdown for people.

use std::fmt::Write as _;

use crate::amplitude::Amplitude;
use crate::contestant::{COUNT, Family, HORIZON, STEPPED, label};
use crate::machine;
use crate::peers::Missing;
use crate::race::Spread;
use crate::session::Outcome;

/// Decades of error in the table of the frontier, as exponents of ten.
const DECADES: std::ops::RangeInclusive<i32> = 3..=15;

/// One line per contestant, with a header.
pub fn csv(outcomes: &[Outcome]) -> String {
    let mut text = String::from(
        "target,amplitude,precision,family,name,setting,error,\
         array_ns,array_ns_lower,array_ns_upper,array_per_sin,\
         scalar_ns,scalar_ns_lower,scalar_ns_upper,scalar_per_sin,single_ns,single_ns_lower,single_ns_upper,\
         single_per_sin,cold_ns,cold_ns_lower,cold_ns_upper,random_access_ns\n",
    );
    for one in outcomes {
        let spread = |s: Spread| format!("{:.4},{:.4},{:.4}", s.median, s.lower, s.upper);
        let error = if one.error.is_nan() { String::new() } else { format!("{:.3e}", one.error) };
        let random_access = one.random_access.map(|ns| format!("{ns:.1}")).unwrap_or_default();
        let _ = writeln!(
            text,
            "{},{},{},{},{error},{},{:.4},{},{:.4},{},{:.4},{},{random_access}",
            machine::target(),
            one.amplitude.slug,
            one.precision,
            fields(one.family, &one.name, &one.setting),
            spread(one.array),
            one.array_ratio.median,
            spread(one.scalar),
            one.scalar_ratio.median,
            spread(one.single),
            one.single_ratio.median,
            spread(one.cold),
        );
    }
    text
}

/// The fields `family,name,setting` of CSV.
pub(crate) fn fields(family: Family, name: &str, setting: &str) -> String {
    [family.name(), name, setting].map(quoted).join(",")
}

/// A field of CSV; RFC 4180 wants quotes around one with a comma.
fn quoted(field: &str) -> String {
    if field.contains(',') { format!("\"{field}\"") } else { field.into() }
}

/// Everything in one document: what it was measured on, the frontier, and a table per amplitude and precision.
pub fn markdown(outcomes: &[Outcome], missing: &[Missing], versions: &[(&str, String)]) -> String {
    let mut text = format!("# Run time against error, {}\n\n", machine::target());
    let _ = writeln!(text, "{}\n", provenance(missing, versions));
    for amplitude in Amplitude::ALL {
        for precision in ["f64", "f32"] {
            let field: Vec<&Outcome> =
                outcomes.iter().filter(|one| one.amplitude == amplitude && one.precision == precision).collect();
            if field.is_empty() {
                continue;
            }
            let _ = writeln!(text, "## θ0 = {}, {precision}\n", amplitude.name);
            if let Some(frontier) = frontier(&field) {
                let _ = writeln!(text, "{frontier}");
            }
            let _ = writeln!(text, "{}", table(&field));
        }
    }
    text
}

/// The frontier at 7π/8 in double precision, with what it was measured on: for the text around the pictures.
pub fn summary(outcomes: &[Outcome]) -> String {
    let field: Vec<&Outcome> =
        outcomes.iter().filter(|one| one.amplitude == Amplitude::LARGE && one.precision == "f64").collect();
    let (machine, rustc, table) = (machine::processor(), machine::rustc(), frontier(&field).unwrap_or_default());
    format!("{}; {rustc}, {machine}.\n\n{table}", machine::target())
}

/// Machine, compiler and peers.
fn provenance(missing: &[Missing], versions: &[(&str, String)]) -> String {
    let peers: Vec<String> = versions.iter().map(|(name, version)| format!("{name} {version}")).collect();
    let absent: Vec<String> = missing.iter().map(|peer| format!("{} ({})", peer.name, peer.why)).collect();
    let absent = if absent.is_empty() { "none".into() } else { absent.join("; ") };
    format!(
        "Processor: {}. Compiler: {}, compiled for {}. Peers: {}. Missing peers: {absent}.\n\n\
         Times are medians with the quartiles in brackets. *Array*: ns per value in a loop over {COUNT} random times of \
         0 to {HORIZON:.0} periods; for steppers ns per step of one of {COUNT} independent pendula. *Cold*: the same when other work has written 8 MiB \
         before each pass. *Scalar*: ns per call of a loop in which none waits for another nor shares a vector with it. \
         *Single*: ns per call when each waits for the one before; for steppers ns per step of one trajectory. *Random access*: what a stepper \
         needs on average for the value at one of those times. *Error*: the largest on the times of the array loop; for \
         steppers the largest over {STEPPED:.0} periods from the release.",
        machine::processor(),
        machine::rustc(),
        machine::target(),
        peers.join(", "),
    )
}

/// All outcomes of one amplitude and precision, families together.
fn table(field: &[&Outcome]) -> String {
    let mut text = String::from(
        "| | | error (rad) | array (ns) | × `sin` | cold (ns) | scalar (ns) | × `sin` | single (ns) | × `sin` | random access |\n\
         |---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    let mut sorted = field.to_vec();
    sorted.sort_by_key(|one| one.family);
    for one in sorted {
        let error = if one.error.is_nan() { "–".into() } else { scientific(one.error) };
        let random_access = one.random_access.map_or_else(|| "–".into(), duration);
        let _ = writeln!(
            text,
            "| {} | {} | {error} | {} | {} | {} | {} | {} | {} | {} | {random_access} |",
            one.name,
            one.setting,
            nanoseconds(one.array),
            digits(one.array_ratio.median),
            digits(one.cold.median),
            nanoseconds(one.scalar),
            digits(one.scalar_ratio.median),
            nanoseconds(one.single),
            digits(one.single_ratio.median),
        );
    }
    text
}

/// Per decade of error our cheapest, the cheapest of the peers that are at least as accurate, and the cheapest of those
/// that compute their values instead of looking them up; `None` without ours.
pub fn frontier(field: &[&Outcome]) -> Option<String> {
    let cheapest = |error: f64, side: fn(Family) -> bool| {
        let able = field.iter().copied().filter(|one| side(one.family) && one.error <= error);
        able.min_by(|a, b| a.array.median.total_cmp(&b.array.median))
    };
    field.iter().find(|one| one.family.ours())?;
    let mut text = String::from(
        "| error at most | `pendula` | ns | cheapest peer | ns | ratio | cheapest without a table | ns | ratio |\n\
         |--:|---|--:|---|--:|--:|---|--:|--:|\n",
    );
    for decade in DECADES {
        let error = 10.0_f64.powi(-decade);
        let Some(own) = cheapest(error, Family::ours) else { break };
        let beside = |peer: Option<&Outcome>| match peer {
            None => "none | – | –".into(),
            Some(peer) => {
                let ns = peer.array.median;
                format!("{} | {} | {}", peer.label(), digits(ns), digits(ns / own.array.median))
            }
        };
        let (any, computing) =
            (cheapest(error, Family::peer), cheapest(error, |family| family.peer() && family != Family::Table));
        let (own, time) = (own.label(), digits(own.array.median));
        let _ = writeln!(text, "| 1e-{decade} | {own} | {time} | {} | {} |", beside(any), beside(computing));
    }
    let left: Vec<String> = undominated(field).map(Outcome::label).collect();
    let left = if left.is_empty() { "none".into() } else { left.join("; ") };
    let _ = writeln!(text, "\nPeers that are cheaper than anything of ours of at most their error: {left}.");
    Some(text)
}

/// The peers on the left of our frontier in the array loop.
fn undominated<'a>(field: &'a [&'a Outcome]) -> impl Iterator<Item = &'a Outcome> {
    field.iter().copied().filter(move |peer| {
        let beaten = |own: &&&Outcome| own.error <= peer.error && own.array.median <= peer.array.median;
        // Without a value there is no error.
        peer.family.peer()
            && !peer.error.is_nan()
            && !field.iter().filter(|one| one.family.ours()).any(|own| beaten(&own))
    })
}

impl Outcome {
    /// See [`label`].
    pub fn label(&self) -> String {
        label(&self.name, &self.setting)
    }
}

/// Three significant digits.
fn digits(value: f64) -> String {
    let decimals = (2.0 - value.abs().log10().floor()).clamp(0.0, 6.0) as usize;
    format!("{value:.decimals$}")
}

fn scientific(value: f64) -> String {
    format!("{value:.1e}")
}

fn nanoseconds(time: Spread) -> String {
    format!("{} ({} to {})", digits(time.median), digits(time.lower), digits(time.upper))
}

/// Nanoseconds in the unit that suits them.
fn duration(ns: f64) -> String {
    if ns < 1e3 {
        format!("{} ns", digits(ns))
    } else if ns < 1e6 {
        format!("{} µs", digits(ns / 1e3))
    } else {
        format!("{} ms", digits(ns / 1e6))
    }
}
