//! The look as shaders that leave the window, for every language that `chiaro export` writes, by
//! the same code. Compiling for seven languages takes a moment, so a thread does it and no hand
//! waits.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::diag::Diagnostic;
use crate::document::Look;
use crate::export::{self, Export};
use crate::files::Outputs;
use crate::library::Library;
use crate::state::session::Session;
use crate::state::worker::Worker;

/// What leaves, and where to.
enum Destination {
    /// All files, into this folder.
    Folder(PathBuf),
    /// The file of the look itself with this ending (`.frag`), to the clipboard.
    Clipboard(&'static str),
}

/// A look as it was when it was asked for.
struct LookExportRequest {
    look: Look,
    library: Arc<Library>,
    stem: String,
    /// Where paths of images begin.
    folder: PathBuf,
    /// The look's own file, which nothing may write over.
    path: Option<PathBuf>,
    language: &'static str,
    to: Destination,
}

/// What became of it.
#[derive(Debug, PartialEq)]
pub(crate) enum LookExportResult {
    /// What to tell.
    Told(String),
    /// What to copy, and what to tell.
    Copied(String, String),
}

/// The thread that does it, and where the last export went.
pub(crate) struct LookExports {
    worker: Worker<Vec<LookExportRequest>, Vec<LookExportResult>>,
    folder: Option<PathBuf>,
}

impl LookExports {
    /// `wake` is called from another thread when something is done.
    pub(crate) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let work = |jobs: Vec<LookExportRequest>| jobs.iter().map(run).collect();
        Self { worker: Worker::new("export look", wake, work), folder: None }
    }

    /// Writes the open look, as it is now, in a language (or [`export::ALL`]) into a folder.
    pub(crate) fn write(&mut self, session: &Session, language: &'static str, folder: PathBuf) {
        self.folder = Some(folder.clone());
        self.add(job(session, language, Destination::Folder(folder)));
    }

    /// Copies the open look, as it is now, in a language: of its files the one with this ending.
    pub(crate) fn copy(&self, session: &Session, language: &'static str, ending: &'static str) {
        self.add(job(session, language, Destination::Clipboard(ending)));
    }

    /// The folder that is offered: the one of the last export, or a new one beside the look.
    pub(crate) fn suggested(&self, session: &Session) -> PathBuf {
        self.folder.clone().unwrap_or_else(|| session.folder().join(own_folder(&stem(session))))
    }

    fn add(&self, job: LookExportRequest) {
        // Nothing that waits is dropped.
        self.worker
            .request(|waiting| waiting.unwrap_or_default().into_iter().chain([job]).collect());
    }

    pub(crate) fn answers(&self) -> impl Iterator<Item = LookExportResult> + use<> {
        self.worker.answers().into_iter().flatten()
    }

    pub(crate) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    pub(crate) fn wait(&self) {
        self.worker.wait();
    }
}

/// What the names of the look's files begin with, as `chiaro export` has it: the name of its own
/// file.
fn stem(session: &Session) -> String {
    let of_file =
        session.path().and_then(Path::file_stem).map(|stem| stem.to_string_lossy().into_owned());
    of_file.unwrap_or_else(|| stem_of(&session.look().name))
}

/// What a look's files are called that has none yet: `Rim light` is kept as `rim-light`.
pub(crate) fn stem_of(look: &str) -> String {
    let words = look.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let stem = words.take(8).collect::<Vec<_>>().join("-").to_lowercase();
    if stem.is_empty() { "look".to_owned() } else { stem }
}

/// A folder for an export alone.
fn own_folder(stem: &str) -> String {
    format!("{stem}-shaders")
}

fn job(session: &Session, language: &'static str, to: Destination) -> LookExportRequest {
    LookExportRequest {
        look: session.look().clone(),
        library: session.project.library.clone(),
        stem: stem(session),
        folder: session.folder(),
        path: session.path().map(Path::to_path_buf),
        language,
        to,
    }
}

fn run(job: &LookExportRequest) -> LookExportResult {
    let exported = export::languages([job.language]).and_then(|languages| {
        Ok((
            export::export(&job.look, &job.library, &job.stem, &languages, &job.folder)?,
            languages,
        ))
    });
    let done = exported.and_then(|(exported, languages)| match &job.to {
        Destination::Folder(folder) => {
            let told = write(&exported, folder, job)?;
            let unverified =
                export::unverified(&languages).map(|told| format!(" · {told}")).unwrap_or_default();
            Ok(LookExportResult::Told(told + &unverified))
        }
        Destination::Clipboard(ending) => copy(&exported, ending, job),
    });
    done.unwrap_or_else(|problems| LookExportResult::Told(told(&problems)))
}

/// Writes the files. Where they would take a document's place they go into a folder of their own,
/// rather than nowhere: whoever takes the look's own folder, where dialogs begin, has made no
/// mistake.
fn write(
    exported: &Export,
    folder: &Path,
    job: &LookExportRequest,
) -> Result<String, Vec<Diagnostic>> {
    let mut outputs = Outputs::new(false);
    job.path.iter().for_each(|path| outputs.reads(path));
    let is_free = export::in_the_way(&exported.files, folder, &outputs).is_none();
    let folder = if is_free { folder.to_owned() } else { folder.join(own_folder(&job.stem)) };
    let written = export::write(&exported.files, &folder, &mut outputs)?;
    let count = match written.len() {
        1 => "1 file".to_owned(),
        count => format!("{count} files"),
    };
    Ok(format!("Exported {count} to {}", folder.display()))
}

fn copy(
    exported: &Export,
    ending: &str,
    job: &LookExportRequest,
) -> Result<LookExportResult, Vec<Diagnostic>> {
    // The look's own module is called as the look is: `rim.es300.frag`, and
    // `rim.normals.es300.frag` that of a pass.
    let own = format!("{}{ending}", job.stem);
    let file = exported.files.iter().find(|file| file.name == own);
    let text =
        file.and_then(|file| Some((String::from_utf8(file.bytes.clone()).ok()?, &file.name)));
    let Some((text, name)) = text else {
        return Err(vec![
            Diagnostic::error("no-text", "this language is no text to copy")
                .hint("Export writes it to a file"),
        ]);
    };
    let is_of_pass = |file: &export::File| {
        file.name != own && file.name.ends_with(ending) && !file.name.contains(".prepare.")
    };
    let more = if exported.files.iter().any(is_of_pass) {
        ". It reads what other passes draw: Export writes those too"
    } else {
        ""
    };
    Ok(LookExportResult::Copied(text, format!("{name} is in the clipboard{more}")))
}

/// The first of what is wrong, with the node and port that it is at and what to do.
fn told(problems: &[Diagnostic]) -> String {
    let Some(first) = problems.iter().find(|problem| problem.is_error()).or(problems.first())
    else {
        return "Nothing was exported".to_owned();
    };
    let place = match (&first.place.node, &first.place.port) {
        (Some(node), Some(port)) => format!(" (node {node}, input {port})"),
        (Some(node), None) => format!(" (node {node})"),
        _ => first.place.file.as_ref().map(|file| format!(" ({file})")).unwrap_or_default(),
    };
    let hints: String = first.hints.iter().map(|hint| format!("; {hint}")).collect();
    let more = match problems.len() {
        0 | 1 => String::new(),
        count => format!("; and {} more, which Problems lists", count - 1),
    };
    format!("Not exported: {}{place}{hints}{more}", first.message)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn looks_are_kept_under_their_names() {
        assert_eq!(stem_of("Rim light, No. 2"), "rim-light-no-2");
        assert_eq!(stem_of("../.."), "look");
        assert_eq!(stem_of("Größe 光"), "größe-光");
    }

    #[test]
    fn what_is_wrong_is_told_with_its_place_and_what_to_do() {
        let mut problem =
            Diagnostic::error("no-input", "nothing is wired here").hint("wire something");
        problem.place.node = Some(crate::ids::NodePath::root("rim".into()));
        problem.place.port = Some("normal".into());
        let warning = Diagnostic::warning("odd", "odd");
        let told = told(&[warning, problem]);
        assert_eq!(
            told,
            "Not exported: nothing is wired here (node rim, input normal); wire something; and 1 \
             more, which Problems \
             lists"
        );
    }
}
