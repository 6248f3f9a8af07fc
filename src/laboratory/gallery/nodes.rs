//! Pictures of nodes, for their documentation: the node as the canvas draws it, and its output on a
//! sphere.

use std::path::{Path, PathBuf};

use super::{MAX_PAGE_BYTES, sample};
use crate::catalog::{CUSTOM_KIND, Catalog};
use crate::diag::Diagnostic;
use crate::drawing::node_svg;
use crate::files::{self, OutputKind, Outputs, make_folder};
use crate::frame::Picture;
use crate::library::Library;
use crate::progress::Progress;
use crate::render::Gpu;

/// Side of a picture, in pixels.
pub const SIDE: u32 = 144;

/// Pictures of one kind of node.
#[derive(Debug)]
pub struct NodePictures {
    /// The kind.
    pub kind: String,
    /// Drawing of the unwired node, as SVG.
    pub svg: String,
    /// The node's output on a sphere; `None` if nothing of it can be seen.
    pub picture: Option<Picture>,
}

/// Draws every kind of a library and passes its pictures to `done`, in the library's order.
///
/// # Errors
/// Kinds that cannot be drawn, errors of `done`, or `stopped` if `progress` was stopped.
pub async fn draw_nodes(
    library: &Library,
    gpu: &Gpu,
    progress: &Progress,
    done: &mut dyn FnMut(NodePictures) -> Result<(), Diagnostic>,
) -> Result<(), Vec<Diagnostic>> {
    let catalog = Catalog::new(library);
    let one = |problem: Diagnostic| vec![problem];
    let told = |error: std::io::Error| {
        one(Diagnostic::error("no-room", format!("no folder for samples: {error}")))
    };
    let folder = tempfile::tempdir().map_err(told)?;
    sample::write_assets(folder.path()).map_err(one)?;
    let kinds: Vec<_> = catalog.all().filter(|kind| kind.id != CUSTOM_KIND).collect();
    progress.expect(kinds.len() as u64);
    for kind in kinds {
        let mut executor = gpu.with_own_store().executor();
        let picture =
            sample::picture(kind, &catalog, library, &mut *executor, (folder.path(), SIDE)).await?;
        done(NodePictures { kind: kind.id.clone(), svg: node_svg(&kind.id, &catalog), picture })
            .map_err(one)?;
        progress.step()?;
    }
    Ok(())
}

/// Checks that pictures of every kind may be written into `folder`, before they are drawn.
///
/// # Errors
/// As [`Outputs::check`].
pub fn check_nodes(library: &Library, folder: &Path, outputs: &Outputs) -> Result<(), Diagnostic> {
    let catalog = Catalog::new(library);
    catalog.all().filter(|kind| kind.id != CUSTOM_KIND).try_for_each(|kind| {
        let [svg, png] = files_of(folder, &kind.id);
        outputs.check(&svg, OutputKind::DRAWING)?;
        outputs.check(
            &png,
            OutputKind { is_own: &|bytes| is_picture(bytes, &svg), ..OutputKind::PICTURE },
        )
    })
}

/// Writes `KIND.svg` and `KIND.png` of every kind into `folder`, which is created if there is none;
/// the two files of a kind together.
///
/// # Errors
/// As [`draw_nodes`], files that cannot be written, and files of others in the way.
pub async fn write_nodes(
    library: &Library,
    folder: &Path,
    gpu: &Gpu,
    outputs: &mut Outputs,
    progress: &Progress,
) -> Result<(), Vec<Diagnostic>> {
    make_folder(folder).map_err(|problem| vec![*problem])?;
    draw_nodes(library, gpu, progress, &mut |node| {
        let [svg, png] = files_of(folder, &node.kind);
        if let Some(picture) = &node.picture {
            let kind =
                OutputKind { is_own: &|bytes| is_picture(bytes, &svg), ..OutputKind::PICTURE };
            outputs.add(&png, kind, &picture.to_png()?)?;
        }
        outputs.add(&svg, OutputKind::DRAWING, node.svg.as_bytes())?;
        outputs.commit()
    })
    .await
}

/// Paths of a kind's drawing and picture.
fn files_of(folder: &Path, kind: &str) -> [PathBuf; 2] {
    ["svg", "png"].map(|ending| folder.join(format!("{kind}.{ending}")))
}

/// True if a picture is ours: its own metadata tells, or our drawing of the same kind lies beside
/// it.
fn is_picture(bytes: &[u8], drawing: &Path) -> bool {
    let is_drawing =
        || files::read(drawing, MAX_PAGE_BYTES).is_ok_and(|svg| (OutputKind::DRAWING.is_own)(&svg));
    (OutputKind::PICTURE.is_own)(bytes) || is_drawing()
}
