//! wip
#![no_std]
pub mod double;
#[doc(hidden)]
pub mod support;
