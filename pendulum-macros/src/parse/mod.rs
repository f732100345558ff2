//! Tokens → [`Request`]: what was asked for, as written. Nothing is evaluated or judged here beyond its syntax.

mod depth;
mod names;
pub(crate) mod number;
pub(crate) mod source;
mod value;
mod words;

pub(crate) use value::Given;
pub(crate) use words::{Float, Keyword, Method, Output};

use crate::report::Report;
use names::{PARAMETERS, ascii, canonical, unknown_parameter};
use number::Number;
use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Error, Ident, Result, Token, Visibility};
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
    /// Every parameter as written, in order, under its name of [`PARAMETERS`] (or the nearest one, if misspelt): those
    /// with a mistake in them too, so that they don't count as missing.
    pub(crate) written: Vec<(String, TokenStream)>,
}

/// What the invocation expands to.
#[derive(Clone)]
pub(crate) enum Shape {
    /// A zero-sized fn item.
    Expression,
    /// `#[…] vis struct Name;`
    Item(Item),
}

/// The header of the item form.
#[derive(Clone)]
pub(crate) struct Item {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) name: Ident,
}

/// Parses one invocation, recording every mistake; `None` where not even the shape could be told.
pub(crate) fn parse(tokens: TokenStream, report: &mut Report) -> Option<Request> {
    if let Some(error) = depth::too_deep(&tokens) {
        report.add(error);
        return None;
    }
    let parsed = (|input: ParseStream| {
        let shape = shape(input)?;
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
    for (parameter, end) in split_at_commas(parameters) {
        if let Err(error) = request.take_parameter(parameter, end) {
            report.add(error);
        }
    }
    Some(request)
}

/// `#[…] vis struct Name;` or nothing.
fn shape(input: ParseStream) -> Result<Shape> {
    let attributes = attributes(input)?;
    let visibility: Visibility = input.parse()?;
    let bare = attributes.is_empty() && matches!(visibility, Visibility::Inherited);
    if bare && !input.peek(Token![struct]) {
        return header_without_struct(input).map_or(Ok(Shape::Expression), Err);
    }
    if !input.peek(Token![struct]) {
        return Err(input.error("expected `struct Name;` after attributes or a visibility"));
    }
    input.parse::<Token![struct]>()?;
    if input.cursor().ident().is_none() {
        return Err(input.error("expected the name of the struct: `struct Name;`"));
    }
    let name = input.parse()?;
    if !input.peek(Token![;]) {
        return Err(input.error("expected `;`: the struct is a unit struct, its parameters follow after the semicolon"));
    }
    input.parse::<Token![;]>()?;
    Ok(Shape::Item(Item { attributes, visibility, name }))
}

/// `#[…]`, any number of them.
fn attributes(input: ParseStream) -> Result<Vec<Attribute>> {
    input.call(Attribute::parse_outer).map_err(|error| {
        let inner = input.peek(Token![!]);
        if inner { input.error("an attribute of the struct is written without `!`: `#[…]`") } else { error }
    })
}

/// The mistake of `Clock;`, `enum Clock;` or `Clock { … }` where `struct Clock;` was meant.
fn header_without_struct(input: ParseStream) -> Option<Error> {
    let (first, rest) = input.cursor().ident()?;
    // `type` is what `float` may be taken for, and the beginning of an item.
    if PARAMETERS.contains(&canonical(&first.to_string())) && first != "type" {
        return None;
    }
    let mut following = rest.token_stream().into_iter();
    let next = following.next()?;
    let name = match &next {
        TokenTree::Ident(keyword) if keyword == "struct" => return Some(word_before_struct(&first, following.next())),
        TokenTree::Ident(second) => second,
        TokenTree::Punct(punct) if matches!(punct.as_char(), ';' | '<') => &first,
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => &first,
        _ => return None,
    };
    let message =
        format!("expected `struct {name};` and then the parameters, or nothing but parameters, `name = value`");
    Some(Error::new(first.span(), message))
}

/// The mistake of `unsafe struct Clock;`.
fn word_before_struct(word: &Ident, name: Option<TokenTree>) -> Error {
    let name = name.map_or_else(|| "Name".to_owned(), |name| name.to_string());
    Error::new(word.span(), format!("`{word}` has no place before `struct {name};`: leave it out"))
}

/// The parameters, each as its own token stream with the span of the comma that ends it, so that a mistake in one
/// doesn't hide those in the next.
fn split_at_commas(tokens: TokenStream) -> Vec<(TokenStream, Span)> {
    let mut parts = Vec::new();
    let mut part = Vec::new();
    for tree in tokens {
        match &tree {
            TokenTree::Punct(punct) if punct.as_char() == ',' => {
                parts.push((part.drain(..).collect(), punct.span()));
            }
            _ => part.push(tree),
        }
    }
    if !part.is_empty() {
        parts.push((part.into_iter().collect(), Span::call_site()));
    }
    parts
}

impl Request {
    /// Whether the parameter was written at all, with or without a mistake.
    pub(crate) fn mentions(&self, name: &str) -> bool {
        self.written.iter().any(|(written, _)| written == name)
    }

    /// Whether something was written that is no parameter, and like none: it may be meant as the one that is missing.
    pub(crate) fn mentions_a_stranger(&self) -> bool {
        self.written.iter().any(|(name, _)| !PARAMETERS.contains(&name.as_str()))
    }

    /// Whether every parameter that was written, but for words that are none, has its value, once.
    pub(crate) fn is_understood(&self) -> bool {
        let numbers = [&self.theta0, &self.velocity0, &self.omega, &self.g, &self.length, &self.tol, &self.t_max];
        let words = [self.n.is_some(), self.method.is_some(), self.float.is_some(), self.outputs.is_some()];
        let valued = numbers.into_iter().flatten().count() + words.into_iter().filter(|&given| given).count();
        self.written.iter().filter(|(name, _)| PARAMETERS.contains(&name.as_str())).count() == valued
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
        let mut said = self.written.iter().filter(|(name, _)| name == "float").map(|(_, value)| value.to_string());
        match &self.float {
            None if said.any(|value| value.contains("32")) => Float::F32,
            _ => self.float(),
        }
    }

    /// The decimal digits of the longest number that the motion depends on.
    pub(crate) fn digits(&self) -> usize {
        let numbers = [&self.theta0, &self.velocity0, &self.omega, &self.g, &self.length];
        numbers.into_iter().flatten().map(|given| given.value.digits()).max().unwrap_or(0)
    }

    fn ends_with(&self, name: &str) -> bool {
        self.written.last().is_some_and(|(last, _)| last == name)
    }

    fn take_parameter(&mut self, tokens: TokenStream, end: Span) -> Result<()> {
        if tokens.is_empty() {
            return Err(Error::new(end, "expected a parameter before this comma: remove it"));
        }
        match named_value(&tokens) {
            Ok((name, value)) => self.set(name, value),
            // `outputs = theta, velocity` is one mistake, and was told of.
            Err(_) if self.outputs.is_none() && self.ends_with("outputs") && output_alone(&tokens) => Ok(()),
            Err(error) => {
                // `theta0` without a value is a mistake of its own, not a missing `theta0`.
                self.written.extend(first_word(tokens).map(|word| (canonical(&word).to_owned(), TokenStream::new())));
                Err(error)
            }
        }
    }

    fn set(&mut self, name: Ident, value: TokenStream) -> Result<()> {
        let known = canonical(&name.to_string()).to_owned();
        let twice = self.written.iter().find(|(written, _)| *written == known).map(|(_, before)| {
            let [before, now] = [before, &value].map(source::value);
            Error::new(name.span(), format!("`{name}` is given twice, `{before}` and `{now}`: keep one"))
        });
        self.written.push((known, value.clone()));
        let parameter = Parameter { name, value, twice };
        match ascii(&parameter.name.to_string()) {
            "theta0" => parameter.fill(&mut self.theta0, number),
            "velocity0" => parameter.fill(&mut self.velocity0, number),
            "omega" => parameter.fill(&mut self.omega, number),
            "g" => parameter.fill(&mut self.g, number),
            "length" => parameter.fill(&mut self.length, number),
            "tol" => parameter.fill(&mut self.tol, number),
            "t_max" => parameter.fill(&mut self.t_max, number),
            "n" => parameter.fill(&mut self.n, count),
            "method" => parameter.fill(&mut self.method, word),
            "float" => parameter.fill(&mut self.float, word),
            "outputs" => parameter.fill(&mut self.outputs, outputs),
            unknown => Err(Error::new(parameter.name.span(), unknown_parameter(unknown))),
        }
    }
}

/// `name = value`, and the mistake that it is where the parameter has a value already.
struct Parameter {
    name: Ident,
    value: TokenStream,
    twice: Option<Error>,
}

impl Parameter {
    /// Reads the value into its field, whatever was there: the checks to come speak of the last one.
    fn fill<T>(self, field: &mut Option<Given<T>>, read: fn(&Ident, TokenStream) -> Result<Given<T>>) -> Result<()> {
        let taken = field.is_some();
        let filled = read(&self.name, self.value).map(|given| *field = Some(given));
        match self.twice {
            Some(mistake) if taken => Err(mistake),
            _ => filled,
        }
    }
}

fn output_alone(tokens: &TokenStream) -> bool {
    syn::parse2::<Ident>(tokens.clone()).is_ok_and(|word| Output::from_word(&word.to_string()).is_some())
}

fn first_word(tokens: TokenStream) -> Option<String> {
    tokens.into_iter().next().map(|tree| tree.to_string())
}

/// `name = value`, the value's tokens untouched.
fn named_value(tokens: &TokenStream) -> Result<(Ident, TokenStream)> {
    let parse = |input: ParseStream| {
        let name = input
            .call(Ident::parse_any)
            .map_err(|_| input.error("expected `name = value`, such as `theta0 = 7π/8`"))?;
        if input.parse::<Option<Token![=]>>()?.is_none() {
            return Err(Error::new(name.span(), format!("expected a value: `{name} = …`")));
        }
        if input.peek(Token![=]) {
            return Err(input.error(format!("a value is given by one `=`: write `{name} = …`")));
        }
        let value: TokenStream = input.parse()?;
        if value.is_empty() {
            return Err(Error::new(name.span(), format!("`{name} =` lacks its value")));
        }
        Ok((name, value))
    };
    parse.parse2(tokens.clone())
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
        assert_eq!(messages.len(), 5, "{messages:#?}");
        assert!(messages[0].contains("did you mean `theta0`"));
        assert!(messages[1].contains("whole number"));
        assert!(messages[2].contains("twice"));
        assert!(messages[3].contains("`fourier`"));
    }

    #[test]
    fn refuses_empty_and_repeated_outputs() {
        assert!(request("theta0 = 1, outputs = []").err().unwrap().to_string().contains("empty"));
        assert!(request("theta0 = 1, outputs = [theta, theta]").err().unwrap().to_string().contains("twice"));
        assert!(
            request("theta0 = 1, outputs = theta").err().unwrap().to_string().contains("write `outputs = [theta]`")
        );
        let without_brackets = request("theta0 = 1, outputs = theta, velocity, n").err().unwrap();
        assert_eq!(without_brackets.into_iter().count(), 2, "`n` is another mistake");
    }
}
