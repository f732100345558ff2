//! The paper's θ̂ = 2 arcsin y, y = Σ wₙ cos((2n−1)πs), piece by piece.
//!
//! θ̂ is analytic but where y = ±1, which at 7π/8 with N = 4 it is nowhere within 0.125i of the real axis: as far as
//! eight times half a 64th of a period. So a dozen terms about the middle of such a part leave less than rounding does,
//! where one polynomial for all phases needs 34 ([`super::whole`]).
//!
//! **Error.** As in [`super::whole`], each interpolant Q is tested afterwards. With x = c + hu the residual R = y(x) −
//! sin(Q(u)/2) is an entire function of u. On an ellipse of parameter ρ |y| is bounded by its coefficients, Im x being
//! at most h(ρ − 1/ρ)/2; and |sin(Q/2)| by the hyperbolic cosine of |Im Q/2|, to which the constant adds nothing. What
//! follows from sup |R| is the same as there.

use super::whole::{Point, bend, largest, twice_arcsine};
use crate::chebyshev::{CosineTable, Interpolation, lebesgue, scale, sin_pi, to_powers, value};
use crate::plan::pieces::Pieces;
use crate::plan::reduction::Reduction;
use crate::series::Wave;
use pendulum_runtime::double::Double;

/// The numbers of parts of half a period that are tried: tables of 6 and 12 kB.
const PARTS: [usize; 2] = [32, 64];

/// Points of interpolation in each.
const POINTS: usize = 16;

/// By how much of themselves parts are interpolated beyond their ends: more than any phase exceeds half of one by.
const MARGIN: f64 = 1.0 / 256.0;

/// More points than this for a residual take too long.
const MOST_POINTS: usize = 40;

/// θ̂ in pieces from a turning point to the lowest point.
pub(super) struct Piecewise {
    parts: usize,
    /// Chebyshev series in u = (s − centre)/half.
    series: Vec<Vec<Double>>,
    /// Of all of them, whole.
    error: f64,
}

impl Piecewise {
    /// θ̂ for these weights, the pieces' series wrong by much less than `limit`; `None` if it bends too much.
    pub(super) fn new(weights: &[Double], limit: f64) -> Option<Self> {
        let size: f64 = weights.iter().map(|w| w.hi.abs()).sum();
        let sum = Wave::harmonics(weights);
        // Second words of small coefficients underflow.
        let moderate = size > 1e-150;
        PARTS.into_iter().filter(|_| moderate).find_map(|parts| Self::in_parts(&sum, parts, limit.min(size) / 512.0))
    }

    fn in_parts(sum: &Wave, parts: usize, negligible: f64) -> Option<Self> {
        let (mut series, mut points, mut residual) = (Vec::new(), Vec::new(), 0.0_f64);
        let table = CosineTable::new(POINTS);
        for index in 0..=parts / 2 {
            let piece = Piece { centre: index as f64 / parts as f64, half: half(parts) };
            let phases: Vec<Double> = table.points().map(|u| piece.phase(u)).collect();
            let sines: Vec<Double> = phases.iter().map(|&s| sum.at(s)).collect();
            let values: Option<Vec<Double>> = sines.iter().map(|&y| twice_arcsine(y)).collect();
            let own = table.coefficients(&values?, POINTS);
            residual = residual.max(piece.residual(sum, &own, negligible)?);
            points.extend(phases.iter().zip(&sines).map(|(s, y)| Point { s: s.hi, y: y.hi.abs() }));
            series.push(own);
        }
        // From the lowest point on.
        points.sort_by(|a, b| b.s.total_cmp(&a.s));
        let most = largest(&points, bend(sum)) + residual;
        let error = 2.0 * residual / (1.0 - most * most).sqrt();
        (error <= negligible).then_some(Self { parts, series, error })
    }

    /// The error with the first `terms` coefficients of each piece.
    fn truncation(&self, terms: usize) -> f64 {
        let dropped = |own: &Vec<Double>| own[terms..].iter().map(|c| c.hi.abs()).sum();
        self.error + self.series.iter().map(dropped).fold(0.0, f64::max)
    }

    /// The kernel with as few terms as are wrong by at most `limit`, and its truncation; `None` for reductions that
    /// can't count parts.
    pub(super) fn kernel(&self, reduction: &Reduction, direction: f64, limit: f64) -> Option<(Pieces, f64)> {
        let reduction = reduction.in_parts(self.parts as f64)?;
        let within = reduction.half() * reduction.unit.hi <= half(self.parts) * (1.0 - MARGIN / 64.0);
        let terms = (2..=POINTS).find(|&terms| self.truncation(terms) <= limit).filter(|_| within)?;
        let unit = reduction.unit / Double::new(half(self.parts));
        let mut quarter: Vec<Vec<Double>> =
            self.series.iter().map(|own| scale(to_powers(&own[..terms]), unit)).collect();
        // About the turning point θ̂ is even, about the lowest point odd: what the other powers are is rounding, of two
        // words.
        let last = quarter.len() - 1;
        quarter[0].iter_mut().skip(1).step_by(2).for_each(|c| *c = Double::ZERO);
        quarter[last].iter_mut().step_by(2).for_each(|c| *c = Double::ZERO);
        Some((Pieces::of_swing(reduction, &quarter, direction), self.truncation(terms)))
    }
}

/// Half a part and its margin, in anchors.
fn half(parts: usize) -> f64 {
    0.5 / parts as f64 * (1.0 + MARGIN)
}

/// The phases c + hu.
struct Piece {
    centre: f64,
    half: f64,
}

impl Piece {
    fn phase(&self, u: Double) -> Double {
        u * self.half + Double::new(self.centre)
    }

    /// Bounds |y − sin(Q/2)| for the interpolant Q.
    fn residual(&self, sum: &Wave, series: &[Double], negligible: f64) -> Option<f64> {
        let ellipse = |rho: f64| (self.bound(sum, series, rho), rho);
        let ellipses = [3.0, 5.0, 8.0, 12.0, 20.0, 32.0].into_iter().map(ellipse);
        let Interpolation { points, error, .. } = Interpolation::fewest(ellipses, negligible * 1e-4, 2, MOST_POINTS)?;
        let at = |u: Double| {
            let residual = sum.at(self.phase(u)) - sin_pi(value(series, u) / (Double::PI * 2.0));
            residual.hi.abs()
        };
        Some(CosineTable::new(points).points().map(at).fold(0.0, f64::max) * lebesgue(points) + error)
    }

    /// The same on the ellipse with parameter ρ.
    fn bound(&self, sum: &Wave, series: &[Double], rho: f64) -> f64 {
        let height = 0.5 * self.half * (rho - 1.0 / rho);
        let term = |(j, c): (usize, &Double)| c.hi.abs() * libm::sinh(j as f64 * libm::log(rho));
        let angle: f64 = series.iter().enumerate().map(term).sum();
        sum.bound(height) + libm::cosh(0.5 * angle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Regime;
    use crate::plan::tests::scene;

    /// (−1)ⁿ⁻¹ k b₂ₙ₋₁ of a release from θ0.
    fn weights(theta0: &str, terms: usize) -> Vec<Double> {
        let scene = scene(&format!("theta0 = {theta0}"));
        let Regime::Swing(swing) = &scene.motion.regime else { panic!("a swing") };
        let weight = |n: usize| {
            let weight = (swing.fourier_coefficient(n) * &swing.elliptic.modulus).to_double();
            if n.is_multiple_of(2) { -weight } else { weight }
        };
        (1..=terms).map(weight).collect()
    }

    /// The numbers of parts and of terms for an error of 2⁻⁵²; nearer to an overshoot there are no pieces.
    #[test]
    fn parts_and_terms() {
        let found = |theta0: &str, terms: usize| {
            let pieces = Piecewise::new(&weights(theta0, terms), 1e-16)?;
            let least = (2..=POINTS).find(|&terms| pieces.truncation(terms) <= 2e-16)?;
            Some((pieces.parts, least))
        };
        assert_eq!(found("1", 1), Some((32, 9)));
        assert_eq!(found("7π/8", 4), Some((32, 12)));
        assert_eq!(found("7π/8", 2), Some((64, 12)));
        assert_eq!(found("0.93π", 4), Some((64, 12)));
        assert_eq!(found("0.95π", 4), None);
    }

    /// A series that is wrong by ε anywhere is seen to be: by ε/2·cos(θ̂/2), times Lebesgue's constant.
    #[test]
    fn errors_are_seen() {
        let sum = Wave::harmonics(&weights("7π/8", 4));
        let table = CosineTable::new(POINTS);
        for index in [0, 5, 16] {
            let piece = Piece { centre: f64::from(index) / 32.0, half: half(32) };
            let angle = |u: Double| twice_arcsine(sum.at(piece.phase(u))).unwrap();
            let mut series = table.coefficients(&table.points().map(angle).collect::<Vec<_>>(), POINTS);
            let exact = piece.residual(&sum, &series, 1e-20).unwrap();
            assert!(exact < 1e-19, "{index}: {exact:e}");
            let epsilon = 1e-9;
            series[2] = series[2] + Double::new(epsilon);
            // T₂ is largest at the ends, cos(θ̂/2) where θ̂ is smaller.
            let ends = [-1.0, 1.0].map(|u| libm::cos(0.5 * angle(Double::new(u)).hi));
            let expected = 0.5 * epsilon * ends[0].max(ends[1]);
            let times = piece.residual(&sum, &series, 1e-20).unwrap() / expected;
            assert!((1.0..4.0).contains(&times), "{index}: {times}");
        }
    }

    /// Where Im s is as large as on the ellipse, and |sin(Q/2)| with Q = 3 + T₁.
    #[test]
    fn bounds_on_ellipses() {
        let sum = Wave::harmonics(&[Double::ONE]);
        let piece = Piece { centre: 0.3, half: 0.1 };
        let series = [Double::new(3.0), Double::ONE];
        let expected = (0.1 * 0.75 * std::f64::consts::PI).cosh() + (0.5 * 0.75_f64).cosh();
        let found = piece.bound(&sum, &series, 2.0);
        assert!((found / expected - 1.0).abs() < 1e-8, "{found} {expected}");
    }

    /// The polynomials are the series: with all terms at the ends and in the middle of pieces.
    #[test]
    fn kernels_are_of_the_series() {
        let weights = weights("2", 3);
        let (sum, pieces) = (Wave::harmonics(&weights), Piecewise::new(&weights, 1e-14).unwrap());
        let rate = crate::exact::Context::for_digits(40).integer(1);
        let clock = crate::plan::reduction::Clock {
            rate: &rate,
            launch: Double::ZERO,
            t_max: Some(4.0),
            float: crate::parse::Float::F64,
        };
        let kernel = |reduction: &Reduction| pieces.kernel(reduction, -1.0, 1e-14);
        let (kernel, truncation) = clock.reductions().iter().find_map(kernel).unwrap();
        assert!(truncation <= 1e-14 && kernel.terms() < POINTS);
        let mut b = crate::program::Builder::new(crate::parse::Float::F64);
        let result = kernel.lower(&mut b, "result");
        let program = b.finish(vec![result]);
        for eighth in -256..256 {
            let t = f64::from(eighth) / 128.0;
            let phase = Double::new(t - t.round());
            let sign = if t.round() % 2.0 == 0.0 { -1.0 } else { 1.0 };
            let exact = twice_arcsine(sum.at(phase)).unwrap() * sign;
            let error = (Double::new(program.run(t)[0]) - exact).hi.abs();
            assert!(error <= truncation + kernel.rounding(), "{t}: {error:e}");
        }
        // A reduction that counts no parts has no pieces.
        assert!(clock.reductions().iter().any(|reduction| pieces.kernel(reduction, 1.0, 1e-14).is_none()));
    }
}
