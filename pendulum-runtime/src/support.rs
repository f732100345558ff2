//! What generated code may call. Not part of the public interface.

/// √x, correctly rounded (NaN for x < 0): the hardware instruction where there is one, the same bits everywhere.
#[inline]
#[must_use]
pub fn sqrt(x: f64) -> f64 {
    libm::sqrt(x)
}

/// √x, correctly rounded (NaN for x < 0): the hardware instruction where there is one, the same bits everywhere.
#[inline]
#[must_use]
pub fn sqrtf(x: f32) -> f32 {
    libm::sqrtf(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// s is the correctly rounded root when x lies between the squares of the midpoints about s.
    #[test]
    fn roots_are_correctly_rounded() {
        let mut x = 0.013_f64;
        for _ in 0..1000 {
            x = x * 1.37 % 3.9;
            let (s, single) = (sqrt(x), sqrtf(x as f32));
            let (p, e) = crate::double::two_prod(s, s);
            let ulp = s.next_up() - s;
            assert!(((x - p) - e).abs() <= s * ulp * (1.0 + 1e-15));
            // In f64 the root of an f32 is exact enough to be rounded again.
            assert_eq!(single, sqrt(f64::from(x as f32)) as f32);
        }
        assert!(sqrt(-1.0).is_nan() && sqrtf(-1.0).is_nan());
        assert_eq!((sqrt(-0.0).to_bits(), sqrt(f64::INFINITY)), ((-0.0_f64).to_bits(), f64::INFINITY));
        assert_eq!(sqrt(5e-324), 2.2227587494850775e-162);
    }
}
