//! The paper's θ̂ = 2 arcsin y, y = Σ wₙ cos((2n−1)πs), as a whole: one polynomial instead of a sum, a root and an
//! arcsine.
//!
//! θ̂ is an even function of the phase, analytic in p = s² but where y = ±1. Sums of few terms take these values near
//! the turning point, off the real axis: at 7π/8 with N = 4 where p = −0.008 ± 0.022i. A [`Moebius`] map moves them
//! away and leaves 34 terms of 63.
//!
//! **Error.** That θ̂ is analytic in some ellipse is awkward to prove. Instead the interpolant Q is tested afterwards:
//! the residual R = y − sin(Q/2) is analytic wherever p is finite, and |y| and |sin(Q/2)| ≤ sinh(|Q|/2) are bounded on
//! an ellipse by their coefficients. So its own interpolation at M points has an error of at most 4Bρ^(1−M)/(ρ − 1)
//! ([`crate::chebyshev::interpolation_error`]), and its values there, multiplied by Lebesgue's constant, bound the rest: Λ ≤
//! (2/π) ln M + 1 (Rivlin 1974). Where |y| and |y − R| = |sin(Q/2)| are at most Y < 1, Q/2, small at the lowest point,
//! stays between −π/2 and π/2, and |θ̂ − Q| ≤ 2 sup|R|/√(1 − Y²).

use crate::chebyshev::{CosineTable, Interpolation, cos_pi, sin_pi, value};
use crate::plan::moebius::Moebius;
use crate::plan::polynomial::Approximation;
use crate::series::Wave;
use crate::supremum::worst;
use pendulum_runtime::double::Double;
use std::f64::consts::PI;

/// The maps tried: none, and some that suit branch points nearer and nearer to the turning point.
const PLACES: [f64; 10] = [0.5, 0.35, 0.25, 0.18, 0.14, 0.115, 0.09, 0.07, 0.05, 0.035];

/// Of these many samples a first look is taken; what needs more terms than that is cheaper by the arcsine.
const LOOK: usize = 48;

/// How much of the largest value the coefficients dropped at the first look may be.
const ROUGH: f64 = 1e-12;

/// More points than this take too long.
const MOST_POINTS: usize = 400;

/// θ̂ for these weights, the whole approximation wrong by much less than `limit`; `None` if it needs many terms.
pub(super) fn approximation(weights: &[Double], limit: f64) -> Option<Approximation> {
    let maps = PLACES.iter().map(|&place| Some(Moebius::new(place)));
    let looks = std::iter::once(None).chain(maps).filter_map(|map| Some((rough_terms(weights, map)?, map)));
    let (rough, map) = looks.min_by_key(|&(terms, _)| terms)?;
    // A limit far above the motion itself asks for no less.
    let negligible = limit.min(weights.iter().map(|w| w.hi.abs()).sum()) / 512.0;
    // Coefficients fall off geometrically.
    let rate = libm::log(ROUGH) / rough as f64;
    let terms = libm::log(negligible / 4.0) / rate;
    let sum = Wave::harmonics(weights);
    (1..=3).find_map(|more| {
        let points = (terms * (1.0 + 0.15 * f64::from(more))).ceil() as usize + 4;
        let series = interpolant(&sum, map, points)?;
        let Distance { within, growth } = distance(&sum, map, &series, negligible)?;
        (within <= negligible).then(|| Approximation::known(map, series, within, growth))
    })
}

/// The phase where the series has its variable at 8P − 1 = u.
fn phase(map: Option<Moebius>, u: Double) -> Double {
    let image = (u + Double::ONE) * 0.125;
    map.map_or(image, |map| map.inverse(image)).sqrt()
}

/// How many terms leave a part of [`ROUGH`], in ordinary precision.
fn rough_terms(weights: &[Double], map: Option<Moebius>) -> Option<usize> {
    let angle = |j: usize| PI * (2 * j + 1) as f64 / (2 * LOOK) as f64;
    let at = |j: usize| {
        let s = phase(map, Double::new(libm::cos(angle(j)))).hi;
        let y: f64 = weights.iter().enumerate().map(|(n, w)| w.hi * libm::cos((2 * n + 1) as f64 * PI * s)).sum();
        libm::asin(y)
    };
    let values: Vec<f64> = (0..LOOK).map(at).collect();
    let coefficient = |i: usize| {
        let sum: f64 = values.iter().enumerate().map(|(j, value)| value * libm::cos(i as f64 * angle(j))).sum();
        2.0 * sum / LOOK as f64
    };
    let largest = coefficient(0).abs();
    let mut tail = 0.0;
    let terms = (1..LOOK).rev().find(|&i| {
        tail += coefficient(i).abs();
        tail.is_nan() || tail > ROUGH * largest
    })?;
    (terms < LOOK * 7 / 8).then_some(terms + 1)
}

/// The Chebyshev series through θ̂ at `points` points.
fn interpolant(sum: &Wave, map: Option<Moebius>, points: usize) -> Option<Vec<Double>> {
    let table = CosineTable::new(points);
    let values: Option<Vec<Double>> = table.points().map(|u| twice_arcsine(sum.at(phase(map, u)))).collect();
    Some(table.coefficients(&values?))
}

/// 2 arcsin y, by Newton's method on sin πx = y; `None` if |y| ≥ 1.
pub(super) fn twice_arcsine(y: Double) -> Option<Double> {
    let mut x = Double::new(libm::asin(y.hi) / PI);
    for _ in 0..2 {
        x = x + (y - sin_pi(x)) / (Double::PI * cos_pi(x));
    }
    (y.hi.abs() < 1.0).then_some(x * Double::PI * 2.0)
}

/// A bound of how far a series is from θ̂ on the interval, and by which power of its parameter it grows on ellipses
/// about it.
struct Distance {
    within: f64,
    growth: f64,
}

/// The distance of `series`; `None` if the sum may reach 1.
///
/// By Hadamard's theorem of three circles a residual below r on the interval and below B on the ellipse with parameter ρ
/// is below r·(B/r)^(ln x/ln ρ) on that with parameter x.
fn distance(sum: &Wave, map: Option<Moebius>, series: &[Double], negligible: f64) -> Option<Distance> {
    let interpolation = enough_points(sum, map, series, negligible * 1e-4)?;
    let sample = |u: Double| {
        let s = phase(map, u);
        let y = sum.at(s);
        (Point { s: s.hi, y: y.hi.abs() }, residual(y, series, u))
    };
    let table = CosineTable::new(interpolation.points);
    let (points_of_sum, residuals): (Vec<Point>, Vec<f64>) = table.points().map(sample).unzip();
    let residual = interpolation.supremum(residuals);
    let within = of_residual(sum, &points_of_sum, residual)?;
    let growth = libm::log(bound(sum, map, series, interpolation.rho)? / residual) / libm::log(interpolation.rho);
    Some(Distance { within, growth })
}

/// |y − sin(Q/2)| where the sum is y and the interpolant Q has its variable at u.
pub(super) fn residual(y: Double, series: &[Double], u: Double) -> f64 {
    (y - sin_pi(value(series, u) / (Double::PI * 2.0))).hi.abs()
}

/// What a residual of the sine makes of the angle; `None` if the sum, known at some points, may reach 1.
pub(super) fn of_residual(sum: &Wave, points: &[Point], residual: f64) -> Option<f64> {
    let most = largest(points, bend(sum)) + residual;
    (most < 1.0).then(|| 2.0 * residual / (1.0 - most * most).sqrt())
}

/// Bounds |y″|.
fn bend(sum: &Wave) -> f64 {
    sum.terms().iter().map(|&(m, w)| w.hi.abs() * (f64::from(m) * PI).powi(2)).sum()
}

/// |y| at a phase.
#[derive(Clone, Copy)]
pub(super) struct Point {
    pub(super) s: f64,
    pub(super) y: f64,
}

/// Bounds |y| where |y″| ≤ `bend`, from points between the lowest point, ½, and the turning point, 0, about which y is
/// odd and even.
fn largest(points: &[Point], bend: f64) -> f64 {
    let lowest = Point { s: 0.5, y: 0.0 };
    let other_side = points.last().map(|&Point { s, y }| Point { s: -s, y });
    let all: Vec<Point> = std::iter::once(lowest).chain(points.iter().copied()).chain(other_side).collect();
    let between = |pair: &[Point]| worst([pair[0].y, pair[1].y]) + bend * (pair[0].s - pair[1].s).powi(2) / 8.0;
    worst(all.windows(2).map(between))
}

/// Bounds the residual on the ellipse with parameter ρ; `None` where that reaches infinite phases.
fn bound(sum: &Wave, map: Option<Moebius>, series: &[Double], rho: f64) -> Option<f64> {
    let height = Moebius::height(map, rho)?;
    let angle: f64 = series.iter().enumerate().map(|(j, c)| c.hi.abs() * libm::cosh(j as f64 * libm::log(rho))).sum();
    Some(sum.bound(height) + libm::sinh(0.5 * angle))
}

/// As many points as make the residual's interpolation error negligible.
fn enough_points(sum: &Wave, map: Option<Moebius>, series: &[Double], negligible: f64) -> Option<Interpolation> {
    let ellipse = |rho: f64| Some((bound(sum, map, series, rho)?, rho));
    let ellipses = [1.15, 1.25, 1.35, 1.5, 1.7, 2.0, 2.5, 3.0].into_iter().filter_map(ellipse);
    Interpolation::fewest(ellipses, negligible, 2, MOST_POINTS)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::chebyshev::lebesgue;
    use crate::fuzz::random::Random;
    use crate::motion::{Regime, Swing};
    use crate::plan::plan;
    use crate::plan::tests::scene;
    use crate::scene::Scene;

    /// (−1)ⁿ⁻¹ k b₂ₙ₋₁.
    pub(in crate::plan::paper) fn weights(swing: &Swing, terms: usize) -> Vec<Double> {
        swing.half_sine_weights(&swing.fourier_coefficients(terms))
    }

    #[test]
    fn arcsines_of_known_sines() {
        let third = twice_arcsine(Double::new(0.5)).unwrap() * 3.0 - Double::PI;
        let half = twice_arcsine(Double::new(0.5).sqrt()).unwrap() * 2.0 - Double::PI;
        assert!(third.hi.abs() < 1e-30 && half.hi.abs() < 1e-30, "{third:?} {half:?}");
        assert_eq!(twice_arcsine(Double::new(1.0)), None);
    }

    /// The bound of the whole series is next to nothing, and that of a series that is wrong by ε at the lowest point is
    /// εΛ/√(1 − y²), y being the largest.
    #[test]
    fn errors_are_seen() {
        for (theta0, terms) in [("1e-3", 1), ("1", 2), ("π/2", 3), ("7π/8", 4), ("7π/8", 8)] {
            let scene = scene(&format!("theta0 = {theta0}"));
            let Regime::Swing(swing) = &scene.motion.regime else { panic!("a swing") };
            let sum = Wave::harmonics(&weights(swing, terms));
            let largest = sum.at(Double::ZERO).hi;
            let epsilon = 1e-9 * largest;
            for map in [None, Some(Moebius::new(0.14))] {
                let Some(series) = interpolant(&sum, map, 90) else { panic!("{theta0} {terms}") };
                let exact = distance(&sum, map, &series, 1e-26).unwrap().within;
                // Without a map 90 terms leave 10⁻¹⁵ at 7π/8.
                assert!(exact <= if map.is_some() { 1e-24 } else { 1e-15 }, "{theta0} {terms} {map:?}: {exact:e}");
                for spoilt in [0, 3, 40] {
                    let mut series = series.clone();
                    series[spoilt] = series[spoilt] + Double::new(epsilon);
                    let Interpolation { points, .. } = enough_points(&sum, map, &series, 1e-30).unwrap();
                    let expected = epsilon * lebesgue(points) / (1.0 - largest * largest).sqrt();
                    let seen = distance(&sum, map, &series, 1e-26).unwrap().within / expected;
                    assert!((0.99..1.02).contains(&seen), "{theta0} {terms} {map:?} {spoilt}: {seen}");
                }
            }
        }
    }

    /// Somewhat beyond the lowest point the series is no farther from twice the arcsine than the growth of its distance
    /// says.
    #[test]
    fn distances_grow_beyond_the_lowest_point() {
        let mut grown = 0;
        for (theta0, terms, points, beyond) in [("1", 2, 12, 0.05), ("7π/8", 4, 24, 0.01), ("2", 3, 16, 0.03)] {
            let scene = scene(&format!("theta0 = {theta0}"));
            let Regime::Swing(swing) = &scene.motion.regime else { panic!("a swing") };
            let sum = Wave::harmonics(&weights(swing, terms));
            for map in [None, Some(Moebius::new(0.25))] {
                let series = interpolant(&sum, map, points).unwrap();
                let Distance { within, growth } = distance(&sum, map, &series, 1e-20).unwrap();
                let known = Approximation::known(map, series.clone(), within, growth);
                let error = |s: f64| {
                    let p = Double::new(s) * s;
                    let image = map.map_or(p, |map| {
                        Double::new(map.end()) - Double::new(map.scale()) / (p + Double::new(map.place))
                    });
                    (value(&series, image * 8.0 - Double::ONE) - twice_arcsine(sum.at(Double::new(s))).unwrap())
                        .hi
                        .abs()
                };
                let seen = (0..=100).map(|i| error(0.5 + beyond * f64::from(i) / 100.0)).fold(0.0, f64::max);
                let [inner, outer] = [0.0, beyond].map(|beyond| known.truncation(points, beyond));
                assert!(seen <= outer, "{theta0} {map:?}: {inner:e} {seen:e} {outer:e}");
                grown += u32::from(seen > inner);
            }
        }
        assert!(grown > 3, "{grown}");
    }

    /// Of a series that is right, few points see nothing but their own error.
    #[test]
    fn errors_of_few_points() {
        let scene = scene("theta0 = 2");
        let Regime::Swing(swing) = &scene.motion.regime else { panic!("a swing") };
        let sum = Wave::harmonics(&weights(swing, 3));
        let largest = sum.at(Double::ZERO).hi;
        let map = Some(Moebius::new(0.25));
        let series = interpolant(&sum, map, 90).unwrap();
        let Interpolation { error: own, .. } = enough_points(&sum, map, &series, 1e-6).unwrap();
        let found = distance(&sum, map, &series, 1e-2).unwrap().within;
        // The largest sum between points is overestimated.
        let times = found / (2.0 * own / (1.0 - largest * largest).sqrt());
        assert!((1.0..1.5).contains(&times), "{found:e}: {times}");
    }

    /// Of a series that is wrong by much the sine of its half may be larger than y, too: by sup |R|, which is ε/2 at
    /// the lowest point, times Λ.
    #[test]
    fn large_errors_bring_the_sum_nearer_to_one() {
        let scene = scene("theta0 = 7π/8");
        let Regime::Swing(swing) = &scene.motion.regime else { panic!("a swing") };
        let sum = Wave::harmonics(&weights(swing, 8));
        let mut series = interpolant(&sum, Some(Moebius::new(0.14)), 90).unwrap();
        let epsilon = 2e-3;
        series[0] = series[0] + Double::new(epsilon);
        let Interpolation { points, .. } = enough_points(&sum, Some(Moebius::new(0.14)), &series, 1e-30).unwrap();
        let residual = 0.5 * epsilon * lebesgue(points);
        let most = sum.at(Double::ZERO).hi + residual;
        let expected = 2.0 * residual / (1.0 - most * most).sqrt();
        let found = distance(&sum, Some(Moebius::new(0.14)), &series, 1e-26).unwrap().within;
        assert!((found / expected - 1.0).abs() < 0.01, "{found:e} {expected:e}");
    }

    /// cos πs − ½ cos 3πs; where ρ = 2, without a map, |Im s| ≤ sinh(½ ln 2)/2, and |1 + T₁| ≤ 1 + 5/4.
    #[test]
    fn bounds_of_a_known_sum() {
        let sum = Wave::harmonics(&[Double::ONE, Double::new(-0.5)]);
        assert!((bend(&sum) - 5.5 * PI * PI).abs() < 1e-12);
        let height = 0.25 * (2f64.sqrt() - 0.5f64.sqrt());
        let expected = (PI * height).cosh() + 0.5 * (3.0 * PI * height).cosh() + 1.125f64.sinh();
        let found = bound(&sum, None, &[Double::ONE; 2], 2.0).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-8, "{found} {expected}");
        let Interpolation { error, .. } = enough_points(&sum, None, &[Double::ONE; 2], 1e-20).unwrap();
        assert!(error <= 1e-20 && error > 1e-22, "{error:e}");
    }

    /// cos πs, of which no sample is the largest value.
    #[test]
    fn the_largest_sum_between_samples() {
        let at = |s: f64| Point { s, y: (PI * s).cos() };
        let bound = |samples: &[f64]| largest(&samples.iter().map(|&s| at(s)).collect::<Vec<_>>(), PI * PI);
        let fine = bound(&[0.4, 0.3, 0.2, 0.1, 0.04]);
        assert!(fine > 1.0 && fine < 1.01, "{fine}");
        // Where samples are missing the bend counts: π²/8 times the square of the gap.
        assert!((bound(&[0.05]) - at(0.05).y - PI * PI / 8.0 * 0.45 * 0.45).abs() < 1e-12);
        assert!((bound(&[0.45, 0.2]) - at(0.2).y - PI * PI / 8.0 * 0.16).abs() < 1e-12);
    }

    /// Im √p on the ellipse itself.
    #[test]
    fn heights_are_those_of_the_image() {
        for map in [None, Some(Moebius::new(0.5)), Some(Moebius::new(0.1))] {
            for rho in [1.1, 1.3, 1.6] {
                let Some(bound) = Moebius::height(map, rho) else { continue };
                let seen = (0..1000).map(|i| imaginary_part(map, rho, f64::from(i) * PI / 1000.0)).fold(0.0, f64::max);
                // That of the map takes the worst of either part.
                let most = if map.is_some() { 4.0 } else { 1.0 + 1e-4 };
                assert!(seen <= bound * (1.0 + 1e-12) && bound < most * seen, "{map:?} {rho}: {seen} {bound}");
            }
        }
        assert_eq!(Moebius::height(Some(Moebius::new(0.01)), 2.0), None);
    }

    fn imaginary_part(map: Option<Moebius>, rho: f64, angle: f64) -> f64 {
        let (x, y) = ((1.0 + 0.5 * (rho + 1.0 / rho) * angle.cos()) / 8.0, (rho - 1.0 / rho) * angle.sin() / 16.0);
        let (re, im) = map.map_or((x, y), |map| {
            // b(¼ + b)/(¼ + b − P) − b
            let (d, square) = (map.end() - x, (map.end() - x).powi(2) + y * y);
            (map.scale() * d / square - map.scale() / map.end(), map.scale() * y / square)
        });
        ((re.hypot(im) - re) / 2.0).sqrt()
    }

    /// Against the arcsine of the sum, for swings of all amplitudes, released and launched, to either side, and any
    /// time.
    #[test]
    fn plans_compute_twice_the_arcsine() {
        let mut random = Random::new(7);
        let mut wholes = 0;
        for _ in 0..24 {
            let (theta0, terms) = (0.05 + 0.87 * random.unit(), 1 + random.below(5));
            let side = random.choose(&["", "-"]);
            let velocity0 = if random.one_in(3) { 0.2 * random.unit() } else { 0.0 };
            let text = format!("theta0 = {side}{theta0:.4}π, n = {terms}, velocity0 = {velocity0:.3}");
            let scene = scene(&text);
            let Ok(plan) = plan(&scene) else { continue };
            let Regime::Swing(swing) = &scene.motion.regime else { continue };
            let (description, bound) = (&plan.parts[0].description, plan.parts[0].bound);
            let whole = description.contains("twice the arcsine");
            wholes += u32::from(whole);
            let sum = Wave::harmonics(&weights(swing, terms));
            let amplitude = swing.amplitude.to_f64();
            let ulp = amplitude.next_up() - amplitude;
            assert!(bound.phase + bound.evaluation <= 11.0 * ulp || !whole, "{text}: {bound:?}");
            for _ in 0..24 {
                let t = 2f64.powf(60.0 * random.unit() - 6.0);
                let Some(exact) = exact(&scene, swing, &sum, t) else { continue };
                let error = (Double::new(plan.functions[0].program.run(t)[0]) - exact).hi.abs();
                let units = error / ulp;
                // An arcsine multiplies what its argument is wrong by.
                assert!(units <= 8.0 || !whole, "{text} at {t:e}: {units}");
            }
        }
        assert!(wholes > 12, "{wholes}");
    }

    /// The map is one of anchors, and pieces are parts of one, whatever the unit of the reduced phase.
    #[test]
    fn in_other_units() {
        let mut random = Random::new(8);
        for (text, how) in [
            ("theta0 = 7π/8, method = fourier, tol = 2e-2, omega = 30", "replaced"),
            ("theta0 = -7π/8, method = fourier, tol = 2e-2, omega = 7", "replaced"),
            ("theta0 = 7π/8, n = 4, omega = 30", "32 polynomials"),
            ("theta0 = -7π/8, n = 4, omega = 7, t_max = 2", "32 polynomials"),
        ] {
            let (scene, plan) = (scene(text), plan(&scene(text)).unwrap());
            let Regime::Swing(swing) = &scene.motion.regime else { panic!("a swing") };
            let (part, sum) = (&plan.parts[0], Wave::harmonics(&weights(swing, 4)));
            let found = (plan.reduction.unit != Double::ONE, part.description.contains(how), plan.coefficients.len());
            assert_eq!(found, (true, true, 4), "{text}: {}", part.description);
            let bias = swing.elliptic.fourier_analysis().supremum(4);
            let own = if text.contains("tol") { part.bound.truncation - bias } else { 1e-15 };
            let most = own + part.bound.phase + part.bound.evaluation;
            for _ in 0..40 {
                let t = 2.0 * random.unit();
                let exact = exact(&scene, swing, &sum, t).unwrap();
                let error = (Double::new(plan.functions[0].program.run(t)[0]) - exact).hi.abs();
                assert!(error <= most, "{text} at {t}: {error:e} {most:e}");
            }
        }
    }

    fn exact(scene: &Scene, swing: &Swing, sum: &Wave, t: f64) -> Option<Double> {
        let context = scene.motion.omega.context();
        let phase = swing.rate() * context.float(t)? + &swing.launch;
        let passed = phase.round();
        let odd = (&passed - passed.scale(-1).round().scale(1)).is_zero();
        let value = twice_arcsine(sum.at((phase - passed).to_double()))?;
        Some(if odd == swing.mirrored { -value } else { value })
    }
}
