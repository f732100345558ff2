//! The bounds against samples: never below, and hardly above where the worst cases meet.

mod edges;

use super::*;
use crate::scene::Scene;
use crate::supremum::worst;
use crate::testing::{self, scene};
use std::f64::consts::PI;

/// Twice the derivative of the arcsine of Σ a cos ms, and its derivative.
fn arcsine_slopes(ours: &[(f64, f64)], s: f64) -> (f64, f64) {
    let sum = |f: &dyn Fn(f64, f64) -> f64| ours.iter().map(|&(m, a)| f(m, a)).sum::<f64>();
    let y = sum(&|m, a| a * (m * s).cos());
    let first = sum(&|m, a| -m * a * (m * s).sin());
    let second = sum(&|m, a| -m * m * a * (m * s).cos());
    let margin = 1.0 - y * y;
    (2.0 * first / margin.sqrt(), 2.0 * (second / margin.sqrt() + y * first * first / margin.powf(1.5)))
}

/// sup |θ̂′(s)·rate − θ̇(s + shift)| over all s and shifts, at most 1, one of which is `drift`.
fn sampled(ours: &[(f64, f64)], method: Method, rate: f64, drift: f64, velocity: impl Fn(f64) -> f64) -> f64 {
    const SAMPLES: u32 = 600;
    let slope = |s: f64| match method {
        Method::Fourier => arcsine_slopes(ours, s).0,
        _ => ours.iter().map(|&(m, a)| -m * a * (m * s).sin()).sum(),
    };
    let shifts = if drift == 0.0 { vec![0.0] } else { vec![0.0, drift, -drift] };
    let at = |i: u32| {
        let s = f64::from(i) / f64::from(2 * SAMPLES);
        shifts.iter().map(|shift| (slope(s) * rate - velocity(s + shift)).abs()).fold(0.0, f64::max)
    };
    (0..=SAMPLES).map(at).fold(0.0, f64::max)
}

struct Case {
    scene: Scene,
    /// The first so many weights of the method.
    terms: usize,
    method: Method,
    /// Our rate over the exact one.
    faster: f64,
    drift: f64,
}

impl Case {
    /// The bound, and what is seen of it.
    fn bounds(&self) -> (f64, f64) {
        let swing = testing::swing(&self.scene);
        let curves = SwingCurves::new(swing, &self.scene.motion.omega);
        let weights: Vec<Double> = match self.method {
            Method::Harmonic | Method::SmallAngle => vec![swing.amplitude.to_double()],
            Method::Fourier => swing.half_sine_weights(&swing.fourier_coefficients(self.terms)),
            _ => curves.angle().terms().iter().take(self.terms).map(|term| term.1).collect(),
        };
        let exact = swing.rate();
        let rate = &exact * &exact.context().float(self.faster).unwrap();
        let theta = curves.angle();
        let sum = Sum::of_weights(&self.scene, swing, self.method, rate, weights);
        let found = Approximate { drift: self.drift, ..Approximate::new(&sum, &theta) }.velocity();
        let ours: Vec<(f64, f64)> =
            sum.weights.iter().enumerate().map(|(n, w)| ((2 * n + 1) as f64 * PI, w.hi)).collect();
        let terms = theta.terms();
        let slope =
            |s: f64| terms.iter().map(|&(m, a)| -f64::from(m) * PI * a.hi * (f64::from(m) * PI * s).sin()).sum::<f64>();
        let seen = sampled(&ours, self.method, sum.rate.to_f64(), self.drift, |s| slope(s) * exact.to_f64());
        (found, seen)
    }

    #[track_caller]
    fn expect(&self, most: f64) {
        let (found, seen) = self.bounds();
        let (terms, method) = (self.terms, self.method.word());
        assert!(seen <= found, "{method} {terms}: {seen:e} exceeds {found:e}");
        assert!(found <= most * seen, "{method} {terms}: {found:e} is much more than {seen:e}");
    }
}

fn swing(theta0: &str, method: Method, terms: usize) -> Case {
    Case { scene: scene(&format!("theta0 = {theta0}, omega = 3")), terms, method, faster: 1.0, drift: 0.0 }
}

/// At the same phase and rate it is a supremum over cells.
#[test]
fn of_the_same_rate() {
    for theta0 in ["1", "7π/8"] {
        swing(theta0, Method::Harmonic, 1).expect(1.01);
        swing(theta0, Method::Series, 2).expect(1.01);
        swing(theta0, Method::Series, 3).expect(1.02);
    }
    // The cells' bends are of either curve: tight where the error is large.
    swing("1", Method::Fourier, 1).expect(1.05);
    swing("0.7π", Method::Fourier, 2).expect(1.3);
    swing("0.95π", Method::Series, 6).expect(1.05);
    // However small the error is.
    for (theta0, terms, most) in [("1", 4, 1.01), ("1", 5, 1.01), ("2", 6, 1.01), ("7π/8", 4, 1.02), ("7π/8", 8, 1.02)]
    {
        swing(theta0, Method::Fourier, terms).expect(most);
    }
    swing("0.95π", Method::Fourier, 5).expect(1.05);
}

/// |sin x + sin 3x| is at most 8/(3√3), where it isn't at an end, nor its bound sampled there.
#[test]
fn of_sums_of_sines() {
    let sum = Cosines::new([(1, 1.0 / PI), (3, 1.0 / (3.0 * PI))].into_iter());
    let found = by_halves([0.0, 0.5], CELLS, MOST_HALVED, |low, high| sum.over(low, high).largest(1));
    let known = 8.0 / 27f64.sqrt();
    assert!(known <= found && found < 1.01 * known, "{found} for {known}");
}

/// The angle over a moment against samples: never below, and not much above; and held beyond it where θ̂ exceeds the
/// amplitude by more, but for what is seen at its extrema next to that.
#[test]
fn of_angles_within_a_moment() {
    for (start, t_max) in
        [("theta0 = 1", 0.3), ("theta0 = 2, velocity0 = 0.5", 0.4), ("theta0 = 2.6, velocity0 = -0.4", 1.0)]
    {
        let scene = scene(&format!("{start}, t_max = {t_max}"));
        let swing = testing::swing(&scene);
        let (theta, rate) = (SwingCurves::new(swing, &scene.motion.omega).angle(), swing.rate());
        for (method, terms) in [(Method::Harmonic, 1), (Method::Series, 3), (Method::Series, 5), (Method::Fourier, 5)] {
            let weights: Vec<Double> = match method {
                Method::Harmonic => vec![swing.amplitude.to_double()],
                Method::Fourier => swing.half_sine_weights(&swing.fourier_coefficients(terms)),
                _ => theta.terms().iter().take(terms).map(|term| term.1).collect(),
            };
            let ours = Sum::of_weights(&scene, swing, method, rate.clone(), weights);
            let angle = |s: f64| {
                let sum: f64 =
                    ours.weights.iter().enumerate().map(|(n, w)| w.hi * ((2 * n + 1) as f64 * PI * s).cos()).sum();
                if method == Method::Fourier { 2.0 * sum.asin() } else { sum }
            };
            let (reach, launch) = (t_max * rate.to_f64(), swing.launch.to_f64());
            let seen = (-500..=500).map(|i| launch + reach * f64::from(i) / 500.0);
            let seen = worst(seen.map(|s| (angle(s) - theta.at(Double::new(s)).hi).abs()));
            let beyond =
                worst((0..=5000).map(|i| (angle(f64::from(i) * 1e-4).abs() - swing.amplitude.to_f64()).max(0.0)));
            let (found, held) = Approximate::new(&ours, &theta).angle();
            assert!(seen <= found && found <= 1.1 * seen, "{start}, {method:?} {terms}: {found:e} for {seen:e}");
            assert_eq!(
                held.is_some(),
                beyond > NEXT_TO * found,
                "{start}, {method:?} {terms}: {beyond:e} of {found:e}"
            );
            let most = swing.amplitude.to_f64() + found;
            assert!(held.is_none_or(|held| (held / most - 1.0).abs() < 1e-15), "{held:?} {most}");
        }
    }
}

/// y = ½ cos πs and Y = ¾ cos πs, in cells, about the turning point and the lowest point too.
#[test]
fn arcsines_apart() {
    let [half, rest] = [0.5, 0.25].map(Double::new);
    let sines = |complementary| Sines {
        whole: Cosines::odd(&[half + rest]),
        rest: Cosines::odd(&[rest]),
        complementary,
        ..beside_nothing(&[half])
    };
    let apart = |s: f64| 2.0 * ((0.75 * (PI * s).cos()).asin() - (0.5 * (PI * s).cos()).asin()).abs();
    for cell in 0..50 {
        let (low, high) = (0.01 * f64::from(cell), 0.01 * f64::from(cell + 1));
        let seen = worst((0..=20).map(|i| apart(low + 0.01 * f64::from(i) / 20.0)));
        let found = sines(0.6).angles_apart(low, high);
        assert!(seen <= found && found <= 1.05 * seen + 0.005, "{low}: {found} for {seen}");
    }
    // The whole may be more than it is, but cos(θ/2) is no less.
    let doubtful = |complementary| Sines { omitted: [0.05, 0.0], ..sines(complementary) }.angles_apart(0.0, 0.01);
    assert!(apart(0.0) < doubtful(0.66) && doubtful(0.66) < 0.98 * doubtful(0.0));
}

/// With all its terms the series is exact, and what is left are the other rate and phase.
#[test]
fn of_another_rate_or_phase() {
    // All terms have the same sign at the lowest point.
    for theta0 in ["1", "7π/8"] {
        for faster in [1.125, 0.875] {
            Case { faster, ..swing(theta0, Method::Series, 300) }.expect(1.001);
        }
        // An anchor off, the velocities are opposite.
        Case { drift: 1.0, ..swing(theta0, Method::Series, 300) }.expect(1.001);
    }
    // Of small angles the series has one term, whose steepest place the phase may meet.
    Case { drift: 1e-3, ..swing("0.01", Method::Series, 300) }.expect(1.01);
    Case { drift: 0.1, ..swing("0.5", Method::Series, 300) }.expect(1.05);
}

/// Near the top the two velocities, π²·rate and 2ω at most, are taken as opposite, as they are an anchor off.
#[test]
fn near_the_top() {
    let motion = swing("pi - 1e-300", Method::Harmonic, 1);
    let swinging = testing::swing(&motion.scene);
    let expected = PI * PI * swinging.rate().to_f64() + 6.0;
    let rate = swinging.rate();
    let theta = SwingCurves::new(swinging, &motion.scene.motion.omega).angle();
    let of = |method| {
        let sum = Sum::of_weights(&motion.scene, swinging, method, rate.clone(), vec![Double::PI]);
        Approximate { drift: 1.0, ..Approximate::new(&sum, &theta) }.velocity()
    };
    assert!((1.0..1.0 + 1e-8).contains(&(of(Method::Harmonic) / expected)));
    assert_eq!(of(Method::Fourier), f64::INFINITY);
}

/// Of θ = 0, beside which the derivative of the arcsine is all there is.
fn beside_nothing(weights: &[Double]) -> Sines {
    let nothing = || Cosines::new(std::iter::empty());
    let minus: Vec<Double> = weights.iter().map(|&weight| -weight).collect();
    Sines {
        ours: Cosines::odd(weights),
        whole: nothing(),
        rest: Cosines::odd(&minus),
        theta: nothing(),
        omitted: [0.0; 2],
        omitted_slope: 0.0,
        complementary: 0.0,
    }
}

/// In cells, wide ones too; narrow ones are bounded to a thousandth.
#[test]
fn arcsines_within_cells() {
    for (amplitude, width, most) in [(0.5_f64, 0.05, 1.3), (0.9, 0.02, 1.2), (0.99, 0.01, 1.3), (0.9, 1e-5, 1.001)] {
        let sines = beside_nothing(&[Double::new(amplitude)]);
        for cell in 1..=(0.5_f64 / width).min(20.0) as u32 {
            let middle = width * (f64::from(cell) - 0.5);
            let found = sines.slopes_apart(middle - 0.5 * width, middle + 0.5 * width);
            let within = |i: i32| arcsine_slopes(&[(PI, amplitude)], middle + width * f64::from(i) / 40.0).0.abs();
            let seen = (-20..=20).map(within).fold(0.0, f64::max);
            assert!(seen <= found, "{amplitude} {middle}: {seen} exceeds {found}");
            assert!(cell <= 2 || found <= most * seen, "{amplitude} {middle}: {found} for {seen}");
        }
    }
}

/// Where either sine might be 1 there is no bound.
#[test]
fn cells_that_reach_the_edge() {
    let sum = |weight: f64| Cosines::odd(&[Double::new(weight)]);
    for (ours, whole, bounded) in [(0.5, 1.0, false), (1.0, 0.5, false), (-1.0, 0.5, false), (0.5, 0.9, true)] {
        let sines = Sines {
            whole: sum(whole),
            rest: sum(whole - ours),
            theta: sum(1.0),
            ..beside_nothing(&[Double::new(ours)])
        };
        assert_eq!(sines.slopes_apart(0.0, 0.01).is_finite(), bounded, "{ours} {whole}");
    }
}

/// What sin(θ/2) is in doubt by counts as often as ρ and ρ′ do: with y = Y = θ = ½ cos πs at s = ¼ these are 2/√m, and
/// |θ′|·tan(arcsin y)/√m; and what θ′ is in doubt by, as often as |ρ|·tan(arcsin y)/√m.
#[test]
fn what_is_in_doubt() {
    let half = || Cosines::odd(&[Double::new(0.5)]);
    let nothing = || Cosines::new(std::iter::empty());
    let y = 0.125f64.sqrt();
    let margin = (1.0 - y * y).sqrt();
    for (omitted, expected) in
        [([1e-6, 0.0], 1e-6 * PI * y * (y / margin) / margin), ([0.0, 1e-6], 2e-6 / margin), ([0.0; 2], 0.0)]
    {
        let whole = half();
        let sines = Sines { whole, theta: half(), rest: nothing(), omitted, ..beside_nothing(&[Double::new(0.5)]) };
        let found = sines.slopes_apart(0.25, 0.25);
        assert!((found - expected).abs() < 1e-11, "{omitted:?}: {found:e} {expected:e}");
    }
    let found = |omitted_slope: f64| {
        let (whole, rest) = (half(), half());
        let sines = Sines { whole, theta: half(), rest, omitted_slope, ..beside_nothing(&[Double::new(0.5)]) };
        sines.slopes_apart(0.25, 0.25)
    };
    let (more, expected) = (found(1e-6) - found(0.0), 1e-6 * y * (y / margin) / margin);
    assert!((more - expected).abs() < 1e-13, "{more:e} {expected:e}");
}

/// Where a sum falls steeply next to 1, and doesn't bend itself, the arcsine does.
#[test]
fn steep_flanks() {
    let (weights, harmonics) = ([0.6, 0.0, 0.38].map(Double::new), [(PI, 0.6), (5.0 * PI, 0.38)]);
    let sines = beside_nothing(&weights);
    for width in [1e-2, 1e-3, 1e-4] {
        for place in 1..60 {
            let middle = f64::from(place) / 400.0;
            let found = sines.slopes_apart(middle - 0.5 * width, middle + 0.5 * width);
            let within = |i: i32| arcsine_slopes(&harmonics, middle + width * f64::from(i) / 40.0).0.abs();
            let seen = (-20..=20).map(within).fold(0.0, f64::max);
            assert!(seen <= found && found <= seen + 1200.0 * width, "{middle} {width}: {found} for {seen}");
        }
    }
}

/// |cos φ − cos 3φ| is at most 8/(3√3), where it isn't at an end; cos φ + ½ cos 5φ is 3/2 at 0.
#[test]
fn suprema_of_sums() {
    let besides = |terms: &[(u32, f64)], omitted: f64| {
        supremum_of_terms(&terms.iter().map(|&(m, a)| (m, Double::new(a))).collect::<Vec<_>>(), omitted)
    };
    let wave = |terms: &[(u32, f64)]| besides(terms, 0.0);
    for (terms, known) in [([(1, 1.0), (3, -1.0)], 8.0 / 27f64.sqrt()), ([(1, 1.0), (5, 0.5)], 1.5)] {
        let found = wave(&terms);
        assert!(known * (1.0 + 1e-14) <= found && found <= 1.02 * known, "{found} for {known}");
    }
    // What is omitted besides may have any sign.
    assert_eq!(besides(&[(1, 1.0)], 0.25), wave(&[(1, 1.0)]) + 0.25);
    assert_eq!((wave(&[]), besides(&[], 0.25)), (0.0, 0.25));
}

/// Of few terms their supremum, of many the sum of their magnitudes; and what the series itself omits.
#[test]
fn what_is_left_out() {
    let scene = scene("theta0 = 0.999π");
    let swing = testing::swing(&scene);
    let theta = SwingCurves::new(swing, &scene.motion.omega).angle().omitting(0.125);
    let all = theta.terms().len();
    for left in [0, 3, 40, 41, 50] {
        let terms = &theta.terms()[all - left..];
        let magnitudes = terms.iter().map(|(_, a)| a.hi.abs()).sum::<f64>();
        let sum = if left > 40 { magnitudes } else { supremum_of_terms(terms, 0.0) };
        assert_eq!(left_out(&theta, all - left), sum + 0.125, "{left}");
    }
}
