//! The `chiaro` program: reads the command line and hands over to the command line tools or the
//! editor.

use std::io::Write as _;
use std::process::ExitCode;

use chiaro::cli::{Outcome, run};

fn main() -> ExitCode {
    match run() {
        Outcome::Done(code) => code,
        Outcome::Edit { files, mesh } => edit(&files, mesh.as_deref()),
    }
}

#[cfg(feature = "editor")]
fn edit(files: &[std::path::PathBuf], mesh: Option<&str>) -> ExitCode {
    match chiaro::editor::run(files, mesh) {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => last_words(&problem),
    }
}

#[cfg(not(feature = "editor"))]
fn edit(_files: &[std::path::PathBuf], _mesh: Option<&str>) -> ExitCode {
    last_words(
        &"error: this chiaro was built without its editor; build it with the feature `editor`",
    )
}

/// Says why the program ends, where there is anybody to hear: a closed standard error is no reason
/// to panic.
fn last_words(words: &dyn std::fmt::Display) -> ExitCode {
    let _ = writeln!(std::io::stderr().lock(), "{words}");
    ExitCode::FAILURE
}
