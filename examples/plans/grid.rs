//! The grid: amplitudes that are binary fractions, so that the macro and the run-time motion mean the same number.

use crate::plan::{Plan, plan};

/// The plans of one amplitude.
pub(crate) struct Row {
    /// With the method, if one was forced.
    pub(crate) amplitude: &'static str,
    pub(crate) plans: Vec<Plan>,
}

/// One row per amplitude, one column per tolerance; the method in braces is forced.
macro_rules! row {
    ($amplitude:expr, $theta0:tt [$($tol:tt)*] $method:tt) => {
        Row { amplitude: $amplitude, plans: vec![$(row!(@plan $theta0 $tol $method)),*] }
    };
    (@plan $theta0:tt full { $($method:ident)? }) => { plan!($theta0, "full" $(, method = $method)?) };
    (@plan $theta0:tt $tol:tt { $($method:ident)? }) => {
        plan!($theta0, stringify!($tol), tol = $tol $(, method = $method)?)
    };
}

/// Amplitudes against every decade of tolerance.
macro_rules! rows {
    ($($amplitude:literal: $($theta0:tt)/+;)*) => {
        vec![$(row!(
            $amplitude,
            ($($theta0)/+)
            [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10 1e-11 1e-12 1e-13 1e-14 full]
            {}
        )),*]
    };
}

/// What the planner chooses.
pub(crate) fn planned() -> Vec<Row> {
    rows! {
        "0.125": 0.125;
        "0.5": 0.5;
        "1": 1;
        "1.5": 1.5;
        "2": 2;
        "2.5": 2.5;
        "2.75": 2.75;
        "3": 3;
        "3.125": 3.125;
        "3.140625": 3.140625;
        // The largest multiple of 2⁻³⁰ below π.
        "π − 1.2·10⁻¹⁰": 3373259426/1073741824;
    }
}

/// What the methods of the paper, and the series of θ, need for the same.
pub(crate) fn forced() -> Vec<Row> {
    vec![
        row!("2.75, method = series", (2.75) [1e-1 1e-2 1e-4 1e-6 1e-8 1e-10 1e-12 full] { series }),
        row!("2.75, method = fourier", (2.75) [1e-1 1e-2 1e-4 1e-6 1e-8 1e-10 1e-12] { fourier }),
        row!("0.5, method = series", (0.5) [1e-2 1e-4 1e-6 1e-8 1e-10 1e-12 full] { series }),
        row!("0.5, method = fourier", (0.5) [1e-2 1e-4 1e-6 1e-8 1e-10 1e-12] { fourier }),
    ]
}
