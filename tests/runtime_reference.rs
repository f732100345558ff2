//! The runtime against independent truth: every row of `data/reference.csv`.

use pendulum_runtime::Pendulum;

struct Row {
    rest: bool,
    parameter: f64,
    t: f64,
    theta: (f64, f64),
    velocity: (f64, f64),
}

fn rows() -> impl Iterator<Item = Row> {
    include_str!("data/reference.csv").lines().filter(|line| !line.starts_with('#')).map(|line| {
        let mut cells = line.split(',');
        let rest = cells.next() == Some("rest");
        let mut cell = || cells.next().expect("seven columns");
        let bits = |s: &str| f64::from_bits(u64::from_str_radix(s, 16).expect("the bits of an f64"));
        let decimal = |s: &str| s.parse().expect("a number");
        Row {
            rest,
            parameter: bits(cell()),
            t: bits(cell()),
            theta: (bits(cell()), decimal(cell())),
            velocity: (bits(cell()), decimal(cell())),
        }
    })
}

#[test]
fn probe() {
    let mut worst = std::collections::BTreeMap::new();
    for row in rows() {
        let p = if row.rest {
            Pendulum::<f64>::new(row.parameter, 1.0)
        } else {
            Pendulum::from_state(0.0, row.parameter, 1.0)
        }
        .unwrap();
        let unit = 2f64.powi(-50);
        let scale = if row.rest { row.parameter } else { row.theta.0.abs().max(1.0) };
        let e = ((p.theta(row.t) - row.theta.0) - row.theta.1).abs() / scale / unit;
        let top = if row.rest { 2.0 * (row.parameter / 2.0).sin() } else { row.parameter };
        let ev = ((p.velocity(row.t) - row.velocity.0) - row.velocity.1).abs() / top / unit;
        let periods = row.t.abs() / p.period();
        let far = if periods > 2f64.powi(45) {
            2
        } else if periods > 1e6 {
            1
        } else {
            0
        };
        let w = worst.entry((row.rest, row.parameter.to_bits(), far)).or_insert((0.0, 0.0, 0.0, 0.0));
        if e > w.0 || e.is_nan() {
            w.0 = e;
            w.2 = row.t
        }
        if ev > w.1 || ev.is_nan() {
            w.1 = ev;
            w.3 = row.t
        }
    }
    for ((rest, p, far), w) in worst {
        println!("{rest} {} far {far}: {:.3} {:.3} at {:e} {:e}", f64::from_bits(p), w.0, w.1, w.2, w.3);
    }
}
