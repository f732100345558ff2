//! What generated code may call, and what the macro has to know of it. Not part of the public interface.

use crate::kernel::two_to;

/// √x for normal x > 0, within [`ROOT_ERROR`] units of rounding, by + − × and bits alone: loops over it vectorise,
/// which they don't over the hardware's instruction, and constants can be made of it.
///
/// r ≈ 1/√x from the exponent's half (the constant of *Quake III Arena*, 1999, in [`rootf`], its counterpart for `f64` by
/// Robertson 2012 here; relative error below 0.0344, as measured), then twice
/// r·(1 − e)^(−½) = r·(1 + e/2 + 3e²/8 + 5e³/16 + …), e = 1 − x·r²: after the first e is below 2·10⁻⁵, after the second
/// the series leaves 10⁻¹⁹.
#[inline]
#[must_use]
pub const fn root(x: f64) -> f64 {
    let r = f64::from_bits(0x5fe6_eb50_c7b5_37a9_u64.wrapping_sub(x.to_bits() >> 1));
    let r = nearer(x, r);
    let r = nearer(x, r);
    x * r
}

/// Bounds |[`root`] − √x|/√x, in units of 2⁻⁵³; that of [`rootf`] in units of 2⁻²⁴.
///
/// In the last step e is wrong by two units for its two products, the difference from 1 being exact, and r by half of
/// that; r is rounded by one more in its sum, and the product with x by another: three. Products with e, which is small,
/// add 10⁻⁴, and in single precision the series leaves 3e²/8, 0.003.
pub const ROOT_ERROR: f64 = 3.5;

/// From here to the least normal number [`root`] is within [`NEXT_TO_ZERO`] of 0, and [`rootf`] within
/// [`NEXT_TO_ZERO_SINGLE`]. Farther below neither is a number.
pub const LEAST_UNDER_ROOT: f64 = -0.2;

/// How near to 0 [`root`] is then.
pub const NEXT_TO_ZERO: f64 = two_to(-500);

/// How near [`rootf`] is.
pub const NEXT_TO_ZERO_SINGLE: f64 = two_to(-50);

const fn nearer(x: f64, r: f64) -> f64 {
    let e = 1.0 - x * r * r;
    r + r * (e * (0.5 + e * (0.375 + e * 0.3125)))
}

/// As [`root`]: the second step leaves 10⁻¹⁰.
#[inline]
#[must_use]
pub const fn rootf(x: f32) -> f32 {
    let r = f32::from_bits(0x5f37_59df_u32.wrapping_sub(x.to_bits() >> 1));
    let e = 1.0 - x * r * r;
    let r = r + r * (e * (0.5 + e * (0.375 + e * 0.3125)));
    let e = 1.0 - x * r * r;
    x * (r + r * (e * 0.5))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In exact arithmetic |root − √x| = |root² − x|/(root + √x).
    #[test]
    fn roots_by_arithmetic_keep_their_bound() {
        let mut x = 0.013_f64;
        let mut worst = [0.0_f64; 2];
        for i in 0..if cfg!(miri) { 2000 } else { 200_000 } {
            x = x * 1.37 % 3.9;
            let scaled = if i % 3 == 0 { x * 1e-200 } else { x };
            let s = root(scaled);
            let (p, e) = crate::double::two_prod(s, s);
            worst[0] = worst[0].max(((scaled - p) - e).abs() / (2.0 * scaled) / (0.5 * f64::EPSILON));
            let single = f64::from(x as f32);
            let s = f64::from(rootf(x as f32));
            worst[1] = worst[1].max((s * s - single).abs() / (2.0 * single) / f64::from(0.5 * f32::EPSILON));
        }
        assert!(worst.iter().all(|&worst| worst > 1.0 && worst < ROOT_ERROR), "{worst:?}");
        assert!(root(f64::NAN).is_nan() && rootf(f32::NAN).is_nan());
    }

    /// Where rounding takes what is under a root to 0 or below, or next to it.
    #[test]
    fn next_to_nothing_under_the_root() {
        const { assert!(NEXT_TO_ZERO < 1e-100 && NEXT_TO_ZERO_SINGLE < 1e-15) };
        let below = [-0.0, -f64::MIN_POSITIVE, -1e-200, -1e-17, -1e-3, -0.1, LEAST_UNDER_ROOT];
        let subnormal = (0..52).map(|bit| f64::from_bits(1 << bit));
        for x in below.into_iter().chain(subnormal) {
            assert!(root(x).abs() < NEXT_TO_ZERO, "{x:e}: {:e}", root(x));
        }
        let subnormal = (0..23).map(|bit| f32::from_bits(1 << bit));
        for x in below.map(|x| x as f32).into_iter().chain(subnormal) {
            assert!(f64::from(rootf(x).abs()) < NEXT_TO_ZERO_SINGLE, "{x:e}: {:e}", rootf(x));
        }
    }
}
