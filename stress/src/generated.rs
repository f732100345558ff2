//! A few hundred compiled plans; `build.rs` says which.

use crate::motion::{Motion, Start, number};
use crate::pair::Pair;
use crate::promised::ANY_TIME;
use crate::truth::Output;

/// Evaluates an output; positions have two numbers, others a 0.
type Evaluate = fn(f64) -> [f64; 2];

/// One output of one compiled item.
pub struct Generated {
    /// The release angle as it is written.
    pub theta0: &'static str,
    /// `"f64"` or `"f32"`.
    pub float: &'static str,
    /// The rest of the invocation.
    pub asked: &'static str,
    /// The output.
    pub output: Output,
    /// The bound proven at compile time.
    pub proven: f64,
    /// k, K, K′, q and T.
    pub constants: [f64; 5],
    /// b₂ₙ₋₁ of a plan with `n`.
    pub coefficients: &'static [f64],
    /// The plan, at times rounded to its type.
    pub evaluate: Evaluate,
}

macro_rules! generated {
    (@coefficients $plan:ident n = $n:literal,) => { &$plan::COEFFICIENTS };
    (@coefficients $plan:ident $($other:tt)*) => { &[] };
    ($all:ident, $plan:ident, $written:literal, ($($theta0:tt)*), $float:ident, $output:ident, {$($asked:tt)*}) => {
        pendula::pendulum! {
            struct $plan;
            theta0 = $($theta0)*, float = $float, outputs = [$output], $($asked)*
        }
        $all.push(Generated {
            theta0: $written,
            float: stringify!($float),
            asked: stringify!($($asked)*),
            output: Output::named(stringify!($output)),
            proven: $crate::bound!($plan $output).into(),
            constants: [$plan::MODULUS, $plan::K, $plan::K_PRIME, $plan::NOME, $plan::PERIOD].map(f64::from),
            coefficients: generated!(@coefficients $plan $($asked)*),
            evaluate: |t| $plan::$output(t as $float).pair(),
        });
    };
}

/// All of them.
pub fn generated() -> Vec<Generated> {
    include!(concat!(env!("OUT_DIR"), "/plans.rs"))
}

impl Generated {
    /// The exact motion.
    ///
    /// # Panics
    /// If the angle isn't a number.
    pub fn motion(&self) -> Motion {
        Motion::new(Start::at_rest(number(self.theta0).expect("build.rs writes numbers")))
    }

    /// The value of a parameter.
    fn parameter(&self, name: &str) -> Option<f64> {
        let asked = self.asked.split(',').filter_map(|one| one.split_once('='));
        asked.filter(|(key, _)| key.trim() == name).find_map(|(_, value)| value.trim().parse().ok())
    }

    /// The horizon; [`ANY_TIME`] where none was asked for.
    pub fn horizon(&self) -> f64 {
        self.parameter("t_max").unwrap_or(ANY_TIME * self.constants[4])
    }

    /// `tol`, if it was asked for.
    pub fn tolerance(&self) -> Option<f64> {
        self.parameter("tol")
    }
}
