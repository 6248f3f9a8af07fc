//! WGSL sources: what is embedded, how imports are resolved, and the only caller of naga's front end and validator.
//!
//! A source may begin with lines `import chiaro::name;`, each naming a file of `shaders/lib/`. [`link`] puts what is
//! imported before the source, each file once; the result is plain WGSL, and [`Linked::locate`] finds the way back to
//! the file and line that a byte of it came from.

mod embedded;
mod link;
mod operations;
mod scan;
mod validate;

pub use embedded::{NODES, PASSES, SHADER_LIBRARY};
pub use link::{Linked, Source, link};
pub use operations::Operations;
pub use scan::{Declaration, DeclarationKind, Field, Import, Scan, identifiers, rename_identifiers, scan};
pub use validate::{Valid, WgslError, parse, validate};

/// The path and the text of `shaders/passes/NAME.wgsl`.
pub fn pass(name: &str) -> Option<(&'static str, &'static str)> {
    let is_it = |path: &str| path.rsplit('/').next().and_then(|file| file.strip_suffix(".wgsl")) == Some(name);
    PASSES.iter().copied().find(|(path, _)| is_it(path))
}
