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
    /// 8p − `centre`, of a phase in anchors.
    pub(crate) centred: Id,
    pub(crate) centre: f64,
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
    pub(crate) fn lower(b: &mut Builder, phase: Phase, reduction: &Reduction, centre: f64, odd: bool) -> Self {
        match reduction.origin {
            Origin::Anchor => Self::from_anchor(b, phase, reduction, centre, odd),
            Origin::Lowest => Self::from_lowest(b, phase, reduction, centre),
        }
    }

    fn from_anchor(b: &mut Builder, phase: Phase, reduction: &Reduction, centre: f64, odd: bool) -> Self {
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
        let scale = reduction.unit * reduction.unit * 8.0;
        let scale = b.exact(scale.hi, scale.lo);
        let scaled = b.mul(square, scale);
        let offset = b.constant(centre);
        let centred = b.sub(scaled, offset);
        b.name(centred, "u");
        let (magic, count) = (phase.magic, phase.count);
        Self { distance, magnitude: distance, square, centred, centre, side: None, magic, count }
    }

    /// With s = ½ − |z|: p = ¼ − |z|(1 − |z|), in which |z| small beside 1 loses nothing.
    fn from_lowest(b: &mut Builder, phase: Phase, reduction: &Reduction, centre: f64) -> Self {
        let half = reduction.half();
        let magnitude = b.push(Op::Abs(phase.remainder));
        let magnitude = at_most(b, magnitude, half);
        b.name(magnitude, "a");
        let whole = Double::ONE / reduction.unit;
        let [whole_id, half_id, quarter_id] =
            [whole, whole * 0.5, whole * whole * 0.25].map(|constant| b.exact(constant.hi, constant.lo));
        let other = b.sub(whole_id, magnitude);
        let product = b.mul(magnitude, other);
        b.name(product, "w");
        let distance = b.sub(half_id, magnitude);
        let square = b.sub(quarter_id, product);
        b.name(square, "p");
        let scale = reduction.unit * reduction.unit * 8.0;
        let scale = b.exact(scale.hi, scale.lo);
        let scaled = b.mul(product, scale);
        let top = b.constant(2.0 - centre);
        let centred = b.sub(top, scaled);
        b.name(centred, "u");
        let (side, magic, count) = (Some(phase.remainder), phase.magic, phase.count);
        Self { distance, magnitude, square, centred, centre, side, magic, count }
    }
}

impl Variables {
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
