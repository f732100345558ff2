//! The exact motion by theta functions in multiple precision (*NIST Digital Library of Mathematical Functions*, ch. 20
//! and 22): nothing in common with the planner's Fourier series but K, K′ and q.

use crate::exact::{Context, Real};
use crate::motion::{Elliptic, Motion, Regime, Rotation, Separatrix, Swing};
use crate::parse::Output;

/// θ, θ̇ and what follows from them at one time.
pub(crate) struct State {
    theta: Real,
    /// θ less its turns.
    wrapped: Real,
    velocity: Real,
    omega: Real,
}

impl State {
    pub(crate) fn at(motion: &Motion, t: f64) -> Self {
        let context = motion.omega.context();
        let t = context.float(t).expect("a finite time");
        match &motion.regime {
            Regime::Swing(swing) => swung(swing, &motion.omega, &t),
            Regime::Rotation(rotation) => rotated(rotation, &motion.omega, &t),
            Regime::Separatrix(separatrix) => passed(separatrix, &motion.omega, &t),
        }
    }

    pub(in crate::plan) fn output(&self, output: Output) -> Vec<Real> {
        let square = self.omega.square();
        match output {
            Output::Theta => vec![self.theta.clone()],
            Output::Wrapped => vec![self.wrapped.clone()],
            Output::Velocity => vec![self.velocity.clone()],
            Output::Acceleration => vec![-(square * self.wrapped.sin())],
            Output::Position => {
                let (sin, cos) = self.wrapped.sin_cos();
                vec![sin, -cos]
            }
        }
    }
}

/// n = round(x) and x − n.
fn split(x: &Real) -> (Real, Real) {
    let n = x.round();
    let rest = x - &n;
    (n, rest)
}

fn is_odd(n: &Real) -> bool {
    !split(&n.scale(-1)).1.is_zero()
}

fn signed(x: Real, negative: bool) -> Real {
    if negative { -x } else { x }
}

/// θ = 4 atan(S/C), S = Σ 2h^(n²) cos nx over odd n, C = 1 + Σ 2h^(n²) cos nx over even n, h = √q; where q > 1/20 their
/// duals in h = √q′ and y = πu/(2K′), 4 atan((C − S)/(C + S)). θ̇² = 4ω²(k² − sin²(θ/2)).
fn swung(swing: &Swing, omega: &Real, t: &Real) -> State {
    let context = omega.context();
    let rate = context.integer(2) / &swing.period;
    let (n, s) = split(&(rate * t + &swing.launch));
    let elliptic = &swing.elliptic;
    let quotient = if elliptic.nome.to_f64() < 0.05 {
        let x = &s * &context.pi();
        let [odd, even] = sums(&elliptic.nome.sqrt(), |n| (&x * &context.integer(n)).sin_cos().1);
        odd.atan2(&even)
    } else {
        let y = &s * &(context.pi() * &elliptic.quarter / &elliptic.quarter_complementary);
        let rising = y.exp();
        let falling = context.integer(1) / &rising;
        let cosh = |n: i64| (rising.power(n as usize) + falling.power(n as usize)).scale(-1);
        let [odd, even] = sums(&elliptic.nome_complementary().sqrt(), cosh);
        (&even - &odd).atan2(&(even + odd))
    };
    let theta = quotient.scale(2);
    let kinetic = elliptic.modulus.square() - theta.scale(-1).sin().square();
    let speed = if kinetic.is_negative() { context.integer(0) } else { kinetic.sqrt() } * omega;
    let falls = !s.is_negative();
    let flip = is_odd(&n) ^ swing.mirrored;
    let theta = signed(theta, flip);
    State { wrapped: theta.clone(), theta, velocity: signed(speed.scale(1), falls ^ flip), omega: omega.clone() }
}

/// Σ 2h^(n²) f(n) over odd n, and 1 + the same over even n.
fn sums(h: &Real, f: impl Fn(i64) -> Real) -> [Real; 2] {
    let context = h.context();
    let mut sums = [context.integer(0), context.integer(1)];
    for n in 1.. {
        let term = h.power((n * n) as usize).scale(1) * f(n);
        if term.abs() < sums[1].abs() * context.power_of_two(-300) && n > 2 {
            break;
        }
        let index = usize::from(n % 2 == 0);
        sums[index] = &sums[index] + &term;
    }
    sums
}

/// θ = 2 am(u; κ) + 2πn by tan am = ϑ₃(0)ϑ₁(z)/(ϑ₄(0)ϑ₂(z)), z = πu/(2K), or by Jacobi's imaginary transformation.
/// θ̇² = v₀² − 4ω² sin²(θ/2) = (κ′v₀)² + 4ω² cos²(θ/2), where nothing cancels.
fn rotated(rotation: &Rotation, omega: &Real, t: &Real) -> State {
    let context = omega.context();
    let (n, s) = split(&(t / &rotation.period + &rotation.launch));
    let elliptic = &rotation.elliptic;
    let half = amplitude(elliptic, &s);
    let angle = half.scale(1);
    let theta = &angle + &(n * context.pi().scale(1));
    let slowest = &rotation.fastest * &elliptic.complementary;
    let kinetic = slowest.square() + (half.sin_cos().1 * omega).square().scale(2);
    let velocity = signed(kinetic.sqrt(), rotation.mirrored);
    State {
        theta: signed(theta, rotation.mirrored),
        wrapped: signed(angle, rotation.mirrored),
        velocity,
        omega: omega.clone(),
    }
}

/// am(2K·s; κ) for |s| ≤ ½.
fn amplitude(elliptic: &Elliptic, s: &Real) -> Real {
    let context = s.context();
    let one = context.integer(1);
    // ϑ₁(z), ϑ₂(z), ϑ₃(0), ϑ₄(0) of q; with z = iy, ϑ₁(iy)/i, ϑ₄(iy), ϑ₃(0), ϑ₂(0) of q′.
    let direct = elliptic.nome.to_f64() < 0.05;
    let nome = &if direct { elliptic.nome.clone() } else { elliptic.nome_complementary() };
    let root = nome.sqrt().sqrt();
    let (mut sine, mut cosine) = (context.integer(0), if direct { context.integer(0) } else { one.clone() });
    let (mut third, mut other) = (one.clone(), if direct { one.clone() } else { context.integer(0) });
    let z = s * &context.pi();
    let y = &z * &(&elliptic.quarter / &elliptic.quarter_complementary);
    let rising = y.exp();
    let falling = &one / &rising;
    for n in 0..200i64 {
        let negative = n % 2 == 1;
        let (half_power, power) = (root.power(((2 * n + 1) * (2 * n + 1)) as usize), nome.power((n * n) as usize));
        let odd = (2 * n + 1) as usize;
        if direct {
            let (sin, cos) = (&z * &context.integer(2 * n + 1)).sin_cos();
            sine = sine + signed(&half_power * &sin, negative);
            cosine = cosine + &half_power * &cos;
        } else {
            let sinh = rising.power(odd) - falling.power(odd);
            sine = sine + signed(&half_power * &sinh.scale(-1), negative);
            other = other + half_power.scale(1);
            if n > 0 {
                let even = (2 * n) as usize;
                cosine = cosine + signed(&power * &(rising.power(even) + falling.power(even)), negative);
            }
        }
        if n > 0 {
            third = third + power.scale(1);
            if direct {
                other = other + signed(power.scale(1), negative);
            }
        }
        if n > 3 && power.exponent_above() < -700 {
            break;
        }
    }
    let (top, bottom) =
        if direct { (third * &sine, other * &cosine) } else { (third * sine.scale(1), other * &cosine) };
    let bottom = if bottom.is_negative() { context.integer(0) } else { bottom };
    top.atan2(&bottom)
}

/// θ = 4 atan tanh(z/2), z = ωt + launch, and θ̇ = 2ω sech z.
fn passed(separatrix: &Separatrix, omega: &Real, t: &Real) -> State {
    let context = omega.context();
    let z = omega * t + &separatrix.launch;
    let one = context.integer(1);
    let far = z.exponent_above() > 12;
    let e = if far { context.integer(0) } else { (-z.abs()).exp() };
    let theta = (&one - &e).atan2(&(&one + &e)).scale(2);
    let theta = signed(theta, z.is_negative() ^ separatrix.mirrored);
    let velocity = (omega * &e).scale(2) / (one + e.square());
    let velocity = signed(velocity, separatrix.mirrored);
    State { wrapped: theta.clone(), theta, velocity, omega: omega.clone() }
}

/// √Σ(value − exact)².
pub(in crate::plan) fn distance(context: Context, values: &[f64], exact: &[Real]) -> f64 {
    let square = |(value, exact): (&f64, &Real)| {
        let Some(value) = context.float(*value) else { return context.power_of_two(4000) };
        (value - exact).square()
    };
    let sum = values.iter().zip(exact).map(square).fold(context.integer(0), |sum, square| sum + square);
    sum.sqrt().to_f64()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::scene;

    /// The two series for each regime meet where either serves.
    #[test]
    fn agrees_with_the_state_at_zero() {
        for text in [
            "theta0 = 1e-9",
            "theta0 = 1",
            "theta0 = 7π/8",
            "theta0 = π - 1e-30",
            "theta0 = 1, velocity0 = -1/3",
            "theta0 = -3, velocity0 = 0.1",
            "theta0 = 1, velocity0 = 3, omega = 1.5",
            "theta0 = -2, velocity0 = -2",
            "theta0 = 2, velocity0 = 5",
            "theta0 = 3, velocity0 = -0.2",
            "velocity0 = 2",
            "theta0 = π/2, velocity0 = -sqrt(2)",
        ] {
            let scene = scene(text);
            let motion = &scene.motion;
            let state = State::at(motion, 0.0);
            let off = [(&state.theta, &motion.theta0), (&state.velocity, &motion.velocity0)]
                .map(|(found, given)| (found - given).abs().to_f64() / (given.abs().to_f64() + 1e-9));
            // The square root of the kinetic energy halves the digits where it vanishes.
            assert!(off[0] < 1e-80 && off[1] < 1e-40, "{text}: {off:?}");
        }
    }

    /// A step of the equation of motion by Taylor's series of sixth order.
    #[test]
    fn moves_by_the_equation_of_motion() {
        for text in ["theta0 = 3", "theta0 = 1, velocity0 = 1", "theta0 = 1, velocity0 = -3", "velocity0 = -2"] {
            let scene = scene(text);
            let h = 2f64.powi(-20);
            for t in [0.0, 0.7, -2.0, 11.3, 1e6] {
                let [before, here, after] = [t - h, t, t + h].map(|t| State::at(&scene.motion, t));
                // (θ₊ − 2θ + θ₋)/h² = θ̈ + h²θ⁗/12, |θ⁗| < 10.
                let second = (before.theta.clone() + &after.theta - here.theta.scale(1)).to_f64() / (h * h);
                let first = (after.theta - before.theta).to_f64() / (2.0 * h);
                assert!((second - here.output(Output::Acceleration)[0].to_f64()).abs() < h * h, "{text} {t}");
                assert!((first - here.velocity.to_f64()).abs() < h * h, "{text} {t}");
            }
        }
    }
}
