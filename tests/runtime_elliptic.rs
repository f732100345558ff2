//! `elliptic` against mpmath over its domain, and its behaviour at the edges.

use pendula::elliptic::{self, Jacobi, complementary};
use pendula_stress::reference;

/// Half an ulp of 1.
const U: f64 = f64::EPSILON / 2.0;

/// Errors of K, K′, q, sn, cn, dn, am, F as fractions of the bounds that the module's documentation states.
fn errors(j: &Jacobi, u: f64, phi: f64, expected: [f64; 8]) -> [f64; 8] {
    let [k, kc, q, sn, cn, dn, am, f] = expected;
    let (s, c, d) = j.sn_cn_dn(u);
    let relative = |x: f64, exact: f64| (x - exact).abs() / exact.abs();
    [
        relative(j.quarter_period(), k) / (2.0 * U),
        relative(j.complementary_quarter_period(), kc) / (2.0 * U),
        relative(j.nome(), q) / (2.0 * U),
        (s - sn).abs() / if u < 1e-3 { 8.0 * U * sn } else { 6.0 * U },
        (c - cn).abs() / (6.0 * U), // of the 9 that are met where it vanishes
        (d - dn).abs() / (6.0 * U),
        (j.am(u) - am).abs() / if u < 1e-3 { 8.0 * U * am } else { 6.0 * U * am.max(1.0) },
        relative(j.incomplete(phi), f) / (2.0 * U),
    ]
}

#[test]
fn every_row_keeps_the_documented_error() {
    let (mut worst, mut rows) = ([0.0_f64; 8], 0);
    for (complement, [modulus, u, phi], expected) in reference::elliptic() {
        let j = if complement { Jacobi::from_complementary_modulus(modulus) } else { Jacobi::from_modulus(modulus) };
        let errors = errors(&j.expect("in [0, 1]"), u, phi, expected);
        worst = core::array::from_fn(|i| worst[i].max(errors[i]));
        assert!(errors.iter().all(|e| *e <= 1.0), "{complement} {modulus:e} at {u}: {errors:?}");
        rows += 1;
    }
    assert!(rows > 100, "{rows} rows");
    println!("worst error as a fraction of the documented bound: K, K', q, sn, cn, dn, am, F: {worst:.2?}");
}

#[test]
fn functions_are_those_of_the_prepared_modulus() {
    let j = Jacobi::from_modulus(0.8).expect("in [0, 1]");
    let (sn, cn, dn) = j.sn_cn_dn(1.1);
    assert_eq!((elliptic::sn(1.1, 0.8), elliptic::cn(1.1, 0.8), elliptic::dn(1.1, 0.8)), (sn, cn, dn));
    assert_eq!(elliptic::quarter_period(0.8), j.quarter_period());
    assert_eq!(elliptic::complementary_quarter_period(0.8), complementary::quarter_period(0.8));
    assert_eq!((elliptic::nome(0.8), elliptic::am(1.1, 0.8)), (j.nome(), j.am(1.1)));
    assert_eq!(elliptic::incomplete(1.1, 0.8), j.incomplete(1.1));
}

/// What is rounded to beyond the range of a function could not be its inverse's argument.
#[test]
fn values_stay_in_range() {
    assert_eq!(complementary::sn(4.503_599_627_370_496e15, 1.028_720_138_352_128e-15), -1.0);
    for i in 1..20_000 {
        let kc = 0.5 * f64::from(i) / 20_000.0;
        let j = Jacobi::from_complementary_modulus(kc).expect("in [0, 1]");
        for n in [1.0, 7.0, 12.0] {
            let (sn, cn, dn) = j.sn_cn_dn(n * j.quarter_period());
            assert!(sn.abs() <= 1.0 && cn.abs() <= 1.0 && (kc..=1.0).contains(&dn), "{kc} {n}: {sn} {cn} {dn}");
        }
    }
}

#[test]
fn the_circular_limit() {
    // sn is within 6·2⁻⁵³ of sin here, sin itself half an ulp.
    for u in [0.0, 1e-300, 0.3, 1.0, 2.0, 4.0, -5.0] {
        assert!((elliptic::sn(u, 0.0) - u.sin()).abs() <= 7.0 * U, "{u}");
        assert!((elliptic::cn(u, 0.0) - u.cos()).abs() <= 7.0 * U, "{u}");
        assert_eq!(elliptic::dn(u, 0.0), 1.0);
        assert!((elliptic::am(u, 0.0) - u).abs() <= 6.0 * U * u.abs(), "{u}");
        assert!((elliptic::incomplete(u, 0.0) - u).abs() <= 6.0 * U * u.abs(), "{u}");
    }
    assert_eq!(elliptic::quarter_period(0.0), core::f64::consts::FRAC_PI_2);
    assert_eq!(elliptic::complementary_quarter_period(0.0), f64::INFINITY);
    assert_eq!(elliptic::nome(0.0), 0.0);
}

#[test]
fn the_hyperbolic_limit() {
    for u in [0.0, 1e-300, 0.3, 1.0, 5.0, -20.0, 1e300] {
        assert!((elliptic::sn(u, 1.0) - u.tanh()).abs() <= 7.0 * U, "{u}");
        assert!((elliptic::cn(u, 1.0) - 1.0 / u.cosh()).abs() <= 7.0 * U, "{u}");
        assert!((elliptic::dn(u, 1.0) - 1.0 / u.cosh()).abs() <= 7.0 * U, "{u}");
        assert!((elliptic::am(u, 1.0) - u.sinh().atan()).abs() <= 7.0 * U, "{u}");
    }
    assert_eq!(elliptic::quarter_period(1.0), f64::INFINITY);
    assert_eq!((elliptic::nome(1.0), complementary::nome(0.0)), (1.0, 1.0));
    // F(φ, 1) = asinh(tan φ)
    assert!((elliptic::incomplete(1.0, 1.0) - 1.0_f64.tan().asinh()).abs() <= 7.0 * U);
}

#[test]
fn f_and_am_invert_each_other_at_any_angle() {
    for k in [0.1, 0.5, 0.9, 0.999_999] {
        let j = Jacobi::from_modulus(k).expect("in [0, 1]");
        for phi in [1e-10, 0.1, 1.5, 1.57, 1.58, 3.0, 3.2, 10.0, -100.0, 1e6] {
            // dF/dφ = 1/dn, at most 1/k′.
            let slope = 1.0 / (1.0 - k * k).sqrt();
            let back = j.am(j.incomplete(phi));
            assert!((back - phi).abs() <= 8.0 * U * (1.0 + phi.abs()) * slope, "{k} {phi} {back}");
        }
    }
}

/// Beyond the quarter turn F is a part and many K, of which only the sum is rounded; expected values by mpmath.
#[test]
fn incomplete_integrals_beyond_the_quarter_turn_are_within_an_ulp() {
    for (complement, phi, expected) in [
        (0.5, 2.2198071722000634, 3.2816404220585107),
        (0.9999999999999999, 7.946323804844804, 7.946323804844805),
        (1e-300, 1.6, 1380.09710762993),
        (0.1, 3.0, 7.249211365502322),
        (0.3, 1e15, 1672892460505136.2),
        (0.7, 6e22, 7.1147637815018225e+22),
        (1e-12, 1e300, 1.8472996773716873e301),
    ] {
        let error = (complementary::incomplete(phi, complement) - expected).abs();
        assert!(error <= expected.next_up() - expected, "{phi} {complement}: {error:e}");
        assert_eq!(complementary::incomplete(-phi, complement), -complementary::incomplete(phi, complement));
    }
    assert_eq!(complementary::incomplete(f64::MAX, 1.0), f64::MAX);
    assert_eq!(complementary::incomplete(-4.0, 0.0), f64::NEG_INFINITY);
}

#[test]
fn outside_the_domain_all_is_nan() {
    for bad in [-1e-300, 1.0_f64.next_up(), 2.0, f64::INFINITY, f64::NAN] {
        assert!(Jacobi::from_modulus(bad).is_none() && Jacobi::from_complementary_modulus(bad).is_none());
        let values =
            [elliptic::quarter_period(bad), elliptic::nome(bad), elliptic::sn(1.0, bad), complementary::am(1.0, bad)];
        assert!(values.iter().all(|x| x.is_nan()), "{bad}: {values:?}");
    }
    for bad in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let values =
            [elliptic::sn(bad, 0.5), elliptic::dn(bad, 0.5), elliptic::am(bad, 1.0), elliptic::incomplete(bad, 0.5)];
        assert!(values.iter().all(|x| x.is_nan()), "{bad}: {values:?}");
    }
}

/// What is odd is so to the bit, zeros among it, and what is even, too.
#[test]
fn parity() {
    for k in [0.0, 0.3, 0.999_999, 1.0] {
        let jacobi = Jacobi::from_modulus(k).expect("in [0, 1]");
        for u in [0.0, 1e-300, 1e-17, 0.3, 2.0, 7.5, 1e10] {
            let [(sn, cn, dn), (of_minus, cn_of_minus, dn_of_minus)] = [u, -u].map(|u| jacobi.sn_cn_dn(u));
            assert_eq!(
                [of_minus, cn_of_minus, dn_of_minus].map(f64::to_bits),
                [-sn, cn, dn].map(f64::to_bits),
                "{u} {k}"
            );
            assert_eq!(jacobi.am(-u).to_bits(), (-jacobi.am(u)).to_bits(), "{u} {k}");
            assert_eq!(jacobi.incomplete(-u).to_bits(), (-jacobi.incomplete(u)).to_bits(), "{u} {k}");
        }
    }
}

/// F is odd to the bit, and next to the quarter turn it is K less what Legendre's F(φ) + F(ψ) = K leaves, where
/// k′ tan φ tan ψ = 1: both angles are near π/2 for a small k′, and each needs its small cosine to the last digit.
#[test]
fn incomplete_integrals_next_to_the_quarter_turn() {
    for kc in [1e-3, 1e-8, 1e-14] {
        let jacobi = Jacobi::from_complementary_modulus(kc).expect("in [0, 1]");
        for part in [0.1, 0.5, 0.9] {
            // tan φ = k′^(−part), and φ as near as an `f64` comes: what it misses counts by dF/dφ.
            let phi = kc.powf(-part).atan();
            let psi = (phi.tan() * kc).recip().atan();
            let [f, g] = [phi, psi].map(|angle| jacobi.incomplete(angle));
            let slope = |angle: f64| 1.0 / angle.cos().hypot(kc);
            let slack = U * (slope(phi) * phi + slope(psi) * psi) * 2.0 + 16.0 * U * f.max(g);
            assert!((f + g - jacobi.quarter_period()).abs() <= slack, "{kc} {part}");
            assert_eq!(jacobi.incomplete(-phi).to_bits(), (-f).to_bits(), "{kc} {part}");
            assert_eq!(jacobi.incomplete(-psi).to_bits(), (-g).to_bits(), "{kc} {part}");
        }
    }
}
