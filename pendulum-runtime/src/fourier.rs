//! The paper's approximation: N terms of the Fourier series of sn (Eq. 22).

use crate::double::Double;
use crate::error::Error;
use crate::fourier_analysis::FourierAnalysis;
use crate::kernel::{sin_turns, two_to};
use crate::motion::{Motion, Shape, with_turns};
use crate::phase::Phase;
use crate::scalar::Scalar;
use crate::swing::SwingPhase;
use core::marker::PhantomData;

/// Of so small a part of the first, coefficients change no bit of a sum, whose terms are at most 2N − 1 times as much
/// beside it; subnormal ones would take the recurrence twice the time.
const NOTHING: f64 = two_to(-200);

/// θ̂(t) = 2 arcsin(k snᴺ(ωt + K)) with snᴺ(u) = Σ b₂ₙ₋₁ sin((2n − 1)πu/(2K)), n = 1 … N (Eqs. 20 to 22).
///
/// Made by [`Pendulum::fourier`](crate::Pendulum::fourier). Exactly periodic with the exact period, so its error does
/// not grow with t.
///
/// ```
/// # use pendulum_runtime::Pendulum;
/// let p = Pendulum::<f64>::new(7.0 * core::f64::consts::PI / 8.0, 1.0)?;
/// let paper = p.fourier::<4>()?;
/// assert!((paper.theta(1e6) - p.theta(1e6)).abs() <= paper.max_error() + 1e-13); // rounding
/// assert!((paper.max_error() / p.amplitude() - 0.0039887).abs() < 1e-6); // the paper says 0.4 %
/// # Ok::<(), pendulum_runtime::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fourier<const N: usize, F: Scalar = f64> {
    phase: Phase,
    /// Whole turns of the initial angle, 2πn.
    base: Double,
    /// The phase begins at the positive (+1) or the negative (−1) turning point.
    direction: f64,
    /// b₂ₙ₋₁.
    coefficients: [f64; N],
    /// k b₂ₙ₋₁, or nothing of what changes no bit of the sum.
    amplitudes: [f64; N],
    max_error: f64,
    scalar: PhantomData<F>,
}

impl<const N: usize, F: Scalar> Fourier<N, F> {
    pub(crate) fn new(motion: &Motion) -> Result<Self, Error> {
        if N == 0 {
            return Err(Error::NoTerms);
        }
        let Shape::Swing(_, phase) = motion.shape else {
            return Err(Error::NotASwing);
        };
        let analysis = FourierAnalysis::new(motion.k, motion.moduli.kc);
        if let Some(overshoot) = analysis.overshoot(N) {
            return Err(Error::Overshoot { terms: N, overshoot, smallest: analysis.smallest_working() });
        }
        let exact: [_; N] = core::array::from_fn(|i| analysis.coefficient(i + 1));
        Ok(Self {
            phase,
            base: motion.base,
            direction: motion.direction,
            coefficients: exact.map(Double::to_f64),
            amplitudes: exact.map(|b| if b.hi < NOTHING * exact[0].hi { 0.0 } else { (b * motion.k).to_f64() }),
            max_error: analysis.supremum(N),
            scalar: PhantomData,
        })
    }

    /// b₁, b₃, …, b₂ₙ₋₁, dimensionless (Eq. 20), each rounded once. They approach 1, 0, 0, … as θ0 → 0.
    #[must_use]
    pub fn coefficients(&self) -> [F; N] {
        self.coefficients.map(F::narrow)
    }

    /// θ̂(t), rad. NaN for NaN and ±∞.
    ///
    /// One sine of the reduced phase; the harmonics follow by Clenshaw's recurrence in sin² w.
    #[must_use]
    #[inline]
    pub fn theta(&self, t: F) -> F {
        let sine = sin_turns(SwingPhase::new(self.phase.reduce(t.widen())).crossing());
        let twice_cosine = 2.0 - 4.0 * (sine * sine); // 2 cos 2w
        let (mut here, mut next) = (0.0, 0.0);
        for &amplitude in self.amplitudes.iter().rev() {
            (here, next) = (amplitude + (twice_cosine * here - next), here);
        }
        let argument = (sine * (here + next)).clamp(-1.0, 1.0); // rounding alone can exceed 1 here
        F::narrow(with_turns(self.base, 0.0, self.direction * (2.0 * libm::asin(argument))))
    }

    /// sup |θ̂ − θ| over all t, rad, of the formula (Eq. 22) itself: the true supremum over a period, wherever it is
    /// attained (not always at t = 0), also where it is far below the rounding of θ. It is found numerically, from a dozen
    /// samples per half wave on, and in `f32` rounded upward; next to an overshoot it has been seen to be off by up to
    /// 2·10⁻⁸ of itself. The macro's `MAX_ERROR` is proven.
    ///
    /// What rounding adds isn't in it: a few units in the last place of θ0, and as many times more as the arcsine is
    /// steep, 1/cos(θ̂/2) at the turning point.
    #[must_use]
    pub fn max_error(&self) -> F {
        F::narrow_up(self.max_error)
    }
}
