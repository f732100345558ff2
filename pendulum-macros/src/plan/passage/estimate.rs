//! What a passage costs, before there is one.

use super::{Images, OF_ARCTANGENT, Orbit, of_series};
use crate::parse::{Float, Output};

/// Operations by term of a polynomial, with the powers of its variable.
const BY_TERM: f64 = 2.2;

impl Orbit {
    /// The cost of the kernel of an output that is to be right within `limit`, in units of its factor. Of 550 candidates from
    /// 7π/8 to π − 10⁻²⁰, of rotations and of the separatrix, from 10⁻² to full precision, it is with the phase 0.87 to 1.08
    /// times the cost of the plan, of nine in ten 0.9 to 1.035 times.
    pub(in crate::plan) fn cost(&self, output: Output, limit: f64, float: Float) -> f64 {
        let q = self.q();
        let (images, _) = Images::that_matter(output, q, q.sqrt(), limit);
        let bits = -libm::log2(limit).min(-6.0);
        let bits_of = |share: f64| bits - libm::log2(share);
        let of_powers = 0.6 + bits_of(of_series(output)) / 5.0;
        let of_arctangent = if output.is_angle() { 0.4 * bits_of(OF_ARCTANGENT) - 1.1 } else { 0.0 };
        let quotient = match output {
            Output::Theta | Output::Wrapped => 8.0,
            Output::Velocity => 10.0,
            Output::Acceleration => 13.5,
            Output::Position => 18.5,
        };
        let of_images = match images {
            Images::Nothing => 0.0,
            Images::Sum => 10.0,
            Images::Denominator => 18.0,
            Images::Correction => 23.0,
        };
        let care = if images.ask_for_care(output, limit) { 4.0 } else { 0.0 };
        let operations = BY_TERM * (of_powers + of_arctangent) + quotient + of_images + care;
        match float {
            Float::F64 => operations,
            // Half of the lanes, and conversions there and back.
            Float::F32 => 2.0 * operations + 7.0,
        }
    }
}
