//! Near misses: an invocation's text, cut into tokens, with something wrong with it.

use super::grammar::{decimal, digits, invocation, power_of_ten};
use crate::testing::Random;

/// What may stand where it shouldn't.
const WORDS: &[&str] = &[
    "theta0",
    "θ0",
    "velocity0",
    "omega",
    "ω",
    "g",
    "length",
    "n",
    "tol",
    "t_max",
    "method",
    "float",
    "outputs",
    "theta",
    "velocity",
    "position",
    "state",
    "f32",
    "f64",
    "f16",
    "fourier",
    "polynomial",
    "struct",
    "enum",
    "fn",
    "pub",
    "A",
    "_",
    "π",
    "PI",
    "pi",
    "sqrt",
    "sin",
    "self",
    "Self",
    "crate",
    "r#theta0",
    "r#struct",
    "'a",
    "日本",
    "ϑ0",
    "µ",
];
const PUNCTUATION: &[&str] = &[
    ",", ",,", ";", "=", "==", ":", "::", "+", "-", "--", "*", "**", "/", "%", "^", "!", "?", ".", "..", "..=", "#",
    "$", "@", "&", "&&", "|", "<", "<<=", ">", "->", "=>", "~",
];
const LITERALS: &[&str] = &[
    "0",
    "1",
    "-1",
    "0.0",
    "1.",
    "7π",
    "7.5deg",
    "1rad",
    "1f32",
    "1f64",
    "3u8",
    "0x1F",
    "0b101",
    "0o17",
    "1_000",
    "1__0.0_1",
    "1e5",
    "1E-5",
    "1e400",
    "1e-400",
    "1e1000",
    "1e1001",
    "1e99999999999999999999",
    "1e-99999999999999999999",
    "1e+3",
    "18446744073709551616",
    "340282366920938463463374607431768211456",
    "\"π\"",
    "'1'",
    "b\"1\"",
    "b'1'",
    "c\"1\"",
    "r#\"1\"#",
    "true",
    "1e3π",
    "0e0",
    "00.00",
    "4.9e-324",
    "2.2250738585072014e-308",
    "1.7976931348623157e308",
    "1π2",
    "3.14159265358979323846264338327950288419716939937510",
];

/// A valid invocation with one to four mutations.
pub(crate) fn near_miss(random: &mut Random) -> String {
    let mut tokens = tokens(&invocation(random).text());
    for _ in 0..=random.below(4) {
        mutate(random, &mut tokens);
    }
    tokens.join(if random.one_in(20) { "" } else { " " })
}

/// Nothing but tokens, in balanced groups.
pub(crate) fn soup(random: &mut Random) -> String {
    let mut text = String::new();
    let mut open = Vec::new();
    for _ in 0..random.below(40) {
        match random.below(12) {
            0 => {
                let (left, right) = random.choose(&[("(", ")"), ("[", "]"), ("{", "}")]);
                text.push_str(left);
                open.push(right);
            }
            1 => text.push_str(open.pop().unwrap_or("=")),
            2..5 => text.push_str(random.choose(PUNCTUATION)),
            5..8 => text.push_str(random.choose(LITERALS)),
            8 => text.push_str(" tol ="),
            _ => text.push_str(random.choose(WORDS)),
        }
        text.push(' ');
    }
    open.into_iter().rev().for_each(|right| text.push_str(right));
    text
}

fn tokens(text: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    for word in text.split_whitespace() {
        let mut rest = word;
        while let Some(at) = rest.find([',', ';', '(', ')', '[', ']', '/', '*']) {
            if at > 0 {
                tokens.push(rest[..at].to_owned());
            }
            tokens.push(rest[at..=at].to_owned());
            rest = &rest[at + 1..];
        }
        if !rest.is_empty() {
            tokens.push(rest.to_owned());
        }
    }
    tokens
}

fn mutate(random: &mut Random, tokens: &mut Vec<String>) {
    if tokens.is_empty() {
        tokens.push("=".to_owned());
    }
    let at = random.below(tokens.len());
    let other = random.below(tokens.len());
    match random.below(12) {
        0 => drop(tokens.remove(at)),
        1 => tokens.insert(at, tokens[other].clone()),
        2 => tokens.swap(at, other),
        3 => tokens[at] = random.choose(WORDS).to_owned(),
        4 => tokens[at] = random.choose(LITERALS).to_owned(),
        5 => tokens.insert(at, random.choose(PUNCTUATION).to_owned()),
        6 => tokens.insert(at, random.choose(WORDS).to_owned()),
        7 => tokens.truncate(at),
        8 => misspell(random, &mut tokens[at]),
        9 => {
            if let Some(value) = tokens.iter().rposition(|token| token.starts_with(|c: char| c.is_ascii_digit())) {
                tokens[value] = number(random);
            }
        }
        _ => {
            let values: Vec<usize> = (1..tokens.len()).filter(|&i| tokens[i - 1] == "=").collect();
            if !values.is_empty() {
                let value = random.choose(&values);
                tokens[value] = number(random);
            }
        }
    }
}

fn misspell(random: &mut Random, token: &mut String) {
    let characters: Vec<char> = token.chars().collect();
    let at = random.below(characters.len().max(1));
    let letter = random.choose(&['a', 'e', 'θ', '_', '0', 'π', '.']);
    *token = characters.iter().enumerate().map(|(i, &c)| if i == at { letter } else { c }).collect();
}

/// A number that is extreme in some way: its digits, its exponent, its depth, its length, what cancels in it.
fn number(random: &mut Random) -> String {
    match random.below(12) {
        0 => digits(random, 3, 1200),
        1 => power_of_ten(random, -1100, 1100),
        2 => {
            let depth = 1 << random.below(11);
            format!("{}{}{}", "(".repeat(depth), decimal(random, -3, 1), ")".repeat(depth))
        }
        3 => format!("{}1", "-".repeat(1 << random.below(11))),
        4 => {
            let (term, operator) = (decimal(random, -9, 0), random.choose(&["+", "-", "*", "/"]));
            let terms = vec![term; 1 << random.below(10)];
            terms.join(operator)
        }
        5 => format!("{}2{}", "sqrt(".repeat(1 << random.below(8)), ")".repeat(1 << random.below(8))),
        6 => format!("π - {}", power_of_ten(random, -1000, 0)),
        7 => format!("2 - {} * {}", power_of_ten(random, -1000, 0), power_of_ten(random, -1000, 0)),
        8 => format!("sqrt(2)*sqrt(2) - 2 + {}", power_of_ten(random, -400, 0)),
        9 => format!("1/({} - {})", decimal(random, 0, 0), decimal(random, 0, 0)),
        10 => format!("{} / {}", power_of_ten(random, -1000, 1000), power_of_ten(random, -1000, 1000)),
        _ => random.choose(LITERALS).to_owned(),
    }
}
