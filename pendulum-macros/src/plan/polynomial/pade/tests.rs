use super::*;
use crate::plan::aim::Task;
use crate::plan::curve::Curve;
use crate::plan::tests::scene;

/// The curves of an output, and their series.
fn curves(text: &str) -> (Vec<Curve>, Vec<Approximation>) {
    let task = Task::new(&scene(&format!("struct Motion; {text}")));
    let curves = task.aims[0].curves.clone();
    let plain = curves.iter().map(|curve| Approximation::new(curve, None, 1e-22).unwrap()).collect();
    (curves, plain)
}

/// Interpolated anew, over the poles: the coefficients that were to vanish do, but for the rounding of the poles to 24
/// bits.
#[test]
fn coefficients_vanish() {
    for (text, terms, vanishing_too) in [
        ("theta0 = 7π/8", 9, 1),
        ("theta0 = 7π/8, outputs = [velocity]", 6, 1),
        ("theta0 = 1, outputs = [velocity]", 4, 1),
        ("theta0 = 7π/8, outputs = [position]", 7, 0),
        ("velocity0 = 2.1, outputs = [velocity]", 5, 1),
    ] {
        let (curves, plain) = curves(text);
        let series: Vec<Series> = plain.iter().map(Series::new).collect();
        let pole = vanishing(&series, terms).unwrap();
        for (curve, plain) in curves.iter().zip(&plain) {
            let over = Approximation::new(curve, Some(pole), 1e-22).unwrap();
            for index in terms..=terms + vanishing_too {
                let [found, before] = [&over, plain].map(|series| series.series()[index].hi.abs());
                assert!(found < 1e-7 * before, "{text} {index}: {found:e} {before:e}");
            }
        }
    }
}

/// Fewer terms than over the nearest poles, by interpolation over either; and at most one each less than counted by
/// magnitudes.
#[test]
fn terms_saved() {
    for (text, limit, saved) in [
        ("theta0 = 7π/8", 1e-9, 4),
        ("theta0 = 7π/8", 1e-12, 2),
        ("theta0 = 1", 1e-12, 3),
        ("theta0 = 0.99π", 1e-9, 4),
        ("theta0 = 7π/8, outputs = [velocity]", 1e-6, 1),
        ("theta0 = 1, outputs = [velocity]", 1e-9, 2),
        ("theta0 = 7π/8, outputs = [position]", 1e-11, 2),
        ("theta0 = 7π/8, outputs = [position]", 1e-9, 0),
        ("velocity0 = 2.1, outputs = [velocity]", 1e-9, 2),
    ] {
        let (curves, plain) = curves(text);
        let nearest = Pole::new(curves[0].strip(), 1);
        let (pole, terms) = best(&plain, nearest, limit).unwrap();
        let count = |pole: Pole| {
            let terms = |curve| Approximation::new(curve, Some(pole), 1e-22).unwrap().terms_for(limit, 0.0).unwrap();
            curves.iter().map(terms).sum::<usize>()
        };
        let found = count(pole);
        assert_eq!(count(nearest), found + saved, "{text} {limit:e}");
        assert!((found..=found + curves.len()).contains(&terms), "{text} {limit:e}: {found} {terms}");
        assert!(saved > 0 || pole == nearest, "{text} {limit:e}");
    }
}

/// Without poles, or where they are real, there is nothing to divide by; and no number of terms serves an error of
/// nought.
#[test]
fn no_poles() {
    assert_eq!(Pole::of(0.01, -0.3), None);
    assert_eq!(Pole::of(f64::NAN, 1.0), None);
    assert_eq!(Pole::of(0.25, f64::INFINITY), None);
    let pole = Pole::of(0.5, -0.25).unwrap();
    assert_eq!((pole.place.hi, pole.height_squared.hi), (0.125, f64::from(0.484_375_f32)));
    let (curves, plain) = curves("theta0 = 1");
    assert_eq!(best(&plain, Pole::new(curves[0].strip(), 1), 0.0), None);
}
