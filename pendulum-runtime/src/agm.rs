//! The arithmetic-geometric mean: K = π/(2 AGM(1, k′)).

use crate::double::Double;
use libm::sqrt;

/// More steps than any pair in (2⁻¹⁰⁷⁴, 1] needs; the loop ends earlier.
const MAX_STEPS: usize = 24;

/// AGM(1, x) for 0 < x ≤ 1 in two words (for x below 10⁻²⁹⁰ in fewer, as products underflow).
///
/// Each step doubles the digits that agree. When a and b agree to 2⁻⁵⁴, their mean is AGM to (a − b)²/16 = 2⁻¹¹².
/// A rounding error enters a homogeneous function of degree one with positive weights, so the steps add at most the
/// error of a mean and a square root each, about 2⁻¹⁰³ in all.
pub(crate) fn agm_double(x: Double) -> Double {
    let (mut a, mut b) = (Double::ONE, x);
    for _ in 0..MAX_STEPS {
        let mean = (a + b).scale(0.5);
        if (a.hi - b.hi).abs() <= 5.6e-17 * a.hi {
            return mean;
        }
        b = (a * b).sqrt();
        a = mean;
    }
    a
}

/// K = π/(2 AGM(1, k′)), correctly rounded but for ties; ∞ for k′ = 0.
pub(crate) fn complete(kc: Double) -> f64 {
    if kc.hi == 0.0 { f64::INFINITY } else { (Double::PI.scale(0.5) / agm_double(kc)).to_f64() }
}

/// AGM(1, x) for 0 < x ≤ 1, within 2 ulp; 0 for x = 0.
pub(crate) fn agm(x: f64) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    let (mut a, mut b) = (1.0, x);
    for _ in 0..MAX_STEPS {
        let mean = 0.5 * (a + b);
        // Then the mean is AGM to (a − b)²/(16a²) = 6·10⁻¹⁸ of it.
        if a - b <= 1e-8 * a {
            return mean;
        }
        b = sqrt(a * b);
        a = mean;
    }
    a
}

/// √q, q = exp(−πK′/K), from both moduli, for q ≤ ¼ (k′ ≥ 0.1134), within 3 ulp down to k = 10⁻³⁰⁰.
///
/// Never as an exponential, whose error grows with K′/K. With aₙ, cₙ the AGM's means and half-differences from a₀ = 1,
/// b₀ = k′, c₀ = k, three Landen steps turn q into q⁴ = ε(1 + 2ε⁴ + 15ε⁸ + …), ε = c₃/(4a₄) (DLMF 22.2, 19.8), and
/// cₙ₊₁ = cₙ²/(4aₙ₊₁) turns that into q = (k/4)² (a₁⁴ a₂² a₃ a₄)^(−1/4) (1 + 2ε⁴)^(1/4).
pub(crate) fn sqrt_nome(k: f64, kc: f64) -> f64 {
    let a1 = 0.5 * (1.0 + kc);
    let b1 = sqrt(kc);
    let a2 = 0.5 * (a1 + b1);
    let b2 = sqrt(a1 * b1);
    let a3 = 0.5 * (a2 + b2);
    let b3 = sqrt(a2 * b2);
    let a4 = 0.5 * (a3 + b3);
    let c1 = k * k / (4.0 * a1);
    let c2 = c1 * c1 / (4.0 * a2);
    let c3 = c2 * c2 / (4.0 * a3);
    let e = c3 / (4.0 * a4);
    let e2 = e * e;
    let product = sqrt(sqrt(a3 * a4) * a2) * a1; // (a₁⁴ a₂² a₃ a₄)^(1/4)
    0.25 * k * (1.0 + 0.25 * e2 * e2) / sqrt(product)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::double::relative_error;
    use crate::kernel::two_to;

    /// Expected values by mpmath.
    #[test]
    fn means_in_two_words() {
        let cases = [
            (Double::new(0.5).sqrt(), Double { hi: 0.847213084793979, lo: 3.2274329925022014e-17 }),
            (Double::new(0.5), Double { hi: 0.7283955155234534, lo: 4.945050030370928e-17 }),
            (Double::new(1e-12), Double { hi: 0.054133068513430714, lo: 1.1684898136696955e-18 }),
            (Double::new(1e-300), Double { hi: 0.002269406194157821, lo: 1.2098312148717716e-19 }),
        ];
        for (x, expected) in cases {
            let error = relative_error(agm_double(x), expected);
            // At 1e-300 the second words underflow.
            let bound = if x.hi < 1e-290 { 1e-24 } else { two_to(-102) };
            assert!(error <= bound, "{x:?}: {error:e}");
            assert!((agm(x.hi) / expected.hi - 1.0).abs() <= 2.0 * f64::EPSILON);
        }
        assert_eq!((agm_double(Double::ONE), agm(1.0)), (Double::ONE, 1.0));
        assert_eq!((agm(0.0), complete(Double::ZERO)), (0.0, f64::INFINITY));
    }

    /// AGM(1, x) = a·AGM(1, b/a) with a = (1 + x)/2 and b = √x, over amplitudes that end the loop at every distance of
    /// the means: one that ends too early shows on one side.
    #[test]
    fn one_step_changes_nothing() {
        // From 1 down to 10⁻²⁸⁰, by a factor that hits no pattern.
        let mut x = Double::ONE;
        for _ in 0..if cfg!(miri) { 40 } else { 4000 } {
            x = x * 0.851_17;
            let (a, b) = ((x + Double::ONE).scale(0.5), x.sqrt());
            let (mean, same) = (agm_double(x), a * agm_double(b / a));
            // Twice 2⁻¹⁰³ as derived there, and a few roundings here.
            assert!(relative_error(mean, same) <= two_to(-101), "{x:?}");
            assert!((agm(x.hi) / mean.hi - 1.0).abs() <= 2.0 * f64::EPSILON, "{x:?}");
        }
    }

    /// k/4 as k → 0, even where k² underflows.
    #[test]
    fn the_root_of_the_nome_at_tiny_moduli() {
        for k in [1e-9, 1e-100, 1e-300] {
            assert!((sqrt_nome(k, 1.0) / (k / 4.0) - 1.0).abs() <= 2.0 * f64::EPSILON);
        }
    }
}
