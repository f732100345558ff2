//! Tables of what was found.

use std::fmt::Write as _;

use crate::finding::Finding;

/// One line of a table: a promise and what became of it.
#[derive(Clone, Debug)]
pub struct Row {
    /// The scene, plan or regime.
    pub subject: String,
    /// The output.
    pub output: String,
    /// The largest error promised, in the output's unit.
    pub promise: f64,
    /// The bound proven at compile time, where there is one.
    pub proven: Option<f64>,
    /// The largest error that may be observed: the promise of a tolerance, half of it at full precision.
    pub observable: f64,
    /// What was found.
    pub found: Finding,
}

impl Row {
    /// Whether every promise was kept.
    pub fn kept(&self) -> bool {
        self.objections().is_empty()
    }

    /// What was not kept.
    pub fn objections(&self) -> Vec<String> {
        let mut all = self.found.faults.clone();
        let found = &self.found;
        let mut object = |what: &str, limit: f64| {
            all.push(format!(
                "{}, {}: observed {:e} at {:e}, {what} {limit:e}",
                self.subject, self.output, found.worst, found.at
            ));
        };
        if let Some(proven) = self.proven {
            if found.worst > proven {
                object("proven", proven);
            }
            // The proven bound is rounded up to the plan's float.
            if proven > self.promise * (1.0 + f64::from(f32::EPSILON)) {
                object("of a bound beyond the promise", proven);
            }
        }
        if found.worst > self.observable {
            object("promised", self.observable);
        }
        all
    }
}

/// For tests.
///
/// # Panics
/// With what was not kept, or not tried, and the table.
#[track_caller]
pub fn assert_kept(rows: &[Row]) {
    assert!(!rows.is_empty() && rows.iter().all(|row| row.found.tried > 0), "{}", table(rows));
    let objections: Vec<String> = rows.iter().flat_map(Row::objections).collect();
    assert!(objections.is_empty(), "{}\n{}", objections.join("\n"), table(rows));
}

/// A Markdown table; errors in units of the promise.
pub fn table(rows: &[Row]) -> String {
    let mut text = String::from(
        "| | output | promise | proven | observed | at | inputs | broken |\n|---|---|---|---|---|---|---|---|\n",
    );
    for row in rows {
        let Row { subject, output, promise, proven, found, .. } = row;
        let proven = proven.map_or("–".into(), |proven| format!("{:.2}", proven / promise));
        let observed = found.worst / promise;
        let at = if found.worst > 0.0 { format!("{:e}", found.at) } else { "–".into() };
        let tried = count(found.tried);
        let _ = writeln!(
            text,
            "| {subject} | {output} | {promise:.3e} | {proven} | {observed:.2} | {at} | {tried} | {} |",
            found.broken
        );
    }
    text
}

/// A count with groups of three digits.
pub fn count(n: u64) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}
