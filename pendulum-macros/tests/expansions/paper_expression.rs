// What this expands to; written by src/snapshots.rs.
//
//     theta0 = 7π/8, n = 4

fn expression() -> impl Copy {
    /// The motion of a pendulum, θ̈ + ω² sin θ = 0, for `theta0 = 7π/8, n = 4`.
    ///
    /// * θ(0) = 2.748893571891069 rad, θ̇(0) = 0.0, ω = 1.0
    /// * a swing between ±2.748893571891069 rad with the period T = 12.160802258580567
    /// * k = 0.9807852804032304, K = 3.0402005646451418, K′ = 1.5860712391076077, q = 0.19418044072494273
    ///
    /// Planned for the paper's θ̂ with 4 terms (Eq. 22), over 2⁵³ periods:
    ///
    /// * phase: exact products with the rate in 4 words, wrong by at most 1.1e-16 anchors
    /// * theta: 4 harmonics folded into a polynomial of 18 terms in 8s² − 1, an arcsine by a polynomial of 19 terms; proven error ≤ 1.098e-2 rad (1.1e-2 of truncation, 1.3e-15 of phase, 9.6e-15 of rounding); 115 operations
    /// * coefficients of sn: b1 = 1.1523081413695546, b3 = 0.18163662447513268, b5 = 0.03502170732398364, b7 = 0.0067987238779056575
    #[allow(
        dead_code,
        unused_qualifications,
        clippy::all,
        clippy::pedantic,
        clippy::nursery,
        clippy::arithmetic_side_effects,
        clippy::as_conversions,
        clippy::float_arithmetic,
        clippy::float_cmp,
        clippy::min_ident_chars,
        clippy::missing_inline_in_public_items,
        clippy::missing_docs_in_private_items,
        clippy::single_call_fn
    )]
    #[inline(always)]
    const fn theta(t: f64) -> f64 {
        let head = f64::from_bits(t.to_bits() & 0xfffffffffc000000);
        let tail = t - head;
        let v = head * 0.1644628345966339;
        let first = v - (v + 5.404319552844595e16 - 5.404319552844595e16);
        let v_2 = tail * 0.1644628345966339 + head * -8.564655651355224e-10;
        let second = v_2 - (v_2 + 5.404319552844595e16 - 5.404319552844595e16);
        let third = tail * -8.564655651355224e-10 + head * 4.710335330430138e-17;
        let fourth = tail * 4.710335330430138e-17 + t * 9.387273175688693e-25;
        let magic = first + second + third + 6755399441055744.0;
        let n = magic - 6755399441055744.0;
        let s = first - n + second + third + fourth;
        let v_3 = s * s;
        let p = if 0.2500009536752261_f64 < v_3 { 0.2500009536752261_f64 } else { v_3 };
        let u = p * 8.0 - 1.0;
        let u2 = u * u;
        let u4 = u2 * u2;
        let u8 = u4 * u4;
        let u16 = u8 * u8;
        let argument = 0.7018130433969925 - 0.5291889982552708 * u
            + (-0.2826079120114372 + 0.04943072457380841 * u) * u2
            + (0.09716441844940404 - 0.029805017900611113 * u
                + (-0.018951675363534475 + 0.017743895627790485 * u) * u2) * u4
            + (-0.007184978771351389 + 0.0019105349428924334 * u
                + (-0.00037515516992174243 + 5.7605262742027504e-5 * u) * u2
                + (-7.164361935674084e-6 + 7.395923243101023e-7 * u
                    + (-6.454501042747263e-8 + 4.8333597818805465e-9 * u) * u2) * u4)
                * u8 + (-3.1835451922286057e-10 + 1.81134646028934e-11 * u) * u16;
        let z = (1.0 - argument) * 0.5;
        let root = ::pendula::__private::support::root(z);
        let z2 = z * z;
        let z4 = z2 * z2;
        let z8 = z4 * z4;
        let z16 = z8 * z8;
        let result = 3.141592653589793
            - root
                * (1.0 + 0.16666666666664692 * z
                    + (0.075000000004661 + 0.044642856707040525 * z) * z2
                    + (0.030381965927734657 + 0.02237151471508333 * z
                        + (0.017365564198693513 + 0.013787050989347117 * z) * z2) * z4
                    + (0.013342636659204767 - 0.003640901406691777 * z
                        + (0.08407513894478745 - 0.31781098908834565 * z) * z2
                        + (1.0702391529183808 - 2.629224219313825 * z
                            + (4.87039834346951 - 6.499638137651803 * z) * z2) * z4) * z8
                    + (5.974990353733298 - 3.3847332031160233 * z
                        + 0.9129216870797077 * z2) * z16) * 4.0;
        f64::from_bits(result.to_bits() ^ (magic.to_bits() << 63))
    }
    theta
}
