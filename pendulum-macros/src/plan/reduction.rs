//! Phase reduction: from the time to the phase between two anchors, where the motion is symmetric.
//!
//! An anchor is a turning point of a swing, or the top of a rotation; `rate` anchors are passed per unit of time, and
//! x = rate·t + launch counts them. A reduction computes either n = round(x), whose parity tells the sign of a swing, and
//! the remainder s = x − n, or n = round(x − ½) and z = x − n − ½, the phase from the lowest point, near which it is the
//! more accurate and the motion the fastest. |s| and |z| are at most ½ (plus `overshoot`), in units of `unit` anchors.
//!
//! Rounding is done by adding and subtracting 1.5·2⁵² (1.5·2²³), which leaves the integer in the sum's low bits. The
//! subtractions that follow are exact: their operands are multiples of the same unit and the result is no longer.

use crate::exact::Real;
use crate::parse::Float;
use crate::program::rounding::half_ulp;
use crate::program::{Builder, Id, Op};
use pendulum_runtime::double::Double;

/// How the phase is found, over which horizon, and how wrong it can be.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Reduction {
    pub(crate) method: Method,
    /// The type of time and result.
    pub(crate) float: Float,
    /// Anchors passed at t = 0.
    pub(crate) launch: Double,
    /// Where the reduced phase is zero.
    pub(crate) origin: Origin,
    /// |computed − true| of the phase over the horizon, in anchors, is at most `error` + `relative_error`·|phase|.
    pub(crate) error: f64,
    pub(crate) relative_error: f64,
    /// |s| exceeds ½ by at most this, in anchors.
    pub(crate) overshoot: f64,
    /// Anchors per unit of the reduced variable.
    pub(crate) unit: Double,
    /// Times beyond ±this are replaced by it, where the products would overflow.
    pub(crate) cap: Option<f64>,
}

/// The zero of the reduced phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Origin {
    /// An anchor: a turning point, the top.
    Anchor,
    /// Half-way between two anchors: the lowest point.
    Lowest,
}

/// The ways of reducing the phase, cheapest first.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Method {
    /// s = t·R − n with R in one word.
    OneWord { rate: f64 },
    /// s = t − n·T₁ − n·T₂ …, every nTᵢ but the last exact (Cody and Waite 1980); s is a time.
    CodyWaite { rate: f64, words: Vec<f64> },
    /// An `f32` time, R in one `f64` word.
    Wide { rate: f64 },
    /// An `f32` time, R in three `f64` words whose first two products are exact.
    WideAnyTime { words: [f64; 3] },
    /// An `f64` time, R in three or four words; all products that matter but the last are exact.
    AnyTime { words: Vec<f64> },
    /// z = t·R + launch, never reduced: the separatrix has one lowest point. R in three words where there is a launch.
    Linear { words: [f64; 3] },
}

/// The reduced phase in a program.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Phase {
    /// The remainder, of the program's float.
    pub(crate) remainder: Id,
    /// The sum whose lowest bit is the parity of n.
    pub(crate) magic: Id,
    /// The number n of anchors passed.
    pub(crate) count: Id,
}

/// The horizon when no `t_max` is given: 2⁵³ periods are 2⁵⁴ anchors.
const UNLIMITED: f64 = 18_014_398_509_481_984.0;

/// Farther than this from the lowest point, in units of 1/ω, the separatrix is at the top in any precision.
const LINEAR_HALF: f64 = 700.0;

/// What all reductions of one motion start from.
pub(crate) struct Clock<'a> {
    /// Anchors per unit of time.
    pub(crate) rate: &'a Real,
    pub(crate) launch: Double,
    pub(crate) t_max: Option<f64>,
    pub(crate) float: Float,
}

impl Clock<'_> {
    /// The greatest |t| promised.
    fn horizon(&self) -> f64 {
        self.t_max.unwrap_or_else(|| UNLIMITED / self.rate.to_f64()).min(f64::MAX)
    }

    /// Every reduction that is valid over the horizon.
    pub(crate) fn reductions(&self) -> Vec<Reduction> {
        use Origin::{Anchor, Lowest};
        let common = [self.one_word()];
        let cody_waite = [(2, Anchor), (3, Anchor), (2, Lowest), (3, Lowest)];
        let cody_waite = cody_waite.map(|(words, origin)| self.cody_waite(words, origin));
        let last = match self.float {
            Float::F64 => vec![self.any_time(3, Anchor), self.any_time(4, Anchor), self.any_time(4, Lowest)],
            Float::F32 => {
                vec![self.wide(Anchor), self.wide(Lowest), self.wide_any_time(Anchor), self.wide_any_time(Lowest)]
            }
        };
        let unsure = common.into_iter().chain(cody_waite).flatten();
        unsure.chain(last).filter(Reduction::is_useful).collect()
    }

    fn reduction(
        &self,
        method: Method,
        origin: Origin,
        [error, relative_error]: [f64; 2],
        overshoot: f64,
    ) -> Reduction {
        let cody_waite = matches!(method, Method::CodyWaite { .. });
        // Where a product can overflow: of `f32` times only that with a single `f32` word, the others being of `f64`.
        let (overflows, most) = match (self.float, &method) {
            (Float::F64, _) => (self.rate.to_f64() > 0.25, 2f64.powi(1000)),
            (Float::F32, Method::OneWord { .. }) => (self.rate.to_f64() > 1.0, 2f64.powi(120)),
            (Float::F32, _) => (false, 0.0),
        };
        // The launch phase is added in two words where there are any; zero and one half without rounding that matters.
        let exact =
            matches!(method, Method::AnyTime { .. }) || self.launch.lo == 0.0 && (2.0 * self.launch.hi).fract() == 0.0;
        let wide = matches!(method, Method::Wide { .. } | Method::WideAnyTime { .. });
        let added_in = if wide { Float::F64 } else { self.float };
        let launch_error = if exact { 0.0 } else { 2.0 * half_ulp(0.5, added_in) };
        Reduction {
            method,
            float: self.float,
            launch: self.launch,
            origin,
            error: error + launch_error,
            relative_error,
            overshoot,
            unit: if cody_waite { self.rate.to_double() } else { Double::ONE },
            cap: (overflows && !cody_waite).then(|| self.float.round(most / self.rate.to_f64().max(1.0))),
        }
    }

    /// |t|·|R − fl(R)| and the rounding of the product; the subtraction is exact.
    fn one_word(&self) -> Option<Reduction> {
        let anchors = self.horizon() * self.rate.to_f64();
        let rate = self.float.round(self.rate.to_f64());
        let drift = self.horizon() * self.off(&[rate]);
        (anchors < self.float.magic() / 8.0).then(|| {
            let error = drift + half_ulp(anchors * 1.001, self.float);
            self.reduction(Method::OneWord { rate }, Origin::Anchor, [error, 0.0], 0.0)
        })
    }

    /// With n < 2ᵏ anchors (half anchors) over the horizon and p bits a word, all words but the last have p − k bits.
    fn cody_waite(&self, count: usize, origin: Origin) -> Option<Reduction> {
        let anchors = (self.horizon() * self.rate.to_f64() + 1.0).max(2.0);
        let k = anchors.log2().floor() as i32 + 2;
        let p = self.float.bits();
        if k > 2 * p / 3 {
            return None;
        }
        let time = self.rate.context().integer(1) / self.rate;
        let words = split_down(&time, p - k, count, self.float);
        if words.iter().any(|w| *w != 0.0 && w.abs() < self.smallest_safe()) {
            return None;
        }
        let rate = self.float.round(self.rate.to_f64());
        let left = words.iter().fold(time, |rest, &word| rest - self.exact(word)).abs().to_f64();
        let last = words.last().copied().unwrap_or(0.0).abs();
        // The first difference is exact by Sterbenz's lemma, or as a multiple of t's unit within t's binade; only a time
        // next to half an anchor, where that is next to a power of two, escapes both.
        let half = 0.5 / rate;
        let crosses = exponent(half * (1.0 + 1e-6)) != exponent(half * (1.0 - 1e-6));
        let escape = f64::from(u8::from(crosses)) * half_ulp(half * 1.001, self.float);
        let drift = (anchors * left + half_ulp(anchors * last, self.float) + escape) * rate * 1.000_001;
        let errors = match origin {
            Origin::Anchor => [drift + half_ulp(half * 1.001, self.float) * rate, 0.0],
            Origin::Lowest => [drift, self.float.unit() * 1.001],
        };
        let overshoot = 4.0 * anchors * self.float.unit();
        Some(self.reduction(Method::CodyWaite { rate, words }, origin, errors, overshoot))
    }

    fn wide(&self, origin: Origin) -> Reduction {
        let rate = self.rate.to_f64();
        let anchors = self.horizon() * rate;
        let drift = self.horizon() * self.off(&[rate]) + half_ulp(anchors * 1.001, Float::F64);
        self.reduction(Method::Wide { rate }, origin, self.narrowed(drift, origin), 0.0)
    }

    /// The first two products are exact (24 + 29 bits); the sum of the second and third, below 2²⁶, is rounded to 2⁻²⁸.
    fn wide_any_time(&self, origin: Origin) -> Reduction {
        let words = split_down(self.rate, 29, 3, Float::F64);
        let method = Method::WideAnyTime { words: [words[0], words[1], words[2]] };
        self.reduction(method, origin, self.narrowed(2f64.powi(-27), origin), 2f64.powi(-26))
    }

    /// The time of the separatrix, `rate` being ω and `launch` the phase ωt from the lowest point.
    pub(crate) fn linear(&self) -> Reduction {
        let words = if self.launch == Double::ZERO {
            [self.rate.to_f64(), 0.0, 0.0]
        } else {
            let [r1, r2, r3] = split_near(self.rate, &[26, 26]);
            [r1, r2, r3]
        };
        let launch = self.launch.hi.abs();
        let relative = if self.float == Float::F64 { 3.001 } else { 1.001 } * self.float.unit();
        Reduction {
            method: Method::Linear { words },
            float: self.float,
            launch: self.launch,
            origin: Origin::Lowest,
            error: (launch + 1.0) * 2f64.powi(-74),
            relative_error: relative,
            overshoot: 0.0,
            unit: Double::ONE,
            cap: Some(2.0 * (LINEAR_HALF + launch) / self.rate.to_f64()).filter(|cap| cap.is_finite()),
        }
    }

    /// What the conversion of the phase to `f32` adds.
    fn narrowed(&self, error: f64, origin: Origin) -> [f64; 2] {
        match origin {
            Origin::Anchor => [error + half_ulp(0.49, Float::F32), 0.0],
            Origin::Lowest => [error, self.float.unit() * 1.001],
        }
    }

    /// Two roundings of sums, relative to the result, and the last word's product: of three words, below 16 anchors, it is
    /// rounded to 2⁻⁵⁰ and so is its sum with another. Where the third part isn't small beside the others (t beyond 2²⁵
    /// anchors), the first sum is exact.
    fn any_time(&self, count: usize, origin: Origin) -> Reduction {
        let words = split_near::<4>(self.rate, &[26, 25, 25][..count - 1])[..count].to_vec();
        let last = if count == 3 { 2f64.powi(-49) } else { 2f64.powi(-72) };
        let drift = self.horizon() * self.off(&words) + last;
        let errors = match origin {
            Origin::Anchor => [drift + 2f64.powi(-53), 0.0],
            Origin::Lowest => [drift, 2.001 * Float::F64.unit()],
        };
        self.reduction(Method::AnyTime { words }, origin, errors, 2f64.powi(-50))
    }

    fn exact(&self, x: f64) -> Real {
        self.rate.context().float(x).unwrap_or_else(|| self.rate.context().integer(0))
    }

    /// |R − Σ words|.
    fn off(&self, words: &[f64]) -> f64 {
        words.iter().fold(self.rate.clone(), |rest, &word| rest - self.exact(word)).abs().to_f64()
    }

    /// Words below this would lose bits to underflow in products.
    fn smallest_safe(&self) -> f64 {
        match self.float {
            Float::F64 => 1e-280,
            Float::F32 => 1e-30,
        }
    }
}

/// `x` > 0 as a sum of `count` words rounded down, all but the last with at most `bits` bits: no word is negative, so that
/// overflow in their products can't meet with opposite signs.
fn split_down(x: &Real, bits: i32, count: usize, float: Float) -> Vec<f64> {
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
fn split_near<const N: usize>(x: &Real, bits: &[i32]) -> [f64; N] {
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

fn exponent(x: f64) -> i32 {
    ((x.to_bits() >> 52) & 0x7ff) as i32 - 1023
}

fn truncate(x: f64, bits: i32) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    f64::from_bits(x.to_bits() & !((1u64 << (53 - bits)) - 1))
}

impl Reduction {
    /// Whether the phase is known at all at the end of the horizon.
    fn is_useful(&self) -> bool {
        self.error < 0.5 && self.half().is_finite()
    }

    /// The number of its operations.
    pub(crate) fn operations(&self) -> usize {
        let mut b = Builder::new(self.float);
        let t = b.input();
        let Phase { remainder, magic, .. } = self.lower(&mut b, t);
        b.finish(vec![remainder, magic]).operations()
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        let from = if self.origin == Origin::Lowest { " from the lowest point" } else { "" };
        let how = match &self.method {
            Method::OneWord { .. } => "one product with the rate".to_owned(),
            Method::CodyWaite { words, .. } => format!("Cody and Waite's remainder of {} words", words.len()),
            Method::Wide { .. } => "one product with the rate in `f64`".to_owned(),
            Method::WideAnyTime { .. } => "exact products with the rate in three words of `f64`".to_owned(),
            Method::AnyTime { words } => format!("exact products with the rate in {} words", words.len()),
            Method::Linear { .. } => "the time itself".to_owned(),
        };
        format!("{how}{from}")
    }

    /// The largest |s|, in units of the reduced variable, rounded up to a number of its type.
    pub(crate) fn half(&self) -> f64 {
        if matches!(self.method, Method::Linear { .. }) {
            return LINEAR_HALF;
        }
        if self.overshoot == 0.0 && self.unit == Double::ONE {
            return 0.5;
        }
        let half = (0.5 + self.overshoot) / self.unit.hi;
        self.float.round(half * (1.0 + 4.0 * self.float.unit()))
    }

    /// Emits the reduction.
    pub(crate) fn lower(&self, b: &mut Builder, t: Id) -> Phase {
        let t = self.capped(b, t);
        let phase = match &self.method {
            Method::OneWord { rate } => self.direct(b, t, *rate),
            Method::CodyWaite { rate, words } => self.cody_waite(b, t, *rate, words),
            Method::Wide { rate } => {
                let wide = b.convert(t, Float::F64);
                self.direct(b, wide, *rate)
            }
            Method::WideAnyTime { words } => {
                let wide = b.convert(t, Float::F64);
                self.wide_any_time(b, wide, words)
            }
            Method::AnyTime { words } => self.any_time(b, t, words),
            Method::Linear { words } => {
                let wide = b.convert(t, Float::F64);
                self.linear(b, wide, words)
            }
        };
        let remainder = b.convert(phase.remainder, self.float);
        let name = if self.origin == Origin::Anchor { "s" } else { "z" };
        Phase { remainder: b.name(remainder, name), ..phase }
    }

    /// `t` within ±cap, infinite times turned to NaN by t − t.
    fn capped(&self, b: &mut Builder, t: Id) -> Id {
        let Some(cap) = self.cap else { return t };
        let (most, least) = (b.constant(cap), b.constant(-cap));
        let zero = b.sub(t, t);
        let upper = b.push(Op::Min { limit: most, x: t });
        let both = b.push(Op::Max { limit: least, x: upper });
        let capped = b.add(both, zero);
        b.name(capped, "time")
    }

    /// Phase of t = 0 from the origin nearest to it: where t is small nothing of it is lost.
    fn offset(&self) -> Double {
        let offset = self.whole_offset();
        if matches!(self.method, Method::Linear { .. }) {
            offset
        } else {
            offset - Double::new(offset.hi.round_ties_even())
        }
    }

    /// Phase of t = 0 from the origin numbered 0.
    fn whole_offset(&self) -> Double {
        match (&self.method, self.origin) {
            (Method::Linear { .. }, _) | (_, Origin::Anchor) => self.launch,
            (_, Origin::Lowest) => self.launch - Double::new(0.5),
        }
    }

    /// The number of the origin nearest to t = 0.
    fn first_number(&self) -> f64 {
        self.whole_offset().hi.round_ties_even()
    }

    /// The magic sum of x + offset, and the nearest integer.
    fn round(&self, b: &mut Builder, x: Id) -> (Id, Id) {
        let x = offset_by(b, x, self.offset());
        let constant = b.float().magic();
        let constant = b.constant(constant);
        let magic = b.add(x, constant);
        b.name(magic, "magic");
        let n = b.sub(magic, constant);
        (magic, b.name(n, "n"))
    }

    /// The phase, origins counted from the one numbered 0.
    fn numbered(&self, b: &mut Builder, remainder: Id, magic: Id, count: Id) -> Phase {
        let first = self.first_number();
        if first == 0.0 {
            return Phase { remainder, magic, count };
        }
        let first = b.constant(first);
        Phase { remainder, magic: b.add(magic, first), count: b.add(count, first) }
    }

    fn direct(&self, b: &mut Builder, t: Id, rate: f64) -> Phase {
        let rate = b.constant(rate);
        let x = b.mul(t, rate);
        b.name(x, "x");
        let (magic, n) = self.round(b, x);
        let rest = b.sub(x, n);
        let remainder = offset_by(b, rest, self.offset());
        self.numbered(b, remainder, magic, n)
    }

    fn cody_waite(&self, b: &mut Builder, t: Id, rate: f64, words: &[f64]) -> Phase {
        let rate = b.constant(rate);
        let x = b.mul(t, rate);
        let (magic, count) = self.round(b, x);
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
        let remainder = offset_by(b, remainder, offset);
        self.numbered(b, remainder, magic, count)
    }

    fn wide_any_time(&self, b: &mut Builder, t: Id, words: &[f64; 3]) -> Phase {
        let [first, second, third] = words.map(|word| {
            let word = b.constant(word);
            b.mul(t, word)
        });
        let (first, eights) = modulo_eight(b, first);
        let low = b.add(second, third);
        let sum = b.add(first, low);
        let (magic, n) = self.round(b, sum);
        let rest = b.sub(first, n);
        let rest = offset_by(b, rest, self.offset());
        let count = b.add(eights, n);
        let remainder = b.add(rest, low);
        self.numbered(b, remainder, magic, count)
    }

    /// With t = head + tail (27 + 26 bits) and R = r₁ + r₂ + r₃ + r₄ (26, 25, 25 and 53 bits, to nearest), and e the sum of
    /// the exponents of t and R: head·r₁ is exact; tail·r₁ + head·r₂ is a multiple of 2^(e−77) below 2^(e−24), hence
    /// exact; tail·r₂ + head·r₃ is a multiple of 2^(e−103) below 2^(e−50), hence exact; the rest is below 2^(e−75).
    /// The first two are taken modulo 8, exactly; only the sums of the four parts are rounded.
    /// With three words the third is all the rest, and its product with t the last part.
    fn any_time(&self, b: &mut Builder, t: Id, words: &[f64]) -> Phase {
        let words: Vec<Id> = words.iter().map(|&word| b.constant(word)).collect();
        let (r1, r2, r3) = (words[0], words[1], words[2]);
        let head = b.push(Op::Head(t));
        b.name(head, "head");
        let tail = b.sub(t, head);
        b.name(tail, "tail");
        let first = b.mul(head, r1);
        let (first, many) = modulo_eight(b, first);
        b.name(first, "first");
        let second = cross(b, (tail, r1), (head, r2));
        let (second, some) = modulo_eight(b, second);
        b.name(second, "second");
        let third = cross(b, (tail, r2), (if words.len() > 3 { head } else { t }, r3));
        b.name(third, "third");
        let fourth = words.get(3).map(|&r4| {
            let fourth = cross(b, (tail, r3), (t, r4));
            b.name(fourth, "fourth")
        });
        let leading = b.add(first, second);
        let sum = b.add(leading, third);
        let (magic, n) = self.round(b, sum);
        let rest = b.sub(first, n);
        let eights = b.add(many, some);
        let count = b.add(eights, n);
        let remainder = self.sum_of_parts(b, [rest, second, third], fourth);
        self.numbered(b, remainder, magic, count)
    }

    /// The four parts and the offset. Without a launch the offset is nought or a half: as long as the third part isn't
    /// small, all sums but the last are exact. With one they are done in two words.
    fn sum_of_parts(&self, b: &mut Builder, [rest, second, third]: [Id; 3], fourth: Option<Id>) -> Id {
        let offset = self.offset();
        if offset.lo == 0.0 && (2.0 * offset.hi).fract() == 0.0 {
            let rest = offset_by(b, rest, offset);
            let sum = b.add(rest, second);
            let sum = b.add(sum, third);
            return fourth.map_or(sum, |fourth| b.add(sum, fourth));
        }
        let (head, low) = (b.exact(offset.hi, 0.0), b.constant(offset.lo));
        let (mut sum, mut lost) = (rest, fourth.map_or(low, |fourth| b.add(fourth, low)));
        for part in [second, third, head] {
            let (next, error) = b.two_sum(sum, part);
            (sum, lost) = (next, b.add(lost, error));
        }
        b.add(sum, lost)
    }

    /// Without a launch the product's rounding is relative to itself. With one, near the lowest point, the product has to
    /// be exact where the launch cancels it: t in 27 + 26 bits, R in 26 + 26 and the rest.
    fn linear(&self, b: &mut Builder, t: Id, words: &[f64; 3]) -> Phase {
        let [r1, r2, r3] = words.map(|word| b.constant(word));
        if self.launch == Double::ZERO {
            let remainder = b.mul(t, r1);
            return Phase { remainder, magic: t, count: t };
        }
        let head = b.push(Op::Head(t));
        b.name(head, "head");
        let tail = b.sub(t, head);
        b.name(tail, "tail");
        let first = b.mul(head, r1);
        let second = cross(b, (tail, r1), (head, r2));
        let third = cross(b, (tail, r2), (t, r3));
        let (launch, rest) = (b.exact(self.launch.hi, 0.0), b.constant(self.launch.lo));
        let (sum, lost) = b.two_sum(first, launch);
        let (sum, lost_too) = b.two_sum(sum, second);
        let low = b.add(lost, lost_too);
        let third = b.add(third, rest);
        let low = b.add(low, third);
        Phase { remainder: b.add(sum, low), magic: t, count: t }
    }
}

/// x + offset, if there is any.
fn offset_by(b: &mut Builder, x: Id, offset: Double) -> Id {
    if offset == Double::ZERO {
        return x;
    }
    let offset = b.exact(offset.hi, offset.lo);
    b.add(x, offset)
}

/// a·b + c·d.
fn cross(b: &mut Builder, left: (Id, Id), right: (Id, Id)) -> Id {
    let left = b.mul(left.0, left.1);
    let right = b.mul(right.0, right.1);
    b.add(left, right)
}

/// x less the nearest multiple of 8, exactly, for |x| ≤ 2⁵⁴, and that multiple: adding 1.5·2⁵⁵ rounds to one.
fn modulo_eight(b: &mut Builder, x: Id) -> (Id, Id) {
    let constant = b.constant(8.0 * Float::F64.magic());
    let sum = b.add(x, constant);
    let eights = b.sub(sum, constant);
    (b.sub(x, eights), eights)
}
