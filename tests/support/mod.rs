//! What several test programs share. Each of them compiles all of it and uses a part.
#![allow(dead_code, reason = "every test program uses a part of this")]

pub(crate) mod badf;
pub(crate) mod color;
#[cfg(feature = "gpu")]
pub(crate) mod eval;
pub(crate) mod files;
#[cfg(feature = "gpu")]
pub(crate) mod handwritten;
#[cfg(feature = "gpu")]
pub(crate) mod held;
pub(crate) mod ledger;
pub(crate) mod noise;
pub(crate) mod random;
pub(crate) mod report;
pub(crate) mod stacks;
pub(crate) mod validators;
#[cfg(feature = "gpu")]
pub(crate) mod wait;
