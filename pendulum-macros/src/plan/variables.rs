//! What kernels are functions of: the phase from the nearest anchor, its square, and the signs.

use crate::plan::moebius::Moebius;
use crate::plan::reduction::{Origin, Phase, Reduction};
use crate::program::{Builder, Id, Op};
use crate::series::Parity;
use pendulum_runtime::double::Double;

/// The variables that all kernels of a function share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Variables {
    /// The phase s from the nearest anchor, or its magnitude if reduced from the lowest point.
    pub(crate) distance: Id,
    /// The magnitude of the phase from the lowest point, if reduced from there.
    pub(crate) magnitude: Id,
    /// p = s²; over an arc without symmetry s + ½ in anchors, in units of the phase.
    pub(crate) p: Id,
    /// What s and p are before they are limited, if it is known.
    pub(crate) unlimited: Option<Unlimited>,
    /// Anchors per unit of the phase.
    pub(crate) unit: Double,
    /// What p and its kin are computed of.
    pub(crate) source: Source,
    /// The phase from the lowest point, if reduced from there: negative on its way from the anchor before.
    pub(crate) side: Option<Id>,
    /// The sum with the parity of the anchor.
    pub(crate) magic: Id,
    /// The number of anchors passed.
    pub(crate) count: Id,
    /// Whether they are those of one kernel.
    pub(crate) alone: bool,
    /// Whether values take the signs that the anchor and the side of the lowest point give.
    pub(crate) signs: bool,
}

/// s and p as they come, which beyond the horizon may be anything.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unlimited {
    distance: Id,
    square: Id,
    /// What |s| is limited to.
    pub(crate) half: f64,
    /// Whether it is no more, or twice as much at least.
    pub(crate) leaps: bool,
}

/// What the variable of a polynomial is computed of, with no rounding more than it takes.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Source {
    /// p itself.
    Square,
    /// What p falls short of a quarter by, and that quarter, in units of the reduced variable.
    Below { below: Id, quarter: Double },
    /// p = (s + ½)/4, with half an arc in units of the reduced variable.
    Linear { half: Double },
    /// P = (¼ + b) − b(¼ + b)/divisor, in anchors whatever the unit of the reduced variable.
    Quotient { divisor: Id, map: Moebius },
}

impl Unlimited {
    /// A monotonic function of p, limited only after it is computed: the same number, since roundings are monotonic.
    pub(crate) fn limited(self, b: &mut Builder, function: impl Fn(&mut Builder, Id) -> Id) -> Id {
        let float = b.float();
        let at = |p: f64| {
            let mut b = Builder::new(float);
            let input = b.input();
            let value = function(&mut b, input);
            b.finish(vec![value]).run(float.round(p))[0]
        };
        let (last, falls) = (at(self.half * self.half), at(float.largest()) < at(0.0));
        let value = function(b, self.square);
        if falls { at_least(b, value, last) } else { at_most(b, value, last) }
    }
}

impl Variables {
    /// Keeps the phase within half an anchor: beyond the horizon it is arbitrary, the result is not. `odd` tells
    /// whether the sign of s matters.
    pub(crate) fn lower(b: &mut Builder, phase: Phase, reduction: &Reduction, odd: bool) -> Self {
        match reduction.origin {
            Origin::Anchor if reduction.is_lopsided() => Self::from_start(b, phase, reduction),
            Origin::Anchor => Self::from_anchor(b, phase, reduction, odd),
            Origin::Lowest => Self::from_lowest(b, phase, reduction),
        }
    }

    /// What every origin begins with: signs, one kernel, and no side.
    pub(crate) fn of_one_kernel([distance, p]: [Id; 2], unit: Double, source: Source, phase: Phase) -> Self {
        let Phase { magic, count, .. } = phase;
        let (magnitude, unlimited, side, alone, signs) = (distance, None, None, true, true);
        Self { distance, magnitude, p, unlimited, unit, source, side, magic, count, alone, signs }
    }

    fn from_anchor(b: &mut Builder, phase: Phase, reduction: &Reduction, odd: bool) -> Self {
        let half = reduction.half();
        let square = b.mul(phase.remainder, phase.remainder);
        let unlimited = Unlimited { distance: phase.remainder, square, half, leaps: reduction.leaps() };
        let p = at_most(b, square, half * half);
        b.name(p, "p");
        // Not what is squared: an operation more, and the square waits for one less.
        let distance = if odd {
            let clamped = clamp(b, phase.remainder, half);
            b.name(clamped, "clamped")
        } else {
            phase.remainder
        };
        let variables = Self::of_one_kernel([distance, p], reduction.unit, Source::Square, phase);
        Self { unlimited: Some(unlimited), ..variables }
    }

    /// Over an arc without symmetry.
    fn from_start(b: &mut Builder, phase: Phase, reduction: &Reduction) -> Self {
        let distance = clamp(b, phase.remainder, reduction.half());
        b.name(distance, "clamped");
        let half = Double::new(0.5) / reduction.unit;
        let half_id = b.rounded(half);
        let p = b.add(distance, half_id);
        Self::of_one_kernel([distance, p], reduction.unit, Source::Linear { half }, phase)
    }

    /// With s = ½ − |z|: p = ¼ − |z|(1 − |z|), in which |z| small beside 1 loses nothing.
    fn from_lowest(b: &mut Builder, phase: Phase, reduction: &Reduction) -> Self {
        let half = reduction.half();
        let magnitude = b.push(Op::Abs(phase.remainder));
        let magnitude = at_most(b, magnitude, half);
        b.name(magnitude, "a");
        let whole = Double::ONE / reduction.unit;
        let quarter = whole * whole * 0.25;
        let [whole_id, half_id, quarter_id] = [whole, whole * 0.5, quarter].map(|constant| b.rounded(constant));
        let other = b.sub(whole_id, magnitude);
        let product = b.mul(magnitude, other);
        b.name(product, "below");
        let distance = b.sub(half_id, magnitude);
        let p = b.sub(quarter_id, product);
        b.name(p, "p");
        let source = Source::Below { below: product, quarter };
        let variables = Self::of_one_kernel([distance, p], reduction.unit, source, phase);
        Self { magnitude, side: Some(phase.remainder), ..variables }
    }

    /// The same without signs.
    pub(crate) fn unsigned(self) -> Self {
        Self { signs: false, ..self }
    }

    /// The same of a phase without limits.
    pub(crate) fn without(self, Unlimited { distance, square, .. }: Unlimited) -> Self {
        Self { distance, magnitude: distance, p: square, ..self }
    }

    /// 8p − 1, of a phase in anchors.
    pub(crate) fn normalised(&self, b: &mut Builder) -> Id {
        let eighth = self.unit * self.unit * 8.0;
        let one = b.constant(1.0);
        match self.source {
            Source::Square => {
                let eighth = b.rounded(eighth);
                let scaled = b.mul(self.p, eighth);
                b.sub(scaled, one)
            }
            Source::Below { below, .. } => {
                let eighth = b.rounded(eighth);
                let scaled = b.mul(below, eighth);
                b.sub(one, scaled)
            }
            Source::Linear { .. } => {
                let doubled = self.unit * 2.0;
                let doubled = b.rounded(doubled);
                b.mul(self.distance, doubled)
            }
            Source::Quotient { divisor, map } => self.less_quotient(b, divisor, map, 8.0, -Double::ONE),
        }
    }

    /// p + `shift`.
    pub(crate) fn shifted(&self, b: &mut Builder, shift: Double) -> Id {
        match self.source {
            Source::Quotient { divisor, map } => self.less_quotient(b, divisor, map, 1.0, shift),
            Source::Linear { half } => b.offset(self.distance, half + shift),
            Source::Square => b.offset(self.p, shift),
            Source::Below { below, quarter } => {
                let top = quarter + shift;
                let top = b.rounded(top);
                b.sub(top, below)
            }
        }
    }

    /// With the image of p in place of p.
    pub(crate) fn mapped(&self, b: &mut Builder, map: Moebius) -> Self {
        let place = Double::new(map.place) / (self.unit * self.unit);
        let place = b.rounded(place);
        let divisor = b.add(self.p, place);
        b.name(divisor, "d");
        Self { source: Source::Quotient { divisor, map }, ..*self }
    }

    /// factor·P + `offset`.
    fn less_quotient(&self, b: &mut Builder, divisor: Id, map: Moebius, factor: f64, offset: Double) -> Id {
        let dividend = Double::new(factor * map.scale()) / (self.unit * self.unit);
        let top = Double::new(factor * map.end()) + offset;
        let [dividend, top] = [dividend, top].map(|constant| b.rounded(constant));
        let quotient = b.div(dividend, divisor);
        b.sub(top, quotient)
    }

    /// `value` of a curve, with its sign. Of a phase reduced from the lowest point kernels know the magnitude alone:
    /// before that point the anchor passed counts, after it the next one, in between which an even curve that alternates
    /// changes its sign, and an odd one that doesn't.
    pub(crate) fn signed(&self, b: &mut Builder, value: Id, alternates: bool, parity: Parity) -> Id {
        if !self.signs {
            return value;
        }
        let changing = if alternates { Parity::Even } else { Parity::Odd };
        let side = self.side.filter(|_| parity == changing);
        let value = side.map_or(value, |side| b.push(Op::Against { x: value, sign: side }));
        if alternates { b.push(Op::Alternate { x: value, magic: self.magic, bit: 0 }) } else { value }
    }
}

/// x, or the limit where that is less.
pub(super) fn at_most(b: &mut Builder, x: Id, limit: f64) -> Id {
    let limit = b.constant(limit);
    b.push(Op::Min { limit, x })
}

/// x, or the limit where that is more.
fn at_least(b: &mut Builder, x: Id, limit: f64) -> Id {
    let limit = b.constant(limit);
    b.push(Op::Max { limit, x })
}

/// x within ±limit.
pub(super) fn clamp(b: &mut Builder, x: Id, limit: f64) -> Id {
    let x = at_most(b, x, limit);
    at_least(b, x, -limit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::Float;

    /// It is the function of the limited variable, bit by bit, whichever way it goes.
    #[test]
    fn limited_after_they_are_computed() {
        for float in [Float::F64, Float::F32] {
            for (slope, constant) in [(1.7, -0.3), (-1.684_907_4, 1.887_701_9), (8.0, -1.0), (0.1, 0.7)] {
                let [slope, constant] = [slope, constant].map(|number| float.round(number));
                let linear = |b: &mut Builder, p: Id| {
                    let (slope, constant) = (b.constant(slope), b.constant(constant));
                    let product = b.mul(p, slope);
                    b.add(product, constant)
                };
                let half = 0.474;
                let mut b = Builder::new(float);
                let square = b.input();
                let unlimited = Unlimited { distance: square, square, half, leaps: true };
                let late = unlimited.limited(&mut b, linear);
                let early = at_most(&mut b, square, float.round(half * half));
                let early = linear(&mut b, early);
                let program = b.finish(vec![late, early]);
                for i in -40..40 {
                    let [late, early] = program.run(float.round(half * half * 1.003f64.powi(i)))[..] else { panic!() };
                    assert_eq!(late, early, "{slope} {i}");
                }
                assert!(program.run(f64::INFINITY).iter().all(|result| result.is_finite()));
            }
        }
    }
}
