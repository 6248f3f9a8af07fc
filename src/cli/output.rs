//! What is printed, in one place: results to standard output, everything else to standard error.

use std::collections::HashSet;
use std::io::{IsTerminal as _, Write as _};

use serde_json::Value as Json;

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

    /// A result as JSON.
    pub(super) fn json(&self, value: &Json) {
        self.result(&serde_json::to_string_pretty(value).unwrap_or_default());
    }

    /// A message about what is being done.
    pub(super) fn message(&self, text: &str) {
        let _ = writeln!(std::io::stderr().lock(), "{text}");
    }

    /// How far long work has come, on one line that is written over; nothing where nobody watches.
    pub(super) fn progress(&self, what: &str, done: u64, total: u64) {
        let mut err = std::io::stderr().lock();
        if err.is_terminal() && total > 0 {
            let _ = write!(err, "\r{what}: {} %\x1b[K", 100 * done / total);
            let _ = err.flush();
        }
    }

    /// Takes the line of progress away.
    pub(super) fn end_progress(&self) {
        let mut err = std::io::stderr().lock();
        if err.is_terminal() {
            let _ = write!(err, "\r\x1b[K");
        }
    }

    /// Diagnostics, each once.
    pub(super) fn diagnostics(&self, diagnostics: &[Diagnostic]) {
        let mut shown: HashSet<String> = HashSet::new();
        for diagnostic in diagnostics {
            let text = diagnostic.to_string();
            if shown.insert(text.clone()) {
                self.message(&text);
            }
        }
    }
}

/// The same diagnostics, each once.
pub(super) fn once(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut seen: HashSet<String> = HashSet::new();
    diagnostics.retain(|diagnostic| seen.insert(format!("{diagnostic}{:?}", diagnostic.place)));
    diagnostics
}
