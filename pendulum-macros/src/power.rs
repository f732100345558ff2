//! Powers with whole exponents, the same whatever machine compiles: `f64::powi` isn't promised to be. Powers of two next to
//! a number, by its bits.

pub(crate) use pendulum_runtime::two_to;

/// xⁿ by squaring.
pub(crate) fn power(x: f64, n: i32) -> f64 {
    let magnitude = pendulum_runtime::power(x, n.abs());
    if n < 0 { 1.0 / magnitude } else { magnitude }
}

/// The largest e for which 2ᵉ ≤ |x|, of a normal number.
pub(crate) fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

/// The power of two at which the binade of x ≥ 0 begins; of numbers below all normal ones 0.
pub(crate) fn binade(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & (0x7ff << 52))
}

/// Whether x is ±2ᵉ, a normal number.
pub(crate) fn is_power_of_two(x: f64) -> bool {
    x.to_bits() & ((1 << 52) - 1) == 0 && x.is_normal()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers() {
        assert_eq!([power(3.0, 5), power(-0.5, 3), power(7.0, 0), power(4.0, -2)], [243.0, -0.125, 1.0, 0.0625]);
    }

    #[test]
    fn powers_of_two_next_to_a_number() {
        for (x, known) in [(1.0, 0), (1.99, 0), (2.0, 1), (0.5, -1), (-4.0, 2)] {
            assert_eq!(exponent(x), known);
        }
        assert_eq!([binade(1.99), binade(2.0), binade(f64::MIN_POSITIVE / 2.0)], [1.0, 2.0, 0.0]);
        for (x, is) in [(1.0, true), (0.125, true), (1.5, false), (0.0, false), (f64::INFINITY, false), (3.0, false)] {
            assert_eq!(is_power_of_two(x), is, "{x}");
        }
    }
}
