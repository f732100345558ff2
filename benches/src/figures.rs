//! The two pictures: run time against error, and error against time elapsed.

use pendula_plot::{LogLog, Marker, Point, Series, Stroke, palette};

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
        (Family::Planned, ANY_TIME) => (palette::BLUE, Marker::Diamond, None),
        (Family::Planned, _) => (palette::BLUE, Marker::Disc, Some((Stroke::Solid, 2.6))),
        (Family::Forced, _) => (palette::SKY, Marker::Disc, faint),
        (Family::Runtime, _) => (palette::BLUE, Marker::Square, None),
        (Family::Paper, _) => (palette::ORANGE, Marker::Square, Some((Stroke::Solid, 1.6))),
        (Family::Library, "GSL") => (palette::PURPLE, Marker::Diamond, None),
        (Family::Library, name) if name.starts_with("Boost") => (palette::PURPLE, Marker::Square, faint),
        (Family::Library, _) => (palette::PURPLE, Marker::Triangle, None),
        (Family::Table, _) => (palette::GREEN, Marker::Square, faint),
        (Family::Stepper, "semi-implicit Euler") => (palette::VERMILION, Marker::Nabla, faint),
        (Family::Stepper, "leapfrog") => (palette::VERMILION, Marker::Triangle, faint),
        (Family::Stepper, "RK4") => (palette::VERMILION, Marker::Diamond, faint),
        (Family::Stepper | Family::Yardstick, _) => (palette::GREY, Marker::Cross, faint),
    };
    Look { colour, marker, line }
}

/// Run time in the array loop against error for one amplitude and precision.
pub fn pareto(outcomes: &[Outcome], amplitude: Amplitude, precision: &str) -> LogLog {
    let field: Vec<&Outcome> =
        outcomes.iter().filter(|one| one.amplitude == amplitude && one.precision == precision).collect();
    let mut series: Vec<Series> = Vec::new();
    for one in field.iter().filter(|one| !matches!(one.family, Family::Yardstick | Family::Forced)) {
        let look = look(one.family, &one.name);
        let note_left = one.name == "semi-implicit Euler";
        let point = Point { note: note(one), note_left, ..Point::new(one.array.median, one.error) };
        match series.iter_mut().find(|seen| seen.label == one.name) {
            Some(seen) => seen.points.push(point),
            None => series.push(Series {
                label: one.name.clone(),
                colour: look.colour,
                marker: Some(look.marker),
                line: look.line,
                points: vec![point],
            }),
        }
    }
    let range = if precision == "f32" { (1e-8, 20.0) } else { (1e-17, 20.0) };
    if let Some(unit) = field.iter().find(|one| one.family == Family::Yardstick) {
        let at = unit.array.median;
        series.insert(
            0,
            Series {
                label: unit.name.clone(),
                colour: palette::GREY,
                marker: None,
                line: Some((Stroke::Dashed, 1.4)),
                points: vec![Point::new(at, range.0), Point::new(at, range.1)],
            },
        );
    }
    // The side that matters lies on top.
    series.sort_by_key(|one| one.colour == palette::BLUE);
    LogLog {
        title: format!(
            "Run time against error: θ₀ = {}, {precision}, array loop, {}",
            amplitude.name,
            crate::machine::target()
        ),
        x_label: "time per value (ns)".into(),
        y_label: "largest error (rad)".into(),
        y_range: Some(range),
        series,
    }
}

/// The short text beside a point: the step of a stepper, the size of a table.
fn note(one: &Outcome) -> String {
    match one.family {
        Family::Table => one.setting.trim_end_matches(" points").into(),
        Family::Stepper if !one.setting.contains("tolerance") => one.setting.clone(),
        Family::Library if !one.setting.is_empty() => one.setting.clone(),
        _ => String::new(),
    }
}

/// Error against time elapsed.
pub fn drift(drifts: &[Drift], amplitude: Amplitude) -> LogLog {
    let line = |one: &Drift| {
        let look = look(one.family, &one.name);
        let width = if one.family.ours() { 2.6 } else { 1.6 };
        Series {
            label: if one.setting.is_empty() { one.name.clone() } else { format!("{}, {}", one.name, one.setting) },
            colour: look.colour,
            marker: Some(look.marker),
            line: Some((Stroke::Solid, width)),
            points: one.points.iter().map(|&(periods, error)| Point::new(periods, error)).collect(),
        }
    };
    LogLog {
        title: format!("Error against time elapsed: θ₀ = {}, f64", amplitude.name),
        x_label: "periods elapsed".into(),
        y_label: "largest error in one period (rad)".into(),
        y_range: Some((1e-17, 20.0)),
        series: drifts.iter().filter(|one| shown(one)).map(line).collect(),
    }
}

/// One or two of a kind: the picture with all of them cannot be read.
fn shown(one: &Drift) -> bool {
    match one.family {
        Family::Yardstick | Family::Forced => false,
        Family::Paper => ["N = 4", "N = 12"].contains(&one.setting.as_str()),
        Family::Library => one.setting != "f64",
        Family::Stepper if one.setting.contains("tolerance") => {
            one.name.contains("T/1000") && !one.setting.contains("10⁻⁶")
        }
        Family::Stepper => one.setting == "T/100" || one.name == "RK4",
        Family::Planned => ["tol 1e-3", "tol 1e-6", "tol 1e-9", "full precision"].contains(&one.setting.as_str()),
        Family::Runtime | Family::Table => true,
    }
}
