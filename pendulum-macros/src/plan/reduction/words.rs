//! Numbers as sums of words with few bits, whose products are exact.

use crate::exact::Real;
use crate::parse::Float;

/// `x` > 0 as a sum of `count` words rounded down, all but the last with at most `bits` bits: no word is negative, so that
/// overflow in their products can't meet with opposite signs.
pub(super) fn split_down(x: &Real, bits: i32, count: usize, float: Float) -> Vec<f64> {
    let mut rest = x.clone();
    let mut words = Vec::new();
    for index in 0..count {
        let nearest = rest.to_f64();
        // Truncation doesn't undo the rounding of a number just below one of few bits.
        let above = x.context().float(nearest).is_some_and(|exact| exact > rest);
        let head = if above { nearest.next_down() } else { nearest };
        let word = if index + 1 == count { float.round(head) } else { truncate(head, bits) };
        if let Some(exact) = x.context().float(word) {
            rest = rest - exact;
        }
        words.push(word);
    }
    words
}

/// `x` as a sum of words, all but the last rounded to nearest with the bits stated: each word's leading bit stands at
/// least that many places below the one before.
pub(super) fn split_near<const N: usize>(x: &Real, bits: &[i32]) -> [f64; N] {
    let mut rest = x.clone();
    let mut unit = 2f64.powi(exponent(x.to_f64()) + 1);
    let mut words = [0.0; N];
    for (index, word) in words.iter_mut().enumerate() {
        let head = rest.to_f64();
        *word = head;
        if let Some(&bits) = bits.get(index) {
            unit *= 2f64.powi(-bits);
            *word = (head / unit).round_ties_even() * unit;
        }
        if let Some(exact) = x.context().float(*word) {
            rest = rest - exact;
        }
    }
    words
}

pub(super) fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

fn truncate(x: f64, bits: i32) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    f64::from_bits(x.to_bits() & !((1u64 << (53 - bits)) - 1))
}
