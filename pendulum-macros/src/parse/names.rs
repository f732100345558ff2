//! The names of parameters, and what others were probably meant to be.

use super::words::{Keyword, Parameter};
use crate::report::{list, nearest};
use syn::Ident;

impl Parameter {
    pub(crate) fn of(name: &Ident) -> Option<Self> {
        Self::named(&name.to_string())
    }

    /// The parameter of that name.
    pub(crate) fn named(name: &str) -> Option<Self> {
        match name {
            "θ0" => Some(Self::Theta0),
            "ω" => Some(Self::Omega),
            other => Self::from_word(other),
        }
    }

    /// The same of one that is misspelt.
    pub(super) fn like(name: &str) -> Option<Self> {
        Self::named(name).or_else(|| meant(name))
    }
}

fn meant(name: &str) -> Option<Parameter> {
    let lower = name.to_lowercase();
    let synonym = Parameter::SYNONYMS.iter().find(|(synonym, _)| *synonym == lower).map(|&(_, word)| word);
    synonym.or_else(|| nearest(name, Parameter::WORDS)).and_then(Parameter::from_word)
}

/// The mistake of a name that is no parameter's. One that is given wasn't meant.
pub(super) fn unknown_parameter(name: &str, is_given: impl Fn(Parameter) -> bool) -> String {
    match (name.to_lowercase().as_str(), meant(name)) {
        ("t", _) if name == "T" => {
            "unknown parameter `T`: did you mean `t_max`, the horizon, or `omega = 2π/T`, of small oscillations?"
                .to_owned()
        }
        (inverse @ "period", _) => {
            format!("unknown parameter `{name}`: did you mean `omega = 2π/{inverse}`, of small oscillations?")
        }
        (direct @ ("f" | "f0" | "hz" | "freq" | "frequency"), _) => {
            format!("unknown parameter `{name}`: did you mean `omega = 2π*{direct}`, of small oscillations?")
        }
        ("precision", _) => {
            format!("unknown parameter `{name}`: did you mean `tol`, the largest error, or `float`, the type?")
        }
        ("mass" | "m", _) => format!("unknown parameter `{name}`: the motion doesn't depend on it, leave it out"),
        ("damping" | "friction" | "drag" | "drive" | "force" | "torque", _) => {
            format!("unknown parameter `{name}`: this is the motion of a pendulum without friction or drive")
        }
        (_, Some(known)) if is_given(known) => {
            format!("unknown parameter `{name}`: `{}` is given already, leave `{name}` out", known.word())
        }
        (_, Some(known)) => format!("unknown parameter `{name}`: did you mean `{}`?", known.word()),
        (_, None) => format!("unknown parameter `{name}`: a parameter is one of {}", list(Parameter::WORDS)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn suggests_what_was_probably_meant() {
        let pairs = [
            ("theta", "theta0"),
            ("angle", "theta0"),
            ("θ_0", "theta0"),
            ("Θ0", "theta0"),
            ("theta_0", "theta0"),
            ("ω_0", "omega"),
            ("velocity", "velocity0"),
            ("Omega", "omega"),
            ("Ω", "omega"),
            ("t_end", "t_max"),
            ("L", "length"),
            ("l", "length"),
            ("ell", "length"),
            ("T", "t_max"),
            ("tmax", "t_max"),
            ("N", "n"),
            ("tolerance", "tol"),
            ("period", "omega"),
            ("output", "outputs"),
        ];
        for (written, known) in pairs {
            assert_eq!(meant(written).map(Parameter::word), Some(known), "{written}");
        }
        assert!(unknown_parameter("eps", |known| known == Parameter::Tol).contains("`tol` is given already"));
        assert!(unknown_parameter("T", |_| false).contains("`t_max`, the horizon, or `omega = 2π/T`"));
        assert!(unknown_parameter("mass", |_| false).contains("leave it out"));
        assert!(unknown_parameter("Damping", |_| false).contains("without friction"));
        // One letter is no misspelling of another.
        for unknown in ["k", "m", "x", "colour", "mass", "damping"] {
            assert_eq!(meant(unknown), None, "{unknown}");
        }
    }
}
