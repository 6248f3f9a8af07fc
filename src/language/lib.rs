//! Basic language of Chiaro: ids, diagnostics, progress, and WGSL with its interpreter.
//!
//! [`ids`] name the parts of a document and [`diag`] reports problems; [`progress`] measures long
//! work, and stops it. [`wgsl`] resolves imports and is the only caller of naga's front end and
//! validator; [`interp`] runs the validated modules in f64 or f32, on the CPU.

// Basic terms of all other crates.
pub mod clock;
pub mod diag;
pub mod figures;
pub mod ids;
pub mod milestones;
pub mod progress;

// WGSL sources and their interpreter.
pub mod interp;
pub mod wgsl;
