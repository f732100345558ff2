//! What was asked for, as written.

use super::names::{ascii, is_a_parameter, unknown_parameter};
use super::number::Number;
use super::value::{Given, count, number, outputs, word};
use super::{Float, Method, Output, Shape};
use proc_macro2::TokenStream;
use syn::{Error, Ident, Result};

/// The parameters: a field of [`Request`] for each, which the function after it reads.
macro_rules! parameters {
    ($($name:ident: $value:ty = $read:path,)*) => {
        /// Their names.
        pub(super) const PARAMETERS: &[&str] = &[$(stringify!($name)),*];

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
                match ascii(&word) {
                    $(stringify!($name) => $read(name, value).map(|given| self.$name = Some(given)),)*
                    unknown => Err(Error::new(name.span(), unknown_parameter(unknown))),
                }
            }
        }
    };
}

parameters! {
    theta0: Number = number,
    velocity0: Number = number,
    omega: Number = number,
    g: Number = number,
    length: Number = number,
    n: usize = count,
    tol: Number = number,
    t_max: Number = number,
    method: Method = word,
    float: Float = word,
    outputs: Vec<Output> = outputs,
}

/// A parameter as it was written.
pub(crate) struct Written {
    /// Its name, or the nearest one of a parameter.
    pub(super) name: String,
    /// Whether it is that name.
    pub(super) exact: bool,
    /// Whether there was no mistake in it.
    pub(super) understood: bool,
    pub(super) value: TokenStream,
}

impl Written {
    fn is_parameter(&self) -> bool {
        is_a_parameter(&self.name)
    }
}

impl Request {
    /// What sets the rate.
    pub(crate) fn rate(&self) -> Option<&Given<Number>> {
        self.omega.as_ref().or(self.length.as_ref())
    }

    /// Whether the parameter was written at all, with or without a mistake.
    pub(crate) fn mentions(&self, name: &str) -> bool {
        debug_assert!(is_a_parameter(name), "{name} is no parameter");
        self.written.iter().any(|written| written.name == name)
    }

    /// Whether the parameter was written, but with a mistake, which has been reported: what was meant isn't known.
    pub(crate) fn misstates(&self, name: &str) -> bool {
        self.mentions(name) && !self.written.iter().any(|written| written.name == name && written.understood)
    }

    /// Whether that parameter may have been meant by something that was written with a mistake.
    pub(crate) fn may_mean(&self, name: &str) -> bool {
        self.misstates(name) || !self.mentions(name) && self.mentions_a_stranger()
    }

    /// Whether something was written that is no parameter, and like none: it may be meant as the one that is missing.
    pub(crate) fn mentions_a_stranger(&self) -> bool {
        self.written.iter().any(|written| !written.is_parameter())
    }

    /// Whether there was no mistake in the parameters that were written, but for words that are none.
    pub(crate) fn is_understood(&self) -> bool {
        self.written.iter().filter(|written| written.is_parameter()).all(|written| written.understood)
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
        let is_single = |Written { name, value, .. }: &Written| {
            let value = value.to_string();
            value.contains("f32") || name == "float" && (value.contains("32") || value.contains("single"))
        };
        if self.float.is_none() && self.written.iter().any(is_single) { Float::F32 } else { self.float() }
    }

    /// The decimal digits of the longest number that the motion depends on.
    pub(crate) fn digits(&self) -> usize {
        let numbers = [&self.theta0, &self.velocity0, &self.omega, &self.g, &self.length];
        numbers.into_iter().flatten().map(|given| given.value.digits()).max().unwrap_or(0)
    }
}
