//! The functions that are approximated by polynomials.

use pendulum_runtime::double::Double;

/// Σ (ln 2)^(2i + k) vⁱ/(2i + k)!, v = f²: sinh(f ln 2)/f for k = 1, (cosh(f ln 2) − 1)/v for k = 2.
pub(super) fn series(v: Double, k: u32) -> Double {
    let square = Double::LN_2 * Double::LN_2 * v;
    let mut term = if k == 2 { Double::LN_2 * Double::LN_2 * 0.5 } else { Double::LN_2 };
    let (mut sum, mut n) = (term, f64::from(k));
    while term.hi > 1e-34 {
        term = term * square / ((n + 1.0) * (n + 2.0));
        sum = sum + term;
        n += 2.0;
    }
    sum
}

/// arctan √v/√v for v > 0, by one Newton step from the `f64` value.
pub(super) fn arctangent_ratio(v: Double) -> Double {
    let x = v.sqrt();
    let start = libm::atan(x.hi);
    let angle = Double::new(start) / Double::PI;
    let (sine, cosine) = (crate::chebyshev::sin_pi(angle), crate::chebyshev::cos_pi(angle));
    let step = (x * cosine - sine) / (cosine + x * sine);
    (Double::new(start) + step) / x
}
