//! What several subcommands do first: find the library, read the look.

use std::path::Path;

use super::output::Output;
use crate::diag::{Diagnostic, has_errors};
use crate::document::{Document, Look};
use crate::frame::SetupLook;
use crate::library::Library;

/// The built-in library with a project's own nodes: those of `nodes`, else of the folder `nodes/` beside the document.
pub(super) fn library_for(document: &Path, nodes: Option<&Path>) -> Library {
    let beside = document.parent().unwrap_or(Path::new("")).join("nodes");
    match nodes {
        Some(folder) => Library::built_in().with_project(folder),
        None if beside.is_dir() => Library::built_in().with_project(&beside),
        None => Library::built_in().clone(),
    }
}

/// The folder given as `--nodes` must be there: a mistyped one would only be seen as unknown kinds.
pub(super) fn check_nodes_folder(nodes: Option<&Path>) -> Result<(), Vec<Diagnostic>> {
    match nodes.filter(|folder| !folder.is_dir()) {
        None => Ok(()),
        Some(folder) => {
            let message = format!("--nodes cannot be `{}`: there is no such folder", folder.display());
            Err(vec![Diagnostic::error("bad-argument", message)])
        }
    }
}

/// Reads a look; where there is a scene or something wrong, says so.
pub(super) fn open_look(path: &Path, output: &Output) -> Result<SetupLook, Vec<Diagnostic>> {
    let loaded = match Document::load(path) {
        Document::Look(loaded) => loaded,
        Document::Scene(_) => {
            let problem = Diagnostic::error("not-a-look", "this is a scene").in_file(path.display().to_string());
            return Err(vec![problem.hint("name one of its looks")]);
        }
    };
    let Some(look) = loaded.value.clone().filter(|_: &Look| !has_errors(&loaded.diagnostics)) else {
        return Err(loaded.diagnostics);
    };
    output.diagnostics(&loaded.diagnostics);
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    Ok(SetupLook { look, source: loaded.source.into(), folder })
}
