//! Note of a file that could not be opened: its name, the reason, and a remedy.

use std::path::{Path, PathBuf};

use chiaro_locale::tr;

use crate::diag::{Diagnostic, LineColumn};
use crate::state::paths::absolute;
use crate::state::revision::{DocumentNumber, PaintingNumber};
use crate::state::session::Session;

/// A file that could not be opened.
pub(crate) struct UnopenedFile {
    /// Name of the file, and the reason.
    pub(crate) text: String,
    /// Path of the file, and a remedy.
    pub(crate) help: String,
    /// Path of a file whose reading was not even tried, since the last program ended over it.
    pub(crate) interrupted: Option<PathBuf>,
    /// Documents that were open then: the note is dropped when others are.
    open: (DocumentNumber, Option<PaintingNumber>),
}

impl UnopenedFile {
    pub(super) fn new(path: &Path, problems: &[Diagnostic], session: &Session) -> Self {
        let problem = problems.iter().find(|problem| problem.is_error()).or(problems.first());
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
        let why = problem.map(|problem| problem.message.as_str()).unwrap_or_default();
        let said = tr!("cannot read the file: {reason}", reason = "");
        let why = why.strip_prefix(said.as_str()).unwrap_or(why);
        let at = problem.and_then(|problem| problem.place.at);
        let text = match at {
            Some(LineColumn { line, column }) => {
                tr!("{name} could not be opened: {why} (line {line}, column {column})")
            }
            None => tr!("{name} could not be opened: {why}"),
        };
        let whole = absolute(path);
        let hints = problem.map(|problem| problem.hints.join("; ")).unwrap_or_default();
        let help = if hints.is_empty() { String::new() } else { format!(": {hints}") };
        Self {
            text,
            help: format!("{}{help}", whole.display()),
            interrupted: None,
            open: Self::open(session),
        }
    }

    /// Note of a file that is not read without being asked for.
    pub(super) fn interrupted(path: &Path, session: &Session) -> Self {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
        Self {
            text: tr!("{name} was not opened: Chiaro ended while reading it the last time"),
            help: tr!(
                "{path}: save your other work, then try again",
                path = absolute(path).display()
            ),
            interrupted: Some(path.to_owned()),
            open: Self::open(session),
        }
    }

    fn open(session: &Session) -> (DocumentNumber, Option<PaintingNumber>) {
        (
            session.revisions().document,
            session.painting().map(crate::state::painting::work::OpenPainting::number),
        )
    }

    /// True if no other document was opened since.
    pub(super) fn is_new(&self, session: &Session) -> bool {
        self.open == Self::open(session)
    }
}
