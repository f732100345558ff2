//! Theta series as polynomials: ratios such as sin((2j+1)w)/sin w are polynomials in η = 4 sin² w.
//!
//! All four families obey P₍ⱼ₊₁₎ = (2 − η)Pⱼ − P₍ⱼ₋₁₎ with P₀ = 1 and differ only in P₁. Hyperbolic arguments w = iX
//! need nothing new: η = −4 sinh² X. So a theta quotient is one sine (or exponential) and two short polynomials,
//! whatever the number of harmonics.

use crate::kernel::{power, two_to};

/// Which harmonics are expanded; each is 1 for j = 0.
#[derive(Clone, Copy)]
pub(crate) enum Harmonics {
    /// sin((2j+1)w)/sin w.
    OddSine,
    /// cos((2j+1)w)/cos w.
    OddCosine,
    /// cos(2jw).
    EvenCosine,
    /// sin(2(j+1)w)/sin 2w.
    EvenSine,
}

/// Weights below this are left out: they are nothing beside others, and subnormal numbers, which they or their
/// products could be, take as long as a hundred others.
const NOTHING: f64 = two_to(-900);

/// The coefficients, lowest power of η first, of Σⱼ weightⱼ Pⱼ(η).
pub(crate) fn polynomial<const N: usize>(harmonics: Harmonics, weight: impl Fn(i32) -> f64) -> [f64; N] {
    let (constant, slope) = match harmonics {
        Harmonics::OddSine => (3.0, 1.0),
        Harmonics::OddCosine => (1.0, 1.0),
        Harmonics::EvenCosine => (1.0, 0.5),
        Harmonics::EvenSine => (2.0, 1.0),
    };
    let (mut previous, mut current) = ([0.0; N], [0.0; N]);
    let mut sum = [0.0; N];
    previous[0] = 1.0;
    current[0] = constant;
    if N > 1 {
        current[1] = -slope;
    }
    sum[0] = weight(0);
    for j in 1..N {
        let w = weight(j as i32);
        let w = if w.abs() < NOTHING { 0.0 } else { w };
        for i in 0..=j {
            sum[i] += w * current[i];
        }
        let mut next = [0.0; N];
        for i in 0..N {
            let shifted = if i > 0 { current[i - 1] } else { 0.0 };
            next[i] = 2.0 * current[i] - shifted - previous[i];
        }
        previous = current;
        current = next;
    }
    sum
}

/// The same less its first harmonic, which is 1: rounded in proportion to what is left.
pub(crate) fn after_first<const N: usize>(harmonics: Harmonics, weight: impl Fn(i32) -> f64) -> [f64; N] {
    polynomial(harmonics, |j| if j == 0 { 0.0 } else { weight(j) })
}

/// ϑ₁(w; q)/(2q^¼ sin w).
pub(crate) fn jacobi_theta1<const N: usize>(q: f64) -> [f64; N] {
    polynomial(Harmonics::OddSine, theta1_weight(q))
}

/// What its harmonics count.
pub(crate) fn theta1_weight(q: f64) -> impl Fn(i32) -> f64 {
    move |j| alternate(j) * power(q, j * (j + 1))
}

/// ϑ₂(w; q)/(2q^¼ cos w).
pub(crate) fn jacobi_theta2<const N: usize>(q: f64) -> [f64; N] {
    polynomial(Harmonics::OddCosine, theta2_weight(q))
}

/// What its harmonics count.
pub(crate) fn theta2_weight(q: f64) -> impl Fn(i32) -> f64 {
    move |j| power(q, j * (j + 1))
}

/// ϑ₃(w; q).
pub(crate) fn jacobi_theta3<const N: usize>(q: f64) -> [f64; N] {
    polynomial(Harmonics::EvenCosine, |j| twice_after_first(j) * power(q, j * j))
}

/// ϑ₄(w; q).
pub(crate) fn jacobi_theta4<const N: usize>(q: f64) -> [f64; N] {
    polynomial(Harmonics::EvenCosine, |j| twice_after_first(j) * alternate(j) * power(q, j * j))
}

/// (−1)ʲ.
pub(crate) fn alternate(j: i32) -> f64 {
    if j & 1 == 0 { 1.0 } else { -1.0 }
}

/// 1, 2, 2, …: the coefficients of a theta series in cosines.
fn twice_after_first(j: i32) -> f64 {
    if j == 0 { 1.0 } else { 2.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::horner;

    /// The harmonics themselves, one at a time.
    #[test]
    fn polynomials_are_the_harmonics() {
        let w = 0.4_f64;
        let eta = 4.0 * libm::sin(w) * libm::sin(w);
        for n in 0..6 {
            let only = |harmonics| horner(&polynomial::<6>(harmonics, |j| if j == n { 1.0 } else { 0.0 }), eta);
            let (odd, even) = (f64::from(2 * n + 1), f64::from(2 * n));
            // Coefficients up to 2000 cancel to values of about 1.
            let close = |x: f64, y: f64| assert!((x - y).abs() < 1e-12, "{n}: {x} {y}");
            close(only(Harmonics::OddSine), libm::sin(odd * w) / libm::sin(w));
            close(only(Harmonics::OddCosine), libm::cos(odd * w) / libm::cos(w));
            close(only(Harmonics::EvenCosine), libm::cos(even * w));
            close(only(Harmonics::EvenSine), libm::sin((even + 2.0) * w) / libm::sin(2.0 * w));
        }
    }

    /// ϑ₃⁴ = ϑ₂⁴ + ϑ₄⁴ and ϑ₁′ = ϑ₂ϑ₃ϑ₄ at w = 0 (DLMF 20.7.5, 20.4.6), where the polynomials are their first
    /// coefficients.
    #[test]
    fn theta_functions_obey_jacobi() {
        for q in [0.0, 0.01, 0.1, 0.2] {
            let first: [[f64; 6]; 4] = [jacobi_theta1(q), jacobi_theta2(q), jacobi_theta3(q), jacobi_theta4(q)];
            let [c1, c2, c3, c4] = first.map(|coefficients| coefficients[0]);
            assert!((c1 / (c2 * c3 * c4) - 1.0).abs() < 1e-14, "{q}");
            assert!(((16.0 * q * power(c2, 4) + power(c4, 4)) / power(c3, 4) - 1.0).abs() < 1e-14, "{q}");
        }
    }

    /// However small the nome, no coefficient is subnormal, which would be slow; those that count are there.
    #[test]
    fn coefficients_are_normal() {
        for exponent in 0..400 {
            let q = libm::pow(10.0, -0.75 * f64::from(exponent)) / 4.0;
            let series: [[f64; 6]; 4] = [jacobi_theta1(q), jacobi_theta2(q), jacobi_theta3(q), jacobi_theta4(q)];
            assert!(series.iter().flatten().all(|c| *c == 0.0 || c.is_normal()), "{q:e}: {series:?}");
            let at_nought = 1.0 + 2.0 * (q + power(q, 4) + power(q, 9) + power(q, 16) + power(q, 25));
            assert!((series[2][0] - at_nought).abs() <= f64::EPSILON, "{q:e}");
        }
    }

    #[test]
    fn signs() {
        assert_eq!((alternate(0), alternate(3)), (1.0, -1.0));
    }
}
