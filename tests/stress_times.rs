//! The stress suite `times` on few inputs: every class of plans at random, structured and adversarial times. In full:
//! `cargo run --release -p pendula-stress -- times`.

use pendula_stress::report::{Row, assert_kept};
use pendula_stress::session::Session;
use pendula_stress::times;

fn kept(rows: &[Row]) {
    assert_kept(rows);
    assert!(rows.len() > 40 && rows.iter().all(|row| row.found.tried > 0));
    // A truth that were our own values would find no errors at all.
    let seen = rows.iter().filter(|row| row.found.worst > 0.05 * row.promise).count();
    assert!(seen > rows.len() / 2, "{seen} of {}", rows.len());
}

#[test]
fn double_precision_at_all_kinds_of_times() {
    kept(&times::sample(&Session::quiet(), 2, 0..=times::HARDEST - 1));
}

/// The fourth part of the phase is left out of the sum that is rounded, so that n can be the wrong neighbour of a tie
/// by more than the limits of |s| allow.
#[test]
fn double_precision_beside_ties() {
    kept(&times::sample(&Session::quiet(), 16, times::HARDEST..=times::HARDEST));
}
