//! The paper's θ̂ as one polynomial.
//!
//! θ̂ is an even function of the phase, analytic in p = s² but where y = ±1. Sums of few terms take these values near
//! the turning point, off the real axis: at 7π/8 with N = 4 where p = −0.008 ± 0.022i. A [`Moebius`] map moves them
//! away and leaves 34 terms of 63.
//!
//! **Error.** That θ̂ is analytic in some ellipse is awkward to prove. Instead the interpolant Q is tested afterwards:
//! the residual R = y − sin(Q/2) is analytic wherever p is finite, and |y| and |sin(Q/2)| ≤ sinh(|Q|/2) are bounded on
//! an ellipse by their coefficients. That bounds what its own interpolation at M points is wrong by
//! ([`crate::chebyshev::interpolation_error`]), and its values there, multiplied by Lebesgue's constant, bound the rest
//! ([`crate::chebyshev::lebesgue`]). What follows from sup |R| is in [`super::residual`].

use super::Allowance;
use super::residual::{OF_RESIDUAL, largest_residual, of_residual, twice_arcsine};
use crate::chebyshev::{CosineTable, Interpolation, OF_INTERPOLATION};
use crate::plan::Bound;
use crate::plan::cosines::Cosines;
use crate::plan::form::{Division, Form};
use crate::plan::kernel::{Core, Kernel};
use crate::plan::moebius::Moebius;
use crate::plan::polynomial::interval;
use crate::plan::polynomial::{Approximation, Growth, Numerator};
use crate::plan::reduction::Reduction;
use crate::series::Wave;
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
    let sum = &Wave::harmonics(weights);
    let maps = PLACES.iter().map(|&place| Some(Moebius::new(place)));
    let charts = std::iter::once(None).chain(maps).map(|map| Chart { sum, map });
    let looks = charts.filter_map(|chart| Some((chart.rough_terms()?, chart)));
    let (rough, chart) = looks.min_by_key(|&(terms, _)| terms)?;
    // A limit far above the motion itself asks for no less.
    let negligible = limit.min(Cosines::odd(weights).magnitude(0)) * OF_INTERPOLATION;
    // Coefficients fall off geometrically.
    let rate = libm::log(ROUGH) / rough as f64;
    let terms = libm::log(negligible / 4.0) / rate;
    (1..=3).find_map(|more| {
        let points = (terms * (1.0 + 0.15 * f64::from(more))).ceil() as usize + 4;
        let series = chart.interpolant(points)?;
        let Distance { within, growth } = chart.distance(&series, negligible)?;
        (within <= negligible).then(|| Approximation::known(chart.map, series, within, growth))
    })
}

/// The polynomial in the cheapest form that keeps within the allowance.
pub(super) fn kernel(
    approximation: &Approximation,
    allowance: Allowance,
    reduction: &Reduction,
    direction: f64,
) -> Option<(Kernel, Bound)> {
    let terms = approximation.terms_for(allowance.truncation, reduction.overshoot)?;
    let mut forms: Vec<Form> = Form::ALL.into_iter().filter(|form| form.suits(terms, reduction.float)).collect();
    let cost = |form: &Form| form.cost(terms, Division::None) + form.variables(terms);
    forms.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    forms.into_iter().find_map(|form| {
        let truncated = approximation.truncated(terms, reduction, true);
        let mut polynomial = truncated.polynomial(form, Numerator::One, allowance.rest)?;
        let truncation = polynomial.truncation;
        if direction < 0.0 {
            polynomial.negate();
        }
        let kernel = Kernel::from(Core::Polynomial(Box::new(polynomial)));
        let rounding = kernel.rounding(reduction, allowance.rest - truncation);
        Some((kernel, allowance.kept(truncation, rounding)?))
    })
}

/// The sum y, and the variable in which θ̂ = 2 arcsin y is to be a polynomial: u = 8P − 1, P being p or its image under a
/// map.
#[derive(Clone, Copy)]
struct Chart<'a> {
    sum: &'a Wave,
    map: Option<Moebius>,
}

/// A bound of how far a series is from θ̂ on the interval, and how it grows on ellipses about it.
struct Distance {
    within: f64,
    growth: Growth,
}

impl Chart<'_> {
    /// The phase at u.
    fn phase(self, u: Double) -> Double {
        let image = interval::p_in_two_words(u);
        self.map.map_or(image, |map| map.inverse(image)).sqrt()
    }

    /// How many terms leave a part of [`ROUGH`], in ordinary precision.
    fn rough_terms(self) -> Option<usize> {
        let angle = |j: usize| PI * (2 * j + 1) as f64 / (2 * LOOK) as f64;
        let at = |j: usize| {
            let s = self.phase(Double::new(libm::cos(angle(j)))).hi;
            let y: f64 = self.sum.terms().iter().map(|&(m, w)| w.hi * libm::cos(f64::from(m) * PI * s)).sum();
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
    fn interpolant(self, points: usize) -> Option<Vec<Double>> {
        let table = CosineTable::new(points);
        let values: Option<Vec<Double>> = table.points().map(|u| twice_arcsine(self.sum.at(self.phase(u)))).collect();
        Some(table.coefficients(&values?))
    }

    /// The distance of `series`; `None` if the sum may reach 1.
    ///
    /// By Hadamard's theorem of three circles a residual below r on the interval and below B on the ellipse with parameter
    /// ρ is below r·(B/r)^(ln x/ln ρ) on that with parameter x.
    fn distance(self, series: &[Double], negligible: f64) -> Option<Distance> {
        let interpolation = self.enough_points(series, negligible * OF_RESIDUAL)?;
        let residual = largest_residual(self.sum, series, |u| self.phase(u), interpolation);
        let within = of_residual(self.sum, residual)?;
        let log_rho = libm::log(interpolation.rho);
        let power = libm::log(self.bound(series, interpolation.rho)? / residual) / log_rho;
        Some(Distance { within, growth: Growth::Power { power, log_rho } })
    }

    /// Bounds the residual on the ellipse with parameter ρ; `None` where that reaches infinite phases.
    fn bound(self, series: &[Double], rho: f64) -> Option<f64> {
        let height = Moebius::height(self.map, rho)?;
        let term = |(j, c): (usize, &Double)| c.hi.abs() * libm::cosh(j as f64 * libm::log(rho));
        let angle: f64 = series.iter().enumerate().map(term).sum();
        Some(self.sum.bound(height) + libm::sinh(0.5 * angle))
    }

    /// As many points as make the residual's interpolation error negligible.
    fn enough_points(self, series: &[Double], negligible: f64) -> Option<Interpolation> {
        let ellipse = |rho: f64| Some((self.bound(series, rho)?, rho));
        let ellipses = [1.15, 1.25, 1.35, 1.5, 1.7, 2.0, 2.5, 3.0].into_iter().filter_map(ellipse);
        Interpolation::fewest(ellipses, negligible, 2, MOST_POINTS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chebyshev::{lebesgue, value};
    use crate::plan::paper::whole::tests::weights_from;
    use crate::supremum::worst;

    /// The bound of the whole series is next to nothing, and that of a series that is wrong by ε at the lowest point is
    /// εΛ/√(1 − y²), y being the largest.
    #[test]
    fn errors_are_seen() {
        for (theta0, terms) in [("1e-3", 1), ("1", 2), ("π/2", 3), ("7π/8", 4), ("7π/8", 8)] {
            let sum = Wave::harmonics(&weights_from(theta0, terms));
            let largest = sum.at(Double::ZERO).hi;
            let epsilon = 1e-9 * largest;
            for map in [None, Some(Moebius::new(0.14))] {
                let chart = Chart { sum: &sum, map };
                let Some(series) = chart.interpolant(90) else { panic!("{theta0} {terms}") };
                let exact = chart.distance(&series, 1e-26).unwrap().within;
                // Without a map 90 terms leave 10⁻¹⁵ at 7π/8.
                assert!(exact <= if map.is_some() { 1e-24 } else { 1e-15 }, "{theta0} {terms} {map:?}: {exact:e}");
                for spoilt in [0, 3, 40] {
                    let mut series = series.clone();
                    series[spoilt] = series[spoilt] + Double::new(epsilon);
                    let Interpolation { points, .. } = chart.enough_points(&series, 1e-30).unwrap();
                    let expected = epsilon * lebesgue(points) / (1.0 - largest * largest).sqrt();
                    let seen = chart.distance(&series, 1e-26).unwrap().within / expected;
                    assert!((0.99..1.02).contains(&seen), "{theta0} {terms} {map:?} {spoilt}: {seen}");
                }
            }
        }
    }

    /// How far a series is from twice the arcsine at a phase.
    fn distance_at(Chart { sum, map }: Chart, series: &[Double], s: f64) -> f64 {
        let s = Double::new(s);
        let (p, wide) = (s * s, |map: Moebius| [map.end(), map.scale(), map.place].map(Double::new));
        let image = map.map(wide).map_or(p, |[end, scale, place]| end - scale / (p + place));
        (value(series, image * 8.0 - Double::ONE) - twice_arcsine(sum.at(s)).unwrap()).hi.abs()
    }

    /// What is left out over a shorter reach, which in the image of s² is a longer one.
    #[test]
    fn reaches_of_moments() {
        let sum = Wave::harmonics(&weights_from("2", 3));
        for map in [None, Some(Moebius::new(0.25)), Some(Moebius::new(0.0625))] {
            let chart = Chart { sum: &sum, map };
            let series = chart.interpolant(60).unwrap();
            let Distance { within, growth } = chart.distance(&series, 1e-20).unwrap();
            let known = Approximation::known(map, series.clone(), within, growth);
            for (terms, reach) in
                [3, 5, 8].into_iter().flat_map(|terms| [0.1, 0.2, 0.35, 0.5].map(|reach| (terms, reach)))
            {
                let at = |i: u32| distance_at(chart, &series[..terms], reach * f64::from(i) / 2000.0);
                let seen = worst((0..=2000).map(at));
                let bound = known.truncation(terms, reach - 0.5);
                assert!(seen <= bound && bound <= 1.1 * seen, "{map:?} {terms} {reach}: {bound:e} for {seen:e}");
            }
        }
    }

    /// Somewhat beyond the lowest point the series is no farther from twice the arcsine than the growth of its distance
    /// says.
    #[test]
    fn distances_grow_beyond_the_lowest_point() {
        let mut grown = 0;
        for (theta0, terms, points, beyond) in [("1", 2, 12, 0.05), ("7π/8", 4, 24, 0.01), ("2", 3, 16, 0.03)] {
            let sum = Wave::harmonics(&weights_from(theta0, terms));
            for map in [None, Some(Moebius::new(0.25))] {
                let chart = Chart { sum: &sum, map };
                let series = chart.interpolant(points).unwrap();
                let Distance { within, growth } = chart.distance(&series, 1e-20).unwrap();
                let known = Approximation::known(map, series.clone(), within, growth);
                let seen = worst((0..=100).map(|i| distance_at(chart, &series, 0.5 + beyond * f64::from(i) / 100.0)));
                let [inner, outer, farther] = [0.0, beyond, 0.2].map(|beyond| known.truncation(points, beyond));
                assert!(seen <= outer, "{theta0} {map:?}: {inner:e} {seen:e} {outer:e}");
                // Nothing is known beyond the ellipse where the sum was bounded.
                assert_eq!(farther, f64::INFINITY, "{theta0} {map:?}");
                grown += u32::from(seen > inner);
            }
        }
        assert!(grown > 3, "{grown}");
    }

    /// Of a series that is right, few points see nothing but their own error.
    #[test]
    fn errors_of_few_points() {
        let sum = Wave::harmonics(&weights_from("2", 3));
        let largest = sum.at(Double::ZERO).hi;
        let chart = Chart { sum: &sum, map: Some(Moebius::new(0.25)) };
        let series = chart.interpolant(90).unwrap();
        let Interpolation { error: own, .. } = chart.enough_points(&series, 1e-6).unwrap();
        let found = chart.distance(&series, 1e-2).unwrap().within;
        // The largest sum between points is overestimated.
        let times = found / (2.0 * own / (1.0 - largest * largest).sqrt());
        assert!((1.0..1.5).contains(&times), "{found:e}: {times}");
    }

    /// Of a series that is wrong by much the sine of its half may be larger than y, too: by sup |R|, which is ε/2 at
    /// the lowest point, times Λ.
    #[test]
    fn large_errors_bring_the_sum_nearer_to_one() {
        let sum = Wave::harmonics(&weights_from("7π/8", 8));
        let chart = Chart { sum: &sum, map: Some(Moebius::new(0.14)) };
        let mut series = chart.interpolant(90).unwrap();
        let epsilon = 2e-3;
        series[0] = series[0] + Double::new(epsilon);
        let Interpolation { points, .. } = chart.enough_points(&series, 1e-30).unwrap();
        let residual = 0.5 * epsilon * lebesgue(points);
        let most = sum.at(Double::ZERO).hi + residual;
        let expected = 2.0 * residual / (1.0 - most * most).sqrt();
        let found = chart.distance(&series, 1e-26).unwrap().within;
        assert!((found / expected - 1.0).abs() < 0.01, "{found:e} {expected:e}");
    }

    /// cos πs − ½ cos 3πs; where ρ = 2, without a map, |Im s| ≤ sinh(½ ln 2)/2, and |1 + T₁| ≤ 1 + 5/4.
    #[test]
    fn bounds_of_a_known_sum() {
        let sum = Wave::harmonics(&[Double::ONE, Double::new(-0.5)]);
        let height = 0.25 * (2f64.sqrt() - 0.5f64.sqrt());
        let expected = (PI * height).cosh() + 0.5 * (3.0 * PI * height).cosh() + 1.125f64.sinh();
        let chart = Chart { sum: &sum, map: None };
        let found = chart.bound(&[Double::ONE; 2], 2.0).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-8, "{found} {expected}");
        let Interpolation { error, .. } = chart.enough_points(&[Double::ONE; 2], 1e-20).unwrap();
        assert!(error <= 1e-20 && error > 1e-22, "{error:e}");
    }

    /// Im √p on the ellipse itself.
    #[test]
    fn heights_are_those_of_the_image() {
        for map in [None, Some(Moebius::new(0.5)), Some(Moebius::new(0.1))] {
            for rho in [1.1, 1.3, 1.6] {
                let bound = Moebius::height(map, rho).unwrap();
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
}
