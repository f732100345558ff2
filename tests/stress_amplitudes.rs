//! The stress suites `amplitudes` and `coefficients` on few inputs. In full:
//! `cargo run --release -p pendula-stress -- amplitudes` and `-- coefficients`.

use pendula_stress::report::assert_kept;
use pendula_stress::session::Session;
use pendula_stress::{amplitudes, coefficients};

#[test]
fn from_the_bottom_to_the_last_number_below_the_top() {
    assert_kept(&amplitudes::runtime(&Session::quiet(), 24));
}

#[test]
fn compiled_plans_at_every_amplitude() {
    assert_kept(&amplitudes::compiled(&Session::quiet(), 2));
}

#[test]
fn compiled_constants_are_correctly_rounded() {
    let row = coefficients::compiled(&Session::quiet());
    assert!(row.found.tried > 2500);
    assert_kept(&[row]);
}

#[test]
fn constants_at_run_time_are_within_an_ulp() {
    assert_kept(&coefficients::runtime(&Session::quiet(), 60));
}
