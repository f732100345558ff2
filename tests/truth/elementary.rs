//! Sine, cosine and exponential in two words: Taylor's series of a small argument, then doublings.

use pendulum_runtime::double::Double;

/// (sin x, cos x) for |x| ≤ 2: the error of about 2⁻¹⁰⁰ is far below every tolerance here.
pub fn sin_cos(x: Double) -> (Double, Double) {
    // |x|/16 ≤ 1/8, whose 22nd power is below 2⁻⁶⁶ and its factorial above 2⁶⁹.
    let small = x.scale(1.0 / 16.0);
    let square = small * small;
    let (mut sine, mut versine) = (Double::ZERO, Double::ZERO);
    for n in (1..=11).rev() {
        let even = f64::from(2 * n) * f64::from(2 * n - 1);
        let odd = f64::from(2 * n) * f64::from(2 * n + 1);
        versine = (Double::ONE - versine) * square / Double::new(even);
        sine = (Double::ONE - sine) * square / Double::new(odd);
    }
    sine = small - small * sine;
    for _ in 0..4 {
        // sin 2x = 2 sin x (1 − v) and v(2x) = 2 sin² x, v = 1 − cos.
        let doubled = (sine - sine * versine).scale(2.0);
        versine = (sine * sine).scale(2.0);
        sine = doubled;
    }
    (sine, Double::ONE - versine)
}

/// eˣ for |x| ≤ 40, relative error about 2⁻⁹⁵.
pub fn exp(x: Double) -> Double {
    let small = x.scale(1.0 / 256.0);
    let mut sum = Double::ONE;
    for n in (1..=20).rev() {
        sum = Double::ONE + sum * small / Double::new(f64::from(n));
    }
    for _ in 0..8 {
        sum = sum * sum;
    }
    sum
}
