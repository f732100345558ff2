//! Independent truth about swings, to about 28 digits at any time up to 2⁵⁴ periods: quotients of theta functions in
//! double-double arithmetic, their constants from `swings.csv` (mpmath).
//!
//! With x = 2πt/T counted from the release and h = exp(−πK′/(2K)), S = Σ 2h^(n²) cos nx over odd n and C = 1 + the same
//! over even n: θ = 4 atan2(S, C). Above a right angle or so the dual is the short one: y = x·K/K′,
//! h = exp(−πK/(2K′)), cosh for cos, θ = 4 atan2(C − S, C + S) in the first quarter.
#![allow(dead_code, unreachable_pub, reason = "each test crate uses its own part of this module")]

mod elementary;
pub mod times;

use elementary::{exp, sin_cos};
use pendula_stress::reference::bits;
use pendulum_runtime::double::{Double, two_prod};

/// A swing between turning points, known exactly.
#[derive(Clone, Copy, Debug)]
pub struct Swing {
    rate: [f64; 3],
    frequency: Double,
    dual: bool,
    base: Double,
    stretch: Double,
    launch: Double,
}

/// What the swing does at one time.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// θ, rad.
    pub theta: Double,
    /// θ̇ in rad·ω.
    pub velocity: Double,
    pub sine: Double,
    pub cosine: Double,
}

impl Swing {
    /// The swing that starts from `theta0;velocity0;omega`, as the tests write them.
    pub fn named(start: &str) -> Self {
        let bare = |text: &str| text.chars().filter(|c| !c.is_whitespace() && !"()".contains(*c)).collect::<String>();
        let start = bare(start);
        let row = include_str!("swings.csv")
            .lines()
            .filter_map(|line| line.split_once(','))
            .find_map(|(name, row)| (bare(name) == start).then_some(row));
        let row = row.unwrap_or_else(|| panic!("swings.csv lacks {start}: add it to swings.py"));
        let cells: Vec<&str> = row.split(',').collect();
        let word = |i: usize| bits(cells[i]);
        let double = |i: usize| Double::from_sum(word(i), word(i + 1));
        Self {
            rate: [word(0), word(1), word(2)],
            frequency: double(3),
            dual: cells[5] == "1",
            base: double(6),
            stretch: double(8),
            launch: double(10),
        }
    }

    /// The largest |θ|, |θ̇|/ω and |θ̈|/ω².
    pub fn largest(&self) -> [f64; 3] {
        let (turn, bottom) = (self.at(self.time_of(0.0)), self.at(self.time_of(0.25)));
        let steepest = if turn.theta.hi.abs() < core::f64::consts::FRAC_PI_2 { turn.sine.hi.abs() } else { 1.0 };
        [turn.theta.hi.abs(), bottom.velocity.hi.abs(), steepest]
    }

    pub fn period(&self) -> f64 {
        1.0 / self.rate[0]
    }

    /// The time at which the phase is `phase` periods after the release, in the first period.
    pub fn time_of(&self, phase: f64) -> f64 {
        (phase - self.launch.hi) / self.rate[0]
    }

    /// t/T + launch less the nearest integer.
    fn phase(&self, t: f64) -> Double {
        let [first, second, third] = self.rate;
        let ((p, p_rest), (q, q_rest)) = (two_prod(t, first), two_prod(t, second));
        let whole = Double::from_sum(p - p.round(), p_rest) + Double::from_sum(q - q.round(), q_rest);
        let phase = whole + Double::new(t * third) + self.launch;
        phase - Double::new(phase.hi.round())
    }

    /// The state at `t`.
    pub fn at(&self, t: f64) -> State {
        let phase = self.phase(t);
        let distance = phase.abs();
        // The second quarter is the first, backwards and below.
        let beyond = distance.hi > 0.25;
        let quarter = if beyond { Double::new(0.5) - distance } else { distance };
        let [p, q, dp, dq] = self.pair(Double::PI * quarter.scale(2.0) * self.stretch);
        let approximate = 4.0 * p.hi.atan2(q.hi);
        let (sine, cosine) = sin_cos(Double::new(approximate / 4.0));
        let correction = (p * cosine - q * sine) / (q * cosine + p * sine);
        let theta = Double::new(approximate) + correction.scale(4.0);
        let square = p * p + q * q;
        let slope = (dp * q - p * dq).scale(4.0) / square * self.stretch * self.frequency;
        // e^(iθ/4) = (q + ip)/√(p² + q²), squared twice.
        let (half_cosine, half_sine) = ((q * q - p * p) / square, (p * q).scale(2.0) / square);
        let sine = (half_sine * half_cosine).scale(2.0);
        State {
            theta: if beyond { -theta } else { theta },
            velocity: if phase.hi < 0.0 { -slope } else { slope },
            sine: if beyond { -sine } else { sine },
            cosine: half_cosine * half_cosine - half_sine * half_sine,
        }
    }

    /// (P, Q) with θ = 4 atan2(P, Q), and their derivatives by the variable of the sums.
    fn pair(&self, x: Double) -> [Double; 4] {
        // (cos nx, sin nx), or (cosh, sinh), of successive n.
        let (cosine, sine, sign) = if self.dual {
            let (grown, shrunk) = (exp(x), exp(-x));
            ((grown + shrunk).scale(0.5), (grown - shrunk).scale(0.5), Double::ONE)
        } else {
            let (half_sine, half_cosine) = sin_cos(x.scale(0.5));
            (half_cosine * half_cosine - half_sine * half_sine, (half_sine * half_cosine).scale(2.0), -Double::ONE)
        };
        let (mut c, mut s) = (cosine, sine);
        // h^(n²) and h^(2n+1), by which it goes on.
        let square = self.base * self.base;
        let (mut power, mut step) = (self.base, square * self.base);
        let [mut odd, mut even, mut d_odd, mut d_even] = [Double::ZERO, Double::ONE, Double::ZERO, Double::ZERO];
        for n in 1..=12 {
            let (value, slope) = ((power * c).scale(2.0), (power * s).scale(2.0) * sign * f64::from(n));
            if n % 2 == 1 {
                (odd, d_odd) = (odd + value, d_odd + slope);
            } else {
                (even, d_even) = (even + value, d_even + slope);
            }
            (c, s) = (c * cosine + sign * s * sine, s * cosine + c * sine);
            (power, step) = (power * step, step * square);
        }
        if self.dual { [even - odd, even + odd, d_even - d_odd, d_even + d_odd] } else { [odd, even, d_odd, d_even] }
    }
}

/// |x − exact|.
pub fn distance(x: f64, exact: Double) -> f64 {
    (Double::new(x) - exact).abs().to_f64()
}
