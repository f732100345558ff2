//! A compiled plan, what it promises, and what a dense look at it finds.
#![allow(dead_code, unreachable_pub, reason = "each test crate uses its own part of this module")]

use pendula_stress::promised::ANY_TIME;

use crate::truth::{State, Swing, distance, times};

/// One output of one compiled item.
pub struct Promise {
    /// `theta0;velocity0;omega`.
    pub start: &'static str,
    /// The rest of the invocation.
    pub asked: &'static str,
    pub output: &'static str,
    pub method: &'static str,
    pub terms: usize,
    pub horizon: f64,
    /// The proven bound, in the output's unit.
    pub bound: f64,
}

/// A promise and its observed counterpart.
pub struct Finding {
    pub promise: Promise,
    pub observed: f64,
    pub at: f64,
    /// The largest magnitude of the output.
    pub largest: f64,
}

impl Promise {
    /// The largest error over the horizon; `error` gives the time as rounded to the plan's float, and the error there.
    pub fn observe(self, density: u32, error: impl Fn(f64, &dyn Fn(f64) -> State) -> (f64, f64)) -> Finding {
        let swing = Swing::named(self.start);
        let horizon = self.horizon.min(ANY_TIME * swing.period());
        let (mut observed, mut worst_at) = (0.0_f64, f64::NAN);
        for t in times::within(&swing, horizon, density) {
            let (at, error) = error(t, &|t| swing.at(t));
            assert!(error.is_finite(), "{} {}: {} at {t:e}", self.start, self.asked, self.output);
            if error > observed && at.abs() <= horizon {
                (observed, worst_at) = (error, at);
            }
        }
        let [theta, velocity, acceleration] = swing.largest();
        let largest = match self.output {
            "theta" => theta,
            "velocity" => velocity,
            "acceleration" => acceleration,
            _ => 1.0,
        };
        Finding { promise: self, observed, at: worst_at, largest }
    }
}

impl Finding {
    /// How far the proven bound is above what was seen.
    pub fn slack(&self) -> f64 {
        self.promise.bound / self.observed
    }

    pub fn describe(&self) -> String {
        let Promise { start, asked, output, method, terms, bound, .. } = &self.promise;
        format!(
            "{:28} {asked:34} {output:12} {method:10} {terms:3} terms: proven {bound:.2e}, observed {:.2e} at {:e} ({:.2})",
            start.replace(' ', ""),
            self.observed,
            self.at,
            self.slack()
        )
    }
}

/// Prints a table, and fails with all rows that `wrong` objects to.
pub fn judge(findings: &[Finding], wrong: impl Fn(&Finding) -> Option<String>) {
    let mut objections = Vec::new();
    for finding in findings {
        println!("{}", finding.describe());
        objections.extend(wrong(finding).map(|why| format!("{}\n    {why}", finding.describe())));
    }
    assert!(objections.is_empty(), "{} of {}:\n{}", objections.len(), findings.len(), objections.join("\n"));
}

/// |computed − exact| of an output, in its unit with ω = `omega`.
pub fn error_of(output: &str, computed: [f64; 2], exact: &State, omega: f64) -> f64 {
    let [first, second] = computed;
    match output {
        "theta" => distance(first, exact.theta),
        "velocity" => distance(first / omega, exact.velocity),
        "acceleration" => distance(first / (omega * omega), -exact.sine),
        _ => distance(first, exact.sine).hypot(distance(second, -exact.cosine)),
    }
}

/// `findings!(density; [[θ0 θ̇0 ω] …] [{horizon; float; outputs; further parameters} …])`: every start with every
/// request, one [`Finding`] per output.
#[macro_export]
macro_rules! findings {
    ($density:expr; [$($start:tt)*] $requests:tt) => {{
        let mut all = Vec::new();
        $($crate::findings!(@start all $density; $start $requests);)*
        all
    }};
    (@start $all:ident $density:expr; $start:tt [$($request:tt)*]) => {
        $($crate::findings!(@one $all $density; $start $request);)*
    };
    (@one $all:ident $density:expr; [$theta0:tt $velocity0:tt $omega:tt]
        {$($horizon:literal)?; $float:ident; $($output:ident)*; $($asked:tt)*}) => {{
        pendula::pendulum! {
            struct Motion;
            theta0 = $theta0, velocity0 = $velocity0, omega = $omega, float = $float,
            $(t_max = $horizon,)? outputs = [$($output),*], $($asked)*
        }
        let start = concat!(stringify!($theta0), ";", stringify!($velocity0), ";", stringify!($omega));
        let asked = concat!(stringify!($float $($asked)*) $(, " t_max = ", $horizon)?);
        let horizon = [$(f64::from($horizon),)? f64::INFINITY][0];
        $($all.push($crate::promise::Promise {
            start,
            asked,
            output: stringify!($output),
            method: Motion::METHOD,
            terms: Motion::TERMS,
            horizon,
            bound: f64::from(pendula_stress::bound!(Motion $output)),
        }
        .observe($density, |t, truth| {
            let t = t as $float;
            let at = f64::from(t);
            let computed = pendula_stress::pair::Pair::pair(Motion::$output(t));
            let omega = f64::from(Motion::OMEGA);
            (at, $crate::promise::error_of(stringify!($output), computed, &truth(at), omega))
        }));)*
    }};
}
