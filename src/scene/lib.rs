//! Drawing of scenes: frame plans of a scene at a time, and shaders for other programs.
//!
//! [`geometry`] reads and makes meshes, [`hcbtf`] holds surfaces painted for every light and every
//! eye, [`directions`] weighs keys on the sphere. [`frame`] joins looks, meshes, lights, keys and
//! time into a frame plan, which a renderer executes; [`export`] turns it into files for other
//! programs, and [`drawing`] draws graphs themselves. [`import`] makes looks of other programs'
//! graphs, and [`photometry`] pictures of measured lamps.

use chiaro_compiler::{catalog, compile, document, examples, library};
use chiaro_files as files;
use chiaro_language::{clock, diag, figures, ids, interp, progress, wgsl};

mod cache;
pub mod directions;
pub mod drawing;
pub mod export;
pub mod frame;
pub mod geometry;
pub mod hcbtf;
pub mod import;
pub mod photometry;
pub mod placing;
pub mod threads;
