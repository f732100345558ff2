//! The derivative of the paper's θ̂, dθ̂/dt, as one polynomial in each piece of half a period: the derivative of an
//! interpolant of θ̂ of more points, so that even differentiated it is wrong by next to nothing ([`super::residual`]).

use super::angle_in_pieces::{Piece, first_that_serves, interpolants};
use super::residual::{LEAST_POINTS_OF_SLOPE, OF_RESIDUAL, of_residual_slope};
use crate::chebyshev::{OF_INTERPOLATION, derivative, rounding_of_derivative};
use crate::plan::cosines::Cosines;
use crate::plan::pieces::{Piecewise, half};
use crate::power::power;
use crate::program::rounding::INFLATION;
use crate::series::{Parity, Wave};
use crate::supremum::worst;
use pendulum_runtime::double::Double;

/// Points of interpolation in each piece.
const POINTS: usize = 24;

/// More points than this for a residual take too long.
const MOST_POINTS: usize = 52;

/// More harmonics than this, next to the top, take too long, and hardly ever as few pieces as are tried.
pub(super) const MOST_OF_SLOPE: usize = 24;

/// For these weights of harmonics of a phase that grows at that rate, in so many pieces at least, wrong by much less than
/// `limit`; `None` if it bends too much.
pub(super) fn approximation(weights: &[Double], rate: Double, limit: f64, least: usize) -> Option<Piecewise> {
    let (size, sum) = (Cosines::odd(weights).magnitude(0), Wave::harmonics(weights));
    let limit = limit.min(size * rate.hi);
    first_that_serves(&sum, size, least, |pieces| in_pieces(&sum, pieces, rate, limit))
}

fn in_pieces(sum: &Wave, pieces: usize, rate: Double, limit: f64) -> Option<Piecewise> {
    // From derivatives by the place in a piece to those by time.
    let factor = rate / half(pieces);
    let negligible = limit / factor.hi * OF_INTERPOLATION;
    let slope = |piece: &Piece<'_>, own: &[Double]| {
        // So that n³ times as much is still a part of what is negligible.
        let little = negligible * OF_RESIDUAL / power(MOST_POINTS as f64, 3);
        let interpolation = piece.interpolation(own, little, LEAST_POINTS_OF_SLOPE, MOST_POINTS)?;
        Some(piece.residual(own, interpolation) * power(interpolation.points as f64, 3))
    };
    let (angles, slope) = interpolants(sum, pieces, POINTS, slope)?;
    let rounding = worst(angles.iter().map(|own| rounding_of_derivative(own)));
    let error = (of_residual_slope(sum, half(pieces), slope)? + rounding) * INFLATION;
    let by_time = |own: &Vec<Double>| derivative(own).into_iter().map(|c| c * factor).collect();
    let series = angles.iter().map(by_time).collect();
    (error <= negligible).then(|| Piecewise::known(series, error * factor.hi * INFLATION, Parity::Odd))
}

#[cfg(test)]
mod tests {
    use super::super::tests::weights;
    use super::*;

    use crate::parse::Float;
    use crate::plan::reduction::Reduction;
    use crate::testing::{scene, swing};

    /// The numbers of pieces and of terms for an error of 2⁻⁵² where θ̂ itself takes a term less; nearer to an overshoot there
    /// are no pieces.
    #[test]
    fn pieces_and_terms() {
        let time = Reduction::time(1.0, false, Float::F64).unwrap();
        let found = |theta0: &str, terms: usize| {
            let scene = scene(&format!("theta0 = {theta0}"));
            let swing = swing(&scene);
            let piecewise = approximation(&weights(swing, terms), swing.rate().to_double(), 1e-16, 0)?;
            Some((piecewise.pieces(), piecewise.terms_for(2e-16, &time)?))
        };
        assert_eq!(found("1", 1), Some((32, 9)));
        assert_eq!(found("7π/8", 4), Some((32, 13)));
        assert_eq!(found("0.93π", 4), Some((64, 13)));
        assert_eq!(found("0.95π", 4), None);
    }

    /// A series that is wrong by ε in one term is seen to be, by more than that and by less than n³ times as much.
    #[test]
    fn errors_are_seen() {
        let sum = Wave::harmonics(&[Double::new(0.5)]);
        let bound = |epsilon: f64| {
            let slope = |piece: &Piece<'_>, own: &[Double]| {
                let mut own = own.to_vec();
                own[2] = own[2] + Double::new(epsilon);
                let interpolation = piece.interpolation(&own, 1e-28, LEAST_POINTS_OF_SLOPE, MOST_POINTS)?;
                Some(piece.residual(&own, interpolation) * power(interpolation.points as f64, 3))
            };
            let (_, slope) = interpolants(&sum, 32, POINTS, slope).unwrap();
            of_residual_slope(&sum, half(32), slope).unwrap()
        };
        // T₂′ is 4 at most.
        assert!(bound(0.0) < 1e-22 && bound(1e-9) >= 4e-9 && bound(1e-9) < 1e-3, "{:e} {:e}", bound(0.0), bound(1e-9));
    }
}
