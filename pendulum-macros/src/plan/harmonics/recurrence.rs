//! What Clenshaw's recurrence is rounded by, interval by interval.
//!
//! With X = 2 cos 2φ, uₙ = wₙ + X·uₙ₊₁ − uₙ₊₂ and V = u₁ ∓ u₂ the sum is cos φ or sin φ times V. The recurrence is
//! linear in the weights, so that a rounding error made in uₙ is an error of wₙ, which the sum passes on at most
//! undiminished; all of them see the same X, an error of which changes V by V′(X) times as much. Anywhere
//! |uₙ| ≤ Σ|wₘ|(m − n + 1), but about a turning point, where the weights alternate and an arcsine blows errors up, uₙ
//! and V′ are much less: so they are evaluated in the middle of the interval, and their own slopes bounded, by those of
//! Chebyshev's polynomials Uⱼ at 1, j(j + 1)(j + 2)/3 and (j − 1)j(j + 1)(j + 2)(j + 3)/15 (V. A. Markov).
//!
//! A sum S of cosines is a polynomial in c = cos φ, and an error of c as computed changes S by |dS/dc| = |S′(φ)/sin φ|
//! times as much: near the top next to nothing about a turning point, where V and 8c²V′, which make it up, are as large
//! as anywhere. A sum S of sines is sin φ times a polynomial in c, which changes it by |sin φ dV/dc| =
//! |S′(φ) − S cot φ|/sin φ times as much.

use crate::parse::Float;
use crate::plan::cosines::Local;
use crate::power::power;
use crate::program::rounding::half_ulp;
use pendulum_runtime::double::Double;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// A sum of cosines or sines, and what is known of its errors everywhere.
pub(super) struct Recurrence {
    weights: Vec<f64>,
    /// What each weight is rounded by.
    constants: Vec<f64>,
    of_sines: bool,
    /// Bounds of |uₙ| and of its derivative by X.
    sizes: Vec<[f64; 2]>,
    /// The same of V′ and V″.
    bends: [f64; 2],
    /// The same of the second derivative by the cosine of a sum of cosines; of V for sines.
    bend_by_cosine: f64,
    /// The error of the computed cos φ; and of the factor before V, that or sin φ.
    cosine: f64,
    factor: f64,
    float: Float,
}

impl Recurrence {
    /// With a cosine wrong by `cosine`; `sine` is the error of the sine of a sum of sines.
    pub(super) fn new(weights: &[Double], cosine: f64, sine: Option<f64>, float: Float) -> Self {
        let constants = weights.iter().map(|&w| (w - Double::new(float.round(w.hi))).hi.abs()).collect();
        let weights: Vec<f64> = weights.iter().map(|w| w.hi).collect();
        let total = |from: usize, of: fn(f64) -> f64| -> f64 {
            weights.iter().skip(from).enumerate().map(|(j, w)| w.abs() * of(j as f64)).sum()
        };
        let sizes = (0..weights.len() + 2).map(|n| [total(n, |j| j + 1.0), total(n, slope)]).collect();
        // Of Uⱼ and Uⱼ₋₁.
        let bends = [total(0, |j| slope(j) + slope(j - 1.0)), total(0, |j| bend(j) + bend(j - 1.0))];
        let bend_by_cosine = total(0, if sine.is_some() { |j| 4.0 * bend(2.0 * j) } else { |j| second(2.0 * j + 1.0) });
        let (of_sines, factor) = (sine.is_some(), sine.unwrap_or(cosine));
        Self { weights, constants, of_sines, sizes, bends, bend_by_cosine, cosine, factor, float }
    }

    /// What X is wrong by where the cosine as computed is at most so large, if that cosine is right: the roundings of 4c²
    /// and of itself.
    fn rounding_of_x(&self, cosine: f64) -> f64 {
        4.0 * half_ulp(cosine * cosine, self.float) + half_ulp(2.0, self.float)
    }

    /// What it is wrong by for that cosine's error.
    fn passed_on_to_x(&self, cosine: f64) -> f64 {
        8.0 * cosine * self.cosine
    }

    /// By which part of its bound uₙ may be wrong: each rounding is at most a part of that bound, and is passed on as
    /// often as weights follow.
    fn excess(&self) -> f64 {
        let most = 1.0 + self.cosine;
        let each = 7.0 * self.float.rounding_unit() + self.rounding_of_x(most) + self.passed_on_to_x(most);
        each * 0.5 * (self.weights.len() * (self.weights.len() + 1)) as f64
    }

    /// Whether a step might: no uₙ is larger than the first may be, and X·uₙ is at most twice as large.
    fn overflows(&self, excess: f64) -> bool {
        4.0 * beyond(excess) * self.sizes[0][0] > self.float.largest()
    }

    /// How wrong the sum is for φ/π between these, where the sum of cosines, or that of which the sum of sines is the
    /// derivative by φ/π, is known to be so.
    pub(super) fn error(&self, low: f64, high: f64, known: &Local) -> f64 {
        let excess = self.excess();
        if excess >= 1.0 || self.overflows(excess) {
            return f64::INFINITY;
        }
        let interval = self.interval(low, high, excess);
        let reach = self.reach(&interval, excess);
        let by_cosine =
            if self.of_sines { sines_by_cosine(known, low, high) } else { cosines_by_cosine(known, low, high) };
        let of_steps = self.of_steps(&interval, &reach, excess);
        (of_steps + self.of_arguments(&interval, &reach, by_cosine)) * beyond(excess)
    }

    /// What the roundings of weights, products and sums are passed on as.
    fn of_steps(&self, interval: &Interval, Reach { u, v, .. }: &Reach, excess: f64) -> f64 {
        let count = self.weights.len();
        let rounding = |size: f64| half_ulp(size * beyond(excess), self.float);
        let step = |n: usize| {
            let (w, product) = (self.weights[n].abs(), interval.most * u[n + 1]);
            let sum = (w + product).min(u[n] + u[n + 2]);
            // The constant, the product, its sum with the constant, and the difference.
            let product_and_sum = if n + 1 < count { rounding(product) + rounding(sum) } else { 0.0 };
            self.constants[n] + product_and_sum + if n + 2 < count { rounding(u[n]) } else { 0.0 }
        };
        // |cos (2n + 1)φ|, |sin (2n + 1)φ| at most, n from 0.
        let wave = |n: usize| (interval.factor * (2 * n + 1) as f64).min(1.0);
        let steps: f64 = (0..count).map(|n| step(n) * wave(n)).sum();
        // The last sum and its product with the factor.
        steps + rounding(*v) * wave(0) + rounding(v * wave(0))
    }

    /// What the errors of cos φ and sin φ, and the rounding of X, are passed on as. The sum's derivative by the cosine is
    /// that by X times 8c, and V where the cosine is a factor besides: bounded by the other one, either may be less.
    fn of_arguments(&self, interval: &Interval, &Reach { v, v_slope, .. }: &Reach, by_cosine: f64) -> f64 {
        let (besides, of_sine) = if self.of_sines { (0.0, self.factor * v) } else { (v, 0.0) };
        let by_x = v_slope * interval.factor;
        let from_x = 8.0 * interval.cosine * by_x + besides;
        let from_cosine = (by_cosine + besides) / (8.0 * interval.least_cosine) + interval.error_of_x * self.bends[1];
        let by_cosine = from_x.min(by_cosine + 0.5 * self.bend_by_cosine * self.cosine);
        of_sine + self.cosine * by_cosine + self.rounding_of_x(interval.cosine) * by_x.min(from_cosine)
    }

    fn interval(&self, low: f64, high: f64, excess: f64) -> Interval {
        let (middle, half) = (0.5 * PI * (low + high), 0.5 * PI * (high - low).abs());
        let x = 2.0 * libm::cos(2.0 * middle);
        let [cosine, sine] = [FRAC_PI_2 - middle.abs(), middle].map(|distance| (distance.abs() + half).min(1.0));
        let cosine = cosine + self.cosine;
        let factor = if self.of_sines { sine + self.factor } else { cosine };
        let error_of_x = self.rounding_of_x(cosine) + self.passed_on_to_x(cosine);
        let apart = 4.0 * half * steepest(middle, half) + error_of_x;
        let most = (x.abs() + apart).min(2.0 * beyond(excess));
        let least_cosine = libm::cos((middle.abs() + half).min(FRAC_PI_2));
        Interval { x, apart, most, error_of_x, cosine, least_cosine, factor }
    }

    /// How large the recurrence's numbers are there: as in the middle, where they are evaluated, and as much more as they
    /// may change by.
    fn reach(&self, interval: &Interval, excess: f64) -> Reach {
        let &Interval { x, apart, .. } = interval;
        let mut values = vec![[0.0; 2]; self.weights.len() + 2];
        for n in (0..self.weights.len()).rev() {
            let ([u, slope], [next, next_slope]) = (values[n + 1], values[n + 2]);
            values[n] = [self.weights[n] + x * u - next, u + x * slope - next_slope];
        }
        // A number is computed with that excess twice, by the program and here.
        let lost = 2.0 * excess / (1.0 - excess);
        let beyond = beyond(excess);
        let of_u = |(&[size, slope], [value, _]): (&[f64; 2], &[f64; 2])| {
            size.min(value.abs() + apart * slope * beyond) + lost * size
        };
        let u: Vec<f64> = self.sizes.iter().zip(&values).map(of_u).collect();
        let sign = if self.of_sines { 1.0 } else { -1.0 };
        let [v, v_slope] = std::array::from_fn(|order| (values[0][order] + sign * values[1][order]).abs());
        let [slope, bend] = self.bends;
        let v_slope = (slope * beyond).min(v_slope + apart * bend * beyond) + lost * slope;
        let v = (u[0] + u[1]).min(v + apart * v_slope + 2.0 * lost * self.sizes[0][0]);
        Reach { u, v, v_slope }
    }
}

/// An interval of φ.
struct Interval {
    /// X in its middle; how far X as computed is from that; and |X| at most.
    x: f64,
    apart: f64,
    most: f64,
    /// What X is wrong by.
    error_of_x: f64,
    /// |cos φ| as computed at most, no more than the distance from its zero; and as it is at least.
    cosine: f64,
    least_cosine: f64,
    /// |cos φ| or |sin φ|, which V is multiplied with, as computed at most.
    factor: f64,
}

/// |uₙ|, |V| and |V′| at most, as computed or not.
struct Reach {
    u: Vec<f64>,
    v: f64,
    v_slope: f64,
}

/// What bounds for |X| ≤ 2 grow by at most where X as computed is more. With X = 2 cosh η, η² is at most what it is more
/// than 2, and Uⱼ = sinh (j + 1)η/sinh η at most exp((j + 1)²η²/6) times its j + 1 at 2; its derivatives grow less. Of an
/// error of X `excess` has up to (j + 1)²/2: so a third of that is for these, the rest for roundings that the recurrence
/// so computed passes on.
fn beyond(excess: f64) -> f64 {
    1.0 + 4.0 * excess
}

/// |dS/dc| at most, of a sum S of cosines of which that is known. S′ is nought at 0, and |S′(φ)| at most |φ| times |S″|
/// between.
fn cosines_by_cosine(sum: &Local, low: f64, high: f64) -> f64 {
    let [first, last] = ends(low, high);
    if low.min(high) <= 0.0 {
        return sum.largest(2) / (PI * PI) * (last / libm::sin(last)).max(1.0);
    }
    sum.largest(1) / PI / libm::sin(first).min(libm::sin(last))
}

/// |sin φ dV/dc| at most, of a sum S of sines, the derivative by φ/π of what is known. S′ sin φ − S cos φ is nought at 0,
/// and its derivative (S″ + S) sin φ.
fn sines_by_cosine(integral: &Local, low: f64, high: f64) -> f64 {
    let [first, last] = ends(low, high);
    let [sum, slope, bend] = [1, 2, 3].map(|order| integral.largest(order) / power(PI, order as i32 - 1));
    if low.min(high) <= 0.0 {
        return (bend + sum) / (1.0 + libm::cos(last));
    }
    let sine = libm::sin(first).min(libm::sin(last));
    (slope + sum * libm::cos(first).abs().max(libm::cos(last).abs()) / sine) / sine
}

/// |φ| where it is least and largest at an end.
fn ends(low: f64, high: f64) -> [f64; 2] {
    let [low, high] = [low, high].map(|end| end.abs() * PI);
    [low.min(high), low.max(high)]
}

/// The second derivative of Chebyshev's polynomial Tₙ at 1, where it is largest.
fn second(n: f64) -> f64 {
    n * n * (n * n - 1.0) / 3.0
}

/// |Uⱼ′(X/2)| at most, by X.
fn slope(j: f64) -> f64 {
    j * (j + 1.0) * (j + 2.0) / 6.0
}

/// |Uⱼ″(X/2)| at most, by X.
fn bend(j: f64) -> f64 {
    ((j - 1.0) * j * (j + 1.0) * (j + 2.0) * (j + 3.0) / 60.0).max(0.0)
}

/// |sin 2φ| at most.
fn steepest(middle: f64, half: f64) -> f64 {
    let to_summit = ((2.0 * middle / PI).rem_euclid(1.0) * 2.0 - 1.0).abs() * FRAC_PI_4;
    libm::cos(2.0 * (to_summit - half).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::cosines::Cosines;
    use crate::plan::harmonics::clenshaw;
    use crate::program::Builder;
    use crate::supremum::worst;
    use crate::testing::Random;

    fn error(recurrence: &Recurrence, low: f64, high: f64) -> f64 {
        let weights: Vec<Double> = recurrence.weights.iter().map(|&w| Double::new(w)).collect();
        let of = if recurrence.of_sines { Cosines::integral_of_sines } else { Cosines::odd };
        recurrence.error(low, high, &of(&weights).over(low, high))
    }

    /// Operation by operation, for two weights that cancel: u₂ = b, X = 4c² − 2, Xu₂, u₁ = a + Xu₂, u₁ − u₂, c(u₁ − u₂).
    #[test]
    fn errors_of_two_weights() {
        let (a, b, unit, cosine) = (0.75, -0.125_f64, Float::F64.rounding_unit(), 1e-12);
        let weights = [a, b].map(Double::new);
        let recurrence = Recurrence::new(&weights, cosine, None, Float::F64);
        let ulps = |sizes: &[f64]| sizes.iter().map(|&size| half_ulp(size, Float::F64)).sum::<f64>();
        for (s, x, v, c) in [(0.0, 2.0, a + b, 1.0), (0.5, -2.0, a - 3.0 * b, 0.0)] {
            // The product, u₁, the difference, and the last product. Neither constant is rounded.
            let roundings = ulps(&[2.0 * b, a + x * b, v, v]);
            // X is rounded by 6; and the cosine's error counts by the derivative of ac + b(4c³ − 3c).
            let slope = a + b * (12.0 * c * c - 3.0);
            let expected = c * (roundings + 6.0 * unit * b.abs()) + cosine * slope.abs();
            let found = error(&recurrence, s, s);
            assert!((found / expected - 1.0).abs() < 1e-9, "{s}: {found:e} for {expected:e}");
        }
        let single = |weight: Double| error(&Recurrence::new(&[weight], 0.0, None, Float::F64), 0.0, 0.0);
        let lost = 0.25 * unit * a;
        for (weight, lost) in [(weights[0], 0.0), (Double { hi: a, lo: lost }, lost)] {
            let (found, expected) = (single(weight), lost + ulps(&[a, a]));
            assert!((found / expected - 1.0).abs() < 1e-9, "{found:e} for {expected:e}");
        }
        let long = Recurrence::new(&vec![weights[0]; 2500], 0.0, None, Float::F32);
        assert_eq!(error(&long, 0.1, 0.2), f64::INFINITY);
    }

    /// Of six equal weights the recurrence's first number is 21 times as large, though a sum is nowhere more than six times.
    #[test]
    fn numbers_that_overflow() {
        let of_six =
            |weight: f64, float| error(&Recurrence::new(&[Double::new(weight); 6], 0.0, None, float), 0.0, 0.5);
        assert!(of_six(3e36, Float::F32).is_finite() && of_six(1e37, Float::F32).is_infinite());
        assert!(of_six(1e300, Float::F64).is_finite() && of_six(4e306, Float::F64).is_infinite());
    }

    /// The derivatives of Uⱼ by X, where they are largest.
    #[test]
    fn slopes_of_chebyshev_polynomials() {
        // U and its derivatives at X = 2.
        let (mut before, mut here) = ([0.0; 3], [1.0, 0.0, 0.0]);
        for j in 0..20 {
            assert_eq!([slope(f64::from(j)), bend(f64::from(j))], [here[1], here[2]], "{j}");
            let [u, first, second] = here;
            let next = [2.0 * u, u + 2.0 * first, 2.0 * (first + second)];
            (before, here) = (here, std::array::from_fn(|order| next[order] - before[order]));
        }
        for (low, high) in [(0.0, 0.1), (0.1, 0.2), (0.2, 0.3), (0.26, 0.5), (0.0, 0.5), (0.4, 0.55)] {
            let (middle, half) = (0.5 * PI * (low + high), 0.5 * PI * (high - low));
            let at = |i: u32| (2.0 * PI * (low + (high - low) * f64::from(i) / 1000.0)).sin().abs();
            let seen = (0..=1000).map(at).fold(0.0, f64::max);
            let found = steepest(middle, half);
            assert!(found >= seen - 1e-15 && found <= seen + 1e-5, "{low} to {high}: {found} for {seen}");
        }
    }

    /// What holds for an interval holds at each of its points; and not much more, if it is short.
    #[test]
    fn errors_of_intervals() {
        let mut random = Random::new(11);
        for _ in 0..2000 {
            let (count, decay) = (2 + (30.0 * random.unit()) as i32, 1.6 * random.unit() - 0.8);
            let weights: Vec<Double> = (0..count).map(|n| Double::new(f64::powi(decay, n))).collect();
            let sine = Some(1e-15).filter(|_| random.unit() < 0.5);
            let recurrence = Recurrence::new(&weights, 1e-15, sine, Float::F64);
            let low = 0.5 * random.unit();
            let high = low + f64::powf(10.0, -6.0 * random.unit()) * (0.5 - low);
            let bound = error(&recurrence, low, high);
            let at = |part: f64| low + part * (high - low);
            let points = worst([0.0, 0.1, 0.3, 0.5, 0.8, 1.0].map(at).map(|s| error(&recurrence, s, s)));
            assert!(bound >= points * (1.0 - 1e-9), "{count} {decay} {low} {high}: {bound:e} {points:e}");
            let short = (high - low) * f64::from(count * count) < 1e-3;
            assert!(!short || bound <= 1.5 * points, "{count} {decay} {low} {high}: {bound:e} {points:e}");
        }
    }

    /// In single precision, sums of random weights: no error is above its bound, and next to a turning point the
    /// largest is no small part of it.
    #[test]
    fn errors_that_occur() {
        let mut random = Random::new(7);
        for (count, decay, of_sines) in [(6, 0.3, false), (20, 0.7, false), (20, 0.7, true), (12, -0.6, false)] {
            let rounded = |x: f64| f64::from(x as f32);
            let mut weight = |n: i32| Double::new(rounded((0.5 + random.unit()) * f64::powi(-decay, n)));
            let weights: Vec<Double> = (0..count).map(&mut weight).collect();
            let wrong = 1e-7;
            let recurrence = Recurrence::new(&weights, wrong, of_sines.then_some(wrong), Float::F32);
            let mut b = Builder::new(Float::F32);
            let cosine = b.input();
            let (first, second) = clenshaw(&mut b, cosine, &weights);
            let program = b.finish(vec![first, second.unwrap()]);
            for slice in 0..32 {
                // Next to a turning point, and narrow elsewhere.
                let low = f64::from(slice) / 64.0;
                let high = low + if slice == 0 { 1.0 / 64.0 } else { 1e-3 };
                let bound = error(&recurrence, low, high);
                let mut largest = 0.0_f64;
                for _ in 0..2000 {
                    let s = low + (high - low) * random.unit();
                    let at = |phase: f64| (phase * PI).sin_cos();
                    let mut off = || wrong * (2.0 * random.unit() - 1.0);
                    let (sine, cosine) = at(s);
                    let given = cosine + off();
                    let given = rounded(given).clamp(cosine - wrong, cosine + wrong);
                    let factor = if of_sines { sine + off() } else { given };
                    if rounded(given) != given {
                        continue;
                    }
                    let found = program.run(given);
                    let last = if of_sines { found[0] + found[1] } else { found[0] - found[1] };
                    let found = rounded(factor) as f32 * last as f32;
                    let wave =
                        |n: usize| if of_sines { at((2 * n + 1) as f64 * s).0 } else { at((2 * n + 1) as f64 * s).1 };
                    let exact: f64 = weights.iter().enumerate().map(|(n, w)| w.hi * wave(n)).sum();
                    largest = largest.max((f64::from(found) - exact).abs());
                }
                let most = if slice == 0 { 3.5 } else { 10.0 };
                assert!(largest <= bound && bound <= most * largest, "{count} {slice}: {largest:e} of {bound:e}");
            }
        }
    }
}
