//! A reduction as operations.

use super::{Mirror, Origin, Phase, Reduction, Scheme, is_half};
use crate::parse::Float;
use crate::plan::variables::clamp;
use crate::program::{Builder, Id, Op};
use pendulum_runtime::double::Double;

impl Reduction {
    /// Emits the reduction.
    pub(crate) fn lower(&self, b: &mut Builder, t: Id) -> Phase {
        let t = if self.mirror == Mirror::Magnitude { b.push(Op::Abs(t)) } else { t };
        let t = self.capped(b, t);
        let phase = match &self.scheme {
            Scheme::OneWord { rate } => self.direct(b, t, *rate),
            Scheme::Scaled { rate, scaled, anchor } => self.scaled(b, t, [*rate, *scaled, *anchor]),
            Scheme::CodyWaite { rate, words } => self.cody_waite(b, t, *rate, words),
            Scheme::Wide { rate } => {
                let wide = b.convert(t, Float::F64);
                self.direct(b, wide, *rate)
            }
            Scheme::WideAnyTime { words } => {
                let wide = b.convert(t, Float::F64);
                self.wide_any_time(b, wide, words)
            }
            Scheme::AnyTime { words, doubled } => self.any_time(b, t, words, *doubled),
            Scheme::Time { .. } => self.unreduced(b, t),
            Scheme::Linear { rate, passed, times, .. } => {
                let time = unless_infinite(b, t, t);
                b.name(time, "time");
                let wide = b.convert(time, Float::F64);
                linear(b, wide, [*times, *rate], *passed)
            }
        };
        let remainder = b.convert(phase.remainder, self.float);
        let name = if self.counts_pieces() { "apart" } else { self.origin.phase() };
        Phase { remainder: b.name(remainder, name), ..phase }
    }

    /// `t` within ±cap, and infinite times NaN.
    fn capped(&self, b: &mut Builder, t: Id) -> Id {
        let Some(cap) = self.cap else { return t };
        let capped = clamp(b, t, cap);
        let capped = unless_infinite(b, capped, t);
        b.name(capped, "time")
    }

    /// What is added of the phase of t = 0: all but what is counted.
    fn offset(&self) -> Double {
        self.nearest_offset() - Double::new(self.counted())
    }

    /// Phase of t = 0 from the origin nearest to it: where t is small nothing of it is lost.
    fn nearest_offset(&self) -> Double {
        let offset = self.whole_offset();
        if self.is_linear() { offset } else { offset - Double::new(offset.hi.round_ties_even()) }
    }

    /// A half is a number of pieces: part of the constant that rounds, it costs nothing.
    fn counted(&self) -> f64 {
        let offset = self.nearest_offset();
        if self.counts_pieces() && is_half(offset) { offset.hi } else { 0.0 }
    }

    /// Phase of t = 0 from the origin numbered 0.
    fn whole_offset(&self) -> Double {
        match (&self.scheme, self.origin) {
            (Scheme::Linear { .. }, _) | (_, Origin::Anchor) => self.launch,
            (_, Origin::Lowest) => self.launch - Double::new(0.5),
        }
    }

    /// The number of the origin nearest to t = 0.
    pub(super) fn first_number(&self) -> f64 {
        self.whole_offset().hi.round_ties_even()
    }

    /// The magic sum of x + offset, and the nearest integer.
    fn round(&self, b: &mut Builder, t: Id, x: Id) -> (Id, Id) {
        let x = b.offset(x, self.offset() * self.scale);
        let constant = (b.float().magic() / self.pieces + self.counted()) * self.scale;
        let constant = self.mirrored(b, t, constant);
        let magic = b.add(x, constant);
        b.name(magic, "magic");
        let n = b.sub(magic, constant);
        (magic, b.name(n, "n"))
    }

    /// A constant that rounds, with the sign of the time where that mirrors.
    fn mirrored(&self, b: &mut Builder, t: Id, constant: f64) -> Id {
        let magnitude = b.constant(constant);
        if self.mirror != Mirror::Sign {
            return magnitude;
        }
        let constant = b.push(Op::CopySign { magnitude, sign: t });
        b.name(constant, "rounder")
    }

    /// The phase, origins counted from the one numbered 0; pieces from the lowest point after it.
    fn numbered(&self, b: &mut Builder, remainder: Id, magic: Id, count: Id) -> Phase {
        let first = self.first_number();
        let from_lowest = if self.counts_pieces() { self.counted() - 0.5 } else { 0.0 };
        let magic = b.offset(magic, Double::new(first * self.scale));
        let count = b.offset(count, Double::new((first + from_lowest) * self.scale));
        if self.scale == 1.0 {
            return Phase { remainder, magic, count };
        }
        let scale = b.constant(1.0 / self.scale);
        Phase { remainder, magic, count: b.mul(count, scale) }
    }

    fn direct(&self, b: &mut Builder, t: Id, rate: f64) -> Phase {
        let rate = b.constant(rate * self.scale);
        let x = b.mul(t, rate);
        b.name(x, "x");
        let (magic, n) = self.round(b, t, x);
        let remainder = self.less(b, &[x], n);
        self.numbered(b, remainder, magic, n)
    }

    fn scaled(&self, b: &mut Builder, t: Id, [rate, scaled, anchor]: [f64; 3]) -> Phase {
        let factors = [rate * self.scale, scaled * self.scale, anchor];
        let [rate, scaled, anchor] = factors.map(|factor| b.constant(factor));
        let x = b.mul(t, rate);
        let (magic, count) = self.round(b, t, x);
        let (distance, whole) = (b.mul(t, scaled), b.mul(count, anchor));
        let remainder = b.sub(distance, whole);
        self.numbered(b, remainder, magic, count)
    }

    fn cody_waite(&self, b: &mut Builder, t: Id, rate: f64, words: &[f64]) -> Phase {
        let rate = b.constant(rate);
        let x = b.mul(t, rate);
        let (magic, count) = self.round(b, t, x);
        let mut n = count;
        // Of the offset, halves are added to n without rounding.
        let halves = (-2.0 * self.offset().hi).round_ties_even() * 0.5;
        let offset = (self.offset() + Double::new(halves)) / self.unit;
        if halves != 0.0 {
            let halves = b.constant(halves);
            n = b.add(n, halves);
        }
        let mut remainder = t;
        for &word in words.iter().filter(|&&word| word != 0.0) {
            let word = b.constant(word);
            let whole = b.mul(n, word);
            remainder = b.sub(remainder, whole);
        }
        let remainder = b.offset(remainder, offset);
        self.numbered(b, remainder, magic, count)
    }

    /// The products of the time and the words, the first modulo 8: n is rounded from their sum, and they are added to −n
    /// from the largest on.
    fn wide_any_time(&self, b: &mut Builder, t: Id, words: &[f64]) -> Phase {
        let product = |&word: &f64| {
            let word = b.constant(word);
            b.mul(t, word)
        };
        let mut parts: Vec<Id> = words.iter().map(product).collect();
        let (first, eights) = self.modulo_eight(b, t, parts[0]);
        parts[0] = first;
        let sum = sum_from_last(b, &parts);
        let (magic, n) = self.round(b, t, sum);
        let remainder = self.less(b, &parts, n);
        let count = b.add(eights, n);
        self.numbered(b, remainder, magic, count)
    }

    /// With t = head + tail (27 + 26 bits) and R = r₁ + r₂ + r₃ + r₄ (26, 25, 25 and 53 bits, to nearest), and e the
    /// sum of the exponents of t and R: head·r₁ is exact; tail·r₁ + head·r₂ is a multiple of 2^(e−77) below 2^(e−24),
    /// hence exact; tail·r₂ + head·r₃ is a multiple of 2^(e−103) below 2^(e−50), hence exact; the rest is below
    /// 2^(e−75). The first is taken modulo 8, exactly, and the sum of the first three rounded to n, below 2³⁰ and off
    /// by at most 2⁻²². The first less n is exact, and with the second a multiple of 2^(e−77) again of a few anchors:
    /// so only the sums with the last two parts are rounded. Without a launch each sum is rounded relative to its result,
    /// if at all: the first if that is above a quarter, where then the last is nothing beside it. With fewer words the last
    /// is all the rest, and its product with t, rounded, a term of the last part.
    fn any_time(&self, b: &mut Builder, t: Id, words: &[f64], doubled: bool) -> Phase {
        const NAMES: [&str; 4] = ["first", "second", "third", "fourth"];
        let words: Vec<Id> = words.iter().map(|&word| b.constant(word * self.scale)).collect();
        let head = b.push(Op::Head(t));
        b.name(head, "head");
        let tail = b.sub(t, head);
        b.name(tail, "tail");
        let first = b.mul(head, words[0]);
        let (first, eights) = self.modulo_eight(b, t, first);
        let mut parts = vec![b.name(first, NAMES[0])];
        for index in 1..words.len() {
            let with = if index + 1 < words.len() { head } else { t };
            let part = cross(b, (with, words[index]), (tail, words[index - 1]));
            parts.push(b.name(part, NAMES[index]));
        }
        let (leading, last) = parts.split_at(parts.len().min(3));
        let sum = sum_from_last(b, leading);
        let (magic, n) = self.round(b, t, sum);
        let count = b.add(eights, n);
        let remainder = match last {
            // Fewer than four parts are wrong by more than their sums.
            [] => self.less(b, leading, n),
            &[last, ..] if is_half(self.offset()) => {
                let sum = self.less(b, leading, n);
                b.add(sum, last)
            }
            &[last, ..] if doubled => self.launched_in_two_words(b, n, leading, last),
            &[last, ..] => self.launched(b, n, leading, last),
        };
        self.numbered(b, remainder, magic, count)
    }

    /// The parts and the offset, less n. Of the offset a multiple of 2⁻²³ is added to −n and the first part, without
    /// rounding but for times of a few anchors, and what is left, below 2⁻²⁴, to the last part. Each sum is rounded relative
    /// to its result.
    fn launched(&self, b: &mut Builder, n: Id, leading: &[Id], last: Id) -> Id {
        const PARTS: f64 = (1 << 23) as f64;
        let offset = self.offset();
        let coarse = (offset.hi * PARTS).round_ties_even() / PARTS;
        let fine = (offset - Double::new(coarse)).hi;
        let [coarse, fine] = [coarse, fine].map(|part| b.constant(part * self.scale));
        let (start, last) = (b.sub(coarse, n), b.add(last, fine));
        let sum = leading.iter().fold(start, |sum, &part| b.add(sum, part));
        b.add(sum, last)
    }

    /// The same with sums in two words; from the lowest point also that with n, beside which a first part below a half may
    /// be the longer number (Dekker's sum, whose larger operand is n wherever it is rounded: by up to 2⁻⁵⁴, which from an
    /// anchor is part of the error).
    fn launched_in_two_words(&self, b: &mut Builder, n: Id, leading: &[Id], last: Id) -> Id {
        let offset = self.offset() * self.scale;
        let (head, low) = (b.constant(offset.hi), b.constant(offset.lo));
        let (mut sum, mut lost) = (b.sub(leading[0], n), b.add(last, low));
        if self.origin == Origin::Lowest {
            let taken = b.add(sum, n);
            let error = b.sub(leading[0], taken);
            lost = b.add(lost, error);
        }
        for &part in leading[1..].iter().chain([&head]) {
            let (next, error) = b.two_sum(sum, part);
            (sum, lost) = (next, b.add(lost, error));
        }
        b.add(sum, lost)
    }

    /// The sum of the parts and the offset, less n. Where the offset is a half, it is taken from n, without rounding:
    /// the first part less n alone may be longer than that part.
    fn less(&self, b: &mut Builder, parts: &[Id], n: Id) -> Id {
        let offset = self.offset();
        let (before, after) = if is_half(offset) { (offset, Double::ZERO) } else { (Double::ZERO, offset) };
        let n = b.offset(n, -before * self.scale);
        let rest = b.sub(parts[0], n);
        let rest = parts[1..].iter().fold(rest, |rest, &part| b.add(rest, part));
        b.offset(rest, after * self.scale)
    }

    /// x less the nearest multiple of 8, exactly, for |x| ≤ 2⁵⁴, and that multiple: adding 1.5·2⁵⁵ rounds to one.
    fn modulo_eight(&self, b: &mut Builder, t: Id, x: Id) -> (Id, Id) {
        let constant = self.mirrored(b, t, 8.0 * Float::F64.magic() * self.scale);
        let sum = b.add(x, constant);
        let eights = b.sub(sum, constant);
        (b.sub(x, eights), eights)
    }

    fn unreduced(&self, b: &mut Builder, t: Id) -> Phase {
        let mut remainder = unless_infinite(b, t, t);
        if self.scale != 1.0 {
            let scale = b.constant(self.scale);
            remainder = b.mul(remainder, scale);
        }
        Phase { remainder, magic: t, count: t }
    }
}

/// `x`, but NaN where the time is infinite: there t − t is.
fn unless_infinite(b: &mut Builder, x: Id, t: Id) -> Id {
    let zero = b.sub(t, t);
    b.add(x, zero)
}

/// Next to t₀ the first difference is exact (Sterbenz), and elsewhere, as the second is, rounded by a part of itself.
fn linear(b: &mut Builder, t: Id, [times, rate]: [f64; 2], passed: Double) -> Phase {
    let [times, rate] = [times, rate].map(|factor| b.constant(factor));
    let time = b.mul(t, times);
    let words = [passed.hi, passed.lo].into_iter().filter(|&word| word != 0.0);
    let from_lowest = words.fold(time, |rest, word| {
        let word = b.constant(word);
        b.sub(rest, word)
    });
    Phase { remainder: b.mul(from_lowest, rate), magic: t, count: t }
}

/// The sum of parts of which the first is there last.
fn sum_from_last(b: &mut Builder, parts: &[Id]) -> Id {
    parts.iter().copied().rev().reduce(|sum, part| b.add(sum, part)).expect("a part")
}

/// a·b + c·d.
fn cross(b: &mut Builder, left: (Id, Id), right: (Id, Id)) -> Id {
    let left = b.mul(left.0, left.1);
    let right = b.mul(right.0, right.1);
    b.add(left, right)
}
