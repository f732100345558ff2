//! The same bits at every optimisation level and on every IEEE target: a fingerprint of everything the runtime
//! computes. Run it with `--release`, with `RUSTFLAGS="-C target-cpu=native"` and on other machines. A deliberate
//! change of a formula changes it; the message of the failed assertion has the new value.

use pendula::elliptic::Jacobi;
use pendula::{Pendulum, Scalar};

const FINGERPRINT: u64 = 0xe522_275c_1fc1_4a74;

/// FNV-1a over the bits.
struct Fingerprint(u64);

impl Fingerprint {
    fn add<F: Into<f64>>(&mut self, numbers: impl IntoIterator<Item = F>) {
        for byte in numbers.into_iter().flat_map(|x| x.into().to_bits().to_le_bytes()) {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

fn add_motion<F: Scalar + Into<f64>>(fingerprint: &mut Fingerprint, p: &Pendulum<F>, times: impl Iterator<Item = F>) {
    let constants = [p.period(), p.amplitude(), p.modulus(), p.nome(), p.quarter_period(), p.energy()];
    fingerprint.add(constants);
    let paper = p.fourier::<5>();
    for t in times {
        let (x, y) = p.position(t);
        let motion = [p.theta(t), p.velocity(t), p.acceleration(t), p.wrapped(t), x, y, p.small_angle(t)];
        fingerprint.add(motion);
        if let Ok(time) = p.time_at(p.theta(t)) {
            fingerprint.add([time]);
        }
        if let Ok(paper) = &paper {
            fingerprint.add([paper.theta(t), paper.max_error()]);
        }
    }
}

/// Times from 1e-3 to 1e13 of both signs.
fn times() -> impl Iterator<Item = f64> {
    (0..400).map(|i| f64::from(1 - 2 * (i % 2)) * 1.37e-3 * growth(i))
}

/// 1.097ⁿ by multiplication: `powi` may differ between targets.
fn growth(n: i32) -> f64 {
    (0..n).fold(1.0, |x, _| x * 1.097)
}

#[test]
fn the_bits_are_the_same_everywhere() {
    let mut fingerprint = Fingerprint(0xcbf2_9ce4_8422_2325);
    for theta0 in [1e-9, 0.3, 1.5, 2.7, 3.0, 3.13, core::f64::consts::PI] {
        add_motion(&mut fingerprint, &Pendulum::<f64>::new(theta0, 1.3).expect("valid"), times());
    }
    for (theta, velocity) in [(0.4, 1.1), (-2.0, 0.9), (0.0, 2.6), (30.0, -2.03), (0.0, 2.0), (1.0, 40.0)] {
        add_motion(&mut fingerprint, &Pendulum::<f64>::from_state(theta, velocity, 1.0).expect("valid"), times());
        let narrow = Pendulum::<f32>::from_state(theta as f32, velocity as f32, 1.0).expect("valid");
        add_motion(&mut fingerprint, &narrow, times().map(|t| t as f32));
    }
    for k in [0.1, 0.7, 0.93, 0.999] {
        let j = Jacobi::from_modulus(k).expect("in [0, 1]");
        for u in times() {
            let (sn, cn, dn) = j.sn_cn_dn(u);
            fingerprint.add([sn, cn, dn, j.am(u), j.incomplete(u)]);
        }
    }
    assert_eq!(fingerprint.0, FINGERPRINT, "the fingerprint is now {:#x}", fingerprint.0);
}
