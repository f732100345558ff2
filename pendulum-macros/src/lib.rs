//! wip
#![allow(dead_code)]
mod chebyshev;
mod check;
mod exact;
mod motion;
mod parse;
mod plan;
mod program;
mod report;
mod scene;
mod series;
