//! Bounds as texts give them: with a few decimals, and never rounded to what isn't proven.

/// An upper bound with so many decimals, rounded up.
pub(crate) fn at_most(bound: f64, decimals: usize) -> String {
    let nearest = |x: f64| format!("{x:.decimals$e}");
    let (text, exact) = (nearest(bound), format!("{bound:e}"));
    let is_below = text.parse::<f64>().is_ok_and(|stated| stated < bound);
    let Some((_, exponent)) = exact.split_once('e').filter(|_| is_below) else { return text };
    // It is below by less than half of a unit in the last decimal: 0.6 units more are rounded to the next.
    let more: f64 = format!("0.{:0<decimals$}6e{exponent}", "").parse().unwrap_or(bound);
    nearest(bound + more)
}

/// A lower bound of a magnitude, rounded down.
pub(crate) fn at_least(bound: f64, decimals: usize) -> String {
    at_most(-bound, decimals).trim_start_matches('-').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_rounded_outwards() {
        for (bound, decimals, above, below) in [
            (1e-6, 1, "1.0e-6", "1.0e-6"),
            (1.0000000001e-6, 1, "1.1e-6", "1.0e-6"),
            (1.04e-6, 1, "1.1e-6", "1.0e-6"),
            (1.06e-6, 1, "1.1e-6", "1.0e-6"),
            (1.1499999999e-6, 1, "1.2e-6", "1.1e-6"),
            (9.94e-7, 1, "1.0e-6", "9.9e-7"),
            (9.96e-7, 1, "1.0e-6", "9.9e-7"),
            (0.0, 1, "0.0e0", "0.0e0"),
            (2.5e-3, 0, "3e-3", "2e-3"),
            (1.2341e-300, 3, "1.235e-300", "1.234e-300"),
            (f64::from_bits(1), 3, "4.941e-324", "4.941e-324"),
        ] {
            assert_eq!([at_most(bound, decimals), at_least(bound, decimals)], [above, below], "{bound:e}");
        }
    }
}
