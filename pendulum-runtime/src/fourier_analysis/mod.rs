//! What N terms of the Fourier series of sn do (Eq. 22): coefficients, overshoot, and the supremum of the error.
//!
//! Shared by the run-time `Fourier` and the macro; not part of the public interface.
//!
//! With w the phase since the zero crossing, 0 ≤ w ≤ π/2 by symmetry, let y = sin(θ/2) = k sn, and let
//! x = k snᴺ = y − ρ be the argument of the arcsine, ρ the tail of the series. Everything follows from y, from
//! dn = cos(θ/2) and from the tail, each known to relative accuracy, and nothing is ever the difference of two large
//! numbers:
//!
//! * 1 − x² = dn² + ρ(2y − ρ), the *margin*; the arcsine exists as long as it is not negative;
//! * sin(½(θ̂ − θ)) = −ρ(x + y)/(x dn + y √margin).

mod cells;

use self::cells::Cells;
use crate::agm::agm_double;
use crate::double::Double;
use crate::kernel::{power, round, sin_turns, two_to};
use crate::nome::root_of_nome;
use crate::phase::Reduced;
use crate::rotation::Rotation;
use crate::swing::{Swing, SwingPhase};
use libm::sqrt;

/// Samples per half wave of the first neglected harmonic: enough that each local extremum of a function whose tail
/// falls off geometrically shows as a sample above both neighbours, to be refined from there.
const SAMPLES: usize = 12;

/// More terms than any motion needs: the last `f64` below π 600, launches that stop nearer to the top up to some 1,300.
const MOST_TERMS: usize = 4096;

/// Halvings of a cell of `certified_bound`, which each make its excess about half as large: more than it ever takes.
const DEEPEST: u32 = 40;

/// The series of one swing.
#[derive(Clone, Copy, Debug)]
pub struct FourierAnalysis {
    k: Double,
    /// k′.
    kc: f64,
    /// √q.
    root: Double,
    /// 2π/K.
    scale: Double,
    swing: Swing,
    /// dn is the velocity of the rotation of the same modulus.
    rotation: Rotation,
}

/// The neglected terms at one phase.
#[derive(Clone, Copy)]
struct Tail {
    value: f64,
    slope: f64,
}

/// One phase.
#[derive(Clone, Copy)]
struct Sample {
    /// y = sin(θ/2).
    y: f64,
    /// cos(θ/2).
    dn: f64,
    tail: Tail,
}

impl Sample {
    /// 1 − x².
    fn margin(&self) -> f64 {
        self.dn * self.dn + self.tail.value * (2.0 * self.y - self.tail.value)
    }

    /// |θ̂ − θ|; where the arcsine does not exist, as if its argument were 1.
    fn error(&self) -> f64 {
        distance(self.y, self.dn, self.tail.value, self.margin().max(0.0))
    }
}

/// |2 asin(y − ρ) − 2 asin y| from dn² = 1 − y² and margin = 1 − (y − ρ)².
fn distance(y: f64, dn: f64, tail: f64, margin: f64) -> f64 {
    if tail == 0.0 {
        return 0.0;
    }
    let root = sqrt(margin);
    let x = y - tail;
    if x <= 0.0 {
        return 2.0 * (libm::atan2(y, dn) - libm::atan2(x, root)).abs();
    }
    let sine = tail * ((x + y) / (x * dn + y * root)); // in this order: nothing underflows on the way
    2.0 * libm::atan2(sine.abs(), x * y + dn * root)
}

impl FourierAnalysis {
    /// For k = sin(θ0/2) and k′ = cos(θ0/2), 0 ≤ k < 1, each with small relative error.
    #[must_use]
    pub fn new(k: Double, kc: Double) -> Self {
        let mean = agm_double(kc);
        Self {
            k,
            kc: kc.hi,
            root: root_of_nome(k, kc),
            scale: mean.scale(4.0), // 2π/K = 4 AGM(1, k′)
            swing: Swing::new(k, kc, mean.hi, f64::INFINITY),
            rotation: Rotation::new(k.hi, kc.hi, mean.hi),
        }
    }

    /// b₂ₙ₋₁ = (2π/(kK)) q^{n−½}/(1 − q^{2n−1}) (Eq. 20) for n ≥ 1. As k → 0, 1 for n = 1 and 0 for the others, which
    /// are no numbers from k = 6e-162 down, where k²/16, about the second, underflows.
    #[must_use]
    pub fn coefficient(&self, n: usize) -> Double {
        // Below 10⁻²⁷⁵ √q has less than two words.
        if self.k.hi < two_to(-700) {
            return if n == 1 { Double::ONE } else { Double::ZERO };
        }
        let q = self.root * self.root;
        let power = (1..n).fold(Double::ONE, |power, _| power * q);
        let odd = power * power * q; // q^{2n−1}
        (self.root / self.k) * self.scale * power / (Double::ONE - odd)
    }

    /// How far the largest argument of the arcsine, k snᴺ, exceeds 1; `None` if it nowhere does.
    #[must_use]
    pub fn overshoot(&self, terms: usize) -> Option<f64> {
        let least = -self.largest(terms, |sample| -sample.margin());
        (least < 0.0).then(|| -least / (1.0 + sqrt(1.0 - least)))
    }

    /// The smallest number of terms without overshoot.
    ///
    /// The amplitude up to which N terms serve grows with N, so this is a
    /// search in a sorted sequence.
    #[must_use]
    pub fn smallest_working(&self) -> usize {
        let mut works = 1;
        while works < MOST_TERMS && self.overshoot(works).is_some() {
            works *= 2;
        }
        let mut fails = works / 2;
        while works - fails > 1 {
            let middle = usize::midpoint(works, fails);
            if self.overshoot(middle).is_some() { fails = middle } else { works = middle }
        }
        works
    }

    /// sup |θ̂ − θ| over the period: every local maximum found by sampling, refined until it stands still. Next to
    /// an overshoot, where 1 − x² cancels before its root is taken, it has been seen to be off by up to 2·10⁻⁸ of itself.
    #[must_use]
    pub fn supremum(&self, terms: usize) -> f64 {
        self.largest(terms, Sample::error)
    }

    /// An upper bound of |θ̂ − θ| over the period, at most 1 + `slack` times its supremum, by branch and bound: proven,
    /// rounding included, whatever the sampling of `supremum` may have missed.
    #[must_use]
    pub fn certified_bound(&self, terms: usize, slack: f64) -> f64 {
        let goal = self.supremum(terms) * (1.0 + slack);
        Cells::new(self, terms, goal).bound(0.0, 0.25, DEEPEST) * (1.0 + 1e-9)
    }

    /// The largest value over the quarter period.
    fn largest(&self, terms: usize, f: impl Fn(&Sample) -> f64) -> f64 {
        let points = SAMPLES * (terms + 1);
        let step = 0.25 / points as f64;
        let at = |index: usize| f(&self.sample(terms, step * index as f64));
        // One step beyond the turning point the function is its own mirror image. Mostly it is largest there.
        let (mut after, mut here) = (at(points - 1), at(points));
        let mut best = f64::NEG_INFINITY;
        for index in (1..=points).rev() {
            let before = at(index - 1);
            // A parabola through three samples rises above the middle one by an eighth of this at most.
            let rise = (here - before) + (here - after);
            if here >= before && here >= after && here + rise > best {
                let z = step * index as f64;
                let near = |z: f64| f(&self.sample(terms, z));
                best = best.max(here).max(refine(&near, z - step, (z + step).min(0.25)));
            }
            (here, after) = (before, here);
        }
        best.max(here)
    }

    /// Everything at z turns from the zero crossing, 0 ≤ z ≤ ¼.
    fn sample(&self, terms: usize, z: f64) -> Sample {
        let (y, _) = self.swing.half_angle(SwingPhase::at_crossing(z));
        Sample { y, dn: self.dn(z), tail: self.tail(terms, z) }
    }

    /// cos(θ/2) likewise. Nearer to the turning point it is that at the mirrored phase which says how small it is there:
    /// dn(K − u) = k′/dn(u) (DLMF 22.4.3), and half-way both are √k′.
    fn dn(&self, z: f64) -> f64 {
        let velocity = |z: f64| self.rotation.velocity(Reduced { turns: 0.0, high: 2.0 * z, low: 0.0 });
        if z <= 0.125 { velocity(z) } else { self.kc / velocity(0.25 - z) }
    }

    /// ρ = Σ_{n>N} k b₂ₙ₋₁ sin((2n − 1)w) and dρ/dw, to the last digit.
    fn tail(&self, terms: usize, z: f64) -> Tail {
        let twice_cosine = 2.0 * harmonic(2.0 * z).1;
        let (mut before, mut here) = (harmonic((2 * terms) as f64 * z - z), harmonic((2 * terms) as f64 * z + z));
        let mut tail = Tail { value: 0.0, slope: 0.0 };
        self.for_tail(terms, |odd, amplitude| {
            tail.value += amplitude * here.0;
            tail.slope += odd * amplitude * here.1;
            let after = (twice_cosine * here.0 - before.0, twice_cosine * here.1 - before.1);
            (before, here) = (here, after);
        });
        tail
    }

    /// Σ_{n>N} k b₂ₙ₋₁ (2n − 1)^order.
    fn tail_moment(&self, terms: usize, order: i32) -> f64 {
        let mut sum = 0.0;
        self.for_tail(terms, |odd, amplitude| sum += amplitude * power(odd, order));
        sum
    }

    /// Calls `f` with 2n − 1 and k b₂ₙ₋₁ for n = N + 1, N + 2, … until the rest is below 2⁻⁵⁵ of the first; weighted
    /// with (2n − 1)², below 10⁻¹⁴ of the sum, with (2n − 1)³ below 10⁻¹³.
    fn for_tail(&self, terms: usize, mut f: impl FnMut(f64, f64)) {
        let root = self.root.to_f64();
        let q = root * root;
        let mut weight = root * self.scale.hi * power(q, terms as i32);
        let mut odd_power = power(q, 2 * terms as i32 + 1);
        let last = weight * 2.8e-17 * (1.0 - q);
        let mut odd = (2 * terms + 1) as f64;
        while weight > last {
            f(odd, weight / (1.0 - odd_power));
            weight *= q;
            odd_power *= q * q;
            odd += 2.0;
        }
    }
}

/// (sin 2πz, cos 2πz) for moderate z ≥ 0.
fn harmonic(z: f64) -> (f64, f64) {
    let s = z - round(z);
    let a = s.abs();
    let sine = sin_turns(if a <= 0.25 { a } else { 0.5 - a });
    (if s < 0.0 { -sine } else { sine }, sin_turns(0.25 - a))
}

/// The largest value of a function with one maximum in [low, high], by golden sections until the bracket is 10⁻⁸ of
/// itself, where the value, flat there, stands still to 10⁻¹⁶.
fn refine(f: &impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    let mut left = high - GOLDEN * (high - low);
    let mut right = low + GOLDEN * (high - low);
    let (mut at_left, mut at_right) = (f(left), f(right));
    let mut best = at_left.max(at_right).max(f(high));
    for _ in 0..38 {
        if at_left >= at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - GOLDEN * (high - low);
            at_left = f(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + GOLDEN * (high - low);
            at_right = f(right);
        }
        best = best.max(at_left).max(at_right);
    }
    best
}

#[cfg(test)]
mod tests;
