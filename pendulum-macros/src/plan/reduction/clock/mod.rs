//! The reductions that a motion can choose from, and how wrong each is.

mod any_time;

use super::words::split_down;
use super::{LINEAR_HALF, Origin, ROUNDED, Reduction, Scheme, is_half};
use crate::exact::Real;
use crate::motion::Swing;
use crate::parse::Float;
use crate::power::{exponent, is_power_of_two, two_to};
use crate::program::rounding::half_ulp;
use crate::scene::Scene;
use pendulum_runtime::double::Double;

/// The longest horizon in anchors, 2⁵⁴: 2⁵³ periods of a swing, which passes two in each.
const UNLIMITED: f64 = two_to(54);

/// The rounding of remainders up to ½ as they become `f32`.
const NARROWING: f64 = f32::EPSILON as f64 / 8.0;

/// Roundings of what is rounded, in units of the one that is counted: each is 2⁻²⁴ of it at most.
const SECOND_ORDER: f64 = 0.001;

/// What errors are multiplied with for it; and magnitudes, since a number next to a power of two may be above it once it is
/// rounded.
const WIDENED: f64 = 1.0 + SECOND_ORDER;

/// Launches, in anchors from a half, up to which roundings of differences are counted in proportion, as without one. At half
/// an anchor that may be twice as much as they are; so farther from there the largest is counted.
const NEXT_TO_HALF: f64 = 1.0 / 64.0;

/// What a rate in one word may differ by.
const OF_RATE: f64 = 1.0 + ROUNDED;

/// What all reductions of one motion start from.
pub(crate) struct Clock<'a> {
    /// Anchors per unit of time.
    pub(crate) rate: &'a Real,
    pub(crate) launch: Double,
    /// The greatest |t| promised.
    pub(crate) horizon: f64,
    pub(crate) float: Float,
}

/// The time times the rate in one word, how wrong that is, and how far the remainder may be beyond its range.
struct Product {
    rate: f64,
    error: f64,
    overshoot: f64,
}

impl<'a> Clock<'a> {
    /// For the horizon and the float of a scene.
    pub(crate) fn new(scene: &Scene, rate: &'a Real, launch: &Real) -> Self {
        Self { rate, launch: launch.to_double(), horizon: scene.horizon(), float: scene.float }
    }

    /// The greatest |t| at which a phase at this rate is any good. Eq. 3, whose rate isn't the motion's, may be asked for
    /// more by default; what it is wrong by is then all that it can be (`paper/bias/mod.rs`).
    pub(crate) fn reach(&self) -> f64 {
        self.horizon.min(UNLIMITED / self.rate.to_f64()).min(f64::MAX)
    }

    /// How many anchors are passed until then.
    fn anchors(&self) -> f64 {
        self.reach() * self.rate.to_f64()
    }

    /// Every reduction that is valid over the horizon.
    pub(crate) fn reductions(&self) -> Vec<Reduction> {
        let short = [
            self.one_word(),
            self.scaled(),
            self.cody_waite(2, Origin::Anchor),
            self.cody_waite(3, Origin::Anchor),
            self.cody_waite(2, Origin::Lowest),
            self.cody_waite(3, Origin::Lowest),
        ];
        let any_time = match self.float {
            Float::F64 => self.in_words(),
            Float::F32 => self.in_wider(),
        };
        short.into_iter().flatten().chain(any_time).filter(Reduction::is_useful).collect()
    }

    /// Of `f64` times, with the rate in two to four words.
    fn in_words(&self) -> Vec<Reduction> {
        let launched = !self.starts_on_half();
        let from_anchor = [2, 3, 4].map(|words| self.any_time(words, Origin::Anchor, false));
        let from_lowest = self.any_time(4, Origin::Lowest, launched);
        let doubled = launched.then(|| self.any_time(4, Origin::Anchor, true));
        from_anchor.into_iter().chain([from_lowest]).chain(doubled).collect()
    }

    /// Of `f32` times, in `f64`.
    fn in_wider(&self) -> Vec<Reduction> {
        let origins = [Origin::Anchor, Origin::Lowest];
        let in_one_word = origins.into_iter().filter_map(|origin| self.wide(origin));
        let any_time = origins.into_iter().flat_map(|origin| [self.wide_any_time(origin), self.fine_any_time(origin)]);
        in_one_word.chain(any_time).collect()
    }

    /// The same, of a swing.
    pub(crate) fn of_swing(&self, swing: &Swing) -> Vec<Reduction> {
        let reductions = self.reductions();
        let released = swing.launch.is_zero();
        reductions.into_iter().map(|reduction| if released { reduction.released() } else { reduction }).collect()
    }

    fn reduction(
        &self,
        scheme: Scheme,
        origin: Origin,
        [error, relative_error]: [f64; 2],
        overshoot: f64,
    ) -> Reduction {
        let (scale, cap) = self.within_range(&scheme);
        let unit = match scheme {
            Scheme::CodyWaite { .. } => self.rate.to_double(),
            Scheme::Scaled { anchor, .. } => Double::ONE / (anchor * scale),
            _ => Double::new(1.0 / scale),
        };
        // The launch phase is added in two words where there are any. Where it is a rounded time, that has been
        // counted.
        let counted = self.starts_on_half() || matches!(scheme, Scheme::AnyTime { .. } | Scheme::CodyWaite { .. });
        let wide = matches!(scheme, Scheme::Wide { .. } | Scheme::WideAnyTime { .. });
        let added_in = if wide { Float::F64 } else { self.float };
        let launch_error = if counted { 0.0 } else { 2.0 * half_ulp(0.5, added_in) };
        // Added last, it takes the remainder beyond half an anchor by what it is rounded by.
        let [error, overshoot] = [error, overshoot].map(|of_time| of_time + launch_error);
        let without_error = Reduction::exact(scheme, origin, self.float);
        Reduction { launch: self.launch, error, relative_error, overshoot, unit, scale, cap, ..without_error }
    }

    /// What keeps the product of the time with its factor from overflowing: a power of two beside a factor above 1, or,
    /// of factors so large that powers of the phase would get out of hand, a cap of the time. Products of Cody and
    /// Waite's overflow beyond the horizon only, without harm; those of `f32` times with `f64` words don't.
    fn within_range(&self, scheme: &Scheme) -> (f64, Option<f64>) {
        let rate = self.rate.to_f64();
        let factor = match scheme {
            Scheme::OneWord { .. } | Scheme::AnyTime { .. } => rate,
            Scheme::Scaled { scaled, .. } => rate.max(*scaled),
            _ => 0.0,
        };
        let (halvings, most) = match self.float {
            Float::F64 => (18, two_to(1000)),
            Float::F32 => (3, two_to(120)),
        };
        match 1 + exponent(factor) {
            _ if factor < 0.99 => (1.0, None),
            needed if needed <= halvings => (two_to(-needed), None),
            _ => (1.0, Some(self.float.round(most / factor))),
        }
    }

    fn one_word(&self) -> Option<Reduction> {
        let Product { rate, error, overshoot } = self.product(Origin::Anchor, self.float)?;
        Some(self.reduction(Scheme::OneWord { rate }, Origin::Anchor, [error, 0.0], overshoot))
    }

    /// The error is |t|·|R − fl(R)| and the rounding of the product; the subtraction of n is exact.
    ///
    /// With another phase at t = 0 n is rounded from a rounded sum: just below a power of two that is in the binade above,
    /// where a tie can go either way, and the remainder is beyond half an anchor, or half a piece, by as much.
    fn product(&self, origin: Origin, float: Float) -> Option<Product> {
        let anchors = self.anchors();
        let rate = float.round(self.rate.to_f64());
        let error = self.drift(&[rate]) + self.rounding_in_one_word(anchors, float);
        let overshoot = 2.0 * self.rounding_of_sum(origin, float);
        // Beyond, the sum that rounds has no odd numbers.
        (anchors < float.magic() / 8.0).then_some(Product { rate, error, overshoot })
    }

    /// The rounding of the sum of which n is the nearest number, where an origin isn't passed at t = 0.
    fn rounding_of_sum(&self, origin: Origin, float: Float) -> f64 {
        let without = origin == Origin::Anchor && self.launch == Double::ZERO;
        if without { 0.0 } else { half_ulp(self.anchors() * WIDENED + 1.0, float) }
    }

    /// |t|·|AR − R′|, the rounding of the product t·R′ (least for its digits where the last of them stands just below a
    /// power of two), and that of the difference, if |t| is about half an anchor; in units of which an anchor has A.
    fn scaled(&self) -> Option<Reduction> {
        const TRIED: u32 = 64;
        let anchors = self.anchors();
        let bits = self.float.bits() - libm::log2(anchors + 2.0).ceil() as i32;
        if self.launch != Double::ZERO || bits < 8 {
            return None;
        }
        // The last product is to stay below a power of two.
        let least = two_to(1 - bits);
        let top = 0.998 * two_to(libm::log2(anchors).ceil() as i32) / anchors;
        let top = (top.clamp(1.0, 2.0) / least).floor();
        let rate = self.rate.to_double();
        let off = |anchor: f64| {
            let product = rate * anchor;
            (product - Double::new(self.float.round(product.hi))).hi.abs() / anchor
        };
        let anchor = (0..TRIED).map(|index| (top - f64::from(index)) * least).filter(|&anchor| anchor >= 1.0);
        let anchor = anchor.min_by(|&a, &b| off(a).total_cmp(&off(b)))?;
        let scaled = self.float.round((rate * anchor).hi);
        let rounding = half_ulp(anchors * anchor * WIDENED, self.float) + half_ulp(anchor, self.float);
        let left = self.rate - self.real(scaled) / self.real(anchor);
        let error = self.over_horizon(&left) * WIDENED + rounding / anchor;
        let rate = self.float.round(rate.hi);
        let scheme = Scheme::Scaled { rate, scaled, anchor };
        let overshoot = self.misplaced(rate, Origin::Anchor, error);
        Some(self.reduction(scheme, Origin::Anchor, [error, 0.0], overshoot))
    }

    /// With n < 2ᵏ anchors (half anchors) over the horizon and p bits a word, all words but the last have p − k bits.
    fn cody_waite(&self, count: usize, origin: Origin) -> Option<Reduction> {
        let anchors = (self.anchors() + 1.0).max(2.0);
        let k = libm::log2(anchors).floor() as i32 + 2;
        let p = self.float.bits();
        if k > 2 * p / 3 || !self.has_moderate_multiples() {
            return None;
        }
        let time = self.rate.context().integer(1) / self.rate;
        let words = split_down(&time, p - k, count, self.float);
        if words.iter().any(|w| *w != 0.0 && w.abs() < *self.float.moderate().start()) {
            return None;
        }
        let rate = self.float.round(self.rate.to_f64());
        let left = words.iter().fold(time, |rest, &word| rest - self.real(word)).abs().to_f64();
        let last = words.last().copied().unwrap_or(0.0).abs();
        // Of three words the second difference is rounded, too, and half-way between two origins all three are.
        let (differences, escape) =
            if self.halfway(origin) { (count, 0.0) } else { (count - 1, self.escape_of_first_difference(rate)) };
        let drift = (anchors * left + half_ulp(anchors * last, self.float) + escape) * rate * OF_RATE;
        let rounding = |anchors: f64| half_ulp(anchors / rate * WIDENED, self.float) * rate * OF_RATE;
        let farthest = 0.5 + self.misplaced(rate, origin, 0.0);
        // Another launch than a half is added last: a constant, after differences that are farther from 0 by as much.
        let launch = self.distance_from_half();
        let (of_launch, sums) = if self.starts_on_half() { (0.0, 0.0) } else { (rounding(launch), 1.0) };
        let (differences, unit) = (differences as f64, self.float.rounding_unit() * WIDENED);
        let of_all = drift + differences * rounding(farthest + launch) + of_launch;
        let errors = match origin {
            Origin::Anchor => [of_all + sums * rounding(farthest), 0.0],
            // Each by a unit of the remainder and of the launch.
            Origin::Lowest if launch < NEXT_TO_HALF => {
                [drift + differences * unit * launch + of_launch, (differences + sums) * unit]
            }
            Origin::Lowest => [of_all, unit],
        };
        let overshoot = self.misplaced(rate, origin, errors[0] + errors[1]);
        Some(self.reduction(Scheme::CodyWaite { rate, words }, origin, errors, overshoot))
    }

    /// Next to an origin the first difference is exact by Sterbenz's lemma, or as a multiple of t's unit within t's binade;
    /// only a time about half an anchor, no farther from it than a launch moves it, where a power of two is, escapes both.
    fn escape_of_first_difference(&self, rate: f64) -> f64 {
        let launch = self.distance_from_half();
        let [nearest, farthest] = [0.5 - launch, 0.5 + launch].map(|anchors| anchors / rate);
        let crosses = exponent(farthest * OF_RATE) != exponent(nearest / OF_RATE);
        if crosses { half_ulp(farthest * WIDENED, self.float) } else { 0.0 }
    }

    /// Whether the time between anchors is one whose multiples, up to one beyond the horizon, and whose product with the
    /// launch in two words neither over- nor underflow.
    fn has_moderate_multiples(&self) -> bool {
        let time = 1.0 / self.rate.to_f64();
        Float::F64.moderate().contains(&time) && self.reach() + time < self.float.largest() / 4.0
    }

    /// How far beyond half an anchor a remainder, wrong by `error`, may be that isn't what n was rounded from: by what
    /// the rate in one word is off by, and the roundings of its product with the time and of the sum with the launch.
    fn misplaced(&self, rate: f64, origin: Origin, error: f64) -> f64 {
        let drift = self.drift(&[rate]);
        let product = half_ulp(self.anchors() * WIDENED, self.float);
        (drift + product + self.rounding_of_sum(origin, self.float) + error) * WIDENED
    }

    fn wide(&self, origin: Origin) -> Option<Reduction> {
        let Product { rate, error, overshoot } = self.product(origin, Float::F64)?;
        let errors = self.narrowed(error, overshoot, origin);
        let reduction = self.reduction(Scheme::Wide { rate }, origin, errors, overshoot);
        Some(Reduction { rounding: NARROWING, ..reduction })
    }

    /// The time of the separatrix, `rate` being ω and `launch` the phase ωt from the lowest point. Rounded are R, the
    /// product, unless with a power of two, and, with a launch, two differences; of `f32` all but the last in `f64`.
    pub(crate) fn linear(&self) -> Reduction {
        // So that t₀ overflows for no R, and its second word doesn't underflow where that matters.
        let power = match exponent(self.rate.to_f64()) {
            ..-900 => -200,
            900.. => 200,
            _ => 0,
        };
        let rate = self.rate.scale(-power).to_double();
        let launch = self.launch.hi.abs();
        let furthest = (self.anchors() + launch) * (1.0 + 8.0 * self.float.rounding_unit());
        let half = self.float.round(furthest).min(LINEAR_HALF);
        let (passed, times) = (-(self.launch / rate), libm::exp2(power as f64));
        let scheme = Scheme::Linear { rate: rate.hi, passed, times, half };
        let product = if is_power_of_two(rate.hi) { 0.0 } else { 1.0 };
        let of_rate = (rate.lo / rate.hi).abs() / Float::F64.rounding_unit();
        let roundings = match (product + of_rate, self.float) {
            (roundings, Float::F64) if launch == 0.0 => roundings,
            (roundings, Float::F64) => roundings + 2.0,
            (0.0, Float::F32) if launch == 0.0 => 0.0,
            (_, Float::F32) => 1.0,
        };
        Reduction {
            launch: self.launch,
            error: (launch + 1.0) * two_to(-74),
            relative_error: if roundings == 0.0 {
                0.0
            } else {
                (roundings + SECOND_ORDER) * self.float.rounding_unit()
            },
            ..Reduction::exact(scheme, Origin::Lowest, self.float)
        }
    }

    /// What the conversion of the phase to `f32` adds. Beyond half an anchor numbers are twice as far apart, but next to
    /// it none is farther from one than from ½.
    fn narrowed(&self, error: f64, overshoot: f64, origin: Origin) -> [f64; 2] {
        match origin {
            Origin::Anchor => [error + overshoot.clamp(NARROWING, 2.0 * NARROWING), 0.0],
            Origin::Lowest => [error, self.float.rounding_unit() * WIDENED],
        }
    }

    /// The rounding of the product of time and rate; of one below ½, and of its sum with half an anchor, if that is
    /// less.
    fn rounding_in_one_word(&self, anchors: f64, float: Float) -> f64 {
        let of_sum = if self.launch == Double::ZERO { 0.0 } else { half_ulp(0.49, float) + half_ulp(0.5, float) };
        half_ulp(anchors * WIDENED, float).max(of_sum)
    }

    /// Whether halves of an anchor, which are no matter of rounding, are passed at t = 0.
    fn starts_on_half(&self) -> bool {
        is_half(self.launch)
    }

    /// How many anchors are passed at t = 0, to the nearest half.
    fn nearest_half(&self) -> f64 {
        0.5 * (2.0 * self.launch.hi).round_ties_even()
    }

    /// How far from there t = 0 is, in anchors.
    fn distance_from_half(&self) -> f64 {
        (self.launch - Double::new(self.nearest_half())).hi.abs()
    }

    /// Whether t = 0 is half-way between two origins, or next to there. The phase is then what half an anchor is more than
    /// a small time of finer digits: this difference is rounded, too, if it is above a quarter of an anchor.
    fn halfway(&self, origin: Origin) -> bool {
        let from_origin = self.nearest_half() - if origin == Origin::Anchor { 0.5 } else { 0.0 };
        from_origin.fract() == 0.0
    }

    fn real(&self, x: f64) -> Real {
        self.rate.context().float(x).unwrap_or_else(|| self.rate.context().integer(0))
    }

    /// |t|·|R − Σ words| at the end of the horizon. What words leave may be below every `f64` where that is not.
    fn drift(&self, words: &[f64]) -> f64 {
        self.over_horizon(&words.iter().fold(self.rate.clone(), |rest, &word| rest - self.real(word)))
    }

    /// What a rate comes to by then.
    fn over_horizon(&self, rate: &Real) -> f64 {
        (rate.abs() * self.real(self.reach())).to_f64()
    }
}

#[cfg(test)]
mod tests;
