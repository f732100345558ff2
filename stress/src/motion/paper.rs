//! The paper's θ̂ = 2 arcsin(k Σ b₂ₙ₋₁ sin((2n−1)(x + π/2))) (Eq. 22) in multiple precision.

use crate::big::Big;

use super::{Series, clenshaw};

impl Series {
    /// b₂ₙ₋₁ = (2π/(kK)) qⁿ⁻¹ᐟ²/(1 − q²ⁿ⁻¹) for n up to `terms` (Eq. 20).
    pub fn paper_coefficients(&self, terms: usize) -> Vec<Big> {
        let scale = &(&Big::pi() * &2.0.into()) / &(&self.modulus[0] * &self.quarters[0]);
        // qⁿ⁻¹ᐟ², whose square is q²ⁿ⁻¹.
        let mut power = self.nome.sqrt();
        let mut coefficients = Vec::with_capacity(terms);
        for _ in 0..terms {
            coefficients.push(&(&scale * &power) / &(&Big::from(1.0) - &(&power * &power)));
            power = &power * &self.nome;
        }
        coefficients
    }

    /// θ̂ at phase φ; `None` where the argument exceeds 1.
    pub fn paper(&self, coefficients: &[Big], phase: &Big) -> Option<Big> {
        let cosine = (&(phase * &Big::pi()) * &2.0.into()).cos();
        let alternating = coefficients.iter().enumerate();
        let alternating = alternating.map(|(n, b)| b * &if n.is_multiple_of(2) { 1.0 } else { -1.0 }.into());
        let double = &(&(&cosine * &cosine) * &4.0.into()) - &2.0.into();
        let [first, second] = clenshaw(alternating, &double);
        let argument = &self.modulus[0] * &(&cosine * &(&first - &second));
        let rest = &Big::from(1.0) - &(&argument * &argument);
        (!rest.is_negative()).then(|| &argument.asin() * &2.0.into())
    }
}
