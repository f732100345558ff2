//! Invocations as users write them: every regime, horizon, tolerance, output and method.

use crate::parse::{Float, Keyword, Method, Output};
use crate::testing::Random;

/// A header (empty for an expression) and parameters.
pub(crate) struct Invocation {
    pub(crate) header: &'static str,
    pub(crate) parameters: Vec<(&'static str, String)>,
}

impl Invocation {
    pub(crate) fn text(&self) -> String {
        let parameters: Vec<String> = self.parameters.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        format!("{} {}", self.header, parameters.join(", "))
    }
}

/// A well-formed invocation; most make sense.
pub(crate) fn invocation(random: &mut Random) -> Invocation {
    let header = random.choose(&["", "struct A;", "/// Doc\n pub struct A;", "#[derive(Clone)] pub(crate) struct A;"]);
    let mut parameters = start(random);
    let goal = random.below(8);
    if goal < 5 {
        parameters.push(("tol", tolerance(random)));
    } else if goal == 5 {
        let most = random.choose(&[4, 12, 80]);
        parameters.push(("n", random.between(1, most).to_string()));
    }
    if random.one_in(4) {
        parameters.push(("method", random.choose(Method::WORDS).to_owned()));
    }
    if random.one_in(2) {
        parameters.push(("t_max", horizon(random)));
    }
    if random.one_in(3) {
        parameters.push(("float", random.choose(&["f32", "f32", "f64"]).to_owned()));
    }
    if random.one_in(2) {
        parameters.push(("outputs", outputs(random, header.is_empty())));
    }
    Invocation { header, parameters }
}

/// What sets the pendulum going: released, launched, about the separatrix, over the top.
fn start(random: &mut Random) -> Vec<(&'static str, String)> {
    let mut parameters = Vec::new();
    let regime = random.below(8);
    if regime < 6 {
        parameters.push((random.choose(&["theta0", "θ0"]), signed(random, angle)));
    }
    if regime >= 4 {
        parameters.push(("velocity0", signed(random, velocity)));
    }
    match random.below(6) {
        0 => parameters.push((random.choose(&["omega", "ω"]), rate(random))),
        1 => parameters.extend([("g", decimal(random, -2, 2)), ("length", decimal(random, -3, 2))]),
        _ => {}
    }
    parameters
}

fn signed(random: &mut Random, value: fn(&mut Random) -> String) -> String {
    let value = value(random);
    if random.one_in(4) { format!("-({value})") } else { value }
}

fn angle(random: &mut Random) -> String {
    match random.below(9) {
        0 => format!("{}π/{}", random.between(1, 7), random.between(8, 16)),
        1 => format!("{}deg", random.between(1, 17999) as f64 / 100.0),
        2 => format!("π - {}", power_of_ten(random, -300, -1)),
        3 => format!("π - {}", decimal(random, -14, -1)),
        4 => power_of_ten(random, -307, 0),
        5 => digits(random, 1, 60),
        6 => format!("{:?}", std::f64::consts::PI.next_down() * random.unit()),
        8 => random.choose(&["π", "180deg"]).to_owned(),
        _ => format!("{:.4}", 3.1 * random.unit()),
    }
}

fn velocity(random: &mut Random) -> String {
    match random.below(8) {
        0 => "2".to_owned(),
        1 => format!("2 + {}", power_of_ten(random, -300, -1)),
        2 => format!("2 - {}", power_of_ten(random, -300, -1)),
        3 => power_of_ten(random, -300, 300),
        4 => decimal(random, -12, 8),
        5 => format!("2*sqrt({:.3})", random.unit()),
        _ => format!("{:.4}", 4.0 * random.unit()),
    }
}

fn rate(random: &mut Random) -> String {
    if random.one_in(3) { power_of_ten(random, -200, 200) } else { decimal(random, -3, 3) }
}

fn tolerance(random: &mut Random) -> String {
    match random.below(8) {
        0 => power_of_ten(random, -17, 0),
        1 => power_of_ten(random, -40, 3),
        _ => decimal(random, -14, -1),
    }
}

/// One whose unit of time is very long or very short, often so that velocities or accelerations are next to what there
/// are numbers for.
pub(crate) fn far_units(random: &mut Random) -> String {
    let float = random.choose(&[Float::F64, Float::F64, Float::F32]);
    let most = if float == Float::F64 { 308 } else { 38 };
    let (low, high) = random.choose(&[(0, most), (most * 9 / 10, most), (most * 4 / 10, most / 2)]);
    let (whole, part) = (random.between(1, 9), random.below(10));
    let unit = format!("{whole}.{part}e{}{}", random.choose(&["-", ""]), random.between(low, high));
    let theta0 = digits(random, 2, 6);
    let least = random.choose(&[-9, -9, -100]);
    let (small, velocity) = (power_of_ten(random, least, 0), digits(random, 2, 6));
    let start = random.choose(&[
        "theta0 = π - SMALL",
        "theta0 = THETA",
        "theta0 = THETA, velocity0 = SPEED * UNIT",
        "velocity0 = (2 + SMALL) * UNIT",
        "velocity0 = UNIT / SMALL",
        "theta0 = π/2, velocity0 = -sqrt(2) * UNIT",
        "velocity0 = 2 * UNIT",
    ]);
    let output = random.choose(&["theta", "velocity", "velocity", "acceleration", "position", "theta, velocity"]);
    let goal = if random.one_in(2) { format!(", tol = {}", power_of_ten(random, -14, -1)) } else { String::new() };
    let horizon = if random.one_in(2) { format!(", t_max = {} / UNIT", decimal(random, 0, 6)) } else { String::new() };
    let serves = !start.contains("UNIT") && output.contains(['y', 'h']) && random.one_in(2);
    let method =
        if serves { random.choose(&[", method = series", ", method = harmonic", ", method = fourier"]) } else { "" };
    let text = format!(
        "struct A; {start}, omega = UNIT, float = {}, outputs = [{output}]{goal}{horizon}{method}",
        float.word()
    );
    let given = [("THETA", theta0), ("SPEED", velocity), ("SMALL", small), ("UNIT", unit)];
    given.into_iter().fold(text, |text, (name, number)| text.replace(name, &number))
}

fn horizon(random: &mut Random) -> String {
    match random.below(6) {
        0 => power_of_ten(random, -300, 300),
        1 => power_of_ten(random, -5, 17),
        _ => decimal(random, 0, 6),
    }
}

fn outputs(random: &mut Random, expression: bool) -> String {
    let most = if expression { 1 } else { Output::WORDS.len() };
    let mut words: Vec<&str> = Output::WORDS.to_vec();
    let mut chosen = Vec::new();
    for _ in 0..=random.below(most) {
        chosen.push(words.swap_remove(random.below(words.len())));
    }
    format!("[{}]", chosen.join(", "))
}

pub(crate) fn power_of_ten(random: &mut Random, low: i64, high: i64) -> String {
    format!("1e{}", random.between(low, high))
}

/// Two to sixteen digits and an exponent.
pub(crate) fn decimal(random: &mut Random, low: i64, high: i64) -> String {
    let places = 1 + random.below(16);
    format!("{:.*}e{}", places, 1.0 + 9.0 * random.unit(), random.between(low, high))
}

/// A number below `whole` + 1 of up to `most` digits after the point.
pub(crate) fn digits(random: &mut Random, whole: usize, most: usize) -> String {
    let mut text = format!("{}.", random.below(whole + 1));
    for _ in 0..=random.below(most) {
        text.push(char::from(b'0' + random.below(10) as u8));
    }
    text
}
