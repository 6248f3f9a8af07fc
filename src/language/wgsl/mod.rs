//! WGSL sources: the embedded files, the resolution of imports, and the only caller of naga's front
//! end and validator.
//!
//! A source may begin with lines `import chiaro::name;`, each naming a file of `shaders/lib/`.
//! [`link`] puts the imported files before the source, each file once; the result is plain WGSL,
//! and [`LinkedSource::locate`] finds the file and line that a byte of the result came from.

use crate::diag::Diagnostic;

mod bounds;
mod depth;
mod embedded;
mod link;
mod loops;
mod operations;
mod permitted;
mod scan;
mod validate;

pub use bounds::{
    MAX_BRANCHES, MAX_CODE_BYTES, MAX_DECLARATIONS, MAX_OPERATORS, MAX_STATEMENTS, beyond_bounds,
};
use chiaro_locale::tr;
pub use depth::depth_of_entry_points;
#[cfg(test)]
pub use embedded::shipped_nodes;
pub use embedded::{PASSES, SHADER_LIBRARY};
pub use link::{LinkedFile, LinkedSource, NamedSource, library_scans, link};
pub use loops::{BoundedLoops, CountedLoop, MAX_CALL_ROUNDS, MAX_ROUNDS, bound_loops};
pub use operations::Operations;
pub use permitted::{
    MAX_CODE_OPERATIONS, MAX_TABLE_BYTES, MAX_TABLE_LENGTH, MAX_VARIABLE_BYTES, refusals,
};
pub use scan::{
    Declaration, DeclarationKind, Field, Import, Scan, code, identifiers, rename_identifiers, scan,
};
pub use validate::{ValidModule, WgslError, parse, validate};

/// Source of a pass: `shaders/passes/NAME.wgsl` with its imports, and with some of its constants
/// set to other numbers.
///
/// # Errors
/// A diagnostic for a missing pass, constant or import.
pub fn pass(name: &str, constants: &[(&str, i32)]) -> Result<LinkedSource, Vec<Diagnostic>> {
    let is_it = |path: &str| {
        path.rsplit('/').next().and_then(|file| file.strip_suffix(".wgsl")) == Some(name)
    };
    let Some((path, text)) = PASSES.iter().find(|(path, _)| is_it(path)) else {
        return Err(vec![Diagnostic::error(
            "missing-pass",
            tr!("this build of Chiaro lacks the pass `{name}`"),
        )]);
    };
    let mut text = (*text).to_owned();
    for (constant, number) in constants {
        text = with_constant(&text, constant, *number).ok_or_else(|| {
            let message = tr!("the pass `{name}` has no line `const {constant} = ...;`");
            vec![Diagnostic::error("missing-constant", message)]
        })?;
    }
    link(&[NamedSource { name: path, text: &text }])
}

/// Replaces the number of the line `const NAME = NUMBER;` of `text`; `None` without such a line.
fn with_constant(text: &str, name: &str, number: i32) -> Option<String> {
    let begin = format!("const {name} = ");
    let line = text.lines().find(|line| line.starts_with(&begin))?;
    Some(text.replacen(line, &format!("{begin}{number};"), 1))
}
