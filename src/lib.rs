//! Chiaro: from a graph of light to one readable WGSL shader.
//!
//! A [`document::Look`] is what an artist wires. [`compile`] checks it against the [`library`] of
//! nodes (each one a WGSL file), runs whatever is known before the fragment through [`interp`] in
//! f64, removes what cannot reach the output, and emits one WGSL module that [`wgsl`] has
//! validated. [`frame`] joins looks, meshes, lights, keys and time into a frame plan, which the
//! renderer executes and `export` turns into files for other programs.
//!
//! Each floor of the house is a crate under `src/`, lowest first; here its rooms go by the names
//! that people say.
#![forbid(unsafe_code)]
#![warn(missing_docs)]

#[doc(inline)]
pub use chiaro_language::{clock, diag, figures, ids, interp, milestones, progress, wgsl};

#[doc(inline)]
pub use chiaro_compiler::{catalog, compile, document, examples, library};

#[doc(inline)]
pub use chiaro_files as files;

#[cfg(feature = "scene")]
#[doc(inline)]
pub use chiaro_scene::{directions, drawing, export, frame, geometry, hcbtf, threads};

#[cfg(feature = "scene")]
#[doc(inline)]
pub use chiaro_reference as reference;
#[cfg(feature = "gpu")]
#[doc(inline)]
pub use chiaro_render as render;

#[cfg(feature = "scene")]
#[doc(inline)]
pub use chiaro_laboratory::fit;
#[cfg(feature = "gpu")]
#[doc(inline)]
pub use chiaro_laboratory::{accuracy, gallery};
#[cfg(feature = "sweeps")]
#[doc(inline)]
pub use chiaro_sweeps as sweeps;

#[cfg(feature = "cli")]
#[doc(inline)]
pub use chiaro_cli as cli;
#[cfg(feature = "editor")]
#[doc(inline)]
pub use chiaro_editor as editor;
