//! The exact motion of a pendulum, θ̈ + ω² sin θ = 0, as code generated at compile time.
//!
//! You state an amplitude, an error, a duration, and which quantities you need; [`pendulum!`] solves the motion in high
//! precision, plans the cheapest evaluation that provably keeps the error, and emits straight-line Rust with folded
//! constants. The result can be asked at any time directly, is `const` and `no_std`, has the same bits on every platform,
//! and in a loop over an array usually costs less than one call of `sin`. For an amplitude known only when the program
//! runs there is [`Pendulum`].
//!
//! The idea of a periodic approximation that stays accurate for ever is that of F. M. S. Lima, *Simple but accurate
//! periodic solutions for the nonlinear pendulum equation* (Rev. Bras. Ens. Fís., 2019); equation numbers are the
//! paper's.
//!
//! ```
//! use pendula::pendulum;
//!
//! pendulum! {
//!     /// The clock on the wall.
//!     pub struct Clock;
//!     theta0 = 6deg, g = 9.81, length = 0.994, tol = 1e-9, t_max = 86_400, outputs = [theta, velocity]
//! }
//!
//! let (theta, velocity) = Clock::state(3600.0); // an hour after release, asked directly
//! assert!(theta.abs() <= Clock::THETA0 + Clock::MAX_ERROR);
//! const { assert!(Clock::MAX_ERROR <= 1e-9) }; // proven, for all |t| ≤ 86,400 s
//! const NOON: f64 = Clock::theta(43_200.0); // by the compiler
//! # assert!(NOON.is_finite() && velocity.is_finite());
//! ```
//!
//! | you have | use |
//! |---|---|
//! | an amplitude (or a state) known when you write the program | [`pendulum!`] |
//! | an amplitude (or a state) known when the program runs | [`Pendulum::new`], [`Pendulum::from_state`] |
//! | a push, and need the motion after it | `let (theta, velocity) = Clock::state(t)`, then `Pendulum::from_state(theta, velocity + push, Clock::OMEGA)`, of which t = 0 is the push |
//! | an angle, and need the time at which it is passed | [`Pendulum::time_at`]; of an item's motion, that of `Pendulum::from_state(Clock::THETA0, Clock::VELOCITY0, Clock::OMEGA)` |
//! | the paper's approximation with N terms | `pendulum!(theta0 = …, n = 4)`, [`Pendulum::fourier`] |
//! | an elliptic integral or function near k = 1 | [`elliptic`] |
//!
//! # Scope
//! One rigid pendulum without friction or drive. Any amplitude, any launch, any time; angles in radians, time in any
//! unit, ω in radians per that unit.
//!
//! # `no_std`, determinism
//! Nothing allocates, panics, or calls the platform's mathematical library. Generated code is `const`: + − × ÷, comparisons
//! that select one of two numbers, and manipulations of a number's bits, in a fixed order. Plans with a table of
//! coefficients mask the index of its row, so that no row is missed and no check is needed. The run-time part takes
//! correctly rounded square roots besides. A fused multiply-add, whose bits would differ, is in neither. So the bits are
//! the same on every target with IEEE 754's arithmetic (32-bit x86 without SSE2 has another) and at every optimisation
//! level, but for the sign and payload of a NaN, which the standard leaves open. Another version may plan differently, also
//! of what the planner depends on: where bits are compared, as in replays and lockstep, commit `Cargo.lock`.
#![forbid(unsafe_code)]
#![no_std]

pub use pendulum_runtime::{Error, Fourier, Pendulum, Regime, Scalar, elliptic};

#[doc(hidden)]
pub mod __private {
    pub use pendulum_macros::pendulum;
    pub use pendulum_runtime::support;
}

/// The README's examples are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The motion of a pendulum, planned and generated at compile time.
///
/// # Two forms
/// An **expression**: a zero-sized fn item that coerces to `fn(f64) -> f64`.
///
/// ```
/// use pendula::pendulum;
/// let theta = pendulum!(theta0 = 7π/8, n = 4); // the paper's θ̂ with N = 4 (Eq. 22)
/// assert_eq!(core::mem::size_of_val(&theta), 0);
/// assert!((theta(0.0) - 2.7489).abs() < 0.011);
/// ```
///
/// It has one output. Each invocation is a type of its own: in an array without a stated type the first has to be cast.
///
/// ```
/// use pendula::pendulum;
/// let swings = [pendulum!(theta0 = 1, tol = 1e-6) as fn(f64) -> f64, pendulum!(theta0 = 2, tol = 1e-6)];
/// let stated: [fn(f64) -> f64; 2] = [pendulum!(theta0 = 1, tol = 1e-6), pendulum!(theta0 = 2, tol = 1e-6)];
/// assert_eq!(swings.map(|theta| theta(0.5)), stated.map(|theta| theta(0.5)));
/// ```
///
/// An **item**: a unit struct whose associated constants and functions are the motion. Attributes, doc comments and
/// visibility are kept; the plan is written into its documentation. If the compiler says of a call among items that
/// "macro expansion ignores `{`", the call lacks its `struct Name;` and is an expression.
///
/// ```
/// pendula::pendulum! {
///     /// A lantern on a chain, for a game.
///     #[derive(Clone, Copy, Debug)]
///     pub struct Lantern;
///     theta0 = 50deg, g = 9.81, length = 1.5, float = f32, tol = 1e-4, t_max = 3600
/// }
///
/// const SWING: [f32; 64] = {
///     let mut swing = [0.0; 64];
///     let mut i = 0;
///     while i < 64 {
///         swing[i] = Lantern::theta(i as f32 / 64.0 * Lantern::PERIOD);
///         i += 1;
///     }
///     swing
/// };
/// assert!((SWING[0] - Lantern::THETA0).abs() <= Lantern::MAX_ERROR);
/// ```
///
/// # Parameters
/// In any order, separated by commas.
///
/// | parameter | meaning | range | default |
/// |---|---|---|---|
/// | `theta0`, `θ0` | angle at t = 0 | 10⁻³⁰⁰ (`f32`: 10⁻³⁵) ≤ \|θ0\| < π at rest, \|θ0\| ≤ π in motion | 0 if `velocity0` is given |
/// | `velocity0` | θ̇ at t = 0, rad per unit of t (`90deg` is 90 degrees, π/2 rad, per unit of t) | any up to 10¹³⁶·ω | 0, released at rest |
/// | `omega`, `ω` | ω = √(g/ℓ), rad per unit of t | > 0, for periods up to 10²⁸⁰ (`f32`: 3·10³⁸), of velocities up to ω = 10²⁹⁹, of accelerations while ω²θ̇ is a number | 1 |
/// | `g`, `length` | in place of `omega`: m/s² and m, both | > 0 | |
/// | `n` | the paper's θ̂ with N = n terms (Eq. 22), of a swing | from 1 to what `float` can use | |
/// | `tol` | largest error allowed, rounding included: rad for θ, wrapped or not, rad·ω for θ̇, rad·ω² for θ̈, lengths for the position; not with `n` | > 0, within reach of `float` | full precision, below |
/// | `t_max` | the promise holds for \|t\| ≤ `t_max`, the horizon; a shorter one is a cheaper reduction of the phase, and less than a quarter of a period (half of a rotation's, 4/ω on the separatrix) none at all | > 0, up to 2⁵³ periods | 2⁵³ periods; on the separatrix any time |
/// | `method` | how θ is approximated, below | any for a swing, `polynomial` for a rotation, none for the separatrix | the cheapest; `fourier` with `n` |
/// | `float` | type of t and of the results | `f64`, `f32` | `f64` |
/// | `outputs` | list of `theta`, `velocity`, `acceleration`, `position`, `wrapped` | not empty, no repetition | `[theta]` |
///
/// | `method` | is | gives |
/// |---|---|---|
/// | `small_angle` | Eq. 3, θ0 cos ωt + (θ̇0/ω) sin ωt; its phase drifts, so give `t_max` | θ and its derivatives |
/// | `harmonic` | Eq. 17, with the amplitude and the phase of the motion | θ and its derivatives |
/// | `fourier` | Eq. 22, θ̂ = 2 arcsin y with `n` terms, or as many as `tol` takes | θ̂ and its derivative, −ω² sin θ̂, (sin θ̂, −cos θ̂) |
/// | `series` | the Fourier series of θ itself; its sum in pieces where a recurrence would be rounded by too much | θ and its derivatives |
/// | `polynomial` | one in the phase, in pieces where one can't serve | everything |
///
/// **Numbers** are decimal literals of up to 10 000 digits (every digit counts) and exponents between ±400, with
/// `+ - * /`, parentheses, unary minus, `π`, `PI`, `pi` and `sqrt(…)`; a literal may end in `π`, `deg` or `rad`:
/// `7π/8`, `157.5deg`, `3*PI/4 - 0.01`. What it ends in belongs to it alone: `3/4π` is 3/(4π). `deg` and `rad` are for
/// `theta0` and `velocity0` only. Nothing is rounded to `f64` on the way, so every constant is the correctly rounded
/// one of the exact value. An expression may have up to 500 tokens, and parentheses nested up to 64 deep; a sum that
/// 10 000 digits don't tell from 0 is 0. A macro sees names, not values: a constant or variable of your own can't
/// stand there; [`Pendulum`] takes those.
///
/// # What the item has
/// Constants are of the type `float` where nothing else is said.
///
/// | constant | meaning | exists |
/// |---|---|---|
/// | `THETA0`, `VELOCITY0`, `OMEGA` | θ(0) in rad; θ̇(0) and ω in rad per unit of t | always |
/// | `T_MAX` | the horizon as a number of the type `float`, in `f32` not above it: what is promised of errors holds for \|t\| up to it | always |
/// | `AMPLITUDE` | the largest \|θ\|, rad | for a swing |
/// | `MODULUS` | k = sin(`AMPLITUDE`/2) of a swing, κ = 2ω/\|θ̇\| at the lowest point of a rotation, 1 on the separatrix | always |
/// | `K`, `K_PRIME`, `NOME` | K(k), K(k′) and q = exp(−πK′/K), κ in place of k in a rotation | for swings and rotations |
/// | `PERIOD` | T = 4K/ω of a swing, the time of one turn of a rotation | for swings and rotations |
/// | `METHOD: &str` | `"polynomial"`; where that would be long `"pieces"` (a table of polynomials, of up to 16 KiB an output), near the top `"passage"` (through the lowest point; also the separatrix); or the `method` of the paper or `"series"` that was asked for (often with a table of up to 18 KiB) | always |
/// | `TERMS: usize` | terms (harmonics) of the first output | always |
/// | `OPERATIONS: usize` | operations in one call of the first function, a square root, a minimum and a look-up of a table's row being one each | always |
/// | `COEFFICIENTS: [_; N]` | b₁, b₃, … (Eq. 20) | for a plan by Eq. 22 |
/// | `MAX_ERROR` | proven bound of the error of `theta`, rad | if `theta` is an output |
/// | `MAX_VELOCITY_ERROR`, `MAX_ACCELERATION_ERROR` | likewise, in rad·ω and rad·ω², as `tol`; times `OMEGA`, or its square, in the units of the result | if it is an output |
/// | `MAX_POSITION_ERROR` | likewise, the distance of (x, y) from the exact point, in lengths | if `position` is an output |
/// | `MAX_WRAPPED_ERROR` | likewise, rad, less whole turns: at the top either side may be returned | if `wrapped` is an output |
///
/// Functions are `const fn`, one for each of the `outputs`. The first, of which `TERMS` and `OPERATIONS` tell, is the first
/// in this table, in whatever order `outputs` has them.
///
/// | function | result |
/// |---|---|
/// | `theta(t)`, `velocity(t)`, `acceleration(t)` | θ, θ̇, θ̈ = −ω² sin θ, in rad and the unit of t |
/// | `position(t) -> (x, y)` | (sin θ, −cos θ) in lengths, y upwards, computed without θ; beyond ±1 by no more than `MAX_POSITION_ERROR` |
/// | `wrapped(t)` | θ less its whole turns, in [−π, π) |
/// | `state(t) -> (θ, θ̇)` | if both are outputs, with one reduction of the phase; the same bits, except perhaps for the sign of a zero |
///
/// * NaN and ±∞ in t give NaN, every other t a finite result (the angle of a rotation that would overflow, ±∞).
/// * Released from rest, for every finite t: θ(−t) = θ(t) to the bit; −θ0 gives the mirror image to the bit, except
///   perhaps for the sign of a zero.
/// * Beyond the horizon the θ of a swing stays within ±(`AMPLITUDE` + `MAX_ERROR`). Beyond a `t_max` of less than a
///   quarter of a swing's `PERIOD`, half of a rotation's, or 4/ω on the separatrix, all outputs may stay as they are at
///   `t_max`.
/// * A bound is that of the t passed. A clock rounded to `f32` is itself wrong, after an hour of seconds by up to 1.2·10⁻⁴
///   s: keep time in `f64`, and pass what is left of it after whole periods.
/// * With `float = f32` these are computed in `f64` nevertheless: the phase and the turns of a rotation, without `t_max` or
///   for a fine `tol`; times on the separatrix; the passage. A swing or a rotation with a `t_max` and a coarse `tol` has
///   none.
/// * Of θ̇ the bound alone is promised: where `METHOD` is `"passage"` it is not exactly 0 at the release.
///
/// ```
/// pendula::pendulum! {
///     struct Load;
///     theta0 = 0.3, velocity0 = 0.8, tol = 1e-12, outputs = [theta, velocity, position]
/// }
/// let (theta, velocity) = Load::state(0.0);
/// assert!((theta - 0.3).abs() <= 1e-12 && (velocity - 0.8).abs() <= 1e-12);
/// let (x, y) = Load::position(1.0);
/// assert!((x * x + y * y - 1.0).abs() < 1e-11);
/// assert!(Load::AMPLITUDE > 0.3); // launched in mid-swing: it goes higher than it started
/// ```
///
/// Functions coerce to function pointers, by which several motions stand in one array:
///
/// ```
/// use pendula::pendulum;
/// pendulum! { struct Short; theta0 = 1, g = 9.81, length = 0.5, float = f32, tol = 1e-4, t_max = 3600 }
/// pendulum! { struct Long; theta0 = 0.4, g = 9.81, length = 2, float = f32, tol = 1e-4, t_max = 3600 }
/// const SWINGS: [(fn(f32) -> f32, f32); 2] = [(Short::theta, Short::PERIOD), (Long::theta, Long::PERIOD)];
/// for (theta, period) in SWINGS {
///     assert!((theta(period) - theta(0.0)).abs() < 3e-4);
/// }
/// ```
///
/// A loop over an array of times becomes vector instructions if the function is called in it or in its closure, as in
/// `times.iter().map(|&t| Load::theta(t))`. Passed by its name in more than one place, a long one may stay a call.
///
/// Swing, rotation or separatrix is decided by the exact parameters. `theta` of a rotation counts its turns, and
/// without `t_max` its `MAX_ERROR` includes the rounding of 2⁵³ of them, tens of radians, in `f32` billions: give
/// `t_max`, or use `wrapped`, which keeps its digits however many they are.
///
/// ```
/// use pendula::pendulum;
/// pendulum! { struct Loop; velocity0 = 2.5, tol = 1e-9, t_max = 1e6, outputs = [theta, wrapped] }
/// assert!((Loop::theta(10.0 * Loop::PERIOD) - 20.0 * core::f64::consts::PI).abs() < 1e-8);
/// let to_the_top = pendulum!(velocity0 = 2); // the separatrix, since ω = 1
/// assert!((to_the_top(50.0) - core::f64::consts::PI).abs() < 1e-14);
/// ```
///
/// # Errors
/// Every mistake is a compile error at the token to blame, which names the parameter, the value and a remedy; several
/// mistakes are reported together. A `tol` that can't be promised is refused with the best that is found to be: of one
/// output without a forced `method` mostly within some per cent of what can be had, seldom a quarter above it. One mistake
/// is mathematics rather than syntax: with few terms the argument of the arcsine in Eq. 22 exceeds 1 at large amplitudes
/// (from 0.7308π for N = 1, 0.9046π for 2, 0.9139π for 3, 0.9547π for 4), where θ̂ would be NaN.
///
/// ```compile_fail
/// // the smallest number of terms that works is `n = 4`
/// let theta = pendula::pendulum!(theta0 = 0.95π, n = 2);
/// ```
///
/// # What is promised
/// The exact value minus the returned one is at most `MAX_ERROR` in magnitude for every t of the type within the
/// horizon: truncation, the rounding of coefficients, the reduction of the phase and the rounding of every operation
/// are bounded at compile time, not sampled. With `n` the function is the paper's θ̂, within 8 ulp of the amplitude in
/// all tests (more with more than 150 terms, or if the argument of the arcsine comes within 10⁻¹¹ of 1; other outputs may
/// be farther off near the top), and `MAX_ERROR` is a proven bound of its distance from the exact motion over the horizon.
///
/// Full precision, without `tol` and `n`, is 2⁻⁴⁹ (`f32`: 2⁻²⁰) of
///
/// | output | of |
/// |---|---|
/// | θ of a swing | `AMPLITUDE`, which is \|θ0\| of a release |
/// | θ on the separatrix, `wrapped` | π |
/// | θ of a rotation | π, and the rounding of its turns besides |
/// | θ̇, θ̈ | the largest of them |
/// | position | three lengths |
///
/// `method = small_angle` and `harmonic` have no more terms to come that close by: without `tol`, `MAX_ERROR` is a bound of
/// what the formula is off by.
///
/// # Greek letters
/// The compiler's lint `mixed_script_confusables` warns of an identifier that looks like a Latin one, such as `θ0` or a
/// lone `π`, in a crate that has no other Greek. `theta0`, `PI` and suffixes (`7π/8`, `1π`) don't trigger it.
///
/// # Names in scope
/// What is generated names its variables in lower case (`t`, `s`, `p`, `n` and the like) and the types `f32`, `f64`, `u32`,
/// `usize` and `str`. A `const`, `static` or unit struct of such a variable's name, or another type of such a name, where the
/// macro is called, is an error in it (E0005, E0530, E0308), since patterns name constants wherever they come from. The
/// compiler warns of such names by itself; put the call into a module of its own.
#[macro_export]
macro_rules! pendulum {
    ($($input:tt)*) => { $crate::__private::pendulum! { [$crate] $($input)* } };
}
