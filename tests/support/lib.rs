//! What several test programs share and what knows nothing of what Chiaro draws: formulas in f64,
//! random numbers, ledgers, outside validators, and the disk that documents are read from.
//! `tests/drawing` is what draws.

use std::path::Path;

pub use chiaro_files;

pub mod badf;
pub mod color;
pub mod files;
pub mod ledger;
pub mod noise;
pub mod random;
pub mod report;
pub mod validators;

/// The root of the repository, which a test program of any crate may be run from.
pub fn root() -> &'static Path {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    folder.ancestors().nth(2).expect("this crate lies two folders below")
}
