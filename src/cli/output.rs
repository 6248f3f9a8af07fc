//! Output of the program, in one place: results to standard output, everything else to standard
//! error.

use std::collections::HashSet;
use std::io::{self, IsTerminal as _, Write as _};
use std::sync::{Mutex, MutexGuard, PoisonError};

use serde_json::Value as Json;

use crate::diag::{Diagnostic, Severity, reason};
use crate::progress::Progress;

/// Output of results and messages.
#[derive(Debug, Default)]
pub(super) struct Output {
    /// Error that kept a result from being written; nothing is written after it.
    failed: Mutex<Option<io::Error>>,
}

impl Output {
    pub(super) fn new() -> Self {
        Self::default()
    }

    /// Prints a result. An error of printing is returned by [`finish`](Self::finish).
    pub(super) fn result(&self, text: &str) {
        self.write(|out| writeln!(out, "{text}"));
    }

    /// Prints a text of the argument parser, in colors if the terminal shows them.
    pub(super) fn help(&self, help: &clap::Error) {
        *self.failed() = help.print().err();
    }

    /// Makes sure, at the end of the program, that every result has been written.
    ///
    /// # Errors
    /// `cannot-print`: a disk is full, or standard output takes no more for another reason. A
    /// reader that has gone away is no error, as with other tools.
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

    /// Prints a result as JSON.
    pub(super) fn json(&self, value: &Json) {
        self.result(&serde_json::to_string_pretty(value).unwrap_or_default());
    }

    /// Prints a message about the work that is done.
    pub(super) fn message(&self, text: &str) {
        let _ = writeln!(std::io::stderr().lock(), "{text}");
    }

    /// Does long work, and shows its progress on one line that is overwritten and erased at the
    /// end; shows nothing if standard error is no terminal.
    pub(super) fn watch<T>(&self, label: &'static str, work: impl FnOnce(&Progress) -> T) -> T {
        let made = work(&watched(label));
        on_terminal("\r\x1b[K");
        made
    }

    /// Does long work that waits for a GPU, and shows its progress as [`watch`](Self::watch) does.
    pub(super) async fn watch_async<T>(
        &self,
        label: &'static str,
        work: impl AsyncFnOnce(&Progress) -> T,
    ) -> T {
        let made = work(&watched(label)).await;
        on_terminal("\r\x1b[K");
        made
    }

    /// Prints diagnostics, each once.
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

/// Progress whose percents overwrite each other on a terminal.
fn watched(label: &'static str) -> Progress {
    Progress::observed_by_percent(move |percent| {
        on_terminal(&format!("\r{label}: {percent} %\x1b[K"));
    })
}

/// Writes to standard error if it is a terminal.
fn on_terminal(text: &str) {
    let mut err = io::stderr().lock();
    if err.is_terminal() {
        let _ = write!(err, "{text}");
        let _ = err.flush();
    }
}

/// Makes errors of warnings, for who is strict.
pub(super) fn raise(diagnostics: &mut [Diagnostic]) {
    for diagnostic in diagnostics.iter_mut().filter(|one| one.severity == Severity::Warning) {
        diagnostic.severity = Severity::Error;
    }
}

/// Refuses to go on over warnings, for who is strict.
///
/// # Errors
/// All diagnostics, each once, warnings as errors, where one of them is a warning.
pub(super) fn refuse_warnings(
    is_strict: bool,
    diagnostics: &mut Vec<Diagnostic>,
) -> Result<(), Vec<Diagnostic>> {
    if !is_strict || diagnostics.iter().all(|one| one.severity != Severity::Warning) {
        return Ok(());
    }
    raise(diagnostics);
    Err(once(std::mem::take(diagnostics)))
}

/// The diagnostics, each once.
pub(super) fn once(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut seen: HashSet<String> = HashSet::new();
    diagnostics.retain(|diagnostic| seen.insert(format!("{diagnostic}{:?}", diagnostic.place)));
    diagnostics
}
