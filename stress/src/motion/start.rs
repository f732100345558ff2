//! Initial states, as they are written in invocations.

use crate::big::Big;

/// θ, θ̇ and ω at t = 0.
#[derive(Clone, Debug)]
pub struct Start {
    /// rad
    pub theta0: Big,
    /// rad per unit of time
    pub velocity0: Big,
    /// rad per unit of time
    pub omega: Big,
}

impl Start {
    /// Released from rest with ω = 1.
    pub fn at_rest(theta0: Big) -> Self {
        Self { theta0, velocity0: 0.0.into(), omega: 1.0.into() }
    }

    /// From three numbers as in an invocation; see [`number`].
    pub fn written(theta0: &str, velocity0: &str, omega: &str) -> Option<Self> {
        Some(Self { theta0: number(theta0)?, velocity0: number(velocity0)?, omega: number(omega)? })
    }
}

/// `a`, `aπ`, `a/b`, `aπ/b`, and the sum or difference of one of them and a decimal number.
pub fn number(text: &str) -> Option<Big> {
    let bare: String = text.chars().filter(|c| !c.is_whitespace() && !"()_".contains(*c)).collect();
    // A sign that isn't the first character nor that of an exponent.
    let joint = bare.char_indices().skip(1).find(|&(i, c)| "+-".contains(c) && !bare[..i].ends_with(['e', 'E']));
    match joint {
        Some((i, sign)) => {
            let (left, right) = (term(&bare[..i])?, term(&bare[i + 1..])?);
            Some(if sign == '+' { &left + &right } else { &left - &right })
        }
        None => term(&bare),
    }
}

fn term(text: &str) -> Option<Big> {
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    let above = match above.strip_suffix('π') {
        Some(factor) => &Big::pi() * &Big::decimal(factor)?,
        None => Big::decimal(above)?,
    };
    Some(&above / &Big::decimal(below)?)
}

#[cfg(test)]
mod tests {
    use super::number;
    use std::f64::consts::PI;

    #[test]
    fn reads_what_invocations_have() {
        let read = |text| number(text).expect("a number").to_f64();
        assert_eq!(read("7π / 8"), 7.0 * PI / 8.0);
        assert_eq!(read("(-1e-9)"), -1e-9);
        assert_eq!(read("(1π - 1e-9)"), PI - 1e-9);
        assert_eq!(read("201/100"), 2.01);
        assert!(number("seven").is_none());
    }
}
