//! Measurements of accuracy and cost, looks fitted to strokes painted on their pictures, and
//! galleries of looks and scenes.

#[cfg(feature = "gpu")]
use chiaro_compiler::{catalog, examples};
use chiaro_compiler::{compile, document, library};
#[cfg(feature = "gpu")]
use chiaro_files as files;
#[cfg(feature = "gpu")]
use chiaro_language::interp;
use chiaro_language::{diag, figures, ids, progress};
use chiaro_reference as reference;
#[cfg(feature = "gpu")]
use chiaro_render as render;
use chiaro_scene::frame;
#[cfg(feature = "gpu")]
use chiaro_scene::{drawing, export};

/// Samples that docs and gallery show each kind of node with, by kind: values, sources and shape,
/// as JSON.
pub const NODE_SAMPLES: &str = include_str!("gallery/samples.json");

#[cfg(feature = "gpu")]
pub mod accuracy;
pub mod fit;
#[cfg(feature = "gpu")]
pub mod gallery;
