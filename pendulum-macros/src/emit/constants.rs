//! The associated constants of the item form.

use super::literal;
use super::outputs::Wording;
use crate::exact::Real;
use crate::motion::{Elliptic, Regime};
use crate::parse::Float;
use crate::plan::Plan;
use crate::scene::Scene;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The names of those that some regime has; a stub has them all.
pub(super) const OF_MOTION: [&str; 10] =
    ["THETA0", "VELOCITY0", "OMEGA", "T_MAX", "AMPLITUDE", "MODULUS", "K", "K_PRIME", "NOME", "PERIOD"];

/// Every constant that makes sense for the regime and the plan.
pub(super) fn all(scene: &Scene, plan: &Plan) -> TokenStream {
    let mut constants = motion(scene);
    constants.plan(plan);
    constants.written.into_iter().map(|(_, constant)| constant).collect()
}

/// Those that make sense for the regime, by their names.
pub(super) fn of_motion(scene: &Scene) -> Vec<(&'static str, TokenStream)> {
    motion(scene).written
}

fn motion(scene: &Scene) -> Writer {
    let motion = &scene.motion;
    let mut constants = Writer { float: scene.float, written: Vec::new() };
    constants.real("THETA0", &motion.theta0, "θ at t = 0, rad.");
    constants.real("VELOCITY0", &motion.velocity0, "θ̇ at t = 0, rad per unit of t.");
    constants.real("OMEGA", &motion.omega, "ω, the rate of small oscillations, rad per unit of t.");
    constants.number(
        "T_MAX",
        scene.float.round_down(scene.horizon()),
        "The errors are bounded for all |t| up to this.",
    );
    match &motion.regime {
        Regime::Swing(swing) => {
            constants.real("AMPLITUDE", &swing.amplitude, "The largest |θ|, rad.");
            constants.elliptic(&swing.elliptic, "k", "sin(amplitude/2)");
            constants.real("PERIOD", &swing.period, "T = 4K/ω, the time of one swing to and fro, in the unit of t.");
        }
        Regime::Rotation(rotation) => {
            constants.elliptic(&rotation.elliptic, "κ", "2ω/|θ̇| at the lowest point");
            constants.real("PERIOD", &rotation.period, "The time of one turn, in the unit of t.");
        }
        Regime::Separatrix(separatrix) => {
            let one = separatrix.launch.context().integer(1);
            constants.real("MODULUS", &one, "k = 1: between swinging and turning over.");
        }
    }
    constants
}

struct Writer {
    float: Float,
    written: Vec<(&'static str, TokenStream)>,
}

impl Writer {
    fn real(&mut self, name: &'static str, value: &Real, doc: &str) {
        self.number(name, nearest(value, self.float), doc);
    }

    fn number(&mut self, name: &'static str, value: f64, doc: &str) {
        let (ident, float) = (format_ident!("{name}"), self.float);
        let value = literal::float(value, float);
        let doc = format!(" {doc}");
        self.written.push((name, quote!(#[doc = #doc] pub const #ident: #float = #value;)));
    }

    fn count(&mut self, name: &'static str, value: usize, doc: &str) {
        let ident = format_ident!("{name}");
        let value = proc_macro2::Literal::usize_unsuffixed(value);
        let doc = format!(" {doc}");
        self.written.push((name, quote!(#[doc = #doc] pub const #ident: usize = #value;)));
    }

    /// `k` is what the modulus is called, `definition` what it is.
    fn elliptic(&mut self, elliptic: &Elliptic, k: &str, definition: &str) {
        self.real("MODULUS", &elliptic.modulus, &format!("{k} = {definition}, the modulus."));
        self.real("K", &elliptic.quarter, &format!("K({k}), the complete elliptic integral of the first kind."));
        let complement = format!("K′ = K({k}′), {k}′² = 1 − {k}².");
        self.real("K_PRIME", &elliptic.quarter_complementary, &complement);
        self.real("NOME", &elliptic.nome, "q = exp(−πK′/K).");
    }

    fn plan(&mut self, plan: &Plan) {
        let method = plan.method;
        let constant = quote!(#[doc = " The kind of plan."] pub const METHOD: &'static str = #method;);
        self.written.push(("METHOD", constant));
        self.count("TERMS", plan.terms, "Terms, or harmonics, of the first function.");
        self.count("OPERATIONS", plan.operations(), "Operations of one call of the first function.");
        if !plan.coefficients.is_empty() {
            self.coefficients(&plan.coefficients);
        }
        for part in &plan.parts {
            let Wording { max_error, bound, .. } = Wording::of(part.output);
            self.number(max_error, self.float.round_up(part.error()), bound);
        }
    }

    fn coefficients(&mut self, coefficients: &[Real]) {
        let float = self.float;
        let values = coefficients.iter().map(|b| literal::float(nearest(b, float), float));
        let count = proc_macro2::Literal::usize_unsuffixed(coefficients.len());
        let doc = " b₂ₙ₋₁ = (2π/(kK)) q^(n−½)/(1 − q²ⁿ⁻¹), n = 1, 2, …: the coefficients of sn (Eq. 20).";
        let constant = quote!(#[doc = #doc] pub const COEFFICIENTS: [#float; #count] = [#(#values),*];);
        self.written.push(("COEFFICIENTS", constant));
    }
}

/// The number of the type that is nearest to `x`.
fn nearest(x: &Real, float: Float) -> f64 {
    match float {
        Float::F64 => x.to_f64(),
        Float::F32 => f64::from(x.to_f32()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::scene;

    /// The stub of a refused item has all that the item might have had.
    #[test]
    fn constants_of_each_regime_are_known() {
        let mut seen = Vec::new();
        for start in ["theta0 = 1", "velocity0 = 2", "velocity0 = 3"] {
            let scene = scene(&format!("struct Motion; {start}, tol = 1e-3, t_max = 10"));
            let text = all(&scene, &crate::plan::plan(&scene).unwrap()).to_string();
            let names = text.split("pub const ").skip(1).filter_map(|rest| rest.split(' ').next());
            seen.extend(names.map(str::to_owned));
        }
        let of_plan = ["METHOD", "TERMS", "OPERATIONS", "MAX_ERROR"];
        seen.retain(|name| !of_plan.contains(&name.as_str()));
        assert!(seen.iter().all(|name| OF_MOTION.contains(&name.as_str())), "{seen:?}");
        assert!(OF_MOTION.iter().all(|name| seen.iter().any(|seen| seen == name)), "{seen:?}");
    }
}
