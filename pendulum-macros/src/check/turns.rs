//! An angle without its full turns.

use crate::exact::Real;

/// What full turns leave of an angle, in [−π, π].
pub(super) enum Rest {
    Lowest,
    Top,
    Between(Real),
    /// So many turns that the rest isn't known.
    Unknown,
}

impl Rest {
    pub(super) fn of(angle: &Real) -> Self {
        const MOST_TURNS: f64 = 1e15;
        let context = angle.context();
        let pi = context.pi();
        let turns = (angle / &pi.scale(1)).to_f64().round();
        let Some(turns) = context.float(turns).filter(|_| turns.abs() < MOST_TURNS) else { return Self::Unknown };
        let rest = angle - &(turns * pi.scale(1));
        let negligible = angle.abs() * context.resolution();
        if rest.abs() <= negligible {
            Self::Lowest
        } else if (rest.abs() - pi).abs() <= negligible {
            Self::Top
        } else {
            Self::Between(rest)
        }
    }

    /// As it is given.
    pub(super) fn shown(&self, in_degrees: bool) -> String {
        let value = match self {
            Self::Unknown => return "`theta0` less its full turns".to_owned(),
            Self::Lowest => "0".to_owned(),
            Self::Top if in_degrees => "180deg".to_owned(),
            Self::Top => "1π".to_owned(),
            Self::Between(rest) if in_degrees => {
                let context = rest.context();
                format!("{}deg", (rest * &context.integer(180) / context.pi()).to_f64())
            }
            Self::Between(rest) => rest.to_f64().to_string(),
        };
        format!("`theta0 = {value}`")
    }
}
