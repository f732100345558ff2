//! What an error of a series counts.

use super::interval::p;
use super::leeway::Leeway;
use super::pole::Pole;
use crate::series::Parity;

/// Over poles it counts the more the nearer they are, of an odd curve as many times as the phase is long; where a curve is
/// flat less.
#[derive(Clone, Copy)]
pub(super) struct Weight<'a> {
    pub(super) pole: Option<Pole>,
    pub(super) parity: Parity,
    pub(super) leeway: Option<&'a Leeway>,
}

impl Weight<'_> {
    /// At u = 8p − 1.
    pub(super) fn at(self, u: f64) -> f64 {
        self.between(p(u), p(u)) / self.leeway.map_or(1.0, |leeway| leeway.at(u))
    }

    /// The most between two squares of phases, without what a leeway spares.
    pub(super) fn between(self, low: f64, high: f64) -> f64 {
        let phase = if self.parity == Parity::Odd { high.sqrt() } else { 1.0 };
        phase / self.pole.map_or(1.0, |pole| pole.least_between(low, high))
    }
}
