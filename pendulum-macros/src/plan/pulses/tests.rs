//! Bounds of the curves on ellipses between their poles, against the curves there: sums of pulses of complex phases.

use super::*;
use crate::exact::Context;
use crate::motion::{Elliptic, Regime};
use crate::plan::curve::{Curve, Curves, RotationCurves, SwingCurves};
use crate::testing::scene;
use pendulum_runtime::double::Double;

type Complex = (f64, f64);

fn times((a, b): Complex, (c, d): Complex) -> Complex {
    (a * c - b * d, a * d + b * c)
}

fn magnitude((a, b): Complex) -> f64 {
    a.hypot(b)
}

/// (π/2K′) Σ sech α(s − ½ − m), or with alternating signs.
fn pulses(elliptic: &Elliptic, (x, y): Complex, alternate: bool) -> Complex {
    let complementary = elliptic.quarter_complementary.to_f64();
    let rate = PI * elliptic.quarter.to_f64() / complementary;
    let mut sum = (0.0, 0.0);
    let farthest = 3 + (40.0 / rate) as i32;
    for m in -farthest..=farthest {
        let (a, b) = (rate * (x - 0.5 - f64::from(m)), rate * y);
        let cosh = (a.cosh() * b.cos(), a.sinh() * b.sin());
        let square = times(cosh, (cosh.0, -cosh.1)).0;
        let sign = if alternate && m % 2 != 0 { -1.0 } else { 1.0 };
        if square.is_finite() {
            sum = (sum.0 + sign * cosh.0 / square, sum.1 - sign * cosh.1 / square);
        }
    }
    (sum.0 * FRAC_PI_2 / complementary, sum.1 * FRAC_PI_2 / complementary)
}

/// θ or θ − 2πs, θ̇, θ̈, sin(θ/2) and cos(θ/2), for ω = 1, or their magnitudes.
struct Motion {
    elliptic: Elliptic,
    /// 1/κ.
    front: f64,
    rotates: bool,
    curves: [Curve; 5],
}

impl Motion {
    fn new(text: &str) -> Self {
        let scene = scene(&format!("struct Motion; {text}"));
        let omega = &scene.motion.omega;
        let all = |curves: &dyn Curves| {
            [curves.angle(), curves.velocity(), curves.acceleration(), curves.half_sine(), curves.half_cosine()]
        };
        match &scene.motion.regime {
            Regime::Swing(swing) => Self {
                elliptic: swing.elliptic.clone(),
                front: 1.0,
                rotates: false,
                curves: all(&SwingCurves::new(swing, omega)),
            },
            Regime::Rotation(rotation) => Self {
                elliptic: rotation.elliptic.clone(),
                front: 1.0 / rotation.elliptic.modulus.to_f64(),
                rotates: true,
                curves: all(&RotationCurves::new(rotation, omega)),
            },
            Regime::Separatrix(_) => panic!("no pulses"),
        }
    }

    fn magnitude(&self, index: usize, s: Complex) -> f64 {
        // Of θ̇/2 and of the cosine of half the angle it is a swing's first and a rotation's second that alternates.
        let e = |alternate: bool| {
            let (a, b) = pulses(&self.elliptic, s, alternate);
            (a * self.front, b * self.front)
        };
        let sine = |cosine: Complex| {
            let square = times(cosine, cosine);
            magnitude((1.0 - square.0, -square.1)).sqrt()
        };
        let cosine = || e(self.rotates);
        match index {
            0 => magnitude(self.angle(s)),
            1 => 2.0 * magnitude(e(!self.rotates)),
            2 => 2.0 * sine(cosine()) * magnitude(cosine()),
            3 => sine(cosine()),
            _ => magnitude(cosine()),
        }
    }

    /// What it is at a real phase, and Simpson's sum of its derivative from there; θ falls from its turning point.
    fn angle(&self, (x, y): Complex) -> Complex {
        const STEPS: u32 = 60;
        let slope = |i: u32| {
            let height = y * f64::from(i) / f64::from(STEPS);
            let (re, im) = pulses(&self.elliptic, (x, height), !self.rotates);
            // dθ/ds = 4K·θ̇/2 for a swing, and 4K/κ of that for a rotation, less the turns.
            let scale = 4.0 * self.elliptic.quarter.to_f64();
            if self.rotates { (scale * re - 2.0 * PI, scale * im) } else { (-scale * re, -scale * im) }
        };
        let mut sum = (0.0, 0.0);
        for i in 0..=STEPS {
            let weight = if i == 0 || i == STEPS { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
            let (re, im) = slope(i);
            sum = (sum.0 + weight * re, sum.1 + weight * im);
        }
        let step = y / f64::from(STEPS) / 3.0;
        (self.curves[0].at(Double::new(x)).to_f64() - step * sum.1, step * sum.0)
    }
}

const SCENES: [&str; 9] = [
    "theta0 = 1e-9",
    "theta0 = 0.5",
    "theta0 = 2",
    "theta0 = 7π/8",
    "theta0 = π - 1e-3",
    "theta0 = π - 1e-12",
    "velocity0 = 30",
    "velocity0 = 2.1",
    "velocity0 = 2.00000001",
];

/// For real phases the curves are what their Fourier series say.
#[test]
fn curves_are_pulses() {
    for text in SCENES {
        let motion = Motion::new(text);
        for s in [0.0, 0.1, 0.25, 0.4, 0.49, 0.5] {
            for (index, curve) in motion.curves.iter().enumerate() {
                let (found, expected) = (motion.magnitude(index, (s, 0.0)), curve.at(Double::new(s)).to_f64().abs());
                // Sines of half the angle cancel next to the turning points' and the lowest's.
                let accuracy = if index == 3 || index == 2 { 1e-7 } else { 1e-12 * curve.size.largest + 1e-13 };
                assert!((found - expected).abs() < accuracy, "{text} {index} {s}: {found} {expected}");
            }
        }
    }
}

/// The phases about an anchor, and arcs anywhere, by their centre and length.
const ARCS: [(f64, f64); 9] =
    [(0.0, 1.0), (0.0, 0.3), (0.0, 0.9), (0.5, 0.4), (0.3, 0.2), (0.3, 0.7), (-0.45, 0.05), (-0.5, 0.01), (0.1, 0.99)];

fn arc((centre, stretch): (f64, f64)) -> Arc {
    let real = |x: f64| Context::settled().float(x).unwrap();
    Arc::new(0.5 * stretch, &real(1.0), &real(centre)).unwrap_or(Arc::WHOLE)
}

/// On an ellipse, and so within, no curve is larger than its bound, which isn't far above where the poles are near, nor,
/// of what is nothing but pulses, where these are small.
#[test]
fn bounds_between_poles() {
    for (text, place) in SCENES.into_iter().flat_map(|text| ARCS.map(|place| (text, place))) {
        let (motion, arc) = (Motion::new(text), arc(place));
        for (index, curve) in motion.curves.iter().enumerate() {
            let pulses = curve.pulses().unwrap();
            for part in [0.3, 0.6, 0.88, 0.94] {
                let angle = part * pulses.parameter_of_poles(arc);
                let bound = pulses.bound(arc, angle);
                let samples = if arc == Arc::WHOLE { 50 } else { 20 };
                let on_it = |i: i32| {
                    // Denser next to the foci.
                    let along = FRAC_PI_2 * (f64::from(i) / f64::from(samples)).powi(2) * f64::from(i.signum());
                    let (way, half) = (if i < 0 { -1.0 } else { 1.0 }, 0.5 * place.1);
                    let (real, imaginary) = (way * along.cos(), along.abs().sin());
                    motion.magnitude(index, (place.0 + half * angle.cosh() * real, half * angle.sinh() * imaginary))
                };
                let largest = (-samples..=samples).map(on_it).fold(0.0, f64::max);
                let about = format!("{text} {place:?} {index} {part}: {largest:e} of {bound:e}");
                assert!(largest <= bound, "{about}");
                // θ has logarithms at the poles.
                let near = arc == Arc::WHOLE && part > 0.9 && index > 0 || arc != Arc::WHOLE && index == 1;
                assert!(!near || pulses.rate < 2.0 || bound < 12.0 * largest, "{about}");
            }
        }
    }
}

/// Through a pole there is none.
#[test]
fn no_bound_at_poles() {
    for text in ["theta0 = 7π/8", "velocity0 = 2.001"] {
        for curve in &Motion::new(text).curves {
            let pulses = curve.pulses().unwrap();
            let [before, at] =
                [0.95, 1.0 + 1e-9].map(|part| pulses.bound(Arc::WHOLE, part * pulses.parameter_of_poles(Arc::WHOLE)));
            assert!(before.is_finite() && at == f64::INFINITY, "{text}: {before} {at}");
        }
    }
}
