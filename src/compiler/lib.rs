//! Compiler from a graph of light to one readable WGSL shader.
//!
//! A [`document::Look`] is the graph that an artist wires. [`compile`] checks the graph against the
//! [`library`] of nodes (each one a WGSL file), evaluates all parts that are known before the
//! fragment in the interpreter, in f64, removes the parts that cannot reach the output, and emits
//! one WGSL module that naga has validated. [`catalog`] describes the nodes for people and
//! programs.

use chiaro_language::{diag, ids, interp, milestones, wgsl};

pub mod catalog;
pub mod compile;
pub mod document;
pub mod examples;
pub mod files;
pub mod library;
