//! The errors that the paper states, beside those of the generated code.

use crate::approximation::{Approximation, approximation};
use pendula::Error;

/// One of the paper's statements of accuracy.
struct Row {
    formula: &'static str,
    approximation: Approximation,
    /// In percent of θ0, as printed in the paper; `None` where it states nothing.
    claim: Option<(&'static str, f64)>,
}

fn rows() -> [Row; 11] {
    let harmonic = |approximation, claim| Row { formula: "Eq. 17", approximation, claim };
    let fourier = |approximation, claim| Row { formula: "Eq. 22", approximation, claim };
    [
        harmonic(approximation!((π / 3), method = harmonic), Some(("< 1", 1.0))),
        fourier(approximation!((π / 3), n = 1), Some(("2", 2.0))),
        fourier(approximation!((π / 3), n = 2), Some(("0.04", 0.04))),
        harmonic(approximation!((π / 2), method = harmonic), Some(("2.3", 2.3))),
        fourier(approximation!((π / 2), n = 2), Some(("0.2", 0.2))),
        harmonic(approximation!((4π / 5), method = harmonic), None),
        fourier(approximation!((4π / 5), n = 3), Some(("0.6", 0.6))),
        harmonic(approximation!((7π / 8), method = harmonic), None),
        fourier(approximation!((7π / 8), n = 4), Some(("0.4", 0.4))),
        harmonic(approximation!((0.95π), method = harmonic), None),
        fourier(approximation!((0.95π), n = 6), Some(("0.3", 0.3))),
    ]
}

pub(crate) fn print() -> Result<(), Error> {
    println!("sup |θ̂ − θ| / θ0, generated code against the exact motion computed at run time:\n");
    println!("  θ0      formula   N   the paper   computed    ratio   proven bound");
    for Row { formula, approximation, claim } in rows() {
        let computed = 100.0 * approximation.supremum(1)?.relative;
        let (stated, ratio) = claim.map_or((String::from("–"), String::new()), |(stated, value)| {
            (format!("{stated} %"), format!("{:.3}", computed / value))
        });
        let proven = 100.0 * approximation.proven / approximation.theta0;
        println!(
            "  {:<7} {formula}  {:>2}   {stated:>9}  {computed:>8.5} %   {ratio:>5}   {proven:>8.5} %",
            approximation.label(),
            approximation.terms,
        );
    }
    println!("\n  No error exceeds the paper's figure for it by more than the rounding of its last digit.\n");
    Ok(())
}
