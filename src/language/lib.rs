//! What everything in Chiaro is said in.
//!
//! [`ids`] name what a document holds and [`diag`] says what is wrong with it; [`progress`] tells
//! how far long work has come, and stops it. [`wgsl`] resolves
//! imports and is the only caller of naga's front end and validator; [`interp`] runs what it gives
//! in f64 or f32, on the CPU.

// Words that everything is said in.
pub mod clock;
pub mod diag;
pub mod figures;
pub mod ids;
pub mod milestones;
pub mod progress;

// WGSL sources, and what runs them.
pub mod interp;
pub mod wgsl;
