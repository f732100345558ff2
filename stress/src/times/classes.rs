//! The classes of plans: one per way to reduce the phase, kernel, regime and output.

use pendula::Pendulum;

use crate::finding::Finding;
use crate::motion::{Motion, Regime, Start};
use crate::pair::Pair;
use crate::promised::{ANY_TIME, PROVEN, RUN_TIME, UNIT};
use crate::report::Row;
use crate::truth::Output;

/// Evaluates an output at many times; positions have two numbers.
type Evaluate = Box<dyn Fn(&[f64], &mut [[f64; 2]]) + Send + Sync>;

/// One output of one plan.
pub struct Class {
    /// What is special about it.
    pub name: String,
    /// Where the motion starts from.
    pub start: Start,
    /// The output.
    pub output: Output,
    /// The horizon in units of time, if it was given so.
    pub horizon: f64,
    /// The horizon in periods.
    pub periods: f64,
    /// What is promised, in the output's unit.
    pub promise: f64,
    /// What may be observed of it.
    pub observable: f64,
    /// The bound proven at compile time.
    pub proven: Option<f64>,
    /// The largest magnitude of the output within and beyond the horizon.
    pub ceiling: f64,
    /// Terms of the paper's θ̂, where that is the truth instead of the motion.
    pub terms: Option<usize>,
    /// The plan.
    pub evaluate: Evaluate,
}

impl Class {
    /// Where an error breaks a promise.
    pub fn limit(&self) -> f64 {
        self.proven.unwrap_or(self.observable)
    }

    pub(super) fn row(&self, found: Finding) -> Row {
        Row {
            subject: self.name.clone(),
            output: self.output.name().to_owned(),
            promise: self.promise,
            proven: self.proven,
            observable: self.observable,
            found,
        }
    }
}

fn over<P: Pair>(function: impl Fn(f64) -> P + Send + Sync + 'static) -> Evaluate {
    Box::new(move |times, values| {
        for (value, &t) in values.iter_mut().zip(times) {
            *value = function(t).pair();
        }
    })
}

macro_rules! plan {
    ($all:ident: $name:literal, [$theta0:tt $velocity0:tt $omega:tt] $(tol $tol:literal)? $(within $t_max:literal)?
        $(by $method:ident)?; $($output:ident)*) => {{
        pendula::pendulum! {
            struct Plan;
            theta0 = $theta0, velocity0 = $velocity0, omega = $omega,
            $(tol = $tol,)? $(t_max = $t_max,)? $(method = $method,)? outputs = [$($output),*]
        }
        let written = [stringify!($theta0), stringify!($velocity0), stringify!($omega)];
        let tolerances: &[f64] = &[$($tol)?];
        let horizons: &[u32] = &[$($t_max)?];
        let scene = Scene::new($name, written, tolerances.first().copied(), horizons.first().copied());
        scene.is_planned_by(Plan::METHOD);
        $($all.push(scene.class(Output::named(stringify!($output)), $crate::bound!(Plan $output), over(Plan::$output)));)*
    }};
}

/// What the outputs of a plan have in common.
struct Scene {
    name: String,
    start: Start,
    /// The largest |θ| and |θ̇|/ω.
    largest: [f64; 2],
    tol: Option<f64>,
    t_max: Option<u32>,
}

impl Scene {
    fn new(name: &str, [theta0, velocity0, omega]: [&str; 3], tol: Option<f64>, t_max: Option<u32>) -> Self {
        let start = Start::written(theta0, velocity0, omega).expect("three numbers");
        let bare = |text: &str| text.replace(['(', ')', ' '], "");
        let mut name = format!("{name}: θ0 = {}", bare(theta0));
        for (text, symbol, default) in [(velocity0, "θ̇0", "0"), (omega, "ω", "1")] {
            if text != default {
                name.extend([", ", symbol, " = ", &bare(text)]);
            }
        }
        Self { name, largest: largest(&Motion::new(start.clone())), start, tol, t_max }
    }

    /// What a scene is chosen for and named by is what the planner does with it.
    fn is_planned_by(&self, method: &str) {
        let named = ["pieces", "passage"].into_iter().find(|named| self.name.contains(named));
        assert!(named.is_none_or(|named| named == method), "{} is planned by {method}", self.name);
    }

    fn class(&self, output: Output, proven: f64, evaluate: Evaluate) -> Class {
        let ceiling = match output {
            Output::Theta => self.largest[0],
            Output::Velocity => self.largest[1],
            Output::Acceleration | Output::Position => 1.0,
            Output::Wrapped => std::f64::consts::PI,
        };
        let full = PROVEN * ceiling * room(output);
        Class {
            name: self.name.clone(),
            start: self.start.clone(),
            output,
            horizon: self.t_max.map_or(f64::INFINITY, f64::from),
            periods: ANY_TIME,
            promise: self.tol.unwrap_or(full),
            observable: self.tol.unwrap_or(full / 2.0),
            proven: Some(proven),
            ceiling,
            terms: None,
            evaluate,
        }
    }
}

/// How much more than [`PROVEN`] is allowed: three times for a position, whose coordinates are products of two.
fn room(output: Output) -> f64 {
    if output == Output::Position { 3.0 } else { 1.0 }
}

/// The largest |θ| and |θ̇|/ω: 2 arcsin k and 2k of a swing, ∞ and 2/κ of a rotation.
fn largest(motion: &Motion) -> [f64; 2] {
    match &motion.regime {
        Regime::Swing(series) => [2.0 * series.modulus[0].asin().to_f64(), 2.0 * series.modulus[0].to_f64()],
        Regime::Rotation(series) => [f64::INFINITY, 2.0 / series.modulus[0].to_f64()],
        Regime::Separatrix => [std::f64::consts::PI, 2.0],
    }
}

/// All of them.
pub fn classes() -> Vec<Class> {
    let mut all = Vec::new();
    swings(&mut all);
    moments(&mut all);
    near_top(&mut all);
    rotations(&mut all);
    paper(&mut all);
    runtime(&mut all);
    all
}

fn swings(all: &mut Vec<Class>) {
    plan!(all: "tol 1e-9, 100 periods", [(7π/8) 0 1] tol 1e-9 within 1217; theta velocity acceleration position);
    plan!(all: "100 periods", [(7π/8) 0 1] within 1217; theta velocity);
    plan!(all: "10⁸ periods", [(7π/8) 0 1] within 1000000000; theta);
    plan!(all: "any time", [(7π/8) 0 1]; theta velocity acceleration position);
    plan!(all: "any time", [(1π/3) 0 3]; theta velocity);
    plan!(all: "tol 1e-12, any time", [(1/10) 0 1] tol 1e-12; theta);
    plan!(all: "tol 1e-5, any time", [(7π/8) 0 1] tol 1e-5; theta velocity);
    plan!(all: "any time", [(1e-9) 0 1]; theta velocity);
    plan!(all: "launched, any time", [1 1 1]; theta velocity position);
    plan!(all: "launched, any time", [(0.3) 2 (1.25)]; theta);
    plan!(all: "launched, tol 1e-6, any time", [1 1 3] tol 1e-6; theta velocity);
    plan!(all: "launched, tol 1e-9, any time", [2 (-0.4) 1] tol 1e-9; theta position);
}

/// Less than half a swing, or than a turn, whose phase is the time itself.
fn moments(all: &mut Vec<Class>) {
    plan!(all: "a moment", [(7π/8) 0 1] within 3; theta velocity position);
    plan!(all: "tol 1e-9, a moment", [0 (-1.9) 1] tol 1e-9 within 1; theta acceleration);
    plan!(all: "a moment", [1 (-1) 1] within 1; theta velocity acceleration);
    plan!(all: "a moment", [(1.638165) (1.680681) (1.311)] within 1; theta velocity acceleration);
    plan!(all: "rotation, a moment", [0 (2.5) 1] within 1; velocity position);
}

fn near_top(all: &mut Vec<Class>) {
    plan!(all: "any time", [(0.999π) 0 1]; theta velocity position);
    plan!(all: "pieces, any time", [(1π-1e-9) 0 1]; theta velocity);
    plan!(all: "pieces, launched, any time", [(3.14159) (0.0000015) (1.25)]; theta velocity);
    plan!(all: "launched near the top, tol 1e-9", [(3.14) (0.0015) (1.25)] tol 1e-9; theta velocity);
    plan!(all: "positions in pieces, any time", [(1π-1e-9) 0 1] by polynomial; position);
    plan!(all: "a series, any time", [(-0.999π) 0 2] by series; theta velocity);
    plan!(all: "passage, any time", [(1π-1e-20) 0 2]; theta velocity position);
    plan!(all: "near the top, tol 1e-6, 100 periods", [(1π-1e-9) 0 1] tol 1e-6 within 9000; theta);
    plan!(all: "separatrix", [0 2 1]; theta velocity position);
    plan!(all: "separatrix, tol 1e-14", [0 2 1] tol 1e-14; acceleration);
}

fn rotations(all: &mut Vec<Class>) {
    plan!(all: "rotation, tol 1e-9", [0 (2.5) 1] tol 1e-9 within 1000; theta);
    plan!(all: "rotation, any time", [0 (2.5) 1]; wrapped velocity position);
    plan!(all: "rotation, any time", [1 (-3) 1]; wrapped);
    plan!(all: "rotation, any time", [0 (2.00001) 1]; wrapped velocity);
    plan!(all: "rotation in pieces, any time", [0 (-2.0001) 1]; wrapped velocity acceleration);
    plan!(all: "positions in pieces of a rotation, any time", [0 (-2.00000000000001) 1] by polynomial; position);
}

/// The paper's θ̂ in pieces, as one polynomial, and next to an overshoot by the arcsine of the complement.
fn paper(all: &mut Vec<Class>) {
    pendula::pendulum! {
        struct InPieces;
        theta0 = 7π/8, n = 4
    }
    pendula::pendulum! {
        struct Whole;
        theta0 = 1π/3, n = 2
    }
    pendula::pendulum! {
        struct ByComplement;
        theta0 = 0.954π, n = 4
    }
    let class = |name: &str, theta0: &str, [promise, ceiling]: [f64; 2], proven, terms, evaluate| Class {
        name: format!("{name}: {theta0}"),
        start: Start::written(theta0, "0", "1").expect("numbers"),
        output: Output::Theta,
        horizon: f64::INFINITY,
        periods: ANY_TIME,
        promise,
        observable: promise,
        proven,
        ceiling,
        terms,
        evaluate,
    };
    let (bound, theta) = (InPieces::MAX_ERROR, over(InPieces::theta));
    all.push(class("n = 4, against the motion", "7π/8", [bound, InPieces::THETA0], Some(bound), None, theta));
    // θ̂ may go beyond the amplitude, by its error at most.
    let mut against = |name, start, (theta0, bound): (f64, f64), terms, theta| {
        let ulps = [8.0 * (theta0.next_up() - theta0), theta0 + bound];
        all.push(class(name, start, ulps, None, Some(terms), theta));
    };
    against("n = 4 in pieces, against θ̂", "7π/8", (InPieces::THETA0, InPieces::MAX_ERROR), 4, over(InPieces::theta));
    against("n = 2 as one polynomial, against θ̂", "1π/3", (Whole::THETA0, Whole::MAX_ERROR), 2, over(Whole::theta));
    against(
        "n = 4 by the complement, against θ̂",
        "0.954π",
        (ByComplement::THETA0, ByComplement::MAX_ERROR),
        4,
        over(ByComplement::theta),
    );
}

fn runtime(all: &mut Vec<Class>) {
    use std::f64::consts::PI;
    let states = [(7.0 * PI / 8.0, 0.0), (1e-9, 0.0), (PI - 1e-12, 0.0), (1.0, 1.0), (0.0, 2.5), (0.0, 2.0)];
    for (theta0, velocity0) in states {
        let pendulum = Pendulum::<f64>::from_state(theta0, velocity0, 1.0).expect("a motion");
        let start = Start { theta0: theta0.into(), velocity0: velocity0.into(), omega: 1.0.into() };
        let [theta, velocity] = largest(&Motion::new(start.clone()));
        // Relative to the amplitude from rest, to max(|θ|, 1) otherwise.
        let unit = if velocity0 == 0.0 { theta0 } else { 1.0 };
        let mut push = |output, largest: f64, unit: f64, evaluate| {
            let class = Class {
                name: format!("run time: θ0 = {theta0:e}, θ̇0 = {velocity0}"),
                start: start.clone(),
                output,
                horizon: f64::INFINITY,
                periods: RUN_TIME,
                promise: UNIT * unit,
                observable: UNIT * unit,
                proven: None,
                ceiling: largest,
                terms: None,
                evaluate,
            };
            all.push(class);
        };
        if theta.is_finite() {
            push(Output::Theta, theta, unit, over(move |t| pendulum.theta(t)));
        } else {
            push(Output::Wrapped, PI, unit, over(move |t| pendulum.wrapped(t)));
        }
        push(Output::Velocity, velocity, velocity, over(move |t| pendulum.velocity(t)));
    }
}
