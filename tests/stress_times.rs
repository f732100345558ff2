//! The stress suite `times` on few inputs: every class of plans at random, structured and adversarial times. In full:
//! `cargo run --release -p pendula-stress -- times`.

use pendula_stress::report::{Row, table};
use pendula_stress::session::Session;
use pendula_stress::times;

#[test]
fn double_precision_at_all_kinds_of_times() {
    let rows = times::sample(&Session::quiet(), 2);
    let objections: Vec<String> = rows.iter().flat_map(Row::objections).collect();
    assert!(objections.is_empty(), "{}\n{}", objections.join("\n"), table(&rows));
    assert!(rows.len() > 40 && rows.iter().all(|row| row.found.tried > 0));
}
