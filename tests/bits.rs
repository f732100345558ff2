//! The same bits at every optimisation level, on every target and with every instruction set: hashes of the results of
//! each kind of plan, and of everything that the runtime computes, at 10⁵ times against `tests/bits/hashes.txt`.
//! `.ci/run` runs this test at opt-levels 0 and 3, for the baseline and for the machine's own instructions.
//!
//! A change of the planner or of the runtime changes bits, and may: `PENDULA_BLESS=1 cargo test --test bits` writes the
//! file anew.

use pendula::elliptic::Jacobi;
use pendula::{Fourier, Pendulum, Scalar, pendulum};
use std::fmt::Write as _;

const EVALUATIONS: u64 = 100_000;

/// FNV-1a over 64-bit words, whose highest bits come down again: multiplication alone would leave the sign of a result in
/// the highest bit, where that of another undoes it.
struct Hash(u64);

impl Hash {
    const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    fn add(&mut self, bits: u64) {
        let product = (self.0 ^ bits).wrapping_mul(0x0100_0000_01b3);
        self.0 = product ^ (product >> 32);
    }
}

trait Bits {
    fn hash(self, hash: &mut Hash);
}

impl Bits for f64 {
    fn hash(self, hash: &mut Hash) {
        // NaN has many bit patterns, of which IEEE 754 leaves the choice open.
        hash.add(if self.is_nan() { u64::MAX } else { self.to_bits() });
    }
}

impl Bits for f32 {
    fn hash(self, hash: &mut Hash) {
        hash.add(if self.is_nan() { u64::MAX } else { self.to_bits().into() });
    }
}

impl<T: Bits> Bits for (T, T) {
    fn hash(self, hash: &mut Hash) {
        self.0.hash(hash);
        self.1.hash(hash);
    }
}

impl<T: Bits, const N: usize> Bits for [T; N] {
    fn hash(self, hash: &mut Hash) {
        for one in self {
            one.hash(hash);
        }
    }
}

impl<T: Bits> Bits for Option<T> {
    fn hash(self, hash: &mut Hash) {
        if let Some(one) = self {
            one.hash(hash);
        }
    }
}

/// Times without any function of a library: bits of a linear congruence, half of them in ±64, half of any magnitude.
fn times() -> impl Iterator<Item = f64> {
    let mut state = 1_u64;
    (0..EVALUATIONS).map(move |i| {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        let mixed = state ^ (state >> 32);
        if i % 2 == 0 { (mixed >> 11) as f64 / (1_u64 << 46) as f64 - 64.0 } else { f64::from_bits(mixed) }
    })
}

fn hash<T: Bits>(f: impl Fn(f64) -> T) -> u64 {
    let mut hash = Hash::EMPTY;
    times().for_each(|t| f(t).hash(&mut hash));
    hash.0
}

macro_rules! hashes {
    ($($float:ident $output:ident { $($parameters:tt)* })*) => {{
        let mut lines = String::new();
        $({
            let f = pendulum!(float = $float, outputs = [$output], $($parameters)*);
            let asked = stringify!($float $output: $($parameters)*);
            let _ = writeln!(lines, "{:016x} {asked}", hash(|t| f(t as $float)));
        })*
        lines
    }};
}

fn generated() -> String {
    hashes! {
        f64 theta { theta0 = 7π/8 }
        f64 velocity { theta0 = 7π/8 }
        f64 acceleration { theta0 = 100deg }
        f64 position { theta0 = 2 }
        f64 theta { theta0 = 1, velocity0 = 1, omega = 2.5 }
        f64 theta { theta0 = 7π/8, tol = 1e-6, t_max = 1000 }
        f64 velocity { theta0 = 1e-6, tol = 1e-12, t_max = 100000 }
        f64 velocity { theta0 = 7π/8, tol = 1e-9, t_max = 1000 }
        f64 theta { theta0 = 7π/8, n = 4 }
        f64 velocity { theta0 = 7π/8, n = 4 }
        f64 acceleration { theta0 = 7π/8, n = 4 }
        f32 position { theta0 = -0.93π, n = 4 }
        f64 acceleration { theta0 = 2, method = series, tol = 1e-9 }
        f64 theta { theta0 = PI - 1e-7 }
        f64 velocity { theta0 = PI - 1e-5, omega = 3, velocity0 = 1e-6 }
        f64 acceleration { velocity0 = 2.0001 }
        f32 theta { theta0 = 0.93π, n = 4 }
        f64 theta { theta0 = 0.95π, tol = 1e-3, method = series }
        f64 velocity { theta0 = 0.95π, method = series }
        f64 theta { theta0 = 1, tol = 0.5, method = harmonic }
        f32 theta { theta0 = 7π/8 }
        f32 velocity { theta0 = 7π/8, tol = 1e-4, t_max = 100 }
        f32 position { theta0 = 2, tol = 1e-4 }
        f32 theta { theta0 = 7π/8, n = 4 }
        f64 theta { theta0 = 0.95π }
        f64 position { theta0 = 7π/8 }
        f32 acceleration { theta0 = 0.9π }
        f32 theta { theta0 = 0.999999π }
        f64 theta { theta0 = 7π/8, tol = 1e-3 }
        f64 velocity { theta0 = 1, velocity0 = 1, tol = 1e-9 }
        f64 wrapped { velocity0 = 2.5 }
        f32 wrapped { theta0 = 1, velocity0 = -3, tol = 1e-4 }
        f64 theta { velocity0 = 40, tol = 1e-9, t_max = 1000 }
        f64 wrapped { theta0 = 3.14159, tol = 1e-3 }
        f64 position { velocity0 = 2 }
        f32 wrapped { velocity0 = -2, tol = 1e-3 }
    }
}

/// The runtime, whose arithmetic follows the same rules.
fn runtime() -> String {
    let mut lines = String::new();
    for (theta, velocity, omega) in
        [(2.75, 0.0, 1.0), (1e-3, 0.0, 1.0), (1.0, 1.0, 2.5), (0.0, 2.0, 1.0), (0.5, 3.0, 1.0)]
    {
        let p = Pendulum::<f64>::from_state(theta, velocity, omega).expect("a valid state");
        let _ = writeln!(lines, "{:016x} Pendulum({theta}, {velocity}, {omega}).state", hash(|t| p.state(t)));
        let _ = writeln!(lines, "{:016x} Pendulum({theta}, {velocity}, {omega}).position", hash(|t| p.position(t)));
    }
    for theta0 in [1e-9, 0.3, 1.5, 2.7, 3.0, 3.13, core::f64::consts::PI] {
        let p = Pendulum::<f64>::new(theta0, 1.3).expect("a valid amplitude");
        let _ = writeln!(lines, "{:016x} Pendulum::<f64>::new({theta0}, 1.3)", motion(&p, |t| t));
    }
    for (theta, velocity) in [(0.4, 1.1), (-2.0, 0.9), (0.0, 2.6), (30.0, -2.03), (0.0, 2.1), (0.0, 2.0), (1.0, 40.0)] {
        let wide = Pendulum::<f64>::from_state(theta, velocity, 1.0).expect("a valid state");
        let narrow = Pendulum::<f32>::from_state(theta as f32, velocity as f32, 1.0).expect("a valid state");
        let hashes = [("f64", motion(&wide, |t| t)), ("f32", motion(&narrow, |t| t as f32))];
        for (float, hash) in hashes {
            let _ = writeln!(lines, "{hash:016x} Pendulum::<{float}>::from_state({theta}, {velocity}, 1)");
        }
    }
    for k in [0.1, 0.7, 0.93, 0.999] {
        let j = Jacobi::from_modulus(k).expect("in [0, 1]");
        let _ = writeln!(lines, "{:016x} Jacobi::from_modulus({k})", hash(|u| jacobi(&j, u)));
    }
    lines
}

/// All constants of a motion, and all its functions at times that `round` gives its type.
fn motion<F: Scalar + Bits>(p: &Pendulum<F>, round: impl Fn(f64) -> F) -> u64 {
    let mut hash = Hash::EMPTY;
    [p.period(), p.amplitude(), p.modulus(), p.nome(), p.complete_integral(), p.energy()].hash(&mut hash);
    [p.omega(), p.complementary_modulus(), p.complementary_integral()].hash(&mut hash);
    let paper = p.fourier::<5>().ok();
    paper.as_ref().map(Fourier::max_error).hash(&mut hash);
    for t in times().map(round) {
        p.position(t).hash(&mut hash);
        [p.theta(t), p.velocity(t), p.acceleration(t), p.wrapped(t), p.small_angle(t), p.harmonic(t)].hash(&mut hash);
        p.time_at(p.theta(t)).ok().hash(&mut hash);
        paper.as_ref().map(|paper| paper.theta(t)).hash(&mut hash);
    }
    hash.0
}

fn jacobi(j: &Jacobi, u: f64) -> [f64; 5] {
    let (sn, cn, dn) = j.sn_cn_dn(u);
    [sn, cn, dn, j.am(u), j.incomplete(u)]
}

#[test]
fn bits_are_the_same_everywhere() {
    let computed = format!("{}{}", generated(), runtime());
    if std::env::var_os("PENDULA_BLESS").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/bits/hashes.txt");
        return std::fs::write(path, &computed).expect("the file can be written");
    }
    let expected = include_str!("bits/hashes.txt");
    for (computed, expected) in computed.lines().zip(expected.lines().chain(std::iter::repeat("nothing"))) {
        assert_eq!(computed, expected, "if bits were meant to change, bless them: see the head of tests/bits.rs");
    }
    assert_eq!(computed.lines().count(), expected.lines().count());
}
