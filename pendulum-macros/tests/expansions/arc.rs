// What this expands to; written by src/snapshots.rs.
//
//     struct Instant;
//     theta0 = 1, tol = 1e-9, t_max = 1, outputs = [state]

///
struct Instant;
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
impl Instant {
    const REFUSED: f64 = {
        compile_error! {
            "output `state` is the function that comes with two outputs: list `theta` and `velocity`"
        }
        1.0
    };
    pub const THETA0: f64 = Self::REFUSED;
    pub const VELOCITY0: f64 = Self::REFUSED;
    pub const OMEGA: f64 = Self::REFUSED;
    pub const T_MAX: f64 = Self::REFUSED;
    pub const AMPLITUDE: f64 = Self::REFUSED;
    pub const MODULUS: f64 = Self::REFUSED;
    pub const K: f64 = Self::REFUSED;
    pub const K_PRIME: f64 = Self::REFUSED;
    pub const NOME: f64 = Self::REFUSED;
    pub const PERIOD: f64 = Self::REFUSED;
    pub const MAX_ERROR: f64 = Self::REFUSED;
    pub const MAX_VELOCITY_ERROR: f64 = Self::REFUSED;
    pub const MAX_ACCELERATION_ERROR: f64 = Self::REFUSED;
    pub const MAX_POSITION_ERROR: f64 = Self::REFUSED;
    pub const MAX_WRAPPED_ERROR: f64 = Self::REFUSED;
    pub const METHOD: &'static str = {
        let _ = Self::REFUSED;
        ""
    };
    pub const TERMS: usize = Self::REFUSED as usize;
    pub const OPERATIONS: usize = Self::REFUSED as usize;
    pub const COEFFICIENTS: [f64; { Self::REFUSED as usize }] = [Self::REFUSED; {
        Self::REFUSED as usize
    }];
    pub const fn theta(_t: f64) -> f64 {
        Self::REFUSED
    }
    pub const fn velocity(_t: f64) -> f64 {
        Self::REFUSED
    }
    pub const fn acceleration(_t: f64) -> f64 {
        Self::REFUSED
    }
    pub const fn wrapped(_t: f64) -> f64 {
        Self::REFUSED
    }
    pub const fn position(_t: f64) -> (f64, f64) {
        (Self::REFUSED, Self::REFUSED)
    }
    pub const fn state(_t: f64) -> (f64, f64) {
        (Self::REFUSED, Self::REFUSED)
    }
}
