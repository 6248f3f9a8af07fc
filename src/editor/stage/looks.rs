//! The looks that are not open, from their files: read again when those change, and as they were while they are broken.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;

use crate::compile::check;
use crate::diag::{Diagnostic, has_errors};
use crate::document::Look;
use crate::frame::SetupLook;
use crate::library::Library;

/// Looks by their files.
#[derive(Default)]
pub(super) struct Looks {
    known: BTreeMap<PathBuf, Known>,
}

struct Known {
    stamp: Option<(SystemTime, u64)>,
    /// `None` where it could never be read.
    look: Option<Arc<SetupLook>>,
    problems: Vec<Diagnostic>,
}

impl Looks {
    /// Reads those that are not known, or that have changed, and forgets the others.
    pub(super) fn refresh<'p>(&mut self, files: impl Iterator<Item = &'p PathBuf>, library: &Library) {
        let mut old = std::mem::take(&mut self.known);
        for file in files {
            if self.known.contains_key(file) {
                continue;
            }
            let stamp = stamp(file);
            let known = match old.remove(file) {
                Some(known) if known.stamp == stamp => known,
                _ if stamp.is_none() => continue,
                known => read(file, stamp, known.and_then(|known| known.look), library),
            };
            self.known.insert(file.clone(), known);
        }
    }

    /// The look in a file, or that it is broken; `None` where there is no such file.
    pub(super) fn get(&self, file: &Path) -> Option<Option<Arc<SetupLook>>> {
        self.known.get(file).map(|known| known.look.clone())
    }

    pub(super) fn problems(&self) -> impl Iterator<Item = &Diagnostic> {
        self.known.values().flat_map(|known| &known.problems)
    }
}

fn stamp(file: &Path) -> Option<(SystemTime, u64)> {
    let data = std::fs::metadata(file).ok().filter(std::fs::Metadata::is_file)?;
    Some((data.modified().ok()?, data.len()))
}

fn read(file: &Path, stamp: Option<(SystemTime, u64)>, before: Option<Arc<SetupLook>>, library: &Library) -> Known {
    let loaded = Look::load(file);
    let mut problems = loaded.diagnostics;
    let look = loaded.value.filter(|_| !has_errors(&problems));
    let look = look.and_then(|look| match check(&look, library, None) {
        Ok(_) => Some(look),
        Err(mut found) => {
            loaded.source.locate_all(&mut found);
            problems.extend(found);
            None
        }
    });
    let folder = file.parent().map(Path::to_path_buf).unwrap_or_default();
    let source = Arc::new(loaded.source);
    let look = look.map(|look| Arc::new(SetupLook { look, source, folder }));
    let stays = look.is_none() && before.is_some();
    let told = problems.into_iter().map(|problem| of_file(problem, file, stays)).collect();
    Known { stamp, look: look.or(before), problems: told }
}

/// A problem with a look that is not open: its nodes are none of the graph on the canvas.
fn of_file(mut problem: Diagnostic, file: &Path, stays: bool) -> Diagnostic {
    let node = problem.place.node.take();
    let node = node.map(|node| format!("`{node}`: ")).unwrap_or_default();
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    problem.message = format!("{name}: {node}{}", problem.message);
    problem.place.port = None;
    problem.place.file.get_or_insert_with(|| file.display().to_string());
    if stays { problem.hint("it is shown as it was before") } else { problem }
}
