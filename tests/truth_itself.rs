//! The truth that other tests rely on, against the reference data.

mod truth;

use pendula_stress::reference::{Exact, releases_and_launches};
use truth::{Swing, distance};

/// The reference has the f64 parameters: those of these names are exact.
const EXACT: [(&str, f64); 3] = [("1;0;1", 1.0), ("2;0;1", 2.0), ("3;0;1", 3.0)];

#[test]
fn theta_quotients_in_two_words_agree_with_the_reference() {
    let mut rows = 0;
    for (name, theta0) in EXACT {
        let swing = Swing::named(name);
        for row in
            releases_and_launches().filter(|row| row.theta0 == theta0 && row.velocity0 == 0.0 && row.t.abs() < 1e17)
        {
            let state = swing.at(row.t);
            // The reference rounds its second word to four digits: 2⁻⁵³·10⁻³ of the value.
            let off = |x: pendulum_runtime::double::Double, exact: Exact| {
                ((x.hi - exact.nearest) + (x.lo - exact.rest)).abs()
            };
            assert!(off(state.theta, row.theta) < 2e-19, "{name} at {}: {state:?} {row:?}", row.t);
            assert!(off(state.velocity, row.velocity) < 2e-19, "{name} at {}: {state:?} {row:?}", row.t);
            assert!(distance(row.theta.nearest.sin(), state.sine) < 4e-16);
            assert!(distance(row.theta.nearest.cos(), state.cosine) < 4e-16);
            rows += 1;
        }
    }
    assert!(rows > 100, "{rows}");
}
