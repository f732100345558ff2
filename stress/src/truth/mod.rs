//! Truth at hundreds of millions of times: the motion by Taylor polynomials about points of its phase.
//!
//! The phase comes from integer arithmetic: t is an integer times a power of two, so a window of the binary digits of
//! 1/T times that integer has the turns and 139 bits of the phase, whatever t (Payne and Hanek 1983). A polynomial for
//! each small interval has its coefficients from the equation of motion at a state computed by [`Motion`], the first in
//! two words. What is left is the rounding of the first-order term: 2⁻⁵⁸ of the largest value or less, a 256th of what
//! is promised at full precision. [`Truth::direct`] does without all of that.

mod clock;

use crate::big::Big;
use crate::motion::{Motion, Regime, State};
use clock::{Clock, Phase};

/// Degree of the polynomials; see [`intervals`].
const DEGREE: usize = 12;
/// A value in two words, and the polynomial's other coefficients.
type Node = [f64; DEGREE + 2];

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// θ, turns counted, rad.
    Theta,
    /// θ modulo a turn, rad.
    Wrapped,
    /// θ̇, rad per unit of time.
    Velocity,
    /// θ̈, rad per unit of time squared.
    Acceleration,
    /// (sin θ, −cos θ).
    Position,
}

impl Output {
    /// As it is written in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Theta => "theta",
            Self::Wrapped => "wrapped",
            Self::Velocity => "velocity",
            Self::Acceleration => "acceleration",
            Self::Position => "position",
        }
    }

    /// That which is written so.
    ///
    /// # Panics
    /// If there is none.
    pub fn named(name: &str) -> Self {
        let all = [Self::Theta, Self::Wrapped, Self::Velocity, Self::Acceleration, Self::Position];
        all.into_iter().find(|output| output.name() == name).expect("the name of an output")
    }

    /// The unit in which errors are measured: a power of ω.
    pub fn unit(self, omega: f64) -> f64 {
        match self {
            Self::Velocity => omega,
            Self::Acceleration => omega * omega,
            _ => 1.0,
        }
    }
}

/// One output of one motion.
pub struct Truth {
    motion: Motion,
    output: Output,
    /// The power of ω in the output, by which errors are divided.
    unit: f64,
    clock: Clock,
    /// Polynomials over the intervals of one period, for the output or for both coordinates.
    tables: Vec<Vec<Node>>,
}

/// Intervals per period. The nearest singularity of θ lies at a distance of K′/(4K) periods or more from the real axis
/// (for a swing; twice that for a rotation), so that half an interval is at most 2⁻⁷ of it, and the thirteenth power of
/// that 2⁻⁹¹.
fn intervals(motion: &Motion) -> u32 {
    match &motion.regime {
        Regime::Swing(series) | Regime::Rotation(series) => {
            let [quarter, complementary] = series.quarters.each_ref().map(Big::to_f64);
            512_u32 * ((quarter / complementary).max(1.0).ceil() as u32).next_power_of_two()
        }
        Regime::Separatrix => 64,
    }
}

/// On the separatrix, the largest |ωt| that has intervals of its own; beyond it 4e^(−ωt) is less than 2⁻⁹⁰.
const SPAN: f64 = 64.0;

impl Truth {
    /// Prepares the tables.
    pub fn new(motion: Motion, output: Output) -> Self {
        let per_unit = intervals(&motion);
        let count =
            if matches!(motion.regime, Regime::Separatrix) { (2.0 * SPAN) as u32 * per_unit + 1 } else { per_unit };
        let mut truth = Self::without_tables(motion, output);
        let motion = &truth.motion;
        let coordinates = if output == Output::Position { 2 } else { 1 };
        let mut tables = vec![Vec::with_capacity(count as usize); coordinates];
        for index in 0..count {
            let ahead = f64::from(index) / f64::from(per_unit);
            // Within half a period of the anchor, so that a rotation's angle is within ±π, or within the separatrix's
            // span.
            let start = if count > per_unit { -SPAN } else { -(ahead + 0.5).floor() };
            let phase = Big::from(start + ahead);
            for (table, node) in tables.iter_mut().zip(nodes(motion, output, &phase, per_unit)) {
                table.push(node);
            }
        }
        truth.tables = tables;
        truth
    }

    /// For [`direct`](Self::direct) only.
    pub fn without_tables(motion: Motion, output: Output) -> Self {
        let clock = Clock::new(&motion, intervals(&motion));
        let unit = output.unit(motion.start.omega.to_f64());
        Self { motion, output, unit, clock, tables: Vec::new() }
    }

    /// The motion.
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// The error of `given` at time `t` (only the first number, but for a position), in units of ω's power.
    pub fn error(&self, t: f64, given: [f64; 2]) -> f64 {
        let phase = self.clock.at(t);
        let error = match self.output {
            Output::Position => self.distance(0, &phase, given[0], 0.0).hypot(self.distance(1, &phase, given[1], 0.0)),
            Output::Theta => self.distance(0, &phase, given[0], phase.turns),
            Output::Wrapped => {
                let turns = ((given[0] - self.tables[0][phase.index][0]) / std::f64::consts::TAU).round();
                self.distance(0, &phase, given[0], turns)
            }
            _ => self.distance(0, &phase, given[0], 0.0),
        };
        error / self.unit
    }

    /// |given − (polynomial + turns·2π)|.
    fn distance(&self, table: usize, phase: &Phase, given: f64, turns: f64) -> f64 {
        let node = &self.tables[table][phase.index];
        let rest = node[2..].iter().rev().fold(0.0, |sum, coefficient| (sum + coefficient) * phase.offset);
        // 2π in two words times an integer of up to 53 bits, exactly but for the last product.
        let high = turns * std::f64::consts::TAU;
        let low = if turns == 0.0 {
            0.0
        } else {
            turns.mul_add(std::f64::consts::TAU, -high) + turns * 2.449_293_598_294_706_4e-16
        };
        (((given - high) - node[0]) - (node[1] + low + rest)).abs()
    }

    /// The same in multiple precision from the beginning, without tables or integer clock.
    pub fn direct(&self, t: f64, given: [f64; 2]) -> f64 {
        let [periods, phase] = self.motion.phase(t);
        let [exact, second] = values(&self.motion, self.output, &self.motion.at_phase(&phase));
        let distance = |given: f64, exact: &Big| (&Big::from(given) - exact).to_f64();
        let turn = &Big::pi() * &2.0.into();
        let error = match self.output {
            Output::Position => distance(given[0], &exact).hypot(distance(given[1], &second)),
            Output::Theta if matches!(self.motion.regime, Regime::Rotation(_)) => {
                let turned = &(&periods * &self.motion.sign.into()) * &turn;
                distance(given[0], &(&exact + &turned)).abs()
            }
            Output::Wrapped => {
                let turns = &(&Big::from(given[0]) - &exact) / &turn;
                (&turns.less_turns() * &turn).to_f64().abs()
            }
            _ => distance(given[0], &exact).abs(),
        };
        error / self.unit
    }
}

/// The output at a state of the motion.
fn values(motion: &Motion, output: Output, state: &State) -> [Big; 2] {
    let (sign, omega) = (Big::from(motion.sign), &motion.start.omega);
    let zero = Big::from(0.0);
    match output {
        Output::Theta | Output::Wrapped => [&state.theta * &sign, zero],
        Output::Velocity => [&(&state.slope / &motion.period()) * &sign, zero],
        Output::Acceleration => [-&(&state.theta.sin() * &(&sign * &(omega * omega))), zero],
        Output::Position => [&state.theta.sin() * &sign, -&state.theta.cos()],
    }
}

/// Taylor polynomials of the output's coordinates about `phase`, in intervals of 1/`per_unit` of the phase.
fn nodes(motion: &Motion, output: Output, phase: &Big, per_unit: u32) -> Vec<Node> {
    let state = motion.at_phase(phase);
    // In units of ωt: θ″ = −sin θ, with the series of sin θ and cos θ carried along.
    let per_radian = &motion.period() * &motion.start.omega;
    let speed = &state.slope / &per_radian;
    let (mut theta, mut sine, mut cosine) =
        (vec![state.theta.clone(), speed], vec![state.theta.sin()], vec![state.theta.cos()]);
    for j in 0..=DEGREE {
        let next = |other: &[Big]| {
            // (j + 1)·sⱼ₊₁ = Σ (i + 1)·θᵢ₊₁·cⱼ₋ᵢ
            let sum = (0..=j).fold(Big::from(0.0), |sum, i| {
                let product = &theta[i + 1] * &other[j - i];
                &sum + &(&product * &Big::from((i + 1) as f64))
            });
            &sum / &Big::from((j + 1) as f64)
        };
        let (s, c) = (next(&cosine), -&next(&sine));
        let acceleration = &sine[j] / &Big::from(((j + 1) * (j + 2)) as f64);
        theta.push(-&acceleration);
        sine.push(s);
        cosine.push(c);
    }
    let step = &per_radian / &Big::from(f64::from(per_unit));
    let (sign, omega) = (Big::from(motion.sign), &motion.start.omega);
    let (fast, faster) = (&sign * omega, &sign * &(omega * omega));
    let node = |coefficient: &dyn Fn(usize) -> Big| {
        let mut node = [0.0; DEGREE + 2];
        let mut power = Big::from(1.0);
        [node[0], node[1]] = coefficient(0).to_pair();
        for (j, cell) in node[2..].iter_mut().enumerate() {
            power = &power * &step;
            *cell = (&coefficient(j + 1) * &power).to_f64();
        }
        node
    };
    match output {
        Output::Theta | Output::Wrapped => vec![node(&|j| &theta[j] * &sign)],
        Output::Velocity => vec![node(&|j| &(&theta[j + 1] * &Big::from((j + 1) as f64)) * &fast)],
        Output::Acceleration => vec![node(&|j| -&(&sine[j] * &faster))],
        Output::Position => vec![node(&|j| &sine[j] * &sign), node(&|j| -&cosine[j])],
    }
}

#[cfg(test)]
mod tests {
    use super::{Output, Truth};
    use crate::motion::{Motion, Start};
    use crate::reference::{Exact, Row, releases_and_launches};

    /// Reference data has θ and θ̇ as a number and a rest of four digits, 2⁻⁶⁶ of it or so.
    const TOLERANCE: f64 = 1e-19;

    /// Whether the reference is as far from its own nearest number by our reckoning as by its own.
    fn check(row: &Row, Exact { nearest, rest }: Exact, slack: f64, error: impl Fn(f64, [f64; 2]) -> f64) {
        let error = error(row.t, [nearest, 0.0]);
        let unit = nearest.abs().max(1.0);
        assert!((error - rest.abs()).abs() < slack * unit, "{row:?}: {error:e}");
    }

    /// The motion of a row, if that is within 2⁵³ periods: its extremes of t are beyond any promise.
    fn promised(row: &Row) -> Option<Motion> {
        let Row { theta0, velocity0, omega, t, .. } = *row;
        let motion = Motion::new(Start { theta0: theta0.into(), velocity0: velocity0.into(), omega: omega.into() });
        (t.abs() <= 9e15 * motion.period().to_f64()).then_some(motion)
    }

    /// Some of all swings and rotations.
    #[test]
    fn multiple_precision_agrees_with_reference_data() {
        let mut count = 0;
        for row in releases_and_launches().step_by(23) {
            let Some(motion) = promised(&row) else { continue };
            let [theta, velocity] =
                [Output::Theta, Output::Velocity].map(|output| Truth::without_tables(motion.clone(), output));
            check(&row, row.theta, TOLERANCE, |t, given| theta.direct(t, given));
            check(&row, row.velocity, TOLERANCE, |t, given| velocity.direct(t, given));
            count += 1;
        }
        assert!(count > 90, "{count}");
    }

    /// Of 2.1 at the bottom, a rotation of which turns are counted. The table's own error is up to 2⁻⁵⁸ = 3.5e-18.
    #[test]
    fn tables_agree_with_reference_data() {
        let mut tables: Option<[Truth; 2]> = None;
        let mut count = 0;
        for row in releases_and_launches().filter(|row| row.velocity0 == 2.1) {
            let Some(motion) = promised(&row) else { continue };
            let new = || [Output::Theta, Output::Velocity].map(|output| Truth::new(motion.clone(), output));
            let [theta, velocity] = tables.get_or_insert_with(new);
            check(&row, row.theta, TOLERANCE + 4e-18, |t, given| theta.error(t, given));
            check(&row, row.velocity, TOLERANCE + 4e-18, |t, given| velocity.error(t, given));
            count += 1;
        }
        assert!(count > 40, "{count}");
    }
}
