use super::*;
use crate::exact::Context;

fn context() -> Context {
    Context::for_digits(20)
}

#[test]
fn tmp_time() {
    let c = context();
    let th = c.pi() * c.ratio(7, 8);
    let s = std::time::Instant::now();
    for _ in 0..20 {
        let _ = Motion::solve(&th, &c.integer(0), &c.integer(1)).unwrap();
    }
    eprintln!("rest {:?}", s.elapsed() / 20);
    let s = std::time::Instant::now();
    for _ in 0..20 {
        let m = Motion::solve(&c.integer(1), &c.integer(1), &c.integer(1)).unwrap();
        let Regime::Swing(w) = m.regime else { panic!() };
        if false {
            eprintln!("{} {}", w.launch.to_f64(), w.amplitude.to_f64());
        }
    }
    eprintln!("mid {:?}", s.elapsed() / 20);
    let m = Motion::solve(&c.integer(1), &c.integer(1), &c.integer(1)).unwrap();
    let Regime::Swing(w) = m.regime else { panic!() };
    eprintln!("{} {}", w.launch.to_f64(), w.amplitude.to_f64());
    let m = Motion::solve(&c.integer(1), &c.integer(2), &c.integer(1)).unwrap();
    let Regime::Rotation(w) = m.regime else { panic!() };
    eprintln!("{} {}", w.launch.to_f64(), w.fastest.to_f64());
}
