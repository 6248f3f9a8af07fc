//! Chiaro: from a graph of light to one readable WGSL shader.
//!
//! A [`document::Look`] is what an artist wires. [`compile`] checks it against the [`library`] of nodes (each one a
//! WGSL file), runs whatever is known before the fragment through [`interp`] in f64, removes what cannot reach the
//! output, and emits one WGSL module that [`wgsl`] has validated. [`frame`] joins looks, meshes, lights, keys and time
//! into a frame plan, which the renderer executes and `export` turns into files for other programs.
//!
//! Modules stand on floors, lowest first; each imports only from floors below its own, and a test holds that.
#![forbid(unsafe_code)]
#![warn(missing_docs)]

// Floor 0: words that everything is said in.
mod base64;
pub mod clock;
pub mod diag;
pub mod examples;
pub mod figures;
pub mod ids;
pub mod milestones;
pub mod threads;

// Floor 1: WGSL sources, and the only caller of naga's front end and validator.
pub mod wgsl;

// Floor 2: what runs WGSL in f64, what nodes there are, what artists make.
pub mod document;
pub mod interp;
pub mod library;

// Floor 3: from documents to shaders and frame plans.
pub mod catalog;
pub mod compile;
pub mod directions;
pub mod drawing;
pub mod frame;
pub mod geometry;
pub mod hcbtf;

// Floor 4: who executes plans and carries shaders away.
pub mod export;
pub mod reference;
#[cfg(feature = "gpu")]
pub mod render;

// Floor 5: what accuracy costs in time, and looks from what was painted.
#[cfg(feature = "gpu")]
pub mod accuracy;
pub mod fit;

// Floor 5½: what is shown of both.
#[cfg(feature = "gpu")]
pub mod gallery;

// Floor 6: who people talk to.
pub mod cli;
#[cfg(feature = "editor")]
pub mod editor;
