//! Reductions good for any time: its exact products with a rate in several words.

use super::{Clock, NARROWING, SECOND_ORDER, WIDENED};
use crate::parse::Float;
use crate::plan::reduction::words::{split_down, split_near};
use crate::plan::reduction::{Origin, Reduction, Scheme};
use crate::power::two_to;
use crate::program::rounding::half_ulp;

/// That of a sum just beyond ½ in `f64`, by which any time is reduced.
const SUM: f64 = f64::EPSILON / 4.0;

impl Clock<'_> {
    /// What the words leave, the roundings of the last part, and those of sums, relative to the result.
    pub(in crate::plan::reduction) fn any_time(&self, count: usize, origin: Origin, doubled: bool) -> Reduction {
        let words = split_near(self.rate, &[26, 25, 25][..count - 1]);
        let of_lost = if doubled { self.rounding_of_lost(&words) } else { 0.0 };
        let drift = self.drift(&words) + self.rounding_of_last_part(&words) + of_lost;
        let scheme = Scheme::AnyTime { words, doubled };
        // n is rounded from the leading parts: the last, below 2⁻²¹, may carry the remainder past half an anchor.
        let overshoot = two_to(-20);
        if origin == Origin::Lowest {
            return self.reduction(
                scheme,
                origin,
                [drift, (3.0 + SECOND_ORDER) * Float::F64.rounding_unit()],
                overshoot,
            );
        }
        let [sums, seldom] = self.rounding_of_sums(count, doubled);
        let relative = self.starts_on_half() || count == 4 && !doubled;
        let rounding = if relative { sums } else { 0.0 };
        Reduction { rounding, seldom, ..self.reduction(scheme, origin, [drift + sums, 0.0], overshoot) }
    }

    /// What sums are rounded by, and what of that is met only just beyond half an anchor, where results are rounded twice as
    /// much: of four words half. Of three sums one is that of [`Self::halfway`], or the first, which is exact where the last
    /// word's product matters; of four with a launch one is that with the launch for times of a few anchors only. Fewer
    /// words are wrong by more, and there all counts; in two words the last sum is rounded, and one with n.
    fn rounding_of_sums(&self, count: usize, doubled: bool) -> [f64; 2] {
        match (count, self.starts_on_half()) {
            (4, false) if !doubled => [4.0 * SUM + two_to(-75), 2.0 * SUM],
            (4, true) => [3.0 * SUM, SUM],
            (2 | 3, false) => [5.0 * SUM, 0.0],
            _ => [2.0 * SUM, 0.0],
        }
    }

    /// The last part is the time times the last word and its tail, below 2⁻²⁶ of it, times the word before: the first
    /// product is rounded, the other has few enough bits, and the sum is rounded.
    fn rounding_of_last_part(&self, words: &[f64]) -> f64 {
        let most = |word: usize| self.reach() * words[words.len() - word].abs() * WIDENED;
        let (last, before) = (most(1), most(2));
        half_ulp(last, Float::F64) + half_ulp(last + before * two_to(-26), Float::F64)
    }

    /// Sums in two words are exact but for what is rounded of what they lose: the launch's second word and the errors of
    /// four sums are added to the last part, together less than 2⁻⁵⁰, since no sum that is rounded is above 2.
    fn rounding_of_lost(&self, words: &[f64]) -> f64 {
        let last = self.reach() * words.last().map_or(0.0, |word| word.abs()) * WIDENED;
        5.0 * half_ulp(last + two_to(-50), Float::F64)
    }

    /// The first product is exact (24 + 29 bits), the second, below 2²⁶, is rounded, to 2⁻²⁸ at the end of the longest
    /// horizon, and so is its sum with the first less n, of up to an anchor.
    pub(super) fn wide_any_time(&self, origin: Origin) -> Reduction {
        let words = split_down(self.rate, 29, 2, Float::F64);
        let product = half_ulp(self.reach() * words[1] * WIDENED, Float::F64);
        let error = self.drift(&words) + product + 2.0 * SUM;
        self.wide_words(origin, words, error)
    }

    /// The same for motions that pass the lowest point within a thousandth of the time between anchors, and for pieces of
    /// such, which round remainders by less than a product with the second of two words: of three words the second product
    /// is exact, too, and the third below 2⁻³; what they leave is below 2⁻⁵⁶, and that product and two sums are rounded to
    /// 2⁻⁵⁴ at most.
    pub(super) fn fine_any_time(&self, origin: Origin) -> Reduction {
        self.wide_words(origin, split_down(self.rate, 29, 3, Float::F64), two_to(-52))
    }

    fn wide_words(&self, origin: Origin, words: Vec<f64>, error: f64) -> Reduction {
        // n is rounded from sums of up to 2²⁶ either way.
        let overshoot = two_to(-26);
        let errors = self.narrowed(error, overshoot, origin);
        let reduction = self.reduction(Scheme::WideAnyTime { words }, origin, errors, overshoot);
        Reduction { rounding: NARROWING, ..reduction }
    }
}
