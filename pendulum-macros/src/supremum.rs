//! Bounds over intervals, from bounds on parts of them; and norms.

use std::collections::BinaryHeap;

/// The largest of the errors, or the first that is above `cap`; infinite where one is no number.
pub(crate) fn largest(errors: impl Iterator<Item = f64>, cap: f64) -> f64 {
    let mut largest: f64 = 0.0;
    for error in errors {
        largest = largest.max(if error.is_nan() { f64::INFINITY } else { error });
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

/// The largest of the bounds on `cells`² slices of [low, high], or some number above `cap` if it is: of the cells as many
/// are sliced, in the order of their bounds, as may hold it.
pub(crate) fn by_slices([low, high]: [f64; 2], cells: u32, cap: f64, bound: impl Fn(f64, f64) -> f64) -> f64 {
    let parts = |[low, high]: [f64; 2]| {
        let at = move |index: u32| low + (high - low) * f64::from(index) / f64::from(cells);
        (0..cells).map(move |index| [at(index), at(index + 1)])
    };
    let bound = |[low, high]: [f64; 2]| worst([bound(low, high)]);
    let mut open: Vec<(f64, [f64; 2])> = parts([low, high]).map(|cell| (bound(cell), cell)).collect();
    open.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut found: f64 = 0.0;
    for (most, cell) in open {
        if most <= found || found > cap {
            break;
        }
        found = found.max(largest(parts(cell).map(bound), cap));
    }
    found
}

/// Bounds a function on [low, high], given one on any interval, by halving the interval with the largest bound: until
/// that gains less than a thirtieth, or `most` times.
pub(crate) fn by_halves([low, high]: [f64; 2], cells: u32, most: usize, bound: impl Fn(f64, f64) -> f64) -> f64 {
    const GAIN: f64 = 0.97;
    let at = |index: u32| low + (high - low) * f64::from(index) / f64::from(cells);
    let cell = |low: f64, high: f64| [worst([bound(low, high)]), low, high];
    // Numbers that are positive have the order of their bits.
    let ordered = |cell: [f64; 3]| cell.map(f64::to_bits);
    let mut open: BinaryHeap<[u64; 3]> = (0..cells).map(|index| ordered(cell(at(index), at(index + 1)))).collect();
    let mut settled: f64 = 0.0;
    for _ in 0..most {
        let worst = open.peek().map(|worst| worst.map(f64::from_bits));
        let Some([before, low, high]) = worst.filter(|&[worst, ..]| worst > settled) else { break };
        open.pop();
        let middle = 0.5 * (low + high);
        let halves = [cell(low, middle), cell(middle, high)];
        let after = halves[0][0].max(halves[1][0]);
        if before.is_finite() && after > GAIN * before {
            settled = settled.max(after);
        } else {
            open.extend(halves.map(ordered));
        }
    }
    open.peek().map_or(settled, |&[worst, ..]| settled.max(f64::from_bits(worst)))
}

/// √Σx², also where the squares overflow or underflow.
pub(crate) fn norm(parts: impl Iterator<Item = f64>) -> f64 {
    const FAR: f64 = 3.273_390_607_896_142e150; // 2⁵⁰⁰
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

    #[test]
    fn halving_finds_a_narrow_peak() {
        // sup of s/(s² + a²) is 1/(2a), at s = a.
        let a = 1e-6;
        let bound = |low: f64, high: f64| high / (low * low + a * a);
        let found = by_halves([0.0, 1.0], 16, 200, bound);
        assert!(found >= 0.5 / a && found < 0.56 / a, "{found}");
        assert_eq!(by_halves([0.0, 1.0], 4, 10, |low, _| if low == 0.0 { f64::INFINITY } else { 1.0 }), f64::INFINITY);
    }

    /// The same as of all slices, of which no more are looked at than have to be.
    #[test]
    fn slices() {
        let looked = std::cell::Cell::new(0);
        let bound = |low: f64, high: f64| {
            looked.set(looked.get() + 1);
            // Of a parabola with its summit at 0.3, and something for the width.
            let nearest = 0.3_f64.clamp(low, high);
            1.0 - (nearest - 0.3).powi(2) + 0.01 * (high - low)
        };
        let all = |cells: u32| {
            let at = |index: u32| f64::from(index) / f64::from(cells * cells);
            worst((0..cells * cells).map(|index| bound(at(index), at(index + 1))))
        };
        let expected = all(8);
        looked.set(0);
        assert!((by_slices([0.0, 1.0], 8, f64::INFINITY, bound) - expected).abs() < 1e-15);
        assert!(looked.get() <= 24, "{}", looked.get());
        looked.set(0);
        assert!(by_slices([0.0, 1.0], 8, 0.5, bound) > 0.5);
        assert!(looked.get() <= 9, "{}", looked.get());
        assert_eq!(by_slices([0.0, 1.0], 4, 10.0, |_, high| if high == 1.0 { f64::NAN } else { 1.0 }), f64::INFINITY);
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
