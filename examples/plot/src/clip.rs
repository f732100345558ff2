//! Cutting a curve at the edges of a panel.

use std::ops::RangeInclusive;

/// The pieces of the line through `points` that lie within the window, cut at its edges (Liang and Barsky 1984); points
/// that are not finite break the line.
pub(crate) fn clip(points: &[(f64, f64)], x: &RangeInclusive<f64>, y: &RangeInclusive<f64>) -> Vec<Vec<(f64, f64)>> {
    let mut pieces: Vec<Vec<(f64, f64)>> = Vec::new();
    for pair in points.windows(2) {
        let Some((start, end)) = segment(pair[0], pair[1], x, y) else { continue };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&start) => piece.push(end),
            _ => pieces.push(vec![start, end]),
        }
    }
    pieces
}

type Segment = ((f64, f64), (f64, f64));

/// The part of one segment within the window.
fn segment(a: (f64, f64), b: (f64, f64), x: &RangeInclusive<f64>, y: &RangeInclusive<f64>) -> Option<Segment> {
    if ![a.0, a.1, b.0, b.1].into_iter().all(f64::is_finite) {
        return None;
    }
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let edges = [(-dx, a.0 - x.start()), (dx, x.end() - a.0), (-dy, a.1 - y.start()), (dy, y.end() - a.1)];
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (towards, distance) in edges {
        if towards == 0.0 {
            if distance < 0.0 {
                return None;
            }
        } else if towards < 0.0 {
            enter = enter.max(distance / towards);
        } else {
            leave = leave.min(distance / towards);
        }
    }
    // At the ends themselves the given points, to the bit, so that adjoining segments join.
    let at = |s: f64, end: (f64, f64)| if s == 0.0 || s == 1.0 { end } else { (a.0 + s * dx, a.1 + s * dy) };
    (enter < leave).then(|| (at(enter, a), at(leave, b)))
}

#[cfg(test)]
mod tests {
    use super::clip;

    #[test]
    fn a_peak_above_the_window_leaves_two_pieces() {
        let pieces = clip(&[(0.0, 0.0), (1.0, 2.0), (2.0, 0.0)], &(0.0..=2.0), &(-1.0..=1.0));
        assert_eq!(pieces, [vec![(0.0, 0.0), (0.5, 1.0)], vec![(1.5, 1.0), (2.0, 0.0)]]);
    }

    #[test]
    fn a_curve_inside_stays_whole_and_nan_breaks_it() {
        let points = [(0.0, 0.0), (1.0, 0.5), (2.0, 0.0), (3.0, f64::NAN), (4.0, 0.0), (5.0, 0.1)];
        let pieces = clip(&points, &(0.0..=5.0), &(-1.0..=1.0));
        assert_eq!(pieces, [points[..3].to_vec(), points[4..].to_vec()]);
    }
}
