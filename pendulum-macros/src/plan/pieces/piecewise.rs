//! A curve as Chebyshev series in the pieces from an anchor to the middle between two.
//!
//! Each piece is interpolated at M Chebyshev points. On the ellipse with parameter ρ about a piece of half width h the
//! phase stays within the strip |Im s| ≤ h(ρ − 1/ρ)/2, where the Fourier series bounds the curve, and so the interpolants'
//! errors ([`crate::chebyshev::interpolation_error`]). What is dropped is known.

use super::Pieces;
use crate::chebyshev::{CosineTable, Interpolation, lebesgue, rounding_of_powers, scale, to_powers};
use crate::plan::curve::Curve;
use crate::plan::met::Met;
use crate::plan::reduction::Reduction;
use crate::program::rounding::lost_to_underflow;
use crate::series::Parity;
use crate::supremum::worst;
use pendulum_runtime::double::Double;

/// By how much of themselves pieces are interpolated beyond their ends: more than any remainder exceeds half of one by.
const MARGIN: f64 = 1.0 / 256.0;

/// More points in a piece than this take too long.
const MOST_POINTS: usize = 24;

/// A curve in pieces.
#[derive(Clone, Debug)]
pub(crate) struct Piecewise {
    /// Chebyshev series in u = (s − centre)/half, a piece each.
    series: Vec<Vec<Double>>,
    /// Of all of them, whole.
    error: f64,
    parity: Parity,
    alternates: bool,
    /// Where not all is met.
    met: Option<Met>,
}

impl Piecewise {
    /// The numbers of pieces that are tried for whole outputs: a table of up to 16 KiB for each.
    pub(crate) const COUNTS: [usize; 2] = [64, 128];
    /// With more terms than this smaller pieces are tried.
    pub(crate) const MOST_TERMS: usize = 16;

    /// A whole curve in so many pieces from anchor to anchor, the series' own error below `negligible`; `None` if that takes
    /// too many points.
    pub(crate) fn new(curve: &Curve, pieces: usize, negligible: f64) -> Option<Self> {
        let Interpolation { points, error, .. } = enough_points(curve, pieces, negligible)?;
        let table = CosineTable::new(points);
        let values = curve.at_pieces(pieces, table.points().map(|u| u * half(pieces)));
        let (series, rounding): (_, Vec<f64>) = values.iter().map(|own| table.through(own)).unzip();
        Some(Self {
            series,
            error: error + curve.omitted() + lebesgue(points) * curve.sampling_error() + worst(rounding),
            parity: curve.parity(),
            alternates: curve.is_antiperiodic(),
            met: None,
        })
    }

    /// The same, of which a short horizon meets no more than these phases.
    pub(crate) fn meeting(self, phases: Option<Met>) -> Self {
        Self { met: phases, ..self }
    }

    /// A curve that alternates, like θ and θ̇, of which the series and their error are known.
    pub(crate) fn known(series: Vec<Vec<Double>>, error: f64, parity: Parity) -> Self {
        Self { series, error, parity, alternates: true, met: None }
    }

    /// About how many terms leave `limit`, by the distance of the nearest singularities.
    pub(crate) fn estimate(curve: &Curve, pieces: usize, limit: f64) -> usize {
        let log_rho = libm::asinh(curve.strip() / half(pieces));
        (1.0 + libm::log(curve.size.largest / limit).max(1.0) / log_rho).ceil() as usize
    }

    /// The number of pieces from anchor to anchor.
    pub(crate) fn pieces(&self) -> usize {
        2 * (self.series.len() - 1)
    }

    /// Whether a phase of which a reduction makes a remainder from the middle of a piece, or of its mirror image, is met.
    fn meets(&self, index: usize, reduction: &Reduction) -> bool {
        let Some(Met { first, last }) = self.met else { return true };
        let (place, wrong) = (index as f64 / self.pieces() as f64, reduction.error + reduction.relative_error);
        let reach = half(self.pieces()) + 2.0 * wrong;
        [place, -place].into_iter().any(|place| place + (first - reach - place).ceil() <= last + reach)
    }

    /// The error with the first `terms` coefficients of each piece that is met.
    fn truncation(&self, terms: usize, reduction: &Reduction) -> f64 {
        let met = self.series.iter().enumerate().filter(|&(index, _)| self.meets(index, reduction));
        let dropped = met.map(|(_, own)| own[terms..].iter().map(|c| c.hi.abs()).sum());
        self.error + worst(dropped)
    }

    /// The fewest terms, at least two, that are wrong by at most `limit`.
    pub(crate) fn terms_for(&self, limit: f64, reduction: &Reduction) -> Option<usize> {
        (2..=self.series[0].len()).find(|&terms| self.truncation(terms, reduction) <= limit)
    }

    /// The kernel with as few terms as are wrong by at most `limit`, and its truncation, for a reduction to the nearest
    /// piece.
    pub(crate) fn kernel(&self, reduction: &Reduction, limit: f64) -> Option<(Pieces, f64)> {
        let width = half(self.pieces());
        let within = reduction.half() * reduction.unit.hi <= width * (1.0 - MARGIN / 64.0);
        let terms = self.terms_for(limit, reduction).filter(|_| within)?;
        let unit = reduction.unit / width;
        // Beyond the horizon: a value of the motion, whatever the remainder.
        let constant = |own: &[Double]| {
            let mut row = vec![Double::ZERO; terms];
            row[0] = to_powers(own)[0];
            row
        };
        let row = |(index, own): (usize, &Vec<Double>)| {
            if self.meets(index, reduction) { scale(to_powers(&own[..terms]), unit) } else { constant(own) }
        };
        let mut powers: Vec<Vec<Double>> = self.series.iter().enumerate().map(row).collect();
        // About the ends the curve is even or odd: what the other powers are is rounding, of two words.
        let odd = self.parity == Parity::Odd;
        for (end, is_odd) in [(0, odd), (self.series.len() - 1, odd != self.alternates)] {
            let others = powers[end].iter_mut().skip(usize::from(!is_odd)).step_by(2);
            others.for_each(|c| *c = Double::ZERO);
        }
        let pieces = Pieces::new(reduction.clone(), &powers, self.parity, self.alternates);
        let converted = worst(self.series.iter().map(|own| rounding_of_powers(&own[..terms], 1.0)));
        let lost = lost_to_underflow(terms, reduction.half());
        Some((pieces, self.truncation(terms, reduction) + converted + lost))
    }
}

/// Half a piece and its margin, in anchors.
pub(crate) fn half(pieces: usize) -> f64 {
    0.5 / pieces as f64 * (1.0 + MARGIN)
}

/// The phase at u in a piece.
pub(crate) fn phase(pieces: usize, index: usize, u: Double) -> Double {
    u * half(pieces) + Double::new(index as f64 / pieces as f64)
}

/// As many points as make the interpolation error negligible in any piece.
fn enough_points(curve: &Curve, pieces: usize, negligible: f64) -> Option<Interpolation> {
    let ellipse = |height: f64| (curve.bound(height), libm::exp(libm::asinh(height / half(pieces))));
    // A sum of harmonics, which has no poles, is bounded everywhere, farther out by more.
    let entire = || [2.0, 4.0, 8.0, 16.0, 32.0, 64.0].map(|times| times * half(pieces));
    let heights = if curve.is_entire() { entire() } else { curve.heights() };
    Interpolation::fewest(heights.into_iter().map(ellipse), negligible, 4, MOST_POINTS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chebyshev::OF_INTERPOLATION;
    use crate::motion::Regime;
    use crate::parse::Float;
    use crate::plan::curve::{Curves, RotationCurves, SwingCurves};
    use crate::plan::reduction::Clock;
    use crate::program::Builder;
    use crate::program::rounding::UNDERFLOW;
    use crate::testing::{scene, swing};

    /// To the nearest of so many pieces of an anchor, which takes that time.
    fn to_pieces(pieces: usize, time: f64, horizon: f64) -> Reduction {
        let rate = crate::exact::Context::for_digits(40).float(1.0 / time).unwrap();
        let clock = Clock { rate: &rate, launch: Double::ZERO, horizon, float: Float::F64 };
        clock.reductions().iter().find_map(|reduction| reduction.in_pieces(pieces)).unwrap()
    }

    /// Curves of either parity, alternating and not, near the top and far from it.
    fn curves() -> Vec<(&'static str, Curve)> {
        let mut all = Vec::new();
        for start in ["theta0 = 1", "theta0 = 0.99π", "theta0 = π - 1e-6", "velocity0 = 2.001"] {
            let scene = scene(start);
            let omega = &scene.motion.omega;
            match &scene.motion.regime {
                Regime::Swing(swing) => {
                    let curves = SwingCurves::new(swing, omega);
                    let three = [curves.angle(), curves.velocity(), curves.acceleration(), curves.half_cosine()];
                    all.extend(three.map(|curve| (start, curve)));
                }
                Regime::Rotation(rotation) => {
                    let curves = RotationCurves::new(rotation, omega);
                    all.extend([curves.velocity(), curves.acceleration()].map(|curve| (start, curve)));
                }
                Regime::Separatrix(_) => panic!("{start}"),
            }
        }
        all
    }

    /// Anywhere in four anchors, also beyond the ends of pieces, a kernel is off by no more than is stated, and by about
    /// that somewhere.
    #[test]
    fn errors_are_those_stated() {
        // An anchor takes two units of time, and then a quarter, where phases are counted in eighths.
        for (start, curve, time) in
            curves().into_iter().flat_map(|(start, curve)| [2.0, 0.25].map(|t| (start, curve.clone(), t)))
        {
            for (pieces, limit) in [(16, 1e-4), (64, 1e-7), (32, 1e-11), (128, 1e-14)] {
                let piecewise = Piecewise::new(&curve, pieces, limit * OF_INTERPOLATION).unwrap();
                let reduction = to_pieces(pieces, time, 100.0);
                let unit = if time < 1.0 { 8.0 } else { 1.0 };
                assert_eq!((piecewise.pieces(), reduction.unit), (pieces, Double::new(unit)));
                let (kernel, truncation) = piecewise.kernel(&reduction, limit).unwrap();
                // Remainders from fewer pieces go beyond what was interpolated.
                let fewer = reduction.in_pieces(pieces / 2).unwrap();
                assert!(piecewise.kernel(&fewer, limit).is_none());
                assert!(truncation <= limit && kernel.terms() == piecewise.terms_for(limit, &reduction).unwrap());
                let mut b = Builder::new(Float::F64);
                let result = kernel.lower(&mut b, "result");
                let program = b.finish(vec![result]);
                let most = truncation + kernel.rounding();
                let mut worst = 0.0_f64;
                for step in -1600..=1600 {
                    let s = f64::from(step) / 800.0 + f64::from(step % 7) * 2f64.powi(-30);
                    let number = s.round();
                    let sign = if curve.alternates && number % 2.0 != 0.0 { -1.0 } else { 1.0 };
                    let exact = curve.at(Double::new(s - number)) * sign;
                    worst = worst.max((Double::new(program.run(time * s)[0]) - exact).hi.abs());
                }
                assert!(worst <= most, "{start} {pieces} {limit:e}: {worst:e} {most:e}");
                assert!(worst > most / 4.0, "{start} {pieces} {limit:e}: {worst:e} {most:e}");
            }
        }
    }

    /// What samples and coefficients lose to underflow is promised.
    #[test]
    fn pieces_that_underflow() {
        let scene = scene("velocity0 = (2 + 1e-9)*1e-153, omega = 1e-153");
        let Regime::Rotation(rotation) = &scene.motion.regime else { panic!("a rotation") };
        let curve = RotationCurves::new(rotation, &scene.motion.omega).acceleration();
        let reduction = to_pieces(64, 2.0, 100.0);
        let piecewise = Piecewise::new(&curve, 64, UNDERFLOW).unwrap();
        let (_, truncation) = piecewise.kernel(&reduction, 4.0 * UNDERFLOW).unwrap();
        assert!((2.0..6.0).contains(&(truncation / UNDERFLOW)), "{truncation:e}");
    }

    /// What a horizon of less than an anchor meets decides what is promised; beyond it is a value of the motion.
    #[test]
    fn pieces_that_are_met() {
        let scene = scene("theta0 = π - 1e-6");
        let swing = swing(&scene);
        let curve = SwingCurves::new(swing, &scene.motion.omega).angle();
        let reduction = to_pieces(64, 2.0, 2.0);
        let whole = Piecewise::new(&curve, 64, 1e-14).unwrap();
        for (first, last, rows) in
            [(-0.2, 0.2, 0..=13), (0.1, 0.3, 6..=19), (-0.3, -0.1, 6..=19), (1.9, 2.25, 0..=16), (0.4, 0.7, 19..=32)]
        {
            let met = whole.clone().meeting(Some(Met { first, last }));
            let found: Vec<usize> = (0..=32).filter(|&index| met.meets(index, &reduction)).collect();
            assert_eq!(found, rows.collect::<Vec<_>>(), "{first} {last}");
            let (kernel, truncation) = met.kernel(&reduction, 1e-9).unwrap();
            let mut b = Builder::new(Float::F64);
            let result = kernel.lower(&mut b, "result");
            let program = b.finish(vec![result]);
            let most = truncation + kernel.rounding();
            let mut worst = 0.0_f64;
            for step in 0..=1000 {
                let s = first + (last - first) * f64::from(step) / 1000.0;
                let sign = if s.round() % 2.0 == 0.0 { 1.0 } else { -1.0 };
                let exact = curve.at(Double::new(s - s.round())) * sign;
                worst = worst.max((Double::new(program.run(2.0 * s)[0]) - exact).hi.abs());
            }
            assert!(worst <= most && most < 4.0 * worst, "{first} {last}: {worst:e} {most:e}");
            for step in -1000..=1000 {
                let far = program.run(f64::from(step) / 100.0)[0];
                assert!(far.abs() <= swing.amplitude.to_f64() + most, "{step}: {far}");
            }
            assert!(kernel.terms() <= whole.terms_for(1e-9, &reduction).unwrap());
        }
    }

    /// The estimate is seldom one term too low, and then by one, and never more than two too high.
    #[test]
    fn estimates() {
        let time = Reduction::time(1.0, false, Float::F64).unwrap();
        for (start, curve) in curves() {
            for (pieces, limit) in [(32, 1e-3), (64, 1e-6), (64, 1e-9), (64, 1e-12), (128, 1e-15)] {
                let piecewise = Piecewise::new(&curve, pieces, limit * OF_INTERPOLATION).unwrap();
                let needed = piecewise.terms_for(limit, &time).unwrap() as i64;
                let off = Piecewise::estimate(&curve, pieces, limit) as i64 - needed;
                assert!((-1..=3).contains(&off), "{start} {pieces} {limit:e}: {needed} {off}");
            }
        }
        let scene = scene("theta0 = π - 1e-9");
        let swing = swing(&scene);
        let theta = SwingCurves::new(swing, &scene.motion.omega).angle();
        assert!(Piecewise::new(&theta, 16, 1e-14).is_none(), "few pieces take many points");
    }
}
