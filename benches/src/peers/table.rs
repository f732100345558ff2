//! A table of one period with cubic Hermite interpolation.

use pendula_stress::motion::State;

use super::Motion;
use crate::contestant::{Contestant, Family};
use crate::real::Real;

/// Tables of 256 and of 4096 points, filled with the exact values.
pub(super) fn contestants<R: Real>(motion: &Motion) -> Vec<Contestant<R>> {
    vec![table::<R, 256>(motion), table::<R, 4096>(motion)]
}

/// A cubic in the place within an interval, 0 to 1.
#[derive(Clone, Copy)]
struct Interval<R> {
    value: R,
    slope: R,
    square: R,
    cubic: R,
}

/// The coefficients of the cubic with these values and slopes at 0 and 1.
fn hermite<R: Real>((value, slope): (R, R), (end, end_slope): (R, R)) -> Interval<R> {
    let rise = end - value;
    let cubic = slope + end_slope - rise - rise;
    Interval { value, slope, square: rise - slope - cubic, cubic }
}

/// `POINTS`, a power of two, of them over one period. Written for speed: the four coefficients of each interval are
/// stored ready, the index cannot be out of bounds, and there is no branch and no conversion that would keep the loop
/// scalar.
fn table<R: Real, const POINTS: usize>(motion: &Motion) -> Contestant<R> {
    let node = |index: usize| {
        let State { theta, slope } = motion.exact.at_phase(&(index as f64 / POINTS as f64).into());
        (R::of(theta.to_f64()), R::of(slope.to_f64() / POINTS as f64))
    };
    let nodes: Vec<(R, R)> = (0..POINTS).map(node).collect();
    let intervals: Vec<Interval<R>> =
        (0..POINTS).map(|index| hermite(nodes[index], nodes[(index + 1) % POINTS])).collect();
    let Ok(intervals) = <Box<[Interval<R>; POINTS]>>::try_from(intervals.into_boxed_slice()) else {
        unreachable!("as many as there are points")
    };
    let (frequency, points, half) = (R::of(1.0 / motion.period), R::of(POINTS as f64), R::of(0.5));
    Contestant::function(Family::Table, "table, cubic Hermite", &format!("{POINTS} points"), move |t: R| {
        let turns = t * frequency;
        let place = (turns - turns.nearest().0) * points;
        // The interval's left end; at an end either of the two intervals serves.
        let (whole, bits) = (place - half).nearest();
        let s = place - whole;
        let Interval { value, slope, square, cubic } = intervals[bits % POINTS];
        value + s * (slope + s * (square + s * cubic))
    })
}
