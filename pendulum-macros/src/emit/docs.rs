//! What the generated items say of themselves.

use super::named;
use super::outputs::Wording;
use crate::decimals::at_most;
use crate::exact::Real;
use crate::motion::{Elliptic, Regime};
use crate::parse::{Method, Shape};
use crate::plan::reduction::{Origin, Reduction};
use crate::plan::{Function, Part, Plan};
use crate::scene::{Goal, Scene};
use syn::Attribute;

/// The lines of the item's documentation: inputs, constants, plan, bounds.
pub(super) fn motion(scene: &Scene, plan: &Plan) -> Vec<String> {
    let mut lines = Vec::new();
    // What the user wrote, under a condition or not, is a paragraph of its own.
    let documents = |attribute: &Attribute| named(&attribute.meta, "doc").is_some();
    if matches!(&scene.shape, Shape::Item(item) if item.attributes.iter().any(documents)) {
        lines.push(String::new());
    }
    lines.push(format!("The motion of a pendulum, θ̈ + ω² sin θ = 0, for `{}`.", scene.source));
    lines.push(String::new());
    lines.extend(regime(scene));
    lines.push(String::new());
    lines.extend(self::plan(scene, plan));
    lines.into_iter().map(|line| if line.is_empty() { line } else { format!(" {line}") }).collect()
}

fn shown(x: &Real) -> String {
    format!("{:?}", x.to_f64())
}

fn regime(scene: &Scene) -> Vec<String> {
    let motion = &scene.motion;
    let mut lines = vec![format!(
        "* θ(0) = {} rad, θ̇(0) = {}, ω = {}",
        shown(&motion.theta0),
        shown(&motion.velocity0),
        shown(&motion.omega)
    )];
    match &motion.regime {
        Regime::Swing(swing) => {
            lines.push(format!(
                "* a swing between ±{} rad with the period T = {}",
                shown(&swing.amplitude),
                shown(&swing.period)
            ));
            lines.push(elliptic(&swing.elliptic, "k"));
        }
        Regime::Rotation(rotation) => {
            lines.push(format!(
                "* a rotation, one turn in {}, |θ̇| from {} at the top to {} at the lowest point",
                shown(&rotation.period),
                shown(&rotation.slowest),
                shown(&rotation.fastest)
            ));
            lines.push(elliptic(&rotation.elliptic, "κ"));
        }
        Regime::Separatrix(_) => {
            lines.push("* the separatrix: towards the top for ever, never reaching it".to_owned());
        }
    }
    lines
}

fn elliptic(elliptic: &Elliptic, modulus: &str) -> String {
    format!(
        "* {modulus} = {}, {modulus}′ = {}, K = {}, K′ = {}, q = {}",
        shown(&elliptic.modulus),
        shown(&elliptic.complementary),
        shown(&elliptic.quarter),
        shown(&elliptic.quarter_complementary),
        shown(&elliptic.nome)
    )
}

fn plan(scene: &Scene, plan: &Plan) -> Vec<String> {
    let goal = match (scene.goal, scene.method) {
        (Goal::Terms(n), _) => format!("the paper's θ̂ with {n} {} (Eq. 22)", if n == 1 { "term" } else { "terms" }),
        (Goal::Tolerance(_), _) => "an error of at most `tol`".to_owned(),
        (Goal::Full, Some(formula @ (Method::SmallAngle | Method::Harmonic))) => {
            format!("`{}` as it is", formula.word())
        }
        (Goal::Full, _) => format!("the full precision of `{}`", scene.float.word()),
    };
    let horizon = match (&scene.t_max, &scene.motion.regime) {
        (Some(t_max), _) => format!("|t| ≤ {}", shown(t_max)),
        (None, Regime::Separatrix(_)) => "any time".to_owned(),
        (None, _) => "2⁵³ periods".to_owned(),
    };
    let mut lines = vec![format!("Planned for {goal}, over {horizon}:"), String::new()];
    let reduction = &plan.reduction;
    let (most, unit) = match scene.motion.regime {
        Regime::Swing(_) => (0.5, "half periods"),
        Regime::Rotation(_) => (0.5, "turns"),
        Regime::Separatrix(_) => (1.0, "of itself"),
    };
    let wrong = match reduction.error + (most + reduction.overshoot.max(0.0)) * reduction.relative_error {
        0.0 => String::new(),
        error => format!(", wrong by at most {} {unit}", at_most(error, 1)),
    };
    let counted = counted(&scene.motion.regime, reduction);
    lines.push(format!("* phase s{counted}: {}{wrong}", reduction.describe()));
    lines.extend(plan.parts.iter().map(|part| self::part(part, plan)));
    if !plan.coefficients.is_empty() {
        let all: Vec<String> =
            plan.coefficients.iter().enumerate().map(|(i, b)| format!("b{} = {}", 2 * i + 1, shown(b))).collect();
        lines.push(format!("* coefficients of sn: {}", all.join(", ")));
    }
    if !plan.rejected.is_empty() {
        lines.extend(["", "Not chosen:", ""].map(str::to_owned));
        lines.extend(plan.rejected.iter().map(|why| format!("* {why}")));
    }
    lines
}

/// In what a phase is counted that isn't the time itself, and from where, unless its description says so: here, for the
/// code may count it in another unit, and from the middle of a piece.
fn counted(regime: &Regime, reduction: &Reduction) -> String {
    let counted = match (regime, reduction.origin) {
        _ if reduction.is_time() => return String::new(),
        (Regime::Swing(_), Origin::Anchor) => "in half periods from the nearest turning point",
        (Regime::Swing(_), Origin::Lowest) => "in half periods",
        (Regime::Rotation(_), Origin::Anchor) => "in turns from the nearest top",
        (Regime::Rotation(_), Origin::Lowest) => "in turns",
        (Regime::Separatrix(_), _) => return String::new(),
    };
    let elsewhere = if reduction.counts_anchors() { "" } else { "here " };
    format!(", {elsewhere}{counted}")
}

fn part(part: &Part, plan: &Plan) -> String {
    let bound = part.bound;
    let unit = Wording::of(part.output).unit;
    let operations = plan
        .functions
        .iter()
        .find(|function| function.output == Some(part.output))
        .map_or(String::new(), |function| format!("; {} operations", function.program.operations()));
    let shown = |error: f64| at_most(error, 3);
    let error = shown(part.error());
    let [truncation, phase, evaluation] =
        [bound.truncation, bound.phase, bound.evaluation].map(|error| shown(error / part.unit));
    let series = if part.kernel.is_passage() { " with its series" } else { "" };
    format!(
        "* {}: {}; error ≤ {error} {unit}, proven: {truncation} of truncation, {phase} of phase, {evaluation} of evaluation{series}{operations}",
        part.output.word(),
        part.description,
    )
}

/// One line for a function.
pub(super) fn function(function: &Function) -> String {
    let value = function
        .output
        .map_or("(θ(t), θ̇(t)), with one phase reduction for both", |output| Wording::of(output).value);
    format!(" {value}; NaN if t is not finite. {} operations.", function.program.operations())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::scene;

    /// In the unit of the tolerance, as the whole is: that of a velocity is ω.
    #[test]
    fn parts_of_a_bound() {
        let scene = scene("struct Motion; theta0 = 1, omega = 7, tol = 1e-6, t_max = 1e3, outputs = [velocity]");
        let lines = motion(&scene, &crate::plan::plan(&scene).unwrap());
        let line = lines.iter().find(|line| line.contains("velocity: ")).unwrap();
        let numbers: Vec<f64> =
            line.split(' ').filter_map(|word| word.contains("e-").then(|| word.parse().ok())?).collect();
        let [error, parts @ ..] = &numbers[..] else { panic!("{line}") };
        let sum: f64 = parts.iter().sum();
        assert!(parts.len() == 3 && sum >= *error && sum < 1.002 * error, "{line}");
    }

    /// Where the code counts the phase in another unit than the text does, the text says that it is its own.
    #[test]
    fn units_of_phases() {
        for (text, said) in [
            ("theta0 = 7π/8, tol = 1e-6, t_max = 1e3", "phase s, in half periods from the nearest turning point: "),
            ("theta0 = 7π/8, omega = 3, t_max = 1e6", "phase s, here in half periods from the nearest turning point: "),
            ("theta0 = π - 1e-9", "phase s, here in half periods from the nearest turning point: "),
            ("velocity0 = 3, tol = 1e-3, t_max = 1e3", "phase s, in turns from the nearest top: "),
            ("theta0 = 1, t_max = 0.1", "phase s: "),
        ] {
            let scene = scene(&format!("struct Motion; {text}"));
            let lines = motion(&scene, &crate::plan::plan(&scene).unwrap());
            assert!(lines.iter().any(|line| line.contains(said)), "{text}: {lines:#?}");
        }
    }
}
