//! What is compared: anything that gives the angle of a pendulum released at rest with ω = 1.

use std::cell::RefCell;
use std::hint::black_box;

use crate::real::Real;
use crate::truth::Given;

/// Times of an array loop, and states of an ensemble.
pub const COUNT: usize = 4096;

/// An array at the start of a cache line, so that vector loads do not depend on where the allocator puts it.
#[repr(align(64))]
pub struct Block<T>(pub [T; COUNT]);

/// The times lie between 0 and this many periods; so far reach the plans with a horizon.
pub const HORIZON: f64 = 100.0;
/// The error of a stepper is the largest over this many periods from the release.
pub const STEPPED: f64 = 10.0;

/// Who made it, which decides colour and side in the pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Family {
    /// `sin` itself, the unit of cost.
    Yardstick,
    /// The macro's own choice.
    Planned,
    /// The macro with a method forced.
    Forced,
    /// Our run-time crate.
    Runtime,
    /// The formula of the paper as it is written there.
    Paper,
    /// A library of special functions.
    Library,
    /// A table with interpolation.
    Table,
    /// Time stepping.
    Stepper,
}

impl Family {
    /// Whether it is part of this project.
    pub fn ours(self) -> bool {
        matches!(self, Self::Planned | Self::Forced | Self::Runtime)
    }

    /// Whether it stands on the other side: neither ours nor the yardstick.
    pub fn peer(self) -> bool {
        matches!(self, Self::Paper | Self::Library | Self::Table | Self::Stepper)
    }

    /// As it is written in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Yardstick => "yardstick",
            Self::Planned => "pendula, planned",
            Self::Forced => "pendula, method forced",
            Self::Runtime => "pendula, run time",
            Self::Paper => "paper as written",
            Self::Library => "library",
            Self::Table => "table",
            Self::Stepper => "stepper",
        }
    }
}

/// A function of time that can be asked for any t.
pub trait AnyTime<R> {
    /// The angles at `times`, independent of each other.
    fn fill(&self, times: &[R], angles: &mut [R]);

    /// One call after the other, none waiting for another and none combined with another.
    fn scalar(&self, times: &[R]);

    /// One call after the other, each waiting for the result before.
    fn chain(&self, times: &[R]) -> R;
}

/// Any function is one; the loops are compiled for each, so that what can be inlined is. The two loops have a copy of
/// the function each, so that neither is inlined at the expense of the other: only what is inlined vectorises.
#[derive(Clone, Copy, Debug)]
pub struct Function<F, G> {
    /// For the array loop.
    pub array: F,
    /// For single calls.
    pub single: G,
}

impl<R: Real, F: Fn(R) -> R, G: Fn(R) -> R> AnyTime<R> for Function<F, G> {
    #[inline(never)]
    fn fill(&self, times: &[R], angles: &mut [R]) {
        for (angle, &time) in angles.iter_mut().zip(times) {
            *angle = (self.array)(time);
        }
    }

    #[inline(never)]
    fn scalar(&self, times: &[R]) {
        each(times, &self.single);
    }

    #[inline(never)]
    fn chain(&self, times: &[R]) -> R {
        let nothing = black_box(0);
        times.iter().fold(R::zero(), |last, &time| (self.single)(time.after(last, nothing)))
    }
}

/// Calls it at each time, whatever it returns.
#[inline]
fn each<R: Real, T>(times: &[R], function: impl Fn(R) -> T) {
    for &time in times {
        black_box(function(time));
    }
}

/// A function of time with two values, both of which are stored, and waited for.
pub struct Pair<R, F, G> {
    array: F,
    single: G,
    /// Where the array loop leaves the second values.
    second: RefCell<Vec<R>>,
}

impl<R: Real, F: Fn(R) -> (R, R), G: Fn(R) -> (R, R)> Pair<R, F, G> {
    /// Of two copies of a function that gives the angle first; see [`Function`].
    pub fn new((array, single): (F, G)) -> Self {
        Self { array, single, second: RefCell::new(vec![R::zero(); COUNT]) }
    }

    #[inline(never)]
    fn fill_both(&self, times: &[R], angles: &mut [R], second: &mut [R]) {
        for ((angle, second), &time) in angles.iter_mut().zip(second).zip(times) {
            (*angle, *second) = (self.array)(time);
        }
    }
}

impl<R: Real, F: Fn(R) -> (R, R), G: Fn(R) -> (R, R)> AnyTime<R> for Pair<R, F, G> {
    fn fill(&self, times: &[R], angles: &mut [R]) {
        let mut second = self.second.borrow_mut();
        second.resize(times.len(), R::zero());
        self.fill_both(times, angles, &mut second);
        black_box(&second);
    }

    #[inline(never)]
    fn scalar(&self, times: &[R]) {
        each(times, &self.single);
    }

    #[inline(never)]
    fn chain(&self, times: &[R]) -> R {
        let nothing = black_box(0);
        let call = |(a, b), &time: &R| (self.single)(time.after(a, nothing).after(b, nothing));
        times.iter().fold((R::zero(), R::zero()), call).0
    }
}

/// A state: angle and angular velocity.
#[derive(Clone, Copy, Debug)]
pub struct State<R> {
    /// θ in rad.
    pub angle: R,
    /// θ̇ with ω = 1.
    pub velocity: R,
}

/// A method that goes from one sample to the next.
pub trait Stepping<R> {
    /// The time between samples.
    fn interval(&self) -> f64;

    /// The angles at `interval`, `2·interval`, … from the release.
    fn follow(&self, angles: &mut [R]);

    /// One step of every pendulum of an ensemble, `false` if the method only follows one.
    fn advance(&self, ensemble: &mut [State<R>]) -> bool;
}

/// The two kinds.
pub enum Kind<R> {
    /// Gives θ(t) for any t.
    AnyTime(Box<dyn AnyTime<R>>),
    /// Gives θ at equal intervals, in order.
    Stepping(Box<dyn Stepping<R>>),
}

/// How an entry is called in tables.
pub fn label(name: &str, setting: &str) -> String {
    if setting.is_empty() { name.to_owned() } else { format!("{name}, {setting}") }
}

/// One entry.
pub struct Contestant<R> {
    /// Who made it.
    pub family: Family,
    /// What it is.
    pub name: String,
    /// Its settings: terms, tolerance, step.
    pub setting: String,
    /// The amplitude that it was given.
    pub given: Given,
    /// How it is called.
    pub kind: Kind<R>,
}

impl<R: Real> Contestant<R> {
    /// One that was given the amplitude in this precision.
    pub fn new(family: Family, name: &str, setting: &str, kind: Kind<R>) -> Self {
        Self { family, name: name.into(), setting: setting.into(), given: R::GIVEN, kind }
    }

    /// A function of time.
    pub fn function(family: Family, name: &str, setting: &str, function: impl Fn(R) -> R + Clone + 'static) -> Self {
        Self::copies(family, name, setting, (function.clone(), function))
    }

    /// The same of two copies of the function; see [`Function`].
    pub fn copies(
        family: Family,
        name: &str,
        setting: &str,
        (array, single): (impl Fn(R) -> R + 'static, impl Fn(R) -> R + 'static),
    ) -> Self {
        Self::new(family, name, setting, Kind::AnyTime(Box::new(Function { array, single })))
    }

    /// A method that steps.
    pub fn stepping(name: &str, setting: &str, method: impl Stepping<R> + 'static) -> Self {
        Self::new(Family::Stepper, name, setting, Kind::Stepping(Box::new(method)))
    }

    /// The same, compared with the motion of another amplitude.
    #[must_use]
    pub fn given(self, given: Given) -> Self {
        Self { given, ..self }
    }

    /// See [`label`].
    pub fn label(&self) -> String {
        label(&self.name, &self.setting)
    }
}
