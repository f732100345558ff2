//! Phase reduction: from the time to the phase between two anchors, where the motion is symmetric.
//!
//! An anchor is a turning point of a swing, or the top of a rotation; `rate` anchors are passed per unit of time, and x
//! = rate·t + launch counts them. A reduction computes either n = round(x), whose parity tells the sign of a swing, and
//! the remainder s = x − n, or n = round(x − ½) and z = x − n − ½, the phase from the lowest point, near which it is
//! the more accurate and the motion the fastest. |s| and |z| are at most ½ (plus `overshoot`), in units of `unit`
//! anchors.
//!
//! Rounding is done by adding and subtracting 1.5·2⁵² (1.5·2²³), which leaves the integer in the sum's low bits. The
//! subtractions that follow are exact: their operands are multiples of the same unit and the result is no longer.

mod clock;
mod lower;
mod words;

pub(crate) use clock::Clock;

use crate::parse::Float;
use crate::power::{exponent, two_to};
use crate::program::{Builder, Id, Program};
use pendulum_runtime::double::Double;
use std::ops::Range;

/// The part of itself that a number is wrong by after a few roundings in `f32`, at most: a rate in one word by 2⁻²⁴, a
/// phase, its square and a map's image by 4 units each.
pub(crate) const ROUNDED: f64 = 1e-6;

/// How the phase is found, and how wrong it can be over the horizon.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Reduction {
    pub(crate) scheme: Scheme,
    /// The type of time and result.
    pub(crate) float: Float,
    /// Anchors passed at t = 0.
    pub(crate) launch: Double,
    /// Where the reduced phase is zero.
    pub(crate) origin: Origin,
    /// |computed − true| of the phase s over the horizon, in anchors, is at most `error` + `relative_error`·|s| of the
    /// computed s; of the true one `relative_error`/1.001 is enough.
    pub(crate) error: f64,
    pub(crate) relative_error: f64,
    /// The part of `error` that is the rounding of remainders up to ½, and falls with them.
    pub(crate) rounding: f64,
    /// The part of `error` that is hardly ever met: a promise has to include it, but no plan is the better for leaving
    /// room for it.
    pub(crate) seldom: f64,
    /// |s| exceeds ½ by at most this, in anchors; negative where it doesn't reach ½ within the horizon, and is kept from
    /// it beyond.
    pub(crate) overshoot: f64,
    /// The only distances from the origin of which the rounding counts, in anchors, if not all do.
    pub(crate) met: Option<[f64; 2]>,
    /// Anchors per unit of the reduced variable.
    pub(crate) unit: Double,
    /// A power of two that phases are multiplied with besides.
    pub(crate) scale: f64,
    /// Parts of an anchor that n counts, a power of two: the remainder is that from the nearest part.
    pub(crate) pieces: f64,
    /// Times beyond ±this are replaced by it.
    pub(crate) cap: Option<f64>,
    pub(crate) mirror: Mirror,
}

/// How a time and its negative are reduced alike, to the bit, however large they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Mirror {
    /// They are not, or need nothing for it: the motion wasn't released from rest, or the time isn't reduced.
    Neither,
    /// The phase is that of |t|, and what is odd in time takes the sign of t.
    Magnitude,
    /// The constants that round take the sign of t, so that the phase of −t is the negative. Of a phase beyond 2⁵¹ (2²²)
    /// anchors one constant for both signs makes a sum on one side and a difference on the other, which is rounded less.
    Sign,
}

/// The zero of the reduced phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Origin {
    /// An anchor: a turning point, the top.
    Anchor,
    /// Half-way between two anchors: the lowest point.
    Lowest,
}

impl Origin {
    /// What the reduced phase is called in programs.
    pub(crate) fn phase(self) -> &'static str {
        match self {
            Self::Anchor => "s",
            Self::Lowest => "z",
        }
    }
}

/// The ways of reducing the phase.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Scheme {
    /// s = t·R − n with R in one word.
    OneWord { rate: f64 },
    /// s = t·R′ − n·A, in units of which an anchor has A: a number of few bits such that nA is exact, R′ = AR to far
    /// beyond its last place, and the product is rounded as little as its digits allow.
    Scaled { rate: f64, scaled: f64, anchor: f64 },
    /// s = t − n·T₁ − n·T₂ …, every nTᵢ but the last exact (Cody and Waite 1980); s is a time.
    CodyWaite { rate: f64, words: Vec<f64> },
    /// An `f32` time, R in one `f64` word.
    Wide { rate: f64 },
    /// An `f32` time, R in two or three `f64` words; all products but the last are exact.
    WideAnyTime { words: Vec<f64> },
    /// An `f64` time, R in two to four words; all products that matter but the last are exact. `doubled` if sums with a launch
    /// are done in two words.
    AnyTime { words: Vec<f64>, doubled: bool },
    /// s = t: the horizon is an arc, about whose centre the motion is symmetric or `lopsided`.
    Time { lopsided: bool },
    /// z = (t − t₀)·R, |z| ≤ `half`, never reduced: the separatrix has one lowest point, passed at t₀, known in two
    /// words. Both times are multiplied with a power of two, by which R is divided.
    Linear { rate: f64, passed: Double, times: f64, half: f64 },
}

/// The reduced phase in a program.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Phase {
    /// The remainder, of the program's float.
    pub(crate) remainder: Id,
    /// The sum whose lowest bit is the parity of n. Of a phase that isn't reduced neither this nor the number means
    /// anything: it is the time.
    pub(crate) magic: Id,
    /// The number n of anchors passed; of n in pieces, of lowest points.
    pub(crate) count: Id,
}

/// Whether it is a multiple of ½.
pub(crate) fn is_half(x: Double) -> bool {
    x.lo == 0.0 && (2.0 * x.hi).fract() == 0.0
}

/// Times whose powers are of moderate size as they are.
const UNSCALED: Range<f64> = 0.03125..32.0;

/// Farther than this from the lowest point, in units of 1/ω, the separatrix is at the top in any precision: 2⁻⁸⁹⁴ of half
/// a turn from it.
const LINEAR_HALF: f64 = 620.0;

impl Reduction {
    /// The time itself, where |t| up to `reach` is half an arc, if its type is good for such times.
    pub(crate) fn time(reach: f64, lopsided: bool, float: Float) -> Option<Self> {
        let scale = if UNSCALED.contains(&reach) { 1.0 } else { two_to(-1 - exponent(reach)) };
        float.moderate().contains(&reach).then(|| Self {
            unit: Double::new(0.5 / scale) / reach,
            scale,
            ..Self::exact(Scheme::Time { lopsided }, Origin::Anchor, float)
        })
    }

    /// By that scheme, with an anchor passed at t = 0 and without an error: what others differ from.
    fn exact(scheme: Scheme, origin: Origin, float: Float) -> Self {
        Self {
            scheme,
            float,
            launch: Double::ZERO,
            origin,
            error: 0.0,
            relative_error: 0.0,
            rounding: 0.0,
            seldom: 0.0,
            overshoot: 0.0,
            met: None,
            unit: Double::ONE,
            scale: 1.0,
            pieces: 1.0,
            cap: None,
            mirror: Mirror::Neither,
        }
    }

    /// For a release from rest, which is even about t = 0: θ(−t) = θ(t) to the bit. From a lowest point, half an anchor
    /// away, sums just inside of ½ and just outside of it are not rounded alike whatever their constants.
    pub(crate) fn released(self) -> Self {
        let mirror = if self.origin == Origin::Lowest { Mirror::Magnitude } else { Mirror::Sign };
        Self { mirror, ..self }
    }

    /// The same with signs where they are needed: without, the magnitude of the time is an operation less.
    pub(crate) fn with_signs(&self, needed: bool) -> Self {
        let magnitude = self.mirror == Mirror::Sign && !needed;
        Self { mirror: if magnitude { Mirror::Magnitude } else { self.mirror }, ..self.clone() }
    }

    /// The same with the remainder from the nearest of so many pieces of an anchor, whose number is in the low bits of
    /// the magic sum: where that mirrors of |t|, since those of a negative sum would count backwards. `None` where
    /// products with n would no longer be exact, or where there are so many anchors that their pieces can't be told. What
    /// rounds remainders is relative to them, by up to twice as much just above a power of two as just below it.
    pub(crate) fn in_pieces(&self, pieces: usize) -> Option<Self> {
        let pieces = pieces as f64;
        let error = self.error - self.rounding * (1.0 - 2.0 / pieces);
        let seldom = self.seldom / pieces;
        // Every piece is met whole, whether beyond the horizon or not.
        let overshoot = self.overshoot.max(0.0);
        (self.has_pieces() && error * pieces < two_to(-10)).then(|| Self {
            error,
            seldom,
            overshoot,
            pieces,
            ..self.with_signs(false)
        })
    }

    /// The same of phases that go so far from an anchor within the horizon. From a lowest point those that are nearer to
    /// it aren't kept away.
    pub(crate) fn reaching(self, reach: Option<f64>) -> Self {
        match reach.filter(|_| self.origin == Origin::Anchor) {
            Some(reach) => Self { overshoot: reach - 0.5, ..self },
            None => self,
        }
    }

    /// The same where rounding counts only of phases at such distances from an anchor.
    pub(crate) fn meeting(&self, [least, farthest]: [f64; 2]) -> Self {
        let met = match self.origin {
            Origin::Anchor => [least, farthest],
            Origin::Lowest => [0.5 - farthest, 0.5 - least],
        };
        Self { met: Some(met), ..self.clone() }
    }

    /// Whether it can count pieces of an anchor.
    pub(crate) fn has_pieces(&self) -> bool {
        let subtracts = match self.scheme {
            Scheme::OneWord { .. } => self.float == Float::F64,
            // Sums in two words gain nothing beside the others, of which the rounding falls with the remainder.
            Scheme::AnyTime { doubled, .. } => !doubled,
            Scheme::Wide { .. } | Scheme::WideAnyTime { .. } => true,
            _ => false,
        };
        subtracts && self.origin == Origin::Anchor
    }

    /// Whether its error grows with time, as that of a rounded rate does: where it ends, all of that is met.
    pub(crate) fn grows(&self) -> bool {
        match self.scheme {
            Scheme::OneWord { .. } | Scheme::Scaled { .. } | Scheme::CodyWaite { .. } | Scheme::Wide { .. } => true,
            Scheme::AnyTime { .. } | Scheme::WideAnyTime { .. } | Scheme::Time { .. } | Scheme::Linear { .. } => false,
        }
    }

    /// Whether its error is that of a rounding which goes with the time, and is next to nothing for most of a long horizon.
    pub(crate) fn is_rounded_late(&self) -> bool {
        matches!(&self.scheme, Scheme::AnyTime { words, .. } if words.len() == 2)
    }

    /// Whether there is nothing to reduce.
    pub(crate) fn is_time(&self) -> bool {
        matches!(self.scheme, Scheme::Time { .. })
    }

    /// Whether the remainder is in anchors, from one of them.
    pub(crate) fn counts_anchors(&self) -> bool {
        self.unit == Double::ONE && self.scale == 1.0 && !self.counts_pieces()
    }

    /// Whether the remainder is from the nearest of several pieces of an anchor.
    pub(super) fn counts_pieces(&self) -> bool {
        self.pieces > 1.0
    }

    /// Whether it is that of an arc without symmetry.
    pub(crate) fn is_lopsided(&self) -> bool {
        self.scheme == Scheme::Time { lopsided: true }
    }

    /// The phases to be analysed, in units of the reduced variable: both sides of 0 where the motion over an arc has no
    /// symmetry, one elsewhere.
    pub(crate) fn range(&self) -> [f64; 2] {
        if let Some([low, high]) = self.met {
            let [low, high] = [low * (1.0 - ROUNDED), high * (1.0 + ROUNDED)].map(|phase| phase / self.unit.hi);
            return [low, high.min(self.half())];
        }
        [if self.is_lopsided() { -self.half() } else { 0.0 }, self.half()]
    }

    /// Whether its remainders are finite and either within half an anchor or of a whole one at least, whatever the time.
    /// Of a product x below 2^(p−2) x − n is exact. From there on x is a multiple of ½, and so are the magic sum, which is
    /// rounded to such a multiple if at all, n and their difference: 0, ±½, or from ±1 on. A wide one is below an ulp of
    /// 2¹²⁸·rate.
    pub(crate) fn leaps(&self) -> bool {
        let one_word = match self.scheme {
            Scheme::OneWord { .. } => true,
            Scheme::Wide { rate } => rate < two_to(50),
            _ => false,
        };
        let exact = self.launch == Double::ZERO && self.overshoot == 0.0 && !self.counts_pieces();
        one_word && exact && self.origin == Origin::Anchor
    }

    /// Whether the phase is known to half an anchor at the end of the horizon, and every constant is finite.
    fn is_useful(&self) -> bool {
        self.error < 0.5 && self.half().is_finite() && self.program().is_finite()
    }

    /// Whether the phase is that of the separatrix, which isn't reduced.
    pub(crate) fn is_linear(&self) -> bool {
        matches!(self.scheme, Scheme::Linear { .. })
    }

    fn program(&self) -> Program {
        let mut b = Builder::new(self.float);
        let t = b.input();
        let Phase { remainder, magic, .. } = self.lower(&mut b, t);
        b.finish(vec![remainder, magic])
    }

    /// The number of its operations.
    pub(crate) fn operations(&self) -> usize {
        self.program().operations()
    }

    /// For the reader.
    pub(crate) fn describe(&self) -> String {
        let from = if self.origin == Origin::Lowest { " from the lowest point" } else { "" };
        let how = match &self.scheme {
            Scheme::OneWord { .. } => "one product with the rate".to_owned(),
            Scheme::Scaled { .. } => "one product with the rate, in a unit that suits both".to_owned(),
            Scheme::CodyWaite { words, .. } => format!("Cody and Waite's remainder of {} words", words.len()),
            Scheme::Wide { .. } => "one product with the rate in `f64`".to_owned(),
            Scheme::WideAnyTime { words } => {
                format!("exact products with the rate in {} words of `f64`", words.len())
            }
            Scheme::AnyTime { words, doubled } => {
                let sums = if *doubled { ", sums in two words" } else { "" };
                format!("exact products with the rate in {} words{sums}", words.len())
            }
            Scheme::Time { .. } => "the time itself, which the horizon keeps short".to_owned(),
            Scheme::Linear { .. } => "the time itself".to_owned(),
        };
        format!("{how}{from}")
    }

    /// The largest |s|, in units of the reduced variable, rounded up to a number of its type.
    pub(crate) fn half(&self) -> f64 {
        if let Scheme::Linear { half, .. } = self.scheme {
            return half;
        }
        if self.overshoot == 0.0 && self.unit == Double::ONE {
            return 0.5 / self.pieces;
        }
        let half = (0.5 / self.pieces + self.overshoot) / self.unit.hi;
        self.float.round(half * (1.0 + 4.0 * self.float.rounding_unit()))
    }
}

#[cfg(test)]
mod tests;
