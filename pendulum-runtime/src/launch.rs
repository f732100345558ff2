//! From an initial state to a motion: which regime, how large, where in its period.

use crate::agm::agm_double;
use crate::angle::{Angle, reduce};
use crate::carlson::elapsed;
use crate::double::{Double, LARGEST, two_sum};
use crate::double_trig::{half_angle, half_angle_from_top};
use crate::error::{Error, finite};
use crate::kernel::four_atan;
use crate::motion::{Moduli, Motion, Shape};
use crate::phase::{Phase, unit_of};
use crate::rotation::Rotation;
use crate::swing::Swing;

/// Released at rest from `theta0`, |θ0| ≤ the last `f64` below π.
pub(crate) fn at_rest(theta0: f64, omega: f64) -> Result<Motion, Error> {
    finite("theta0", theta0)?;
    positive_rate(omega)?;
    if theta0.abs() > core::f64::consts::PI {
        return Err(Error::Amplitude { value: theta0 });
    }
    Ok(released(reduce(theta0), Double::ZERO, theta0, omega))
}

/// From any angle and velocity.
pub(crate) fn from_state(theta: f64, velocity: f64, omega: f64) -> Result<Motion, Error> {
    finite("theta", theta)?;
    finite("velocity", velocity)?;
    positive_rate(omega)?;
    // Both are taken in units of `unit_of(omega)` first, so that the division neither underflows nor overflows needlessly.
    let unit = unit_of(omega);
    let speed = 0.5 * (velocity.abs() / unit);
    if speed > 0.5 * LARGEST * (omega / unit) {
        return Err(Error::Velocity { value: velocity });
    }
    let start = reduce(theta);
    let Angle { angle, from_top } = start;
    let base = Double::new(theta) - angle;
    if speed == 0.0 {
        // At rest, or so slow that the motion it adds is below the smallest `f64`.
        return Ok(released(start, base, theta, omega));
    }
    let whole = omega / unit;
    let (slack, below) = two_sum(whole, -speed);
    let [speed, slack] = [Double::new(speed), Double { hi: slack, lo: below }].map(|x| x / Double::new(whole));
    let forward = velocity > 0.0;
    let state = State {
        angle: if forward { angle } else { -angle },
        from_top,
        speed,
        slack,
        base,
        direction: if forward { 1.0 } else { -1.0 },
        theta,
        velocity,
        omega,
    };
    Ok(state.launch())
}

fn positive_rate(omega: f64) -> Result<(), Error> {
    finite("omega", omega)?;
    if omega > 0.0 { Ok(()) } else { Err(Error::Frequency { value: omega }) }
}

/// At rest at `angle` from the vertical in [−π, π].
fn released(Angle { angle, from_top }: Angle, base: Double, theta: f64, omega: f64) -> Motion {
    let magnitude = angle.abs();
    let (k, kc) = half_angle_from_top(magnitude, from_top);
    let mean = agm_double(kc);
    Motion {
        shape: Shape::Swing(
            Swing::new(k, kc, mean.hi, magnitude.to_f64()),
            Phase::new(mean * Double::INVERSE_TURN, omega, Double::ZERO),
        ),
        base,
        direction: if angle.hi.is_sign_negative() { -1.0 } else { 1.0 },
        top_speed: top_speed(k, omega),
        amplitude: magnitude.to_f64(),
        k,
        moduli: Moduli { k, kc, mean },
        theta,
        velocity: 0.0,
        omega,
    }
}

/// A state in motion, mirrored so that it moves forward.
struct State {
    /// In [−π, π], and how far from the top.
    angle: Double,
    from_top: Double,
    /// |θ̇|/(2ω), and what it lacks of 1, as precise as itself.
    speed: Double,
    slack: Double,
    base: Double,
    direction: f64,
    theta: f64,
    velocity: f64,
    omega: f64,
}

impl State {
    fn launch(&self) -> Motion {
        let (sine, cosine) = half_angle_from_top(self.angle.abs(), self.from_top);
        let k = hypotenuse(self.speed, sine);
        let since_bottom = {
            let magnitude = elapsed(sine, cosine, self.speed, k);
            if self.angle.hi < 0.0 { -magnitude } else { magnitude }
        };
        // 1 − k² = cos²(θ/2) − (θ̇/2ω)², as a product so that nothing cancels but the difference itself, of the smaller
        // terms: through the lowest point there is none.
        let below =
            if cosine.hi > 0.5 { self.slack - sine * sine / (Double::ONE + cosine) } else { cosine - self.speed };
        let above = cosine + self.speed;
        if below.hi > 0.0 {
            self.swing(k, (below * above).sqrt(), since_bottom)
        } else if below.hi == 0.0 {
            self.separatrix(since_bottom)
        } else {
            self.rotation(k, ((-below / k) * (above / k)).sqrt(), since_bottom)
        }
    }

    fn swing(&self, k: Double, kc: Double, since_bottom: Double) -> Motion {
        let mean = agm_double(kc);
        let rate = mean * Double::INVERSE_TURN;
        // Rounded, but not below the angle of the start.
        let amplitude = amplitude(k, kc).max(self.angle.hi.abs());
        let offset = rate * since_bottom - Double::new(0.25);
        let shape = Shape::Swing(Swing::new(k, kc, mean.hi, amplitude), Phase::new(rate, self.omega, offset));
        self.motion(shape, amplitude, k, Moduli { k, kc, mean })
    }

    fn separatrix(&self, since_bottom: Double) -> Motion {
        let shape = Shape::Separatrix(Rotation::separatrix(), since_bottom);
        let moduli = Moduli { k: Double::ONE, kc: Double::ZERO, mean: Double::ZERO };
        self.motion(shape, core::f64::consts::PI, Double::ONE, moduli)
    }

    /// One turn takes T = 2κK(κ)/ω with κ = 1/k, so 1/T = ωk AGM(1, κ′)/π.
    fn rotation(&self, k: Double, kc: Double, since_bottom: Double) -> Motion {
        let mean = agm_double(kc);
        let rate = mean * k * Double::INVERSE_TURN.scale(2.0);
        let modulus = Double::ONE / k;
        let phase = Phase::new(rate, self.omega, rate * since_bottom);
        let shape = Shape::Rotation(Rotation::new(modulus.hi, kc.hi, mean.hi), phase);
        self.motion(shape, f64::INFINITY, k, Moduli { k: modulus, kc, mean })
    }

    fn motion(&self, shape: Shape, amplitude: f64, k: Double, moduli: Moduli) -> Motion {
        Motion {
            shape,
            base: self.base,
            direction: self.direction,
            top_speed: top_speed(k, self.omega),
            amplitude,
            k,
            moduli,
            theta: self.theta,
            velocity: self.velocity,
            omega: self.omega,
        }
    }
}

/// 2 arcsin k: an arctangent a, and by sin(A/2 − a/2) in two words what it misses.
fn amplitude(k: Double, kc: Double) -> f64 {
    let near = four_atan(k.hi, 1.0 + kc.hi);
    let (sine, cosine) = half_angle(Double::new(near));
    near + 2.0 * (k * cosine - kc * sine).to_f64()
}

/// 2ωk, within the finite numbers; scaled so that no product is split beyond 2⁹⁹⁶.
fn top_speed(k: Double, omega: f64) -> f64 {
    let unit = unit_of(omega);
    ((k * (2.0 * (omega / unit))).to_f64() * unit).min(f64::MAX)
}

/// √(a² + b²) without overflow or underflow.
pub(crate) fn hypotenuse(a: Double, b: Double) -> Double {
    let unit = unit_of(a.hi.max(b.hi));
    let (a, b) = (a.scale(1.0 / unit), b.scale(1.0 / unit));
    (a * a + b * b).sqrt().scale(unit)
}
