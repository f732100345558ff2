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
    /// * theta: 4 harmonics by recurrence from one cosine of 9 terms, an arcsine by a polynomial of 13 terms; proven error ≤ 1.098e-2 rad (1.1e-2 of truncation, 1.3e-15 of phase, 4.3e-14 of rounding); 99 operations
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
    fn theta(t: f64) -> f64 {
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
        let p = if 0.2500000000000011_f64 < v_3 { 0.2500000000000011_f64 } else { v_3 };
        let p2 = p * p;
        let p4 = p2 * p2;
        let p8 = p4 * p4;
        let cosine = 1.0 - 4.934802200544676 * p
            + (4.058712126416498 - 1.335262768843456 * p) * p2
            + (0.23533063012967062 - 0.02580688873817758 * p
                + (0.001929556278037417 - 0.00010456656706174584 * p) * p2) * p4
            + 4.149578027057121e-6 * p8;
        let twice_cosine_of_double = cosine * cosine * 4.0 - 2.0;
        let v_4 = 0.034348775037953166 + twice_cosine_of_double * -0.006668088304975838;
        let v_5 = -0.17814652766733927 + twice_cosine_of_double * v_4
            + 0.006668088304975838;
        let argument = cosine
            * (1.130166863544064 + twice_cosine_of_double * v_5 - v_4 - v_5);
        let z_arcsine = if argument < 0.5 {
            argument * argument
        } else {
            (1.0 - argument) * 0.5
        };
        let x_arcsine = if argument < 0.5 {
            argument
        } else {
            ::pendula::__private::support::sqrt(z_arcsine)
        };
        let z2 = z_arcsine * z_arcsine;
        let z4 = z2 * z2;
        let z8 = z4 * z4;
        let double = x_arcsine
            * (1.0 + 0.16666666666664837 * z_arcsine
                + (0.0750000000040538 + 0.04464285679079935 * z_arcsine) * z2
                + (0.030381960288624933 + 0.022371736189056253 * z_arcsine
                    + (0.017359976290265915 + 0.013882964446353506 * z_arcsine) * z2)
                    * z4
                + (0.01218210162163291 + 0.006478999611110805 * z_arcsine
                    + (0.019647553451933614 - 0.01639265110477977 * z_arcsine) * z2
                    + 0.032017054581234806 * z4) * z8) * 2.0;
        let result = if argument < 0.5 {
            double
        } else {
            3.141592653589793 - (double + double)
        };
        f64::from_bits(result.to_bits() ^ (magic.to_bits() << 63))
    }
    theta
}
