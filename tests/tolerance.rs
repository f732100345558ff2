//! `tol`: the error stays below the proven bound over the whole horizon, and the bound is no more than four times what
//! a dense look finds. `cargo test --release --test tolerance -- --nocapture` prints the table.

mod promise;
mod truth;

use promise::{Finding, judge};

/// Looks this dense find the supremum of a curve with a few dozen extrema to better than a per cent.
const DENSITY: u32 = 1500;

/// Below these the last bits of results decide, of which no 5000 looks find the worst.
fn tight_from(finding: &Finding) -> f64 {
    if finding.promise.asked.starts_with("f32") { 1e-5 } else { 1e-12 }
}

fn wrong(tol: f64) -> impl Fn(&Finding) -> Option<String> {
    move |finding| {
        let bound = finding.promise.bound;
        if finding.observed > bound {
            return Some("the observed error exceeds the proven bound".into());
        }
        if bound > tol {
            return Some(format!("the bound exceeds tol = {tol:e}"));
        }
        (tol >= tight_from(finding) && finding.slack() > 4.0)
            .then(|| "the bound is more than four times too large".into())
    }
}

macro_rules! kept {
    ($tol:literal; $starts:tt $requests:tt) => {{
        judge(&findings!(DENSITY; $starts $requests), wrong($tol));
    }};
}

#[test]
fn a_hundredth() {
    kept!(1e-2; [[0.1 0 1] [1 0 1] [(1π/2) 0 1] [(7π/8) 0 1] [(0.97π) 0 1] [(-7π/8) 0 1]] [
        {10; f64; theta; tol = 1e-2}
        {; f64; theta velocity; tol = 1e-2}
        {1000; f32; theta velocity; tol = 1e-2}
    ]);
}

#[test]
fn what_games_ask_for() {
    kept!(1e-4; [[0.1 0 1] [1 0 1] [(7π/8) 0 3] [(0.95π) 0 1] [0.3 2 1.25] [0 (-1.9) 1]] [
        {100; f32; theta; tol = 1e-4}
        {10; f32; theta velocity acceleration position; tol = 1e-4}
        {; f32; theta position; tol = 1e-4}
        {1000; f64; theta position; tol = 1e-4}
    ]);
}

#[test]
fn a_millionth() {
    kept!(1e-6; [[0.01 0 1] [(1π/6) 0 1] [(100deg) 0 1] [(7π/8) 0 1] [(0.96π) 0 1] [1 1 1] [(-2.5) (-0.25) 0.5]] [
        {500; f64; theta; tol = 1e-6}
        {20; f64; theta velocity acceleration position; tol = 1e-6}
        {; f64; velocity; tol = 1e-6}
    ]);
}

#[test]
fn a_billionth() {
    kept!(1e-9; [[1e-6 0 1] [(1π/3) 0 1] [(3π/4) 0 1] [(7π/8) 0 3] [(0.97π) 0 1] [1 (-1) 1] [2.9 0.1 2]] [
        {1000; f64; theta; tol = 1e-9}
        {100000; f64; theta velocity; tol = 1e-9}
        {; f64; theta acceleration position; tol = 1e-9}
    ]);
}

#[test]
fn a_trillionth() {
    kept!(1e-12; [[0.01 0 1] [1 0 1] [(2π/3) 0 1] [(7π/8) 0 1] [0 1 1]] [
        {100; f64; theta velocity; tol = 1e-12}
        {; f64; theta acceleration; tol = 1e-12}
        {1000; f64; position; tol = 1e-12}
    ]);
}

/// Less than half a swing: polynomials of the time itself, of what is met alone.
#[test]
fn a_moment() {
    kept!(1e-3; [[0.1 0 1] [(7π/8) 0 1] [0 (-1.9) 1] [1 (-1) 1] [(-1) 1 1]] [
        {1; f32; theta velocity acceleration position; tol = 1e-3}
        {0.25; f64; theta velocity acceleration position; tol = 1e-3}
    ]);
    kept!(1e-6; [[0.01 0 1] [(7π/8) 0 1] [(0.999π) 0 1] [0 1 1] [1 1 1] [(-2.5) (-0.25) 0.5]] [
        {2; f64; theta velocity acceleration position; tol = 1e-6}
        {0.015625; f64; theta velocity acceleration position; tol = 1e-6}
    ]);
    kept!(1e-12; [[1 0 1] [(7π/8) 0 1] [0 1 1] [1 (-1) 1]] [
        {1; f64; theta velocity acceleration position; tol = 1e-12}
    ]);
}

#[test]
fn near_the_top() {
    kept!(1e-6; [[(0.99π) 0 1] [(0.9999π) 0 1] [(1π-1e-6) 0 1] [(1π-1e-9) 0 1]] [
        {1000; f64; theta; tol = 1e-6}
        {; f64; theta velocity acceleration position; tol = 1e-6}
    ]);
    kept!(1e-3; [[(0.99π) 0 1] [(0.9999π) 0 1]] [
        {100; f32; theta velocity; tol = 1e-3}
        {; f32; theta position; tol = 1e-3}
    ]);
}

#[test]
fn each_method_when_forced() {
    kept!(0.5; [[0.1 0 1] [1 0 1] [(7π/8) 0 1] [1 1 1]] [
        {10; f64; theta; tol = 0.5, method = harmonic}
        {; f32; theta; tol = 0.5, method = harmonic}
    ]);
    kept!(1e-3; [[0.01 0 1]] [{10; f64; theta; tol = 1e-3, method = small_angle}]);
    kept!(1e-3; [[0.1 0 1] [1 0 1] [(7π/8) 0 1] [1 1 1]] [
        {100; f64; theta; tol = 1e-3, method = fourier}
        {; f64; theta; tol = 1e-3, method = fourier}
        {100; f32; theta; tol = 1e-3, method = fourier}
    ]);
    kept!(1e-4; [[0.1 0 1] [1 0 1] [(7π/8) 0 1] [1 1 1]] [
        {100; f64; theta; tol = 1e-4, method = series}
        {; f64; theta; tol = 1e-4, method = series}
        {100; f32; theta; tol = 1e-4, method = series}
        {100; f64; theta velocity acceleration position; tol = 1e-4, method = polynomial}
    ]);
}

/// Swings next to the top, far from which the horizon ends.
#[test]
fn each_method_for_a_moment() {
    kept!(1e-3; [[1 1.755 1] [0 1.9999 1] [(-1) (-3.5) 2] [(7π/8) 0 1]] [
        {0.25; f64; theta velocity acceleration; tol = 1e-3, method = fourier}
        {0.25; f32; theta velocity; tol = 1e-3, method = fourier}
        {0.25; f64; theta velocity acceleration; tol = 1e-3, method = series}
        {0.25; f32; theta acceleration; tol = 1e-3, method = series}
    ]);
}
