//! Tokens → [`Request`]: what was asked for, as written. Nothing is evaluated or judged here beyond its syntax.

mod depth;
mod header;
mod names;
pub(crate) mod number;
mod parameter;
pub(crate) mod source;
mod value;
mod words;

pub(crate) use header::{Item, Shape};
pub(crate) use value::Given;
pub(crate) use words::{Float, Keyword, Method, Output};

use crate::report::Report;
use names::{PARAMETERS, ascii, canonical, unknown_parameter};
use number::Number;
use parameter::{before_another, named_value};
use proc_macro2::TokenStream;
use syn::parse::{ParseStream, Parser};
use syn::{Error, Ident, Result};
use value::{count, number, outputs, word};

/// One invocation of `pendulum!`.
pub(crate) struct Request {
    pub(crate) shape: Shape,
    pub(crate) theta0: Option<Given<Number>>,
    pub(crate) velocity0: Option<Given<Number>>,
    pub(crate) omega: Option<Given<Number>>,
    pub(crate) g: Option<Given<Number>>,
    pub(crate) length: Option<Given<Number>>,
    pub(crate) n: Option<Given<usize>>,
    pub(crate) tol: Option<Given<Number>>,
    pub(crate) t_max: Option<Given<Number>>,
    pub(crate) method: Option<Given<Method>>,
    pub(crate) float: Option<Given<Float>>,
    pub(crate) outputs: Option<Given<Vec<Output>>>,
    /// Every parameter, in order: those with a mistake in them too, so that they don't count as missing.
    written: Vec<Written>,
}

/// A parameter as it was written.
pub(crate) struct Written {
    /// Its name of [`PARAMETERS`], or the nearest one.
    name: String,
    /// Whether it is that name.
    exact: bool,
    value: TokenStream,
}

impl Written {
    fn is_parameter(&self) -> bool {
        PARAMETERS.contains(&self.name.as_str())
    }
}

/// Parses one invocation, recording every mistake; `None` where not even the shape could be told.
pub(crate) fn parse(tokens: TokenStream, report: &mut Report) -> Option<Request> {
    if let Some(error) = depth::too_deep(&tokens) {
        report.add(error);
        return None;
    }
    let parsed = (|input: ParseStream| {
        let shape = header::shape(input)?;
        Ok((shape, input.parse::<TokenStream>()?))
    })
    .parse2(tokens);
    let (shape, parameters) = report.take(parsed)?;
    let mut request = Request {
        shape,
        theta0: None,
        velocity0: None,
        omega: None,
        g: None,
        length: None,
        n: None,
        tol: None,
        t_max: None,
        method: None,
        float: None,
        outputs: None,
        written: Vec::new(),
    };
    let parameters = match request.shape {
        Shape::Item(_) => before_another(parameters, report),
        Shape::Expression => parameters,
    };
    parameter::for_each(parameters, ["a parameter", "parameters"], report, |tokens, report| {
        request.take_parameter(tokens, report);
    });
    Some(request)
}

impl Request {
    /// Whether the parameter was written at all, with or without a mistake.
    pub(crate) fn mentions(&self, name: &str) -> bool {
        self.written.iter().any(|written| written.name == name)
    }

    /// Whether something was written that is no parameter, and like none: it may be meant as the one that is missing.
    pub(crate) fn mentions_a_stranger(&self) -> bool {
        self.written.iter().any(|written| !written.is_parameter())
    }

    /// Whether every parameter that was written, but for words that are none, has its value, once.
    pub(crate) fn is_understood(&self) -> bool {
        let numbers = [&self.theta0, &self.velocity0, &self.omega, &self.g, &self.length, &self.tol, &self.t_max];
        let words = [self.n.is_some(), self.method.is_some(), self.float.is_some(), self.outputs.is_some()];
        let valued = numbers.into_iter().flatten().count() + words.into_iter().filter(|&given| given).count();
        self.written.iter().filter(|written| written.is_parameter()).count() == valued
    }

    /// Whether what was said of the type, if anything was, could be read.
    pub(crate) fn float_is_understood(&self) -> bool {
        self.float.is_some() || !self.mentions("float")
    }

    /// The type of t and of the results.
    pub(crate) fn float(&self) -> Float {
        self.float.as_ref().map_or(Float::F64, |given| given.value)
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

    fn take_parameter(&mut self, tokens: TokenStream, report: &mut Report) {
        match named_value(&tokens) {
            Ok((name, value)) => self.set(&name, value, report),
            Err(error) => {
                report.add(self.as_an_output(&tokens).unwrap_or(error));
                // `theta0` without a value is a mistake of its own, not a missing `theta0`.
                let name = first_word(&tokens).map(|word| canonical(&word).to_owned());
                self.written.extend(name.map(|name| Written { name, exact: false, value: tokens }));
            }
        }
    }

    /// The mistake of an output that stands outside the list, with those that came before it.
    fn as_an_output(&self, tokens: &TokenStream) -> Option<Error> {
        let output = |tokens: &TokenStream| Output::from_word(&tokens.to_string());
        let word = output(tokens)?.word();
        let listed = self.outputs.iter().flat_map(|given| given.value.iter().copied());
        let outside = self.written.iter().filter(|written| !written.exact).filter_map(|written| output(&written.value));
        let before = listed.chain(outside).map(Output::word).filter(|&other| other != word);
        let list: Vec<&str> = before.chain([word]).collect();
        let message = format!("`{word}` is one of the `outputs`: write `outputs = [{}]`", list.join(", "));
        Some(Error::new_spanned(tokens, message))
    }

    fn set(&mut self, name: &Ident, value: TokenStream, report: &mut Report) {
        let word = name.to_string();
        let known = ascii(&word);
        if let Some(before) = self.written.iter().find(|written| written.exact && written.name == known) {
            let [before, now] = [&before.value, &value].map(source::value);
            let alias = if word == known { String::new() } else { format!(", that is `{known}`,") };
            report.at(name.span(), format!("`{word}`{alias} is given twice, `{before}` and `{now}`: keep one"));
        }
        let exact = PARAMETERS.contains(&known);
        self.written.push(Written { name: canonical(&word).to_owned(), exact, value: value.clone() });
        report.take(self.fill(name, value));
    }

    /// Reads the value into its field, whatever was there: the checks to come speak of the last one.
    fn fill(&mut self, name: &Ident, value: TokenStream) -> Result<()> {
        match ascii(&name.to_string()) {
            "theta0" => number(name, value).map(|given| self.theta0 = Some(given)),
            "velocity0" => number(name, value).map(|given| self.velocity0 = Some(given)),
            "omega" => number(name, value).map(|given| self.omega = Some(given)),
            "g" => number(name, value).map(|given| self.g = Some(given)),
            "length" => number(name, value).map(|given| self.length = Some(given)),
            "tol" => number(name, value).map(|given| self.tol = Some(given)),
            "t_max" => number(name, value).map(|given| self.t_max = Some(given)),
            "n" => count(name, value).map(|given| self.n = Some(given)),
            "method" => word(name, value).map(|given| self.method = Some(given)),
            "float" => word(name, value).map(|given| self.float = Some(given)),
            "outputs" => outputs(name, value).map(|given| self.outputs = Some(given)),
            unknown => Err(Error::new(name.span(), unknown_parameter(unknown))),
        }
    }
}

fn first_word(tokens: &TokenStream) -> Option<String> {
    tokens.clone().into_iter().next().map(|tree| tree.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(text: &str) -> Result<Request> {
        let mut report = Report::default();
        let request = parse(text.parse().unwrap(), &mut report);
        report.finish().map(|()| request.unwrap())
    }

    #[test]
    fn reads_both_forms() {
        let expression = request("θ0 = 7π/8, n = 4").unwrap();
        assert!(matches!(expression.shape, Shape::Expression));
        assert_eq!(expression.n.unwrap().value, 4);
        let item = request("/// Doc\n pub(crate) struct Clock; theta0 = 1, outputs = [theta, velocity],").unwrap();
        let Shape::Item(header) = item.shape else { panic!("an item") };
        assert_eq!(header.name, "Clock");
        assert_eq!(header.attributes.len(), 1);
        assert_eq!(item.outputs.unwrap().value, [Output::Theta, Output::Velocity]);
    }

    #[test]
    fn reports_every_mistake() {
        let error = request("theta = 1, n = 0.5, n = 3, n = 4, method = furier, float = f16").err().unwrap();
        let messages: Vec<String> = error.into_iter().map(|e| e.to_string()).collect();
        assert_eq!(messages.len(), 6, "{messages:#?}");
        assert!(messages[0].contains("did you mean `theta0`"));
        assert!(messages[1].contains("whole number"));
        assert!(messages[2].contains("`0.5` and `3`"));
        assert!(messages[3].contains("`0.5` and `4`"));
        assert!(messages[4].contains("`fourier`"));
    }

    fn mistakes(text: &str) -> Vec<String> {
        request(text).err().into_iter().flatten().map(|error| error.to_string()).collect()
    }

    /// The messages, one for each mistake, that contain these.
    #[track_caller]
    fn refused(text: &str, parts: &[&str]) {
        let messages = mistakes(text);
        assert_eq!(messages.len(), parts.len(), "{text}: {messages:#?}");
        for (message, part) in messages.iter().zip(parts) {
            assert!(message.contains(part), "{text}: {message}\nlacks: {part}");
        }
    }

    #[test]
    fn a_sign_and_a_name_are_two_mistakes() {
        refused("theta0: 1", &["write `theta0 = …`"]);
        refused("θ0 == 1", &["write `θ0 = …`"]);
        refused("theta: 1", &["did you mean `theta0`?", "write `theta0 = …`"]);
        refused("theta == 1", &["did you mean `theta0`?", "write `theta0 = …`"]);
        refused("self.theta0 = 1", &["unknown parameter `self`"]);
        refused("precision = 1e-5", &["did you mean `tol`"]);
        refused("struct A; { theta0 = 1 }", &["remove this"]);
    }

    #[test]
    fn outputs_outside_the_list_are_put_into_it() {
        refused("theta0 = 1, outputs = [theta], velocity", &["`outputs = [theta, velocity]`"]);
        refused("theta0 = 1, theta, velocity", &["`outputs = [theta]`", "`outputs = [theta, velocity]`"]);
        refused("theta0 = 1, outputs = [theta], theta", &["`outputs = [theta]`"]);
    }

    #[test]
    fn a_second_struct_is_one_mistake() {
        let call = "a `pendulum!` of their own";
        refused("struct A; theta0 = 1, tol = 1e-6; struct B; theta0 = 2, tol = 1e-3", &[call]);
        refused("struct A; theta0 = 1, #[derive(Clone)] pub struct B; theta0 = 2", &[call]);
        refused("struct A; theta0 = 1 struct B; theta0 = 2", &[call]);
        refused("struct A; struct B; theta0 = 2", &["comes before its parameters"]);
        refused("theta0 = 2, struct A;", &["comes before its parameters"]);
    }

    #[test]
    fn words_are_left_out_for_defaults() {
        for value in ["inf", "INFINITY", "f64::INFINITY", "None", "std::f64::MAX"] {
            refused(&format!("theta0 = 1, t_max = {value}"), &["leave `t_max` out for 2⁵³ periods"]);
        }
        refused("theta0 = 1, tol = auto", &["leave `tol` out"]);
        refused("theta0 = 1, method = auto", &["or leave `method` out"]);
        refused("theta0 = 1, float = 64", &["or leave `float` out"]);
    }

    /// So that calls of the functions are no mistakes of their own.
    #[test]
    fn the_type_is_told_from_mistakes() {
        let float = |text: &str| parse(text.parse().unwrap(), &mut Report::default()).unwrap().float_meant();
        for text in
            ["float: f32", "float == f32", "float f32", "f32", "float = single", "float = \"f32\"", "theta0 = 1f32"]
        {
            assert_eq!(float(&format!("struct A; {text}, tol = 1e-3")), Float::F32, "{text}");
        }
        assert_eq!(float("struct A; float: f64, tol = 1e-3"), Float::F64);
        assert_eq!(float("struct A; theta0 = 1f32, float = f64"), Float::F64);
    }

    #[test]
    fn refuses_empty_and_repeated_outputs() {
        assert!(request("theta0 = 1, outputs = []").err().unwrap().to_string().contains("empty"));
        assert!(request("theta0 = 1, outputs = [theta, theta]").err().unwrap().to_string().contains("twice"));
        assert!(
            request("theta0 = 1, outputs = theta").err().unwrap().to_string().contains("write `outputs = [theta]`")
        );
        let without_brackets = request("theta0 = 1, outputs = theta, velocity, n").err().unwrap();
        assert_eq!(without_brackets.clone().into_iter().count(), 2, "`n` is another mistake");
        assert!(without_brackets.to_string().contains("`outputs = [theta, velocity]`"));
    }
}
