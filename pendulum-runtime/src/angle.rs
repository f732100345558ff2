//! Any finite angle to [−π, π] in two words, by exact multiplication with 1/(2π) (Payne and Hanek 1983).

use crate::double::Double;
use crate::double_trig::supplement;

/// `angle`, within one and a half of `period` of 0, as a whole number of periods and a rest of at most half of one: decided
/// in two words, since the `f64` nearest to half a period may be on either side.
pub(crate) fn nearest_period(angle: Double, period: Double) -> (f64, Double) {
    if (angle.abs() - period.scale(0.5)).hi > 0.0 {
        let turn = angle.hi.signum();
        (turn, angle - period.scale(turn))
    } else {
        (0.0, angle)
    }
}

/// 1/(2π) after the binary point, most significant word first: enough for the largest `f64` and 200 guard bits.
const INVERSE_TURN_WORDS: [u64; 21] = [
    0x28be60db9391054a,
    0x7f09d5f47d4d3770,
    0x36d8a5664f10e410,
    0x7f9458eaf7aef158,
    0x6dc91b8e909374b8,
    0x01924bba82746487,
    0x3f877ac72c4a69cf,
    0xba208d7d4baed121,
    0x3a671c09ad17df90,
    0x4e64758e60d4ce7d,
    0x272117e2ef7e4a0e,
    0xc7fe25fff7816603,
    0xfbcbc462d6829b47,
    0xdb4d9fb3c9f2c26d,
    0xd3d18fd9a797fa8b,
    0x5d49eeb1faf97c5e,
    0xcf41ce7de294a4ba,
    0x9afed7ec47e35742,
    0x1580cc11bf1edaea,
    0xfc33ef0826bd0d87,
    0x6a78e45857b986c2,
];

/// An angle in [−π, π].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Angle {
    pub(crate) angle: Double,
    /// π − |angle|, known by itself: next to the top the difference would have lost its digits.
    pub(crate) from_top: Double,
}

/// θ less its nearest whole number of turns, for finite θ; relative error below 2⁻¹⁰⁰, of the distance from the top, too,
/// unless θ itself is in [−π, π], when the angle is exact.
pub(crate) fn reduce(theta: f64) -> Angle {
    if theta.abs() <= core::f64::consts::PI {
        let angle = Double::new(theta);
        return Angle { angle, from_top: supplement(angle.abs()) };
    }
    let bits = theta.abs().to_bits();
    let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
    let exponent = (bits >> 52) as i32 - 1075; // |θ| = mantissa · 2^exponent, exponent ≥ −51
    let [fraction, from_half] = fraction_of_turn(mantissa, exponent);
    let reduced = fraction * Double::TURN;
    let angle = if theta < 0.0 { -reduced } else { reduced };
    Angle { angle, from_top: from_half * Double::TURN }
}

/// mantissa · 2^exponent/(2π) modulo 1, in [−½, ½], and by how much its magnitude is below ½.
///
/// Bits of 1/(2π) above 2^−exponent give whole turns; of the rest four words are kept, so the product is off by less
/// than 2⁵³ · 2⁻²⁵⁶, while no `f64` comes nearer than 2⁻⁶² to a whole turn, or half of one.
fn fraction_of_turn(mantissa: u64, exponent: i32) -> [Double; 2] {
    let skip = exponent.max(0) as usize;
    let (word, bit) = (skip / 64, skip % 64);
    let mut product = [0_u64; 5]; // whole turns, then the fraction's four words
    let mut carry = 0_u128;
    for i in (0..4).rev() {
        let high = word_at(word + i) << bit;
        let low = if bit == 0 { 0 } else { word_at(word + i + 1) >> (64 - bit) };
        let p = u128::from(mantissa) * u128::from(high | low) + carry;
        product[i + 1] = p as u64;
        carry = p >> 64;
    }
    product[0] = carry as u64;
    let shift = (-exponent).max(0) as u32;
    let mut fraction = [0_u64; 4];
    for i in 0..4 {
        let above = if shift == 0 { 0 } else { product[i] << (64 - shift) };
        fraction[i] = (product[i + 1] >> shift) | above;
    }
    let negative = fraction[0] >> 63 == 1;
    if negative {
        fraction = fraction.map(|w| !w); // one unit of 2⁻²⁵⁶ too small, far below the error allowed
    }
    let magnitude = words_to_double(fraction);
    // 2²⁵⁵ less the fraction, in units of 2⁻²⁵⁶, but for one unit.
    let mut from_half = fraction.map(|w| !w);
    from_half[0] &= u64::MAX >> 1;
    [if negative { -magnitude } else { magnitude }, words_to_double(from_half)]
}

/// A word of 1/(2π); zero beyond the table, which the largest `f64` does not reach.
fn word_at(i: usize) -> u64 {
    INVERSE_TURN_WORDS.get(i).copied().unwrap_or(0)
}

/// Σ wordᵢ · 2^(−64(i+1)); each half of a word converts exactly.
fn words_to_double(words: [u64; 4]) -> Double {
    let mut sum = Double::ZERO;
    let mut weight = 1.0;
    for w in words {
        for half in [w >> 32, w & 0xffff_ffff] {
            weight *= 1.0 / 4_294_967_296.0;
            sum = sum + Double::new(half as f64 * weight);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::double::relative_error;
    use crate::kernel::two_to;

    /// Expected values by mpmath with 400 digits; the fourth is the `f64` nearest to an odd multiple of π/2.
    #[test]
    fn whole_turns_vanish_exactly() {
        let cases = [
            (4.0, Double { hi: -2.2831853071795867, lo: 1.9915985002059197e-16 }),
            (-100.0, Double { hi: 0.5309649148733836, lo: 3.308917108348227e-17 }),
            (9007199254740992.0, Double { hi: -2.1276428765770463, lo: -1.3415010681967913e-16 }),
            (5.319372648326541e+255, Double { hi: core::f64::consts::FRAC_PI_2, lo: 6.170105654979312e-17 }),
            (1e22, Double { hi: -1.020177392559087, lo: -6.921796134051515e-17 }),
            (f64::MAX, Double { hi: 3.136630678439006, lo: -1.4938518789367579e-16 }),
        ];
        for (theta, expected) in cases {
            let error = relative_error(reduce(theta).angle, expected);
            assert!(error <= two_to(-100), "{theta:e}: {error:e}");
            assert_eq!(reduce(-theta).angle, -reduce(theta).angle);
        }
    }

    /// π − |θ| by mpmath with 400 digits: next to 3π, by 10⁻⁹ and as near as floats come, and the `f64` nearest to any odd
    /// multiple of π.
    #[test]
    fn distances_from_the_top() {
        for (theta, expected) in [
            (9.42477796076938, Double { hi: 3.6739403974420594e-16, lo: 1.56675938590016e-32 }),
            (9.424777959769379, Double { hi: 1.0000004501344106e-09, lo: 9.867754161794555e-26 }),
            (91.106186954104, Double { hi: 1.2379612731767154e-18, lo: -1.1116010032489888e-35 }),
            (-91.10618695410403, Double { hi: 2.842294739167718e-14, lo: 1.3933991987541326e-30 }),
            (1.0638745296733083e256, Double { hi: 0.4395109917533012, lo: -9.5944431011885e-18 }),
            (4.0, Double { hi: 0.8584073464102068, lo: -1.1442377452219664e-17 }),
        ] {
            let error = relative_error(reduce(theta).from_top, expected);
            assert!(error <= two_to(-100), "{theta:e}: {error:e}");
            assert_eq!(reduce(-theta).from_top, reduce(theta).from_top);
        }
    }

    #[test]
    fn angles_within_half_a_turn_stay() {
        for theta in [0.0, -0.0, 1e-310, -3.0, core::f64::consts::PI] {
            assert_eq!(reduce(theta).angle, Double::new(theta));
        }
    }
}
