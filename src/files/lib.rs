//! Access of Chiaro to the disk: reading, writing, the journal and the cache.
//!
//! [`Disk`] is the compiler's source of [`Files`]: plain files within a bound, and folders that are
//! walked once. [`Outputs`] is the writer for commands, guarded against writing over files that
//! somebody made; [`write_atomic`] and [`FileSet`] write whole files or none; a [`journal`] keeps
//! unsaved work, and a [`cache`] what takes long to compute.

use chiaro_compiler::document;
use chiaro_language::{clock, diag};

pub mod cache;
mod disk;
pub mod journal;
mod outputs;
mod paths;
pub mod png;
mod write;

pub use chiaro_compiler::files::{
    FileKind, FileMetadata, Files, FoundFiles, MemoryFiles, OpenFile, ReadError, SharedFiles,
    WalkBounds, is_utf16,
};
pub use disk::{Disk, read, walk};
pub use outputs::{
    FileSet, OutputKind, Outputs, remove_abandoned, remove_unfinished, sealed_script,
};
pub use paths::{relative, shortened};
pub use write::{TextDocument, link, make_folder, read_text, write_atomic};
