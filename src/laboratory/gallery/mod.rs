//! Galleries: looks and scenes as web pages with pictures, graphs, shaders, and costs.
//!
//! [`list`] finds the documents, [`build`] draws and measures one document after the other and
//! writes its page at once, so that a gallery of any length takes the memory of one picture. The
//! pages are plain files: no scripts, nothing loaded from elsewhere, dark or light as the reader's
//! screen is.

mod entry;
pub mod list;
pub mod nodes;
mod page;
mod sample;

use std::collections::HashSet;
use std::path::Path;

use crate::catalog::Catalog;
use crate::diag::Diagnostic;
use crate::files::{self, ReadError};
use crate::files::{OutputKind, Outputs};
use crate::frame::Assets;
use crate::ids::make_slug;
use crate::library::Library;
use crate::progress::Progress;
use crate::render::Gpu;
use entry::GalleryEntry;
pub use list::{GalleryDocument, List, Section};

/// Size that pages of a gallery stay below, in bytes.
const MAX_PAGE_BYTES: u64 = 64 << 20;

/// Options of a gallery.
#[derive(Clone, Debug, PartialEq)]
pub struct GalleryOptions {
    /// Width and height of a picture, in pixels.
    pub size: [u32; 2],
    /// Samples a pixel: 1 or 4.
    pub samples: u32,
    /// Number of times each tier is drawn to measure its time; 0 measures neither times nor errors.
    pub rounds: usize,
    /// A mesh or an own shape in place of each document's own.
    pub mesh: Option<String>,
    /// Path of the nodes' documentation from the pages, such as `../nodes.md`; nothing is linked if
    /// `None`.
    pub nodes: Option<String>,
}

/// Result of building a gallery.
#[derive(Debug, Default)]
pub struct GalleryReport {
    /// Number of documents that have a page.
    pub pages: usize,
    /// Problems of the documents without a page, and warnings.
    pub problems: Vec<Diagnostic>,
}

/// Tag that names the program as a page's maker, by which our own pages are recognized.
const GENERATOR: &str = "<meta name=\"generator\" content=\"Chiaro\">";

/// Pages, as a kind of output file.
const PAGE: OutputKind<'static> =
    OutputKind { name: "a page of a gallery", is_own: &is_page, has_seal: false };

fn is_page(bytes: &[u8]) -> bool {
    String::from_utf8_lossy(bytes).contains(GENERATOR)
}

/// Writes a gallery into `folder`, which is created if there is none. `library_for` finds the nodes
/// that a document may use. A document that cannot be drawn is left out and reported. A page comes
/// with its pictures, all at once.
///
/// # Errors
/// A folder that cannot be written, a file of somebody else in the way, or `stopped` if `progress`
/// was stopped: the finished pages stay.
pub async fn build(
    list: &List,
    folder: &Path,
    outputs: &mut Outputs,
    gpu: &Gpu,
    library_for: &dyn Fn(&Path) -> Library,
    options: &GalleryOptions,
    progress: &Progress,
) -> Result<GalleryReport, Vec<Diagnostic>> {
    check(list, folder, outputs)?;
    files::make_folder(folder).map_err(|problem| vec![*problem])?;
    let one = |problem| vec![problem];
    let mut made = GalleryReport::default();
    let mut index = page::Index::new(list);
    let slugs = slugs(list);
    let mut order = slugs.iter().map(String::as_str);
    progress.expect(slugs.len() as u64);
    for section in &list.sections {
        index.section(section);
        for shown in &section.shown {
            let slug = order.next().unwrap_or_default();
            let library = library_for(&shown.file);
            made.problems.extend(library.problems.iter().cloned());
            // Each document has a store of its own; a shared one would keep the pipelines and
            // textures of all documents.
            match GalleryEntry::make(shown, &library, &gpu.with_own_store(), options).await {
                Ok(entry) => {
                    let entry = entry.tell(&mut made.problems);
                    let mut catalog = Catalog::new(&library);
                    let page = folder.join(format!("{slug}.html"));
                    let is_picture = |bytes: &[u8]| is_picture(bytes, &page);
                    let picture = OutputKind { is_own: &is_picture, ..OutputKind::PICTURE };
                    outputs
                        .add(&folder.join(format!("{slug}.png")), picture, &entry.png)
                        .map_err(one)?;
                    for (place, look) in entry.looks.iter().enumerate() {
                        catalog.sync(look, &library);
                        let (file, graph) =
                            (page::graph_file(slug, place), page::graph(look, &catalog));
                        outputs
                            .add(&folder.join(file), OutputKind::DRAWING, graph.as_bytes())
                            .map_err(one)?;
                    }
                    let html = page::entry(&entry, slug, list, options);
                    outputs.add(&page, PAGE, html.as_bytes()).map_err(one)?;
                    outputs.commit().map_err(one)?;
                    index.entry(&entry, slug);
                    made.pages += 1;
                }
                Err(problems) => {
                    let file = shown.file.display().to_string();
                    let place = |problem: Diagnostic| match problem.place.file {
                        Some(_) => problem,
                        None => problem.in_file(&file),
                    };
                    made.problems.extend(problems.into_iter().map(place));
                }
            }
            progress.step()?;
        }
    }
    if made.pages > 0 {
        let index_page = folder.join("index.html");
        let is_style = |bytes: &[u8]| is_style(bytes, &index_page);
        let style =
            OutputKind { name: "the style of a gallery", is_own: &is_style, has_seal: false };
        outputs.add(&folder.join("style.css"), style, page::STYLE.as_bytes()).map_err(one)?;
        outputs.add(&index_page, PAGE, index.finish().as_bytes()).map_err(one)?;
        outputs.commit().map_err(one)?;
    }
    Ok(made)
}

/// Passes to `sink` everything that decides on a document's page, except times, errors and the code
/// that draws and writes; a caller can keep pages by a hash of these bytes. Reads with `assets`,
/// which may be [drafts](Assets::draft) if the caller tracks the files of HCBTFs in another way.
///
/// # Errors
/// Problems of the document.
pub fn content(
    shown: &GalleryDocument,
    library: &Library,
    options: &GalleryOptions,
    assets: &mut Assets,
    sink: &mut dyn FnMut(&[u8]),
) -> Result<(), Vec<Diagnostic>> {
    entry::content(shown, library, options, assets, sink)
}

/// Unique page names, one for each document in order: `index` and `style` are taken by the gallery
/// itself.
fn slugs(list: &List) -> Vec<String> {
    let mut taken: HashSet<String> = HashSet::from(["index".to_owned(), "style".to_owned()]);
    let all = list.sections.iter().flat_map(|section| &section.shown);
    let slug = |shown: &GalleryDocument| {
        let stem = shown
            .file
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned())
            .unwrap_or_default();
        let slug = make_slug(&stem, |slug| taken.contains(slug));
        taken.insert(slug.clone());
        slug.replace('_', "-")
    };
    all.map(slug).collect()
}

/// Checks that a gallery may be written into a folder, before anything is drawn. A page that is not
/// ours marks the folder as not ours.
///
/// # Errors
/// As [`Outputs::check`], and an `index.html` of somebody else.
pub fn check(list: &List, folder: &Path, outputs: &Outputs) -> Result<(), Vec<Diagnostic>> {
    let one = |problem| vec![problem];
    let index = folder.join("index.html");
    let is_others = match files::read(&index, MAX_PAGE_BYTES) {
        Err(ReadError::Io(_)) => false,
        Ok(bytes) => !is_page(&bytes),
        // The file is too large to be a page of ours, or is no file at all.
        Err(_) => true,
    };
    if is_others {
        let problem = Diagnostic::error("in-the-way", "its index.html is not a gallery of Chiaro");
        return Err(vec![
            problem.in_file(folder.display().to_string()).hint("choose an empty folder with -o"),
        ]);
    }
    outputs.check(&index, PAGE).map_err(one)?;
    let is_style = |bytes: &[u8]| is_style(bytes, &index);
    let style = OutputKind { name: "the style of a gallery", is_own: &is_style, has_seal: false };
    outputs.check(&folder.join("style.css"), style).map_err(one)?;
    for slug in slugs(list) {
        let page = folder.join(format!("{slug}.html"));
        let is_picture = |bytes: &[u8]| is_picture(bytes, &page);
        let picture = OutputKind { is_own: &is_picture, ..OutputKind::PICTURE };
        outputs.check(&page, PAGE).map_err(one)?;
        outputs.check(&folder.join(format!("{slug}.png")), picture).map_err(one)?;
        outputs
            .check(&folder.join(page::graph_file(&slug, 0)), OutputKind::DRAWING)
            .map_err(one)?;
    }
    Ok(())
}

/// True if a picture is ours: its own metadata tells, or a page of ours shows it.
fn is_picture(bytes: &[u8], page: &Path) -> bool {
    let is_shown = || files::read(page, MAX_PAGE_BYTES).is_ok_and(|page| is_page(&page));
    (OutputKind::PICTURE.is_own)(bytes) || is_shown()
}

/// True if a stylesheet is ours: equal to ours, or beside a page of ours.
fn is_style(bytes: &[u8], index: &Path) -> bool {
    bytes == page::STYLE.as_bytes()
        || files::read(index, MAX_PAGE_BYTES).is_ok_and(|page| is_page(&page))
}
