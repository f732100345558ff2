//! What the planner chooses for every amplitude and tolerance: method, terms, proven and observed error, operations.
//!
//! `cargo run --release --example plans` prints the table and writes the map to `target/plans/`; with `-- --bless` the
//! map goes to `docs/images/`.

mod grid;
mod map;
mod plan;

use grid::Row;
use pendula_plot::Figure;
use plan::HORIZON;
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let rows = grid::planned();
    println!(
        "Plans for θ, f64, ω = 1, |t| ≤ {HORIZON}. Observed: against the run-time motion, which is itself wrong by up to"
    );
    println!("2⁻⁵⁰ θ0, at 40,000 times near the release and near the horizon.\n");
    for row in &rows {
        print(row)?;
    }
    println!("The same for methods that are forced, where they are not what the planner chooses:\n");
    for row in grid::forced() {
        print(&row)?;
    }
    let bless = std::env::args().any(|argument| argument == "--bless");
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join(if bless { "docs/images" } else { "target/plans" });
    for file in map::map(&rows).save(&directory.join("plans"))? {
        println!("{}", file.display());
    }
    Ok(())
}

fn print(row: &Row) -> Result<(), pendula::Error> {
    println!("θ0 = {}\n", row.amplitude);
    println!("  tol     method       terms  operations    proven  observed  proven/observed");
    for plan in &row.plans {
        let observed = plan.observed()?;
        println!(
            "  {:<6}  {:<12} {:>5}  {:>10}  {:>8.1e}  {:>8.1e}  {:>15.2}",
            plan.tolerance,
            plan.method,
            plan.terms,
            plan.operations,
            plan.proven,
            observed,
            plan.proven / observed
        );
    }
    println!();
    Ok(())
}
