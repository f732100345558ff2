//! What kernels are functions of: the phase from the nearest anchor, its square, and the signs.

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
    /// p = s².
    pub(crate) square: Id,
    /// 8p of a phase in anchors, over the square of the reduced variable.
    eighth: Double,
    /// If reduced from the lowest point, what p falls short of a quarter by, and that quarter.
    below: Option<(Id, Double)>,
    /// The phase from the lowest point, if reduced from there: negative on its way from the anchor before.
    pub(crate) side: Option<Id>,
    /// The sum with the parity of the anchor.
    pub(crate) magic: Id,
    /// The number of anchors passed.
    pub(crate) count: Id,
}

impl Variables {
    /// Keeps the phase within half an anchor: beyond the horizon it is arbitrary, the result is not. `odd` tells whether
    /// the sign of s matters.
    pub(crate) fn lower(b: &mut Builder, phase: Phase, reduction: &Reduction, odd: bool) -> Self {
        match reduction.origin {
            Origin::Anchor => Self::from_anchor(b, phase, reduction, odd),
            Origin::Lowest => Self::from_lowest(b, phase, reduction),
        }
    }

    fn from_anchor(b: &mut Builder, phase: Phase, reduction: &Reduction, odd: bool) -> Self {
        let half = reduction.half();
        let (distance, square) = if odd {
            let clamped = clamp(b, phase.remainder, half);
            let clamped = b.name(clamped, "clamped");
            (clamped, b.mul(clamped, clamped))
        } else {
            let square = b.mul(phase.remainder, phase.remainder);
            (phase.remainder, at_most(b, square, half * half))
        };
        b.name(square, "p");
        let eighth = reduction.unit * reduction.unit * 8.0;
        let (magic, count) = (phase.magic, phase.count);
        Self { distance, magnitude: distance, square, eighth, below: None, side: None, magic, count }
    }

    /// With s = ½ − |z|: p = ¼ − |z|(1 − |z|), in which |z| small beside 1 loses nothing.
    fn from_lowest(b: &mut Builder, phase: Phase, reduction: &Reduction) -> Self {
        let half = reduction.half();
        let magnitude = b.push(Op::Abs(phase.remainder));
        let magnitude = at_most(b, magnitude, half);
        b.name(magnitude, "a");
        let whole = Double::ONE / reduction.unit;
        let quarter = whole * whole * 0.25;
        let [whole_id, half_id, quarter_id] =
            [whole, whole * 0.5, quarter].map(|constant| b.exact(constant.hi, constant.lo));
        let other = b.sub(whole_id, magnitude);
        let product = b.mul(magnitude, other);
        b.name(product, "below");
        let distance = b.sub(half_id, magnitude);
        let square = b.sub(quarter_id, product);
        b.name(square, "p");
        let eighth = reduction.unit * reduction.unit * 8.0;
        let (side, magic, count) = (Some(phase.remainder), phase.magic, phase.count);
        let below = Some((product, quarter));
        Self { distance, magnitude, square, eighth, below, side, magic, count }
    }
}

impl Variables {
    /// 8p − `centre`, of a phase in anchors.
    pub(crate) fn centred(&self, b: &mut Builder, centre: f64) -> Id {
        let eighth = b.exact(self.eighth.hi, self.eighth.lo);
        let centred = match self.below {
            None => {
                let scaled = b.mul(self.square, eighth);
                let offset = b.constant(centre);
                b.sub(scaled, offset)
            }
            Some((below, _)) => {
                let scaled = b.mul(below, eighth);
                let top = b.constant(2.0 - centre);
                b.sub(top, scaled)
            }
        };
        b.name(centred, "u")
    }

    /// p + `shift`.
    pub(crate) fn shifted(&self, b: &mut Builder, shift: f64) -> Id {
        match self.below {
            _ if shift == 0.0 => self.square,
            None => {
                let shift = b.constant(shift);
                b.add(self.square, shift)
            }
            Some((below, quarter)) => {
                let top = quarter + Double::new(shift);
                let top = b.exact(top.hi, top.lo);
                b.sub(top, below)
            }
        }
    }

    /// `value` of an odd curve of a rotation, whose magnitude it is if the phase was reduced from the lowest point: before
    /// that point the top passed counts, after it the next one.
    pub(crate) fn sign_of_odd(&self, b: &mut Builder, value: Id) -> Id {
        self.side.map_or(value, |side| b.push(Op::Against { x: value, sign: side }))
    }

    /// `value` of a curve that changes its sign from anchor to anchor, and, if it is even about an anchor, from one side
    /// of the lowest point to the other: before that point the anchor passed counts, after it the next one.
    pub(crate) fn sign(&self, b: &mut Builder, value: Id, parity: Parity) -> Id {
        let side = self.side.filter(|_| parity == Parity::Even);
        let value = match side {
            Some(side) => b.push(Op::Against { x: value, sign: side }),
            None => value,
        };
        b.push(Op::Alternate { x: value, magic: self.magic })
    }
}

fn at_most(b: &mut Builder, x: Id, limit: f64) -> Id {
    let limit = b.constant(limit);
    b.push(Op::Min { limit, x })
}

/// x within ±limit.
fn clamp(b: &mut Builder, x: Id, limit: f64) -> Id {
    let x = at_most(b, x, limit);
    let limit = b.constant(-limit);
    b.push(Op::Max { limit, x })
}
