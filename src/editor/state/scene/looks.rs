//! Looks of a scene that are not open, read from their files: again when a file changes, and in
//! their last state while it is broken.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::tr;

use crate::catalog::Catalog;
use crate::compile::{TypedGraph, TypedSource, check};
use crate::diag::{Diagnostic, WithWarnings, has_errors};
use crate::document::{LoadedDocument, Look, Value};
use crate::files::{FileKind, FileMetadata, Files};
use crate::frame::SetupLook;
use crate::library::{Library, Type};
use crate::state::reading::{LookWithLibrary, Parameter};

/// Looks by their files.
#[derive(Default)]
pub(super) struct Looks {
    known: BTreeMap<PathBuf, LookFile>,
    /// Library that the looks were read with.
    library: Option<Arc<Library>>,
}

struct LookFile {
    stamp: Option<FileMetadata>,
    /// The look; `None` where it could never be read.
    look: Option<Arc<ClosedLook>>,
    problems: Vec<Diagnostic>,
}

/// A look that is not open, with its parameters and images.
pub(super) struct ClosedLook {
    pub(super) look: Arc<SetupLook>,
    /// Parameters that objects which wear the look may set.
    pub(super) parameters: Vec<Parameter>,
    /// Files of the look's images.
    pub(super) images: Vec<PathBuf>,
}

impl Looks {
    /// Reads files that are new or have changed, and forgets those not in `files`. With another
    /// library all files are read anew.
    pub(super) fn refresh<'p>(
        &mut self,
        files: impl Iterator<Item = &'p PathBuf>,
        library: &Arc<Library>,
        from: &dyn Files,
    ) {
        let has_same_nodes = self.library.as_ref().is_some_and(|known| Arc::ptr_eq(known, library));
        self.library = Some(library.clone());
        let mut old = std::mem::take(&mut self.known);
        let mut catalog = None;
        for file in files {
            if self.known.contains_key(file) {
                continue;
            }
            let stamp = from.metadata(file).filter(|found| found.kind == FileKind::Plain);
            let known = match old.remove(file) {
                Some(known) if known.stamp == stamp && has_same_nodes => known,
                _ if stamp.is_none() => continue,
                known => {
                    let before = known.and_then(|known| known.look);
                    let loaded = Look::load(from, file);
                    read(file, stamp, loaded, before, library, &mut catalog)
                }
            };
            self.known.insert(file.clone(), known);
        }
    }

    /// The look in a file, `Some(None)` if it is broken; `None` where there is no such file.
    pub(super) fn get(&self, file: &Path) -> Option<Option<Arc<ClosedLook>>> {
        self.known.get(file).map(|known| known.look.clone())
    }

    pub(super) fn problems(&self) -> impl Iterator<Item = &Diagnostic> {
        self.known.values().flat_map(|known| &known.problems)
    }
}

/// The look that was `loaded` from a file; `before` is shown where it is broken now. `catalog` is
/// of the library, made at the first need.
fn read(
    file: &Path,
    stamp: Option<FileMetadata>,
    loaded: LoadedDocument<Look>,
    before: Option<Arc<ClosedLook>>,
    library: &Library,
    catalog: &mut Option<Catalog>,
) -> LookFile {
    let mut problems = loaded.diagnostics;
    let folder = file.parent().map(Path::to_path_buf).unwrap_or_default();
    let look = loaded.value.filter(|_| !has_errors(&problems));
    let look = look.and_then(|look| match check(&look, library, None) {
        Ok(WithWarnings { value: typed, .. }) => {
            let catalog = catalog.get_or_insert_with(|| Catalog::new(library));
            catalog.sync(&look, library);
            let parameters = LookWithLibrary { look: &look, catalog, library }.parameters();
            Some((look, parameters, images(&typed, &folder)))
        }
        Err(mut found) => {
            loaded.source.locate_all(&mut found);
            problems.extend(found);
            None
        }
    });
    let source = Arc::new(loaded.source);
    let look = look.map(|(look, parameters, images)| {
        Arc::new(ClosedLook {
            look: Arc::new(SetupLook { look, source, folder }),
            parameters,
            images,
        })
    });
    let stays = look.is_none() && before.is_some();
    let told = problems.into_iter().map(|problem| of_file(problem, file, stays)).collect();
    LookFile { stamp, look: look.or(before), problems: told }
}

/// Files of the images that a look's nodes name.
fn images(typed: &TypedGraph, folder: &Path) -> Vec<PathBuf> {
    let inputs = typed.nodes.iter().flat_map(|node| node.inputs.iter().flatten());
    let named =
        inputs.filter(|input| input.ty == Type::Image).filter_map(|input| match &input.source {
            TypedSource::Param(_, Value::Text(path)) if !path.is_empty() => Some(folder.join(path)),
            _ => None,
        });
    named.collect()
}

/// A problem of a look that is not open, without its node: the canvas does not show that graph.
/// `stays` is true if an earlier state of the look is shown.
fn of_file(mut problem: Diagnostic, file: &Path, stays: bool) -> Diagnostic {
    let node = problem.place.node.take();
    let node = node.map(|node| format!("`{node}`: ")).unwrap_or_default();
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    problem.message = format!("{name}: {node}{}", problem.message);
    problem.place.port = None;
    problem.place.file.get_or_insert_with(|| file.display().to_string());
    if stays { problem.hint(tr!("it is shown as it was before")) } else { problem }
}
