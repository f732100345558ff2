//! Every reduction against the exact phase, over horizons of all lengths: its error is what it promises, and not much less.

use super::*;
use crate::exact::{Context, Real};
use crate::fuzz::random::Random;
use crate::program::Program;
use std::collections::BTreeMap;

/// A reduction as a program of the time: the remainder, the sum whose parity counts, and the number of origins passed.
struct Trial {
    reduction: Reduction,
    rate: Real,
    launch: Real,
    horizon: f64,
    /// The largest error found, over what is promised there.
    worst: f64,
}

impl Trial {
    fn program(&self) -> Program {
        let mut b = Builder::new(self.reduction.float);
        let t = b.input();
        let phase = self.reduction.lower(&mut b, t);
        b.finish(vec![phase.remainder, phase.magic, phase.count])
    }

    /// Compares at `t` rounded to the type of times.
    fn at(&mut self, program: &Program, t: f64) {
        let t = self.reduction.float.round(t.clamp(-self.horizon, self.horizon));
        if t.abs() > self.horizon {
            return;
        }
        let context = self.rate.context();
        let real = |x: f64| context.float(x).expect("finite");
        let run = program.run(t);
        let (remainder, count) = (run[0], run[2]);
        let computed = real(remainder) * self.reduction.unit.to_real(context);
        let half = context.ratio(1, 2);
        let from = if self.reduction.origin == Origin::Lowest { half } else { context.integer(0) };
        let passed = &self.rate * &real(t) + &self.launch - from;
        let linear = matches!(self.reduction.method, Method::Linear { .. });
        // Beyond 2⁵³ anchors their number itself is rounded, its parity isn't.
        let number = if linear { context.integer(0) } else { (&passed - &computed).round() };
        let exact = passed - &number;
        let (error, phase) = ((computed - &exact).abs().to_f64(), exact.to_f64().abs());
        let promised = self.reduction.error + self.reduction.relative_error * phase;
        let about = || format!("{:?} at {t:e}, launched at {:e}", self.reduction, self.launch.to_f64());
        assert!(error <= promised * (1.0 + 1e-12), "{error:e} of {promised:e}: {}", about());
        assert!(
            remainder.abs() <= (0.5 + self.reduction.overshoot) / self.reduction.unit.hi * (1.0 + 1e-6),
            "{remainder}: {}",
            about()
        );
        assert!(
            remainder.abs() <= self.reduction.half() * (1.0 + 1e-6) || self.reduction.overshoot == 0.0,
            "{}",
            about()
        );
        if !linear {
            let narrow = self.reduction.float == Float::F32 && !self.is_wide();
            let bits = if narrow { u64::from((run[1] as f32).to_bits()) } else { run[1].to_bits() };
            let odd = !(number.scale(-1) - number.scale(-1).round()).is_zero();
            assert_eq!(bits & 1 == 1, odd, "{count}: {}", about());
            let off = (number - real(count)).abs().to_f64();
            assert!(off <= (count.abs() * 2f64.powi(-53)).floor(), "{count}: {}", about());
        }
        self.worst = self.worst.max(error / promised);
    }

    fn is_wide(&self) -> bool {
        matches!(self.reduction.method, Method::Wide { .. } | Method::WideAnyTime { .. })
    }

    fn run(&mut self, random: &mut Random, count: usize) {
        let program = self.program();
        let rate = self.rate.to_f64();
        for sign in [1.0, -1.0] {
            self.at(&program, sign * self.horizon);
            self.at(&program, sign * 1e-300);
            for _ in 0..count {
                let far = sign * self.horizon * (1.0 - 0.1 * random.unit());
                self.at(&program, far);
                self.at(&program, sign * self.horizon * 10f64.powf(-12.0 * random.unit()));
                // Beside an origin, and half-way between two, at the end and at the beginning of the horizon.
                for far in [far * rate, 8.0 * random.unit() * sign] {
                    let nearest = (far * 2.0).round() / 2.0;
                    self.at(&program, (nearest - self.launch.to_f64() % 1.0 + (random.unit() - 0.5) * 1e-3) / rate);
                }
            }
        }
    }
}

trait ToReal {
    fn to_real(self, context: Context) -> Real;
}

impl ToReal for Double {
    fn to_real(self, context: Context) -> Real {
        context.float(self.hi).expect("finite") + context.float(self.lo).expect("finite")
    }
}

impl Method {
    fn name(&self) -> String {
        let words = if let Self::CodyWaite { words, .. } | Self::AnyTime { words } = self { words.len() } else { 0 };
        let name = format!("{self:?}");
        format!("{} {words}", name.split(' ').next().unwrap_or_default())
    }
}

/// For horizons of less than an anchor, of 2⁵⁴, and between; launched on an anchor, between two, and elsewhere.
#[test]
fn errors_are_those_promised() {
    let context = Context::for_digits(60);
    let mut random = Random::new(11);
    let mut worst: BTreeMap<_, f64> = BTreeMap::new();
    for (horizon, float) in
        [0.3, 30.0, 3e3, 1e6, 1e10, f64::INFINITY].map(|h| [(h, Float::F64), (h, Float::F32)]).concat()
    {
        for launch in ["0", "0.5", "0.3", "-3.77777777777777777777"] {
            let rate = context.decimal(&format!("{:.17}123456789123456789", 0.05 + 3.0 * random.unit())).unwrap();
            let launch = context.decimal(launch).unwrap();
            let t_max = Some(horizon / rate.to_f64()).filter(|t| t.is_finite());
            let clock = Clock { rate: &rate, launch: launch.to_double(), t_max, float };
            let horizon = clock.horizon();
            for reduction in clock.reductions() {
                let key = (reduction.method.name(), reduction.origin == Origin::Lowest, float == Float::F32);
                let mut trial = Trial { reduction, rate: rate.clone(), launch: launch.clone(), horizon, worst: 0.0 };
                trial.run(&mut random, 20);
                let worst = worst.entry(key).or_default();
                *worst = worst.max(trial.worst);
            }
        }
    }
    assert_eq!(worst.len(), 19, "{worst:?}");
    for (way, worst) in worst {
        // Of three words the third part's rounding is rarely as large as it might be.
        assert!(worst > if way.0 == "AnyTime 3" { 0.15 } else { 0.5 }, "{way:?}: of its error only {worst} was seen");
    }
}
