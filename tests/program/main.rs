//! The program from outside: its commands, what they write, and what they measure.

mod bench;
mod cli;
mod desktop;
mod fit;
mod gallery;
mod outputs;
#[path = "../support/mod.rs"]
mod support;
