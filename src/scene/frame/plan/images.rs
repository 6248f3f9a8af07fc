//! The images that modules sample.

use std::sync::Arc;

use crate::compile::{CompiledShader, ImageShape};
use crate::diag::Diagnostic;
use crate::frame::assets::{Assets, Image, plain_hcbtf};
use crate::frame::setup::SetupLook;
use crate::hcbtf::LayerOptions;

/// The images that a module reads, in the order of its needs.
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
                ImageShape::Flat => {
                    assets.image(&setup.folder, &image.path).map_err(|problem| vec![problem])
                }
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
