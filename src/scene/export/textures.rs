//! Images and HCBTFs that an exported look reads, carried along with it.

use std::collections::HashSet;
use std::path::Path;

use chiaro_locale::tr;

use super::ExportFile;
use super::modules::ExportImage;
use crate::compile::ImageShape;
use crate::diag::{Diagnostic, WithWarnings};
use crate::frame::{Assets, MESH_PREFIX, image_bytes};
use crate::geometry::WITHIN;
use crate::hcbtf::{LayerOptions, LayeredTexture, ktx2};
use crate::photometry::is_lamp_file;

/// Reads every image, relative to `folder`, names the file that carries it, and returns those files
/// with warnings about images that could not be read. An image is carried unchanged; an HCBTF as
/// the texture that the shader looks up.
pub(super) fn carried(
    images: &mut [ExportImage],
    stem: &str,
    folder: &Path,
    assets: &mut Assets,
) -> WithWarnings<Vec<ExportFile>> {
    let mut files: Vec<ExportFile> = Vec::new();
    let mut problems = Vec::new();
    let mut taken = HashSet::new();
    for image in images.iter_mut().filter(|image| !image.path.is_empty()) {
        let (bytes, ending) = match image.used.shape {
            ImageShape::Flat => {
                let bytes = match image.path.starts_with(MESH_PREFIX) {
                    true => Err(of_mesh(&image.path)),
                    false => image_bytes(&**assets.source(), folder, &image.path),
                };
                let ending = ending(&image.path, bytes.as_deref().unwrap_or_default());
                (bytes.map_err(|problem| vec![problem]), ending)
            }
            ImageShape::Hcbtf { has_levels, storage } => {
                let options =
                    LayerOptions { has_levels, is_decoded: image.used.is_decoded, storage };
                let baked = assets.hcbtf(folder, &image.path, options).map(|warned| {
                    let image = warned.value;
                    let (coding, bytes) = (image.coding, image.bytes.clone());
                    let layers =
                        LayeredTexture { size: image.size, count: image.layers, coding, bytes };
                    ktx2::write(&layers)
                });
                (baked, "ktx2".to_owned())
            }
        };
        match bytes {
            // A file that is sampled in two ways is carried once.
            Ok(bytes) => {
                let known =
                    files.iter().find(|file| file.bytes == bytes).map(|file| file.name.clone());
                image.file = known.or_else(|| {
                    let name = name(stem, &image.path, &ending, &mut taken);
                    files.push(ExportFile { name: name.clone(), bytes });
                    Some(name)
                });
            }
            Err(found) => problems.extend(found.iter().map(|problem| left_out(problem, image))),
        }
    }
    WithWarnings::new(files, problems)
}

/// Ending of an image's file: its own, or, of a picture within a mesh's file or of a lamp's file,
/// that of its format.
fn ending(path: &str, bytes: &[u8]) -> String {
    if path.contains(WITHIN) || is_lamp_file(Path::new(path)) {
        return if bytes.starts_with(b"\xff\xd8") { "jpg" } else { "png" }.to_owned();
    }
    let own = Path::new(path).extension();
    own.map_or("png".to_owned(), |it| it.to_string_lossy().into())
}

/// The problem of a map of the mesh's own materials, which an exported look has no mesh for.
fn of_mesh(path: &str) -> Diagnostic {
    let name = path.trim_start_matches(MESH_PREFIX);
    let message = tr!("each mesh has its own picture for `{name}`, and an exported look none");
    Diagnostic::error("missing-asset", message)
}

/// A name that no other file of the export has: the look's name, then the image's own.
fn name(stem: &str, path: &str, ending: &str, taken: &mut HashSet<String>) -> String {
    let own = Path::new(path).file_stem().map_or("image".into(), |own| own.to_string_lossy());
    // A module's file may be called `stem.word.ending` too, but never with an image's ending.
    let named = |number: u32| match number {
        1 => format!("{stem}.{own}.{ending}"),
        _ => format!("{stem}.{own}-{number}.{ending}"),
    };
    let free = (1..).map(named).find(|name| !taken.contains(&name.to_lowercase()));
    let name = free.unwrap_or_else(|| format!("{stem}.{ending}"));
    taken.insert(name.to_lowercase());
    name
}

fn left_out(problem: &Diagnostic, image: &ExportImage) -> Diagnostic {
    let message = tr!(
        "`{image}` is not carried along: {reason}",
        image = image.path,
        reason = problem.message
    );
    let problem = Diagnostic::warning("not-carried", message).node(image.used.node.clone());
    problem.hint(if image.path.starts_with(MESH_PREFIX) {
        tr!("the shader is whole; choose a file, such as `hero.glb#images/0`, and export again")
    } else {
        tr!("the shader is whole; put the file there and export again")
    })
}
