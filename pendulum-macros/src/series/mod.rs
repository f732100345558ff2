//! The Fourier series of the outputs: independent values to sample, and bounds in the complex plane.

mod pieces;

use crate::chebyshev::{cos_pi, sin_pi};
use crate::motion::{Elliptic, Rotation, Swing};
use crate::power::{power, two_to};
use crate::program::rounding::{INFLATION_OF_SUMS, LOST};
use pendulum_runtime::double::Double;
use std::f64::consts::PI;

/// constant + Σ aₘ cos(mπs) or constant + linear·s + Σ aₘ sin(mπs), s being the phase in anchors.
#[derive(Clone, Debug)]
pub(crate) struct Wave {
    parity: Parity,
    linear: Double,
    constant: Double,
    /// (m, aₘ), m increasing.
    terms: Vec<(u32, Double)>,
    /// Bounds what the omitted terms can add, what those kept lost to underflow, and what it strays by, for real s.
    omitted: f64,
    /// The m of the first that is omitted, if any is.
    first_omitted: Option<u32>,
    /// Of the series' terms; `None` of a finite sum that is no part of one.
    envelope: Option<Envelope>,
}

/// The symmetry about an anchor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Parity {
    Even,
    Odd,
    /// About the middle of an arc that begins anywhere.
    Neither,
}

/// |aₘ| ≤ size·mᵖ·exp(−rate·m).
#[derive(Clone, Copy, Debug)]
struct Envelope {
    size: f64,
    power: i32,
    rate: f64,
}

/// From term to term m grows by this: all of a series are odd multiples of πs, or all are even.
const STEP: u32 = 2;

/// A series ends where a bound of all that follows is below this part of its largest number: far below the rounding of
/// any output.
const NEGLIGIBLE: f64 = 1e-23;

impl Wave {
    /// θ of a swing about its turning point (the series of θ itself, differentiated `order` times with respect to s/`rate`):
    /// θ = 8 Σ (−1)ⁿ⁻¹ q^(n−½)/((2n−1)(1 + q²ⁿ⁻¹)) cos((2n−1)πs), `unit` times, of which the values
    /// are no large multiples: it comes last, since it may be next to the smallest numbers.
    pub(crate) fn swing(swing: &Swing, order: i32, rate: Double, unit: Double) -> Self {
        let nome = swing.elliptic.nome.to_double();
        let root = swing.elliptic.nome.sqrt().to_double();
        let size = 8.0 * power(PI * rate.hi, order) * unit.hi;
        let envelope = Envelope::of(&swing.elliptic, size, order - 1);
        let mut power = root; // q^(m/2)
        let turn = Double::PI * rate;
        let terms = (1..).step_by(2).map(|m: u32| {
            let odd = m % 4 == 3;
            let size = power * 8.0 / (Double::ONE + power * power) / f64::from(m);
            power = power * nome;
            let amplitude = (0..order).fold(size, |size, _| size * turn * f64::from(m)) * unit;
            // Derivatives of the cosine: −sin, −cos, sin, cos.
            let negative = odd ^ matches!(order % 4, 1 | 2);
            (m, if negative { -amplitude } else { amplitude })
        });
        let parity = if order % 2 == 0 { Parity::Even } else { Parity::Odd };
        Self::collect(parity, [Double::ZERO; 2], terms, envelope)
    }

    /// sin(θ/2) = k sn of a swing about its turning point: (2π/K) Σ (−1)ⁿ⁻¹ q^(n−½)/(1 − q²ⁿ⁻¹) cos((2n−1)πs) (Eq. 20).
    pub(crate) fn half_sine(swing: &Swing) -> Self {
        let front = Double::TURN / swing.elliptic.quarter.to_double();
        Self::sn_or_cn(&swing.elliptic, front, Parity::Even)
    }

    /// cos(θ/2) = dn of a swing about its turning point: (π/2K)(1 + 4 Σ (−1)ⁿ qⁿ/(1 + q²ⁿ) cos(2nπs)).
    pub(crate) fn half_cosine(swing: &Swing) -> Self {
        let nome = swing.elliptic.nome.to_double();
        let mut power = nome;
        let front = Double::PI / (swing.elliptic.quarter.to_double() * 2.0);
        let envelope = Envelope::of(&swing.elliptic, front.hi * 4.0, 0);
        let terms = (1..).map(|n: u32| {
            let size = front * power * 4.0 / (Double::ONE + power * power);
            power = power * nome;
            (2 * n, if n % 2 == 1 { -size } else { size })
        });
        Self::collect(Parity::Even, [Double::ZERO, front], terms, envelope)
    }

    /// θ − π of a rotation about the top, differentiated `order` times with respect to s/`rate` (s in turns):
    /// 2πs + 4 Σ (−1)ⁿ qⁿ/(n(1 + q²ⁿ)) sin(2nπs), `unit` times, of which the values are no large
    /// multiples: it comes last, since it may be next to the smallest numbers.
    pub(crate) fn rotation(rotation: &Rotation, order: i32, rate: Double, unit: Double) -> Self {
        let nome = rotation.elliptic.nome.to_double();
        let size = 8.0 * power(PI * rate.hi, order) * unit.hi;
        let envelope = Envelope::of(&rotation.elliptic, size, order - 1);
        let mut power = nome;
        let turn = Double::PI * rate;
        let terms = (1..).map(|n: u32| {
            let size = power * 4.0 / (Double::ONE + power * power) / f64::from(n);
            power = power * nome;
            let amplitude = (0..order).fold(size, |size, _| size * turn * f64::from(2 * n)) * unit;
            let negative = (n % 2 == 1) ^ matches!(order % 4, 2 | 3);
            (2 * n, if negative { -amplitude } else { amplitude })
        });
        let (parity, polynomial) = match order {
            0 => (Parity::Odd, [Double::TURN * unit, Double::ZERO]),
            1 => (Parity::Even, [Double::ZERO, turn * 2.0 * unit]),
            _ => (if order % 2 == 0 { Parity::Odd } else { Parity::Even }, [Double::ZERO; 2]),
        };
        Self::collect(parity, polynomial, terms, envelope)
    }

    /// The mirror image.
    pub(crate) fn negated(mut self) -> Self {
        self.terms.iter_mut().for_each(|(_, amplitude)| *amplitude = -*amplitude);
        Self { linear: -self.linear, constant: -self.constant, ..self }
    }

    /// Whether its sign is another one an anchor later, if nothing of it grows.
    pub(crate) fn is_antiperiodic(&self) -> bool {
        self.terms.first().is_some_and(|(m, _)| m % 2 == 1)
    }

    /// The symmetry about a number of halves of an anchor: sines of odd multiples of πs are cosines from half-way on.
    pub(crate) fn parity_about(&self, halves: Option<i64>) -> Parity {
        match (self.parity, halves.map(|halves| self.is_antiperiodic() && halves % 2 != 0)) {
            (_, None) => Parity::Neither,
            (Parity::Even, Some(true)) => Parity::Odd,
            (Parity::Odd, Some(true)) => Parity::Even,
            (parity, _) => parity,
        }
    }

    /// With a constant added.
    pub(crate) fn raised(self, by: Double) -> Self {
        Self { constant: self.constant + by, ..self }
    }

    /// The same without what grows.
    pub(crate) fn without_mean(self) -> Self {
        Self { linear: Double::ZERO, ..self }
    }

    /// sn or −cn of a rotation about the top: cos and −sin of half the angle from there,
    /// (2π/(κK)) Σ (−1)ⁿ q^(n+½) cos((2n+1)πs)/(1 − q²ⁿ⁺¹) and −(2π/(κK)) Σ (−1)ⁿ q^(n+½) sin((2n+1)πs)/(1 + q²ⁿ⁺¹).
    pub(crate) fn from_top(rotation: &Rotation, parity: Parity) -> Self {
        let elliptic = &rotation.elliptic;
        let front = Double::TURN / (&elliptic.modulus * &elliptic.quarter).to_double();
        Self::sn_or_cn(elliptic, front, parity)
    }

    /// Σ (−1)ⁿ q^(n+½) cos((2n+1)πs)/(1 − q²ⁿ⁺¹) or −Σ (−1)ⁿ q^(n+½) sin((2n+1)πs)/(1 + q²ⁿ⁺¹), `front` times.
    fn sn_or_cn(elliptic: &Elliptic, front: Double, parity: Parity) -> Self {
        let nome = elliptic.nome.to_double();
        let mut power = elliptic.nome.sqrt().to_double();
        let envelope = Envelope::of(elliptic, front.hi / (1.0 - nome.hi), 0);
        let terms = (1..).step_by(2).map(|m: u32| {
            let square = power * power;
            let size = front * power / if parity == Parity::Even { Double::ONE - square } else { Double::ONE + square };
            power = power * nome;
            (m, if (m % 4 == 3) ^ (parity == Parity::Odd) { -size } else { size })
        });
        Self::collect(parity, [Double::ZERO; 2], terms, envelope)
    }

    /// Σ wₙ cos((2n−1)πs), nothing omitted.
    pub(crate) fn harmonics(weights: &[Double]) -> Self {
        let terms = weights.iter().enumerate().map(|(index, &weight)| (2 * index as u32 + 1, weight)).collect();
        Self { terms, ..Self::cosine() }
    }

    /// sin(πs).
    pub(crate) fn sine() -> Self {
        Self { parity: Parity::Odd, ..Self::cosine() }
    }

    /// cos(πs).
    fn cosine() -> Self {
        Self {
            parity: Parity::Even,
            linear: Double::ZERO,
            constant: Double::ZERO,
            terms: vec![(1, Double::ONE)],
            omitted: 0.0,
            first_omitted: None,
            envelope: None,
        }
    }

    fn collect(
        parity: Parity,
        [linear, constant]: [Double; 2],
        terms: impl Iterator<Item = (u32, Double)>,
        envelope: Envelope,
    ) -> Self {
        let mut kept: Vec<(u32, Double)> = Vec::new();
        let (mut largest, mut most) = (linear.hi.abs().max(constant.hi.abs()), linear.hi.abs() + constant.hi.abs());
        let (mut omitted, mut first_omitted) = (0.0, None);
        for (m, amplitude) in terms {
            first_omitted = Some(m);
            largest = largest.max(amplitude.hi.abs());
            let tail = envelope.tail(m, 0.0);
            // The recurrence's numbers are at most Σ |aₙ|(n + 1), and a product in two words takes them 2²⁷ times. Where that
            // overflows they are NaN, so that no comparison holds, nor a bound.
            most += amplitude.hi.abs() * f64::from(m / STEP + 1);
            if !(envelope.size + most * two_to(28)).is_finite() {
                omitted = f64::INFINITY;
                break;
            }
            if tail <= NEGLIGIBLE * largest {
                omitted = tail;
                break;
            }
            kept.push((m, amplitude));
        }
        omitted += lost(kept.len());
        Self { parity, linear, constant, terms: kept, omitted, first_omitted, envelope: Some(envelope) }
    }

    /// The sum of its first terms, nothing omitted; as unknown as the whole if these overflow.
    pub(crate) fn first(mut self, terms: usize) -> Self {
        self.terms.truncate(terms);
        if self.omitted.is_finite() {
            self.omitted = lost(self.terms.len());
            self.first_omitted = None;
        }
        self
    }

    /// Stands for another, from which it strays by at most that for real s.
    pub(crate) fn stray(&mut self, by: f64) {
        self.omitted += by;
    }

    /// The value at the phase s, |s| ≤ 1.5, by Clenshaw's recurrence: from term to term waves φ obey φₙ₊₁ = 2 cos(2πs)φₙ −
    /// φₙ₋₁, so that Σ aₙφₙ = b₀φ₀ − b₁φ₋₁ with bₙ = aₙ + 2 cos(2πs)bₙ₊₁ − bₙ₊₂.
    pub(crate) fn at(&self, s: Double) -> Double {
        let (cosine, sine) = (cos_pi(s), sin_pi(s));
        let turn = cosine * cosine - sine * sine;
        let twice = turn * 2.0;
        let (small, [mut this, mut next]) = self.small_terms(twice);
        for &(_, amplitude) in self.terms[..self.terms.len() - small].iter().rev() {
            (this, next) = (amplitude + twice * this - next, this);
        }
        let of_even_multiples = matches!(self.terms.first(), Some(&(2, _)));
        let [first, before] = match (self.parity, of_even_multiples) {
            (Parity::Even, true) => [turn, Double::ONE],
            (Parity::Even, false) => [cosine, cosine],
            (_, true) => [cosine * sine * 2.0, Double::ZERO],
            (_, false) => [sine, -sine],
        };
        self.constant + self.linear * s + (this * first - next * before)
    }

    /// How many of the last terms are so small that they can be summed in one word, and bₙ and bₙ₊₁ of the first of these:
    /// as long as the rounding of their recurrence, 15 units of Σ |bₙ| at most, takes less than 2⁻¹⁰⁰ of the first amplitude.
    fn small_terms(&self, twice: Double) -> (usize, [Double; 2]) {
        let terms = &self.terms[..];
        let enough = self.first_amplitude() * two_to(-51);
        let (mut count, mut this, mut next, mut all) = (0, 0.0, 0.0, 0.0);
        while count < terms.len() {
            let value: f64 = terms[terms.len() - 1 - count].1.hi + twice.hi * this - next;
            all += value.abs();
            if all > enough {
                break;
            }
            next = this;
            this = value;
            count += 1;
        }
        (count, [this, next].map(Double::new))
    }

    fn first_amplitude(&self) -> f64 {
        self.terms.first().map_or(0.0, |(_, amplitude)| amplitude.hi.abs())
    }

    /// The value at the phase s in one word: wrong by less than 10⁻¹¹ of the terms' sum.
    pub(crate) fn roughly(&self, s: f64) -> f64 {
        self.constant.hi + self.linear.hi * s + self.sum_roughly(s, self.parity, |_, amplitude| amplitude)
    }

    /// The derivative likewise.
    pub(crate) fn slope_roughly(&self, s: f64) -> f64 {
        let (parity, sign) = if self.parity == Parity::Even { (Parity::Odd, -PI) } else { (Parity::Even, PI) };
        self.linear.hi + self.sum_roughly(s, parity, |m, amplitude| sign * f64::from(m) * amplitude)
    }

    /// Σ sₘ cos(mπs) or Σ sₘ sin(mπs), with sizes sₘ made of m and aₘ.
    fn sum_roughly(&self, s: f64, parity: Parity, size: impl Fn(u32, f64) -> f64) -> f64 {
        let angle = PI * s;
        let (mut sine, mut cosine) = libm::sincos(f64::from(self.terms.first().map_or(1, |term| term.0)) * angle);
        let (turn_sine, turn) = libm::sincos(f64::from(STEP) * angle);
        let mut sum = 0.0;
        for &(m, amplitude) in &self.terms {
            sum += size(m, amplitude.hi) * if parity == Parity::Even { cosine } else { sine };
            (cosine, sine) = (cosine * turn - sine * turn_sine, sine * turn + cosine * turn_sine);
        }
        sum
    }

    /// Bounds |value| for |Im s| ≤ `height` and |s| ≤ 4; infinite beyond the strip of convergence.
    pub(crate) fn bound(&self, height: f64) -> f64 {
        let growth = PI * height;
        let kept: f64 = self.terms.iter().map(|&(m, a)| a.hi.abs() * libm::cosh(growth * f64::from(m))).sum();
        let tail = self.tail(growth, |envelope| envelope);
        (4.0 * self.linear.hi.abs() + self.constant.hi.abs() + kept + tail) * INFLATION_OF_SUMS
    }

    /// Bounds |derivative| of what is periodic.
    pub(crate) fn steepest(&self) -> f64 {
        let kept: f64 = self.terms.iter().map(|&(m, a)| a.hi.abs() * PI * f64::from(m)).sum();
        (kept + self.omitted_slope()) * INFLATION_OF_SUMS
    }

    /// The series converges for |Im s| below this; infinite of a finite sum that is no part of one.
    pub(crate) fn strip(&self) -> f64 {
        self.envelope.map_or(f64::INFINITY, |envelope| envelope.rate / PI)
    }

    /// Bounds what the omitted terms, as large as an envelope that is made of theirs, can add for |Im s| ≤ `growth`/π.
    fn tail(&self, growth: f64, made: impl Fn(Envelope) -> Envelope) -> f64 {
        let envelope = self.envelope.zip(self.first_omitted);
        envelope.map_or(0.0, |(envelope, first)| made(envelope).tail(first, growth))
    }

    /// (m, aₘ) of the terms kept.
    pub(crate) fn terms(&self) -> &[(u32, Double)] {
        &self.terms
    }

    /// What the omitted terms can add for real s.
    pub(crate) fn omitted(&self) -> f64 {
        self.omitted
    }

    /// What they can add to the derivative.
    pub(crate) fn omitted_slope(&self) -> f64 {
        let of_slope = |Envelope { size, power, rate }| Envelope { size: size * PI, power: power + 1, rate };
        self.tail(0.0, of_slope)
    }

    /// Bounds what a value is rounded by, also of [`Self::at_pieces`]. The recurrence gives the sum with what each step is
    /// off by added to its amplitude, times a wave, of which none exceeds 1. Cosine and sine of πs are within 2⁻¹⁰⁰, hence
    /// 2 cos 2πs within 2⁻⁹⁷ and a step within 2⁻⁹⁶ of the sums it is made of, and what its product lost. These, like
    /// Chebyshev's Uₙ, add up to at most Σ |aₙ|(n + 1)(n + 2)/2.
    pub(crate) fn sampling_error(&self) -> f64 {
        let of = |&(m, a): &(u32, Double)| {
            let above = f64::from(m / STEP + 1);
            a.hi.abs() * above * (above + 1.0) * two_to(-96)
        };
        let once = self.constant.hi.abs() + self.linear.hi.abs() + self.first_amplitude();
        // Of products with amplitudes, in parts of four times as many, and of those with up to 256 sums of them.
        let lost = LOST * (4 * self.terms.len() + 256) as f64;
        self.terms.iter().map(of).sum::<f64>() + once * two_to(-100) + lost
    }
}

/// What so many terms lost to underflow: amplitudes, what isn't periodic, and the unit.
fn lost(terms: usize) -> f64 {
    LOST * (terms + 2) as f64
}

impl Envelope {
    /// Of powers of q^½, q = exp(−πK′/K).
    fn of(elliptic: &Elliptic, size: f64, power: i32) -> Self {
        let decay = PI * (&elliptic.quarter_complementary / &elliptic.quarter).to_f64();
        Self { size, power, rate: decay / 2.0 }
    }

    /// Bounds Σ |aₘ| exp(growth·m) over m = first, first + STEP, …
    fn tail(self, first: u32, growth: f64) -> f64 {
        let rate = self.rate - growth;
        if rate <= 0.0 {
            return f64::INFINITY;
        }
        let step = f64::from(STEP);
        let m = f64::from(first);
        // mᵖ grows by at most (1 + step/m)ᵖ a step.
        let ratio = libm::exp(-rate * step) * power(1.0 + step / m, self.power.max(0));
        if ratio >= 1.0 {
            return f64::INFINITY;
        }
        self.size * power(m, self.power) * libm::exp(-rate * m) / (1.0 - ratio)
    }
}
