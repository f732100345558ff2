//! The stress suite `exhaustive` on one block of 1024 times in 4099, all exponents and both signs among them. In full:
//! `cargo run --release -p pendula-stress -- exhaustive`.

use pendula_stress::exhaustive;
use pendula_stress::report::{assert_kept, table};
use pendula_stress::session::Session;

#[test]
fn single_precision_at_a_million_times() {
    // A prime, so that blocks fall everywhere within the exponents, of which each has 8192.
    let rows = exhaustive::run(&Session::quiet(), 4099);
    assert_kept(&rows);
    for row in &rows {
        assert!(row.found.tried > 1_000_000);
        // More than a twentieth of what was promised is seen: a plan that were compared with itself would show nothing.
        assert!(row.found.worst > 0.05 * row.promise, "{}", table(&rows));
    }
}
