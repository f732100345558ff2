//! The exact motion of a pendulum from any state, by Fourier series in multiple precision.
//!
//! With m = (θ̇0/2ω)² + sin²(θ0/2): below 1 a swing of modulus k = √m, with the nome q = exp(−πK′/K) and, φ = t/T
//! periods after a turning point,
//!
//! θ = 8 Σ (−1)ⁿ⁻¹ qⁿ⁻¹ᐟ²/((2n−1)(1 + q²ⁿ⁻¹)) cos((2n−1)2πφ);
//!
//! above 1 a rotation of modulus 1/√m and, φ turns after passing the bottom,
//!
//! θ = 2πφ + 4 Σ qⁿ/(n(1 + q²ⁿ)) sin(2πnφ).
//!
//! For m = 1, from the bottom, θ = 4 arctan(e^ωt) − π. The runtime uses theta quotients instead. The tests of
//! [`truth`](crate::truth) compare with reference data by `mpmath`.

mod paper;
mod start;

pub use start::{Start, number};

use crate::big::Big;

/// Terms are left out from where they are less than 2 to this power.
const NEGLIGIBLE: i32 = -220;

/// The constants of one motion.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Where it starts from.
    pub start: Start,
    /// What it does for all time.
    pub regime: Regime,
    /// −1 for the mirror image of what is described.
    pub sign: f64,
}

/// What a motion does for all time.
#[derive(Clone, Debug)]
pub enum Regime {
    /// To and fro.
    Swing(Series),
    /// Over the top.
    Rotation(Series),
    /// To the top, from the bottom at t = 0.
    Separatrix,
}

/// A periodic motion.
#[derive(Clone, Debug)]
pub struct Series {
    /// The modulus, k of a swing and κ of a rotation, and its complement.
    pub modulus: [Big; 2],
    /// K and K′.
    pub quarters: [Big; 2],
    /// q
    pub nome: Big,
    /// T or the time of a turn.
    pub period: Big,
    /// φ at t = 0.
    pub launch: Big,
    coefficients: Vec<Big>,
}

/// θ (without whole turns) and dθ/dφ.
pub struct State {
    /// rad
    pub theta: Big,
    /// rad per period
    pub slope: Big,
}

/// The limit of the arithmetic and the geometric mean (Gauss).
fn agm(mut a: Big, mut b: Big) -> Big {
    let half = Big::from(0.5);
    while (&a - &b).magnitude() > a.magnitude() - 300 {
        let mean = &(&a + &b) * &half;
        b = (&a * &b).sqrt();
        a = mean;
    }
    // One more mean squares what is left.
    &(&a + &b) * &half
}

/// K(k) and K(k′) of k and k′.
pub fn quarters([modulus, complement]: &[Big; 2]) -> [Big; 2] {
    let half_pi = Big::pi() / 2.0.into();
    [&half_pi / &agm(1.0.into(), complement.clone()), &half_pi / &agm(1.0.into(), modulus.clone())]
}

impl Motion {
    /// The motion from `start`.
    ///
    /// # Panics
    /// For a separatrix that doesn't start at the bottom.
    pub fn new(start: Start) -> Self {
        let half_sine = (&start.theta0 / &2.0.into()).sin();
        let fraction = &(&start.velocity0 / &start.omega) / &2.0.into();
        let energy = &(&fraction * &fraction) + &(&half_sine * &half_sine);
        let complement = &Big::from(1.0) - &energy;
        // The mirror image is a motion of its own only for rotation; a swing's is half a period later.
        let backwards = start.velocity0.is_negative();
        if complement.is_zero() {
            assert!(half_sine.is_zero(), "a separatrix starts at the bottom");
            return Self { start, regime: Regime::Separatrix, sign: if backwards { -1.0 } else { 1.0 } };
        }
        if complement.is_negative() {
            let root = energy.sqrt();
            let modulus = [&Big::from(1.0) / &root, &(-&complement).sqrt() / &root];
            let mut series = Series::rotation(modulus, &(&start.omega * &root));
            let theta0 = &start.theta0 * &if backwards { -1.0 } else { 1.0 }.into();
            series.launch = series.solve(&theta0, Series::turning, [-0.5, 0.5]);
            return Self { start, regime: Regime::Rotation(series), sign: if backwards { -1.0 } else { 1.0 } };
        }
        let at_rest = start.velocity0.is_zero();
        let modulus = if at_rest { half_sine } else { energy.sqrt() };
        let sign = if modulus.is_negative() { -1.0 } else { 1.0 };
        let modulus = [&modulus * &sign.into(), complement.sqrt()];
        let mut series = Series::swing(modulus, &start.omega);
        if !at_rest {
            // θ falls while φ grows from 0 to ½.
            let phase = series.solve(&start.theta0, Series::swinging, [0.5, 0.0]);
            series.launch = if backwards { phase } else { -&phase };
        }
        Self { start, regime: Regime::Swing(series), sign }
    }

    /// T or the time of a turn; 1/ω on the separatrix.
    pub fn period(&self) -> Big {
        match &self.regime {
            Regime::Swing(series) | Regime::Rotation(series) => series.period.clone(),
            Regime::Separatrix => &Big::from(1.0) / &self.start.omega,
        }
    }

    /// The state at phase φ, without launch or mirror; on the separatrix φ = ωt.
    pub fn at_phase(&self, phase: &Big) -> State {
        match &self.regime {
            Regime::Swing(series) => series.swinging(phase),
            Regime::Rotation(series) => series.turning(phase),
            Regime::Separatrix => {
                let grown = phase.exp();
                let theta = &(&grown.atan() * &4.0.into()) - &Big::pi();
                let slope = &Big::from(4.0) / &(&grown + &(&Big::from(1.0) / &grown));
                State { theta, slope }
            }
        }
    }

    /// The phase at `t`: whole periods, and what is left, in [−½, ½); on the separatrix none, and ωt.
    pub fn phase(&self, t: f64) -> [Big; 2] {
        let elapsed = &Big::from(t) / &self.period();
        match &self.regime {
            Regime::Swing(series) | Regime::Rotation(series) => {
                let phase = &elapsed + &series.launch;
                let rest = phase.less_turns();
                [&phase - &rest, rest]
            }
            Regime::Separatrix => [Big::from(0.0), elapsed],
        }
    }
}

impl Series {
    fn swing(modulus: [Big; 2], omega: &Big) -> Self {
        let quarters = quarters(&modulus);
        let period = &(&quarters[0] * &4.0.into()) / omega;
        let half = (&(&Big::pi() * &(&quarters[1] / &quarters[0])) * &(-0.5).into()).exp();
        let nome = &half * &half;
        let mut coefficients: Vec<Big> = Vec::new();
        // power = qⁿ⁻¹ᐟ², and its square is q²ⁿ⁻¹.
        let mut power = half;
        while coefficients.first().is_none_or(|first| power.magnitude() > first.magnitude() + NEGLIGIBLE) {
            let n = coefficients.len();
            let below = &Big::from((2 * n + 1) as f64) * &(&Big::from(1.0) + &(&power * &power));
            coefficients.push(&(&power * &if n.is_multiple_of(2) { 8.0 } else { -8.0 }.into()) / &below);
            power = &power * &nome;
        }
        Self { modulus, quarters, nome, period, launch: 0.0.into(), coefficients }
    }

    fn rotation(modulus: [Big; 2], half_fastest: &Big) -> Self {
        let quarters = quarters(&modulus);
        let period = &(&quarters[0] * &2.0.into()) / half_fastest;
        let nome = (&(&Big::pi() * &(&quarters[1] / &quarters[0])) * &(-1.0).into()).exp();
        let mut coefficients: Vec<Big> = Vec::new();
        let mut power = nome.clone();
        while power.magnitude() > NEGLIGIBLE {
            let n = Big::from((coefficients.len() + 1) as f64);
            let below = &n * &(&Big::from(1.0) + &(&power * &power));
            coefficients.push(&(&power * &4.0.into()) / &below);
            power = &power * &nome;
        }
        Self { modulus, quarters, nome, period, launch: 0.0.into(), coefficients }
    }

    fn swinging(&self, phase: &Big) -> State {
        let turn = &Big::pi() * &2.0.into();
        let x = phase * &turn;
        let (sine, cosine) = (x.sin(), x.cos());
        // Clenshaw in 2cos 2x: Σ cₙ cos((2n−1)x) = (b₁ − b₂) cos x, Σ (2n−1)cₙ sin((2n−1)x) = (b₁ + b₂) sin x.
        let double = &(&(&cosine * &cosine) * &4.0.into()) - &2.0.into();
        let [first, second] = clenshaw(self.coefficients.iter().cloned(), &double);
        let theta = &cosine * &(&first - &second);
        let weighted = self.coefficients.iter().enumerate().map(|(n, c)| c * &Big::from((2 * n + 1) as f64));
        let [first, second] = clenshaw(weighted, &double);
        State { theta, slope: -&(&turn * &(&sine * &(&first + &second))) }
    }

    fn turning(&self, phase: &Big) -> State {
        let turn = &Big::pi() * &2.0.into();
        let x = phase * &turn;
        let (sine, cosine) = (x.sin(), x.cos());
        // Clenshaw in 2cos x: Σ aₙ sin nx = b₁ sin x, Σ n·aₙ cos nx = b₁ cos x − b₂.
        let double = &cosine * &2.0.into();
        let [first, _] = clenshaw(self.coefficients.iter().cloned(), &double);
        let theta = &x + &(&first * &sine);
        let weighted = self.coefficients.iter().enumerate().map(|(n, c)| c * &Big::from((n + 1) as f64));
        let [first, second] = clenshaw(weighted, &double);
        State { theta, slope: &turn * &(&Big::from(1.0) + &(&(&first * &cosine) - &second)) }
    }

    /// The phase at which the angle is `theta`, which grows from the first to the second of `between`.
    fn solve(&self, theta: &Big, state: impl Fn(&Self, &Big) -> State, between: [f64; 2]) -> Big {
        let [mut low, mut high] = between.map(Big::from);
        let mut middle = low.clone();
        // Bisection until Newton's method doubles the digits in every step.
        for _ in 0..48 {
            middle = &(&low + &high) * &0.5.into();
            if (&state(self, &middle).theta - theta).is_negative() {
                low = middle.clone();
            } else {
                high = middle.clone();
            }
        }
        for _ in 0..4 {
            let State { theta: here, slope } = state(self, &middle);
            middle = &middle - &(&(&here - theta) / &slope);
        }
        middle
    }
}

/// b₁ and b₂ of Clenshaw's recurrence.
fn clenshaw(coefficients: impl DoubleEndedIterator<Item = Big>, double: &Big) -> [Big; 2] {
    let (mut first, mut second) = (Big::from(0.0), Big::from(0.0));
    for coefficient in coefficients.rev() {
        let next = &(&coefficient + &(double * &first)) - &second;
        second = std::mem::replace(&mut first, next);
    }
    [first, second]
}
