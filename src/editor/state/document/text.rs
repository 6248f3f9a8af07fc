//! Documents whose files are text: looks and scenes.

use std::path::Path;
use std::sync::Arc;

use super::{FileDocument, FileRefusals, OnDisk, OpenDocument};
use crate::diag::{Diagnostic, Place};
use crate::document::{LoadedDocument, Look, Scene, Shot, SourceMap};

/// A text file in its state when it was last read or written.
pub(crate) struct TextFile {
    pub(crate) source: Arc<SourceMap>,
    /// Source as it was opened: a document that means the same again after a save is written in
    /// that form.
    pub(crate) opened: Arc<SourceMap>,
}

impl TextFile {
    /// A file that was opened just now.
    pub(crate) fn new(source: SourceMap) -> Self {
        let source = Arc::new(source);
        Self { opened: source.clone(), source }
    }

    /// The file after it was written.
    pub(crate) fn written(&self, source: SourceMap) -> Self {
        Self { source: Arc::new(source), opened: self.opened.clone() }
    }
}

/// A document with a text form.
pub(crate) trait TextDocument: FileDocument<FileState = TextFile, Change = String> {
    fn read_text(text: &str, file: &str) -> LoadedDocument<Self>;

    /// The canonical text, with the spelling of `source` wherever that means the same.
    fn text_like(&self, source: &SourceMap) -> String;
}

macro_rules! text_document {
    ($document:ty, $refusals:expr) => {
        impl FileDocument for $document {
            type FileState = TextFile;
            type Change = String;
            const REFUSALS: FileRefusals = $refusals;

            fn on_disk(document: &OpenDocument<Self>, path: &Path) -> OnDisk {
                match crate::files::read_text(path) {
                    Ok(found) if found == **document.file.source.text() => OnDisk::Same,
                    Ok(found) if document.journal.overrides(&found) => OnDisk::Same,
                    Ok(found) => OnDisk::Changed(found),
                    Err(_) if !path.exists() => OnDisk::Gone,
                    Err(_) => OnDisk::Unreadable,
                }
            }
        }

        impl TextDocument for $document {
            fn read_text(text: &str, file: &str) -> LoadedDocument<Self> {
                Self::read(text, file)
            }

            fn text_like(&self, source: &SourceMap) -> String {
                self.to_text_like(source)
            }
        }
    };
}

text_document!(Look, FileRefusals::OF_FILE);
text_document!(Scene, FileRefusals::OF_SCENE);
text_document!(Shot, FileRefusals::OF_SHOT);

impl<D> OpenDocument<D>
where
    D: TextDocument + Send + 'static,
    D::Edit: Send,
{
    /// Text of a document: as the file has it, or had it when it was opened, where that means the
    /// same; else the canonical form.
    pub(crate) fn text_of(&self, document: &D) -> String {
        let text = document.text_like(&self.file.source);
        match text == **self.file.source.text() {
            true => text,
            false => document.text_like(&self.file.opened),
        }
    }

    /// Takes a file that was written with this text, and holds the document from now on.
    pub(crate) fn text_was_written(&mut self, path: &Path, text: &str) {
        let source = D::read_text(text, &path.display().to_string()).source;
        let file = self.file.written(source);
        self.was_written(path.to_owned(), file);
    }

    /// Tells the problems of the file again, in the language that is spoken now. Where the file as
    /// it was read has other problems, those that are told stay: they are of another text.
    pub(crate) fn tell_again(&mut self) {
        if self.load_problems.is_empty() {
            return;
        }
        let file = self.path.as_deref().map(|path| path.display().to_string());
        let told = D::read_text(self.file.source.text(), &file.unwrap_or_default()).diagnostics;
        let of = |problems: &[Diagnostic]| -> Vec<(&'static str, Place)> {
            problems.iter().map(|problem| (problem.code, problem.place.clone())).collect()
        };
        if of(&told) == of(&self.load_problems) {
            self.load_problems = told;
        }
    }

    /// Takes the file as another program wrote it; the document means the same.
    pub(crate) fn was_reloaded(&mut self, source: SourceMap) {
        self.file = TextFile::new(source);
        self.is_partial = false;
        self.history.mark_saved();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::History;

    #[test]
    fn problems_of_a_file_are_told_again() {
        let LoadedDocument { source, diagnostics, .. } =
            Look::read(r#"{"nodes": [], "odd": 1}"#, "");
        assert!(!diagnostics.is_empty());
        let mut open =
            OpenDocument::new(History::new(Look::default()), None, TextFile::new(source));
        let mut before = diagnostics.clone();
        before[0].message = "in another language".to_owned();
        open.load_problems = before.clone();
        open.tell_again();
        assert_eq!(open.load_problems, diagnostics);
        // What another program wrote since cannot be told of this text.
        before.push(Diagnostic::error("odd", "it is odd"));
        open.load_problems = before.clone();
        open.tell_again();
        assert_eq!(open.load_problems, before);
    }
}
