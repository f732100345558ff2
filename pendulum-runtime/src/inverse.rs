//! When a motion first passes an angle: the inverse of θ(t) in two words, never as a difference of nearly equal times.
//!
//! By energy (θ̇/2ω)² = k² − sin²(θ/2). With
//!
//! | | κ | x | y = √(1 − x²) | z = √(1 − κ²x²) | r |
//! |---|---|---|---|---|---|
//! | swing | k | sin(θ/2)/k | θ̇/(2ωk) | cos(θ/2) | ωt |
//! | rotation | 1/k | sin(θ/2) | cos(θ/2) | θ̇/(2ωk) | ωkt |
//!
//! and the separatrix, κ = 1, as the limit of either, that is dr = dx/(yz). Between two points of one ascent of x
//! (DLMF 19.29.4 with the linear factors 1 ∓ x and 1 ∓ κx)
//!
//! r = 2 RF(U², U² + (1 − κ)², U² + (1 + κ)²), U = (y₀z₁ + y₁z₀)/(x₁ − x₀),
//!
//! in which nothing is subtracted but x₀ from x₁; and that is 2 sin((θ₁ − θ₀)/4) cos((θ₁ + θ₀)/4), of a difference and
//! a sum of given numbers, exact in two words. To the end of the ascent, x₁ = 1, y₁ = 0 and z₁ = κ′ = √(1 − κ²), it is
//! U = κ′y/(1 − x) = κ′(1 + x)/y. There a swing turns back, and a rotation passes the top.

use crate::angle::{nearest_period, reduce};
use crate::carlson::carlson_rf;
use crate::double::Double;
use crate::double_trig::{half_angle, supplement};
use crate::error::{Error, finite};
use crate::kernel::{round, two_to};
use crate::launch::hypotenuse;
use crate::motion::{Moduli, Motion, Shape};
use crate::phase::unit_of;
use core::f64::consts::{PI, TAU};

/// Times to angles of rotations are told within so many turns: from there on neighbouring `f64` are about a radian apart.
pub(crate) const MOST_TURNS: f64 = 1e15;

/// Swings of an amplitude below this are linear to their last digit.
const LINEAR: f64 = two_to(-100);

impl Motion {
    /// The first t ≥ 0 at which θ(t) = `angle`; what a swing stays short of by at most `beyond` is its turning point.
    pub(crate) fn time_at(&self, angle: f64, beyond: f64) -> Result<f64, Error> {
        finite("theta", angle)?;
        if angle == self.theta {
            return Ok(0.0);
        }
        let way = Way::new(self, angle);
        let (r, k) = match self.shape {
            Shape::Swing(..) => (swing(self, &way, beyond), Double::ONE),
            Shape::Separatrix(..) => (separatrix(self, &way), Double::ONE),
            Shape::Rotation(..) => (rotation(self, &way), self.k),
        };
        // Scaled so that no product is split beyond 2⁹⁹⁶.
        let unit = unit_of(self.omega);
        let time = |r: Double| (r / (k * (self.omega / unit))).to_f64() / unit;
        r.map(time).ok_or(Error::NeverReached { angle })
    }
}

/// From where to where, mirrored so that the motion starts forward, and less the whole turns of the start.
struct Way {
    start: Double,
    target: Double,
    /// target − start.
    ahead: Double,
}

impl Way {
    fn new(motion: &Motion, angle: f64) -> Self {
        let start = reduce(motion.theta).angle;
        let ahead = Double::from_sum(angle, -motion.theta);
        let target = if motion.base.hi == 0.0 { Double::new(angle) } else { start + ahead };
        Self { start, target, ahead }.scale(motion.direction)
    }

    fn scale(&self, scale: f64) -> Self {
        Self { start: self.start.scale(scale), target: self.target.scale(scale), ahead: self.ahead.scale(scale) }
    }

    /// Difference and sum of the sines of θ/2, 2 sin((θ₁ ∓ θ₀)/4) cos((θ₁ ± θ₀)/4).
    fn sines(&self) -> (Double, Double) {
        let (sine, cosine) = signed_half_angle(self.ahead.scale(0.5));
        let (sine_of_sum, cosine_of_sum) = signed_half_angle((self.target + self.start).scale(0.5));
        ((sine * cosine_of_sum).scale(2.0), (sine_of_sum * cosine).scale(2.0))
    }
}

/// A point of an ascent, in the letters of this module's head.
struct Place {
    x: Double,
    y: Double,
    z: Double,
}

impl Place {
    /// r from here to `end`, which is `apart` = x₁ − x₀ further.
    fn to(&self, end: &Self, apart: Double, moduli: &Moduli) -> Double {
        integral(apart, self.y * end.z + end.y * self.z, moduli)
    }

    /// r from here to the end of the ascent; of the two forms of U the one in which nothing cancels.
    fn to_end(&self, moduli: &Moduli) -> Double {
        if self.x.hi < 0.0 {
            integral(Double::ONE - self.x, moduli.kc * self.y, moduli)
        } else {
            integral(self.y, moduli.kc * (Double::ONE + self.x), moduli)
        }
    }
}

/// r for U = m/n. RF is homogeneous of degree −½; so the quotient, which may be anything from 0 to ∞, isn't formed.
fn integral(n: Double, m: Double, moduli: &Moduli) -> Double {
    let sum = Double::ONE + moduli.k;
    let difference = square(moduli.kc) / sum; // 1 − κ
    let m = square(m);
    n.scale(2.0) * carlson_rf(m, m + square(difference * n), m + square(sum * n))
}

/// r of a whole ascent, 2K.
fn ascent(moduli: &Moduli) -> Double {
    Double::PI / moduli.mean
}

/// Angles above the start are passed on the way up to the turning point, those below on the way down from it.
fn swing(motion: &Motion, way: &Way, beyond: f64) -> Option<Double> {
    let (reach, moduli) = (motion.amplitude, &motion.moduli);
    let target = way.target.hi;
    // Where the way is longer than any number the target isn't one.
    if target.is_nan() || target.abs() > 2.0 * reach + beyond {
        return None;
    }
    // Squares of tiny angles would underflow; a power of two times as large, they swing in the same time.
    let lift = if reach < LINEAR { LINEAR / unit_of(reach) } else { 1.0 };
    let way = way.scale(lift);
    let speed = speed(motion, lift);
    let (sine, cosine) = signed_half_angle(way.start);
    let k = hypotenuse(speed, sine.abs());
    let start = Place { x: sine / k, y: speed / k, z: cosine };
    // Rounded, the amplitude may be more than is reached, or less than the angle of the start.
    let at_reach = (0.0..=beyond).contains(&(target.abs() - reach)) && way.start.hi.abs() <= reach * lift;
    let turn = || {
        let up = start.to_end(moduli);
        if target > 0.0 { up } else { up + ascent(moduli) }
    };
    if at_reach && target.abs() == reach && way.target.lo == 0.0 {
        return Some(turn());
    }
    let (difference, sum) = way.sines();
    let (sine, cosine) = signed_half_angle(way.target);
    let squared = speed_squared(speed, difference * sum, cosine, moduli.kc);
    // Less whole turns an angle has digits that the amplitude hasn't: it may be within that or beyond, even beyond the top,
    // from where it falls again.
    if squared.hi < 0.0 || supplement(way.target.abs()).hi < 0.0 {
        return at_reach.then(turn);
    }
    let end = Place { x: sine / k, y: squared.sqrt() / k, z: cosine };
    Some(if difference.hi > 0.0 {
        start.to(&end, difference / k, moduli)
    } else {
        start.to_end(moduli) + end.to_end(moduli)
    })
}

/// (θ̇/2ω)² where cos(θ/2) = `cosine` and sin²(θ/2) is `fallen` more than where it was `speed`²: that difference or
/// cos²(θ/2) − k′², whichever is of the smaller numbers. Released from rest the former is a product and exact; k′² of
/// a fast launch is as good as the difference cos²(θ₀/2) − `speed`², which is never worse than `speed`² itself.
fn speed_squared(speed: Double, fallen: Double, cosine: Double, kc: Double) -> Double {
    if kc.hi < speed.hi { (cosine - kc) * (cosine + kc) } else { square(speed) - fallen }
}

/// |θ̇|/(2ω) at t = 0, `lift` times.
fn speed(motion: &Motion, lift: f64) -> Double {
    let unit = unit_of(motion.omega);
    Double::new(0.5 * (motion.velocity.abs() * lift / unit)) / Double::new(motion.omega / unit)
}

/// sinh ωt = tan(θ/2) in Carlson's form.
fn separatrix(motion: &Motion, way: &Way) -> Option<Double> {
    let place = |angle| {
        let (sine, cosine) = signed_half_angle(angle);
        Place { x: sine, y: cosine, z: cosine }
    };
    let (start, end) = (place(way.start), place(way.target));
    let reached = way.ahead.hi > 0.0 && way.target.hi <= PI && end.y.hi > 0.0;
    reached.then(|| start.to(&end, way.sines().0, &motion.moduli))
}

/// Within the turn of the start as a swing; further turns are the rest of that one, whole ones, and the last one's
/// part before the angle, which by symmetry is one after the opposite angle.
fn rotation(motion: &Motion, way: &Way) -> Option<Double> {
    let moduli = &motion.moduli;
    let (turns, rest) = turns_and_rest(way.target);
    let reached = way.ahead.hi > 0.0 && turns.abs() <= MOST_TURNS;
    reached.then(|| {
        let start = rotating(way.start, moduli);
        if turns == 0.0 {
            start.to(&rotating(rest, moduli), way.sines().0, moduli)
        } else {
            start.to_end(moduli) + ascent(moduli) * (turns - 1.0) + rotating(-rest, moduli).to_end(moduli)
        }
    })
}

/// Whole turns, and the rest in [−π, π]; more turns than [`MOST_TURNS`] are not counted on.
fn turns_and_rest(angle: Double) -> (f64, Double) {
    let most = 2.0 * MOST_TURNS;
    let turns = round((angle.hi / TAU).clamp(-most, most));
    // Beyond a top the time to it is negative, which no square root tells.
    let (more, rest) = nearest_period(angle - Double::TURN * turns, Double::TURN);
    (turns + more, rest)
}

/// z² = κ′² + κ² cos²(θ/2): no velocity is squared, which may be as large as 10²⁹⁰.
fn rotating(angle: Double, moduli: &Moduli) -> Place {
    let (sine, cosine) = signed_half_angle(angle);
    let z = (square(moduli.kc) + square(moduli.k * cosine)).sqrt();
    Place { x: sine, y: cosine, z }
}

/// (sin(x/2), cos(x/2)), both with small relative error, for |x| ≤ π and a little more.
fn signed_half_angle(x: Double) -> (Double, Double) {
    let (sine, cosine) = half_angle(x.abs());
    (if x.hi < 0.0 { -sine } else { sine }, cosine)
}

fn square(x: Double) -> Double {
    x * x
}

#[cfg(test)]
mod tests;
