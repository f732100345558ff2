//! The map of plans: θ0 against tolerance, coloured by method, darker with more operations.

use crate::grid::Row;
use crate::plan::{HORIZON, Plan};
use pendula_plot::{Category, Cell, Map, palette, power_of_ten};

/// One per method, in the order of their first appearance.
const COLOURS: [palette::Colour; 5] =
    [palette::BLUE, palette::GREEN, palette::VERMILION, palette::PURPLE, palette::ORANGE];

pub(crate) fn map(rows: &[Row]) -> Map {
    let plans = || rows.iter().flat_map(|row| &row.plans);
    let mut methods: Vec<&str> = Vec::new();
    for plan in plans() {
        if !methods.contains(&plan.method) {
            methods.push(plan.method);
        }
    }
    let most = plans().map(|plan| plan.operations).max().unwrap_or(1);
    let cell = |plan: &Plan| Cell {
        category: methods.iter().position(|method| *method == plan.method).unwrap_or(0),
        strength: 0.1 + 0.9 * plan.operations as f64 / most as f64,
        text: plan.terms.to_string(),
    };
    let least = plans().map(|plan| plan.operations).min().unwrap_or(0);
    Map {
        title: format!("What the planner chooses (f64, |t| ≤ {HORIZON}/ω)"),
        x_label: "tol (rad)".into(),
        y_label: "release angle θ₀ (rad)".into(),
        columns: rows.first().map_or(Vec::new(), |row| row.plans.iter().map(column).collect()),
        rows: rows.iter().map(|row| row.amplitude.into()).collect(),
        categories: methods
            .iter()
            .zip(COLOURS)
            .map(|(method, colour)| Category { label: (*method).into(), colour })
            .collect(),
        cells: rows.iter().map(|row| row.plans.iter().map(cell).collect()).collect(),
        note: format!(
            "Numbers: terms (of a quotient,\nthose of its numerator).\nDarker: more operations,\n{least} to {most} per call."
        ),
    }
}

fn column(plan: &Plan) -> String {
    let exponent = plan.tolerance.strip_prefix("1e").and_then(|exponent| exponent.parse().ok());
    exponent.map_or_else(|| plan.tolerance.into(), power_of_ten)
}
