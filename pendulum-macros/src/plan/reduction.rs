//! Phase reduction: from the time to the phase between two anchors, where the motion is symmetric.
//!
//! An anchor is a turning point of a swing, or the top of a rotation; `rate` anchors are passed per unit of time, and
//! x = rate·t + launch counts them. Every reduction computes n = round(x), whose parity tells the sign of a swing, and
//! the remainder s = x − n with |s| ≤ ½ (plus `overshoot`), in units of `unit` anchors.
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
    /// |computed − true| of the phase, in anchors, over the horizon.
    pub(crate) error: f64,
    /// |s| exceeds ½ by at most this, in anchors.
    pub(crate) overshoot: f64,
    /// Whether what the rounding of s leaves is kept in a second word.
    pub(crate) two_words: bool,
    /// Anchors per unit of the reduced variable.
    pub(crate) unit: Double,
    /// Times beyond ±this are replaced by it, where the products would overflow.
    pub(crate) cap: Option<f64>,
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
    /// An `f64` time, R in four words; all products that matter are exact.
    AnyTime { words: [f64; 4] },
}

/// The reduced phase in a program.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Phase {
    /// The remainder; `f64` if a second word is kept, else of the program's float.
    pub(crate) s: Id,
    /// What its rounding left, if that is kept (never for `f32`, whose phase is then left wide).
    pub(crate) low: Option<Id>,
    /// The sum whose lowest bit is the parity of n.
    pub(crate) magic: Id,
}

/// The horizon when no `t_max` is given: 2⁵³ periods are 2⁵⁴ anchors.
const UNLIMITED: f64 = 18_014_398_509_481_984.0;

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

    /// Every reduction that is valid over the horizon, with and without a second word.
    pub(crate) fn reductions(&self) -> Vec<Reduction> {
        let candidates = match self.float {
            Float::F64 => vec![
                self.one_word(),
                self.cody_waite(2, false),
                self.cody_waite(3, false),
                self.cody_waite(2, true),
                self.cody_waite(3, true),
                Some(self.any_time(false)),
                Some(self.any_time(true)),
            ],
            Float::F32 => vec![
                self.one_word(),
                self.cody_waite(2, false),
                self.cody_waite(3, false),
                Some(self.wide(false)),
                Some(self.wide(true)),
                Some(self.wide_any_time(false)),
                Some(self.wide_any_time(true)),
            ],
        };
        candidates.into_iter().flatten().filter(Reduction::is_useful).collect()
    }

    fn reduction(&self, method: Method, two_words: bool, error: f64, overshoot: f64) -> Reduction {
        let overflows = self.float == Float::F64 && self.rate.to_f64() > 0.25;
        let cody_waite = matches!(method, Method::CodyWaite { .. });
        let launched = self.launch != Double::ZERO && !two_words;
        let launch_error = if launched { 2.0 * half_ulp(0.5, self.float) } else { 0.0 };
        Reduction {
            method,
            float: self.float,
            launch: self.launch,
            error: error + launch_error,
            overshoot,
            two_words,
            unit: if cody_waite { self.rate.to_double() } else { Double::ONE },
            cap: (overflows && !cody_waite).then(|| 2f64.powi(1000) / self.rate.to_f64().max(1.0)),
        }
    }

    /// |t|·|R − fl(R)| and the rounding of the product; the subtraction is exact.
    fn one_word(&self) -> Option<Reduction> {
        let anchors = self.horizon() * self.rate.to_f64();
        let rate = self.float.round(self.rate.to_f64());
        let drift = self.horizon() * self.off(&[rate]);
        (anchors < self.float.magic() / 8.0).then(|| {
            let error = drift + half_ulp(anchors * 1.001, self.float);
            self.reduction(Method::OneWord { rate }, false, error, 0.0)
        })
    }

    /// With n < 2ᵏ anchors over the horizon and p bits a word, all words but the last have p − k bits.
    fn cody_waite(&self, count: usize, two_words: bool) -> Option<Reduction> {
        let anchors = (self.horizon() * self.rate.to_f64() + 1.0).max(2.0);
        let k = anchors.log2().floor() as i32 + 1;
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
        let half = 0.5 / rate * (1.0 + 1e-6);
        // The first difference is exact by Sterbenz's lemma, or as a multiple of t's unit within t's binade; only a time
        // next to half an anchor, where that is next to a power of two, escapes both.
        let crosses = exponent(half) != exponent(0.5 / rate * (1.0 - 1e-6));
        let differences = f64::from(u8::from(crosses) + u8::from(!two_words)) * half_ulp(half, self.float);
        let drift = anchors * left + half_ulp(anchors * last, self.float) + differences;
        let overshoot = 4.0 * anchors * self.float.unit();
        Some(self.reduction(Method::CodyWaite { rate, words }, two_words, drift * rate * 1.000_001, overshoot))
    }

    fn wide(&self, two_words: bool) -> Reduction {
        let rate = self.rate.to_f64();
        let anchors = self.horizon() * rate;
        let drift = self.horizon() * self.off(&[rate]) + half_ulp(anchors * 1.001, Float::F64);
        self.reduction(Method::Wide { rate }, two_words, drift + narrowing(two_words), 0.0)
    }

    /// The first two products are exact (24 + 29 bits); the sum of the second and third, below 2²⁶, is rounded to 2⁻²⁸.
    fn wide_any_time(&self, two_words: bool) -> Reduction {
        let words = split_down(self.rate, 29, 3, Float::F64);
        let method = Method::WideAnyTime { words: [words[0], words[1], words[2]] };
        self.reduction(method, two_words, 2f64.powi(-27) + narrowing(two_words), 2f64.powi(-26))
    }

    /// Two roundings of sums near ½, unless they are kept in a second word, and the last word's product.
    fn any_time(&self, two_words: bool) -> Reduction {
        let words = split_near(self.rate, &[26, 25, 25]);
        let drift = self.horizon() * self.off(&words) + 2f64.powi(-72);
        let error = drift + if two_words { 0.0 } else { 2f64.powi(-53) };
        self.reduction(Method::AnyTime { words }, two_words, error, 2f64.powi(-50))
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
        let head = rest.to_f64();
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
        self.error < 0.5
    }

    /// The largest |s|, in units of the reduced variable, rounded up to a number of its type.
    pub(crate) fn half(&self) -> f64 {
        if self.overshoot == 0.0 && self.unit == Double::ONE {
            return 0.5;
        }
        let half = (0.5 + self.overshoot) / self.unit.hi;
        self.float.round(half * (1.0 + 4.0 * self.float.unit()))
    }

    /// Emits the reduction.
    pub(crate) fn lower(&self, b: &mut Builder, t: Id) -> Phase {
        let t = self.capped(b, t);
        match &self.method {
            Method::OneWord { rate } => self.direct(b, t, *rate),
            Method::CodyWaite { rate, words } => self.cody_waite(b, t, *rate, words),
            Method::Wide { rate } => {
                let wide = b.convert(t, Float::F64);
                let phase = self.direct(b, wide, *rate);
                self.narrow(b, phase)
            }
            Method::WideAnyTime { words } => {
                let wide = b.convert(t, Float::F64);
                let phase = self.wide_any_time(b, wide, words);
                self.narrow(b, phase)
            }
            Method::AnyTime { words } => self.any_time(b, t, words),
        }
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

    /// x + launch, where there is a launch phase.
    fn launched(&self, b: &mut Builder, x: Id) -> Id {
        if self.launch == Double::ZERO {
            return x;
        }
        let launch = b.exact(self.launch.hi, self.launch.lo);
        b.add(x, launch)
    }

    fn direct(&self, b: &mut Builder, t: Id, rate: f64) -> Phase {
        let rate = b.constant(rate);
        let x = b.mul(t, rate);
        b.name(x, "x");
        let counted = self.launched(b, x);
        let (magic, n) = round(b, counted);
        let rest = b.sub(x, n);
        let s = self.launched(b, rest);
        Phase { s: b.name(s, "s"), low: None, magic }
    }

    fn cody_waite(&self, b: &mut Builder, t: Id, rate: f64, words: &[f64]) -> Phase {
        let rate = b.constant(rate);
        let x = b.mul(t, rate);
        let counted = self.launched(b, x);
        let (magic, n) = round(b, counted);
        let (mut s, mut low) = (t, None);
        let words: Vec<f64> = words.iter().copied().filter(|&word| word != 0.0).collect();
        for (index, &word) in words.iter().enumerate() {
            let word = b.constant(word);
            let whole = b.mul(n, word);
            let rest = b.sub(s, whole);
            if self.two_words && index + 1 == words.len() {
                let seen = b.sub(s, rest);
                low = Some(b.sub(seen, whole));
            }
            s = rest;
        }
        if self.launch != Double::ZERO {
            let offset = self.launch / self.unit;
            if let Some(before) = low {
                let constant = b.exact(offset.hi, 0.0);
                let (sum, lost) = b.two_sum(s, constant);
                let rest = b.constant(offset.lo);
                let lost = b.add(lost, rest);
                (s, low) = (sum, Some(b.add(before, lost)));
            } else {
                let constant = b.exact(offset.hi, offset.lo);
                s = b.add(s, constant);
            }
        }
        Phase { s: b.name(s, "s"), low: low.map(|low| b.name(low, "low")), magic }
    }

    fn wide_any_time(&self, b: &mut Builder, t: Id, words: &[f64; 3]) -> Phase {
        let [first, second, third] = words.map(|word| {
            let word = b.constant(word);
            b.mul(t, word)
        });
        let first = modulo_eight(b, first);
        let low = b.add(second, third);
        let sum = b.add(first, low);
        let counted = self.launched(b, sum);
        let (magic, n) = round(b, counted);
        let rest = b.sub(first, n);
        let s = b.add(rest, low);
        let s = self.launched(b, s);
        Phase { s: b.name(s, "s"), low: None, magic }
    }

    /// With t = head + tail (27 + 26 bits) and R = r₁ + r₂ + r₃ + r₄ (26, 25, 25 and 53 bits, to nearest), and e the sum of
    /// the exponents of t and R: head·r₁ is exact; tail·r₁ + head·r₂ is a multiple of 2^(e−77) below 2^(e−24), hence
    /// exact; tail·r₂ + head·r₃ is a multiple of 2^(e−103) below 2^(e−50), hence exact; the rest is below 2^(e−75).
    /// The first two are taken modulo 8, exactly; only the sum of the four parts, near ½, is rounded.
    fn any_time(&self, b: &mut Builder, t: Id, words: &[f64; 4]) -> Phase {
        let [r1, r2, r3, r4] = words.map(|word| b.constant(word));
        let head = b.push(Op::Head(t));
        b.name(head, "head");
        let tail = b.sub(t, head);
        b.name(tail, "tail");
        let first = b.mul(head, r1);
        let first = modulo_eight(b, first);
        b.name(first, "first");
        let second = cross(b, (tail, r1), (head, r2));
        let second = modulo_eight(b, second);
        b.name(second, "second");
        let third = cross(b, (tail, r2), (head, r3));
        b.name(third, "third");
        let fourth = cross(b, (tail, r3), (t, r4));
        b.name(fourth, "fourth");
        let leading = b.add(first, second);
        let sum = b.add(leading, third);
        let counted = self.launched(b, sum);
        let (magic, n) = round(b, counted);
        let rest = b.sub(first, n);
        if self.two_words {
            return self.any_time_in_two_words(b, magic, [rest, second, third, fourth]);
        }
        let s = b.add(rest, second);
        let s = b.add(s, third);
        let fourth = self.launched(b, fourth);
        let s = b.add(s, fourth);
        Phase { s: b.name(s, "s"), low: None, magic }
    }

    /// The second sum is exact where the third part isn't small beside it (t beyond 2⁴⁸ anchors), so that the quick form
    /// serves wherever something is lost.
    fn any_time_in_two_words(&self, b: &mut Builder, magic: Id, [rest, second, third, fourth]: [Id; 4]) -> Phase {
        let (sum, lost) = b.two_sum(rest, second);
        let (mut sum, lost_too) = b.quick_two_sum(sum, third);
        let mut lost = b.add(lost, lost_too);
        if self.launch != Double::ZERO {
            let launch = b.exact(self.launch.hi, 0.0);
            let (moved, lost_here) = b.two_sum(sum, launch);
            let rest = b.constant(self.launch.lo);
            let lost_here = b.add(lost_here, rest);
            (sum, lost) = (moved, b.add(lost, lost_here));
        }
        let lost = b.add(lost, fourth);
        let (s, low) = b.quick_two_sum(sum, lost);
        Phase { s: b.name(s, "s"), low: Some(b.name(low, "low")), magic }
    }

    /// A wide phase, narrowed unless its second word's worth is wanted.
    fn narrow(&self, b: &mut Builder, phase: Phase) -> Phase {
        if self.two_words {
            return phase;
        }
        b.name(phase.s, "wide");
        let s = b.convert(phase.s, Float::F32);
        Phase { s: b.name(s, "s"), ..phase }
    }
}

/// The error that narrowing a phase to `f32` adds.
fn narrowing(two_words: bool) -> f64 {
    if two_words { 0.0 } else { half_ulp(0.49, Float::F32) }
}

/// a·b + c·d.
fn cross(b: &mut Builder, left: (Id, Id), right: (Id, Id)) -> Id {
    let left = b.mul(left.0, left.1);
    let right = b.mul(right.0, right.1);
    b.add(left, right)
}

/// The magic sum and the integer nearest to x.
fn round(b: &mut Builder, x: Id) -> (Id, Id) {
    let constant = b.float().magic();
    let constant = b.constant(constant);
    let magic = b.add(x, constant);
    b.name(magic, "magic");
    let n = b.sub(magic, constant);
    (magic, b.name(n, "n"))
}

/// x less the nearest multiple of 8, exactly, for |x| ≤ 2⁵⁴: adding 1.5·2⁵⁵ rounds to a multiple of 8.
fn modulo_eight(b: &mut Builder, x: Id) -> Id {
    let constant = b.constant(8.0 * Float::F64.magic());
    let even = b.add(x, constant);
    let even = b.sub(even, constant);
    b.sub(x, even)
}
