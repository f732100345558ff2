//! The public face of a motion.

use crate::error::Error;
use crate::fourier::Fourier;
use crate::launch;
use crate::motion::Motion;
use crate::regime::Regime;
use crate::scalar::Scalar;
use core::marker::PhantomData;

/// The exact motion of a pendulum, θ̈ + ω² sin θ = 0, from any initial state, at any time.
///
/// `F` is `f32` or `f64`; `f32` computes in `f64` and rounds once. Angles are in rad from the lowest point,
/// unbounded (turns are counted); ω = √(g/ℓ) in rad per unit of t.
///
/// # Accuracy (`f64`)
/// The numbers given are taken as exact. Released from rest, θ is within 2⁻⁵⁰·|θ0| for |θ0| from 1e-9 to π − 1e-12 and
/// |t| up to 2⁴⁵ periods; from any other state within 2⁻⁴⁹·max(|θ|, 1), of which more than half is hardly ever met;
/// velocity within 2⁻⁵⁰ of its largest value, acceleration within 2⁻⁴⁹ of its largest, position within 2⁻⁴⁹. All this
/// where |θ| and |velocity|/ω are at first at least 10⁻²⁹⁰, or 0. Beyond 2⁴⁵ periods accuracy falls off, yet for every
/// finite t results are finite (of a rotation whose angle would overflow, the largest number) and swings stay within
/// their amplitude. NaN and ±∞ give NaN. Released from rest, θ(−t) = θ(t), and −θ0 gives −θ(t), to the bit. The bits,
/// those of NaN excepted, do not depend on platform or optimisation.
///
/// # Conditioning near the top
/// At the top a small error of the *input* becomes a large one of the motion: the time spent near the top is (2/ω)
/// ln(8/(π − θ0)) per half swing, so half an ulp (2.2e-16) of θ0 = π − 1e-12 is a relative change of 2.2e-4 in π − θ0
/// and of 7.5e-6 in the period, so after n periods the phase is off by n · 7.5e-6 periods. The same holds for a
/// velocity v0 = 2ω(1 ± δ) through the bottom, whose k′ is √(2δ), and for any state beside the separatrix. Of a state
/// in motion 1 − k² is a difference, carried to 2⁻¹⁰² of the smaller of cos(θ/2) and 1 − cos(θ/2), down to 10⁻²⁹⁰: θ is
/// then within the promise plus 2⁻⁴⁵·|∂θ/∂v|·ulp(v), v being the initial velocity (to first order, which is all there
/// is to say where an ulp crosses the separatrix, or many have passed); so are the other outputs, the period, K, k′ and
/// q. It counts next to the separatrix alone, where `period` has been seen 65 ulp off, `complementary_modulus` 1370.
/// What this type computes is the motion of the number it was given, not of the one that was meant; where that is a
/// formula such as π − 10⁻¹², the macro `pendulum!` takes it exactly.
///
/// ```
/// # use pendulum_runtime::{Error, Pendulum};
/// let clock = Pendulum::<f64>::new(0.3, 3.13)?;
/// let a_year = 3.156e7;
/// let (theta, velocity) = clock.state(a_year);
/// let resumed = Pendulum::<f64>::from_state(theta, velocity, 3.13)?;
/// assert!((resumed.theta(1.0) - clock.theta(a_year + 1.0)).abs() < 1e-14);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pendulum<F: Scalar = f64> {
    motion: Motion,
    scalar: PhantomData<F>,
}

impl<F: Scalar> Pendulum<F> {
    /// Released at rest from `theta0` (rad, |θ0| < π) with small-angle rate `omega` > 0 (rad per unit of t).
    ///
    /// `theta0` = 0 hangs at rest. θ(0) is `theta0` to the bit.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Amplitude`] if |θ0| exceeds the last `f64` below π; [`Error::Frequency`] if
    /// ω ≤ 0.
    ///
    /// ```
    /// # use pendulum_runtime::{Error, Pendulum};
    /// let p = Pendulum::<f64>::new(2.5, 1.0)?;
    /// assert_eq!(p.theta(0.0), 2.5);
    /// assert!(matches!(Pendulum::<f64>::new(3.2, 1.0), Err(Error::Amplitude { .. })));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn new(theta0: F, omega: F) -> Result<Self, Error> {
        Ok(Self { motion: launch::at_rest(theta0.widen(), omega.widen())?, scalar: PhantomData })
    }

    /// In the state (`theta`, `velocity`) at t = 0: any angle (whole turns are kept) and any angular velocity, rad per
    /// unit of t. Swing, separatrix or rotation is decided in twice the working precision; a state that differs from rest
    /// by subnormal numbers alone may be taken for it.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::Frequency`] if ω ≤ 0; [`Error::Velocity`] if |velocity|/ω exceeds 10²⁹⁰.
    ///
    /// ```
    /// # use pendulum_runtime::{Error, Pendulum, Regime};
    /// assert_eq!(Pendulum::<f64>::from_state(0.0, 1.9, 1.0)?.regime(), Regime::Swing);
    /// assert_eq!(Pendulum::<f64>::from_state(0.0, 2.0, 1.0)?.regime(), Regime::Separatrix);
    /// assert_eq!(Pendulum::<f64>::from_state(0.0, -2.1, 1.0)?.regime(), Regime::Rotation);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn from_state(theta: F, velocity: F, omega: F) -> Result<Self, Error> {
        let motion = launch::from_state(theta.widen(), velocity.widen(), omega.widen())?;
        Ok(Self { motion, scalar: PhantomData })
    }

    /// ω, the rate of small oscillations, rad per unit of t, as it was given.
    #[must_use]
    pub fn omega(&self) -> F {
        F::narrow(self.motion.omega)
    }

    /// θ(t), rad; turns counted, so that a rotation grows without bound.
    #[must_use]
    #[inline]
    pub fn theta(&self, t: F) -> F {
        F::narrow(t.evaluate(&self.motion, |motion, t| motion.angle(&motion.at(t))))
    }

    /// θ̇(t), rad per unit of t.
    #[must_use]
    #[inline]
    pub fn velocity(&self, t: F) -> F {
        F::narrow(t.evaluate(&self.motion, |motion, t| motion.velocity_at(&motion.at(t))))
    }

    /// (θ(t), θ̇(t)), sharing one phase reduction.
    #[must_use]
    #[inline]
    pub fn state(&self, t: F) -> (F, F) {
        let (theta, velocity) = t.evaluate(&self.motion, |motion, t| {
            let point = motion.at(t);
            (motion.angle(&point), motion.velocity_at(&point))
        });
        (F::narrow(theta), F::narrow(velocity))
    }

    /// θ̈(t) = −ω² sin θ(t), rad per unit of t squared.
    #[must_use]
    #[inline]
    pub fn acceleration(&self, t: F) -> F {
        F::narrow(t.evaluate(&self.motion, |motion, t| motion.acceleration(&motion.at(t))))
    }

    /// The bob, (sin θ, −cos θ), in units of the length, y upward; computed without θ and without an arctangent. Neither is
    /// ever beyond ±1.
    #[must_use]
    #[inline]
    pub fn position(&self, t: F) -> (F, F) {
        let (x, y) = t.evaluate(&self.motion, |motion, t| motion.position(&motion.at(t)));
        (F::narrow(x), F::narrow(y))
    }

    /// θ(t) less its whole turns, in [−π, π): keeps its digits however far a rotation has gone. `f64`'s `PI` is less
    /// than π and may be a result; `f32`'s, which is more, is none.
    #[must_use]
    #[inline]
    pub fn wrapped(&self, t: F) -> F {
        F::narrow_angle(t.evaluate(&self.motion, |motion, t| motion.wrapped(&motion.at(t))))
    }

    /// The first t ≥ 0 at which θ(t) = `theta`, turns counted. For the first after a time t₁ take the state at t₁, make a motion
    /// of it with [`from_state`](Self::from_state), and add t₁ to its answer.
    ///
    /// By Carlson's RF in twice the working precision, of differences of angles that are exact: within one ulp of the t
    /// at which the motion has the given angle, at any amplitude and next to any turning point. This holds for
    /// |velocity|/ω from 10⁻²⁹⁰ on, or none, and for angles from 10⁻²⁹⁰ away from the start and t from 10⁻²⁹⁰/ω on; beside
    /// the separatrix of a state in motion the last sentences under Conditioning hold of t, too.
    ///
    /// Near a turning point half an ulp of the *angle* moves t by √(ulp/|θ̈|). So that its turning points can be asked
    /// for, ± what [`amplitude`](Self::amplitude) returns stands for them, wherever it was rounded to; of a swing about a
    /// whole number of turns, what is beyond them by up to 2ε times the angle (two to four ulps), as may be what
    /// `turns * TAU ± amplitude` gives. The angle that the motion was given to start in is reached at t = 0.
    ///
    /// # Errors
    /// [`Error::NeverReached`] if no t ≥ 0 qualifies, if it is more than 10¹⁵ turns away, or if it is beyond the
    /// largest number; [`Error::NotFinite`].
    ///
    /// ```
    /// # use pendulum_runtime::{Error, Pendulum};
    /// let p = Pendulum::<f64>::new(2.0, 1.0)?;
    /// assert!((p.time_at(0.0)? - p.period() / 4.0).abs() < 1e-15);
    /// assert!(matches!(p.time_at(2.1), Err(Error::NeverReached { .. })));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn time_at(&self, theta: F) -> Result<F, Error> {
        let (angle, amplitude) = (theta.widen(), self.motion.amplitude);
        // What `amplitude` returns is the turning point, wherever it was rounded to, but where the motion starts there.
        let about_zero = self.motion.base.hi == 0.0;
        let is_turning = about_zero && self.regime() == Regime::Swing && angle.abs() == self.amplitude().widen();
        let target = if is_turning && angle != self.motion.theta { amplitude.copysign(angle) } else { angle };
        let beyond = if about_zero { 0.0 } else { 2.0 * F::ULP * angle.abs() };
        let time = F::narrow_or_infinite(self.motion.time_at(target, beyond)?);
        if time.widen().is_finite() { Ok(time) } else { Err(Error::NeverReached { angle }) }
    }

    /// T = 4K/ω of a swing, 2π/ω at rest, the time of one turn of a rotation, ∞ on the separatrix.
    #[must_use]
    pub fn period(&self) -> F {
        F::narrow_or_infinite(self.motion.period())
    }

    /// The largest |θ|, less whole turns of the initial angle, to 1 ulp of a normal number: 0 at rest, π on the separatrix,
    /// ∞ for a rotation.
    #[must_use]
    pub fn amplitude(&self) -> F {
        F::narrow_or_infinite(self.motion.amplitude)
    }

    /// The elliptic modulus k: sin(amplitude/2) of a swing, 1 on the separatrix, κ = 2ω/v0 < 1 of a rotation that passes the
    /// bottom at v0.
    #[must_use]
    pub fn modulus(&self) -> F {
        F::narrow(self.motion.moduli.k.to_f64())
    }

    /// The complementary modulus k′ = √(1 − k²): cos(amplitude/2) of a swing, 0 on the separatrix. Near the top, where k rounds
    /// to 1, it tells motions from each other.
    #[must_use]
    pub fn complementary_modulus(&self) -> F {
        F::narrow(self.motion.moduli.kc.to_f64())
    }

    /// The nome q = exp(−πK′/K) of the modulus; 1 on the separatrix.
    #[must_use]
    pub fn nome(&self) -> F {
        F::narrow(self.motion.nome())
    }

    /// K, the complete elliptic integral of the modulus: the quarter period of a swing in units of 1/ω
    /// (T = 4K/ω); ∞ on the separatrix. One turn of a rotation takes 2κK/ω.
    #[must_use]
    pub fn complete_integral(&self) -> F {
        F::narrow_or_infinite(self.motion.complete_integral())
    }

    /// K′, the complete elliptic integral of the complementary modulus; ∞ at rest.
    #[must_use]
    pub fn complementary_integral(&self) -> F {
        F::narrow_or_infinite(self.motion.complementary_integral())
    }

    /// What the pendulum does for all time.
    #[must_use]
    pub fn regime(&self) -> Regime {
        self.motion.regime()
    }

    /// The energy per unit of mass and length squared in units of ω², θ̇²/(2ω²) + 1 − cos θ: below 2 a swing, above a
    /// rotation; ∞ where that is larger than any number.
    #[must_use]
    pub fn energy(&self) -> F {
        F::narrow_or_infinite(self.motion.energy())
    }

    /// The small-angle approximation θ(0) cos ωt + (θ̇(0)/ω) sin ωt (Eq. 3, there from rest), θ being counted from the
    /// lowest point next to θ(0), with ωt less turns of 2π in two words: good to the last digits up to 2⁵⁰ turns.
    ///
    /// Its period is short by a fraction θ0²/16, so its error grows with t: at 10° 0.9 % of θ0 within one period, 12 %
    /// within ten.
    #[must_use]
    pub fn small_angle(&self, t: F) -> F {
        F::narrow(self.motion.small_angle(t.widen()))
    }

    /// The harmonic approximation (Eq. 17): the amplitude times cos(2πt/T) with the exact period, shifted to the phase of
    /// the initial state.
    ///
    /// NaN for rotation and separatrix.
    #[must_use]
    pub fn harmonic(&self, t: F) -> F {
        F::narrow(self.motion.harmonic(t.widen()))
    }

    /// The paper's θ̂ with N Fourier terms (Eq. 22).
    ///
    /// A supremum is sought for [`max_error`](Fourier::max_error), which takes some 20 µs with 4 terms; to be refused it
    /// takes longer the nearer to the top, up to 60 ms, since the smallest number of terms that works is sought.
    ///
    /// # Errors
    /// [`Error::Overshoot`] if N terms make the argument of the arcsine exceed 1 (from θ0 = 0.7308π for N = 1, 0.9046π
    /// for 2, 0.9139π for 3, 0.9547π for 4, …); [`Error::NoTerms`] for N = 0; [`Error::NotASwing`] for rotation and
    /// separatrix.
    pub fn fourier<const N: usize>(&self) -> Result<Fourier<N, F>, Error> {
        Fourier::new(&self.motion)
    }
}
