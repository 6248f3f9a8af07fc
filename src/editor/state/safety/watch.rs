//! Watch on files that may have changed. What changed, and whether anything did, is for the caller
//! to check: events come several at a time, for half-written files, and on some systems not at all.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use notify::{EventKind, RecommendedWatcher, RecursiveMode, Watcher as _};

/// Paths that are watched.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct WatchedPaths {
    /// Files, which may not exist yet.
    pub(super) files: BTreeSet<PathBuf>,
    /// Folders with everything in them, which may not exist yet.
    pub(super) folders: BTreeSet<PathBuf>,
    /// Existing folders of `folders`, and the folders below that are looked at. The system is asked
    /// for each alone: asked for a folder with everything below, it would follow links over the
    /// whole disk.
    pub(super) below: BTreeSet<PathBuf>,
}

impl WatchedPaths {
    fn holds(&self, path: &Path) -> bool {
        self.files.contains(path) || self.folders.iter().any(|folder| path.starts_with(folder))
    }

    /// Folders to ask the system for. A file is watched by its folder, since a save puts another
    /// file in its place.
    fn to_ask_for(&self) -> BTreeSet<PathBuf> {
        let parents = self.files.iter().chain(&self.folders).filter_map(|path| path.parent());
        let folders = parents.chain(self.below.iter().map(PathBuf::as_path));
        folders.filter(|folder| folder.is_dir()).map(Path::to_path_buf).collect()
    }
}

#[derive(Default)]
struct WatchState {
    watched: Mutex<WatchedPaths>,
    happened: AtomicBool,
}

/// The system's watch on files.
pub(super) struct Watch {
    shared: Arc<WatchState>,
    /// The system's watcher; `None` where the system has none: files are checked when the window
    /// gets the focus again.
    watcher: Option<RecommendedWatcher>,
    folders: BTreeSet<PathBuf>,
}

impl Watch {
    /// Starts watching. `wake` is called from another thread when something happened.
    pub(super) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let shared = Arc::new(WatchState::default());
        let seen = shared.clone();
        let watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
            let watched = seen.watched.lock().unwrap_or_else(PoisonError::into_inner);
            let is_ours = match event {
                // Reading is no change. An event without a path means that events were lost.
                Ok(event) if matches!(event.kind, EventKind::Access(_)) => false,
                Ok(event) => {
                    event.paths.is_empty() || event.paths.iter().any(|path| watched.holds(path))
                }
                Err(_) => true,
            };
            drop(watched);
            if is_ours {
                seen.happened.store(true, Ordering::Relaxed);
                wake();
            }
        });
        Self { shared, watcher: watcher.ok(), folders: BTreeSet::new() }
    }

    /// Watches other folders below, and asks the system for all folders anew: a folder that was
    /// replaced by another of the same name is no longer watched, and the system does not report
    /// that.
    pub(super) fn renew(&mut self, below: BTreeSet<PathBuf>) {
        let watched = self.shared.watched.lock().unwrap_or_else(PoisonError::into_inner).clone();
        for folder in std::mem::take(&mut self.folders) {
            if let Some(watcher) = &mut self.watcher {
                let _ = watcher.unwatch(&folder);
            }
        }
        self.set(WatchedPaths { below, ..watched });
    }

    /// Watches these paths and nothing else.
    pub(super) fn set(&mut self, watched: WatchedPaths) {
        let folders = watched.to_ask_for();
        *self.shared.watched.lock().unwrap_or_else(PoisonError::into_inner) = watched;
        let Some(watcher) = &mut self.watcher else { return };
        for folder in self.folders.difference(&folders) {
            // A removed folder is no longer watched anyway.
            let _ = watcher.unwatch(folder);
        }
        for folder in folders.difference(&self.folders) {
            // A failure means that the system has no more watches to give: files are checked when
            // the window gets the focus again.
            let _ = watcher.watch(folder, RecursiveMode::NonRecursive);
        }
        self.folders = folders;
    }

    /// True if anything happened since the last call.
    pub(super) fn take(&self) -> bool {
        self.shared.happened.swap(false, Ordering::Relaxed)
    }
}
