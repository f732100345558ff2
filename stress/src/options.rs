//! The command line.

use std::path::PathBuf;
use std::thread;

/// How to call it.
pub const USAGE: &str = "usage: pendula-stress exhaustive|times|amplitudes|coefficients [OPTIONS]
  --threads N         threads to use (default: all)
  --inputs N          inputs per row of the table (default: a billion times; else those of docs/ACCURACY.md); exhaustive tries all
  --only TEXT         of `times` only the classes with TEXT in their name, or with that output
  --record DATE PATH  writes the table, under this date, into PATH (docs/ACCURACY.md)";

/// What to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Suite {
    /// All `f32` times.
    Exhaustive,
    /// Many `f64` times.
    Times,
    /// Many release angles.
    Amplitudes,
    /// Many constants.
    Coefficients,
}

impl Suite {
    const ALL: [Self; 4] = [Self::Exhaustive, Self::Times, Self::Amplitudes, Self::Coefficients];

    /// As it is written on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exhaustive => "exhaustive",
            Self::Times => "times",
            Self::Amplitudes => "amplitudes",
            Self::Coefficients => "coefficients",
        }
    }

    /// Inputs per row in a long run.
    fn inputs(self) -> u64 {
        match self {
            Self::Exhaustive => 1 << 32,
            Self::Times => 1_000_000_000,
            Self::Amplitudes | Self::Coefficients => 10_000,
        }
    }
}

/// The command line, parsed.
#[derive(Clone, Debug)]
pub struct Options {
    /// What to run.
    pub suite: Suite,
    /// On so many threads.
    pub threads: usize,
    /// Inputs per row of the table.
    pub inputs: u64,
    /// Of the classes of [`Suite::Times`] those with this in their name or output.
    pub only: Option<String>,
    /// Where to write the result down, and under which date.
    pub record: Option<(String, PathBuf)>,
}

impl Options {
    /// From the arguments after the program's name.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let name = arguments.next().ok_or("which suite?")?;
        let suite = Suite::ALL.into_iter().find(|suite| suite.name() == name);
        let suite = suite.ok_or_else(|| format!("no suite `{name}`"))?;
        let threads = thread::available_parallelism().map_or(1, usize::from);
        let mut options = Self { suite, threads, inputs: suite.inputs(), only: None, record: None };
        while let Some(option) = arguments.next() {
            let mut value = || arguments.next().ok_or_else(|| format!("{option} needs a value"));
            match option.as_str() {
                "--threads" => options.threads = number(&value()?)?,
                "--inputs" if suite == Suite::Exhaustive => {
                    return Err("`exhaustive` tries every input: leave `--inputs` out".into());
                }
                "--inputs" => options.inputs = number(&value()?)?,
                "--only" if suite != Suite::Times => {
                    return Err(format!("`--only` chooses classes of `times`: `{name}` has none"));
                }
                "--only" => options.only = Some(value()?),
                "--record" => options.record = Some((value()?, value()?.into())),
                _ => return Err(format!("unknown option `{option}`")),
            }
        }
        Ok(options)
    }

    /// The command that does the same.
    pub fn command(&self) -> String {
        let mut command = format!("cargo run --release -p pendula-stress -- {}", self.suite.name());
        if self.inputs != self.suite.inputs() {
            command.push_str(" --inputs ");
            command.push_str(&self.inputs.to_string());
        }
        if let Some(only) = &self.only {
            command.push_str(" --only '");
            command.push_str(only);
            command.push('\'');
        }
        command
    }
}

fn number<T: std::str::FromStr>(text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("`{text}` is not a number"))
}

#[cfg(test)]
mod tests {
    use super::Options;

    fn parse(line: &str) -> Result<Options, String> {
        Options::parse(line.split(' ').map(String::from))
    }

    #[test]
    fn every_input_is_every_input() {
        let refused = parse("exhaustive --threads 2 --inputs 7").expect_err("all are tried");
        assert_eq!(refused, "`exhaustive` tries every input: leave `--inputs` out");
        assert!(parse("exhaustive --threads 2").is_ok());
    }

    #[test]
    fn the_command_does_the_same() {
        for line in ["exhaustive", "times --inputs 7 --only 'rotation'", "amplitudes --inputs 5", "coefficients"] {
            let options = parse(&line.replace('\'', "")).expect("a command line");
            assert_eq!(options.command(), format!("cargo run --release -p pendula-stress -- {line}"));
        }
    }
}
