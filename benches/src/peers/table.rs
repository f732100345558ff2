//! A table of one period with cubic Hermite interpolation.

use super::Motion;
use crate::contestant::{Contestant, Family};
use crate::real::Real;

/// Tables of 256 and of 4096 points, filled with the exact values.
pub(super) fn contestants<R: Real>(motion: &mut Motion) -> Vec<Contestant<R>> {
    [256, 4096].map(|points| table(motion, points)).into()
}

/// θ at a node, and θ̇ times the distance of the nodes.
#[derive(Clone, Copy)]
struct Node<R> {
    value: R,
    slope: R,
}

fn table<R: Real>(motion: &mut Motion, points: usize) -> Contestant<R> {
    let step = motion.period / points as f64;
    // One node more than points, so that the last interval has its end.
    let node = |index: usize| {
        let t = step * index as f64;
        Node { value: R::of(motion.truth.theta(t).high), slope: R::of(motion.truth.velocity(t).high * step) }
    };
    let nodes: Vec<Node<R>> = (0..=points).map(node).collect();
    let per_step = R::of(1.0 / step);
    // A power of two, so that a mask takes off whole periods.
    let mask = points - 1;
    Contestant::function(Family::Table, "table, cubic Hermite", &format!("{points} points"), move |t: R| {
        // Times are positive here, so the conversion rounds down; it is cheaper than `floor` without SSE 4.1.
        let place = t * per_step;
        let whole = place.whole();
        let s = place - R::of(whole as f64);
        let index = whole as usize & mask;
        let (left, right) = (nodes[index], nodes[index + 1]);
        let rise = right.value - left.value;
        let cubic = left.slope + right.slope - rise - rise;
        let square = rise - left.slope - cubic;
        left.value + s * (left.slope + s * (square + s * cubic))
    })
}
