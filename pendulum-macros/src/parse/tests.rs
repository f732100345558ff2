//! Calls as they are read, and what is said of each mistake.

use super::*;

fn request(text: &str) -> syn::Result<Request> {
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

/// What comes after the name is skipped up to the first parameter, so that a mistake there hides no others, nor the name.
#[test]
fn parameters_after_a_mistake_in_the_header() {
    for header in [
        "struct Clock,",
        "struct Clock:",
        "struct Clock",
        "struct Clock { hand: f64 }",
        "struct Clock<T>;",
        "struct Clock<T = f64>;",
        "unsafe struct Clock;",
        "Clock;",
        "Clock {}",
        "enum Clock;",
        "type Clock;",
        "fn Clock() -> f64;",
    ] {
        let mut report = Report::default();
        let request = parse(format!("{header} theta0 = 4, n = 3").parse().unwrap(), &mut report).unwrap();
        let Shape::Item(item) = &request.shape else { panic!("{header}: no item") };
        assert_eq!(item.name, "Clock", "{header}");
        assert!(request.is_understood() && !request.mentions_a_stranger(), "{header}");
        assert_eq!(
            (request.source().as_str(), request.n.map(|given| given.value)),
            ("theta0 = 4, n = 3", Some(3)),
            "{header}"
        );
        assert_eq!(report.finish().unwrap_err().into_iter().count(), 1, "{header}");
    }
    // Nothing is missing where nothing could be read, and no keyword is a name.
    let mut report = Report::default();
    assert!(parse("struct Clock {}".parse().unwrap(), &mut report).unwrap().mentions_a_stranger());
    for header in ["self;", "unsafe struct fn;", "struct;"] {
        let tokens = header.parse();
        assert!(tokens.is_err() || parse(tokens.unwrap(), &mut report).is_none(), "{header}");
    }
}

#[test]
fn signs_between_parameters() {
    refused("struct Clock;; theta0 = 1", &["remove this `;`"]);
    refused("struct Clock; theta0 = 1; n = 4", &["write `,`"]);
    refused("struct Clock; theta0 = 1, n = 4;", &["remove this `;`"]);
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
        refused(&format!("theta0 = 1, t_max = {value}"), &["leave `t_max` out for the longest horizon"]);
    }
    refused("theta0 = 1, tol = auto", &["leave `tol` out"]);
    refused("theta0 = 1, method = auto", &["or leave `method` out"]);
    refused("theta0 = 1, float = 64", &["or leave `float` out"]);
}

/// So that calls of the functions are no mistakes of their own.
#[test]
fn the_type_is_told_from_mistakes() {
    let float = |text: &str| parse(text.parse().unwrap(), &mut Report::default()).unwrap().float_meant();
    for text in ["float: f32", "float == f32", "float f32", "f32", "float = single", "float = \"f32\"", "theta0 = 1f32"]
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
    assert!(request("theta0 = 1, outputs = theta").err().unwrap().to_string().contains("write `outputs = [theta]`"));
    let without_brackets = request("theta0 = 1, outputs = theta, velocity, n").err().unwrap();
    assert_eq!(without_brackets.clone().into_iter().count(), 2, "`n` is another mistake");
    assert!(without_brackets.to_string().contains("`outputs = [theta, velocity]`"));
}

/// Nobody reads ten thousand digits in a message.
#[test]
fn long_literals_are_shortened() {
    let long = format!("-1.{}e-9", "123456789".repeat(1000));
    let shown = source::value(&long.parse().unwrap());
    assert!(shown.starts_with("-1.123456789") && shown.ends_with("…3456789e-9"), "{shown}");
    let short = format!("1.{}", "5".repeat(90));
    assert_eq!(source::value(&short.parse().unwrap()), short);
}
