//! Carlson's symmetric integral RF, the well-conditioned form of the incomplete elliptic integral of the first kind.

use crate::double::Double;

/// More steps than any arguments need: the first step lifts every argument to the order of √(largest · middle).
const MAX_STEPS: usize = 64;

/// RF(x, y, z) for non-negative arguments of which at most one is 0; relative error below 2⁻⁹⁹.
///
/// The duplication theorem (Carlson 1995; DLMF 19.26.18) brings the arguments together fourfold per step; when they
/// agree to 2⁻¹³, the series about their mean (DLMF 19.36.1), whose first neglected terms are of order eight, is exact
/// to 2⁻¹⁰⁶.
pub(crate) fn carlson_rf(x: Double, y: Double, z: Double) -> Double {
    let (mut x, mut y, mut z) = (x, y, z);
    for _ in 0..MAX_STEPS {
        if spread(x.hi, y.hi, z.hi) <= 1.0 / 8192.0 {
            break;
        }
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = rx * ry + ry * rz + rz * rx;
        x = (x + shift).scale(0.25);
        y = (y + shift).scale(0.25);
        z = (z + shift).scale(0.25);
    }
    near_mean(x, y, z) / mean_of(x, y, z).sqrt()
}

/// The largest distance from the mean, relative to it.
fn spread(x: f64, y: f64, z: f64) -> f64 {
    let mean = (x + y + z) / 3.0;
    (x - mean).abs().max((y - mean).abs()).max((z - mean).abs()) / mean
}

fn mean_of(x: Double, y: Double, z: Double) -> Double {
    (x + y + z) / 3.0
}

/// RF · √mean as a series in the relative deviations from the mean.
fn near_mean(x: Double, y: Double, z: Double) -> Double {
    let mean = mean_of(x, y, z);
    let dx = (mean - x) / mean;
    let dy = (mean - y) / mean;
    let dz = -(dx + dy);
    let e2 = dx * dy - dz * dz;
    let e3 = dx * dy * dz;
    let (f2, f3) = (e2.hi, e3.hi);
    let small = f2 * f2 / 24.0 - 3.0 * f2 * f3 / 44.0 - 5.0 * f2 * f2 * f2 / 208.0
        + 3.0 * f3 * f3 / 104.0
        + f2 * f2 * f3 / 16.0;
    Double::ONE + (Double::new(small) + e3 / 14.0 - e2 / 10.0)
}

/// ωt since the angle passed 0: ∫₀^(θ/2) dψ/√(k² − sin² ψ) = (sin(θ/2)/k) RF(a²/k², cos²(θ/2), 1).
///
/// Here k² = a² + sin²(θ/2) is half the energy in units of ω² and a = |θ̇|/(2ω) the speed there. It serves swings
/// (k < 1), the separatrix and rotations (k > 1) alike (DLMF 19.25.5 with the homogeneity of RF).
pub(crate) fn elapsed(sine: Double, cosine: Double, speed: Double, k: Double) -> Double {
    let ratio = speed / k;
    (sine / k) * carlson_rf(ratio * ratio, cosine * cosine, Double::ONE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::double::relative_error;
    use crate::kernel::two_to;

    /// Two of Carlson's own examples (1995), two of near arguments and one of far ones; expected values by mpmath's
    /// `elliprf`.
    #[test]
    fn known_values() {
        let cases = [
            ([1.0, 2.0, 0.0], Double { hi: 1.3110287771460598, lo: 9.58215479734899e-17 }),
            ([2.0, 3.0, 4.0], Double { hi: 0.5840828416771517, lo: -3.6150116917829376e-17 }),
            // So near to each other that the series alone speaks, its highest term being 2⁻⁹⁸.
            (
                [0.99993896484375, 0.99993896484375, 1.0001220703125],
                Double { hi: 1.0000000011175547, lo: -1.0264641272390415e-16 },
            ),
            (
                [1.00006103515625, 1.00006103515625, 0.9998779296875],
                Double { hi: 1.0000000011176196, lo: 2.4236911688791967e-17 },
            ),
            ([0.25, 1e-9, 1.0], Double { hi: 2.1564524043684465, lo: -2.1708506607519867e-17 }),
        ];
        for (arguments, expected) in cases {
            let [x, y, z] = arguments.map(Double::new);
            for value in [carlson_rf(x, y, z), carlson_rf(z, x, y), carlson_rf(y, z, x)] {
                let error = relative_error(value, expected);
                assert!(error <= two_to(-99), "{arguments:?}: {error:e}");
            }
        }
    }

    /// RF(λx, λy, λz) = RF(x, y, z)/√λ, to the bit for λ a power of four.
    #[test]
    fn homogeneous() {
        let [x, y, z] = [0.3, 0.01, 1.0].map(Double::new);
        let scaled = carlson_rf(x.scale(4.0), y.scale(4.0), z.scale(4.0));
        assert_eq!(scaled.scale(2.0), carlson_rf(x, y, z));
    }
}
