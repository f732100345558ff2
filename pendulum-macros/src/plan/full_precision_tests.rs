//! Full precision is kept for every output at all amplitudes: proven to be within 16 units of rounding of the largest value
//! (48 of 1 for a position), and seen within half of that.
//!
//! ```text
//! PENDULA_SCENES=1000 cargo test --release -p pendulum-macros full_precision_tests::many -- --ignored --nocapture
//! ```

use super::random_tests::Probe;
use super::tests::scene;
use super::*;
use crate::fuzz::random::Random;
use crate::parse::Float;

/// From 1e-9 to π − 1e-9, and as near to the separatrix from above; launched anywhere; for any time or a short one.
fn random_start(random: &mut Random) -> String {
    let small = 10f64.powf(0.49 - 9.49 * random.unit());
    let start = match random.below(8) {
        0..4 => format!("theta0 = π - {small:.6e}"),
        4 => format!("theta0 = {small:.6e}"),
        5 => format!("velocity0 = 2 + {small:.6e}"),
        6 => format!("theta0 = {:.6}, velocity0 = {:.6}", 3.1 * random.unit(), 2.2 * random.unit()),
        _ => format!("theta0 = -{:.6}, velocity0 = {small:.6e}", 3.1 * random.unit()),
    };
    let horizon =
        if random.one_in(4) { format!(", t_max = {:.2e}", 10f64.powf(9.0 * random.unit())) } else { String::new() };
    format!("struct Motion; {start}{horizon}")
}

/// The largest proven and observed errors of each output, as parts of what is allowed, and where they are.
fn run(scenes: u64, seed: u64, density: usize) -> Vec<[(f64, String); 2]> {
    let mut random = Random::new(seed);
    let mut worst = vec![[(0.0, String::new()), (0.0, String::new())]; 5];
    for _ in 0..scenes {
        let start = random_start(&mut random);
        let outputs = ["velocity", "acceleration", "wrapped", "position", "theta"];
        for (output, worst) in outputs.iter().zip(&mut worst) {
            let float = random.choose(&[Float::F64, Float::F64, Float::F32]);
            let text = format!("{start}, float = {}, outputs = [{output}]", float.word());
            let scene = scene(&text);
            if *output == "theta" && matches!(scene.motion.regime, Regime::Rotation(_)) {
                continue;
            }
            let plan = plan(&scene).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
            let part = &plan.parts[0];
            let units = if *output == "position" { 48.0 } else { 16.0 };
            let allowed = units * float.unit() * part.largest;
            let mut probe = Probe::new(&scene, &plan);
            if density > 0 {
                probe.everywhere(&mut random, density);
            }
            for (found, worst) in [part.bound.total(), probe.worst.1].into_iter().zip(worst) {
                if found / allowed > worst.0 {
                    *worst = (found / allowed, format!("{text} {}", part.description));
                }
            }
        }
    }
    worst
}

#[test]
fn full_precision_is_kept() {
    for [(proven, proven_of), (observed, observed_of)] in run(25, 1, 2) {
        assert!(proven <= 1.0, "{proven}: {proven_of}");
        assert!(observed <= 0.5, "{observed}: {observed_of}");
    }
}

/// The same, of PENDULA_SCENES scenes from PENDULA_FUZZ_SEED, densely.
#[test]
#[ignore = "minutes"]
fn many() {
    let setting = |name: &str, default| std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(default);
    let worst =
        run(setting("PENDULA_SCENES", 300), setting("PENDULA_FUZZ_SEED", 2), setting("PENDULA_DENSITY", 30) as usize);
    for found in worst.iter().flatten() {
        println!("{:.3} {}", found.0, found.1);
    }
    for [(proven, _), (observed, _)] in worst {
        assert!(proven <= 1.0 && observed <= 0.5);
    }
}
