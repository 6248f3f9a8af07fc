//! What is printed, in one place: results to standard output, everything else to standard error.

use std::collections::HashSet;
use std::io::{self, IsTerminal as _, Write as _};
use std::sync::{Mutex, MutexGuard, PoisonError};

use serde_json::Value as Json;

use crate::diag::{Diagnostic, reason};
use crate::progress::Progress;

/// Where results and messages go.
#[derive(Debug, Default)]
pub(super) struct Output {
    /// Why a result could not be written; nothing is written after that.
    failed: Mutex<Option<io::Error>>,
}

impl Output {
    pub(super) fn new() -> Self {
        Self::default()
    }

    /// A result. What keeps it from being written is told by [`finish`](Self::finish).
    pub(super) fn result(&self, text: &str) {
        self.write(|out| writeln!(out, "{text}"));
    }

    /// What the argument parser has to say, in colors where a terminal shows them.
    pub(super) fn help(&self, help: &clap::Error) {
        *self.failed() = help.print().err();
    }

    /// Sees that every result has been written, at the end of the program.
    ///
    /// # Errors
    /// `cannot-print`: a disk is full, or whatever else took no more. A reader that has gone away
    /// is no error, as with other tools.
    pub(super) fn finish(&self) -> Result<(), Diagnostic> {
        self.write(|out| out.flush());
        match self.failed().take() {
            Some(error) if error.kind() != io::ErrorKind::BrokenPipe => {
                let message = format!(
                    "the result could not be written to standard output: {}",
                    reason(&error)
                );
                let problem = Diagnostic::error("cannot-print", message);
                Err(problem
                    .hint("what was written is not whole: make room, or write to another place"))
            }
            _ => Ok(()),
        }
    }

    fn failed(&self) -> MutexGuard<'_, Option<io::Error>> {
        self.failed.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn write(&self, write: impl FnOnce(&mut io::StdoutLock<'_>) -> io::Result<()>) {
        let mut failed = self.failed();
        if failed.is_none() {
            *failed = write(&mut io::stdout().lock()).err();
        }
    }

    /// A result as JSON.
    pub(super) fn json(&self, value: &Json) {
        self.result(&serde_json::to_string_pretty(value).unwrap_or_default());
    }

    /// A message about what is being done.
    pub(super) fn message(&self, text: &str) {
        let _ = writeln!(std::io::stderr().lock(), "{text}");
    }

    /// Does long work, and shows how far it has come on one line that is written over and taken
    /// away at the end; nothing where nobody watches.
    pub(super) fn watch<T>(&self, label: &'static str, work: impl FnOnce(&Progress) -> T) -> T {
        let made = work(&watched(label));
        on_terminal("\r\x1b[K");
        made
    }

    /// Does long work that waits for a GPU, and shows how far it has come as [`watch`](Self::watch)
    /// does.
    pub(super) async fn watch_async<T>(
        &self,
        label: &'static str,
        work: impl AsyncFnOnce(&Progress) -> T,
    ) -> T {
        let made = work(&watched(label)).await;
        on_terminal("\r\x1b[K");
        made
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

/// Work whose percents are written over each other on a terminal.
fn watched(label: &'static str) -> Progress {
    Progress::observed_by_percent(move |percent| {
        on_terminal(&format!("\r{label}: {percent} %\x1b[K"));
    })
}

/// Writes to standard error where that is a terminal.
fn on_terminal(text: &str) {
    let mut err = io::stderr().lock();
    if err.is_terminal() {
        let _ = write!(err, "{text}");
        let _ = err.flush();
    }
}

/// The same diagnostics, each once.
pub(super) fn once(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut seen: HashSet<String> = HashSet::new();
    diagnostics.retain(|diagnostic| seen.insert(format!("{diagnostic}{:?}", diagnostic.place)));
    diagnostics
}
