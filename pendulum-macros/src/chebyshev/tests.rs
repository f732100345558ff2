use super::*;

#[test]
fn sums_of_chebyshev_polynomials() {
    for first in [0, 1, 2, 9] {
        for u in [-1.0, -0.3, 0.0, 0.77, 1.0_f64] {
            let t = |j: usize| (j as f64 * u.acos()).cos();
            let expected = 2.0 * t(first) - 0.5 * t(first + 1) + 0.25 * t(first + 2);
            let found = sum(&[2.0, -0.5, 0.25], first, u);
            assert!((found - expected).abs() < 1e-13, "{first} {u}: {found} {expected}");
        }
    }
}

#[test]
fn cosine_of_known_angles() {
    let half = cos_pi(Double::ONE / 3.0) - Double::new(0.5);
    assert!(half.hi.abs() < 1e-31);
    let root = cos_pi(Double::new(0.25));
    assert!((root * root - Double::new(0.5)).hi.abs() < 1e-31);
    assert!((sin_pi(Double::new(-0.5)) + Double::ONE).hi.abs() < 1e-31);
    // π/6 of it, less a sixth of the cube, which is nothing here.
    let small = Double::new(1e-20) / 3.0;
    assert!((sin_pi(small) - Double::PI * small).hi.abs() < 1e-51);
}

#[test]
fn recovers_a_polynomial() {
    // 3 − 2x + 5x³ = 3 + 1.75·T₁ + 1.25·T₃
    let table = CosineTable::new(9);
    let cubic = |x: Double| Double::new(3.0) - x * 2.0 + x * x * x * 5.0;
    let values: Vec<Double> = table.points().map(cubic).collect();
    let series = table.coefficients(&values);
    for (found, known) in series.iter().zip([3.0, 1.75, 0.0, 1.25, 0.0, 0.0, 0.0, 0.0, 0.0]) {
        assert!((*found - Double::new(known)).hi.abs() < 1e-30);
    }
    for (found, known) in to_powers(&series).iter().zip([3.0, -2.0, 0.0, 5.0]) {
        assert!((*found - Double::new(known)).hi.abs() < 1e-29);
    }
    // Σ cⱼ(2y − 1)ʲ at y = 1 and y = 0.
    let shifted = scale(shift(&to_powers(&series), Double::new(-1.0)), Double::new(2.0));
    let at_one = shifted.iter().fold(Double::ZERO, |sum, &c| sum + c);
    assert!((at_one - Double::new(6.0)).hi.abs() < 1e-29);
    assert!((shifted[0] - Double::ZERO).hi.abs() < 1e-29);
}

/// Interpolants of what is a polynomial are wrong by less than rounding may make of them.
#[test]
fn interpolation_is_rounded() {
    for points in [4, 24, 160] {
        let cubic = |x: Double| Double::new(0.3) + x * 0.7 + x * x * x * 5.0;
        let (series, rounding) = CosineTable::new(points).interpolant(cubic);
        let error = |i: u32| {
            let x = Double::new(f64::from(i) / 100.0 - 1.0);
            (value(&series, x) - cubic(x)).hi.abs()
        };
        let seen = (0..=200).map(error).fold(0.0, f64::max);
        let largest = 6.0 * 2f64.powi(-100) * (points * points) as f64;
        assert!(seen <= rounding && rounding <= 9.0 * largest, "{points}: {seen:e} {rounding:e}");
    }
}

/// T₃′ = 6T₂ + 3T₀, and of other sums what differences give, wrong by no more than is stated.
#[test]
fn derivatives() {
    let doubles = |series: &[f64]| series.iter().map(|&c| Double::new(c)).collect::<Vec<_>>();
    assert_eq!(derivative(&doubles(&[7.0, 0.0, 0.0, 1.0])), doubles(&[3.0, 0.0, 6.0]));
    assert_eq!(derivative(&doubles(&[7.0])), doubles(&[0.0]));
    let series: Vec<Double> = (0..24).map(|j| Double::new(1.0 / f64::from(j + 3)) / Double::new(7.0)).collect();
    let (slopes, step) = (derivative(&series), two_to(-34));
    for index in -15..=15 {
        let x = f64::from(index) / 16.0;
        // Fourth differences leave 10⁻³⁴ of the fifth derivative.
        let at = |steps: f64| value(&series, Double::from_sum(x, steps * step));
        let difference = ((at(1.0) - at(-1.0)) * 8.0 - (at(2.0) - at(-2.0))) / Double::new(12.0 * step);
        let error = (value(&slopes, Double::new(x)) - difference).hi.abs();
        assert!(error < 1e-17, "{x}: {error:e}");
    }
    let stated = rounding_of_derivative(&series);
    assert!((1e-28..1e-24).contains(&stated), "{stated:e}");
}

/// What becomes of series by their conversion, of variables about the middle and about an end: less than is stated.
#[test]
fn conversions() {
    for terms in [2, 5, 12, 24] {
        for (factor, by) in [(1.0, 0.0), (8.0, -1.0), (8.0, 0.25)] {
            let series: Vec<Double> =
                (0..terms).map(|j| Double { hi: 0.7f64.powi(j), lo: 1e-17 * 0.7f64.powi(j) }).collect();
            let [factor, by] = [factor, by].map(Double::new);
            let powers = scale(shift(&to_powers(&series), by), factor);
            // τ = factor·y + by from −1 to 1.
            let error = |i: u32| {
                let tau = Double::new(f64::from(i) / 100.0 - 1.0);
                let y = (tau - by) / factor;
                let found = powers.iter().rev().fold(Double::ZERO, |sum, &c| c + sum * y);
                (found - value(&series, tau)).hi.abs()
            };
            let seen = (0..=200).map(error).fold(0.0, f64::max);
            let most = rounding_of_powers(&series, 1.0 + 2.0 * by.hi.abs());
            assert!(seen <= most + 1e-31, "{terms} {by:?}: {seen:e} {most:e}");
        }
    }
}

/// 1/(a − x), whose pole lies on the ellipse with parameter a + √(a² − 1).
#[test]
fn interpolation_is_as_wrong_as_it_may_be() {
    let pole = 1.5;
    let rho = 0.95 * (pole + (pole * pole - 1.0_f64).sqrt());
    let bound = 1.0 / (pole - 0.5 * (rho + 1.0 / rho));
    for points in [4, 9, 16] {
        let table = CosineTable::new(points);
        let function = |x: Double| Double::ONE / (Double::new(pole) - x);
        let values: Vec<Double> = table.points().map(function).collect();
        let series = table.coefficients(&values);
        let error = |i: u32| {
            let x = Double::new(f64::from(i) / 100.0 - 1.0);
            (value(&series, x) - function(x)).hi.abs()
        };
        let (seen, limit) = ((0..=200).map(error).fold(0.0, f64::max), interpolation_error(bound, rho, points));
        assert!(seen <= limit && limit < 80.0 * seen, "{points}: {seen:e} {limit:e}");
        assert_eq!(points_for(bound, rho, limit * 1.001), points as f64);
        assert_eq!(points_for(bound, rho, limit * 0.999), points as f64 + 1.0);
    }
}

/// max Σ|ℓⱼ(x)|, attained at the ends.
#[test]
fn lebesgues_constant() {
    for points in [2, 10, 40] {
        let nodes: Vec<f64> = CosineTable::new(points).points().map(|x| x.hi).collect();
        let basis = |j: usize| -> f64 {
            let factor = |i: usize| if i == j { 1.0 } else { (1.0 - nodes[i]) / (nodes[j] - nodes[i]) };
            (0..points).map(factor).product()
        };
        let exact: f64 = (0..points).map(|j| basis(j).abs()).sum();
        assert!(exact <= lebesgue(points) && lebesgue(points) < 1.04 * exact, "{points}: {exact}");
    }
}
