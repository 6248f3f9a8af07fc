//! Looks and scenes as a web page: pictures, graphs, shaders, and what they cost.
//!
//! [`list`] says what is shown, [`build`] draws and measures one document after the other and writes its page at once, so
//! that a gallery of any length takes the memory of one picture. The pages are plain files: no scripts, nothing from
//! elsewhere, dark or light as the reader's screen is.

mod entry;
pub mod list;
pub mod nodes;
mod page;
mod sample;

use std::collections::HashSet;
use std::path::Path;

use crate::accuracy::Progress;
use crate::catalog::Catalog;
use crate::diag::Diagnostic;
use crate::document::write_atomic;
use crate::files::{self, ReadError};
use crate::ids::make_slug;
use crate::library::Library;
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
    /// Where the nodes' documentation lies from the pages, such as `../nodes.md`; nothing is linked without it.
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

/// Writes a gallery into `folder`, which is made where there is none. `library_for` finds the nodes that a document may
/// use. A document that cannot be shown is left out and told of.
///
/// # Errors
/// Where nothing can be written there, or a page of somebody else lies in the way, or `progress` stopped it: the pages
/// that are done stay.
pub fn build(
    list: &List,
    folder: &Path,
    gpu: &Gpu,
    library_for: &dyn Fn(&Path) -> Library,
    options: &Options,
    progress: &mut Progress<'_>,
) -> Result<Made, Vec<Diagnostic>> {
    check_folder(folder)?;
    let write = |name: &str, bytes: &[u8]| write_atomic(&folder.join(name), bytes).map_err(|problem| vec![*problem]);
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
                    write(&format!("{slug}.png"), &entry.png)?;
                    for (place, look) in entry.looks.iter().enumerate() {
                        catalog.sync(look, &library);
                        write(&page::graph_file(slug, place), page::graph(look, &catalog).as_bytes())?;
                    }
                    write(&format!("{slug}.html"), page::entry(&entry, slug, list, options).as_bytes())?;
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
        write("style.css", page::STYLE.as_bytes())?;
        write("index.html", index.finish().as_bytes())?;
    }
    Ok(made)
}

/// A page's name for each document in order, each used once: `index` and the like are taken by the gallery itself.
fn slugs(list: &List) -> Vec<String> {
    let mut taken: HashSet<String> = HashSet::from(["index".to_owned(), "style".to_owned()]);
    let all = list.sections.iter().flat_map(|section| &section.shown);
    let slug = |shown: &Shown| {
        let stem = shown.file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let slug = make_slug(&stem, |slug| taken.contains(slug));
        taken.insert(slug.clone());
        slug.replace('_', "-")
    };
    all.map(slug).collect()
}

/// Makes the folder, and refuses one whose page is not a gallery of ours.
fn check_folder(folder: &Path) -> Result<(), Vec<Diagnostic>> {
    let at = |problem: Diagnostic| vec![problem.in_file(folder.display().to_string())];
    std::fs::create_dir_all(folder)
        .map_err(|error| at(Diagnostic::error("cannot-write", format!("the folder cannot be made: {error}"))))?;
    let page = folder.join("index.html");
    match files::read(&page, MAX_PAGE_BYTES) {
        Err(ReadError::Io(_)) => Ok(()),
        Ok(bytes) if String::from_utf8_lossy(&bytes).contains(GENERATOR) => Ok(()),
        // Also what is too large to be a page of ours, or no file at all.
        _ => {
            let problem = Diagnostic::error("in-the-way", "its index.html is not a gallery of Chiaro");
            Err(at(problem.hint("choose an empty folder with -o")))
        }
    }
}
