//! The names of parameters, and what others were probably meant to be.

use super::request::PARAMETERS;
use crate::report::{list, nearest};

/// What parameters are called elsewhere, in lower case.
const SYNONYMS: [(&str, &[&str]); 9] = [
    ("theta0", &["θ", "θ_0", "angle", "angle0", "amplitude"]),
    (
        "velocity0",
        &[
            "v",
            "v0",
            "v_0",
            "vel",
            "vel0",
            "vel_0",
            "speed",
            "speed0",
            "initial_velocity",
            "theta_dot",
            "thetadot",
            "theta_dot0",
            "dtheta",
            "dtheta0",
            "θ̇",
            "θ̇0",
        ],
    ),
    (
        "omega",
        &["w", "w0", "ω", "ω0", "ω_0", "rate", "angular_frequency", "freq", "frequency", "f", "f0", "hz", "period"],
    ),
    ("g", &["gravity"]),
    ("length", &["l", "ℓ", "ell", "len"]),
    ("n", &["terms", "nterms", "n_terms", "order", "degree", "harmonics"]),
    ("tol", &["tolerance", "tolerence", "accuracy", "eps", "epsilon", "err", "error", "max_error"]),
    ("t_max", &["t", "t_end", "time", "duration", "horizon"]),
    ("float", &["type", "precision"]),
];

/// The parameter's name in ASCII.
pub(crate) fn ascii(name: &str) -> &str {
    match name {
        "θ0" => "theta0",
        "ω" => "omega",
        other => other,
    }
}

/// The same, that of a misspelt one corrected.
pub(super) fn canonical(name: &str) -> &str {
    let name = ascii(name);
    meant(name).unwrap_or(name)
}

/// Whether it is a parameter's name.
pub(super) fn is_a_parameter(name: &str) -> bool {
    PARAMETERS.contains(&ascii(name))
}

/// Whether it is a parameter's name, or near enough to one.
pub(super) fn is_like_a_parameter(name: &str) -> bool {
    is_a_parameter(canonical(name))
}

fn meant(name: &str) -> Option<&'static str> {
    let lower = name.to_lowercase();
    let synonym = SYNONYMS.iter().find(|(_, words)| words.contains(&lower.as_str()));
    synonym.map(|&(known, _)| known).or_else(|| nearest(name, PARAMETERS))
}

pub(super) fn unknown_parameter(name: &str) -> String {
    match (name.to_lowercase().as_str(), meant(name)) {
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
        (_, Some(known)) => format!("unknown parameter `{name}`: did you mean `{known}`?"),
        (_, None) => format!("unknown parameter `{name}`: a parameter is one of {}", list(PARAMETERS)),
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
            assert_eq!(meant(written), Some(known), "{written}");
        }
        assert!(unknown_parameter("mass").contains("leave it out"));
        assert!(unknown_parameter("Damping").contains("without friction"));
        // One letter is no misspelling of another.
        for unknown in ["k", "m", "x", "colour", "mass", "damping"] {
            assert_eq!(meant(unknown), None, "{unknown}");
        }
    }
}
