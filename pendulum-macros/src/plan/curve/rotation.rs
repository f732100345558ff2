//! The curves of a rotation, by the phase in turns from the top.

use super::{Curve, Curves};
use crate::exact::Real;
use crate::motion::Rotation;
use crate::plan::conditioning::Conditioning;
use crate::plan::pulses::Pulses;
use crate::series::{Parity, Wave};
use pendulum_runtime::double::Double;
use std::cell::OnceCell;

/// The curves of a rotation, by the phase in turns from the top.
pub(crate) struct RotationCurves<'a> {
    rotation: &'a Rotation,
    omega: &'a Real,
    conditioning: OnceCell<Conditioning>,
}

impl<'a> RotationCurves<'a> {
    pub(crate) fn new(rotation: &'a Rotation, omega: &'a Real) -> Self {
        Self { rotation, omega, conditioning: OnceCell::new() }
    }

    /// Turns per unit of time.
    fn rate(&self) -> Double {
        self.rotation.rate().to_double()
    }

    /// The largest |derivative| by the phase of what changes by at most that product per unit of time, which itself over-
    /// or underflows where ω is far from 1.
    fn slope(&self, factor: f64, per_time: f64) -> f64 {
        factor * (per_time / self.rate().hi)
    }

    /// 1/κ.
    fn front(&self) -> f64 {
        1.0 / self.rotation.elliptic.modulus.to_f64()
    }

    fn conditioning(&self) -> &Conditioning {
        let omega = self.omega.to_f64();
        let slope = || Wave::rotation(self.rotation, 1, Double::ONE, Double::ONE);
        let (rate, fastest) = (self.rate().hi / omega, self.rotation.fastest.to_f64() / omega);
        self.conditioning.get_or_init(|| Conditioning::of_wave(&slope(), rate, fastest))
    }

    /// The angle itself, of the turn that passes the lowest point at s = ½.
    pub(crate) fn whole_angle(&self) -> Curve {
        let wave = Wave::rotation(self.rotation, 0, Double::ONE, Double::ONE).raised(-Double::PI);
        Curve { wave, pulses: None, ..self.angle() }
    }
}

impl Curves for RotationCurves<'_> {
    /// From the top, less 2πs; its slope is that of the whole.
    fn angle(&self) -> Curve {
        let wave = Wave::rotation(self.rotation, 0, Double::ONE, Double::ONE).without_mean();
        let slopes = [self.slope(1.0, self.rotation.fastest.to_f64()), self.conditioning().angle];
        let pulses = Pulses::angle(&self.rotation.elliptic, std::f64::consts::PI, 1.0);
        Curve::new(wave, pulses, std::f64::consts::PI, slopes, 1.0)
    }

    /// |θ̇|; its derivative is at most ω².
    fn velocity(&self) -> Curve {
        let omega = self.omega.to_f64();
        let fastest = self.rotation.fastest.to_double();
        let wave = Wave::rotation(self.rotation, 1, self.rate() / fastest, fastest);
        let slopes = [self.slope(omega, omega), omega * self.conditioning().velocity];
        let pulses = Pulses::velocity(&self.rotation.elliptic, self.front(), omega);
        Curve::new(wave, pulses, fastest.hi, slopes, omega)
    }

    fn acceleration(&self) -> Curve {
        let unit = self.omega.square().to_double();
        let square = unit.hi;
        let wave = Wave::rotation(self.rotation, 2, self.rate() / self.omega.to_double(), unit);
        let slopes = [self.slope(square, self.rotation.fastest.to_f64()), square * self.conditioning().acceleration];
        let pulses = Pulses::acceleration(&self.rotation.elliptic, self.front(), square);
        Curve::new(wave, pulses, square, slopes, square)
    }

    fn half_sine(&self) -> Curve {
        let pulses = Pulses::half_sine(&self.rotation.elliptic, self.front());
        Curve::new(Wave::from_top(self.rotation, Parity::Even), pulses, 1.0, [f64::INFINITY; 2], 1.0)
    }

    fn half_cosine(&self) -> Curve {
        let pulses = Pulses::half_cosine(&self.rotation.elliptic, self.front());
        Curve::new(Wave::from_top(self.rotation, Parity::Odd), pulses, 1.0, [f64::INFINITY; 2], 1.0)
    }
}
