//! The two pictures: run time against error, and error against time elapsed.

use pendula_plot::{LogLog, Marker, Series, Stroke, palette};

use crate::amplitude::Amplitude;
use crate::contestant::Family;
use crate::drift::Drift;
use crate::ours::ANY_TIME;
use crate::session::Outcome;

/// How a contestant is drawn: colour, marker, whether its settings are joined by a line.
struct Look {
    colour: palette::Colour,
    marker: Marker,
    line: Option<(Stroke, f64)>,
}

fn look(family: Family, name: &str) -> Look {
    let faint = Some((Stroke::Dotted, 1.2));
    let (colour, marker, line) = match (family, name) {
        (Family::Planned, ANY_TIME) => (palette::SKY, Marker::Disc, Some((Stroke::Solid, 2.6))),
        (Family::Planned, _) => (palette::BLUE, Marker::Disc, Some((Stroke::Solid, 2.6))),
        (Family::Forced, _) => (palette::SKY, Marker::Nabla, faint),
        (Family::Runtime, _) => (palette::BLUE, Marker::Square, None),
        (Family::Paper, _) => (palette::ORANGE, Marker::Square, Some((Stroke::Solid, 1.6))),
        (Family::Library, "GSL") => (palette::PURPLE, Marker::Diamond, None),
        (Family::Library, name) if name.starts_with("Boost") => (palette::PURPLE, Marker::Square, faint),
        (Family::Library, _) => (palette::PURPLE, Marker::Triangle, None),
        (Family::Table, _) => (palette::GREEN, Marker::Square, faint),
        (Family::Stepper, "semi-implicit Euler") => (palette::VERMILION, Marker::Nabla, faint),
        (Family::Stepper, "leapfrog") => (palette::VERMILION, Marker::Triangle, faint),
        (Family::Stepper, "RK4") => (palette::VERMILION, Marker::Diamond, faint),
        (Family::Stepper, name) if name.ends_with("T/100") => (palette::BLACK, Marker::Cross, faint),
        (Family::Stepper | Family::Yardstick, _) => (palette::GREY, Marker::Cross, faint),
    };
    Look { colour, marker, line }
}

/// What the entries of one name are called in the legend: with their settings, or from the first to the last.
fn legend(name: &str, settings: &[&str]) -> String {
    match settings {
        [] | [""] => name.into(),
        [one] => format!("{name}, {one}"),
        [first, last] => format!("{name}, {first} and {last}"),
        [first, .., last] => format!("{name}, {first} to {last}"),
    }
}

/// Run time in the array loop against error for one amplitude and precision.
pub fn pareto(outcomes: &[Outcome], amplitude: Amplitude, precision: &str) -> LogLog {
    let field: Vec<&Outcome> = outcomes
        .iter()
        .filter(|one| one.amplitude == amplitude && one.precision == precision && one.family != Family::Forced)
        .collect();
    let range = if precision == "f32" { (1e-8, 20.0) } else { (1e-17, 20.0) };
    let series = names(field.iter().map(|one| one.name.as_str())).into_iter().map(|name| {
        let entries: Vec<&Outcome> = field.iter().copied().filter(|one| one.name == name).collect();
        if entries[0].family == Family::Yardstick {
            return yardstick(entries[0], range);
        }
        let look = look(entries[0].family, name);
        Series {
            label: legend(name, &entries.iter().map(|one| one.setting.as_str()).collect::<Vec<_>>()),
            colour: look.colour,
            marker: Some(look.marker),
            line: look.line,
            points: entries.iter().map(|one| (one.array.median, one.error)).collect(),
        }
    });
    let target = crate::machine::target();
    LogLog {
        title: format!("Run time against error: θ₀ = {}, {precision}, array loop, {target}", amplitude.name),
        x_label: "time per value (ns)".into(),
        y_label: "largest error (rad)".into(),
        y_range: range,
        series: series.collect(),
    }
}

/// A line at the cost of `sin`.
fn yardstick(unit: &Outcome, range: (f64, f64)) -> Series {
    let at = unit.array.median;
    Series {
        label: unit.name.clone(),
        colour: palette::GREY,
        marker: None,
        line: Some((Stroke::Dashed, 1.4)),
        points: vec![(at, range.0), (at, range.1)],
    }
}

/// Every name once, in the order of appearance.
fn names<'a>(all: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut seen = Vec::new();
    for name in all {
        if !seen.contains(&name) {
            seen.push(name);
        }
    }
    seen
}

/// Error against time elapsed: a line per entry, and a place in the legend per name.
pub fn drift(drifts: &[Drift], amplitude: Amplitude) -> LogLog {
    let shown: Vec<&Drift> = drifts.iter().filter(|one| shown(one)).collect();
    let mut series = Vec::new();
    for name in names(shown.iter().map(|one| one.name.as_str())) {
        let entries: Vec<&Drift> = shown.iter().copied().filter(|one| one.name == name).collect();
        let settings: Vec<&str> = entries.iter().map(|one| one.setting.as_str()).collect();
        for (index, one) in entries.into_iter().enumerate() {
            let look = look(one.family, name);
            let (colour, width) = if one.family.ours() { (palette::BLUE, 2.6) } else { (look.colour, 1.6) };
            series.push(Series {
                label: if index == 0 { legend(name, &settings) } else { String::new() },
                colour,
                marker: Some(look.marker),
                line: Some((Stroke::Solid, width)),
                points: one.points.clone(),
            });
        }
    }
    LogLog {
        title: format!("Error against time elapsed: θ₀ = {}, f64", amplitude.name),
        x_label: "periods elapsed".into(),
        y_label: "largest error in one period (rad)".into(),
        y_range: (1e-17, 20.0),
        series,
    }
}

/// One or two of a kind: the picture with all of them cannot be read.
fn shown(one: &Drift) -> bool {
    match one.family {
        Family::Yardstick | Family::Forced => false,
        Family::Paper => ["N = 4", "N = 12"].contains(&one.setting.as_str()),
        Family::Library => one.setting != "f64",
        Family::Stepper if one.name.starts_with("Dormand") => one.name.ends_with("T/1000") && one.setting != "tol 1e-6",
        Family::Stepper => one.setting == "T/100" || one.name == "RK4",
        Family::Planned => one.name == ANY_TIME,
        Family::Runtime | Family::Table => true,
    }
}
