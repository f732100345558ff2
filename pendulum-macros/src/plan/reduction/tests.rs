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
        let linear = matches!(self.reduction.method, Method::Linear { .. });
        let halves = i64::from(self.reduction.origin == Origin::Lowest && !linear);
        let passed = &self.rate * &real(t) + &self.launch - context.ratio(halves, 2);
        // Beyond 2⁵³ anchors their number itself is rounded, its parity isn't.
        let number = if linear { context.integer(0) } else { (&passed - &computed).round() };
        let exact = passed - &number;
        let (error, phase) = ((computed - &exact).abs().to_f64(), exact.to_f64().abs());
        let promised = self.reduction.error + self.reduction.relative_error * phase;
        let about = || format!("{:?} at {t:e}, launched at {:e}", self.reduction, self.launch.to_f64());
        assert!(error <= promised * (1.0 + 1e-12), "{error:e} of {promised:e}: {}", about());
        assert!(remainder.abs() <= self.reduction.half(), "{remainder}: {}", about());
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

fn rate(random: &mut Random) -> Real {
    Context::for_digits(60).decimal(&format!("{:.17}123456789123456789", 0.05 + 3.0 * random.unit())).unwrap()
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
            let rate = rate(&mut random);
            let phase = context.decimal(launch).unwrap();
            let t_max = Some(horizon / rate.to_f64()).filter(|t| t.is_finite());
            let clock = Clock { rate: &rate, launch: phase.to_double(), t_max, float };
            let horizon = clock.horizon();
            for reduction in clock.reductions() {
                let key = (reduction.method.name(), reduction.origin == Origin::Lowest, float == Float::F32, launch);
                let mut trial = Trial { reduction, rate: rate.clone(), launch: phase.clone(), horizon, worst: 0.0 };
                trial.run(&mut random, 20);
                let worst = worst.entry(key).or_default();
                *worst = worst.max(trial.worst);
            }
        }
    }
    // Every way from every launch, but for the one that is only for none.
    assert_eq!(worst.len(), 17 * 4 + 2, "{worst:?}");
    for (way, worst) in worst {
        // Of any time, sums of several parts are rarely all at their worst; of three words the drift depends on the rate.
        let least = match way.0.as_str() {
            "AnyTime 3" => 0.02,
            "AnyTime 4" => 0.2,
            _ => 0.35,
        };
        assert!(worst > least, "{way:?}: of its error only {worst} was seen");
    }
}

/// The time itself, and the launch.
#[test]
fn the_separatrix() {
    let context = Context::for_digits(60);
    let mut random = Random::new(12);
    for float in [Float::F64, Float::F32] {
        for launch in ["0", "0.3", "-3.77777777777777777777", "50.123456789123456789123456789"] {
            let (rate, launch) = (rate(&mut random), context.decimal(launch).unwrap());
            let reduction = Clock { rate: &rate, launch: launch.to_double(), t_max: None, float }.linear();
            assert_eq!((reduction.origin, reduction.unit), (Origin::Lowest, Double::ONE));
            // Beyond the cap nothing moves.
            let cap = 2.0 * (700.0 + launch.to_f64().abs()) / rate.to_f64();
            assert_eq!(reduction.cap, Some(cap));
            let horizon = 60.0 / rate.to_f64();
            let mut trial = Trial { reduction, rate, launch, horizon, worst: 0.0 };
            trial.run(&mut random, 60);
            assert!(trial.worst > 0.25, "{float:?} {}: {}", trial.launch.to_f64(), trial.worst);
        }
    }
}

/// Which ways there are, by horizon: one word up to an eighth of 1.5·2⁵² (2²³) anchors, scaled ones while 8 bits are left for the
/// unit, Cody and Waite's up to 2³⁴ (2¹⁵).
#[test]
fn ways_of_each_horizon() {
    let context = Context::for_digits(60);
    let rate = context.decimal("0.7071067811865475244").unwrap();
    for (float, anchors, expected) in [
        (Float::F64, 1.7e10, "OneWord 0, Scaled 0, CodyWaite 2, CodyWaite 3, AnyTime 3, AnyTime 4"),
        (Float::F64, 1.8e10, "OneWord 0, Scaled 0, AnyTime 3, AnyTime 4"),
        (Float::F64, 3.5e13, "OneWord 0, Scaled 0, AnyTime 3, AnyTime 4"),
        (Float::F64, 3.6e13, "OneWord 0, AnyTime 3, AnyTime 4"),
        (Float::F64, 8.4e14, "OneWord 0, AnyTime 3, AnyTime 4"),
        (Float::F64, 8.5e14, "AnyTime 3, AnyTime 4"),
        (Float::F32, 3.2e4, "OneWord 0, Scaled 0, CodyWaite 2, CodyWaite 3, Wide 0, WideAnyTime 0"),
        (Float::F32, 3.3e4, "OneWord 0, Scaled 0, Wide 0, WideAnyTime 0"),
        (Float::F32, 6.6e4, "OneWord 0, Wide 0, WideAnyTime 0"),
        (Float::F32, 1.5e6, "OneWord 0, Wide 0, WideAnyTime 0"),
        (Float::F32, 1.6e6, "Wide 0, WideAnyTime 0"),
    ] {
        let t_max = Some(anchors / rate.to_f64());
        let ways = |launch| {
            let reductions = Clock { rate: &rate, launch, t_max, float }.reductions();
            // From the lowest point they come again.
            let mut ways: Vec<String> = Vec::new();
            for name in reductions.iter().map(|way| way.method.name()) {
                if !ways.contains(&name) {
                    ways.push(name);
                }
            }
            ways.join(", ")
        };
        assert_eq!(ways(Double::ZERO), expected, "{float:?} {anchors:e}");
        // A scaled unit is for no launch only.
        assert_eq!(ways(Double::new(0.25)), expected.replace("Scaled 0, ", ""), "{float:?} {anchors:e}");
    }
    // Words that would underflow are none.
    for (rate, float, there) in [
        ("1e270", Float::F64, false),
        ("1e240", Float::F64, true),
        ("1e26", Float::F32, false),
        ("1e15", Float::F32, true),
    ] {
        let rate = context.decimal(rate).unwrap();
        let clock = Clock { rate: &rate, launch: Double::ZERO, t_max: Some(100.0 / rate.to_f64()), float };
        let found = clock.reductions().iter().any(|way| matches!(way.method, Method::CodyWaite { .. }));
        assert_eq!(found, there, "{float:?} {:e}", rate.to_f64());
    }
}
