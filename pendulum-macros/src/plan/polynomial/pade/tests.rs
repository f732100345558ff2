use super::*;
use crate::plan::curve::Curve;
use crate::plan::task::Task;
use crate::testing::scene;

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
        let pole = vanishing(&series, terms, Float::F64).unwrap();
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
        let nearest = Pole::new(curves[0].strip(), 1, Float::F64);
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
    assert_eq!(Pole::of([0.01, -0.3], Float::F64), None);
    assert_eq!(Pole::of([f64::NAN, 1.0], Float::F64), None);
    assert_eq!(Pole::of([0.25, f64::INFINITY], Float::F64), None);
    let pole = Pole::of([0.5, -0.25], Float::F64).unwrap();
    let pair = pole.pairs().next().unwrap();
    assert_eq!((pair.place.hi, pair.height_squared.hi), (0.125, f64::from(0.484_375_f32)));
    let (curves, plain) = curves("theta0 = 1");
    assert_eq!(best(&plain, Pole::new(curves[0].strip(), 1, Float::F64), 0.0), None);
}

/// A second pair saves terms where it is said to, and there are poles of the curve by which it does.
#[test]
fn terms_saved_by_two() {
    for (text, limit, saved) in [
        ("theta0 = 7π/8", 1e-12, 3),
        ("theta0 = π - 1e-5", 1e-9, 3),
        ("theta0 = 7π/8, outputs = [velocity]", 1e-14, 3),
        ("theta0 = 0.9999π, outputs = [velocity]", 1e-12, 7),
        ("theta0 = 7π/8, outputs = [position]", 1e-12, 4),
    ] {
        let (curves, plain) = curves(text);
        let (first, _) = best(&plain, Pole::new(curves[0].strip(), 1, Float::F64), limit).unwrap();
        let pole = two(&plain, first, limit).unwrap();
        assert!(pole.is_of_two() && !first.is_of_two(), "{text}");
        let count = |pole: Pole| {
            let terms = |curve| Approximation::new(curve, Some(pole), 1e-22).unwrap().terms_for(limit, 0.0).unwrap();
            curves.iter().map(terms).sum::<usize>()
        };
        assert_eq!(count(first), count(pole) + saved, "{text} {limit:e}");
    }
    // Of few terms none are saved.
    let (curves, plain) = curves("theta0 = 1");
    let (first, _) = best(&plain, Pole::new(curves[0].strip(), 1, Float::F64), 1e-3).unwrap();
    assert_eq!(two(&plain, first, 1e-3), None);
    assert_eq!(two(&plain, first, 0.0), None);
}

/// Of a product of two quadratic polynomials both are found, from either; of one without such factors next to which the
/// method converges none.
#[test]
fn quadratic_factors() {
    let pairs = [[0.11, -0.6], [0.09, -0.45], [0.3, 0.5]];
    for (first, second) in pairs.into_iter().flat_map(|first| pairs.map(|second| (first, second))) {
        let ([c, b], [e, d]) = (first, second);
        let quartic = [c * e, b * e + c * d, c + e + b * d, b + d];
        for near in [first, second].map(|[constant, linear]| [1.02 * constant, 0.99 * linear]) {
            let Some(found) = quadratics(quartic, near) else {
                assert_eq!(first, second);
                continue;
            };
            let product = |[[c, b], [e, d]]: [[f64; 2]; 2]| [c * e, b * e + c * d, c + e + b * d, b + d];
            let error = product(found).iter().zip(quartic).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            assert!(error < 1e-12, "{first:?} {second:?}: {found:?}");
        }
    }
    assert_eq!(quadratics([f64::NAN; 4], [0.1, -0.5]), None);
}
