//! √q in two words, for coefficients that are to be rounded only once.

use crate::double::Double;

/// Landen steps until the nome is below this; then ε(1 + 2ε⁴ + 15ε⁸) is exact to 2⁻¹⁰⁶.
const SMALL_NOME: f64 = 1e-3;

/// Enough Landen steps for every `f64` complement: q at k′ = 10⁻³⁰⁰ is 0.993, and 0.993^(2¹²) is small.
const MAX_STEPS: usize = 14;

/// √q = exp(−πK′/(2K)) for 0 ≤ k < 1, relative error below 2⁻⁹⁷.
///
/// n Landen steps turn q into q^(2ⁿ) = ε(1 + 2ε⁴ + 15ε⁸ + …) with ε = c₍ₙ₊₁₎/(4a₍ₙ₊₂₎) in the AGM of 1 and k′ from
/// c₀ = k (DLMF 19.8, 20.9); then n + 1 square roots lead back. For tiny k, q = (k²/16)(1 + k²/2 + …) as it stands.
pub(crate) fn root_of_nome(k: Double, kc: Double) -> Double {
    if k.hi < 1e-10 {
        return k.scale(0.25) * (Double::ONE + (k * k).scale(0.25));
    }
    let (mut a, mut b) = (Double::ONE, kc);
    let mut c = k;
    let mut steps = 0;
    // Invariant: c = cₙ, (a, b) = (aₙ, bₙ); q^(2^(n−1)) ≈ cₙ/(4a₍ₙ₊₁₎).
    loop {
        let mean = (a + b).scale(0.5);
        b = (a * b).sqrt();
        a = mean;
        if steps > 0 {
            let e = c / mean.scale(4.0);
            if e.hi < SMALL_NOME || steps == MAX_STEPS {
                return root(series(e), steps);
            }
        }
        c = c * c / mean.scale(4.0);
        steps += 1;
    }
}

/// q, rounded once; 1 for k = 1.
pub(crate) fn nome_of(k: Double, kc: Double) -> f64 {
    if kc.hi == 0.0 {
        return 1.0;
    }
    let root = root_of_nome(k, kc);
    (root * root).to_f64()
}

/// ε(1 + 2ε⁴ + 15ε⁸).
fn series(e: Double) -> Double {
    let fourth = (e * e) * (e * e);
    e * (Double::ONE + fourth.scale(2.0) + fourth * fourth * 15.0)
}

/// x^(1/2ⁿ).
fn root(x: Double, n: usize) -> Double {
    (0..n).fold(x, |x, _| x.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::agm::sqrt_nome;
    use crate::double::relative_error;
    use crate::kernel::two_to;

    /// Expected values by mpmath, exp(−πK′/(2K)).
    #[test]
    fn roots_in_two_words() {
        let bound = two_to(-97);
        let root = root_of_nome(Double::new(0.5), Double { hi: 0.8660254037844386, lo: 5.0175421109034514e-17 });
        assert!(relative_error(root, Double { hi: 0.1340611316115422, lo: -3.377252941970281e-18 }) <= bound);
        let kc = Double::new(1e-12);
        let root = root_of_nome((Double::ONE - kc * kc).sqrt(), kc);
        assert!(relative_error(root, Double { hi: 0.9184828693521186, lo: -3.92228320154781e-17 }) <= bound);
        // On both sides of where the steps take over, and where their squares would underflow.
        for (k, hi, lo) in [(9e-11, 2.25e-11, 4.55625e-32), (2e-10, 5e-11, 5e-31), (1e-200, 2.5e-201, 0.0)] {
            let kc = Double { hi: 1.0, lo: -0.5 * k * k };
            assert!(relative_error(root_of_nome(Double::new(k), kc), Double { hi, lo }) <= bound, "{k}");
        }
        assert_eq!(nome_of(Double::ONE, Double::ZERO), 1.0);
        assert_eq!(nome_of(Double::ZERO, Double::ONE), 0.0);
    }

    /// The quick form in one word, over its whole domain.
    #[test]
    fn one_word_and_two_words_agree() {
        for i in 1..=880 {
            let k = Double::new(f64::from(i) / 1000.0);
            let kc = ((Double::ONE - k) * (Double::ONE + k)).sqrt();
            let exact = root_of_nome(k, kc).hi;
            assert!((sqrt_nome(k.hi, kc.hi) / exact - 1.0).abs() <= 3.0 * f64::EPSILON, "{i}");
        }
        let kc = Double::new(0.12); // where the direct series end
        let k = ((Double::ONE - kc) * (Double::ONE + kc)).sqrt();
        assert!((sqrt_nome(k.hi, kc.hi) / root_of_nome(k, kc).hi - 1.0).abs() <= 3.0 * f64::EPSILON);
    }
}
