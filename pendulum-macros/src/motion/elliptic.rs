//! The modulus and what follows from it: quarter periods and nomes.

use crate::exact::Real;
use pendulum_runtime::double::Double;
use pendulum_runtime::fourier_analysis::FourierAnalysis;

/// A modulus and its integrals.
#[derive(Clone, Debug)]
pub(crate) struct Elliptic {
    /// k.
    pub(crate) modulus: Real,
    /// k′ = √(1 − k²), never computed so.
    pub(crate) complementary: Real,
    /// K(k).
    pub(crate) quarter: Real,
    /// K′ = K(k′).
    pub(crate) quarter_complementary: Real,
    /// q = exp(−πK′/K).
    pub(crate) nome: Real,
}

impl Elliptic {
    /// Of the series of sn (Eq. 20). Nearer to the top than floats tell it is that of the nearest that they do: arguments
    /// of the arcsine exceed 1 by as much there, whatever the number of terms.
    pub(crate) fn fourier_analysis(&self) -> FourierAnalysis {
        let complementary = self.complementary.to_double();
        let nearest = Double::new(f64::MIN_POSITIVE);
        FourierAnalysis::new(
            self.modulus.to_double(),
            if complementary.hi < nearest.hi { nearest } else { complementary },
        )
    }

    /// πK/K′, of which q′ is exp of the negative.
    pub(crate) fn span(&self) -> Real {
        self.modulus.context().pi() * &self.quarter / &self.quarter_complementary
    }

    /// q′ = exp(−πK/K′).
    pub(crate) fn nome_complementary(&self) -> Real {
        (-self.span()).exp()
    }

    /// From k and k′, both given so that neither has to be found as √(1 − the other²), which cancels at one end.
    ///
    /// K = π/(2 AGM(1, k′)) and K′ = π/(2 AGM(1, k)): both lose nothing, however small k or k′.
    pub(crate) fn new(modulus: Real, complementary: Real) -> Self {
        let context = modulus.context();
        let pi = context.pi();
        let one = context.integer(1);
        let mean = one.agm(&complementary);
        let mean_complementary = one.agm(&modulus);
        let half_pi = pi.scale(-1);
        Self {
            quarter: &half_pi / &mean,
            quarter_complementary: half_pi / &mean_complementary,
            nome: (-(pi * &mean / &mean_complementary)).exp(),
            modulus,
            complementary,
        }
    }
}
