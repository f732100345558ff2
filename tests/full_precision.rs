//! Without `n` and `tol`: the full precision of the float at any time. `cargo test --release --test full_precision --
//! --nocapture` prints the table.

mod promise;
mod truth;

use pendula_stress::promised::{PROVEN, PROVEN_F32, UNIT, UNIT_F32};
use promise::{Finding, judge};

/// Proven and observed errors are at most these, relative to the largest value.
struct Limits {
    proven: f64,
    observed: f64,
}

const F64: Limits = Limits { proven: PROVEN, observed: UNIT };
const F32: Limits = Limits { proven: PROVEN_F32, observed: UNIT_F32 };

fn wrong(limits: &Limits) -> impl Fn(&Finding) -> Option<String> {
    move |finding| {
        // A position is promised in lengths, not to a precision; its product of two pairs takes three times as much.
        let room = if finding.promise.output == "position" { 3.0 } else { 1.0 };
        let (proven, observed) = (finding.promise.bound / finding.largest, finding.observed / finding.largest);
        if finding.observed > finding.promise.bound {
            return Some("the observed error exceeds the proven bound".into());
        }
        if proven > limits.proven * room {
            return Some(format!("proven {:.2} of what is promised", proven / limits.proven));
        }
        (observed > limits.observed * room)
            .then(|| format!("observed {:.2} of what is promised", observed / limits.observed))
    }
}

#[test]
fn f64_at_any_time() {
    let small = findings!(600; [[1e-9 0 1] [1e-6 0 1] [0.01 0 1] [0.1 0 1] [(1π/6) 0 1] [1 0 1]] [
        {; f64; theta; }
        {; f64; theta velocity acceleration position; }
    ]);
    judge(&small, wrong(&F64));
    let large = findings!(600; [
        [(1π/2) 0 1] [(100deg) 0 1] [(-2) 0 1] [(4π/5) 0 1] [(7π/8) 0 1] [(7π/8) 0 3] [(0.95π) 0 1] [(0.97π) 0 1]
    ] [
        {; f64; theta; }
        {; f64; theta velocity acceleration position; }
    ]);
    judge(&large, wrong(&F64));
}

#[test]
fn f64_near_the_top() {
    let near = findings!(600; [
        [(0.98π) 0 1] [(0.99π) 0 1] [(0.999π) 0 1] [(0.9999π) 0 1] [(1π-1e-6) 0 1] [(1π-1e-9) 0 1]
    ] [
        {; f64; theta; }
        {; f64; theta velocity position; }
    ]);
    judge(&near, wrong(&F64));
}

/// Where no single polynomial can, one for each part of the period.
#[test]
fn forced_polynomials_near_the_top() {
    let f64 = findings!(600; [[(1π-1e-6) 0 1] [(1π-1e-9) 0 1]] [
        {; f64; theta; method = polynomial}
        {; f64; velocity acceleration; method = polynomial}
        {; f64; position; method = polynomial}
    ]);
    judge(&f64, wrong(&F64));
    let f32 = findings!(600; [[(1π-1e-6) 0 1] [(1π-1e-9) 0 1]] [
        {; f32; theta velocity; method = polynomial}
    ]);
    judge(&f32, wrong(&F32));
}

/// By the recurrence or, where that is rounded by too much, in pieces.
#[test]
fn forced_series() {
    let f64 = findings!(600; [
        [1e-9 0 1] [0.1 0 1] [1 0 1] [(7π/8) 0 1] [(0.99π) 0 1] [(1π-1e-6) 0 1] [(1π-1e-9) 0 1] [1 1 1]
    ] [
        {; f64; theta; method = series}
        {; f64; theta velocity; method = series}
    ]);
    judge(&f64, wrong(&F64));
    let f32 = findings!(600; [[1 0 1] [(0.999π) 0 1] [(1π-1e-9) 0 1]] [{; f32; theta velocity; method = series}]);
    judge(&f32, wrong(&F32));
}

#[test]
fn f64_launched_in_mid_swing() {
    let launched = findings!(600; [
        [1 1 1] [(-1) 1 1] [1 (-1) 1] [0 1 1] [0 (-1.9) 1] [(-2.5) (-0.25) 0.5]
    ] [
        {; f64; theta velocity acceleration position; }
        {1000; f64; theta; }
    ]);
    judge(&launched, wrong(&F64));
}

/// Next to the lowest point an acceleration changes fastest; its bound is far above what is observed elsewhere.
#[test]
fn f64_accelerations() {
    let accelerations = findings!(3000; [[2.6901 0 1] [2.7604 0 1] [2.3587 0 1] [(7π/8) 0 1]] [
        {; f64; acceleration; }
        {26; f64; acceleration; }
        {1272; f64; velocity acceleration position theta; }
    ]);
    judge(&accelerations, wrong(&F64));
}

/// Beyond 2⁵⁴ in t the reduction's third partial product is about 1: its rounding would show.
#[test]
fn f64_launched_and_far_out() {
    let launched = findings!(600; [[0.3 2 1.25] [2.9 0.1 2]] [
        {; f64; theta velocity acceleration position; }
    ]);
    judge(&launched, wrong(&F64));
}

#[test]
fn f64_within_a_horizon() {
    let short = findings!(600; [[0.01 0 1] [1 0 1] [(7π/8) 0 1] [(0.95π) 0 1]] [
        {10; f64; theta velocity; }
        {1000; f64; theta; }
        {1000000; f64; theta; }
    ]);
    judge(&short, wrong(&F64));
}

#[test]
fn f32_at_any_time() {
    let findings = findings!(1000; [
        [1e-9 0 1] [0.01 0 1] [1 0 1] [(1π/2) 0 1] [(100deg) 0 1] [(7π/8) 0 1] [(-7π/8) 0 1] [(0.97π) 0 1] [1 1 1]
        [0.3 2 1.25] [(0.999π) 0 1]
    ] [
        {; f32; theta; }
        {; f32; theta velocity acceleration; }
        {100; f32; theta velocity; }
    ]);
    judge(&findings, wrong(&F32));
}
