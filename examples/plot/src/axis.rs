//! One axis: its range, its scale and its ticks.

use std::ops::RangeInclusive;

/// How values are spread along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Scale {
    Linear,
    /// Positive values only; the range is that of the decimal logarithms.
    Log,
}

/// An axis with its caption.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    pub(crate) label: String,
    pub(crate) scale: Scale,
    pub(crate) range: RangeInclusive<f64>,
}

/// A mark on an axis at `at`, 0 to 1 along it; the ones without a text are minor.
#[derive(Debug, PartialEq)]
pub(crate) struct Tick {
    pub(crate) at: f64,
    pub(crate) text: Option<String>,
}

impl Axis {
    /// A linear axis over `values`, widened to whole ticks of a step that gives about `steps` of them.
    pub(crate) fn around(label: &str, values: impl Iterator<Item = f64>, steps: f64) -> Self {
        let (low, high) = extent(values).unwrap_or((0.0, 1.0));
        let step = round_step((high - low).max(f64::MIN_POSITIVE.max(high.abs() * 1e-12)) / steps);
        let range = (low / step).floor() * step..=(high / step).ceil() * step;
        Self { label: label.into(), scale: Scale::Linear, range }
    }

    /// A linear axis over exactly `range`.
    pub(crate) fn linear(label: &str, range: RangeInclusive<f64>) -> Self {
        Self { label: label.into(), scale: Scale::Linear, range }
    }

    /// A logarithmic axis over the positive ones of `values` with a little room at both ends.
    pub(crate) fn logarithmic(label: &str, values: impl Iterator<Item = f64>) -> Self {
        let logs = values.filter(|v| *v > 0.0).map(f64::log10);
        let (low, high) = extent(logs).unwrap_or((0.0, 1.0));
        let room = (0.03 * (high - low)).max(0.1);
        Self { label: label.into(), scale: Scale::Log, range: low - room..=high + room }
    }

    /// Where `value` lies, 0 to 1 within the range.
    pub(crate) fn place(&self, value: f64) -> f64 {
        let value = if self.scale == Scale::Log { value.log10() } else { value };
        (value - self.range.start()) / (self.range.end() - self.range.start())
    }

    /// About `most` ticks with a text, and minor ones between them where there is room.
    pub(crate) fn ticks(&self, most: f64) -> Vec<Tick> {
        match self.scale {
            Scale::Linear => self.linear_ticks(most),
            Scale::Log => self.decades(most),
        }
    }

    fn linear_ticks(&self, most: f64) -> Vec<Tick> {
        let (low, high) = (*self.range.start(), *self.range.end());
        // A thousandth of a step of tolerance keeps the end ticks when the range was itself made of steps.
        let within = |step: f64| ((low / step - 1e-3).ceil() as i64, (high / step + 1e-3).floor() as i64);
        let coarse = round_step((high - low) / most);
        // Fewer than three ticks can't be read as a scale; the next finer step is two or two and a half times as fine.
        let step = if within(coarse).1 - within(coarse).0 < 2 { round_step(0.3 * coarse) } else { coarse };
        let digits = (-step.log10().floor()).max(0.0) as usize;
        let tick = |index: i64| {
            let value = index as f64 * step;
            Tick { at: self.place(value), text: Some(number(value, digits, step)) }
        };
        let (first, last) = within(step);
        (first..=last).map(tick).collect()
    }

    fn decades(&self, most: f64) -> Vec<Tick> {
        let (low, high) = (*self.range.start(), *self.range.end());
        let every = ((high - low) / most).ceil().max(1.0) as i64;
        let at = |log: f64| (log - low) / (high - low);
        // Everyday numbers are read faster than powers where they are few and short.
        let plain = low >= -2.0 && high <= 4.7;
        let text = |decade: i64| if plain { plain_decade(decade) } else { power_of_ten(decade) };
        let mut ticks = Vec::new();
        for decade in low.floor() as i64..=high.floor() as i64 {
            if decade as f64 >= low {
                let text = (decade % every == 0).then(|| text(decade));
                ticks.push(Tick { at: at(decade as f64), text });
            }
            if high - low <= 6.0 {
                let minor =
                    (2..10).map(|k| decade as f64 + f64::from(k).log10()).filter(|log| (low..=high).contains(log));
                ticks.extend(minor.map(|log| Tick { at: at(log), text: None }));
            }
        }
        ticks
    }
}

/// Least and largest of the finite ones.
fn extent(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.filter(|v| v.is_finite()).fold(None, |seen, v| match seen {
        None => Some((v, v)),
        Some((low, high)) => Some((low.min(v), high.max(v))),
    })
}

/// The least of 1, 2, 5 times a power of ten that is at least `step`.
fn round_step(step: f64) -> f64 {
    let decade = 10.0_f64.powf(step.log10().floor());
    [1.0, 2.0, 5.0].into_iter().map(|m| m * decade).find(|s| *s >= step * 0.999).unwrap_or(10.0 * decade)
}

/// A tick of a linear axis: fixed digits, a true minus sign, powers of ten where the digits would be too many.
fn number(value: f64, digits: usize, step: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let plain = if (1e-4..1e6).contains(&step) {
        format!("{value:.digits$}")
    } else {
        let exponent = value.abs().log10().floor() as i64;
        let mantissa = value / 10.0_f64.powi(exponent as i32);
        format!("{:.0}·{}", mantissa, power_of_ten(exponent))
    };
    plain.replace('-', "−")
}

/// 10ⁿ in digits, for |n| of a few.
fn plain_decade(exponent: i64) -> String {
    let digits = (-exponent).max(0) as usize;
    format!("{:.digits$}", 10.0_f64.powi(exponent as i32))
}

/// 10ⁿ as text: with a raised exponent, but for 1 and 10.
pub fn power_of_ten(exponent: i64) -> String {
    if let 0 | 1 = exponent {
        return plain_decade(exponent);
    }
    let raise = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    std::iter::once("10".to_owned()).chain(exponent.to_string().chars().map(|d| raise(d).to_string())).collect()
}

#[cfg(test)]
mod tests {
    use super::{Axis, power_of_ten};

    #[test]
    fn exponents_are_raised() {
        assert_eq!(power_of_ten(-15), "10⁻¹⁵");
        assert_eq!(power_of_ten(203), "10²⁰³");
        assert_eq!(power_of_ten(0), "1");
    }

    #[test]
    fn a_range_is_widened_to_whole_ticks() {
        let axis = Axis::around("", [-2.7, 2.6].into_iter(), 5.0);
        assert_eq!(axis.range, -4.0..=4.0);
        let texts: Vec<_> = axis.ticks(5.0).into_iter().filter_map(|tick| tick.text).collect();
        assert_eq!(texts, ["−4", "−2", "0", "2", "4"]);
    }

    #[test]
    fn a_low_axis_keeps_three_ticks() {
        let texts = Axis::linear("", -0.44..=0.44).ticks(3.5).into_iter().filter_map(|tick| tick.text);
        assert_eq!(texts.collect::<Vec<_>>(), ["−0.4", "−0.2", "0", "0.2", "0.4"]);
    }

    #[test]
    fn a_long_log_axis_skips_decades() {
        let axis = Axis::logarithmic("", [1e-16, 1e-1].into_iter());
        let texts: Vec<_> = axis.ticks(8.0).into_iter().filter_map(|tick| tick.text).collect();
        assert_eq!(texts, ["10⁻¹⁶", "10⁻¹⁴", "10⁻¹²", "10⁻¹⁰", "10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²"]);
    }
}
