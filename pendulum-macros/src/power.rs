//! Powers with whole exponents, the same whatever machine compiles: `f64::powi` isn't promised to be.

/// xⁿ by squaring.
pub(crate) fn power(x: f64, n: i32) -> f64 {
    let magnitude = pendulum_runtime::power(x, n.abs());
    if n < 0 { 1.0 / magnitude } else { magnitude }
}

/// 2ⁿ exactly, as far as it is a number.
pub(crate) fn two_to(n: i32) -> f64 {
    libm::ldexp(1.0, n)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers() {
        assert_eq!([power(3.0, 5), power(-0.5, 3), power(7.0, 0), power(4.0, -2)], [243.0, -0.125, 1.0, 0.0625]);
        assert_eq!([two_to(0), two_to(-53), two_to(1022)], [1.0, f64::EPSILON / 2.0, 1.0 / f64::MIN_POSITIVE]);
        assert_eq!([two_to(-1074), two_to(-1075), two_to(1024)], [f64::from_bits(1), 0.0, f64::INFINITY]);
    }
}
