//! The `chiaro` program: reads the command line and hands over to the command line tools or the editor.

use std::process::ExitCode;

use chiaro::cli::{Outcome, run};

fn main() -> ExitCode {
    match run() {
        Outcome::Done(code) => code,
        Outcome::Edit { files, mesh } => edit(&files, mesh.as_deref()),
    }
}

#[cfg(feature = "editor")]
#[expect(clippy::print_stderr, reason = "the program's last words")]
fn edit(files: &[std::path::PathBuf], mesh: Option<&str>) -> ExitCode {
    match chiaro::editor::run(files, mesh) {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

#[cfg(not(feature = "editor"))]
#[expect(clippy::print_stderr, reason = "the program's last words")]
fn edit(_files: &[std::path::PathBuf], _mesh: Option<&str>) -> ExitCode {
    eprintln!("error: this chiaro was built without its editor; build it with the feature `editor`");
    ExitCode::FAILURE
}
