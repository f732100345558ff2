//! A wave at the same places of every piece of an anchor.

use super::{Parity, STEP, Wave};
use crate::chebyshev::{CosineTable, cos_pi, sin_pi};
use pendulum_runtime::double::Double;

impl Wave {
    /// For each i from 0 to pieces/2 the values at the phases i/pieces + offset, for |offset| ≤ ½ and an even number of pieces.
    ///
    /// A term is cos(mπ·offset) cos(mπi/pieces) − sin(mπ·offset) sin(mπi/pieces), or the like of a sine, in which m counts
    /// modulo 2·pieces: of thousands no more are left than there are pieces.
    ///
    /// Of up to 2¹⁴ terms it is rounded by less than what [`Wave::sampling_error`] says of the recurrence, whose terms count
    /// Σ|aₘ|n(n + 1)·2⁻⁹⁶, n being about m/2: the waves of the offset are turned by n steps, each wrong by 2⁻⁹⁸, and all
    /// else adds up to 2⁻⁹⁶Σ|aₘ| at most, of sums to one remainder, wrong by 2⁻¹⁰⁵ each, of those over them, and of
    /// products.
    pub(crate) fn at_pieces(&self, pieces: usize, offsets: impl Iterator<Item = Double>) -> Vec<Vec<Double>> {
        let weighted: Vec<_> = offsets.map(|offset| (offset, self.modulo_turns(pieces, offset))).collect();
        let table = CosineTable::new(pieces / 2);
        let at = |i: usize, offset: Double, weights: &[(Double, Double)]| {
            let term = |(m, &(even, odd)): (usize, &(Double, Double))| {
                even * table.get(m * i) + odd * table.get(m * i + 3 * pieces / 2)
            };
            let terms = self.remainders(pieces).zip(weights).map(term);
            let s = offset + Double::new(i as f64 / pieces as f64);
            self.constant + self.linear * s + terms.fold(Double::ZERO, |sum, term| sum + term)
        };
        let in_piece = |i: usize| weighted.iter().map(|(offset, weights)| at(i, *offset, weights)).collect();
        (0..=pieces / 2).map(in_piece).collect()
    }

    /// The remainders of m, up to their signs.
    fn remainders(&self, pieces: usize) -> impl Iterator<Item = usize> {
        let least = self.terms.first().map_or(0, |term| term.0 % STEP);
        (least as usize..=pieces).step_by(STEP as usize)
    }

    /// For each remainder r what cos(rπi/pieces) and sin(rπi/pieces) are multiplied with.
    fn modulo_turns(&self, pieces: usize, offset: Double) -> Vec<(Double, Double)> {
        let mut weights = vec![(Double::ZERO, Double::ZERO); self.remainders(pieces).count()];
        let wave = |m: u32| (cos_pi(offset * f64::from(m)), sin_pi(offset * f64::from(m)));
        let (mut cosine, mut sine) = wave(self.terms.first().map_or(0, |term| term.0));
        let (turn, turn_sine) = wave(STEP);
        for &(m, amplitude) in &self.terms {
            let remainder = m as usize % (2 * pieces);
            let (remainder, mirrored) =
                if remainder > pieces { (2 * pieces - remainder, true) } else { (remainder, false) };
            let (even, odd) = (amplitude * cosine, amplitude * sine);
            let (even, odd) = if self.parity == Parity::Even { (even, -odd) } else { (odd, even) };
            let weight = &mut weights[remainder / STEP as usize];
            *weight = (weight.0 + even, weight.1 + if mirrored { -odd } else { odd });
            (cosine, sine) = (cosine * turn - sine * turn_sine, sine * turn + cosine * turn_sine);
        }
        weights
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Regime;
    use crate::testing::{scene, swing};

    /// By Clenshaw's recurrence, of few terms and of more than there are pieces.
    #[test]
    fn values_in_pieces_are_those_one_by_one() {
        let swing = |theta0: &str, order: i32| {
            let scene = scene(&format!("theta0 = {theta0}"));
            let swing = swing(&scene);
            Wave::swing(swing, order, Double::ONE, Double::ONE)
        };
        let scene = scene("velocity0 = 2.000001");
        let Regime::Rotation(rotation) = &scene.motion.regime else { panic!("a rotation") };
        let waves = [
            swing("1", 0),
            swing("π - 1e-6", 1),
            swing("π - 1e-30", 0),
            Wave::rotation(rotation, 0, Double::ONE, Double::ONE),
            Wave::rotation(rotation, 1, Double::ONE, Double::ONE),
            Wave::from_top(rotation, Parity::Odd),
            Wave::harmonics(&[0.9, -0.4, 0.1].map(Double::new)),
            Wave::sine(),
        ];
        for wave in waves {
            for (pieces, offset) in [(2, 0.3), (32, 0.01), (64, -0.0078), (64, 0.0), (128, 1e-9)] {
                let offset = Double { hi: offset, lo: 1e-18 * offset };
                let values = wave.at_pieces(pieces, [offset].into_iter()).concat();
                assert_eq!(values.len(), pieces / 2 + 1);
                for (i, value) in values.into_iter().enumerate() {
                    let expected = wave.at(offset + Double::new(i as f64 / pieces as f64));
                    let apart = (value - expected).hi.abs();
                    assert!(
                        apart <= 2.0 * wave.sampling_error(),
                        "{pieces} {i}: {apart:e} {:e}",
                        wave.sampling_error()
                    );
                    assert!(apart <= 1e-27, "{pieces} {i}: {apart:e}");
                }
            }
        }
    }
}
