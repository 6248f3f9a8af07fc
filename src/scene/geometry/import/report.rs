//! Collector of a reader's diagnostics, up to a bound.

use chiaro_locale::trn;

use crate::diag::{Diagnostic, LineColumn, has_errors};

/// Greatest number of problems of one file that are told; further ones are counted.
const MAX_TOLD: usize = 20;

/// Error type of a reader's functions; boxed, because a diagnostic is big and results are many.
pub(super) type ImportProblem = Box<Diagnostic>;

/// The diagnostics of one file.
pub(super) struct ImportReport {
    file: String,
    list: Vec<Diagnostic>,
    untold: usize,
}

impl ImportReport {
    pub(super) fn new(file: &str) -> Self {
        Self { file: file.to_owned(), list: Vec::new(), untold: 0 }
    }

    /// Adds a diagnostic of this file.
    pub(super) fn add(&mut self, diagnostic: Diagnostic) {
        if self.list.len() < MAX_TOLD || (diagnostic.is_error() && !has_errors(&self.list)) {
            self.list.push(diagnostic.in_file(self.file.as_str()));
        } else {
            self.untold += 1;
        }
    }

    /// Adds an error of the file as a whole.
    pub(super) fn error(&mut self, code: &'static str, message: impl Into<String>) {
        self.add(Diagnostic::error(code, message));
    }

    /// Adds an error at `token`, which is a slice of `text`.
    pub(super) fn error_at(
        &mut self,
        text: &str,
        token: &str,
        code: &'static str,
        message: impl Into<String>,
    ) {
        self.add_at(text, token, Diagnostic::error(code, message));
    }

    /// Adds a diagnostic at `token`, which is a slice of `text`.
    pub(super) fn add_at(&mut self, text: &str, token: &str, diagnostic: Diagnostic) {
        // Finding the line takes a walk through the text, so it is done only for diagnostics that
        // are told.
        if self.list.len() < MAX_TOLD {
            let offset = (token.as_ptr() as usize).saturating_sub(text.as_ptr() as usize);
            self.add(diagnostic.at(LineColumn::of(text, offset)));
        } else {
            self.add(diagnostic);
        }
    }

    /// True if an error was reported, so that the file cannot be used.
    pub(super) fn has_errors(&self) -> bool {
        has_errors(&self.list)
    }

    /// Hands over all diagnostics if there is an error.
    pub(super) fn stop_on_errors(&mut self) -> Result<(), Vec<Diagnostic>> {
        if self.has_errors() { Err(self.take()) } else { Ok(()) }
    }

    /// All diagnostics of the file.
    pub(super) fn into_list(mut self) -> Vec<Diagnostic> {
        self.take()
    }

    fn take(&mut self) -> Vec<Diagnostic> {
        let mut list = std::mem::take(&mut self.list);
        if self.untold > 0 {
            let message = trn!(
                count = self.untold,
                "there are {count} more problems of this kind",
                "there are {count} more problems of this kind"
            );
            list.push(Diagnostic::note("mesh-more", message).in_file(self.file.as_str()));
        }
        list
    }
}
