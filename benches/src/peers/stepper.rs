//! Time stepping at fixed steps.

use super::Motion;
use crate::contestant::{Contestant, State, Stepping};
use crate::real::Real;

/// Semi-implicit Euler, leapfrog and RK4 at T/100 and T/1000.
pub(super) fn contestants<R: Real>(motion: &Motion) -> Vec<Contestant<R>> {
    let mut all = Vec::new();
    for steps in [100, 1000] {
        let setting = format!("T/{steps}");
        let interval = motion.period / f64::from(steps);
        all.push(Contestant::stepping("semi-implicit Euler", &setting, Stepper::new(motion, interval, euler)));
        all.push(Contestant::stepping("leapfrog", &setting, Stepper::new(motion, interval, leapfrog)));
        all.push(Contestant::stepping("RK4", &setting, Stepper::new(motion, interval, rk4)));
    }
    all
}

/// A one-step method with its step, and the state at the release.
struct Stepper<R, F> {
    start: State<R>,
    interval: f64,
    step: R,
    method: F,
}

impl<R: Real, F: Fn(State<R>, R) -> State<R>> Stepper<R, F> {
    fn new(motion: &Motion, interval: f64, method: F) -> Self {
        let start = State { angle: R::of(motion.theta0), velocity: R::zero() };
        let step = R::of(interval);
        // Its times are multiples of the step that it really takes.
        Self { start, interval: step.wide(), step, method }
    }
}

impl<R: Real, F: Fn(State<R>, R) -> State<R>> Stepping<R> for Stepper<R, F> {
    fn interval(&self) -> f64 {
        self.interval
    }

    #[inline(never)]
    fn follow(&self, angles: &mut [R]) {
        let mut state = self.start;
        for angle in angles {
            state = (self.method)(state, self.step);
            *angle = state.angle;
        }
    }

    #[inline(never)]
    fn advance(&self, ensemble: &mut [State<R>]) -> bool {
        for state in ensemble {
            *state = (self.method)(*state, self.step);
        }
        true
    }
}

/// First the velocity, then the angle with the new velocity (Euler and Cromer).
fn euler<R: Real>(State { angle, velocity }: State<R>, step: R) -> State<R> {
    let velocity = velocity - step * angle.sin();
    State { angle: angle + step * velocity, velocity }
}

/// Half a step of the angle, a step of the velocity, half a step of the angle: one sine per step.
fn leapfrog<R: Real>(State { angle, velocity }: State<R>, step: R) -> State<R> {
    let half = R::of(0.5) * step;
    let middle = angle + half * velocity;
    let velocity = velocity - step * middle.sin();
    State { angle: middle + half * velocity, velocity }
}

/// The classical Runge-Kutta method of fourth order.
fn rk4<R: Real>(start: State<R>, step: R) -> State<R> {
    let (half, sixth, two) = (R::of(0.5) * step, step / R::of(6.0), R::of(2.0));
    let rate = |state: State<R>| State { angle: state.velocity, velocity: -state.angle.sin() };
    let ahead = |rate: State<R>, by: R| State {
        angle: start.angle + by * rate.angle,
        velocity: start.velocity + by * rate.velocity,
    };
    let first = rate(start);
    let second = rate(ahead(first, half));
    let third = rate(ahead(second, half));
    let fourth = rate(ahead(third, step));
    State {
        angle: start.angle + sixth * (first.angle + two * (second.angle + third.angle) + fourth.angle),
        velocity: start.velocity
            + sixth * (first.velocity + two * (second.velocity + third.velocity) + fourth.velocity),
    }
}
