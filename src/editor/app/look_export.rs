//! Export of the look as shaders or as a package, for every language and package that `chiaro
//! export` writes, by the same code. Compiling for seven languages takes a moment, so a thread does
//! it and no hand waits. Nodes whose tier no export carries are exported in the nearest that one
//! does, which is told.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::{tr, trn};

use crate::diag::Diagnostic;
use crate::document::Look;
use crate::export::package::{Package, PackageScene, draw_expected, export_package, package};
use crate::export::{self, ExportFile, ExportOptions, Language};
use crate::files::Outputs;
use crate::frame::{Assets, Executor};
use crate::library::Library;
use crate::progress::Progress;
use crate::render::Gpu;
use crate::state::session::Session;
use crate::state::snapshot::RenderSnapshot;
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
    snapshot: RenderSnapshot,
    stem: String,
    /// File of the look, which nothing may write over.
    path: Option<PathBuf>,
    /// Slug of a language or a package, or [`export::ALL`].
    target: &'static str,
    to: Destination,
    options: ExportOptions,
}

/// Result of an export.
#[derive(Debug, PartialEq)]
pub(crate) enum LookExportResult {
    /// A message.
    Told(String),
    /// Text to copy, and a message.
    Copied(String, String),
    /// A package's page to open, and a message.
    Opened(PathBuf, String),
}

/// The exporting thread, and the folder of the last export.
pub(crate) struct LookExports {
    worker: Worker<Vec<LookExportRequest>, Vec<LookExportResult>>,
    folder: Option<PathBuf>,
}

impl LookExports {
    /// Starts the thread. `wake` is called from another thread when an export is done. Without a
    /// `gpu` packages have no picture of what they are expected to show.
    pub(crate) fn new(gpu: Option<Gpu>, wake: impl Fn() + Send + 'static) -> Self {
        let mut executor = gpu.map(|gpu| gpu.executor());
        let work = async move |jobs: Vec<LookExportRequest>| {
            let mut all = Vec::new();
            for job in jobs {
                all.push(run(job, executor.as_mut()).await);
            }
            all
        };
        Self { worker: Worker::waiting("export look", wake, work), folder: None }
    }

    /// Writes the open look, as it is now, in a language (or [`export::ALL`]) or as a package
    /// into a folder.
    pub(crate) fn write(
        &mut self,
        session: &Session,
        language: &'static str,
        folder: PathBuf,
        options: ExportOptions,
    ) {
        self.folder = Some(folder.clone());
        self.add(job(session, language, Destination::Folder(folder), options));
    }

    /// Copies the open look, as it is now, in a language: the one of its files with this ending.
    pub(crate) fn copy(&self, session: &Session, language: &'static str, ending: &'static str) {
        let options = ExportOptions { takes_carried_tiers: true, ..ExportOptions::default() };
        self.add(job(session, language, Destination::Clipboard(ending), options));
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

fn job(
    session: &Session,
    target: &'static str,
    to: Destination,
    options: ExportOptions,
) -> LookExportRequest {
    LookExportRequest {
        options,
        snapshot: session.snapshot_of(Arc::new(session.look().clone())).alone(),
        stem: stem(session),
        path: session.path().map(Path::to_path_buf),
        target,
        to,
    }
}

async fn run(
    job: LookExportRequest,
    executor: Option<&mut Box<dyn Executor + Send>>,
) -> LookExportResult {
    let done = match package(job.target) {
        Some(package) => write_package(&job, package, executor).await,
        None => write_languages(&job),
    };
    done.unwrap_or_else(|problems| LookExportResult::Told(told(&problems)))
}

/// The look and its library as the choices of the export have them, and what that changed.
fn prepared(
    job: &LookExportRequest,
    is_package: bool,
) -> Result<(Look, Library, String), Vec<Diagnostic>> {
    let (mut look, mut library) = ((*job.snapshot.look).clone(), (*job.snapshot.library).clone());
    let told = match &job.options.apply(&mut look, &mut library, is_package)?[..] {
        [] => String::new(),
        [one] => format!(" · {}", one.message),
        [first, rest @ ..] => {
            tr!(" · {first}; and {more} more", first = first.message, more = rest.len())
        }
    };
    Ok((look, library, told))
}

fn write_languages(job: &LookExportRequest) -> Result<LookExportResult, Vec<Diagnostic>> {
    let languages = export::languages([job.target])?;
    let (look, library, changed) = prepared(job, false)?;
    let mut assets = Assets::of(&job.snapshot.assets);
    let place = (job.snapshot.folder.as_path(), &mut assets);
    let exported = export::export(&look, &library, &job.stem, &languages, place)?;
    match &job.to {
        Destination::Folder(folder) => {
            let (told, _) = write(&exported.value, folder, job)?;
            Ok(LookExportResult::Told(told + &unverified(&languages) + &changed))
        }
        Destination::Clipboard(ending) => copy(&exported.value, ending, job),
    }
}

/// Note on languages whose files no compiler has seen; empty where there are none.
fn unverified(languages: &[&Language]) -> String {
    let unseen = languages.iter().filter(|language| language.verified_by.is_none());
    let labels: Vec<String> = unseen.map(|language| language.label.to_owned()).collect();
    let count = labels.len();
    let Some(names) = labels.into_iter().reduce(|parts, last| tr!("{parts} and {last}")) else {
        return String::new();
    };
    trn!(
        count,
        " · {names} is unverified: no compiler here has seen the files",
        " · {names} are unverified: no compiler here has seen the files"
    )
}

async fn write_package(
    job: &LookExportRequest,
    package: &Package,
    executor: Option<&mut Box<dyn Executor + Send>>,
) -> Result<LookExportResult, Vec<Diagnostic>> {
    let Destination::Folder(folder) = &job.to else {
        return Ok(LookExportResult::Told(tr!("a package is a folder").to_owned()));
    };
    let (look, library, changed) = prepared(job, true)?;
    let mut assets = Assets::default();
    let mut setup = job.snapshot.setup(&mut assets)?.value;
    setup.looks[0].look = look;
    let scene = PackageScene::of(&setup).ok_or_else(|| {
        vec![Diagnostic::error("empty-scene", tr!("there is no mesh to show the look on"))]
    })?;
    let place = (job.snapshot.folder.as_path(), &mut assets);
    let look = &setup.looks[0].look;
    let mut files = export_package(look, &library, &job.stem, package, &scene, place)?.value;
    if let Some(executor) = executor {
        let progress = Progress::new();
        files.push(draw_expected(&setup, &library, assets, &mut **executor, &progress).await?);
    }
    let (told, folder) = write(&files, folder, job)?;
    let told = told + &changed;
    Ok(match package.opens {
        Some(page) => LookExportResult::Opened(folder.join(page), told),
        None => LookExportResult::Told(told),
    })
}

/// Writes the files of an export. Where they would replace a document they go into a folder of
/// their own, and are not refused: to choose the look's own folder, where dialogs begin, is no
/// mistake.
fn write(
    exported: &[ExportFile],
    folder: &Path,
    job: &LookExportRequest,
) -> Result<(String, PathBuf), Vec<Diagnostic>> {
    let mut outputs = Outputs::new(false);
    job.path.iter().for_each(|path| outputs.reads(path));
    let is_free = export::in_the_way(exported, folder, &outputs).is_none();
    let folder = if is_free { folder.to_owned() } else { folder.join(own_folder(&job.stem)) };
    let written = export::write(exported, &folder, &mut outputs)?;
    let told = trn!(
        count = written.len(),
        "Exported {count} file to {folder}",
        "Exported {count} files to {folder}",
        folder = folder.display()
    );
    Ok((told, folder))
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
            Diagnostic::error("no-text", tr!("this language is no text to copy"))
                .hint(tr!("Export writes it to a file")),
        ]);
    };
    let is_of_pass = |file: &export::ExportFile| {
        file.name != own && file.name.ends_with(ending) && !file.name.contains(".prepare.")
    };
    let told = match exported.iter().any(is_of_pass) {
        true => tr!(
            "{name} is in the clipboard. It reads what other passes draw: Export writes those too"
        ),
        false => tr!("{name} is in the clipboard"),
    };
    Ok(LookExportResult::Copied(text, told))
}

/// Address of a file for a browser, every odd byte of its path as `%XX`.
pub(crate) fn address_of(file: &Path) -> String {
    let path = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
    let path = path.to_string_lossy().replace('\\', "/");
    let mut address = "file://".to_owned();
    if !path.starts_with('/') {
        address.push('/');
    }
    for byte in path.bytes() {
        if byte.is_ascii_alphanumeric() || b"/-_.~:".contains(&byte) {
            address.push(char::from(byte));
        } else {
            address += &format!("%{byte:02X}");
        }
    }
    address
}

/// Message of the first problem, with its node and port, and its hints.
fn told(problems: &[Diagnostic]) -> String {
    let Some(first) = problems.iter().find(|problem| problem.is_error()).or(problems.first())
    else {
        return tr!("Nothing was exported").to_owned();
    };
    let place = match (&first.place.node, &first.place.port) {
        (Some(node), Some(port)) => tr!(" (node {node}, input {port})"),
        (Some(node), None) => tr!(" (node {node})"),
        _ => first.place.file.as_ref().map(|file| format!(" ({file})")).unwrap_or_default(),
    };
    let hints: String = first.hints.iter().map(|hint| format!("; {hint}")).collect();
    let more = match problems.len() {
        0 | 1 => String::new(),
        count => tr!("; and {more} more, which Problems lists", more = count - 1),
    };
    tr!("Not exported: {what}{place}{hints}{more}", what = first.message)
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
    fn files_have_addresses() {
        assert_eq!(address_of(Path::new("/a b/ü.html")), "file:///a%20b/%C3%BC.html");
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
