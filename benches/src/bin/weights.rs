//! What one operation of each kind costs in an array loop, an addition or a multiplication being 1: what the planner's
//! cost model (`pendulum-macros/src/program/cost.rs`) has to say.
//!
//! `cargo run --release -p pendula-benches --bin weights`; with `RUSTFLAGS=-Ctarget-cpu=x86-64-v3` for AVX2. Operations
//! of each kind are put between polynomials, which plans consist of, and the increase is divided by that of as many
//! additions and multiplications. All loops are timed in interleaved rounds.

use std::hint::black_box;

use pendula::__private::support::{root, rootf};
use pendula_benches::contestant::{Block, COUNT};
use pendula_benches::machine;
use pendula_benches::race::{Effort, Job, Spread, race};
use pendula_benches::real::{ROUNDER, Real};
use pendula_stress::random::Random;

/// Independent chains of operations, as evaluation by Estrin's scheme has them.
const REPEATS: usize = 4;
/// Multiplications and additions per chain before what is measured and after it: with all chains as many as in plans of
/// middling tolerance.
const TERMS: usize = 2;

/// The sum of `REPEATS` chains, each of which has x ↦ `step(x, y, i)` between two polynomials. y is another variable
/// and i counts the chains.
#[expect(clippy::inline_always, reason = "the loops are to vectorise whatever the step is")]
#[inline(always)]
fn body<R: Real>(x: R, step: impl Fn(R, R, usize) -> R) -> R {
    let y = x + R::of(0.125);
    let mut sum = R::zero();
    for i in 0..REPEATS {
        let mut v = y + R::of(i as f64 / 4.0);
        for j in 0..TERMS {
            v = v * y + R::of(0.5 + j as f64 / 16.0);
        }
        v = step(v, y, i);
        for j in 0..TERMS {
            v = v * y + R::of(0.25 + j as f64 / 16.0);
        }
        sum = sum + v;
    }
    sum
}

/// One entry: a kind of operation, how many of them a repetition has beside the additions and multiplications named,
/// and the loop.
struct Kind<'a> {
    name: &'static str,
    /// Additions and multiplications that a repetition has besides; they are taken off.
    besides: f64,
    /// Operations of the kind in one repetition.
    each: f64,
    job: Job<'a>,
}

fn kind<'a, R: Real>(
    name: &'static str,
    (each, besides): (f64, f64),
    inputs: &'a Block<R>,
    step: impl Fn(R, R, usize) -> R + Copy + 'a,
) -> Kind<'a> {
    let mut outputs = Box::new(Block([R::zero(); COUNT]));
    let work = move || {
        for (output, &input) in outputs.0.iter_mut().zip(&black_box(inputs).0) {
            *output = body(input, step);
        }
        black_box(&outputs);
    };
    Kind { name, besides, each, job: Job::new(COUNT, work) }
}

/// Between 1 and 2, where none of the loops below overflows.
fn inputs<R: Real>() -> Block<R> {
    let mut random = Random::new(0xC057);
    let mut block = Block([R::zero(); COUNT]);
    block.0.fill_with(|| R::of(1.0 + random.unit()));
    block
}

fn constant(i: usize) -> f64 {
    0.75 + i as f64 / 8.0
}

/// The kinds of `pendulum-macros/src/program/mod.rs` that there are of both floats, as they are emitted.
macro_rules! kinds {
    ($inputs:expr, $float:ident of $bits:ident, $root:ident) => {{
        const SIGN: $bits = 1 << ($bits::BITS - 1);
        let constant = |i| constant(i) as $float;
        vec![
            kind("nothing", (1.0, 0.0), $inputs, |v: $float, _, _| v),
            kind("addition and multiplication", (2.0, 0.0), $inputs, move |v, y, i| v * y + constant(i)),
            kind("quotient", (1.0, 0.0), $inputs, |v, y, _| y / v),
            kind("root", (1.0, 0.0), $inputs, |v, _, _| $root(v)),
            kind("sign by parity (`Alternate`)", (1.0, 1.0), $inputs, move |v, y, i| {
                $float::from_bits(v.to_bits() ^ ((y + constant(i)).to_bits() << ($bits::BITS - 1)))
            }),
            kind("sign against (`Against`)", (1.0, 1.0), $inputs, move |v, y, i| {
                $float::from_bits(v.to_bits() ^ (!(y - constant(i)).to_bits() & SIGN))
            }),
            kind("sign along (`Along`)", (1.0, 1.0), $inputs, move |v, y, i| {
                $float::from_bits(v.to_bits() ^ ((y - constant(i)).to_bits() & SIGN))
            }),
            kind("constant with a sign (`CopySign`)", (1.0, 2.0), $inputs, move |v, y, i| {
                v + constant(i).copysign(y - constant(i + 1))
            }),
            kind("absolute value", (1.0, 1.0), $inputs, |v, y, _| (v - y).abs()),
            kind("minimum, maximum", (1.0, 1.0), $inputs, move |v, y, i| {
                let v = v * y;
                let limit = 64.0 * constant(i);
                if limit < v { limit } else { v }
            }),
            kind("choice (`Select`)", (1.0, 1.0), $inputs, move |v, y, i| {
                let sum = v + y;
                if v < constant(i) { y } else { sum }
            }),
        ]
    }};
}

fn doubles(inputs: &Block<f64>) -> Vec<Kind<'_>> {
    let mut kinds = kinds!(inputs, f64 of u64, root);
    kinds.extend([
        kind("head", (1.0, 1.0), inputs, |v, y, _| f64::from_bits((v * y).to_bits() & 0xffff_ffff_fc00_0000)),
        kind("power of two", (1.0, 2.0), inputs, |v, y, i| {
            let magic = y + ROUNDER + constant(i);
            v * f64::from_bits(magic.to_bits().wrapping_add(1023) << 52)
        }),
        kind("narrow and widen, half of it", (2.0, 1.0), inputs, |v, y, _| f64::from((v * y) as f32)),
    ]);
    kinds
}

fn singles(inputs: &Block<f32>) -> Vec<Kind<'_>> {
    let mut kinds = kinds!(inputs, f32 of u32, rootf);
    kinds.push(kind(
        "addition and multiplication in f64, and conversions, all of it",
        (1.0, 0.0),
        inputs,
        |v, y, i| (f64::from(v) * f64::from(y) + constant(i)) as f32,
    ));
    kinds
}

/// Weights by the median over the rounds.
fn report(precision: &str, kinds: &[Kind<'_>]) {
    println!("\n| {precision} | weight | quartiles |\n|---|--:|---|");
    let [nothing, unit, ..] = kinds else { return };
    for kind in &kinds[1..] {
        let rounds = kind.job.samples.iter().zip(&nothing.job.samples).zip(&unit.job.samples);
        let weight = rounds.map(|((with, without), unit)| {
            let one = (unit - without) / (2 * REPEATS) as f64;
            ((with - without) / REPEATS as f64 / one - kind.besides) / kind.each
        });
        let weight = Spread::of(weight);
        println!("| {} | {:.1} | {:.1} to {:.1} |", kind.name, weight.median, weight.lower, weight.upper);
    }
}

fn main() {
    println!("{}; {}, {}", machine::target(), machine::rustc(), machine::processor());
    let (wide, narrow) = (inputs(), inputs());
    let mut kinds = doubles(&wide);
    let split = kinds.len();
    kinds.extend(singles(&narrow));
    race(kinds.iter_mut().map(|kind| &mut kind.job), Effort::FULL, |_, _| {});
    report("f64", &kinds[..split]);
    report("f32", &kinds[split..]);
}
