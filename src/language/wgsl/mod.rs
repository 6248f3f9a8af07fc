//! WGSL sources: what is embedded, how imports are resolved, and the only caller of naga's front end and validator.
//!
//! A source may begin with lines `import chiaro::name;`, each naming a file of `shaders/lib/`. [`link`] puts what is
//! imported before the source, each file once; the result is plain WGSL, and [`Linked::locate`] finds the way back to
//! the file and line that a byte of it came from.

use crate::diag::Diagnostic;

mod embedded;
mod link;
mod operations;
mod scan;
mod validate;

pub use embedded::{PASSES, SHADER_LIBRARY};
pub use link::{Linked, Source, link};
pub use operations::Operations;
pub use scan::{Declaration, DeclarationKind, Field, Import, Scan, identifiers, rename_identifiers, scan};
pub use validate::{Valid, WgslError, parse, validate};

/// `shaders/passes/NAME.wgsl` with what it imports.
///
/// # Errors
/// That there is no such pass, or what it imports in vain.
pub fn pass(name: &str) -> Result<Linked, Vec<Diagnostic>> {
    let is_it = |path: &str| path.rsplit('/').next().and_then(|file| file.strip_suffix(".wgsl")) == Some(name);
    let Some((path, text)) = PASSES.iter().find(|(path, _)| is_it(path)) else {
        return Err(vec![Diagnostic::error("missing-pass", format!("this build of Chiaro lacks the pass `{name}`"))]);
    };
    link(&[Source { name: path, text }])
}
