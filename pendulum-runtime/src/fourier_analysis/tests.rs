use super::*;

/// |2 asin(y − ρ) − 2 asin y| as it is defined, also where y − ρ has the other sign, which only phases next to the zero
/// crossing meet, where nothing is largest.
#[test]
fn distances_of_arcsines() {
    for y in [0.1, 0.5, 0.9] {
        for tail in [-0.05, -1e-6, 0.0, 1e-6, 0.05, 0.1, 0.3, 0.7] {
            let x: f64 = y - tail;
            let margin = (1.0 - x) * (1.0 + x);
            let exact = 2.0 * (libm::asin(x) - libm::asin(y)).abs();
            let error = (distance(y, sqrt((1.0 - y) * (1.0 + y)), tail, margin) - exact).abs();
            // The difference of the library's arcsines loses units in the last place of each.
            assert!(error <= 1e-15, "{y} {tail}: {error:e}");
        }
    }
}
