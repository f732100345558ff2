//! Every reduction against the exact phase, over horizons of all lengths: its error is what it promises, and not much
//! less.

use super::*;
use crate::exact::{Context, Real};
use crate::program::Program;
use crate::testing::Random;
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
        phase(&self.reduction)
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
        let linear = self.reduction.is_linear();
        let halves = i64::from(self.reduction.origin == Origin::Lowest && !linear);
        let passed = &self.rate * &real(t) + &self.launch - context.ratio(halves, 2);
        // Beyond 2⁵³ anchors their number itself is rounded, its parity isn't.
        let power = self.reduction.pieces.log2() as i64;
        let number = if linear { context.integer(0) } else { (&passed - &computed).scale(power).round().scale(-power) };
        let exact = passed - &number;
        let (error, phase) = ((computed - &exact).abs().to_f64(), exact.to_f64().abs());
        let promised = self.reduction.error + self.reduction.relative_error * phase;
        let about = || format!("{:?} at {t:e}, launched at {:e}", self.reduction, self.launch.to_f64());
        assert!(error <= promised * (1.0 + 1e-12), "{error:e} of {promised:e}: {}", about());
        assert!(remainder.abs() <= self.reduction.half(), "{remainder}: {}", about());
        if !linear {
            let narrow = self.reduction.float == Float::F32 && !self.is_wide();
            let bits = if narrow { u64::from((run[1] as f32).to_bits()) } else { run[1].to_bits() };
            // Modulo two anchors, in pieces of one.
            let anchors = number.scale(-1) - number.scale(-1).round();
            let residue = (anchors.to_f64() * 2.0 * self.reduction.pieces) as i64;
            let modulus = 2 * self.reduction.pieces as i64;
            assert_eq!((bits as i64 - residue) % modulus, 0, "{count}: {}", about());
            // Pieces are counted from a lowest point.
            let in_pieces = self.reduction.counts_pieces();
            let off = (number - context.ratio(i64::from(in_pieces), 2) - real(count)).abs().to_f64();
            // The multiple of 8 and the rest, and where numbers don't begin with 0 the first besides.
            let first = self.reduction.first_number();
            let sums = if first == 0.0 && !in_pieces { 1.0 } else { 2.0 };
            let rounded =
                ((count.abs() + first.abs()) * self.reduction.pieces * 2f64.powi(-53)).floor() / self.reduction.pieces;
            assert!(off <= sums * rounded, "{off}, {count}: {}", about());
        }
        self.worst = self.worst.max(error / promised);
    }

    fn is_wide(&self) -> bool {
        matches!(self.reduction.scheme, Scheme::Wide { .. } | Scheme::WideAnyTime { .. })
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

/// The remainder, the sum whose parity counts, and the number of origins passed, as a program of the time.
fn phase(reduction: &Reduction) -> Program {
    let mut b = Builder::new(reduction.float);
    let t = b.input();
    let Phase { remainder, magic, count } = reduction.lower(&mut b, t);
    b.finish(vec![remainder, magic, count])
}

trait ToReal {
    fn to_real(self, context: Context) -> Real;
}

impl ToReal for Double {
    fn to_real(self, context: Context) -> Real {
        context.float(self.hi).expect("finite") + context.float(self.lo).expect("finite")
    }
}

impl Scheme {
    pub(super) fn name(&self) -> String {
        let words = match self {
            Self::CodyWaite { words, .. } | Self::AnyTime { words, .. } | Self::WideAnyTime { words } => words.len(),
            _ => 0,
        };
        let twice = if matches!(self, Self::AnyTime { doubled: true, .. }) { " doubled" } else { "" };
        let name = format!("{self:?}");
        format!("{} {words}{twice}", name.split(' ').next().unwrap_or_default())
    }
}

pub(super) fn rate(random: &mut Random) -> Real {
    Context::for_digits(60).decimal(&format!("{:.17}123456789123456789", 0.05 + 3.0 * random.unit())).unwrap()
}

/// A launch from the lowest point is a number of pieces, which the constant that rounds has anyway.
#[test]
fn halves_cost_pieces_nothing() {
    let rate = rate(&mut Random::new(12));
    for (horizon, float) in [30.0, f64::INFINITY].map(|h| [(h, Float::F64), (h, Float::F32)]).concat() {
        let operations = |launch: f64| {
            let clock = Clock { rate: &rate, launch: Double::new(launch), horizon, float };
            let in_pieces = clock.reductions().iter().find_map(|reduction| reduction.in_pieces(64));
            in_pieces.unwrap().operations()
        };
        let on_anchor = operations(0.0);
        assert_eq!([0.5, -0.5].map(operations), [on_anchor; 2]);
        assert!(operations(0.3) > on_anchor);
    }
}

/// For horizons of less than an anchor, of 2⁵⁴, and between; launched on an anchor, between two, and elsewhere.
#[test]
fn errors_are_those_promised() {
    let context = Context::for_digits(60);
    let mut random = Random::new(11);
    let (mut worst, mut in_pieces): (BTreeMap<_, f64>, _) = (BTreeMap::new(), 0);
    for (horizon, float) in
        [0.3, 30.0, 3e3, 1e6, 1e10, f64::INFINITY].map(|h| [(h, Float::F64), (h, Float::F32)]).concat()
    {
        for launch in ["0", "0.5", "0.3", "-3.77777777777777777777"] {
            let rate = rate(&mut random);
            let phase = context.decimal(launch).unwrap();
            let horizon = horizon / rate.to_f64();
            let clock = Clock { rate: &rate, launch: phase.to_double(), horizon, float };
            let horizon = clock.reach();
            for reduction in clock.reductions() {
                // Little beyond half an anchor but what the phase is wrong by.
                assert!(reduction.overshoot <= 4.0 * reduction.error + 0.01, "{reduction:?}");
                // The same, from the nearest of the pieces of an anchor.
                for reduction in [2, 32].into_iter().filter_map(|pieces| reduction.in_pieces(pieces)) {
                    let mut trial = Trial { reduction, rate: rate.clone(), launch: phase.clone(), horizon, worst: 0.0 };
                    trial.run(&mut Random::new(in_pieces), 20);
                    in_pieces += 1;
                }
                let widened = reduction.half() * reduction.unit.hi / (0.5 + reduction.overshoot);
                assert!(
                    (1.0 - 1e-15..1.0 + 8.0 * float.rounding_unit()).contains(&widened),
                    "{reduction:?}: {widened}"
                );
                let key = (reduction.scheme.name(), reduction.origin == Origin::Lowest, float == Float::F32, launch);
                let mut trial = Trial { reduction, rate: rate.clone(), launch: phase.clone(), horizon, worst: 0.0 };
                trial.run(&mut random, 60);
                let worst = worst.entry(key).or_default();
                *worst = worst.max(trial.worst);
            }
        }
    }
    assert!(in_pieces > 120, "{in_pieces}");
    // Every way from every launch, but for the one that is only for none, and the one only for those in mid-motion.
    assert_eq!(worst.len(), 20 * 4 + 2 + 2, "{worst:?}");
    for (way, worst) in worst {
        // Sums of several parts are rarely all at their worst, nor are three differences.
        let least = match way.0.as_str() {
            "AnyTime 2" | "AnyTime 3" | "AnyTime 4" | "AnyTime 4 doubled" => 0.2,
            "CodyWaite 3" => 0.3,
            _ => 0.35,
        };
        assert!(worst > least, "{way:?}: of its error only {worst} was seen");
    }
}

/// Just beyond half an anchor, where numbers are twice as far apart as just inside, which times at random hardly ever
/// meet: of rates made for it.
#[test]
fn remainders_just_beyond_half_an_anchor() {
    let context = Context::for_digits(60);
    let mut random = Random::new(14);
    for (float, launch, name, least) in [
        (Float::F64, "0", "AnyTime 4", 0.75),
        (Float::F64, "0.3", "AnyTime 4", 0.2),
        (Float::F64, "0.3", "AnyTime 4 doubled", 0.2),
        (Float::F32, "0.3", "Wide 0", 0.9),
    ] {
        let launch = context.decimal(launch).unwrap();
        let mut worst: f64 = 0.0;
        for _ in 0..2000 {
            let t = float.round(2f64.powf(24.0 + 2.0 * random.unit()));
            let beyond = 3.0 * random.unit() * float.rounding_unit();
            let phase = (t * (0.1 + 0.3 * random.unit())).floor() + 0.5;
            let passed = context.float(phase).unwrap() + context.float(beyond).unwrap();
            let rate = (passed - &launch) / context.float(t).unwrap();
            let clock = Clock { rate: &rate, launch: launch.to_double(), horizon: t, float };
            let way = |way: &Reduction| way.origin == Origin::Anchor && way.scheme.name() == name;
            let reduction = clock.reductions().into_iter().find(way).unwrap();
            let mut trial = Trial { reduction, rate: rate.clone(), launch: launch.clone(), horizon: t, worst };
            let program = trial.program();
            for t in [t, -t] {
                trial.at(&program, t);
            }
            worst = trial.worst;
        }
        assert!(worst > least, "{float:?} {name}: of its error only {worst} was seen");
    }
}

/// Next to the lowest point, where what is relative to the remainder is next to nothing: at the end of the longest horizon,
/// of rates made for it.
#[test]
fn remainders_next_to_the_lowest_point() {
    let context = Context::for_digits(60);
    let mut random = Random::new(15);
    let mut worst: f64 = 0.0;
    for _ in 0..20_000 {
        let launch = context.float(random.unit()).unwrap() + context.float(random.unit() * 2f64.powi(-54)).unwrap();
        let t = (2f64.powi(53) * (1.0 + random.unit())).floor();
        let number = context.float((t * (0.3 + 0.6 * random.unit())).floor()).unwrap();
        let beside = context.float((random.unit() - 0.5) * 1e-22).unwrap();
        let rate = (number + context.ratio(1, 2) + beside - &launch) / context.float(t).unwrap();
        let clock = Clock { rate: &rate, launch: launch.to_double(), horizon: f64::INFINITY, float: Float::F64 };
        let horizon = clock.reach();
        let reduction = clock.any_time(4, Origin::Lowest, true);
        let mut trial = Trial { reduction, rate: rate.clone(), launch: launch.clone(), horizon, worst };
        let program = trial.program();
        trial.at(&program, t);
        worst = trial.worst;
    }
    assert!(worst > 0.4, "of its error only {worst} was seen");
}

/// What a launch is off an origin by is never lost, nor are few digits taken for none.
#[test]
fn launches_hardly_off_an_origin() {
    let context = Context::for_digits(60);
    let mut random = Random::new(13);
    for (launch, float) in ["0.50000000000000000001", "-0.00000000000000000001", "0.25", "0.507", "-0.0007"]
        .into_iter()
        .flat_map(|launch| [(launch, Float::F64), (launch, Float::F32)])
    {
        let (rate, phase) = (rate(&mut random), context.decimal(launch).unwrap());
        let clock = Clock { rate: &rate, launch: phase.to_double(), horizon: 1e3, float };
        for reduction in clock.reductions() {
            let mut trial = Trial { reduction, rate: rate.clone(), launch: phase.clone(), horizon: 1e3, worst: 0.0 };
            trial.run(&mut random, 10);
        }
    }
}

/// Beyond the horizon any phase will do, be it infinite, which is clamped; but it has to be one, however fast the
/// motion. At infinite times there is none.
#[test]
fn every_finite_time_has_a_phase() {
    let context = Context::for_digits(60);
    for (float, most) in [(Float::F64, f64::MAX), (Float::F32, f64::from(f32::MAX))] {
        for rate in ["0.2", "0.3", "0.6", "123456.7", "1e20"] {
            for launch in [0.0, 0.5, 0.3] {
                let rate = context.decimal(rate).unwrap();
                let clock = Clock { rate: &rate, launch: Double::new(launch), horizon: 10.0 / rate.to_f64(), float };
                for reduction in clock.reductions() {
                    let program = phase(&reduction);
                    for sign in [1.0, -1.0] {
                        assert!(!program.run(sign * most)[0].is_nan(), "{:e}: {reduction:?}", rate.to_f64());
                        assert!(program.run(sign * f64::INFINITY)[0].is_nan(), "{:e}: {reduction:?}", rate.to_f64());
                    }
                }
            }
        }
    }
}

/// Of releases from rest at any time: what is rounded by constants of the sign of the time is odd, and the bits that
/// count anchors are the same.
#[test]
fn negative_times_mirror() {
    let context = Context::for_digits(60);
    let mut random = Random::new(17);
    let mut count = 0;
    for (float, largest) in [(Float::F64, 1023.99), (Float::F32, 127.99)] {
        for (rate, horizon) in [("0.3", 100.0), ("1.7", f64::INFINITY), ("1e20", f64::INFINITY)] {
            let rate = context.decimal(rate).unwrap();
            let clock = Clock { rate: &rate, launch: Double::ZERO, horizon: horizon / rate.to_f64(), float };
            let released = clock.reductions().into_iter().map(Reduction::released);
            for reduction in released.filter(|reduction| reduction.mirror == Mirror::Sign) {
                count += 1;
                assert_eq!(reduction.in_pieces(4).map_or(Mirror::Magnitude, |pieces| pieces.mirror), Mirror::Magnitude);
                let [program, of_magnitude] = [true, false].map(|signs| phase(&reduction.with_signs(signs)));
                for _ in 0..5000 {
                    let t = float.round(2f64.powf(-60.0 + (largest + 60.0) * random.unit().powi(2)));
                    let (after, before) = (program.run(t), program.run(-t));
                    let about = || format!("{reduction:?} at {t:e}");
                    // But for the sign of nought.
                    assert_eq!(before.iter().map(|x| -x).collect::<Vec<_>>(), after, "{}", about());
                    assert_eq!(of_magnitude.run(-t), after, "{}", about());
                }
            }
        }
    }
    assert!(count > 20, "{count}");
}

/// What is divided by poles as it comes relies on it.
#[test]
fn remainders_that_leap() {
    let context = Context::for_digits(60);
    let mut random = Random::new(15);
    let mut count = 0;
    for (float, largest) in [(Float::F64, 1023.99), (Float::F32, 127.99)] {
        for rate in ["0.2345678901234567891", "1.3", "123456.7", "1e20"] {
            let rate = context.decimal(rate).unwrap();
            let clock = Clock { rate: &rate, launch: Double::ZERO, horizon: 100.0 / rate.to_f64(), float };
            for reduction in clock.reductions().into_iter().filter(Reduction::leaps) {
                count += 1;
                let program = phase(&reduction);
                let wide = matches!(reduction.scheme, Scheme::Wide { .. });
                let least = f64::from(if wide { Float::F64 } else { float }.bits()) - 4.0;
                let mut beyond = 0;
                for _ in 0..20_000 {
                    let exponent = least + (largest - least) * random.unit().powi(8);
                    let t = float.round(2f64.powf((exponent - libm::log2(rate.to_f64())).min(largest)));
                    let s = program.run(if random.unit() < 0.5 { -t } else { t })[0] * reduction.unit.hi;
                    assert!(s.abs() <= 0.5 || (1.0..f64::INFINITY).contains(&s.abs()), "{s} at {t:e}: {reduction:?}");
                    beyond += u32::from(s.abs() >= 1.0);
                }
                assert!(beyond > 100, "{beyond}: {reduction:?}");
            }
        }
    }
    assert_eq!(count, 4 + 4 + 3);
}

/// The time itself, and the launch.
#[test]
fn the_separatrix() {
    let context = Context::for_digits(60);
    let mut random = Random::new(12);
    for float in [Float::F64, Float::F32] {
        let launches = ["0", "0.3", "-3.77777777777777777777", "50.123456789123456789123456789"];
        let rates = [None, Some("1.2345678901234567890123e-306"), Some("9.87654321e295")];
        let rates = if float == Float::F64 { &rates[..] } else { &rates[..1] };
        for (launch, given) in launches.into_iter().flat_map(|launch| rates.iter().map(move |&rate| (launch, rate))) {
            let rate = given.map_or_else(|| rate(&mut random), |rate| context.decimal(rate).unwrap());
            let launch = context.decimal(launch).unwrap();
            let reduction = Clock { rate: &rate, launch: launch.to_double(), horizon: f64::INFINITY, float }.linear();
            assert_eq!((reduction.origin, reduction.unit), (Origin::Lowest, Double::ONE));
            // No farther than the horizon.
            let short = Clock { rate: &rate, launch: launch.to_double(), horizon: 3.0 / rate.to_f64(), float };
            let excess = short.linear().half() / (3.0 + launch.to_f64().abs()) - 1.0;
            assert!(excess > 0.0 && excess < 20.0 * float.rounding_unit(), "{excess:e}");
            // Beyond that nothing moves; no time is so late for a motion that is slow enough.
            let latest = reduction.half() / rate.to_f64();
            assert!(reduction.half() == 620.0 || reduction.half() < 620.0 && latest > 0.9 * float.largest());
            let horizon = 60.0 / rate.to_f64();
            let mut trial = Trial { reduction, rate, launch, horizon, worst: 0.0 };
            trial.run(&mut random, 60);
            // Where the product underflows it has no digits left to be relative to.
            let (program, tiny) = (trial.program(), if float == Float::F64 { 1.5e-323 } else { 1.2345e-44 });
            trial.at(&program, tiny);
            assert!(trial.worst > 0.25, "{float:?} {}: {}", trial.launch.to_f64(), trial.worst);
        }
    }
}

/// A rate that is a number of the type isn't rounded, nor is a product with a power of two; 2.1 is
/// off by 0.2 of a unit at least.
#[test]
fn what_the_separatrix_rounds() {
    let context = Context::for_digits(60);
    for (float, rate, launch, expected) in [
        (Float::F64, "2.5", "0", 1.0..1.01),
        (Float::F64, "0.25", "0", 0.0..0.01),
        (Float::F64, "2.1", "0", 1.2..2.01),
        (Float::F64, "0.25", "0.3", 2.0..2.01),
        (Float::F64, "2.5", "0.3", 3.0..3.01),
        (Float::F32, "0.25", "0", 0.0..0.01),
        (Float::F32, "2.5", "0", 1.0..1.01),
        (Float::F32, "0.25", "0.3", 1.0..1.01),
    ] {
        let [rate, launch] = [rate, launch].map(|number| context.decimal(number).unwrap());
        let clock = Clock { rate: &rate, launch: launch.to_double(), horizon: 9.0, float };
        let roundings = clock.linear().relative_error / float.rounding_unit();
        assert!(expected.contains(&roundings), "{float:?} {}: {roundings}", rate.to_f64());
        let mut trial = Trial { reduction: clock.linear(), rate: rate.clone(), launch, horizon: 9.0, worst: 0.0 };
        trial.run(&mut Random::new(5), 60);
    }
}
