//! The curves of a swing, by the phase in half periods.

use super::{Curve, Curves};
use crate::exact::Real;
use crate::motion::Swing;
use crate::plan::conditioning::Conditioning;
use crate::plan::pulses::Pulses;
use crate::series::Wave;
use pendulum_runtime::double::Double;
use pendulum_runtime::elliptic::Jacobi;
use std::cell::OnceCell;

/// The curves of a swing.
pub(crate) struct SwingCurves<'a> {
    swing: &'a Swing,
    omega: &'a Real,
    conditioning: OnceCell<Conditioning>,
}

impl<'a> SwingCurves<'a> {
    pub(crate) fn new(swing: &'a Swing, omega: &'a Real) -> Self {
        Self { swing, omega, conditioning: OnceCell::new() }
    }

    /// Anchors per unit of ωt: 1/(2K).
    fn rate(&self) -> Double {
        (self.swing.rate() / self.omega).to_double()
    }

    fn modulus(&self) -> f64 {
        self.swing.elliptic.modulus.to_f64()
    }

    /// k′, the least cos(θ/2).
    pub(crate) fn complementary(&self) -> f64 {
        self.swing.elliptic.complementary.to_f64()
    }

    /// sup |sin θ|.
    fn largest_sine(&self) -> f64 {
        let amplitude = self.swing.amplitude.to_f64();
        if amplitude >= std::f64::consts::FRAC_PI_2 { 1.0 } else { libm::sin(amplitude) }
    }

    fn curve(wave: Wave, pulses: Pulses, largest: f64, slopes: [f64; 2], unit: f64) -> Curve {
        Curve { alternates: true, ..Curve::new(wave, pulses, largest, slopes, unit) }
    }

    fn conditioning(&self) -> &Conditioning {
        let (rate, fastest) = (self.rate().hi, 2.0 * self.modulus());
        // θ̇/ω = 2k cn: of some hundreds of harmonics the series takes far longer.
        let cosine = |jacobi: Jacobi| Conditioning::new(|z| fastest * jacobi.sn_cn_dn(z / rate).1.abs(), rate, fastest);
        let slope = || Wave::swing(self.swing, 1, Double::ONE, Double::ONE);
        let series = || Conditioning::of_wave(&slope(), rate, fastest);
        let jacobi = || Jacobi::from_complementary_modulus(self.complementary()).filter(|_| fastest > 1.0);
        self.conditioning.get_or_init(|| jacobi().map_or_else(series, cosine))
    }
}

impl Curves for SwingCurves<'_> {
    /// |θ̇| ≤ 2kω, which it reaches at the lowest point, faster and faster from the turning point on.
    fn angle(&self) -> Curve {
        let wave = Wave::swing(self.swing, 0, Double::ONE, Double::ONE);
        let largest = self.swing.amplitude.to_f64();
        let slopes = [2.0 * self.modulus() / self.rate().hi, self.conditioning().angle];
        let pulses = Pulses::angle(&self.swing.elliptic, largest, 0.0);
        Curve { rises: true, ..Self::curve(wave, pulses, largest, slopes, 1.0) }
    }

    fn velocity(&self) -> Curve {
        let omega = self.omega.to_double();
        let slopes = [self.largest_sine() / self.rate().hi, self.conditioning().velocity].map(|slope| omega.hi * slope);
        let pulses = Pulses::velocity(&self.swing.elliptic, 1.0, omega.hi);
        let wave = Wave::swing(self.swing, 1, self.rate(), omega);
        Self::curve(wave, pulses, 2.0 * self.modulus() * omega.hi, slopes, omega.hi)
    }

    /// −ω² sin θ; its derivative is largest at the lowest point.
    fn acceleration(&self) -> Curve {
        let unit = self.omega.square().to_double();
        let square = unit.hi;
        let slopes =
            [2.0 * self.modulus() / self.rate().hi, self.conditioning().acceleration].map(|slope| square * slope);
        let pulses = Pulses::acceleration(&self.swing.elliptic, 1.0, square);
        let wave = Wave::swing(self.swing, 2, self.rate(), unit);
        Self::curve(wave, pulses, square * self.largest_sine(), slopes, square)
    }

    /// k sn.
    fn half_sine(&self) -> Curve {
        let pulses = Pulses::half_sine(&self.swing.elliptic, 1.0);
        Self::curve(Wave::half_sine(self.swing), pulses, self.modulus(), [f64::INFINITY; 2], 1.0)
    }

    /// dn.
    fn half_cosine(&self) -> Curve {
        let pulses = Pulses::half_cosine(&self.swing.elliptic, 1.0);
        Curve::new(Wave::half_cosine(self.swing), pulses, 1.0, [f64::INFINITY; 2], 1.0)
    }
}
