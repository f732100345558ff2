//! wip
#![no_std]
pub mod double;
