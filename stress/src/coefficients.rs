//! K, K′, q and the coefficients of the paper's series against multiple precision: those of compiled plans to the bit,
//! and those of the run-time crate at random amplitudes in units in the last place.

use pendula::{Pendulum, elliptic};

use crate::big::Big;
use crate::finding::Finding;
use crate::generated::{Generated, generated};
use crate::motion::{Motion, Regime, Series, Start, quarters};
use crate::random::Random;
use crate::report::Row;
use crate::session::{Merge, Session};

/// What is compared at run time, and the error promised, in ulp.
const RUNTIME: [(&str, f64); 11] = [
    ("`elliptic::quarter_period`", 1.0),
    ("`elliptic::complementary_quarter_period`", 1.0),
    ("`elliptic::nome`", 1.0),
    ("`complementary::quarter_period`", 1.0),
    ("`complementary::complementary_quarter_period`", 1.0),
    ("`complementary::nome`", 1.0),
    ("`Pendulum::modulus`", 1.0),
    ("`Pendulum::complete_integral`", 1.0),
    ("`Pendulum::nome`", 1.0),
    ("`Pendulum::period`", 1.0),
    ("`Fourier::coefficients`, N = 4", 1.0),
];

/// Everything: `count` amplitudes at run time, and all compiled constants.
pub fn run(session: &Session, count: u64) -> Vec<Row> {
    let mut rows = runtime(session, count);
    rows.push(compiled(session));
    rows
}

/// Findings by what is compared.
#[derive(Default)]
struct All([Finding; RUNTIME.len()]);

impl Merge for All {
    fn merge(&mut self, other: Self) {
        for (mine, others) in self.0.iter_mut().zip(other.0) {
            mine.merge(others);
        }
    }
}

/// The run-time crate at `count` random amplitudes.
pub fn runtime(session: &Session, count: u64) -> Vec<Row> {
    let all = session.share("run time", count, |number, all: &mut All| {
        let mut random = Random::new(number);
        // Evenly by angle, near the bottom and near the top.
        let theta0 = match number % 3 {
            0 => 3.1 * random.unit() + 1e-3,
            1 => random.scaled(1e-9, 1.0).abs(),
            _ => std::f64::consts::PI - random.scaled(1e-12, 1.0).abs(),
        };
        elliptic_functions((0.5 * theta0).sin(), &mut all.0[..6]);
        pendulum(theta0, &mut all.0[6..]);
    });
    let rows = RUNTIME.into_iter().zip(all.0);
    rows.map(|((name, promise), found)| Row {
        subject: "run time".into(),
        output: name.into(),
        promise,
        proven: None,
        observable: promise,
        found,
    })
    .collect()
}

/// |given − exact| in ulp of the exact value.
fn ulps(given: f64, exact: &Big) -> f64 {
    let near = exact.to_f64().abs();
    let ulp = near.next_up() - near;
    (&Big::from(given) - exact).to_f64().abs() / ulp
}

fn note(found: &mut Finding, given: f64, exact: &Big, at: f64) {
    found.tried += 1;
    let error = ulps(given, exact);
    found.observe(error, at);
    if !error.is_finite() {
        found.fault(|| format!("{given:e} for {:e} at {at:e}", exact.to_f64()));
    }
}

/// By modulus and by complementary modulus, each taken as exact.
fn elliptic_functions(modulus: f64, found: &mut [Finding]) {
    // So near the top that k rounds to 1, whose K is infinite.
    if modulus == 1.0 {
        return;
    }
    let other = |x: f64| (&Big::from(1.0) - &(&Big::from(x) * &Big::from(x))).sqrt();
    let nome = |[quarter, complementary]: &[Big; 2]| (-&(&Big::pi() * &(complementary / quarter))).exp();
    let exact = quarters(&[modulus.into(), other(modulus)]);
    note(&mut found[0], elliptic::quarter_period(modulus), &exact[0], modulus);
    note(&mut found[1], elliptic::complementary_quarter_period(modulus), &exact[1], modulus);
    note(&mut found[2], elliptic::nome(modulus), &nome(&exact), modulus);
    // The same number as a complement exchanges K and K′.
    let exact = quarters(&[other(modulus), modulus.into()]);
    note(&mut found[3], elliptic::complementary::quarter_period(modulus), &exact[0], modulus);
    note(&mut found[4], elliptic::complementary::complementary_quarter_period(modulus), &exact[1], modulus);
    note(&mut found[5], elliptic::complementary::nome(modulus), &nome(&exact), modulus);
}

/// What the run-time pendulum says of itself.
fn pendulum(theta0: f64, found: &mut [Finding]) {
    let (Ok(pendulum), Regime::Swing(series)) =
        (Pendulum::<f64>::new(theta0, 1.0), Motion::new(Start::at_rest(theta0.into())).regime)
    else {
        return found[0].fault(|| format!("no swing from {theta0:e}"));
    };
    note(&mut found[0], pendulum.modulus(), &series.modulus[0], theta0);
    note(&mut found[1], pendulum.complete_integral(), &series.quarters[0], theta0);
    note(&mut found[2], pendulum.nome(), &series.nome, theta0);
    note(&mut found[3], pendulum.period(), &series.period, theta0);
    // Four terms overshoot from 0.9547π.
    if let Ok(fourier) = pendulum.fourier::<4>() {
        for (given, exact) in fourier.coefficients().iter().zip(&series.paper_coefficients(4)) {
            // Not where they underflow.
            if exact.to_f64() > f64::MIN_POSITIVE {
                note(&mut found[4], *given, exact, theta0);
            }
        }
    }
}

/// The constants of compiled plans, which are the correctly rounded ones of the exact angle.
pub fn compiled(session: &Session) -> Row {
    let plans = generated();
    let found = session.share("compiled", plans.len() as u64, |i, found: &mut Finding| {
        let plan = &plans[i as usize];
        if let Regime::Swing(series) = plan.motion().regime {
            compare(plan, &series, found);
        }
    });
    Row {
        subject: format!("{} compiled plans", plans.len()),
        output: "`MODULUS`, `K`, `K_PRIME`, `NOME`, `PERIOD`, `COEFFICIENTS`".into(),
        promise: 0.5,
        proven: None,
        observable: 0.5,
        found,
    }
}

fn compare(plan: &Generated, series: &Series, found: &mut Finding) {
    let [quarter, complementary] = &series.quarters;
    let exact = [&series.modulus[0], quarter, complementary, &series.nome, &series.period];
    let coefficients = series.paper_coefficients(plan.coefficients.len());
    let given = plan.constants.iter().chain(plan.coefficients);
    for (given, exact) in given.zip(exact.into_iter().chain(&coefficients)) {
        let rounded = if plan.float == "f32" { f64::from(exact.to_f32()) } else { exact.to_f64() };
        found.tried += 1;
        if plan.float == "f64" {
            found.observe(ulps(*given, exact), exact.to_f64());
        }
        if given.to_bits() != rounded.to_bits() {
            found.fault(|| format!("{} {}: {given:e} for {rounded:e}", plan.theta0, plan.float));
        }
    }
}
