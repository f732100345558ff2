//! The promise of full precision, over all amplitudes.

use super::tests::scene;
use super::*;
use crate::fuzz::random::Random;

#[test]
#[ignore = "a tool"]
fn scan() {
    let mut random = Random::new(5);
    let mut found = Vec::new();
    let count: u32 = std::env::var("PENDULA_SCENES").ok().and_then(|v| v.parse().ok()).unwrap_or(200);
    for index in 0..count {
        let part = f64::from(index) / f64::from(count);
        let far = 10f64.powf(-9.0 * part + 0.49);
        let start = match random.below(6) {
            0 | 1 | 2 => format!("theta0 = π - {far:.6e}"),
            3 => format!("theta0 = {:.6e}", far),
            4 => format!("velocity0 = {}", 2.0 + far),
            _ => format!("theta0 = {}, velocity0 = {}", 3.1 * random.unit(), 2.2 * random.unit()),
        };
        for output in ["theta", "velocity", "acceleration", "wrapped"] {
            let text = format!("struct Motion; {start}, outputs = [{output}]");
            match plan(&scene(&text)) {
                Ok(plan) => {
                    let part = &plan.parts[0];
                    if output == "theta" && start.contains("velocity") { continue; }
                    let unit = part.largest * 2f64.powi(-49);
                    found.push((part.bound.total() / unit, format!("{text} {} {} {:.3} {:.3} {:.3} {}", plan.method, plan.reduction.describe(), part.bound.truncation / unit, part.bound.phase / unit, part.bound.evaluation / unit, part.description)));
                }
                Err(refusal) => found.push((9.0, format!("{text} {refusal:?}"))),
            }
        }
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    for output in ["theta", "velocity", "acceleration", "wrapped"] {
        let of: Vec<_> = found.iter().filter(|(_, text)| text.contains(&format!("[{output}]"))).collect();
        println!("{output}: {} above of {}", of.iter().filter(|(ratio, _)| *ratio > 1.0).count(), of.len());
        of.iter().take(12).for_each(|(ratio, text)| println!("{ratio:.3} {text}"));
    }
}
