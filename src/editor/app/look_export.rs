//! Export of the look as shaders, for every language that `chiaro export` writes, by the same code.
//! Compiling for seven languages takes a moment, so a thread does it and no hand waits.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::diag::Diagnostic;
use crate::document::Look;
use crate::export::{self, ExportFile};
use crate::files::Outputs;
use crate::frame::{AssetStore, Assets};
use crate::library::Library;
use crate::state::session::Session;
use crate::state::worker::Worker;

/// Destination of an export.
enum Destination {
    /// All files, into this folder.
    Folder(PathBuf),
    /// The file of the look itself with this ending (`.frag`), to the clipboard.
    Clipboard(&'static str),
}

/// A look at the time of the request, with everything for its export.
struct LookExportRequest {
    look: Look,
    library: Arc<Library>,
    stem: String,
    /// Folder that paths of images are relative to.
    folder: PathBuf,
    /// File of the look, which nothing may write over.
    path: Option<PathBuf>,
    language: &'static str,
    to: Destination,
    /// Assets that all pictures of the window share.
    assets: AssetStore,
}

/// Result of an export.
#[derive(Debug, PartialEq)]
pub(crate) enum LookExportResult {
    /// A message.
    Told(String),
    /// Text to copy, and a message.
    Copied(String, String),
}

/// The exporting thread, and the folder of the last export.
pub(crate) struct LookExports {
    worker: Worker<Vec<LookExportRequest>, Vec<LookExportResult>>,
    folder: Option<PathBuf>,
}

impl LookExports {
    /// Starts the thread. `wake` is called from another thread when an export is done.
    pub(crate) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let work = |jobs: Vec<LookExportRequest>| jobs.iter().map(run).collect();
        Self { worker: Worker::new("export look", wake, work), folder: None }
    }

    /// Writes the open look, as it is now, in a language (or [`export::ALL`]) into a folder.
    pub(crate) fn write(&mut self, session: &Session, language: &'static str, folder: PathBuf) {
        self.folder = Some(folder.clone());
        self.add(job(session, language, Destination::Folder(folder)));
    }

    /// Copies the open look, as it is now, in a language: the one of its files with this ending.
    pub(crate) fn copy(&self, session: &Session, language: &'static str, ending: &'static str) {
        self.add(job(session, language, Destination::Clipboard(ending)));
    }

    /// Folder to suggest: that of the last export, or a new one beside the look.
    pub(crate) fn suggested(&self, session: &Session) -> PathBuf {
        self.folder
            .clone()
            .unwrap_or_else(|| session.look.folder().join(own_folder(&stem(session))))
    }

    fn add(&self, job: LookExportRequest) {
        // No waiting request is dropped: the new one is added to them.
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

/// Beginning of the names of the look's files, as `chiaro export` has it: the name of the look's
/// own file without ending.
fn stem(session: &Session) -> String {
    let of_file =
        session.path().and_then(Path::file_stem).map(|stem| stem.to_string_lossy().into_owned());
    of_file.unwrap_or_else(|| stem_of(&session.look().name))
}

/// File name for a look without a file: `Rim light` becomes `rim-light`.
pub(crate) fn stem_of(look: &str) -> String {
    let words = look.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let stem = words.take(8).collect::<Vec<_>>().join("-").to_lowercase();
    if stem.is_empty() { "look".to_owned() } else { stem }
}

/// Name of a folder for one export alone.
fn own_folder(stem: &str) -> String {
    format!("{stem}-shaders")
}

fn job(session: &Session, language: &'static str, to: Destination) -> LookExportRequest {
    LookExportRequest {
        look: session.look().clone(),
        library: session.project.library.clone(),
        stem: stem(session),
        folder: session.look.folder(),
        path: session.path().map(Path::to_path_buf),
        language,
        to,
        assets: session.assets.clone(),
    }
}

fn run(job: &LookExportRequest) -> LookExportResult {
    let exported = export::languages([job.language]).and_then(|languages| {
        let mut assets = Assets::of(&job.assets);
        let place = (job.folder.as_path(), &mut assets);
        Ok((export::export(&job.look, &job.library, &job.stem, &languages, place)?, languages))
    });
    let done = exported.and_then(|(exported, languages)| match &job.to {
        Destination::Folder(folder) => {
            let told = write(&exported.value, folder, job)?;
            let unverified =
                export::unverified(&languages).map(|told| format!(" · {told}")).unwrap_or_default();
            Ok(LookExportResult::Told(told + &unverified))
        }
        Destination::Clipboard(ending) => copy(&exported.value, ending, job),
    });
    done.unwrap_or_else(|problems| LookExportResult::Told(told(&problems)))
}

/// Writes the files of an export. Where they would replace a document they go into a folder of
/// their own, and are not refused: to choose the look's own folder, where dialogs begin, is no
/// mistake.
fn write(
    exported: &[ExportFile],
    folder: &Path,
    job: &LookExportRequest,
) -> Result<String, Vec<Diagnostic>> {
    let mut outputs = Outputs::new(false);
    job.path.iter().for_each(|path| outputs.reads(path));
    let is_free = export::in_the_way(exported, folder, &outputs).is_none();
    let folder = if is_free { folder.to_owned() } else { folder.join(own_folder(&job.stem)) };
    let written = export::write(exported, &folder, &mut outputs)?;
    let count = match written.len() {
        1 => "1 file".to_owned(),
        count => format!("{count} files"),
    };
    Ok(format!("Exported {count} to {}", folder.display()))
}

fn copy(
    exported: &[ExportFile],
    ending: &str,
    job: &LookExportRequest,
) -> Result<LookExportResult, Vec<Diagnostic>> {
    // The look's own module has the look's name, as `rim.es300.frag`; a pass adds its own, as
    // `rim.normals.es300.frag`.
    let own = format!("{}{ending}", job.stem);
    let file = exported.iter().find(|file| file.name == own);
    let text =
        file.and_then(|file| Some((String::from_utf8(file.bytes.clone()).ok()?, &file.name)));
    let Some((text, name)) = text else {
        return Err(vec![
            Diagnostic::error("no-text", "this language is no text to copy")
                .hint("Export writes it to a file"),
        ]);
    };
    let is_of_pass = |file: &export::ExportFile| {
        file.name != own && file.name.ends_with(ending) && !file.name.contains(".prepare.")
    };
    let more = if exported.iter().any(is_of_pass) {
        ". It reads what other passes draw: Export writes those too"
    } else {
        ""
    };
    Ok(LookExportResult::Copied(text, format!("{name} is in the clipboard{more}")))
}

/// Message of the first problem, with its node and port, and its hints.
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
