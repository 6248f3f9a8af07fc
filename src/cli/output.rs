//! What is printed, in one place: results to standard output, everything else to standard error.

use std::io::Write as _;

use crate::diag::Diagnostic;

/// Where results and messages go.
#[derive(Debug, Default)]
pub(super) struct Output {}

impl Output {
    pub(super) fn new() -> Self {
        Self {}
    }

    /// A result. A reader that has gone away ends the program quietly, as it does other tools.
    pub(super) fn result(&self, text: &str) {
        let mut out = std::io::stdout().lock();
        let _ = writeln!(out, "{text}");
    }

    /// A message about what is being done.
    pub(super) fn message(&self, text: &str) {
        let _ = writeln!(std::io::stderr().lock(), "{text}");
    }

    /// Diagnostics, each once.
    pub(super) fn diagnostics(&self, diagnostics: &[Diagnostic]) {
        let mut shown: Vec<String> = Vec::new();
        for diagnostic in diagnostics {
            let text = diagnostic.to_string();
            if !shown.contains(&text) {
                self.message(&text);
                shown.push(text);
            }
        }
    }
}
