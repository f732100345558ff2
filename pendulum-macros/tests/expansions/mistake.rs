// What this expands to; written by src/snapshots.rs.
//
//     pub struct Wrong;
//     theta0 = 4, n = 0

///
pub struct Wrong;
#[allow(clippy::approx_constant, clippy::float_arithmetic, clippy::neg_multiply)]
impl Wrong {
    const REFUSED: f64 = {
        compile_error! {
            "`theta0 = 4` is 4.0 rad = 229.1831180523293°: released at rest, |θ0| must be less than π (180°); `theta0 = -2.2831853071795867` is the same position, and motion over the top starts with a `velocity0`; if degrees are meant, write `theta0 = 4deg`"
        }
        compile_error! {
            "`n = 0` is a series without terms: θ\u{302} needs `n = 1` or more"
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
    pub const COEFFICIENTS: [f64; 0usize] = [Self::REFUSED; 0usize];
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
