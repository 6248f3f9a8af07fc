//! The images that modules sample.

use std::sync::Arc;

use chiaro_locale::tr;

use crate::compile::{CompiledShader, ImageShape};
use crate::diag::Diagnostic;
use crate::frame::assets::{Assets, Image, MESH_PREFIX, plain_hcbtf};
use crate::frame::setup::SetupLook;
use crate::geometry::{MaterialMap, Mesh, MeshPart};
use crate::hcbtf::LayerOptions;

/// True if a module samples a map of the mesh's own materials.
pub(super) fn reads_maps(shader: &CompiledShader) -> bool {
    shader.needs.images.iter().any(|image| image.path.starts_with(MESH_PREFIX))
}

/// The map of the mesh's material that an image's path names; `None` for any other path.
///
/// # Errors
/// A name that no map has.
pub fn named_map(path: &str) -> Result<Option<MaterialMap>, Diagnostic> {
    let Some(name) = path.strip_prefix(MESH_PREFIX) else { return Ok(None) };
    MaterialMap::named(name).map(Some).ok_or_else(|| {
        let names = MaterialMap::NAMES.map(|(_, name)| format!("{MESH_PREFIX}{name}"));
        let problem = Diagnostic::error("missing-asset", tr!("`{path}` is no map of a mesh"));
        problem
            .suggest(path, names.iter().map(String::as_str))
            .hint(tr!("the maps are `{names}`", names = names.join("`, `")))
    })
}

/// Puts the maps of a part's material in place of those of a mesh that has none, among the images
/// that [`images`] read for a module.
///
/// # Errors
/// Pictures of the material that cannot be read.
pub(super) fn put_maps(
    images: &mut [Arc<Image>],
    assets: &mut Assets,
    shader: &CompiledShader,
    setup: &SetupLook,
    (mesh, part): (&Mesh, &MeshPart),
) -> Result<(), Vec<Diagnostic>> {
    let mut problems = Vec::new();
    for (image, used) in images.iter_mut().zip(&shader.needs.images) {
        let Ok(Some(map)) = named_map(&used.path) else { continue };
        match assets.material_map(mesh, part, map) {
            Ok(found) => *image = found,
            Err(problem) => problems.push(problem.node(used.node.clone())),
        }
    }
    setup.source.locate_all(&mut problems);
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}

/// The images that a module reads, in the order of its needs; maps of a mesh's materials are those
/// of a mesh that has none.
pub(in crate::frame) fn images(
    assets: &mut Assets,
    shader: &CompiledShader,
    setup: &SetupLook,
) -> Result<Vec<Arc<Image>>, Vec<Diagnostic>> {
    let mut problems = Vec::new();
    let images = shader
        .needs
        .images
        .iter()
        .map(|image| {
            let plain = |color| match image.shape {
                ImageShape::Flat => Arc::new(Image::single(color)),
                ImageShape::Hcbtf { .. } => Arc::new(plain_hcbtf(color)),
            };
            if image.path.is_empty() {
                // No image is chosen yet: white leaves what the image tints unchanged.
                return plain([255; 4]);
            }
            let read = match image.shape {
                ImageShape::Flat => match named_map(&image.path) {
                    Ok(None) => assets.image(&setup.folder, &image.path),
                    Ok(Some(map)) => Ok(Arc::new(Image::single(map.absent()))),
                    Err(problem) => Err(problem),
                }
                .map_err(|problem| vec![problem]),
                ImageShape::Hcbtf { has_levels, storage } => {
                    let options =
                        LayerOptions { has_levels, is_decoded: image.is_decoded, storage };
                    assets.hcbtf(&setup.folder, &image.path, options).map(|image| image.value)
                }
            };
            read.unwrap_or_else(|found| {
                problems.extend(found.into_iter().map(|problem| problem.node(image.node.clone())));
                plain([255, 0, 255, 255])
            })
        })
        .collect();
    setup.source.locate_all(&mut problems);
    if problems.is_empty() { Ok(images) } else { Err(problems) }
}
