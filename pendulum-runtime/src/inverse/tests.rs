//! Times against mpmath's: K and Carlson's RF with 120 digits.

#![expect(clippy::approx_constant, reason = "angles beside π are what is tested")]

use super::*;

/// θ, θ̇ and ω at t = 0, the angle, and the time.
type Passage = ([f64; 4], Double);

/// Released next to the top, angles next to the turning points.
const NEAR_THE_TOP: [Passage; 12] = [
    (
        [3.1415926514704893, 0.0, 1.0, 3.1415926514704675],
        Double { hi: 0.0045315956516190975, lo: 2.7557073139236296e-19 },
    ),
    ([3.141592335244318, 0.0, 1.0, 3.141592335244317], Double { hi: 7.469916810348866e-05, lo: 5.891202651980344e-22 }),
    ([3.141592653589789, 0.0, 1.0, 3.1415926535897887], Double { hi: 0.4602706845823272, lo: 1.7499294025986203e-17 }),
    ([3.141592653589793, 0.0, 1.0, 3.1415926535897927], Double { hi: 2.213005594184169, lo: 1.0560619315314307e-16 }),
    ([3.141592653589793, 0.0, 1.0, -3.1415926535897927], Double { hi: 75.22329551459346, lo: -1.8733493855133616e-15 }),
    ([3.141592653589793, 0.0, 1.0, 0.0], Double { hi: 38.718150554388814, lo: -2.1773778140501528e-16 }),
    ([3.141592653589793, 0.0, 1.0, 1e-300], Double { hi: 38.718150554388814, lo: -2.1773778140501528e-16 }),
    ([-3.1415, 0.0, 7.0, -3.1414999999], Double { hi: 0.0002098871313535776, lo: 8.6101277821733e-21 }),
    (
        [3.1415926514704893, 0.0, 1.0, -3.1415926514704675],
        Double { hi: 44.098707727904745, lo: -1.8615385822518045e-16 },
    ),
    ([1.0, 0.0, 1.0, 0.9999999999999999], Double { hi: 1.6244282740624275e-08, lo: 6.609561675458617e-25 }),
    ([1.0, 0.0, 1.0, -0.9999999999999999], Double { hi: 3.3499878159409437, lo: -1.3152412752465021e-16 }),
    ([1e-09, 0.0, 1.0, 9.999999999999999e-10], Double { hi: 2.033691978340166e-08, lo: -1.0107504760114261e-24 }),
];

/// Amplitudes whose squares, or whose halves, underflow.
const TINY: [Passage; 10] = [
    ([5e-324, 0.0, 1.0, 0.0], Double { hi: 1.5707963267948966, lo: 6.123233995736766e-17 }),
    ([1e-323, 0.0, 1.0, 5e-324], Double { hi: 1.0471975511965979, lo: -1.072081766451091e-16 }),
    ([1e-310, 0.0, 1.0, -3e-311], Double { hi: 1.8754889808102786, lo: -4.633653369931499e-18 }),
    ([-1e-170, 0.0, 3.0, -5e-171], Double { hi: 0.3490658503988659, lo: 1.9775092349554793e-17 }),
    ([1e-40, 0.0, 1.0, 7e-41], Double { hi: 0.7953988301841435, lo: 1.9011603560337982e-17 }),
    ([0.0, 1e-200, 1.0, 3e-201], Double { hi: 0.3046926540153975, lo: -8.229185706983256e-18 }),
    ([0.0, 1e-200, 1.0, -3e-201], Double { hi: 3.4462853076051907, lo: 5.872434297649424e-17 }),
    ([1e-200, 2e-200, 0.75, -2.2e-200], Double { hi: 4.8873945489630195, lo: -2.677596394204282e-16 }),
    ([1e-200, 2e-230, 1.0, 9e-201], Double { hi: 0.4510268117962623, lo: -6.341870326898535e-18 }),
    ([2e-31, 1e-31, 1.0, 2.1e-31], Double { hi: 0.11299446412451764, lo: 4.218860796082971e-19 }),
];

/// From a state in motion: a step ahead, past the turning point, beside and on the separatrix, further turns.
const LAUNCHED: [Passage; 18] = [
    ([1.0, 0.5, 1.0, 1.0000000000000002], Double { hi: 4.440892098500628e-16, lo: -3.126433560705944e-32 }),
    ([1.0, 1e-09, 1.0, 0.9999999999999999], Double { hi: 1.7476089991328414e-08, lo: -1.1023370264799098e-24 }),
    ([1.0, -1e-09, 1.0, 0.9999999999999999], Double { hi: 1.509929977977217e-08, lo: 1.9492539332112048e-25 }),
    ([1.0, 0.5, 1.0, 0.3], Double { hi: 1.9913940921086801, lo: -6.629045810319542e-17 }),
    ([3.1415926, 1e-08, 1.0, 3.14159260000001], Double { hi: 9.769988193143847e-07, lo: 8.246161298923504e-23 }),
    ([3.1415926, 1e-08, 1.0, 3.1415925], Double { hi: 1.9218478647899293, lo: 7.442902477429403e-17 }),
    ([0.0, 1.9999999999999998, 1.0, 3.1415926], Double { hi: 18.216430551845686, lo: 2.127756712891707e-17 }),
    ([0.0, 2.0000000000000004, 1.0, 3.141592653589793], Double { hi: 19.06154746249283, lo: -1.3537153623450252e-15 }),
    ([0.0, 2.0, 1.0, 3.141592653589793], Double { hi: 38.025003373828866, lo: 1.6464508923192877e-15 }),
    ([0.0, -2.0, 3.0, -1e-280], Double { hi: 5e-281, lo: 0.0 }),
    ([0.5, 2.5, 1.0, 100.0], Double { hi: 48.992107435131345, lo: -2.82719058173618e-15 }),
    ([-3.14159, -2.5, 1.0, -3.1416], Double { hi: 4.000000000024029e-06, lo: 3.4009372271561817e-22 }),
    ([3.14159, 0.1, 2.0, 3.1416], Double { hi: 9.999999986470641e-05, lo: -5.121282090405751e-21 }),
    ([100.5, -40.0, 1.0, -700000000000000.0], Double { hi: 17510947654603.854, lo: 0.00045415752815680747 }),
    ([700.0, 0.3, 1.0, 699.9999999999999], Double { hi: 1.2174272880542583, lo: -8.627201285047259e-17 }),
    ([5.0, 0.0, 1.0, 7.0], Double { hi: 2.39023501016728, lo: -1.7406050636654586e-16 }),
    (
        [0.8595944271218787, 1.3704131791653634e-11, 1.0, 0.8595944271218786],
        Double { hi: 1.7138205666020144e-08, lo: 4.764353364855757e-25 },
    ),
    // Less the turns of the start it is a little less than the amplitude, to which it rounds.
    (
        [6.7884798423802835, -374.69004095283424, 272.17259457990156, 7.926614557501992],
        Double { hi: 0.022083187001576268, lo: 1.5718571869583612e-18 },
    ),
];

/// Rotations to angles a little beyond a top, among them those whose `f64` is on the other side of the odd multiple of π.
const BEYOND_THE_TOP: [Passage; 13] = [
    (
        [-317.3008580125691, 5.772544274120582e-12, 1.0, 15.70796326794897],
        Double { hi: 2963.4781766411024, lo: -1.9730119843029873e-13 },
    ),
    ([0.0, 2.0000000000000004, 1.0, 845.0884238156544], Double { hi: 5127.556269517913, lo: -2.321609221565513e-13 }),
    ([0.0, 2.0000000000000004, 1.0, 3144.734246243383], Double { hi: 19080.609013074187, lo: 4.0005790427613564e-13 }),
    (
        [-317.0, 0.29972461543047735, 1.0, 279.60174616949166],
        Double { hi: 3620.0460450841233, lo: 1.2535990624392562e-13 },
    ),
    (
        [-317.0, 0.30632637022454573, 1.0, 279.60174616949166],
        Double { hi: 917.1615498178779, lo: 1.686356055125091e-14 },
    ),
    (
        [-172.5374523292713, 0.32264703963883506, 1.0, 21.99114857512856],
        Double { hi: 225.84452008940966, lo: 1.1266314711431001e-14 },
    ),
    (
        [3.141592653589793, 0.001, 1.0, 3.1415926535897936],
        Double { hi: 4.440892098500626e-13, lo: -9.244463735579641e-30 },
    ),
    (
        [3.141592653589793, 0.001, 1.0, 3.141592653589794],
        Double { hi: 8.881784197001252e-13, lo: -1.8488927534588537e-29 },
    ),
    (
        [-3.141592653589793, -0.001, 1.0, -3.141592653589794],
        Double { hi: 8.881784197001252e-13, lo: -1.8488927534588537e-29 },
    ),
    (
        [3.1415926535897927, 2e-15, 1.0, 3.1415926535897936],
        Double { hi: 0.4581461269166561, lo: 1.9617932048180278e-19 },
    ),
    (
        [9.42477796076938, 0.001, 1.0, 9.424777960769381],
        Double { hi: 1.7763568394002505e-12, lo: -3.6977855286788316e-29 },
    ),
    ([0.0, 2.5, 1.0, 3.1415926535897936], Double { hi: 1.5962422221317838, lo: -6.991563020349285e-17 }),
    ([0.0, -2.5, 1.0, -9.42477796076938], Double { hi: 4.78872666639535, lo: 2.3434231923958404e-16 }),
];

/// The error of `time_at`, in ulp.
fn error(([theta, velocity, omega, angle], expected): &Passage) -> f64 {
    let motion = crate::launch::from_state(*theta, *velocity, *omega).expect("valid");
    let found = motion.time_at(*angle, 0.0).expect("reached");
    let ulp = expected.hi.next_up() - expected.hi;
    ((found - expected.hi) - expected.lo).abs() / ulp
}

/// Correctly rounded but for what is nearer to a tie than a thousandth.
#[test]
fn times_are_rounded_once() {
    for passage in NEAR_THE_TOP.iter().chain(&TINY).chain(&LAUNCHED).chain(&BEYOND_THE_TOP) {
        let error = error(passage);
        assert!(error <= 0.501, "{passage:?}: {error} ulp");
    }
}

/// Gravity is nothing to the fastest: t = θ/v, and a turn more takes 2π/v.
#[test]
fn the_fastest() {
    for e in 10..=29 {
        for direction in [1.0, -1.0] {
            let speed = (0..e).fold(1.0, |speed, _| speed * 1e10);
            let motion = crate::launch::from_state(0.25, direction * speed, 1.0).expect("valid");
            for angle in [0.5, 3.0, 4.0, 100.0, 1e-300, -7.0, -1e10] {
                let way = direction * (angle - 0.25);
                match motion.time_at(angle, 0.0) {
                    Ok(t) => assert!((t * speed / way - 1.0).abs() <= 2.0 * f64::EPSILON, "{speed} {angle}"),
                    Err(_) => assert!(way < 0.0, "{speed} {angle}"),
                }
            }
        }
    }
}

/// Angles an ulp beyond the turning point, or on the way back of what doesn't come back.
#[test]
fn what_is_never_reached() {
    let never = |theta: f64, velocity: f64, angle: f64| {
        let motion = crate::launch::from_state(theta, velocity, 1.0).expect("valid");
        assert_eq!(motion.time_at(angle, 0.0), Err(Error::NeverReached { angle }), "{theta} {velocity}");
    };
    for amplitude in [5e-324_f64, 1e-200, 1.0, 3.1415926514704893] {
        for angle in [amplitude.next_up(), -amplitude.next_up(), 1.0 + amplitude, 6.0, -1e300] {
            never(amplitude, 0.0, angle);
        }
    }
    for angle in [1e-300, f64::MAX, f64::MIN] {
        never(0.0, 0.0, angle);
    }
    never(f64::MAX, 3.0, f64::MIN);
    for velocity in [2.0, 2.5, 1e290] {
        never(0.0, velocity, -1e-300);
        never(0.0, -velocity, 1e-300);
    }
    never(0.0, 2.0, PI.next_up());
}

/// The amplitude stands for the turning point on its side, whichever way it was rounded: K − F(asin(sin(θ/2)/k)) after a
/// launch upwards, half a period later on the other side.
#[test]
fn turning_points() {
    for direction in [1.0, -1.0] {
        let motion = crate::launch::from_state(0.3 * direction, 1.2 * direction, 1.0).expect("valid");
        let amplitude = direction * motion.amplitude;
        let [first, second] = [amplitude, -amplitude].map(|angle| motion.time_at(angle, 0.0).expect("reached"));
        assert!((first - 1.520_439_018_754_477_4).abs() <= f64::EPSILON, "{first}");
        assert!((second - 5.051_361_590_524_643).abs() <= 4.0 * f64::EPSILON, "{second}");
    }
    let released = crate::launch::from_state(1.0, 0.0, 1.0).expect("valid");
    assert_eq!(released.time_at(1.0, 0.0), Ok(0.0));
}

/// About a whole number of turns they are the sum of that and the amplitude, which is rounded.
#[test]
fn turning_points_after_turns() {
    let mut reached = 0;
    for index in 0..2000 {
        let theta = -40.0 + 0.04 * f64::from(index);
        let motion = crate::launch::from_state(theta, 0.0, 1.0).expect("valid");
        let turns = (theta / TAU).round();
        if motion.amplitude < 0.01 || turns == 0.0 {
            continue;
        }
        let half = 0.5 * motion.period();
        for (side, expected) in [(1.0, 0.0), (-1.0, half)] {
            let angle = turns * TAU + side * motion.amplitude.copysign(theta - turns * TAU);
            let found = motion.time_at(angle, 2.0 * f64::EPSILON * angle.abs()).expect("reached");
            // Half a unit of the angle moves the time by its root, either way; from the start forward only.
            let off = (found - expected).abs().min((found - 2.0 * half).abs());
            assert!(off < 3e-6, "{theta} {side}: {found} {expected}");
            reached += 1;
        }
    }
    assert!(reached > 3000, "{reached}");
}

/// The number so many after `x`, or before it.
fn neighbour(x: f64, steps: i32) -> f64 {
    (0..steps.abs()).fold(x, |x, _| if steps > 0 { x.next_up() } else { x.next_down() })
}

/// Next to the top what is rounded of that sum may be on its other side.
#[test]
fn turning_points_next_to_the_top_after_turns() {
    let (mut reached, mut over) = (0, 0);
    for turns in 1..400 {
        let top = f64::from(2 * turns - 1) * PI;
        for steps in -6..=6 {
            let theta = neighbour(top, steps);
            let motion = crate::launch::from_state(theta, 0.0, 1.0).expect("valid");
            let turn = (motion.base.hi / TAU).round() * TAU;
            for angle in [turn - motion.amplitude, turn + motion.amplitude] {
                over += i32::from(reduce(angle).angle.hi * (angle - turn) < 0.0);
                let found = motion.time_at(angle, 2.0 * f64::EPSILON * angle.abs()).expect("reached");
                assert!((0.0..=1.01 * motion.period()).contains(&found), "{theta} {angle}: {found}");
                reached += 1;
            }
        }
    }
    assert!(reached > 9000 && over > 200, "{reached} {over}");
}

/// An amplitude may be less than an ulp of the angle that a turning point is about.
#[test]
fn turning_points_of_tiny_swings_after_turns() {
    let mut beyond_twice = 0;
    for turns in 1..200 {
        let bottom = f64::from(turns) * TAU;
        for theta in (-2..=2).map(|steps| neighbour(bottom, steps)) {
            let motion = crate::launch::from_state(theta, 0.0, 1.0).expect("valid");
            for angle in [bottom - motion.amplitude, bottom + motion.amplitude, theta.next_up(), theta.next_down()] {
                let from_bottom = (reduce(theta).angle + Double::from_sum(angle, -theta)).hi.abs();
                if from_bottom <= motion.amplitude + 2.0 * (angle.next_up() - angle) {
                    beyond_twice += i32::from(from_bottom > 2.0 * motion.amplitude);
                    let found = motion.time_at(angle, 2.0 * f64::EPSILON * angle.abs()).expect("reached");
                    assert!((0.0..=motion.period()).contains(&found), "{theta} {angle}: {found}");
                }
            }
        }
    }
    assert!(beyond_twice > 100, "{beyond_twice}");
}

/// The same in either type, as anyone would write it.
#[test]
fn turning_points_after_turns_by_the_interface() -> Result<(), Error> {
    let p = crate::Pendulum::<f64>::from_state(7.0, 0.0, 1.0)?;
    assert!((p.time_at(TAU - p.amplitude())? - 0.5 * p.period()).abs() < 1e-7);
    let p = crate::Pendulum::<f32>::from_state(7.0, 0.0, 1.0)?;
    assert!((p.time_at(core::f32::consts::TAU - p.amplitude())? - 0.5 * p.period()).abs() < 2e-3);
    assert!(p.time_at(5.56).is_err() && p.time_at(5.57).is_ok());
    Ok(())
}

/// A swing about one turn passes the amplitude of one about none as any other angle. In `f32` this one's is rounded to
/// more than π, and passed before the turning point; the time is from `mpmath`.
#[test]
fn amplitudes_of_other_turns_are_angles() -> Result<(), Error> {
    let p = crate::Pendulum::<f32>::from_state(3.153_931_6, -196_146.0, 15_896_573.0)?;
    assert_eq!(p.time_at(p.amplitude())?, 7.476_737_7e-7);
    Ok(())
}
