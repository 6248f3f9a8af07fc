//! Exported modules against golden files and outside validators.

mod golden;
#[path = "../support/mod.rs"]
mod support;
mod validators;
