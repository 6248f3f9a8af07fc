//! From a graph of light to one readable WGSL shader.
//!
//! A [`document::Look`] is what an artist wires. [`compile`] checks it against the [`library`] of
//! nodes (each one a WGSL file), runs whatever is known before the fragment through the interpreter
//! in f64, removes what cannot reach the output, and emits one WGSL module that naga has validated.
//! [`catalog`] tells people and programs what there is to wire.

use chiaro_language::{diag, ids, interp, milestones, wgsl};

pub mod catalog;
pub mod compile;
pub mod document;
pub mod examples;
pub mod files;
pub mod library;
