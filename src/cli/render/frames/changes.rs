//! Files that change or vanish while frames are drawn of them.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use crate::diag::Diagnostic;
use crate::output::Output;
use crate::used_files::{ChangedFile, FileChange, RecordedFiles, named};

/// Watch over the files that the frames of a run are drawn of.
#[derive(Debug)]
pub(super) struct FileWatch {
    files: Arc<RecordedFiles>,
    /// Files that changed, each with the frame before which that was noticed.
    noticed: BTreeMap<PathBuf, i32>,
}

impl FileWatch {
    pub(super) fn new(files: Arc<RecordedFiles>) -> Self {
        Self { files, noticed: BTreeMap::new() }
    }

    /// Warns, before a frame is planned, of files that have changed since the frame before.
    pub(super) fn look(&mut self, frame: i32, output: &Output) {
        let mut changed = self.files.changed();
        changed.retain(|file| !self.noticed.contains_key(&file.path));
        self.noticed.extend(changed.iter().map(|file| (file.path.clone(), frame)));
        if !changed.is_empty() {
            let name = |file: &ChangedFile| match file.change {
                FileChange::Gone => format!("{} (gone)", file.path.display()),
                FileChange::Unread | FileChange::ReadAgain => file.path.display().to_string(),
            };
            let message = format!("files changed before frame {frame}: {}", named(&changed, name));
            output.diagnostics(&[Diagnostic::warning("files-changed", message)]);
        }
    }

    /// The problem that frames are not of the files as they are now, on one line; `None` where they
    /// are.
    pub(super) fn problem(&self) -> Option<Diagnostic> {
        let changed = self.files.changed();
        let is_gone = changed.iter().any(|file| file.change == FileChange::Gone);
        let files = named(&changed, |file| self.text(file));
        let before = if is_gone { "put back what is gone, and " } else { "" };
        let message = format!(
            "files changed while frames were drawn: {files}; {before}the same command draws anew \
             what that changes"
        );
        (!changed.is_empty()).then(|| Diagnostic::error("files-changed", message))
    }

    /// A file, with the frames that are of it as it was.
    fn text(&self, file: &ChangedFile) -> String {
        let path = file.path.display();
        match (file.change, self.noticed.get(&file.path)) {
            (FileChange::Gone, _) => format!("{path} (gone; all frames are of it as it was)"),
            (FileChange::ReadAgain, Some(frame)) => {
                format!("{path} (frames before {frame} are of it as it was)")
            }
            _ => format!("{path} (all frames are of it as it was)"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::Files as _;

    #[test]
    fn a_picture_that_is_read_again_is_told_with_the_frames_before() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let files = Arc::new(RecordedFiles::default());
        for name in ["look.json", "wall.png"] {
            std::fs::write(path(name), "one").unwrap();
            files.read(&path(name), 100).unwrap();
        }
        let mut watch = FileWatch::new(files.clone());
        let output = Output::new();
        watch.look(1, &output);
        assert!(watch.problem().is_none());
        std::fs::write(path("wall.png"), "others").unwrap();
        watch.look(3, &output);
        files.read(&path("wall.png"), 100).unwrap();
        watch.look(4, &output);
        std::fs::remove_file(path("look.json")).unwrap();
        let told = watch.problem().unwrap().message;
        assert!(told.contains("wall.png (frames before 3 are of it as it was)"), "{told}");
        assert!(told.contains("look.json (gone; all frames"), "{told}");
        assert!(told.contains("; put back what is gone, and the same command"), "{told}");
    }
}
