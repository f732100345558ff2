//! Which of several ways that keep a promise is taken, at full precision with room.

use crate::plan::observed::{FOR_A_MOMENT, observed};
use crate::plan::reduction::Reduction;
use crate::scene::Goal;

/// The part of 2⁻⁴⁹ (2⁻²⁰), half of which is promised to be the most that is observed, that had better be the most that
/// is expected to be: who asks for full precision wants that promise kept, rather than the last twentieth of the cost.
pub(super) const COMFORTABLE: f64 = 0.475;
/// The part that still keeps it, where more room costs more than that twentieth.
pub(super) const TOLERABLE: f64 = 0.49;
/// How much more what is comfortable may cost than what is tolerable.
pub(super) const DEARER: f64 = 1.05;

/// The best that has been found, of ways in the order of what they are estimated to cost.
pub(super) struct Choice<T> {
    best: Option<Best<T>>,
}

struct Best<T> {
    room: Room,
    /// The share of its limit that it takes.
    share: f64,
    cost: f64,
    way: T,
}

/// What is left of a limit.
#[derive(Clone, Copy, PartialEq)]
enum Room {
    Comfortable,
    Tolerable,
    Little,
}

impl Room {
    /// How much more it may cost.
    fn worth(self) -> f64 {
        if self == Self::Comfortable { DEARER } else { 1.0 }
    }
}

/// Parts of its limits.
#[derive(Clone, Copy)]
pub(super) struct Limits {
    /// What a plan had better keep.
    pub(super) comfortable: f64,
    /// What it does not exceed if there is another.
    pub(super) tolerable: f64,
}

impl Limits {
    pub(super) fn of(goal: Goal, reduction: &Reduction) -> Self {
        let [comfortable, tolerable] = match goal {
            Goal::Full if reduction.is_time() => [TOLERABLE / FOR_A_MOMENT; 2],
            Goal::Full => [COMFORTABLE, TOLERABLE].map(|expected| expected / observed(reduction.float)),
            _ => [1.0; 2],
        };
        Self { comfortable, tolerable }
    }
}

impl<T> Choice<T> {
    pub(super) fn new() -> Self {
        Self { best: None }
    }

    /// The cost from which on nothing would be taken.
    pub(super) fn dear(&self) -> f64 {
        self.best.as_ref().map_or(f64::INFINITY, |best| match best.room {
            Room::Comfortable => best.cost,
            Room::Tolerable => (DEARER * best.cost).next_up(),
            Room::Little => f64::INFINITY,
        })
    }

    /// Whether there is one that is at least tolerable.
    pub(super) fn has_room(&self) -> bool {
        self.best.as_ref().is_some_and(|best| best.room != Room::Little)
    }

    /// The share of its limit that one of that cost may have to be taken: with more it may as well not be looked at.
    pub(super) fn most(&self, Limits { comfortable, tolerable }: Limits, cost: f64) -> f64 {
        match &self.best {
            None => f64::INFINITY,
            Some(best) if best.room == Room::Little => best.share,
            Some(best) if cost * best.room.worth() < best.cost => tolerable,
            Some(_) => comfortable,
        }
    }

    /// The cheapest that is comfortable, unless the cheapest that is tolerable costs less by a twentieth; where none is,
    /// that with the most room.
    pub(super) fn offer(&mut self, limits: Limits, cost: f64, share: f64, way: T) {
        let room = if share <= limits.comfortable {
            Room::Comfortable
        } else if share <= limits.tolerable {
            Room::Tolerable
        } else {
            Room::Little
        };
        let better = self.best.as_ref().is_none_or(|best| match (room, best.room) {
            (Room::Little, Room::Little) => share < best.share,
            (Room::Little, _) => false,
            (_, Room::Little) => true,
            _ => cost * best.room.worth() < best.cost * room.worth(),
        });
        if better {
            self.best = Some(Best { room, share, cost, way });
        }
    }

    pub(super) fn made(self) -> Option<T> {
        self.best.map(|best| best.way)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::search::{Prospect, tasks};
    use crate::testing::scene;

    /// Of ways that are estimated to cost so much, cost so much, and take so much of their limit, in this order.
    #[test]
    fn choices() {
        let chosen = |goal: &str, found: &[(f64, f64, f64)]| {
            let scene = scene(&format!("struct Motion; theta0 = 2{goal}"));
            let prospect = Prospect::new(&scene, tasks(&scene).remove(0));
            let limits = Limits::of(scene.goal, &prospect.reductions[0]);
            let mut choice = Choice::new();
            for (index, &(estimate, cost, share)) in found.iter().enumerate() {
                if estimate >= choice.dear() {
                    break;
                }
                if share <= choice.most(limits, estimate) {
                    choice.offer(limits, cost, share, index);
                }
            }
            choice.made()
        };
        let as_estimated = |found: &[(f64, f64)]| -> Vec<_> { found.iter().map(|&(c, share)| (c, c, share)).collect() };
        let full = |found: &[(f64, f64)]| chosen("", &as_estimated(found));
        assert_eq!(full(&[]), None);
        assert_eq!(full(&[(10.0, 0.58), (10.0, 0.1)]), Some(0));
        assert_eq!(full(&[(10.0, 0.9), (11.0, 0.62), (11.5, 0.58), (11.5, 0.1)]), Some(2));
        assert_eq!(full(&[(10.0, 0.61), (10.5, 0.60), (10.51, 0.1)]), Some(0));
        assert_eq!(full(&[(10.0, 0.9), (20.0, 0.8), (30.0, 0.85)]), Some(1));
        assert_eq!(full(&[(10.0, 0.9), (20.0, 0.8), (30.0, 0.62), (40.0, 0.5)]), Some(2));
        // What costs more than was estimated may cost more than the next.
        let dearer = |found: &[(f64, f64, f64)]| chosen("", found);
        assert_eq!(dearer(&[(10.0, 20.0, 0.58), (15.0, 15.0, 0.58), (15.0, 14.0, 0.1)]), Some(1));
        assert_eq!(dearer(&[(10.0, 20.0, 0.58), (15.0, 20.0, 0.58), (20.0, 1.0, 0.1)]), Some(0));
        assert_eq!(dearer(&[(10.0, 20.0, 0.58), (19.0, 19.0, 0.62), (19.1, 19.1, 0.62)]), Some(1));
        assert_eq!(dearer(&[(10.0, 20.0, 0.58), (19.1, 19.1, 0.62), (19.9, 19.9, 0.58)]), Some(2));
        assert_eq!(dearer(&[(10.0, 20.0, 0.61), (15.0, 15.0, 0.9), (16.0, 19.0, 0.62)]), Some(2));
        assert_eq!(chosen(", tol = 1e-6", &[(10.0, 10.0, 1.0), (10.0, 10.0, 0.1)]), Some(0));
        // Over so short a horizon the phase is the time.
        assert_eq!(chosen(", t_max = 0.1", &[(10.0, 10.0, 0.6), (20.0, 20.0, 0.5)]), Some(1));
    }
}
