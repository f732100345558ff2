//! What is promised at full precision: how far, in periods, and how well, relative to the largest value; in `f64` if nothing
//! else is said.

/// Of a compiled plan without `t_max`: 2⁵³.
pub const ANY_TIME: f64 = (1_u64 << 53) as f64;
/// Of the run-time pendulum: 2⁴⁵.
pub const RUN_TIME: f64 = (1_u64 << 45) as f64;
/// The most that may be observed, and what the run-time pendulum is documented to keep: 2⁻⁵⁰.
pub const UNIT: f64 = 1.0 / (1_u64 << 50) as f64;
/// The most that is proven of a compiled plan: 2⁻⁴⁹.
pub const PROVEN: f64 = 2.0 * UNIT;
/// The most that may be observed in `f32`: 2⁻²¹.
pub const UNIT_F32: f64 = 1.0 / (1_u64 << 21) as f64;
/// The most that is proven in `f32`: 2⁻²⁰.
pub const PROVEN_F32: f64 = 2.0 * UNIT_F32;

/// The constant with which a plan states the proven bound of an output: `bound!(Plan velocity)`.
#[macro_export]
macro_rules! bound {
    ($plan:ident theta) => {
        $plan::MAX_ERROR
    };
    ($plan:ident wrapped) => {
        $plan::MAX_WRAPPED_ERROR
    };
    ($plan:ident velocity) => {
        $plan::MAX_VELOCITY_ERROR
    };
    ($plan:ident acceleration) => {
        $plan::MAX_ACCELERATION_ERROR
    };
    ($plan:ident position) => {
        $plan::MAX_POSITION_ERROR
    };
}

/// The largest of errors; NaN if one is no number.
pub fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    let larger = |worst: f64, error| if error <= worst || worst.is_nan() { worst } else { error };
    errors.into_iter().fold(0.0, larger)
}
