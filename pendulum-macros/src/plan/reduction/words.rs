//! Numbers as sums of words with few bits, whose products are exact.

use crate::exact::Real;
use crate::parse::Float;
use crate::power::{exponent, two_to};

/// `x` > 0 as a sum of `count` words rounded down, all but the last with at most `bits` bits: no word is negative, so
/// that overflow in their products can't meet with opposite signs.
pub(super) fn split_down(x: &Real, bits: i32, count: usize, float: Float) -> Vec<f64> {
    let mut rest = x.clone();
    let mut words = Vec::new();
    for index in 0..count {
        // Truncation doesn't undo the rounding of a number just below one of few bits.
        let head = rest.to_f64_below();
        let word = if index + 1 == count { float.round(head) } else { truncate(head, bits) };
        if let Some(exact) = x.context().float(word) {
            rest = rest - exact;
        }
        words.push(word);
    }
    words
}

/// `x` as a sum of words, all but the last rounded to nearest with the bits stated, the last, one more, with all it has:
/// each word's leading bit stands at least that many places below the one before.
pub(super) fn split_near(x: &Real, bits: &[i32]) -> Vec<f64> {
    let mut rest = x.clone();
    let mut unit = two_to(exponent(x.to_f64()) + 1);
    let mut words = vec![0.0; bits.len() + 1];
    for (index, word) in words.iter_mut().enumerate() {
        let head = rest.to_f64();
        *word = head;
        unit *= bits.get(index).map_or(1.0, |&bits| two_to(-bits));
        // Of a unit that underflows all floats are multiples.
        if index < bits.len() && unit > 0.0 {
            *word = (head / unit).round_ties_even() * unit;
        }
        if let Some(exact) = x.context().float(*word) {
            rest = rest - exact;
        }
    }
    words
}

fn truncate(x: f64, bits: i32) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    f64::from_bits(x.to_bits() & !((1u64 << (53 - bits)) - 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Context;

    /// Words rounded down are never negative, have few bits, and leave less than the last one's unit.
    #[test]
    fn words_rounded_down() {
        let context = Context::for_digits(60);
        // Just below, on and just above numbers of few bits.
        for text in
            ["0.9999999999999999999999999", "1.0000000000000000000000001", "1.25", "0.7853981633974483096156608"]
        {
            let x = context.decimal(text).unwrap();
            for (bits, count) in [(20, 3), (39, 2), (26, 4)] {
                let words = split_down(&x, bits, count, Float::F64);
                assert_eq!(words.len(), count);
                let mut rest = x.clone();
                for (index, &word) in words.iter().enumerate() {
                    assert!(word >= 0.0, "{text}: {words:?}");
                    let last = index + 1 == count;
                    assert!(
                        last || word == 0.0 || word.to_bits().trailing_zeros() >= 53 - bits as u32,
                        "{text}: {words:?}"
                    );
                    rest = rest - context.float(word).unwrap();
                    assert!(!rest.is_negative(), "{text}: {words:?}");
                    // All but its last bits are used.
                    let unit = if last { 53 } else { bits };
                    assert!(rest.to_f64() <= word * 2f64.powi(1 - unit) || word == 0.0, "{text} {index}: {words:?}");
                }
            }
        }
        // What one word holds leaves nothing to the next.
        assert_eq!(split_down(&context.decimal("1.25").unwrap(), 20, 3, Float::F64), [1.25, 0.0, 0.0]);
        let x = context.decimal("0.7853981633974483096156608").unwrap();
        assert!(split_down(&x, 12, 2, Float::F32).iter().all(|&word| f64::from(word as f32) == word));
    }

    /// Words to nearest: each is off by half of its unit at most, which is so many bits below the one before.
    #[test]
    fn words_to_nearest() {
        let context = Context::for_digits(60);
        for text in ["0.9999999999999999999999999", "1.0000000000000000000000001", "3.0", "0.7853981633974483096156608"]
        {
            let x = context.decimal(text).unwrap();
            let words = split_near(&x, &[26, 25, 25]);
            let mut rest = x.clone();
            let mut unit = 2f64.powi(exponent(x.to_f64()) + 1);
            for (word, bits) in words.iter().zip([26, 25, 25, 53]) {
                unit *= 2f64.powi(-bits);
                rest = rest - context.float(*word).unwrap();
                if bits < 53 {
                    assert_eq!((word / unit).fract(), 0.0, "{text}: {words:?}");
                    assert!(rest.abs().to_f64() <= 0.5 * unit, "{text}: {words:?}");
                }
            }
            assert!(rest.abs().to_f64() <= words[3].abs() * 2f64.powi(-53), "{text}: {words:?}");
        }
    }
}
