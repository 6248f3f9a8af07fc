//! Looks and scenes as a web page: pictures, graphs, shaders, and what they cost.
//!
//! [`list`] says what is shown, [`build`] draws and measures one document after the other and
//! writes its page at once, so that a gallery of any length takes the memory of one picture. The
//! pages are plain files: no scripts, nothing from elsewhere, dark or light as the reader's screen
//! is.

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
use crate::render::{Gpu, Renderer};
use entry::Entry;
pub use list::{List, Section, Shown};

/// A page of a gallery is smaller, in bytes.
const MAX_PAGE_BYTES: u64 = 64 << 20;

/// How a gallery is made.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Pixels of a picture.
    pub size: [u32; 2],
    /// Samples a pixel: 1 or 4.
    pub samples: u32,
    /// How often each tier is drawn to measure its time; 0 measures neither times nor errors.
    pub rounds: usize,
    /// A mesh or an own shape in place of each document's own.
    pub mesh: Option<String>,
    /// Where the nodes' documentation lies from the pages, such as `../nodes.md`; nothing is linked
    /// without it.
    pub nodes: Option<String>,
}

/// What was made of a gallery.
#[derive(Debug, Default)]
pub struct Made {
    /// How many documents have a page.
    pub pages: usize,
    /// What was wrong with the others, and what is odd.
    pub problems: Vec<Diagnostic>,
}

/// What a page says of its maker, by which it is known again.
const GENERATOR: &str = "<meta name=\"generator\" content=\"Chiaro\">";

/// A page.
const PAGE: OutputKind<'static> =
    OutputKind { name: "a page of a gallery", is_own: &is_page, has_seal: false };

fn is_page(bytes: &[u8]) -> bool {
    String::from_utf8_lossy(bytes).contains(GENERATOR)
}

/// Writes a gallery into `folder`, which is made where there is none. `library_for` finds the nodes
/// that a document may use. A document that cannot be shown is left out and told of. A page comes
/// with its pictures, all at once.
///
/// # Errors
/// Where nothing can be written there, or a file of somebody else lies in the way, or `progress`
/// stopped it: the pages that are done stay.
pub fn build(
    list: &List,
    folder: &Path,
    outputs: &mut Outputs,
    gpu: &Gpu,
    library_for: &dyn Fn(&Path) -> Library,
    options: &Options,
    progress: &Progress,
) -> Result<Made, Vec<Diagnostic>> {
    check(list, folder, outputs)?;
    make_folder(folder)?;
    let one = |problem| vec![problem];
    let mut made = Made::default();
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
            // A renderer of its own, or the pipelines and textures of all would be kept.
            let mut renderer = Renderer::new(gpu.clone());
            match Entry::make(shown, &library, &mut renderer, options) {
                Ok((entry, warnings)) => {
                    made.problems.extend(warnings);
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

/// Hands over everything that decides on a document's page, but for times and errors and for the
/// code that draws and writes: for those who keep what was shown by a hash of it. Reads with
/// `assets`, which may be [drafts](Assets::draft) where the files of HCBTFs are kept account of
/// otherwise.
///
/// # Errors
/// What is wrong with the document.
pub fn content(
    shown: &Shown,
    library: &Library,
    options: &Options,
    assets: &mut Assets,
    sink: &mut dyn FnMut(&[u8]),
) -> Result<(), Vec<Diagnostic>> {
    entry::content(shown, library, options, assets, sink)
}

/// A page's name for each document in order, each used once: `index` and the like are taken by the
/// gallery itself.
fn slugs(list: &List) -> Vec<String> {
    let mut taken: HashSet<String> = HashSet::from(["index".to_owned(), "style".to_owned()]);
    let all = list.sections.iter().flat_map(|section| &section.shown);
    let slug = |shown: &Shown| {
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

fn make_folder(folder: &Path) -> Result<(), Vec<Diagnostic>> {
    std::fs::create_dir_all(folder).map_err(|error| {
        let problem =
            Diagnostic::error("cannot-write", format!("the folder cannot be made: {error}"));
        vec![problem.in_file(folder.display().to_string())]
    })
}

/// Whether a gallery may be written into a folder, asked before anything is drawn. A page that is
/// not ours stands for a folder that is not.
///
/// # Errors
/// As [`Outputs::check`], and where `index.html` is somebody else's.
pub fn check(list: &List, folder: &Path, outputs: &Outputs) -> Result<(), Vec<Diagnostic>> {
    let one = |problem| vec![problem];
    let index = folder.join("index.html");
    let is_others = match files::read(&index, MAX_PAGE_BYTES) {
        Err(ReadError::Io(_)) => false,
        Ok(bytes) => !is_page(&bytes),
        // What is too large to be a page of ours, or no file at all.
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

/// Whether a picture is ours: it says so itself, or a page of ours shows it.
fn is_picture(bytes: &[u8], page: &Path) -> bool {
    let is_shown = || files::read(page, MAX_PAGE_BYTES).is_ok_and(|page| is_page(&page));
    (OutputKind::PICTURE.is_own)(bytes) || is_shown()
}

/// Whether a style is ours: it is as we write it, or lies beside a page of ours.
fn is_style(bytes: &[u8], index: &Path) -> bool {
    bytes == page::STYLE.as_bytes()
        || files::read(index, MAX_PAGE_BYTES).is_ok_and(|page| is_page(&page))
}
