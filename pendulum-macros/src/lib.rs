//! wip
#![allow(dead_code)]
mod check;
mod exact;
mod motion;
mod parse;
mod report;
mod scene;
