//! Who asks for less pays no more: for a coarser tolerance, a shorter horizon, one output of two.
//!
//! ```text
//! PENDULA_SCENES=9000 cargo test --release -p pendulum-macros plan::tests::asking_less::many -- --ignored --nocapture
//! ```

use crate::fuzz::setting;
use crate::plan::polynomial::Polynomial;
use crate::plan::*;
use crate::testing::{Random, checked};

/// What is asked of a motion, of one output or two.
#[derive(Clone)]
struct Wish {
    start: String,
    outputs: Vec<&'static str>,
    tolerance: f64,
    horizon: f64,
}

impl Wish {
    fn random(random: &mut Random) -> Self {
        let single = random.one_in(3);
        let start = match random.below(6) {
            0 => format!("theta0 = π - {:.3}e-{}", 1.0 + 8.0 * random.unit(), random.between(1, 9)),
            1 => format!("theta0 = {:.5}, velocity0 = -{:.5}", 3.0 * random.unit(), 3.0 * random.unit()),
            2 => format!("velocity0 = {:.5}", 2.0 + 20.0 * random.unit().powi(4)),
            3 => format!("theta0 = {:.3e}", 10f64.powf(-6.0 * random.unit())),
            _ => format!("theta0 = {:.5}", 3.1 * random.unit()),
        };
        let kinds = ["theta", "velocity", "acceleration", "position", "wrapped"];
        Self {
            start: format!("{start}, float = {}", if single { "f32" } else { "f64" }),
            outputs: vec![random.choose(&kinds)],
            tolerance: 10f64.powf(-1.0 - if single { 4.5 } else { 12.0 } * random.unit()),
            horizon: 10f64.powf(if single { 4.0 } else { 9.0 } * random.unit() - 0.5),
        }
    }

    /// The same and more, in one respect.
    fn more(&self, random: &mut Random) -> Self {
        let mut more = self.clone();
        match random.below(3) {
            0 => more.tolerance *= 10f64.powf(-random.unit().powi(2)),
            1 => more.horizon *= 10f64.powf(random.unit().powi(2)),
            _ => more.outputs.push(if self.outputs == ["position"] { "velocity" } else { "position" }),
        }
        more
    }

    fn text(&self) -> String {
        let Self { start, outputs, tolerance, horizon } = self;
        let outputs = outputs.join(", ");
        format!("struct Motion; {start}, outputs = [{outputs}], tol = {tolerance:.3e}, t_max = {horizon:.3e}")
    }
}

/// What the planner counts that an output costs.
fn cost(text: &str, output: &str) -> Option<f64> {
    let plan = plan(&checked(text.parse().unwrap()).0?).ok()?;
    let part = plan.parts.iter().find(|part| part.output.word() == output)?;
    let function = plan.functions.iter().find(|function| function.output == Some(part.output))?;
    let slowness = if part.kernel.is_passage() { part::SLOWNESS } else { 1.0 };
    let waiting = part.kernel.polynomial().map_or(0.0, Polynomial::waiting);
    Some(slowness * function.program.cost() + waiting)
}

/// How many times as much an output costs when less is asked for.
fn ratio(more: &str, less: &str, output: &str) -> Option<f64> {
    let before = cost(more, output)?;
    let after = cost(less, output).unwrap_or_else(|| panic!("{more} is planned, {less} is not"));
    Some(after / before)
}

/// Of each scene the finer tolerance first. Where the cheapest reduction takes almost all of a tolerance, poles that suit
/// what it leaves don't suit the others; and what completes the angle of a rotation counts, up to half of the whole.
#[test]
fn coarser_tolerances_cost_no_more() {
    for (start, output, tolerances) in [
        ("theta0 = π - 4.6e-5, float = f32, t_max = 6.8e3", "theta", &["3e-4", "4e-4", "4.6e-4", "5e-4", "6e-4"][..]),
        ("theta0 = 1.433, t_max = 889.4", "velocity", &["5e-14", "6e-14", "7e-14", "7.12e-14", "8e-14"]),
        ("theta0 = 1.40246, velocity0 = -1.85797, t_max = 0.938", "wrapped, acceleration", &["7.1e-4", "6.1e-3"]),
        ("theta0 = 2.05865, velocity0 = -1.74225, float = f32, t_max = 1.629", "wrapped", &["1e-3", "4.9e-3"]),
        ("theta0 = 1.28687, velocity0 = -2.09272, t_max = 1.449", "wrapped", &["1e-4", "1.3e-3"]),
        ("velocity0 = 2.00001, t_max = 5.377", "wrapped", &["1e-2", "4.9e-2"]),
    ] {
        let text = |tolerance| format!("struct Motion; {start}, outputs = [{output}], tol = {tolerance}");
        let first = output.split(',').next().unwrap();
        for pair in tolerances.windows(2) {
            let ratio = ratio(&text(pair[0]), &text(pair[1]), first).unwrap();
            assert!(ratio <= 1.02, "{start}, {pair:?}: {ratio}");
        }
    }
}

/// Of `PENDULA_SCENES` scenes hardly any costs more, since estimates decide, and none much.
#[test]
#[ignore = "a minute"]
fn many() {
    let mut found = Vec::new();
    for index in 0..setting("PENDULA_SCENES", 9000) {
        let mut random = Random::new((setting("PENDULA_FUZZ_SEED", 1) << 32) + index);
        let less = Wish::random(&mut random);
        let (more, less, output) = (less.more(&mut random).text(), less.text(), less.outputs[0]);
        found.extend(ratio(&more, &less, output).map(|ratio| (ratio, more, less)));
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    let dearer = found.iter().take_while(|(ratio, ..)| *ratio > 1.02);
    let dearer: Vec<_> = dearer.inspect(|(ratio, more, less)| println!("{ratio:.3}\n  {more}\n  {less}")).collect();
    println!("{} of {} cost more", dearer.len(), found.len());
    assert!(dearer.len() * 100 < found.len());
}
