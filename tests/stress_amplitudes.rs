//! The stress suites `amplitudes` and `coefficients` on few inputs. In full:
//! `cargo run --release -p pendula-stress -- amplitudes` and `-- coefficients`.

use pendula_stress::report::{Row, table};
use pendula_stress::session::Session;
use pendula_stress::{amplitudes, coefficients};

fn kept(rows: &[Row]) {
    let objections: Vec<String> = rows.iter().flat_map(Row::objections).collect();
    assert!(objections.is_empty(), "{}\n{}", objections.join("\n"), table(rows));
}

#[test]
fn from_the_bottom_to_the_last_number_below_the_top() {
    kept(&amplitudes::runtime(&Session::quiet(), 24));
}

#[test]
fn compiled_plans_at_every_amplitude() {
    kept(&amplitudes::compiled(&Session::quiet(), 2));
}

#[test]
fn compiled_constants_are_correctly_rounded() {
    let row = coefficients::compiled(&Session::quiet());
    assert!(row.found.tried > 2500);
    kept(&[row]);
}

#[test]
fn constants_at_run_time_are_within_an_ulp() {
    kept(&coefficients::runtime(&Session::quiet(), 60));
}
