//! First steps of several subcommands: finding the library, reading the look.

use std::path::{Component, Path, PathBuf};

use super::output::Output;
use crate::diag::{Diagnostic, has_errors};
use crate::document::{Document, Look, Scene};
use crate::files::{Disk, Files};
use crate::frame::{SetupLook, scene_of};
use crate::library::Library;

/// [`library_of`] the files of the disk.
pub(super) fn library_for(document: &Path, nodes: Option<&Path>) -> Library {
    library_of(&Disk, document, nodes)
}

/// The built-in library with a project's own nodes: those in the folder `nodes`, else those in
/// `nodes/` beside the document, or beside the scene that a shot changes.
pub(super) fn library_of(files: &dyn Files, document: &Path, nodes: Option<&Path>) -> Library {
    let beside = |document: &Path| document.parent().unwrap_or(Path::new("")).join("nodes");
    let mut beside = [document.to_path_buf(), scene_of(files, document)]
        .map(|document| beside(&document))
        .into_iter();
    let beside = beside.find(|folder| nodes.is_none() && folder.is_dir()).unwrap_or_default();
    match nodes {
        Some(folder) => Library::built_in().with_project(files, folder),
        None if beside.as_os_str().is_empty() => Library::built_in().clone(),
        None => Library::built_in().with_project(files, &beside),
    }
}

/// Checks that the folder given as `--nodes` exists: a mistyped one would only show as unknown
/// kinds.
pub(super) fn check_nodes_folder(nodes: Option<&Path>) -> Result<(), Vec<Diagnostic>> {
    match nodes.filter(|folder| !folder.is_dir()) {
        None => Ok(()),
        Some(folder) => {
            let message =
                format!("--nodes cannot be `{}`: there is no such folder", folder.display());
            Err(vec![Diagnostic::error("bad-argument", message)])
        }
    }
}

/// Largest number of a scene's looks that a message names.
const NAMED: usize = 6;

/// Error for a scene given in place of a look, with the paths of the scene's looks as a hint.
pub(super) fn not_a_look(path: &Path, scene: Option<&Scene>) -> Diagnostic {
    let problem =
        Diagnostic::error("not-a-look", "this is a scene").in_file(path.display().to_string());
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut looks: Vec<String> = Vec::new();
    for look in scene
        .iter()
        .flat_map(|scene| scene.objects.values())
        .flat_map(|object| object.looks.values())
    {
        let look = beside(folder, look);
        if !looks.contains(&look) {
            looks.push(look);
        }
    }
    if looks.is_empty() {
        return problem.hint("name a look in its place: a file whose \"chiaro\" is \"look\"");
    }
    let left = looks.len().saturating_sub(NAMED);
    let more = if left > 0 { format!(" or {left} more") } else { String::new() };
    looks.truncate(NAMED);
    problem.hint(format!("name one of its looks in its place: {}{more}", looks.join(", ")))
}

/// A path of a document in its shortest form: `scenes/../looks/a.json` is `looks/a.json`.
pub(super) fn beside(folder: &Path, path: &str) -> String {
    let mut short = PathBuf::new();
    for part in folder.join(path).components() {
        match (part, short.components().next_back()) {
            (Component::ParentDir, Some(Component::Normal(_))) => drop(short.pop()),
            _ => short.push(part),
        }
    }
    short.display().to_string()
}

/// Reads a look; prints its warnings, and returns errors for a scene or a broken look.
pub(super) fn open_look(path: &Path, output: &Output) -> Result<SetupLook, Vec<Diagnostic>> {
    let loaded = match Document::load(&Disk, path) {
        Document::Look(loaded) => loaded,
        Document::Scene(scene) => return Err(vec![not_a_look(path, scene.value.as_ref())]),
        Document::Shot(_) => {
            let problem = Diagnostic::error("not-a-look", "this is a shot, which changes a scene");
            return Err(vec![
                problem
                    .in_file(path.display().to_string())
                    .hint("name a look in its place: a file whose \"chiaro\" is \"look\""),
            ]);
        }
    };
    let Some(look) = loaded.value.clone().filter(|_: &Look| !has_errors(&loaded.diagnostics))
    else {
        return Err(loaded.diagnostics);
    };
    output.diagnostics(&loaded.diagnostics);
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    Ok(SetupLook { look, source: loaded.source.into(), folder })
}
