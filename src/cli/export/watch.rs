//! `chiaro export --watch`: the export is made again whenever the look, its images, the mesh or the
//! project's nodes change.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use notify::{EventKind, RecursiveMode, Watcher as _};

use super::super::output::Output;
use super::Arguments;
use crate::diag::Diagnostic;

/// Time without changes after which the files of a save are taken to be whole.
const QUIET: Duration = Duration::from_millis(150);

/// Endings of the files beside a look that it may read.
const READ: [&str; 10] =
    ["json", "wgsl", "png", "jpg", "jpeg", "exr", "hdr", "ies", "hcbtf", "ktx2"];

/// Exports, and exports again after every change, until the program is ended. A look that cannot be
/// exported is told, and what was written before stays.
///
/// # Errors
/// A system that tells of no changes, or no longer.
pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let lost = |reason: String| {
        let message = format!("changes of files cannot be seen: {reason}");
        vec![Diagnostic::error("cannot-watch", message).hint("export without --watch")]
    };
    let (sender, changes) = channel();
    let mut watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
        let paths = match event {
            Ok(event) if matches!(event.kind, EventKind::Access(_)) => return,
            Ok(event) => event.paths,
            // Events were lost: anything may have changed.
            Err(_) => Vec::new(),
        };
        let _is_nobody_there = sender.send(paths);
    })
    .map_err(|error| lost(error.to_string()))?;
    for folder in folders(arguments) {
        let watched = watcher.watch(&folder, RecursiveMode::NonRecursive);
        watched.map_err(|error| lost(error.to_string()))?;
    }
    loop {
        if let Err(problems) = super::export(arguments, output).await {
            output.diagnostics(&problems);
        }
        let look = arguments.look.display();
        output.message(&format!("watching {look}: a save exports again; Ctrl-C ends"));
        wait(&changes, arguments).ok_or_else(|| lost("the watch ended".to_owned()))?;
    }
}

/// Waits for a change of what is read, and until nothing more changes; `None` where there is no one
/// to tell.
fn wait(changes: &Receiver<Vec<PathBuf>>, arguments: &Arguments) -> Option<()> {
    loop {
        let paths = changes.recv().ok()?;
        if paths.is_empty() || paths.iter().any(|path| is_read(path, arguments)) {
            break;
        }
    }
    while changes.recv_timeout(QUIET).is_ok() {}
    Some(())
}

/// Folders that the export reads from: a save puts another file in the place of one, so that a file
/// is watched by its folder.
fn folders(arguments: &Arguments) -> Vec<PathBuf> {
    let parent = |path: &Path| match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
        _ => PathBuf::from("."),
    };
    let beside = parent(&arguments.look);
    let nodes = arguments.nodes.clone().unwrap_or_else(|| beside.join("nodes"));
    let mesh = arguments.mesh.as_deref().map(|mesh| parent(Path::new(mesh)));
    let mut found = vec![beside, nodes];
    found.extend(mesh);
    found.retain(|folder| folder.is_dir());
    found.sort();
    found.dedup();
    found
}

/// True for a file that the export may read, and does not write.
fn is_read(path: &Path, arguments: &Arguments) -> bool {
    let whole = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let is = |other: &Path| whole(path) == whole(other);
    if is(&arguments.look) || arguments.mesh.as_deref().is_some_and(|mesh| is(Path::new(mesh))) {
        return true;
    }
    let written: Option<&Path> = arguments.output.as_ref().map(AsRef::as_ref);
    let is_written = written.is_some_and(|folder| whole(path).starts_with(whole(folder)));
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    !is_written && ending.is_some_and(|ending| READ.contains(&ending.as_str()))
}
