//! What uses an item that was refused is no mistake: what is known of it, it has.

pendula::pendulum! {
    struct Paper;
    theta0 = 0.95π, n = 2
}
const SECOND: f64 = Paper::COEFFICIENTS[1];
const BOTH: [f64; 2] = Paper::COEFFICIENTS;
const _: () = assert!(Paper::PERIOD > 6.0 && 10 / Paper::TERMS > 0);

pendula::pendulum! {
    struct Fine;
    theta0 = 1, tol = 1e-30, float = f32
}
const _: () = assert!(Fine::PERIOD > 6.0 && Fine::THETA0 == 1.0);

pendula::pendulum! {
    struct Quoted;
    theta0 = 1, tol = 1e-3, float = "f32"
}
const NARROW: f32 = Quoted::theta(1.0);

pendula::pendulum! {
    struct Unknown;
    theta0 = 4, n = four
}
const FIRST: f64 = Unknown::COEFFICIENTS[0];
const _: () = assert!(Unknown::PERIOD > 6.0 && Unknown::MODULUS < 1.0 && Unknown::MAX_ERROR > 0.0);
const AT: f64 = {
    let mut t = 0.0;
    while Unknown::theta(t) >= 0.0 {
        t += 0.01;
    }
    t
};
const LETTER: u8 = Unknown::METHOD.as_bytes()[0];
static TABLE: [f64; Unknown::TERMS] = Unknown::COEFFICIENTS;

fn main() {
    let _ = (SECOND, BOTH, NARROW, FIRST, AT, LETTER, &TABLE);
}
