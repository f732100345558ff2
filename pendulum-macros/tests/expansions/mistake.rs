// What this expands to; written by src/snapshots.rs.
//
//     pub struct Wrong;
//     theta0 = 4, n = 0

compile_error! {
    "`theta0 = 4` is 4.0 rad = 229.1831180523293°: released at rest, |θ0| must be less than π (180°); `theta0 = -2.2831853071795867` is the same position, and motion over the top starts with a `velocity0`; if degrees are meant, write `theta0 = 4deg`"
}
compile_error! {
    "`n = 0` is a series without terms: θ\u{302} needs `n = 1` or more"
}
///
pub struct Wrong;
#[allow(
    dead_code,
    deprecated,
    unused_qualifications,
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    clippy::arithmetic_side_effects,
    clippy::as_conversions,
    clippy::float_arithmetic,
    clippy::float_cmp,
    clippy::indexing_slicing,
    clippy::min_ident_chars,
    clippy::missing_inline_in_public_items,
    clippy::missing_docs_in_private_items,
    clippy::single_call_fn
)]
#[allow(missing_docs)]
impl Wrong {
    pub const THETA0: f64 = 1.0;
    pub const VELOCITY0: f64 = 1.0;
    pub const OMEGA: f64 = 1.0;
    pub const T_MAX: f64 = 1.0;
    pub const AMPLITUDE: f64 = 1.0;
    pub const MODULUS: f64 = 1.0;
    pub const K: f64 = 1.0;
    pub const K_PRIME: f64 = 1.0;
    pub const NOME: f64 = 1.0;
    pub const PERIOD: f64 = 1.0;
    pub const MAX_ERROR: f64 = 0.0;
    pub const MAX_VELOCITY_ERROR: f64 = 0.0;
    pub const MAX_ACCELERATION_ERROR: f64 = 0.0;
    pub const MAX_POSITION_ERROR: f64 = 0.0;
    pub const MAX_WRAPPED_ERROR: f64 = 0.0;
    pub const METHOD: &'static str = "";
    pub const TERMS: usize = 1;
    pub const OPERATIONS: usize = 1;
    pub const COEFFICIENTS: [f64; 1usize] = [0.0; 1usize];
    pub const fn theta(_t: f64) -> f64 {
        0.0
    }
    pub const fn velocity(_t: f64) -> f64 {
        0.0
    }
    pub const fn acceleration(_t: f64) -> f64 {
        0.0
    }
    pub const fn wrapped(_t: f64) -> f64 {
        0.0
    }
    pub const fn position(_t: f64) -> (f64, f64) {
        (0.0, 0.0)
    }
    pub const fn state(_t: f64) -> (f64, f64) {
        (0.0, 0.0)
    }
}
