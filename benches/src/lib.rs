//! Run time against error: `pendula` beside what people use today.
//!
//! `cargo bench --bench pareto` runs it. A [`Contestant`](contestant::Contestant) is anything that gives θ of a
//! pendulum released at rest with ω = 1; [`ours`] and [`peers`] list them. A [`session`] times all of them in one
//! process, in interleaved rounds, and measures their errors against the truth of the stress suites ([`truth`]);
//! [`drift`] follows the errors to 10¹² periods. [`report`] and [`figures`] show what came out, [`targets`] whether it
//! is as cheap as it is to be.

pub mod amplitude;
pub mod contestant;
pub mod drift;
pub mod figures;
pub mod machine;
pub mod ours;
pub mod peers;
pub mod race;
pub mod real;
pub mod report;
pub mod session;
pub mod targets;
pub mod truth;
