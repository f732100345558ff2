//! Interpreted plans against the exact motion.

use super::*;
use crate::check::check;
use crate::exact::Real;
use crate::motion::Regime;
use crate::parse::parse;
use crate::report::Report;
use pendulum_runtime::double::Double;

pub(crate) fn scene(text: &str) -> Scene {
    let mut report = Report::default();
    let request = parse(text.parse().unwrap(), &mut report);
    let scene = request.and_then(|request| check(request, &mut report));
    report.finish().unwrap();
    scene.unwrap()
}

/// The phase of time t: (remainder, parity of the anchor).
fn phase(rate: &Real, launch: &Real, t: f64) -> (Double, bool) {
    let x = rate * &rate.context().float(t).unwrap() + launch;
    let n = x.round();
    let odd = (&n.scale(-1) - &n.scale(-1).round()).abs().to_f64() > 0.25;
    ((x - n).to_double(), odd)
}

fn observed(scene: &Scene, plan: &Plan, samples: usize) -> Vec<f64> {
    let Regime::Swing(swing) = &scene.motion.regime else { panic!() };
    let rate = crate::series::swing_rate(swing);
    let horizon = scene.t_max.as_ref().map_or(9e15 / rate.to_f64() * 2.0, Real::to_f64);
    let mut seed = 0x9e37_79b9_7f4a_7c15u64;
    let mut random = || {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut worst = vec![];
    for (aim, function) in aim::Task::new(scene).aims.iter().zip(&plan.functions) {
        let mut most: f64 = 0.0;
        for i in 0..samples {
            let t = if i % 2 == 0 {
                horizon * (2.0 * random() - 1.0)
            } else {
                (2.0 * random() - 1.0) * 2.0 / rate.to_f64()
            };
            let t = scene.float.round(t);
            let (s, odd) = phase(&rate, &swing.launch, t);
            let values = function.program.run(t);
            let mut sum: f64 = 0.0;
            for (value, curve) in values.iter().zip(&aim.curves) {
                let truth = curve.at(s);
                let flip = curve.alternates && (odd ^ swing.mirrored);
                let truth = if flip { -truth } else { truth };
                sum += (Double::new(*value) - truth).hi.powi(2);
            }
            most = most.max(sum.sqrt());
        }
        worst.push(most);
    }
    worst
}

#[test]
fn look() {
    for (theta, rest) in [
        ("7π/8", "tol = 1e-6, t_max = 938, outputs = [theta, velocity]"),
        ("7π/8", "tol = 1e-9, t_max = 938, outputs = [theta, velocity]"),
        ("7π/8", "tol = 1e-12, t_max = 938, outputs = [theta, velocity]"),
    ] {
        let clock = std::time::Instant::now();
        let scene = scene(&format!("struct A; theta0 = {theta}, {rest}"));
        let solved = clock.elapsed();
        match plan(&scene) {
            Ok(plan) => {
                let time = clock.elapsed();
                let worst = observed(&scene, &plan, 2000);
                println!(
                    "{theta} {rest}: {:?} solve {solved:?} total {time:?} cost {}",
                    plan.reduction.method,
                    plan.cost()
                );
                for (part, worst) in plan.parts.iter().zip(worst) {
                    println!(
                        "   {:?} {:?} terms {:?} bound {:.2e} {:?} ratio {:.2} rel {:.2}u",
                        part.output,
                        part.description,
                        part.kernel.terms(),
                        part.bound.total(),
                        part.bound,
                        part.bound.total() / worst,
                        worst / scene.float.unit() / 2.7
                    );
                }
            }
            Err(e) => println!("{theta} {rest}: {e:?} {:?}", clock.elapsed()),
        }
    }
}

fn written(parameter: &str) -> String {
    // 999*pi/1000, pi-10^-9, 2+10^-6
    let mut out = parameter.to_owned();
    for n in [2, 3, 4, 6, 9, 12] {
        out = out.replace(&format!("10^-{n}"), &format!("1e-{n}"));
    }
    out.replace("10^6", "1e6")
}

#[test]
fn reference() {
    let Ok(path) = std::env::var("REFERENCE") else { return };
    let text = std::fs::read_to_string(path).unwrap();
    let mut groups: Vec<(String, Vec<Vec<String>>)> = Vec::new();
    for line in text.lines().skip(1) {
        let row: Vec<String> = line.split(',').map(str::to_owned).collect();
        let key = format!("{} {}", row[0], row[1]);
        match groups.last_mut() {
            Some((last, rows)) if *last == key => rows.push(row),
            _ => groups.push((key, vec![row])),
        }
    }
    for (key, rows) in groups {
        let (kind, parameter) = key.split_once(' ').unwrap();
        let start = if kind == "lib" { "theta0" } else { "velocity0" };
        let extra = std::env::var("EXTRA").unwrap_or_default();
        let text = format!("struct A; {start} = {}, outputs = [theta, velocity, wrapped] {extra}", written(parameter));
        let scene = scene(&text);
        let clock = std::time::Instant::now();
        let plan = match plan(&scene) {
            Ok(plan) => plan,
            Err(e) => {
                println!("{key}: {e:?}");
                continue;
            }
        };
        let time = clock.elapsed();
        let context = crate::exact::Context::for_digits(60);
        let mut worst = [0f64; 3];
        for row in &rows {
            let t = f64::from_bits(u64::from_str_radix(&row[7][2..], 16).unwrap());
            if row[6] == "extreme" || row[6] == "big" && kind == "rot" {
                continue;
            }
            for (index, column) in [9, 10, 11].into_iter().enumerate() {
                let Ok(Some(truth)) = std::panic::catch_unwind(|| context.decimal(&row[column])) else {
                    println!("?? {}", row[column]);
                    continue;
                };
                let got = plan.functions[index].program.run(t)[0];
                let error = (context.float(got).unwrap_or_else(|| panic!("{key} {t}: {got}")) - &truth).abs().to_f64();
                let scale = plan.parts[index].largest.min(4.0).max(truth.abs().to_f64().min(if kind == "rot" {
                    1e300
                } else {
                    0.0
                }));
                let relative = error / scale * 2f64.powi(50);
                if relative > 1.0 {
                    println!("   {key} {index} t={t:e} {} got {got} truth {}", row[6], row[column]);
                }
                worst[index] = worst[index].max(relative);
            }
        }
        println!(
            "{key}: {time:?} cost {} {} worst/2^-50 {:.2?} proven/2^-49 {:.2?}",
            plan.cost(),
            plan.parts[0].description,
            worst,
            plan.parts.iter().map(|p| p.bound.total() / p.largest * 2f64.powi(49)).collect::<Vec<_>>()
        );
    }
}

#[test]
fn terms() {
    for text in ["theta0 = 7π/8", "theta0 = π/3", "theta0 = 0.95π"] {
        let scene = scene(&format!("struct A; {text}"));
        let task = aim::Task::new(&scene);
        let a = polynomial::Approximation::new(&task.aims[0].curves[0], 0, 1e-17).unwrap();
        println!("{text} {:?}", (2..20).map(|n| (n, format!("{:.3e}", a.truncation(n, 0.0)))).collect::<Vec<_>>());
        println!("   {:?}", a.series[..20].iter().map(|x| format!("{:.3e}", x.hi)).collect::<Vec<_>>());
    }
}
