//! What was asked for, as written.

use super::names::unknown_parameter;
use super::number::Number;
use super::value::{Given, count, number, outputs, word};
use super::{Float, Method, Output, Parameter, Shape, source};
use proc_macro2::TokenStream;
use syn::{Error, Ident, Result};

/// A field of [`Request`] for each parameter, which the function after it reads.
macro_rules! fields {
    ($($parameter:ident => $name:ident: $value:ty = $read:path,)*) => {
        /// One invocation of `pendulum!`.
        pub(crate) struct Request {
            pub(crate) shape: Shape,
            $(pub(crate) $name: Option<Given<$value>>,)*
            /// Every parameter, in order: those with a mistake in them too, so that they don't count as missing.
            pub(super) written: Vec<Written>,
        }

        impl Request {
            pub(super) fn new(shape: Shape) -> Self {
                Self { shape, $($name: None,)* written: Vec::new() }
            }

            /// Reads the value into its field, whatever was there: the checks to come speak of the last one.
            pub(super) fn fill(&mut self, name: &Ident, value: TokenStream) -> Result<()> {
                let word = name.to_string();
                match Parameter::named(&word) {
                    $(Some(Parameter::$parameter) => $read(name, value).map(|given| self.$name = Some(given)),)*
                    None => Err(Error::new(name.span(), unknown_parameter(&word, |known| self.mentions(known)))),
                }
            }
        }
    };
}

fields! {
    Theta0 => theta0: Number = number,
    Velocity0 => velocity0: Number = number,
    Omega => omega: Number = number,
    G => g: Number = number,
    Length => length: Number = number,
    N => n: usize = count,
    Tol => tol: Number = number,
    TMax => t_max: Number = number,
    Method => method: Method = word,
    Float => float: Float = word,
    Outputs => outputs: Vec<Output> = outputs,
}

/// A parameter as it was written.
pub(crate) struct Written {
    /// The one of that name, or of the nearest, if there is one.
    pub(super) parameter: Option<Parameter>,
    /// Whether it is of that name.
    pub(super) exact: bool,
    /// Whether there was no mistake in it.
    pub(super) understood: bool,
    pub(super) value: TokenStream,
}

impl Request {
    /// Records that what may have been parameters wasn't understood at all.
    pub(super) fn skipped(&mut self) {
        self.written.push(Written { parameter: None, exact: false, understood: false, value: TokenStream::new() });
    }

    /// The parameters as they were written, evenly spaced: `theta0 = 7π/8, n = 4`.
    pub(crate) fn source(&self) -> String {
        let parameter = |Written { parameter, value, .. }: &Written| {
            Some(format!("{} = {}", (*parameter)?.word(), source::value(value)))
        };
        let parameters: Vec<String> = self.written.iter().filter_map(parameter).collect();
        parameters.join(", ")
    }

    /// What sets the rate.
    pub(crate) fn rate(&self) -> Option<&Given<Number>> {
        self.omega.as_ref().or(self.length.as_ref())
    }

    /// Whether the parameter was written at all, with or without a mistake.
    pub(crate) fn mentions(&self, parameter: Parameter) -> bool {
        self.written_as(parameter).next().is_some()
    }

    pub(super) fn written_as(&self, parameter: Parameter) -> impl Iterator<Item = &Written> {
        self.written.iter().filter(move |written| written.parameter == Some(parameter))
    }

    /// Whether the parameter was written, but with a mistake, which has been reported: what was meant isn't known.
    pub(crate) fn misstates(&self, parameter: Parameter) -> bool {
        self.mentions(parameter) && !self.written_as(parameter).any(|written| written.understood)
    }

    /// Whether that parameter may have been meant by something that was written with a mistake.
    pub(crate) fn may_mean(&self, parameter: Parameter) -> bool {
        self.misstates(parameter) || !self.mentions(parameter) && self.mentions_a_stranger()
    }

    /// Whether something was written that is no parameter, and like none: it may be meant as the one that is missing.
    pub(crate) fn mentions_a_stranger(&self) -> bool {
        self.written.iter().any(|written| written.parameter.is_none())
    }

    /// Whether there was no mistake in the parameters that were written, but for words that are none.
    pub(crate) fn is_understood(&self) -> bool {
        self.written.iter().filter(|written| written.parameter.is_some()).all(|written| written.understood)
    }

    /// The type of t and of the results.
    pub(crate) fn float(&self) -> Float {
        self.float.as_ref().map_or(Float::F64, |given| given.value)
    }

    pub(crate) fn asks_for(&self, output: Output) -> bool {
        self.outputs.as_ref().is_some_and(|given| given.value.contains(&output))
    }

    /// The type that was probably meant, where what was said of it is a mistake.
    pub(crate) fn float_meant(&self) -> Float {
        let is_single = |Written { parameter, value, .. }: &Written| {
            let value = value.to_string();
            let is_float = *parameter == Some(Parameter::Float);
            value.contains("f32") || is_float && (value.contains("32") || value.contains("single"))
        };
        if self.float.is_none() && self.written.iter().any(is_single) { Float::F32 } else { self.float() }
    }

    /// The decimal digits of the longest number that the motion depends on.
    pub(crate) fn digits(&self) -> usize {
        let numbers = [&self.theta0, &self.velocity0, &self.omega, &self.g, &self.length];
        numbers.into_iter().flatten().map(|given| given.value.digits()).max().unwrap_or(0)
    }
}
