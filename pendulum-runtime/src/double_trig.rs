//! Sine and cosine in two words, for the constants computed once per pendulum.

use crate::double::Double;
use crate::kernel::horner;

const SINE_HEAD: [Double; 8] = [
    Double { hi: -0.16666666666666666, lo: -9.25185853854297e-18 },
    Double { hi: 0.008333333333333333, lo: 1.1564823173178714e-19 },
    Double { hi: -0.0001984126984126984, lo: -1.7209558293420705e-22 },
    Double { hi: 2.7557319223985893e-06, lo: -1.858393274046472e-22 },
    Double { hi: -2.505210838544172e-08, lo: 1.448814070935912e-24 },
    Double { hi: 1.6059043836821613e-10, lo: 1.2585294588752098e-26 },
    Double { hi: -7.647163731819816e-13, lo: -7.03872877733453e-30 },
    Double { hi: 2.8114572543455206e-15, lo: 1.6508842730861433e-31 },
];
const SINE_TAIL: [f64; 5] = [
    -8.22063524662433e-18,
    1.9572941063391263e-20,
    -3.868170170630684e-23,
    6.446950284384474e-26,
    -9.183689863795546e-29,
];
const COSINE_HEAD: [Double; 8] = [
    Double { hi: -0.5, lo: 0.0 },
    Double { hi: 0.041666666666666664, lo: 2.3129646346357427e-18 },
    Double { hi: -0.001388888888888889, lo: 5.300543954373577e-20 },
    Double { hi: 2.48015873015873e-05, lo: 2.1511947866775882e-23 },
    Double { hi: -2.755731922398589e-07, lo: -2.3767714622250297e-23 },
    Double { hi: 2.08767569878681e-09, lo: -1.20734505911326e-25 },
    Double { hi: -1.1470745597729725e-11, lo: -2.0655512752830745e-28 },
    Double { hi: 4.779477332387385e-14, lo: 4.399205485834081e-31 },
];
const COSINE_TAIL: [f64; 5] = [
    -1.5619206968586225e-16,
    4.110317623312165e-19,
    -8.896791392450574e-22,
    1.6117375710961184e-24,
    -2.4795962632247976e-27,
];

/// y·P(y), where P's first coefficients are `head` and the others, below 2⁻⁵³ of the sum, `tail`.
fn series(y: Double, head: &[Double; 8], tail: &[f64; 5]) -> Double {
    let mut sum = Double::new(horner(tail, y.hi));
    for &c in head.iter().rev() {
        sum = sum * y + c;
    }
    sum * y
}

/// sin x for |x| ≤ 0.8, relative error below 2⁻¹⁰². Taylor to x²⁷/27!, whose successor is below 2⁻¹⁰⁷ there.
#[must_use]
pub fn sin_small(x: Double) -> Double {
    x + x * series(x * x, &SINE_HEAD, &SINE_TAIL)
}

/// cos x for |x| ≤ 0.8, relative error below 2⁻¹⁰². Taylor to x²⁶/26!, whose successor is below 2⁻¹⁰⁷ there.
#[must_use]
pub fn cos_small(x: Double) -> Double {
    Double::ONE + series(x * x, &COSINE_HEAD, &COSINE_TAIL)
}

/// (sin(θ/2), cos(θ/2)) for 0 ≤ θ ≤ π, both with small *relative* error: near the top the cosine is the sine of
/// half of π − θ, with π in three words, so π − 10⁻¹² and even the last `f64` below π keep all digits.
pub(crate) fn half_angle(theta: Double) -> (Double, Double) {
    half_angle_from_top(theta, supplement(theta))
}

/// The same where π − θ is known by itself.
pub(crate) fn half_angle_from_top(theta: Double, from_top: Double) -> (Double, Double) {
    if theta.hi <= core::f64::consts::FRAC_PI_2 {
        let half = theta.scale(0.5);
        (sin_small(half), cos_small(half))
    } else {
        let half = from_top.scale(0.5);
        (cos_small(half), sin_small(half))
    }
}

/// The third word of π.
const PI_THIRD: f64 = -2.994_769_809_718_339_7e-33;

/// π − θ, with small relative error.
pub(crate) fn supplement(theta: Double) -> Double {
    (Double::new(Double::PI.hi) - Double::new(theta.hi))
        + (Double::new(Double::PI.lo) - Double::new(theta.lo))
        + Double::new(PI_THIRD)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::double::relative_error;
    use crate::kernel::two_to;

    /// As promised.
    const BOUND: f64 = two_to(-102);

    /// Expected values by mpmath.
    #[test]
    fn sine_and_cosine_in_two_words() {
        let (half, most) = (Double::new(0.5), Double::new(0.8));
        let close = |x, exact| assert!(relative_error(x, exact) <= BOUND, "{x:?} {exact:?}");
        close(sin_small(half), Double { hi: 0.479425538604203, lo: -5.103969860556013e-18 });
        close(cos_small(half), Double { hi: 0.8775825618903728, lo: -4.2623149864279997e-17 });
        close(sin_small(most), Double { hi: 0.7173560908995228, lo: 1.1851419720716684e-18 });
        close(cos_small(most), Double { hi: 0.6967067093471654, lo: 1.9275818349860986e-18 });
        assert_eq!(sin_small(Double::new(1e-300)), Double::new(1e-300));
    }

    #[test]
    fn half_angles_near_the_top_keep_the_small_cosine() {
        let (_, cosine) = half_angle(Double::new(3.141592653588793));
        assert!(relative_error(cosine, Double { hi: 5.001056826311279e-13, lo: -1.2536990227779046e-29 }) <= BOUND);
        let (sine, cosine) = half_angle(Double::new(core::f64::consts::PI));
        assert!(relative_error(cosine, Double { hi: 6.123233995736766e-17, lo: -1.4973849048591698e-33 }) <= BOUND);
        assert_eq!(sine.hi, 1.0);
    }

    #[test]
    fn half_angles_obey_pythagoras() {
        for i in 0..=1000 {
            let (sine, cosine) = half_angle(Double::PI * (f64::from(i) / 1000.0));
            // Twice each relative bound, weighted by the squares.
            assert!(relative_error(sine * sine + cosine * cosine, Double::ONE) <= 4.0 * BOUND);
        }
    }
}
