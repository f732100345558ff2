//! The grid: amplitudes that are binary fractions, so that the macro and the run-time motion mean the same number.

use crate::plan::{Plan, plan};

/// The plans of one amplitude.
pub(crate) struct Row {
    /// As it was written, and with a method if one was forced.
    pub(crate) amplitude: String,
    pub(crate) plans: Vec<Plan>,
}

/// One row per amplitude, one column per tolerance; the method in braces is forced.
macro_rules! row {
    ($theta0:tt [$($tol:tt)*] $method:tt) => {
        Row { amplitude: row!(@label $theta0 $method), plans: vec![$(row!(@plan $theta0 $tol $method)),*] }
    };
    (@label ($($theta0:tt)*) {}) => { stringify!($($theta0)*).to_owned() };
    (@label ($($theta0:tt)*) { $method:ident }) => {
        concat!(stringify!($($theta0)*), ", method = ", stringify!($method)).to_owned()
    };
    (@plan $theta0:tt full { $($method:ident)? }) => { plan!($theta0, "full" $(, method = $method)?) };
    (@plan $theta0:tt $tol:tt { $($method:ident)? }) => {
        plan!($theta0, stringify!($tol), tol = $tol $(, method = $method)?)
    };
}

/// Amplitudes against every decade of tolerance.
macro_rules! rows {
    ($([$($theta0:tt)*])*) => {
        vec![$(row!(
            ($($theta0)*)
            [1e-1 1e-2 1e-3 1e-4 1e-5 1e-6 1e-7 1e-8 1e-9 1e-10 1e-11 1e-12 1e-13 1e-14 full]
            {}
        )),*]
    };
}

/// What the planner chooses.
pub(crate) fn planned() -> Vec<Row> {
    rows! { [0.125] [0.5] [1] [1.5] [2] [2.5] [2.75] [3] }
}

/// What the methods of the paper, and the series of θ, need for the same.
pub(crate) fn forced() -> Vec<Row> {
    vec![
        row!((2.75) [1e-1 1e-2 1e-4 1e-6 1e-8 1e-10 1e-12 full] { series }),
        row!((2.75) [1e-1 1e-2 1e-4 1e-6 1e-8 1e-10 1e-12] { fourier }),
        row!((0.5) [1e-2 1e-4 1e-6 1e-8 1e-10 1e-12 full] { series }),
        row!((0.5) [1e-2 1e-4 1e-6 1e-8 1e-10 1e-12] { fourier }),
    ]
}
