//! The plans whose every input is tried.

use crate::promised::{ANY_TIME, PROVEN_F32, UNIT_F32};

/// One output of one plan in single precision, and the same in double precision.
pub struct Plan {
    /// The scene.
    pub name: &'static str,
    /// Which of its outputs.
    pub output: &'static str,
    /// What was asked for, in the output's unit.
    pub promise: f64,
    /// What may be observed of it.
    pub observable: f64,
    /// The bound proven at compile time.
    pub proven: f64,
    /// The promise holds for |t| up to this.
    pub horizon: f64,
    /// The largest magnitude of the output.
    pub ceiling: f64,
    /// Whether it is an angle modulo a turn.
    pub wrapped: bool,
    /// The plan.
    pub single: fn(&[f32], &mut [f32]),
    /// The truth.
    pub double: fn(&[f32], &mut [f64]),
}

macro_rules! plan {
    ($name:literal: [$($start:tt)*] $(tol = $tol:literal, t_max = $t_max:literal)?; $output:ident, $bound:ident,
        largest $ceiling:expr) => {{
        pendula::pendulum! {
            struct Single;
            $($start)*, float = f32, $(tol = $tol, t_max = $t_max,)? outputs = [$output]
        }
        pendula::pendulum! {
            struct Double;
            $($start)*, outputs = [$output]
        }
        fn single(t: &[f32], values: &mut [f32]) {
            for (value, &t) in values.iter_mut().zip(t) {
                *value = Single::$output(t);
            }
        }
        fn double(t: &[f32], values: &mut [f64]) {
            for (value, &t) in values.iter_mut().zip(t) {
                *value = Double::$output(t.into());
            }
        }
        let ceiling: f64 = $ceiling;
        // Where nothing else was asked.
        let full = ceiling * PROVEN_F32;
        let promise: f64 = [$($tol,)? full][0];
        Plan {
            name: $name,
            output: stringify!($output),
            promise,
            observable: if promise == full { ceiling * UNIT_F32 } else { promise },
            proven: Single::$bound.into(),
            horizon: [$(f64::from($t_max),)? ANY_TIME * Double::PERIOD][0],
            ceiling,
            wrapped: stringify!($output) == "wrapped",
            single,
            double,
        }
    }};
}

/// Three amplitudes, coarse and for a hundred periods or in full precision at any time, and a rotation; the largest
/// terms added last, and a table of pieces.
pub fn plans() -> Vec<Plan> {
    use std::f64::consts::PI;
    vec![
        plan!("π/3, tol 1e-4, t_max 675": [theta0 = PI/3] tol = 1e-4, t_max = 675; theta, MAX_ERROR, largest PI / 3.0),
        plan!("π/3, any time": [theta0 = PI/3]; theta, MAX_ERROR, largest PI / 3.0),
        plan!("7π/8, tol 1e-4, t_max 1217": [theta0 = 7π/8] tol = 1e-4, t_max = 1217; theta, MAX_ERROR,
            largest 7.0 * PI / 8.0),
        plan!("7π/8, any time": [theta0 = 7π/8]; theta, MAX_ERROR, largest 7.0 * PI / 8.0),
        plan!("0.999π, tol 1e-3, t_max 3137": [theta0 = 0.999π] tol = 1e-3, t_max = 3137; theta, MAX_ERROR,
            largest 0.999 * PI),
        plan!("0.999π, any time": [theta0 = 0.999π]; theta, MAX_ERROR, largest 0.999 * PI),
        plan!("rotation, 2.5ω at the bottom, any time": [velocity0 = 2.5]; wrapped, MAX_WRAPPED_ERROR, largest PI),
        plan!("7π/8, any time": [theta0 = 7π/8]; velocity, MAX_VELOCITY_ERROR,
            largest 2.0 * (7.0 * PI / 16.0).sin()),
        plan!("0.9π, any time": [theta0 = 0.9π]; acceleration, MAX_ACCELERATION_ERROR, largest 1.0),
        plan!("0.999999π, any time": [theta0 = 0.999999π]; theta, MAX_ERROR, largest 0.999_999 * PI),
    ]
}
