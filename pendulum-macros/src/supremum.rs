//! Bounds over intervals, from bounds on parts of them; and norms.

use crate::power::two_to;
use std::collections::BinaryHeap;

/// The larger of two errors; infinite if one is no number.
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a >= b {
        a
    } else if b > a {
        b
    } else {
        f64::INFINITY
    }
}

/// The largest of the errors, or the first that is above `cap`; infinite where one is no number.
pub(crate) fn largest(errors: impl Iterator<Item = f64>, cap: f64) -> f64 {
    let mut largest: f64 = 0.0;
    for error in errors {
        largest = larger(largest, error);
        if largest > cap {
            break;
        }
    }
    largest
}

/// The largest of them all; infinite where one is no number.
pub(crate) fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    largest(errors.into_iter(), f64::INFINITY)
}

/// How the largest value of a function is bounded by bounds on parts of an interval: the part with the largest bound is
/// halved, until that gains less than 3 %.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Halving {
    /// The parts at first.
    pub(crate) cells: u32,
    /// Parts wider than a slice are halved whatever that gains; so many slices are as long as the interval.
    pub(crate) slices: u32,
    /// Parts that are halved at most; four times as many where the bound is next to the cap, and more may tell on which
    /// side of it.
    pub(crate) most: usize,
    /// What is below this is as good as nothing, and bounded no better.
    pub(crate) least: f64,
    /// What is above this is good for nothing, and bounded no better.
    pub(crate) cap: f64,
}

impl Halving {
    /// Bounds a function on [low, high], given a bound on any interval; or, once that is known to exceed the cap, gives some
    /// number above the cap, which bounds nothing.
    pub(crate) fn largest(self, [low, high]: [f64; 2], bound: impl Fn(f64, f64) -> f64) -> f64 {
        const GAIN: f64 = 0.97;
        const NARROW: f64 = 1.0 / 512.0;
        let at = |index: u32| {
            if index == self.cells { high } else { low + (high - low) * f64::from(index) / f64::from(self.cells) }
        };
        let slice = 1.001 * (high - low) / f64::from(self.slices);
        let part = |low: f64, high: f64| [worst([bound(low, high)]), low, high];
        // Bounds, which aren't negative, have the order of their bits; of the ends none is needed.
        let ordered = |part: [f64; 3]| part.map(f64::to_bits);
        let mut open: BinaryHeap<[u64; 3]> =
            (0..self.cells).map(|index| ordered(part(at(index), at(index + 1)))).collect();
        let mut settled: f64 = 0.0;
        for halved in 0..4 * self.most {
            let worst = open.peek().map(|worst| worst.map(f64::from_bits));
            let Some([before, low, high]) = worst.filter(|&[worst, ..]| worst > settled.max(self.least)) else { break };
            if halved >= self.most && !self.is_next_to_cap(before) {
                break;
            }
            open.pop();
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                // There is no number between its ends.
                settled = settled.max(before);
                continue;
            }
            if before > self.cap {
                // Where a narrow part isn't bounded below the cap the whole won't be either, however it is halved.
                let [there, ..] = part(middle, middle + NARROW * (high - low));
                if there > self.cap {
                    return there;
                }
            }
            let halves = [part(low, middle), part(middle, high)];
            let after = halves[0][0].max(halves[1][0]);
            if before.is_finite() && after > GAIN * before && high - low <= slice {
                settled = settled.max(after);
                if settled > self.cap {
                    break;
                }
            } else {
                open.extend(halves.map(ordered));
            }
        }
        open.peek().map_or(settled, |&[worst, ..]| settled.max(f64::from_bits(worst)))
    }

    fn is_next_to_cap(&self, bound: f64) -> bool {
        const NEXT: f64 = 0.1;
        (bound - self.cap).abs() <= NEXT * self.cap && self.cap.is_finite()
    }
}

/// The same from so many cells on, halving so many at most.
pub(crate) fn by_halves(interval: [f64; 2], cells: u32, most: usize, bound: impl Fn(f64, f64) -> f64) -> f64 {
    Halving { cells, slices: cells, most, least: 0.0, cap: f64::INFINITY }.largest(interval, bound)
}

/// √Σx², also where the squares overflow or underflow.
pub(crate) fn norm(parts: impl Iterator<Item = f64>) -> f64 {
    const FAR: f64 = two_to(500);
    let parts: Vec<f64> = parts.collect();
    let scaled = |factor: f64| parts.iter().map(|x| x * factor).map(|x| x * x).sum::<f64>().sqrt() / factor;
    match parts.iter().fold(0.0, |most: f64, x| most.max(x.abs())) {
        most if most > FAR => scaled(1.0 / (FAR * FAR)),
        most if most < 1.0 / FAR => scaled(FAR * FAR),
        _ => scaled(1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// To the last number, whatever the cells.
    #[test]
    fn halving_reaches_the_end() {
        for i in 1..100 {
            let (low, high) = (-0.01 * f64::from(i), 0.37 / f64::from(i));
            assert_eq!(by_halves([low, high], 96, 0, |_, high| high + 1.0), high + 1.0, "{low} {high}");
        }
    }

    #[test]
    fn halving_finds_a_narrow_peak() {
        // sup of s/(s² + a²) is 1/(2a), at s = a.
        let a = 1e-6;
        let bound = |low: f64, high: f64| high / (low * low + a * a);
        let found = by_halves([0.0, 1.0], 16, 200, bound);
        assert!(found >= 0.5 / a && found < 0.56 / a, "{found}");
        assert_eq!(by_halves([0.0, 1.0], 4, 10, |low, _| if low == 0.0 { f64::INFINITY } else { 1.0 }), f64::INFINITY);
    }

    /// Never above all slices, and not far from the function where that counts, of which few parts are looked at.
    #[test]
    fn slices() {
        let looked = std::cell::Cell::new(0);
        let bound = |low: f64, high: f64| {
            looked.set(looked.get() + 1);
            // Of a parabola with its summit at 0.3, and something for the width.
            let nearest = 0.3_f64.clamp(low, high);
            1.0 - (nearest - 0.3).powi(2) + (high - low)
        };
        let at = |index: u32| f64::from(index) / 64.0;
        let all = worst((0..64).map(|index| bound(at(index), at(index + 1))));
        let halving = Halving { cells: 8, slices: 64, most: 64, least: 0.0, cap: f64::INFINITY };
        looked.set(0);
        let found = halving.largest([0.0, 1.0], bound);
        assert!(found <= all && found < 1.04, "{found} {all}");
        assert!(looked.get() <= 100, "{}", looked.get());
        looked.set(0);
        assert!(Halving { cap: 0.5, ..halving }.largest([0.0, 1.0], bound) > 0.5);
        assert!(looked.get() <= 60, "{}", looked.get());
        looked.set(0);
        let found = Halving { least: 2.0, ..halving }.largest([0.0, 1.0], bound);
        assert!(found >= all && looked.get() == 8, "{found} {}", looked.get());
        let nowhere = |_: f64, high: f64| if high == 1.0 { f64::NAN } else { 1.0 };
        assert_eq!(halving.largest([0.0, 1.0], nowhere), f64::INFINITY);
    }

    /// Where more halving may tell whether a bound is above the cap it is gone on with, elsewhere not.
    #[test]
    fn what_is_next_to_the_cap_is_halved_more_often() {
        let halved = |cap: f64| {
            let looked = std::cell::Cell::new(0);
            let bound = |low: f64, high: f64| {
                looked.set(looked.get() + 1);
                1.0 + 32.0 * (high - low)
            };
            let halving = Halving { cells: 8, slices: 4096, most: 16, least: 0.0, cap };
            (halving.largest([0.0, 1.0], bound), looked.get())
        };
        let (at_last, far) = halved(0.5);
        assert!(at_last > 0.5 && far < 12, "{at_last} {far}");
        for cap in [8.0, f64::INFINITY] {
            assert_eq!(halved(cap), (3.0, 8 + 2 * 16), "{cap}");
        }
        assert_eq!(halved(2.9).0, 2.0);
    }

    /// Beyond the interval the function may be anything.
    #[test]
    fn nothing_beyond_the_interval_is_looked_at() {
        let bound = |low: f64, high: f64| {
            assert!(0.0 <= low && high <= 1.0, "{low} {high}");
            if high == 1.0 && high - low > 1e-5 { f64::INFINITY } else { 1.0 }
        };
        assert_eq!(Halving { cells: 8, slices: 64, most: 64, least: 0.0, cap: 2.0 }.largest([0.0, 1.0], bound), 1.0);
    }

    /// An interval of next to no numbers, or of one, isn't halved.
    #[test]
    fn what_cannot_be_halved() {
        for (high, most) in [(1.0, 8), (1.0_f64.next_up(), 8), (1.0_f64.next_up().next_up(), 20)] {
            let looked = std::cell::Cell::new(0);
            let bound = |low: f64, high: f64| {
                looked.set(looked.get() + 1);
                1.0 + low + high
            };
            assert_eq!(by_halves([1.0, high], 8, 1000, bound), 1.0 + high + high);
            assert!(looked.get() <= most, "{high}: {}", looked.get());
        }
    }

    /// A bound is cut short only where it is above the cap.
    #[test]
    fn what_is_not_above_the_cap_goes_on() {
        let largest = |cap: f64| largest([1.0, 0.5, 2.0, 3.0].into_iter(), cap);
        assert_eq!([0.9, 1.0, 1.5, 2.0, f64::INFINITY].map(largest), [1.0, 2.0, 2.0, 3.0, 3.0]);
        assert_eq!([worst([1.0, f64::NAN, 2.0]), worst([1.0, 2.0, 0.5]), worst([])], [f64::INFINITY, 2.0, 0.0]);
    }

    #[test]
    fn norms_of_all_sizes() {
        for scale in [1e-316, 1e-200, 1.0, 1e200, 1e300, 2e307] {
            let found = norm([3.0 * scale, 4.0 * scale].into_iter());
            // A subnormal has few digits.
            assert!((found / (5.0 * scale) - 1.0).abs() < 1e-8, "{scale:e}: {found:e}");
        }
        assert_eq!(norm([].into_iter()), 0.0);
        assert_eq!(norm([f64::INFINITY].into_iter()), f64::INFINITY);
    }

    /// From the first number to the last, whole or in cells.
    #[test]
    fn halving_covers_its_interval() {
        for most in [0, 3] {
            assert_eq!(by_halves([1.0, 3.0], 4, most, |_, high| high), 3.0);
            assert_eq!(by_halves([1.0, 3.0], 4, most, |low, _| 1.0 / low), 1.0);
        }
    }
}
