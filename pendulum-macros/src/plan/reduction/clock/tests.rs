//! What each reduction says of its error, worked out by hand, and which there are.

use super::*;
use crate::exact::Context;
use crate::plan::reduction::tests::rate;
use crate::testing::Random;

/// What a scaled rate is off by, over the horizon, and the roundings of the product and of the difference.
#[test]
fn errors_of_scaled_rates() {
    let context = Context::for_digits(60);
    let rate = context.decimal("0.8346268416740731862814297327990468").unwrap();
    for (anchors, float) in [3.0, 50.0, 66.0, 1e4].into_iter().flat_map(|n| [(n, Float::F64), (n, Float::F32)]) {
        let horizon = anchors / rate.to_f64();
        let clock = Clock { rate: &rate, launch: Double::ZERO, horizon, float };
        let scaled = |way: &Reduction| matches!(way.scheme, Scheme::Scaled { .. });
        let reduction = clock.reductions().into_iter().find(scaled).unwrap();
        let Scheme::Scaled { scaled, anchor, .. } = reduction.scheme else { unreachable!() };
        let real = |x: f64| context.float(x).unwrap();
        let off = (&rate * &real(anchor) - real(scaled)).abs().to_f64();
        let rounding = half_ulp(anchors * anchor, float) + half_ulp(anchor, float);
        let excess = reduction.error * anchor / (horizon * off + rounding) - 1.0;
        assert!((0.0..1.1e-3).contains(&excess) && off > 0.0, "{reduction:?}: {excess:e}");
        assert!((1.0..=2.0).contains(&anchor), "{reduction:?}");
        // Any multiple of it within the horizon is exact.
        for number in [2.0, 1.0, 0.0].map(|before| anchors + 1.0 - before) {
            let (product, lost) = pendulum_runtime::double::two_prod(anchor, number);
            assert!(lost == 0.0 && float.round(product) == product, "{number}: {reduction:?}");
        }
    }
}

/// The product with a rate of one bit is rounded by half a unit in the last place of the longest phase, which the
/// horizon's end may just pass.
#[test]
fn roundings_of_one_product() {
    let rate = Context::for_digits(60).decimal("0.5").unwrap();
    let mut seen = 0;
    for (anchors, binade) in [(1000.0, 9), (1023.9, 10), (1024.1, 10), (1500.0, 10), (2047.9, 11), (2048.1, 11)] {
        for (float, bits) in [(Float::F64, 53), (Float::F32, 24)] {
            let clock = Clock { rate: &rate, launch: Double::ZERO, horizon: anchors / 0.5, float };
            let one_word = |way: &Reduction| matches!(way.scheme, Scheme::OneWord { .. });
            let reduction = clock.reductions().into_iter().find(one_word).unwrap();
            assert_eq!(reduction.error, 2f64.powi(binade - bits), "{anchors}: {reduction:?}");
            // In a unit of which an anchor has one, there is the difference's besides.
            let scaled = |way: &Reduction| matches!(way.scheme, Scheme::Scaled { anchor: 1.0, .. });
            if let Some(reduction) = clock.reductions().into_iter().find(scaled) {
                assert_eq!(reduction.error, 2f64.powi(binade - bits) + 2f64.powi(-bits), "{anchors}: {reduction:?}");
                seen += 1;
            }
        }
    }
    assert!(seen >= 4, "{seen}");
}

/// A launch that isn't on an origin or half-way between two is added with two roundings of half an anchor, however few
/// digits it has.
#[test]
fn roundings_of_launches() {
    let rate = Context::for_digits(60).decimal("0.7").unwrap();
    for float in [Float::F64, Float::F32] {
        let error = |launch: Double| {
            let clock = Clock { rate: &rate, launch, horizon: 100.0, float };
            let one_word = |way: &Reduction| matches!(way.scheme, Scheme::OneWord { .. });
            clock.reductions().into_iter().find(one_word).unwrap().error
        };
        let half = error(Double::new(0.5));
        for launch in [Double::new(0.25), Double::new(1e-300), Double { hi: 0.5, lo: 1e-20 }] {
            let times = (error(launch) - half) / half_ulp(0.5, float);
            assert!((times - 2.0).abs() < 1e-6, "{launch:?}: {times}");
        }
    }
}

/// Where n is rounded from a rounded sum, the remainder is beyond half an anchor by a unit in the last place of the sum:
/// with an anchor at t = 0 there is none but for remainders from the lowest point.
#[test]
fn remainders_beyond_half_an_anchor() {
    let rate = Context::for_digits(60).decimal("0.5").unwrap();
    // 1 + 127.5 and somewhat more is in the binade of 128.
    for (horizon, binade) in [(250.0, 6), (255.0, 7)] {
        let ways =
            |launch: f64, float: Float| Clock { rate: &rate, launch: Double::new(launch), horizon, float }.reductions();
        for (float, bits) in [(Float::F64, 52), (Float::F32, 23)] {
            for (launch, expected) in [(0.0, 0.0), (0.5, 2f64.powi(binade - bits)), (-0.5, 2f64.powi(binade - bits))] {
                let one_word = |way: &Reduction| matches!(way.scheme, Scheme::OneWord { .. });
                let found = ways(launch, float).into_iter().find(one_word).unwrap().overshoot;
                assert_eq!(found, expected, "{horizon} {launch} {float:?}");
            }
        }
        for (origin, launch, expected) in [
            (Origin::Anchor, 0.0, 0.0),
            (Origin::Anchor, 0.5, 2f64.powi(binade - 52)),
            (Origin::Lowest, 0.0, 2f64.powi(binade - 52)),
        ] {
            let wide = |way: &Reduction| matches!(way.scheme, Scheme::Wide { .. }) && way.origin == origin;
            let found = ways(launch, Float::F32).into_iter().find(wide).unwrap().overshoot;
            assert_eq!(found, expected, "{horizon} {launch} {origin:?}");
        }
    }
}

fn cody_waite(
    rate: &str,
    launch: f64,
    anchors: f64,
    (count, origin): (usize, Origin),
    float: Float,
) -> (Reduction, Real) {
    let rate = Context::for_digits(60).decimal(rate).unwrap();
    let clock = Clock { rate: &rate, launch: Double::new(launch), horizon: anchors / rate.to_f64(), float };
    let wanted = |way: &Reduction| {
        way.origin == origin && matches!(&way.scheme, Scheme::CodyWaite { words, .. } if words.len() == count)
    };
    let reduction = clock.reductions().into_iter().find(wanted).unwrap();
    (reduction, rate)
}

/// Over a few anchors the words leave nothing. What is left is a unit of rounding of half the time between anchors for
/// each difference but the first; and for that, where half the time is next to a power of two, of which it may be on
/// the other side. Half the time is 0.714…, or 1 but for a ten-millionth.
#[test]
fn roundings_of_differences() {
    let u = Float::F64.rounding_unit();
    for (rate, half, escapes) in [("0.7", u / 2.0, 0.0), ("0.49999995", u, u), ("0.50000005", u, u)] {
        for (count, launch, differences) in [(2, 0.0, 1.0), (3, 0.0, 2.0), (2, 0.5, 2.0), (3, 0.5, 3.0)] {
            // Half-way between two origins the first counts anyway.
            let [of_anchors, of_lowest] = if launch == 0.0 { [escapes, 0.0] } else { [0.0, escapes] };
            let (from_anchor, rate) = cody_waite(rate, launch, 3.0, (count, Origin::Anchor), Float::F64);
            let (from_lowest, _) =
                cody_waite(&rate.to_f64().to_string(), launch, 3.0, (count, Origin::Lowest), Float::F64);
            let rate = rate.to_f64();
            let excess = from_anchor.error / (rate * (of_anchors + differences * half)) - 1.0;
            assert!((-1e-15..2e-6).contains(&excess), "{from_anchor:?}: {excess:e}");
            // Half an anchor on, an origin is half-way between two of the others.
            let differences = 2.0 * count as f64 - 1.0 - differences;
            let excess = from_lowest.relative_error / (differences * u) - 1.0;
            assert!((0.0..2e-3).contains(&excess), "{from_lowest:?}: {excess:e}");
            assert!((from_lowest.error - rate * of_lowest).abs() <= 2e-6 * u, "{from_lowest:?}");
        }
    }
}

/// Half the time between anchors is 0.97. A launch is added last: differences are rounded as far beyond that, by twice as much
/// from 1 on, and it is itself, and so is the sum. If it is next to an origin, the first difference is exact unless it leads
/// beyond 1. Of 0.998 long horizons lead beyond 1 as well.
#[test]
fn roundings_of_differences_from_launches() {
    let u = Float::F32.rounding_unit();
    for (launch, first, others) in
        [(0.01, 0.0, u / 2.0), (0.02, u, u), (-0.25, u, u), (1.49, u / 2.0, u / 2.0), (0.48, u, u)]
    {
        for count in [2, 3] {
            let (reduction, rate) = cody_waite("0.515463917526", launch, 3.0, (count, Origin::Anchor), Float::F32);
            let (rate, from_half) = (rate.to_f64(), (2.0 * launch - (2.0 * launch).round()).abs() / 2.0);
            let differences = first + (count as f64 - 1.0) * others;
            let expected = differences + half_ulp(from_half / rate, Float::F32) + u / 2.0;
            let excess = reduction.error / (rate * expected) - 1.0;
            assert!((-1e-15..2e-4).contains(&excess), "{launch} {reduction:?}: {excess:e}");
        }
    }
    let rounding = |anchors: f64| {
        let last = |count| cody_waite("0.501", 0.0, anchors, (count, Origin::Anchor), Float::F32).0;
        last(3).error / (u / 2.0)
    };
    assert_eq!([rounding(2.0), rounding(3e4)].map(f64::round), [1.0, 2.0]);
}

/// From the lowest point a launch next to a half adds its own unit to each difference, and a sum.
#[test]
fn roundings_of_differences_next_to_a_half() {
    let u = Float::F64.rounding_unit();
    for (half, first) in [(0.0, 1.0), (0.5, 0.0)] {
        for (launch, count) in [(0.001, 2), (-0.001, 3), (0.015, 3)] {
            let which = (count, Origin::Lowest);
            let (reduction, rate) = cody_waite("0.7", half + launch, 3.0, which, Float::F64);
            let (launch, differences) = (launch.abs(), count as f64 - 1.0 + first);
            let excess = reduction.relative_error / ((differences + 1.0) * u) - 1.0;
            assert!((0.0..2e-3).contains(&excess), "{reduction:?}: {excess:e}");
            let expected = differences * u * launch + half_ulp(launch / rate.to_f64(), Float::F64) * rate.to_f64();
            let excess = reduction.error / expected - 1.0;
            assert!((0.0..2e-3).contains(&excess), "{reduction:?}: {excess:e}");
        }
        let (far, _) = cody_waite("0.7", half + 0.02, 3.0, (2, Origin::Lowest), Float::F64);
        assert!((far.relative_error / u - 1.0).abs() < 2e-3 && far.error > u / 3.0, "{far:?}");
    }
}

/// Over long horizons it is what the words leave, and the rounding of the last one's products.
#[test]
fn errors_of_words() {
    for (anchors, float) in [(1e10, Float::F64), (3e9, Float::F64), (3e4, Float::F32)] {
        for count in [2, 3] {
            let (reduction, rate) =
                cody_waite("0.7071067811865475244008443621", 0.0, anchors, (count, Origin::Lowest), float);
            let Scheme::CodyWaite { words, .. } = &reduction.scheme else { unreachable!() };
            let context = rate.context();
            let left = words.iter().fold(context.integer(1) / &rate, |rest, &word| rest - context.float(word).unwrap());
            let (left, last) = (left.abs().to_f64(), words[count - 1]);
            let expected = ((anchors + 1.0) * left + half_ulp((anchors + 1.0) * last, float)) * rate.to_f64();
            let excess = reduction.error / expected - 1.0;
            assert!((0.0..2e-6).contains(&excess), "{reduction:?}: {excess:e}");
        }
    }
}

/// The products of all words but the last with any number of half anchors that can occur.
#[test]
fn products_of_words_are_exact() {
    for rate in ["0.7071067811865475244008443621", "0.8346268416740731862814297327990468", "0.5772156649015328606"] {
        for (anchors, float) in
            [3.95f64, 7.9, 1.9, 1e3, 1e9].into_iter().flat_map(|n| [(n, Float::F64), (n.min(1e4), Float::F32)])
        {
            let (reduction, _) = cody_waite(rate, 0.5, anchors, (3, Origin::Anchor), float);
            let Scheme::CodyWaite { words, .. } = &reduction.scheme else { unreachable!() };
            let most = (2.0 * (anchors + 1.0)).floor();
            for halves in [most, most - 1.0, most - 2.0] {
                for &word in &words[..2] {
                    let (product, lost) = pendulum_runtime::double::two_prod(0.5 * halves, word);
                    assert!(lost == 0.0 && float.round(product) == product, "{halves} halves: {reduction:?}");
                }
            }
        }
    }
}

/// Of a rate that has few bits words leave nothing but the rounding of the phase; of others that of the last part, whose
/// size goes with the anchors of the horizon.
#[test]
fn errors_of_words_for_any_time() {
    let error = |rate: &str, count: usize, anchors: f64| {
        let rate = Context::for_digits(60).decimal(rate).unwrap();
        let horizon = anchors / rate.to_f64();
        let clock = Clock { rate: &rate, launch: Double::ZERO, horizon, float: Float::F64 };
        let way = |way: &Reduction| matches!(&way.scheme, Scheme::AnyTime { words, .. } if words.len() == count);
        clock.reductions().into_iter().find(way).unwrap().error
    };
    let sums = 2f64.powi(-53);
    for anchors in [2f64.powi(53), 2f64.powi(40), f64::INFINITY] {
        assert_eq!(
            [2, 3].map(|count| error("4", count, anchors)),
            [sums + half_ulp(anchors.min(2f64.powi(54)) * 1.001 * 2f64.powi(-26), Float::F64), sums]
        );
    }
    // The last word is below 2⁻²⁶, 2⁻⁵¹ of the rate.
    for (count, bits) in [(2, 26), (3, 51)] {
        for anchors in [2f64.powi(54), 2f64.powi(50)] {
            let last = error("0.7071067811865475244008443621", count, anchors) - sums;
            let ulp = anchors * 2f64.powi(-bits - 53);
            assert!(last <= 4.0 * ulp && last >= 0.1 * ulp, "{count} {anchors:e}: {last:e}, {ulp:e}");
        }
    }
}

/// Phases of rates above 1 are counted in units of a power of two; where powers of these would get out of hand, times
/// are cut off.
#[test]
fn products_stay_finite() {
    let most = |float: Float| 2f64.powi(if float == Float::F64 { 1000 } else { 120 });
    for (rate, float, halvings) in [
        ("0.5", Float::F64, Some(0)),
        ("3", Float::F64, Some(2)),
        ("1e5", Float::F64, Some(17)),
        ("1e6", Float::F64, None),
        ("1e200", Float::F64, None),
        ("0.5", Float::F32, Some(0)),
        ("3", Float::F32, Some(2)),
        ("20", Float::F32, None),
    ] {
        let rate = Context::for_digits(60).decimal(rate).unwrap();
        let clock = Clock { rate: &rate, launch: Double::ZERO, horizon: 10.0 / rate.to_f64(), float };
        let one_word = |way: &Reduction| matches!(way.scheme, Scheme::OneWord { .. });
        let reduction = clock.reductions().into_iter().find(one_word).unwrap();
        let scale = 2f64.powi(-halvings.unwrap_or(0));
        let cap = halvings.is_none().then(|| float.round(most(float) / rate.to_f64()));
        assert_eq!((reduction.scale, reduction.unit, reduction.cap), (scale, Double::new(1.0 / scale), cap));
    }
}

/// Converted to `f32`, the phase is rounded besides: by half a unit in the last place of half an anchor, or relative to
/// what is left of it at the lowest point.
#[test]
fn phases_of_narrow_times() {
    let rate = Context::for_digits(60).decimal("0.7").unwrap();
    let (unit, horizon) = (Float::F32.rounding_unit(), 1e6);
    let clock = Clock { rate: &rate, launch: Double::ZERO, horizon, float: Float::F32 };
    let wide = |way: &Reduction| matches!(way.scheme, Scheme::Wide { .. } | Scheme::WideAnyTime { .. });
    for way in clock.reductions().into_iter().filter(wide) {
        let (rounded, before) = match way.origin {
            Origin::Anchor => (0.25 * unit, way.error - 0.25 * unit),
            Origin::Lowest => (way.relative_error, way.error),
        };
        assert!((0.25 * unit..=1.01 * unit).contains(&rounded), "{way:?}");
        assert!(way.origin == Origin::Anchor || rounded >= unit, "{way:?}");
        assert!(before > 0.0 && before <= 2f64.powi(-27), "{way:?}");
    }
}

/// Of an `f32` time, near the lowest point three words come closer than two, which are rounded to 2⁻²⁸.
#[test]
fn words_of_narrow_times() {
    let rate = Context::for_digits(60).decimal("0.7").unwrap();
    let clock = Clock { rate: &rate, launch: Double::ZERO, horizon: f64::INFINITY, float: Float::F32 };
    let error = |count: usize| {
        let way = |way: &&Reduction| {
            let so_many = matches!(&way.scheme, Scheme::WideAnyTime { words } if words.len() == count);
            way.origin == Origin::Lowest && so_many
        };
        clock.reductions().iter().find(way).map(|way| way.error).unwrap()
    };
    assert!((2f64.powi(-30)..2f64.powi(-27)).contains(&error(2)), "{:e}", error(2));
    assert_eq!(error(3), 2f64.powi(-52));
}

/// Which ways there are, by horizon: one word up to an eighth of 1.5·2⁵² (2²³) anchors, scaled ones while 8 bits are
/// left for the unit, Cody and Waite's up to 2³⁴ (2¹⁵).
#[test]
fn ways_of_each_horizon() {
    let context = Context::for_digits(60);
    let rate = context.decimal("0.7071067811865475244").unwrap();
    for (float, anchors, expected) in [
        (Float::F64, 1.7e10, "OneWord 0, Scaled 0, CodyWaite 2, CodyWaite 3, AnyTime 2, AnyTime 3, AnyTime 4"),
        (Float::F64, 1.8e10, "OneWord 0, Scaled 0, AnyTime 2, AnyTime 3, AnyTime 4"),
        (Float::F64, 3.5e13, "OneWord 0, Scaled 0, AnyTime 2, AnyTime 3, AnyTime 4"),
        (Float::F64, 3.6e13, "OneWord 0, AnyTime 2, AnyTime 3, AnyTime 4"),
        (Float::F64, 8.4e14, "OneWord 0, AnyTime 2, AnyTime 3, AnyTime 4"),
        (Float::F64, 8.5e14, "AnyTime 2, AnyTime 3, AnyTime 4"),
        (Float::F32, 3.2e4, "OneWord 0, Scaled 0, CodyWaite 2, CodyWaite 3, Wide 0, WideAnyTime 2, WideAnyTime 3"),
        (Float::F32, 3.3e4, "OneWord 0, Scaled 0, Wide 0, WideAnyTime 2, WideAnyTime 3"),
        (Float::F32, 6.6e4, "OneWord 0, Wide 0, WideAnyTime 2, WideAnyTime 3"),
        (Float::F32, 1.5e6, "OneWord 0, Wide 0, WideAnyTime 2, WideAnyTime 3"),
        (Float::F32, 1.6e6, "Wide 0, WideAnyTime 2, WideAnyTime 3"),
        (Float::F32, 8.4e14, "Wide 0, WideAnyTime 2, WideAnyTime 3"),
        (Float::F32, 8.5e14, "WideAnyTime 2, WideAnyTime 3"),
    ] {
        let horizon = anchors / rate.to_f64();
        let ways = |launch| {
            let reductions = Clock { rate: &rate, launch, horizon, float }.reductions();
            // From the lowest point they come again.
            let mut ways: Vec<String> = Vec::new();
            for name in reductions.iter().map(|way| way.scheme.name()) {
                if !ways.contains(&name) {
                    ways.push(name);
                }
            }
            ways.join(", ")
        };
        assert_eq!(ways(Double::ZERO), expected, "{float:?} {anchors:e}");
        // A scaled unit is for no launch only, sums in two words for launches.
        let launched = expected.replace("Scaled 0, ", "").replace("AnyTime 4", "AnyTime 4, AnyTime 4 doubled");
        assert_eq!(ways(Double::new(0.25)), launched, "{float:?} {anchors:e}");
    }
    // Words that would underflow are none.
    for (rate, float, there) in [
        ("1e270", Float::F64, false),
        ("1e240", Float::F64, true),
        ("1e26", Float::F32, false),
        ("1e15", Float::F32, true),
    ] {
        let rate = context.decimal(rate).unwrap();
        let clock = Clock { rate: &rate, launch: Double::ZERO, horizon: 100.0 / rate.to_f64(), float };
        let found = clock.reductions().iter().any(|way| matches!(way.scheme, Scheme::CodyWaite { .. }));
        assert_eq!(found, there, "{float:?} {:e}", rate.to_f64());
    }
}

/// From the nearest of many pieces the rounding of remainders is a part of what it was.
#[test]
fn remainders_in_pieces_are_rounded_less() {
    let mut random = Random::new(23);
    for (float, launch, horizon, least, most) in [
        (Float::F64, "0", f64::INFINITY, 2f64.powi(-59), 2f64.powi(-57)),
        (Float::F64, "0.5", f64::INFINITY, 2f64.powi(-59), 2f64.powi(-57)),
        (Float::F64, "0.3", f64::INFINITY, 2f64.powi(-58), 2f64.powi(-56)),
        (Float::F32, "0", 100.0, 2f64.powi(-32), 2f64.powi(-30)),
        // Of three words; products with two are rounded to 2⁻²⁸ as ever.
        (Float::F32, "0", f64::INFINITY, 2f64.powi(-32), 2f64.powi(-30)),
    ] {
        let (rate, phase) = (rate(&mut random), Context::for_digits(60).decimal(launch).unwrap());
        let clock = Clock { rate: &rate, launch: phase.to_double(), horizon, float };
        let last = clock.reductions().into_iter().rfind(Reduction::has_pieces).unwrap();
        let wide = clock.reductions().into_iter().find(|reduction| matches!(reduction.scheme, Scheme::Wide { .. }));
        let reduction = if horizon.is_finite() { wide.unwrap() } else { last };
        let in_pieces = reduction.in_pieces(64).unwrap();
        assert!((least..most).contains(&in_pieces.error), "{in_pieces:?}");
        assert!(
            reduction.error >= in_pieces.error && in_pieces.half() < 0.51 / 64.0 / in_pieces.unit.hi,
            "{in_pieces:?}"
        );
    }
}

/// Where so many anchors are passed that the pieces of one can't be told there are none.
#[test]
fn pieces_that_cannot_be_told() {
    let rate = Context::for_digits(40).ratio(1, 2);
    let one_word = |t_max: f64| {
        let clock = Clock { rate: &rate, launch: Double::ZERO, horizon: t_max, float: Float::F64 };
        clock.reductions().into_iter().find(|reduction| matches!(reduction.scheme, Scheme::OneWord { .. })).unwrap()
    };
    for (t_max, pieces, serves) in [(2f64.powi(36), 32, true), (2f64.powi(42), 32, false), (2f64.powi(42), 2, true)] {
        let reduction = one_word(t_max);
        assert_eq!(reduction.in_pieces(pieces).is_some(), serves, "{pieces}: {reduction:?}");
    }
}
