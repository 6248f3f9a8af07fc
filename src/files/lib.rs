//! What Chiaro reads from the disk and writes to it.
//!
//! [`Disk`] is where the compiler's [`Files`](chiaro_compiler::files::Files) come from: plain files
//! within a bound, and folders that are walked once. [`Outputs`] is how commands write, guarded
//! against writing over what somebody made; [`write_atomic`] and [`FileSet`] write whole files or
//! none; a [`journal`] keeps what is not saved.

use chiaro_compiler::document;
use chiaro_language::{clock, diag};

mod disk;
pub mod journal;
mod outputs;
mod write;

pub use chiaro_compiler::files::{
    Files, FoundFiles, MAX_ENTRIES, MemoryFiles, ReadError, is_utf16,
};
pub use disk::{Disk, read, walk};
pub use outputs::{FileSet, OutputKind, Outputs, remove_abandoned, remove_unfinished};
pub use write::{TextDocument, read_text, write_atomic};
