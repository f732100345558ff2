use super::*;
use crate::double_trig::half_angle;
use crate::kernel::power as power_of;

/// Amplitudes, in parts of π, and numbers of terms.
const SERIES: [(f64, usize); 4] = [(0.3, 1), (0.7, 2), (0.95, 6), (0.999, 9)];

fn analyses() -> impl Iterator<Item = (FourierAnalysis, usize)> {
    SERIES.into_iter().map(|(amplitude, terms)| {
        let (k, kc) = half_angle(Double::PI * amplitude);
        (FourierAnalysis::new(k, kc), terms)
    })
}

/// k b₂ₙ₋₁ beyond the first `terms`, with 2n − 1, as far as they count.
fn neglected(analysis: &FourierAnalysis, terms: usize) -> [(f64, f64); 200] {
    let term = |n: usize| ((2 * n - 1) as f64, (analysis.k * analysis.coefficient(n)).to_f64());
    core::array::from_fn(|i| term(terms + 1 + i))
}

/// |2 asin(y − ρ) − 2 asin y| as it is defined, also where y − ρ has the other sign, which only phases next to the zero
/// crossing meet, where nothing is largest.
#[test]
fn distances_of_arcsines() {
    for y in [0.1, 0.5, 0.9] {
        for tail in [-0.05, -1e-6, 0.0, 1e-6, 0.05, 0.1, 0.3, 0.7] {
            let x: f64 = y - tail;
            let margin = (1.0 - x) * (1.0 + x);
            let exact = 2.0 * (libm::asin(x) - libm::asin(y)).abs();
            let error = (distance(y, sqrt((1.0 - y) * (1.0 + y)), tail, margin) - exact).abs();
            // The difference of the library's arcsines loses units in the last place of each.
            assert!(error <= 1e-15, "{y} {tail}: {error:e}");
        }
    }
}

/// By multiprecision, at 1/16, 1/8, 3/16 and 15/64 of a period from the crossing.
#[test]
fn cosines_of_half_angles() {
    for (kc, exact) in [
        (
            1e-3,
            [0.247_573_188_254_172_16, 0.031_622_776_601_683_79, 0.004_039_209_605_255_58, 0.001_137_393_591_100_890_9],
        ),
        (1e-6, [0.044_699_010_050_557_89, 1e-3, 2.237_186_011_209_031_2e-5, 1.486_349_380_855_725_5e-6]),
        (1e-10, [0.004_472_113_594_431_608, 1e-5, 2.236_079_157_839_677e-8, 2.408_044_452_935_900_6e-10]),
        (1e-20, [1.414_213_562_302_384_4e-5, 1e-10, 7.071_067_812_219_028e-16, 9.721_920_700_877_319e-20]),
    ] {
        let kc = Double::new(kc);
        let analysis = FourierAnalysis::new((Double::ONE - kc * kc).sqrt(), kc);
        for (z, exact) in [1.0 / 16.0, 1.0 / 8.0, 3.0 / 16.0, 15.0 / 64.0].into_iter().zip(exact) {
            let ratio = analysis.dn(z) / exact;
            assert!((ratio - 1.0).abs() <= 4.0 * f64::EPSILON, "{kc:?} {z}: {ratio}");
        }
        assert_eq!(analysis.dn(0.25), kc.hi);
    }
}

#[test]
fn harmonics_over_several_turns() {
    for i in 0..3000 {
        let z = f64::from(i) * 1.01e-3;
        let (sine, cosine) = libm::sincos(core::f64::consts::TAU * z);
        // The library's argument is rounded.
        let slack = 4.0 * f64::EPSILON * (1.0 + z);
        let ours = harmonic(z);
        assert!((ours.0 - sine).abs() <= slack && (ours.1 - cosine).abs() <= slack, "{z}");
    }
}

/// The recurrence against the terms one by one: the certified bound stands on the slope and on the moments.
#[test]
fn the_tail_and_its_slope_term_by_term() {
    for (analysis, terms) in analyses() {
        let neglected = neglected(&analysis, terms);
        let total: f64 = neglected.iter().map(|(odd, amplitude)| odd * amplitude).sum();
        for z in [0.0, 0.013, 0.1, 0.177, 0.25] {
            let sum = |wave: fn(f64) -> f64, power: i32| -> f64 {
                let term = |&(odd, amplitude): &(f64, f64)| {
                    amplitude * power_of(odd, power) * wave(core::f64::consts::TAU * z * odd)
                };
                neglected.iter().map(term).sum()
            };
            let tail = analysis.tail(terms, z);
            // The recurrence's error grows with the number of steps, and its arguments are rounded.
            let slack = 1e-13 * total;
            assert!((tail.value - sum(libm::sin, 0)).abs() <= slack, "{terms} {z}");
            assert!((tail.slope - sum(libm::cos, 1)).abs() <= slack, "{terms} {z}");
        }
        for power in [0, 2, 3] {
            let exact: f64 = neglected.iter().map(|&(odd, amplitude)| amplitude * power_of(odd, power)).sum();
            assert!((analysis.tail_moment(terms, power) / exact - 1.0).abs() <= 1e-13, "{terms} {power}");
        }
    }
}

/// At an amplitude so little below the overshoot of one term that 1 − x² = 3.2·10⁻¹⁶, where it is sampled a little too low:
/// the bound is above the exact value (mpmath, 60 digits), and not far.
#[test]
fn certified_bounds_allow_for_rounding() {
    let k = Double { hi: 0.911_937_795_818_479_2, lo: -2.691_763_476_873_812_5e-17 };
    let kc = Double { hi: 0.410_328_473_978_754_94, lo: -2.737_659_978_990_023e-17 };
    let (analysis, exact) = (FourierAnalysis::new(k, kc), 0.845_628_416_911_335_2);
    assert_eq!(analysis.overshoot(1), None);
    let excess = |bound: f64| (bound - exact) / exact;
    assert!((0.0..1e-6).contains(&excess(analysis.certified_bound(1, 1e-9))));
    assert!(excess(analysis.supremum(1)).abs() < 1e-7);
}

/// What follows the last term, a geometric series, is below 2⁻⁵⁵ of the first.
#[test]
fn tails_end_where_the_rest_is_nothing() {
    for amplitude in [0.3, 0.7, 0.95, 0.999, 0.999_999] {
        let (k, kc) = half_angle(Double::PI * amplitude);
        let analysis = FourierAnalysis::new(k, kc);
        let q = (analysis.root * analysis.root).to_f64();
        let (mut first, mut last) = (0.0, 0.0);
        analysis.for_tail(2, |_, term| {
            if first == 0.0 {
                first = term;
            }
            last = term;
        });
        assert!(last * q / (1.0 - q) <= 2.9e-17 * first, "{amplitude}: {last:e} of {first:e}");
    }
}
