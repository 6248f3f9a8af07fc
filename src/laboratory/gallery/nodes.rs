//! Pictures of nodes, for their documentation: the node as the canvas draws it, and what it gives on a sphere.

use std::path::Path;

use super::sample;
use crate::accuracy::Progress;
use crate::catalog::{CUSTOM_KIND, Catalog};
use crate::diag::Diagnostic;
use crate::document::write_atomic;
use crate::drawing::node_svg;
use crate::frame::Picture;
use crate::library::Library;
use crate::render::{Gpu, Renderer};

/// Pixels of a side.
pub const SIDE: u32 = 144;

/// What is drawn of a kind of node.
#[derive(Debug)]
pub struct NodePictures {
    /// The kind.
    pub kind: String,
    /// The node, unwired.
    pub svg: String,
    /// What it gives on a sphere; `None` where nothing could be seen of it.
    pub picture: Option<Picture>,
}

/// Draws every kind of a library and hands it to `done`, in the library's order.
///
/// # Errors
/// What cannot be drawn, what `done` says, or that `progress` stopped it.
pub fn draw_nodes(
    library: &Library,
    gpu: &Gpu,
    progress: &mut Progress<'_>,
    done: &mut dyn FnMut(NodePictures) -> Result<(), Diagnostic>,
) -> Result<(), Vec<Diagnostic>> {
    let catalog = Catalog::new(library);
    let one = |problem: Diagnostic| vec![problem];
    let told = |error: std::io::Error| one(Diagnostic::error("no-room", format!("no folder for samples: {error}")));
    let folder = tempfile::tempdir().map_err(told)?;
    sample::write_assets(folder.path()).map_err(one)?;
    let kinds: Vec<_> = catalog.all().filter(|kind| kind.id != CUSTOM_KIND).collect();
    progress.expect(kinds.len() as u64);
    for kind in kinds {
        let mut renderer = Renderer::new(gpu.clone());
        let picture = sample::picture(kind, &catalog, library, &mut renderer, (folder.path(), SIDE))?;
        done(NodePictures { kind: kind.id.clone(), svg: node_svg(&kind.id, &catalog), picture }).map_err(one)?;
        progress.step()?;
    }
    Ok(())
}

/// Writes `KIND.svg` and `KIND.png` of every kind into `folder`, which is made where there is none.
///
/// # Errors
/// As [`draw_nodes`], and where nothing can be written.
pub fn write_nodes(
    library: &Library,
    folder: &Path,
    gpu: &Gpu,
    progress: &mut Progress<'_>,
) -> Result<(), Vec<Diagnostic>> {
    std::fs::create_dir_all(folder).map_err(|error| {
        let problem = Diagnostic::error("cannot-write", format!("the folder cannot be made: {error}"));
        vec![problem.in_file(folder.display().to_string())]
    })?;
    let write = |name: String, bytes: &[u8]| write_atomic(&folder.join(name), bytes).map_err(|problem| *problem);
    draw_nodes(library, gpu, progress, &mut |node| {
        write(format!("{}.svg", node.kind), node.svg.as_bytes())?;
        match &node.picture {
            Some(picture) => write(format!("{}.png", node.kind), &picture.to_png()?),
            None => Ok(()),
        }
    })
}
