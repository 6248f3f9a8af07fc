//! Helpers of several test programs that know no more of Chiaro than its words and its files:
//! formulas in f64, random numbers, cases in files, ledgers and the sources that judge, a scanner
//! of Rust, counted SPIR-V, outside validators, a browser and what it is served, Godot, waiting for
//! a GPU, and the disk that documents are read from. Helpers that draw are in `tests/drawing`.

use std::path::Path;

pub use chiaro_files;

pub mod badf;
pub mod cases;
pub mod chromium;
pub mod color;
pub mod files;
pub mod godot;
pub mod judges;
pub mod ledger;
pub mod noise;
pub mod paint;
pub mod random;
pub mod report;
pub mod scan;
pub mod served;
pub mod spirv;
pub mod validators;
pub mod wait;

/// The root of the repository, from a test program of any crate.
pub fn root() -> &'static Path {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    folder.ancestors().nth(2).expect("this crate lies two folders below")
}
